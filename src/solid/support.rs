//! The vertex of a convex solid that lies furthest in a direction, by climbing from vertex to vertex.
//!
//! ```text
//!          direction ^            from a vertex to its best neighbour, until none is better. On a convex solid
//!              ●─────●            the first vertex that no neighbour exceeds is the best of all, because ties
//!            ╱         ╲          are decided by position and there is no plateau to stop on.
//!    start  ●           ●
//!           │   solid   │         The answer to a nearby direction is near: start from there.
//! ```
//!
//! Source: hill climbing as in the game physics series on support functions of polyhedra; the order of ties is the
//! simulation of simplicity (Edelsbrunner and Mücke, 1990) for one linear function.

use super::convex::Convex;
use super::predicates::further;
use crate::geometry::space::check_place;
use crate::ids::VertexId;
use crate::plane::CoordinateError;
use crate::topology::{NoObserver, Observer};
use std::cmp::Ordering;

/// What a climb does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ClimbEvent {
    /// It has come to a vertex.
    At(VertexId),
    /// It looks at a neighbour of that vertex: at the other end of an edge, or at a corner of a face round it that is not
    /// exactly flat. A corner may be looked at more than once.
    Looked(VertexId),
}

/// Keeps the vertices of a climb.
struct Way<'a>(&'a mut Vec<VertexId>);

impl Observer<ClimbEvent> for Way<'_> {
    fn observe(&mut self, event: impl FnOnce() -> ClimbEvent) {
        if let ClimbEvent::At(v) = event() {
            self.0.push(v);
        }
    }
}

/// A direction in space, of any length. 0 in all three is allowed: then all vertices are equally far, and position
/// decides.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Direction([f64; 3]);

impl TryFrom<[f64; 3]> for Direction {
    type Error = CoordinateError;

    /// # Errors
    /// A coordinate that is not finite, or out of the range in which signs are exact.
    fn try_from(direction: [f64; 3]) -> Result<Self, CoordinateError> {
        check_place(direction)?;
        Ok(Self(direction))
    }
}

impl From<Direction> for [f64; 3] {
    fn from(direction: Direction) -> Self {
        direction.0
    }
}

impl Direction {
    /// Its coordinates.
    pub(super) fn vector(self) -> [f64; 3] {
        self.0
    }

    /// A direction whose coordinates are known to be in range.
    pub(super) fn of_checked(direction: [f64; 3]) -> Self {
        Self(direction)
    }
}

impl Convex<'_> {
    /// The vertex furthest in `direction`; of equally far ones that with the greatest x, then y, then z. Exact.
    ///
    /// Cost: about the square root of V steps on round solids; a cone with one vertex of degree V costs V. For many
    /// questions about one solid see [`support_map`](Self::support_map).
    #[must_use]
    pub fn support(&self, direction: Direction) -> VertexId {
        self.support_from(direction, self.first)
    }

    /// The same, climbing from `hint`: the last answer, if directions change little by little. Whatever the hint,
    /// the answer is the same; a hint that is no vertex of the solid is not used.
    #[must_use]
    pub fn support_from(&self, direction: Direction, hint: VertexId) -> VertexId {
        self.climb_observed(direction, hint, &mut NoObserver)
    }

    /// The vertices met by [`support_from`](Self::support_from), the first and the last included.
    #[must_use]
    pub fn climb(&self, direction: Direction, start: VertexId) -> Vec<VertexId> {
        let mut way = Vec::new();
        self.climb_observed(direction, start, &mut Way(&mut way));
        way
    }

    /// [`support_from`](Self::support_from), watched: the vertices that are looked at, and the steps. Returns the furthest
    /// vertex.
    pub fn climb_observed(
        &self,
        direction: Direction,
        start: VertexId,
        observer: &mut impl Observer<ClimbEvent>,
    ) -> VertexId {
        let mut at = if self.solid.has_vertex(start) { start } else { self.first };
        observer.observe(|| ClimbEvent::At(at));
        while let Some(better) = self.best_neighbour(direction, at, observer) {
            at = better;
            observer.observe(|| ClimbEvent::At(at));
        }
        at
    }

    /// The same vertex as [`support`](Self::support), by looking at all of them. O(V).
    #[must_use]
    pub fn support_by_search(&self, direction: Direction) -> VertexId {
        let ahead = |a: VertexId, b: VertexId| self.compare(direction, a, b) == Ordering::Greater;
        self.solid.vertices().fold(self.first, |best, v| if ahead(v, best) { v } else { best })
    }

    #[inline]
    fn compare(&self, direction: Direction, a: VertexId, b: VertexId) -> Ordering {
        further(direction.0, self.solid.point(a), self.solid.point(b))
    }

    /// The best of the neighbours of `at` that are better than `at`. In a face that is not exactly flat all
    /// corners are neighbours: the edges of the exact hull are among these.
    #[inline]
    fn best_neighbour(
        &self,
        direction: Direction,
        at: VertexId,
        observer: &mut impl Observer<ClimbEvent>,
    ) -> Option<VertexId> {
        let dcel = self.solid.topology();
        let mut best = at;
        let mut look = |v: VertexId| {
            observer.observe(|| ClimbEvent::Looked(v));
            if self.compare(direction, v, best) == Ordering::Greater {
                best = v;
            }
        };
        for h in dcel.outgoing_half_edges(at) {
            look(dcel.destination(h));
            if self.bent[dcel.face(h)] {
                dcel.cycle(h).for_each(|g| look(dcel.origin(g)));
            }
        }
        (best != at).then_some(best)
    }
}
