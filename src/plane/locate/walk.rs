//! From a vertex towards a point, face by face.
//!
//! ```text
//!     s ●· · · · ┐ f  ┌ ─ ─┐         In each face the LAST of its edges across the way counts, whatever lies
//!        ╲   ·   │  · │    │ f  · p   between: over it the way leaves the face for good. Inner components count as the
//!         ╲      └────┘    ╱         boundary does, so that the walk gets out of inner components and round them.
//! ```
//!
//! Properties:
//! - no face is looked at twice, for behind the last edge of a face the way does not come back to it; so the walk
//!   ends, whatever the shape of the faces, and looks at each half-edge once at most;
//! - it is decided by orientation alone: the way runs to the right of vertices that lie on it, and of two edges
//!   across the way the later one is found by the sides on which their ends lie;
//! - in a triangulation it is the straight walk from triangle to triangle.
//!
//! Source: the straight walk is that of Devillers, Pion, Teillaud, *Walking in a triangulation*, 2002; here for faces
//! of any shape, with inner components.

use super::order::Ends;
use super::{Location, is_beyond};
use crate::geometry::predicates::orientation;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::on_segment;
use crate::plane::edit::Towards;
use crate::plane::{Point, Subdivision};
use crate::topology::{IdError, NoObserver, Observer};
use std::cmp::Ordering;

/// A walk to a point: where the point lies, and what the walk has seen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Walk {
    /// Where the point lies.
    pub location: Location,
    /// The faces on the way, each once; the last one is that of the point, or one at its edge or vertex. None if the
    /// way led along edges only.
    pub faces: Vec<FaceId>,
    /// How many half-edges were looked at.
    pub half_edges: usize,
}

/// What a walk to a point does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WalkEvent {
    /// It goes along a half-edge that lies on the way.
    Along(HalfEdgeId),
    /// It looks at a face.
    Face {
        /// The face.
        face: FaceId,
        /// How many half-edges its boundaries have.
        half_edges: usize,
        /// The half-edge over which the way leaves the face; none if the point lies there.
        over: Option<HalfEdgeId>,
    },
}

/// What a look at one face says.
enum Seen {
    /// The point lies here.
    Here(Location),
    /// The way leaves the face over this half-edge of it.
    Over(HalfEdgeId),
}

impl Subdivision {
    /// Where the point lies, by a walk from the vertex `start`: quick if that is near.
    ///
    /// Cost: exact; O(size of the faces on the way), never more than O(n); from an isolated vertex also O(number of
    /// inner components).
    ///
    /// # Errors
    /// If `start` does not exist.
    pub fn locate_from(&self, start: VertexId, p: Point) -> Result<Location, IdError> {
        self.dcel.check(start)?;
        Ok(self.walk(start, p, &mut NoObserver))
    }

    /// [`locate_from`](Self::locate_from) with an account of the way.
    ///
    /// # Errors
    /// If `start` does not exist.
    ///
    /// ```
    /// use dcel_kit::{FaceId, VertexId, plane::{Location, Point, Subdivision}};
    /// let s = Subdivision::lab_rectangle();
    /// let walk = s.walk_from(VertexId::new(0), Point::new(400.0, 10.0))?;
    /// assert_eq!((walk.location, walk.faces.len()), (Location::Face(s.outer_face()), 2));
    /// # Ok::<(), dcel_kit::topology::IdError>(())
    /// ```
    pub fn walk_from(&self, start: VertexId, p: Point) -> Result<Walk, IdError> {
        let mut events = Vec::new();
        let location = self.walk_from_observed(start, p, &mut events)?;
        let (mut faces, mut half_edges) = (Vec::new(), 0);
        for event in events {
            if let WalkEvent::Face { face, half_edges: count, .. } = event {
                faces.push(face);
                half_edges += count;
            }
        }
        Ok(Walk { location, faces, half_edges })
    }

    /// [`locate_from`](Self::locate_from), watched: the half-edges along which the way leads, and the faces that it
    /// crosses.
    ///
    /// # Errors
    /// If `start` does not exist.
    pub fn walk_from_observed(
        &self,
        start: VertexId,
        p: Point,
        observer: &mut impl Observer<WalkEvent>,
    ) -> Result<Location, IdError> {
        self.dcel.check(start)?;
        Ok(self.walk(start, p, observer))
    }

    /// The walk from the nearest of some vertices that have edges.
    pub(super) fn jump_and_walk(&self, p: Point) -> Location {
        let bound = self.dcel.vertex_bound();
        let stride = bound / (bound as f64).cbrt().ceil().max(1.0) as usize;
        let distance = |v: VertexId| (self.points[v].x - p.x).powi(2) + (self.points[v].y - p.y).powi(2);
        let sample = (0..bound as u32).step_by(stride.max(1)).map(VertexId::new);
        let with_edges = |&v: &VertexId| self.dcel.has_vertex(v) && self.dcel.outgoing(v).is_some();
        let nearest = sample.filter(with_edges).min_by(|&u, &v| distance(u).total_cmp(&distance(v)));
        // Where the sample has none, any half-edge will do; without edges everything is f0.
        match nearest.or_else(|| self.dcel.half_edges().next().map(|h| self.dcel.origin(h))) {
            Some(start) => self.walk(start, p, &mut NoObserver),
            None => self.in_face(self.outer_face(), [p; 2], &mut NoObserver),
        }
    }

