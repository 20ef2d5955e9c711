//! Where a point lies, by name; and from where a path may start.
//!
//! ```text
//!   ┌───────●────┐     ●  Vertex(v)           Nothing is snapped: a point a hair beside the map is outside, and
//!   │  ·   ╱     │     │  Edge(h)             nearest_point is another question.
//!   │     ╱ ┌────┘     ·  Face(f), Hole(f), Outer
//!   └────┴──┘
//! ```

use super::NavMesh;
use super::grid::Look;
use super::marks::{ID, NONE};
use super::slivers::{Seen, Slivers};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;
use std::fmt;

/// Where a point lies: exactly, on the smallest element that has it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Location {
    /// On a vertex of the mesh.
    Vertex(VertexId),
    /// Inside an edge of the mesh: by its even half, or by the odd one if the face of the even one is a hole.
    Edge(HalfEdgeId),
    /// Inside a face of the mesh, blocked or not.
    Face(FaceId),
    /// Inside a hole, or on something in it. Hole faces side by side are one hole, named by the one with the lowest
    /// number; which of them has the point says [`Subdivision::locate`](crate::plane::Subdivision::locate). What an
    /// obstacle cuts off a hole, or off the outer face, still is the hole, or the outer face.
    Hole(FaceId),
    /// In the outer face.
    Outer,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => write!(f, "on vertex {v}"),
            Self::Edge(h) => write!(f, "on edge {} ({h})", h.edge()),
            Self::Face(x) => write!(f, "in face {x}"),
            Self::Hole(x) => write!(f, "in the hole {x}"),
            Self::Outer => f.write_str("outside"),
        }
    }
}

/// A point from or to which a path may lead, and the face in which one stands there. On an edge or vertex the face
/// says on which side of a wall, or in which wedge of a double corner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct QueryPoint {
    /// The point.
    pub point: Point,
    /// Where it lies.
    pub location: Location,
    /// A face of the mesh that has it, not blocked.
    pub face: FaceId,
}

/// Why one cannot stand at a point.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum QueryPointError {
    /// The point is in no face of the mesh.
    #[error("{point} is {location}, not on the mesh; nearest_point gives the nearest place that is")]
    OffMesh {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
    },
    /// Every face that has the point is blocked.
    #[error("{point} is {location}, and blocked; nearest_point gives the nearest place that is free")]
    Blocked {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
    },
    /// The point is at a double corner, or on a wall: one has to say on which side.
    #[error(
        "{point} is {location}, where {} sides meet that nobody can pass between: choose one of the faces {} with place_in, or all of them with places",
        faces.len(),
        faces.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    )]
    Ambiguous {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
        /// One face on each side.
        faces: Vec<FaceId>,
    },
    /// The face does not have the point, or is blocked, or is no face of the mesh.
    #[error("{point} is {location}, and {face} is no free face there")]
    NotInFace {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
        /// The face.
        face: FaceId,
    },
}

