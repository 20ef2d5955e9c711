//! The first wall that a straight line meets: what a player sees, where a shot ends, whether two agents see each other.
//!
//! ```text
//!        +         +         +       The corners of a face are on the left (+), on the right (-) or on the line (0).
//!         ╲___f1___╱___f2___╱        It leaves a convex face through the side that runs from - to +, or through its
//!   p ─────────────────────●  q      foremost corner on the line. There it goes on in the same wedge, or ends.
//!          ╱       ╲      0
//!         -         -                Only the point that is hit is computed; all else is signs of given points.
//! ```

use super::marks::{CLOSED, ID};
use super::nearest::distance;
use super::{Location, NavMesh, QueryPoint, QueryPointError};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{CoordinateError, Crossed, Point};
use std::cmp::Ordering;

/// Why no ray can be cast.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RaycastError {
    /// The start is no place to stand.
    #[error("the start of the ray: {0}")]
    Start(QueryPointError),
    /// The point it is aimed at has no coordinates that signs are exact for.
    #[error("the end of the ray: {0}")]
    End(CoordinateError),
}

/// What a ray met.
#[derive(Clone, PartialEq, Debug)]
pub struct Raycast {
    /// The faces it ran through, in order. Along an edge, those on one side of it.
    pub faces: Vec<FaceId>,
    /// Where it ended; `None` if nothing was in its way.
    pub hit: Option<RayHit>,
}

/// Where a ray ends at a wall.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RayHit {
    /// The closed side it ran against; the face it came from is on its left.
    pub half_edge: HalfEdgeId,
    /// The face it came from.
    pub face: FaceId,
    /// The vertex, if it ran against one: an end of the side.
    pub vertex: Option<VertexId>,
    /// The point, rounded to the nearest doubles. Exact if it is a vertex or the start.
    pub point: Point,
    /// How far it is from the start to the point.
    pub distance: f64,
}

/// Notes that a ray has entered a face, unless it is in it already.
pub(super) fn enter(faces: &mut Vec<FaceId>, face: FaceId) {
    if faces.last() != Some(&face) {
        faces.push(face);
    }
}

/// The line of a ray.
pub(super) struct Line {
    pub(super) from: Point,
    pub(super) to: Point,
}

impl Line {
    /// `Greater` on the left.
    pub(super) fn side(&self, p: Point) -> Ordering {
        orientation(self.from, self.to, p)
    }

    /// Whether the line leads from `a` towards `b`, both of which are on it.
    pub(super) fn is_forward(&self, a: Point, b: Point) -> bool {
        a != b && left_to_right(a, b) == left_to_right(self.from, self.to)
    }
}

/// Where the line leaves a face.
enum Exit {
    Side(usize),
    Corner(VertexId),
}

/// Where the line goes on.
enum Onwards {
    /// Through this face.
    Into(FaceId),
    /// Along a side of this face, up to the vertex.
    Along(FaceId, VertexId),
    /// Nowhere: this side of the face is closed; it is met at the vertex, or inside.
    Wall(FaceId, usize, Option<VertexId>),
}