    /// Walks from a vertex to a point.
    fn walk(&self, start: VertexId, p: Point, observer: &mut impl Observer<WalkEvent>) -> Location {
        if is_beyond(p) {
            return Location::Face(self.outer_face());
        }
        let mut from = start;
        loop {
            if self.points[from] == p {
                return Location::Vertex(from);
            }
            let face = match self.towards(from, p) {
                Towards::Along(h) => {
                    observer.observe(|| WalkEvent::Along(h));
                    from = self.dcel.destination(h);
                    let at = self.points[from];
                    if at != p && on_segment(self.points[self.dcel.origin(h)], at, p) {
                        return Location::Edge(self.upper_half(h.edge()));
                    }
                    continue;
                }
                Towards::Corner(h) => self.dcel.face(h),
                Towards::Open(f) => f,
            };
            return self.in_face(face, [self.points[from], p], observer);
        }
    }

    /// Walks on from face to face, on a way that starts in `f`.
    fn in_face(&self, mut f: FaceId, way: Ends, observer: &mut impl Observer<WalkEvent>) -> Location {
        for _ in 0..self.dcel.face_count() {
            let (seen, half_edges) = self.look(f, way);
            observer.observe(|| {
                let over = if let Seen::Over(h) = seen { Some(h) } else { None };
                WalkEvent::Face { face: f, half_edges, over }
            });
            match seen {
                Seen::Here(location) => return location,
                Seen::Over(h) => f = self.dcel.face(h.twin()),
            }
        }
        // No face is looked at twice: the point is too close to 0 for exact signs.
        self.locate_by_scan(way[1])
    }

    /// Looks at all of the face: does the point lie on its rim, inside, or behind one of its edges?
    fn look(&self, f: FaceId, [s, p]: Ends) -> (Seen, usize) {
        let mut size = 0;
        let mut last: Option<(HalfEdgeId, Ends)> = None;
        for start in self.cycles(f) {
            let mut a = self.points[self.dcel.origin(start)];
            // The way runs to the right of what lies on it.
            let mut right = orientation(s, p, a).is_lt();
            for h in self.dcel.cycle(start) {
                size += 1;
                let to = self.dcel.destination(h);
                let b = self.points[to];
                if b == p {
                    return (Seen::Here(Location::Vertex(to)), size);
                }
                let side = orientation(s, p, b);
                let was_right = std::mem::replace(&mut right, side.is_lt());
                let ends = std::mem::replace(&mut a, b);
                // Straight through the point: only an edge whose ends lie on both sides, or on the line.
                if was_right == right && side != Ordering::Equal {
                    continue;
                }
                let of_p = orientation(ends, b, p);
                if of_p.is_eq() {
                    if ends == p {
                        return (Seen::Here(Location::Vertex(self.dcel.origin(h))), size);
                    }
                    if on_segment(ends, b, p) {
                        return (Seen::Here(Location::Edge(self.upper_half(h.edge()))), size);
                    }
                    continue;
                }
                if was_right != right
                    && orientation(ends, b, s) == of_p.reverse()
                    && last.is_none_or(|(_, before)| is_later([ends, b], before, p))
                {
                    last = Some((h, [ends, b]));
                }
            }
        }
        if let Some(v) = self.isolated_vertices(f).find(|&v| self.points[v] == p) {
            return (Seen::Here(Location::Vertex(v)), size);
        }
        match last {
            Some((h, [a, b])) if orientation(a, b, p).is_lt() && self.dcel.face(h.twin()) != f => (Seen::Over(h), size),
            _ => (Seen::Here(Location::Face(f)), size),
        }
    }
}

/// Whether the first of two edges across the way comes later on it, nearer to its end `p`, which lies on neither of
/// their lines. They do not cross.
fn is_later(e: Ends, before: Ends, p: Point) -> bool {
    // The one that has both ends on the side of p from the line of the other, or on the line, is later.
    let side = |[a, b]: Ends, of: Ends| {
        let p_side = orientation(of[0], of[1], p);
        let turns = [a, b].map(|q| orientation(of[0], of[1], q)).map(|t| if p_side.is_gt() { t } else { t.reverse() });
        if turns[0] == turns[1].reverse() { Ordering::Equal } else { turns[0].then(turns[1]) }
    };
    side(e, before).then_with(|| side(before, e).reverse()).is_gt()
}