impl NavMesh {
    /// Where `p` lies, exactly. A point with a coordinate that is no number is outside.
    ///
    /// Cost: O(1) for faces of about one size: those of one cell of the index are tested. O(log n) where faces are so long
    /// and thin that cells would see too many of them.
    ///
    /// ```
    /// use dcel_kit::navmesh::{Location, NavMesh};
    /// use dcel_kit::{FaceId, VertexId, plane::{Point, Subdivision}};
    /// let corners = [(0., 0.), (4., 0.), (0., 3.)].map(Point::from);
    /// let mesh = NavMesh::new(&Subdivision::polygon(&corners)?)?;
    /// assert_eq!(mesh.locate(Point::new(1., 1.)), Location::Face(FaceId::new(1)));
    /// assert_eq!(mesh.locate(Point::new(4., 0.)), Location::Vertex(VertexId::new(1)));
    /// assert_eq!(mesh.locate(Point::new(4., 1e-300)), Location::Outer);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn locate(&self, p: Point) -> Location {
        self.locate_with_face(p).0
    }

    /// Where `p` lies, and a face of the mesh that has it.
    #[inline]
    fn locate_with_face(&self, p: Point) -> (Location, Option<FaceId>) {
        if !self.grid.contains(p) {
            return (Location::Outer, None);
        }
        if let Some(slivers) = self.grid.slivers() {
            return self.locate_among(slivers, p);
        }
        match self.grid.look(&self.faces, p) {
            Look::Face(f) => (Location::Face(FaceId::new(f)), Some(FaceId::new(f))),
            Look::Hole(hole) => (hole_location(FaceId::new(hole)), None),
            Look::SomeHole => (self.hole_at(p), None),
            Look::Unclear => {
                let faces = self.grid.faces(self.grid.cell(p)).map(FaceId::new);
                let mut spots = faces.filter_map(|f| Some((self.spot_of_near(f, p)?, Some(f))));
                spots.next().unwrap_or_else(|| (self.hole_at(p), None))
            }
        }
    }

    /// [`locate_with_face`](Self::locate_with_face) on a map of slivers, for a point in the box. Faces that came later
    /// have what those that went had.
    fn locate_among(&self, slivers: &Slivers, p: Point) -> (Location, Option<FaceId>) {
        let seen = slivers.look(p);
        let near: [Option<FaceId>; 2] = match seen {
            Seen::Vertex(v) => [self.fans.get(v.index()).filter(|&&f| f != NONE).map(|&f| FaceId::new(f)), None],
            Seen::Edge([left, right]) => [Some(left), Some(right)],
            Seen::Face(f) => [Some(f), None],
        };
        let late = self.grid.late_faces(p).iter().map(|&f| FaceId::new(f));
        let mut faces = near.into_iter().flatten().chain(late).filter(|&f| self.has_face(f));
        let found = faces.find_map(|f| Some((self.spot_of_near(f, p)?, Some(f))));
        found.unwrap_or_else(|| match seen {
            Seen::Face(hole) if self.grid.is_fresh() => (hole_location(hole), None),
            _ => (self.hole_at(p), None),
        })
    }

    /// The hole that has `p`, which is in no face.
    fn hole_at(&self, p: Point) -> Location {
        hole_location(self.grid.hole(self, p))
    }

    /// [`locate`](Self::locate) without the index: every face is tested. For tests and for lessons. O(n).
    #[must_use]
    pub fn locate_by_scan(&self, p: Point) -> Location {
        let found = self.faces().find_map(|f| self.spot_in(f, p));
        found.unwrap_or_else(|| self.hole_at(p))
    }

    /// Where in the closed face `f` the point lies, if it does. O(sides of f); exact.
    pub(super) fn spot_in(&self, f: FaceId, p: Point) -> Option<Location> {
        if self.grid.contains(p) { self.spot_of_near(f, p) } else { None }
    }

    /// [`spot_in`](Self::spot_in) for a point that is no further away than the map is wide: there the signs are exact.
    #[inline]
    pub(super) fn spot_of_near(&self, f: FaceId, p: Point) -> Option<Location> {
        let range = self.range(f);
        let mut a = self.points[(self.sides[range.end.checked_sub(1)?].origin & ID) as usize];
        let mut on_line = false;
        for side in &self.sides[range] {
            let b = self.points[(side.origin & ID) as usize];
            match orientation(a, b, p) {
                Ordering::Less => return None,
                Ordering::Equal => on_line = true,
                Ordering::Greater => {}
            }
            a = b;
        }
        if on_line { self.spot_on_border(f, p) } else { Some(Location::Face(f)) }
    }

    /// The corner or side of `f` that has `p`, which is on the line of a side and not outside `f`.
    fn spot_on_border(&self, f: FaceId, p: Point) -> Option<Location> {
        if let Some(v) = self.corners(f).find(|&v| self.point(v) == p) {
            return Some(Location::Vertex(v));
        }
        let s = self.range(f).find(|&s| {
            let [a, b] = self.ends(f, s).map(|v| self.point(v));
            orientation(a, b, p).is_eq() && is_between(a, b, p)
        })?;
        let half_edge = self.half_edges[s];
        let both = self.has_face(FaceId::new(self.sides[s].across & ID));
        Some(Location::Edge(if both { half_edge.edge().half_edges()[0] } else { half_edge }))
    }

    /// The place at `p`.
    ///
    /// Cost: that of [`locate`](Self::locate), and O(faces there).
    ///
    /// # Errors
    /// [`QueryPointError`]: `p` is off the mesh or blocked, or there are several sides of a double corner or a wall to
    /// choose from with [`place_in`](Self::place_in).
    pub fn place(&self, point: Point) -> Result<QueryPoint, QueryPointError> {
        let (location, face) = self.locate_with_face(point);
        if let Location::Face(face) = location {
            let place = QueryPoint { point, location, face };
            return if self.is_walkable(face) { Ok(place) } else { Err(QueryPointError::Blocked { point, location }) };
        }
        let mut faces = face.map_or_else(Vec::new, |face| self.parts_of(location, face)).into_iter();
        match (faces.next(), faces.len()) {
            (Some(part), 0) => Ok(QueryPoint { point, location, face: part[0] }),
            (Some(part), _) => {
                let faces = std::iter::once(part).chain(faces).map(|part| part[0]).collect();
                Err(QueryPointError::Ambiguous { point, location, faces })
            }
            (None, _) if matches!(location, Location::Hole(_) | Location::Outer) => {
                Err(QueryPointError::OffMesh { point, location })
            }
            (None, _) => Err(QueryPointError::Blocked { point, location }),
        }
    }

    /// All places at `point`: one, or at a double corner and on a wall one on each side, in the order of
    /// [`QueryPointError::Ambiguous`].
    ///
    /// Cost: that of [`place`](Self::place).
    ///
    /// # Errors
    /// [`QueryPointError`]: `point` is off the mesh or blocked.
    pub fn places(&self, point: Point) -> Result<Vec<QueryPoint>, QueryPointError> {
        match self.place(point) {
            Ok(place) => Ok(vec![place]),
            Err(QueryPointError::Ambiguous { point, location, faces }) => {
                Ok(faces.into_iter().map(|face| QueryPoint { point, location, face }).collect())
            }
            Err(error) => Err(error),
        }
    }

    /// The place at `point` in the face `face`: in the wedge of a double corner, or on the side of a wall, to which
    /// that face belongs.
    ///
    /// # Errors
    /// [`QueryPointError::NotInFace`] if the closed face does not have the point, or nobody may enter it.
    pub fn place_in(&self, face: FaceId, point: Point) -> Result<QueryPoint, QueryPointError> {
        let spot = if self.is_walkable(face) { self.spot_in(face, point) } else { None };
        let location = spot.ok_or_else(|| QueryPointError::NotInFace { point, location: self.locate(point), face })?;
        Ok(QueryPoint { point, location, face })
    }

    /// The faces one stands in at the place, all of them: those round an edge or vertex between which one may pass.
    #[must_use]
    pub fn faces_at(&self, place: &QueryPoint) -> Vec<FaceId> {
        let mut faces = Vec::new();
        self.add_faces_at(place, &mut faces);
        faces
    }

    /// Appends the [`faces_at`](Self::faces_at) the place.
    pub(super) fn add_faces_at(&self, place: &QueryPoint, faces: &mut Vec<FaceId>) {
        let parts = match place.location {
            Location::Face(_) => Vec::new(),
            location => self.parts_of(location, place.face),
        };
        match parts.into_iter().find(|part| part.contains(&place.face)) {
            Some(part) => faces.extend(part),
            None => faces.push(place.face),
        }
    }

    /// The faces at a location that are not blocked, in parts between which nobody can pass there.
    fn parts_of(&self, location: Location, face: FaceId) -> Vec<Vec<FaceId>> {
        match location {
            Location::Edge(h) => {
                let Some(side) = self.sides(face).find(|side| side.half_edge.edge() == h.edge()) else {
                    return Vec::new();
                };
                let here = [face, side.across].into_iter().filter(|&f| self.is_walkable(f));
                if side.open { vec![here.collect()] } else { here.map(|f| vec![f]).collect() }
            }
            Location::Vertex(v) => self.wedges(v),
            Location::Face(_) | Location::Hole(_) | Location::Outer => Vec::new(),
        }
    }
}

fn hole_location(hole: FaceId) -> Location {
    if hole.number() == 0 { Location::Outer } else { Location::Hole(hole) }
}

/// Whether `p`, which is on the line of a and b, lies strictly between them.
#[inline]
pub(super) fn is_between(a: Point, b: Point, p: Point) -> bool {
    let inside = |a: f64, b: f64, p: f64| (a < p && p < b) || (b < p && p < a);
    if (b.x - a.x).abs() > 0.0 { inside(a.x, b.x, p.x) } else { inside(a.y, b.y, p.y) }
}