impl NavMesh {
    /// The first wall on the straight line from `p` to `q`; a hole, the outside and blocked faces are behind walls,
    /// too. Running along a wall, or past a corner that it touches, is allowed, as it is for a path; squeezing through
    /// a double corner is not.
    ///
    /// Whether and which side is hit is decided exactly. If nothing is hit, `q` is reached, and the straight line is the
    /// shortest path.
    ///
    /// Cost: that of [`place`](Self::place), and O(sides of the faces on the way).
    ///
    /// # Errors
    /// [`RaycastError`]: one cannot stand at `p`, or has to say in which face ([`raycast_from`](Self::raycast_from));
    /// or `q` is out of range.
    ///
    /// ```
    /// use dcel_kit::navmesh::NavMesh;
    /// use dcel_kit::{HalfEdgeId, plane::{Point, Subdivision}};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let mesh = NavMesh::new(&Subdivision::polygon(&hall)?)?;
    /// let [inside, outside] = [Point::new(5.0, 3.0), Point::new(11.0, 3.0)];
    /// assert_eq!(mesh.raycast(Point::new(1.0, 1.0), inside)?.hit, None);
    /// let hit = mesh.raycast(inside, outside)?.hit.expect("the wall on the right");
    /// assert_eq!((hit.half_edge, hit.point, hit.distance), (HalfEdgeId::new(2), Point::new(8.0, 3.0), 3.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn raycast(&self, p: Point, q: Point) -> Result<Raycast, RaycastError> {
        self.raycast_from(&self.place(p).map_err(RaycastError::Start)?, q)
    }

    /// [`raycast`](Self::raycast) from a place: at a double corner or on a wall its face says on which side.
    ///
    /// # Errors
    /// [`RaycastError::End`].
    pub fn raycast_from(&self, place: &QueryPoint, q: Point) -> Result<Raycast, RaycastError> {
        q.check().map_err(RaycastError::End)?;
        let mut cast = Raycast { faces: Vec::new(), hit: None };
        if place.point == q {
            cast.faces.push(place.face);
            return Ok(cast);
        }
        let line = Line { from: place.point, to: q };
        let mut onwards = self.first_face(place, &line);
        loop {
            let (face, vertex) = match onwards {
                Onwards::Into(face) => (face, None),
                Onwards::Along(face, vertex) => (face, Some(vertex)),
                Onwards::Wall(face, side, vertex) => {
                    let at_start = cast.faces.is_empty() && vertex.is_none();
                    let point = match vertex {
                        Some(v) => self.point(v),
                        None if at_start => place.point,
                        None => self.crossing(face, side, &line),
                    };
                    let (half_edge, distance) = (self.half_edges[side], distance(place.point, point));
                    cast.hit = Some(RayHit { half_edge, face, vertex, point, distance });
                    enter(&mut cast.faces, face);
                    return Ok(cast);
                }
            };
            enter(&mut cast.faces, face);
            if self.spot_in(face, q).is_some() {
                return Ok(cast);
            }
            onwards = match vertex.map_or_else(|| self.exit(face, &line), Exit::Corner) {
                Exit::Side(side) if self.sides[side].across & CLOSED == 0 => {
                    Onwards::Into(FaceId::new(self.sides[side].across & ID))
                }
                // What ends on the wall itself has been found in the face.
                Exit::Side(side) => Onwards::Wall(face, side, None),
                Exit::Corner(v) => {
                    let wedge = self.wedges(v).into_iter().find(|wedge| wedge.contains(&face));
                    self.onwards(v, &wedge.unwrap_or_else(|| vec![face]), &line, face)
                }
            };
        }
    }

    /// Where the line crosses a side, rounded.
    fn crossing(&self, face: FaceId, side: usize, line: &Line) -> Point {
        let ends = self.ends(face, side).map(|v| self.point(v));
        Crossed::new([line.from, line.to], ends).rounded().0
    }

    /// The face into which the line starts, or what it runs against at once.
    fn first_face(&self, place: &QueryPoint, line: &Line) -> Onwards {
        let h = match place.location {
            Location::Vertex(v) => return self.onwards(v, &self.faces_at(place), line, place.face),
            Location::Edge(h) => h,
            _ => return Onwards::Into(place.face),
        };
        let Some(side) = self.range(place.face).find(|&s| self.half_edges[s].edge() == h.edge()) else {
            return Onwards::Into(place.face);
        };
        let ends = self.ends(place.face, side);
        let [a, b] = ends.map(|v| self.point(v));
        match orientation(a, b, line.to) {
            Ordering::Greater => Onwards::Into(place.face),
            Ordering::Equal => Onwards::Along(place.face, ends[usize::from(line.is_forward(a, b))]),
            Ordering::Less if self.sides[side].across & CLOSED == 0 => {
                Onwards::Into(FaceId::new(self.sides[side].across & ID))
            }
            Ordering::Less => Onwards::Wall(place.face, side, None),
        }
    }

    /// Where the line, which runs through the face, leaves it.
    fn exit(&self, face: FaceId, line: &Line) -> Exit {
        let range = self.range(face);
        let mut foremost: Option<VertexId> = None;
        let mut before = line.side(self.point(self.ends(face, range.end - 1)[0]));
        for s in range.clone() {
            let v = VertexId::new(self.sides[s].origin & ID);
            let here = line.side(self.point(v));
            if before.is_lt() && here.is_gt() {
                return Exit::Side(if s == range.start { range.end - 1 } else { s - 1 });
            }
            if here.is_eq() && foremost.is_none_or(|w| line.is_forward(self.point(w), self.point(v))) {
                foremost = Some(v);
            }
            before = here;
        }
        // A line through a convex face leaves it through a side or a corner.
        foremost.map_or(Exit::Side(range.start), Exit::Corner)
    }

    /// Where the line goes on from the vertex `v`, on which it is, and to which it came in the face `from`: into one of the
    /// faces of the wedge, or along a side of one up to the vertex that is told; or which closed side of the wedge keeps it
    /// back.
    fn onwards(&self, v: VertexId, wedge: &[FaceId], line: &Line, from: FaceId) -> Onwards {
        let at = self.point(v);
        let mut along = None;
        let mut wall = None;
        for &face in wedge {
            let (Some(out), Some(back)) = (self.side_from(face, v.number()), self.side_to(face, v.number())) else {
                continue;
            };
            let (next, prev) = (self.ends(face, out)[1], self.ends(face, back)[0]);
            let [of_next, of_prev] = [next, prev].map(|v| line.side(self.point(v)));
            if of_next.is_lt() && of_prev.is_gt() {
                return Onwards::Into(face);
            }
            for (end, side) in [(next, of_next), (prev, of_prev)] {
                if side.is_eq() && line.is_forward(at, self.point(end)) {
                    along = Some(Onwards::Along(face, end));
                }
            }
            for (side, leaves) in [(out, of_next.is_gt()), (back, of_prev.is_lt())] {
                let is_own = matches!(wall, Some(Onwards::Wall(other, ..)) if other == from);
                if self.sides[side].across & CLOSED != 0 && leaves && (face == from || !is_own) {
                    wall = Some(Onwards::Wall(face, side, Some(v)));
                }
            }
        }
        // A wedge that does not have the direction ends at closed sides, and the direction is beyond one of them, or both.
        let first = wedge.first().copied().unwrap_or(FaceId::new(0));
        along.or(wall).unwrap_or_else(|| Onwards::Wall(first, self.range(first).start, Some(v)))
    }
}
