//! Half-edges linked one-ring by one-ring.
//!
//! ```text
//!        h4 ╲   ╱ h2        each corner is a link: next(twin(h2)) = h0, next(twin(h4)) = h2, next(twin(h0)) = h4
//!            ╲ ╱
//!             ●── h0
//! ```

use super::graph::Graph;
use crate::geometry::predicates::is_before_round;
use crate::ids::MAX_IDS;
use crate::plane::sweep::OneRing;
use crate::topology::{Columns, TooMany};

/// The half-edges of a graph; the links come one-ring by one-ring.
pub(super) struct OneRings {
    next: Vec<u32>,
    prev: Vec<u32>,
    outgoing: Vec<u32>,
}

impl OneRings {
    /// No link yet.
    ///
    /// # Errors
    /// [`TooMany`] if the vertices or half-edges have no ids.
    pub(super) fn new(graph: &Graph) -> Result<Self, TooMany> {
        let Graph { points, edges, .. } = graph;
        if points.len() > MAX_IDS || 2 * edges.len() > MAX_IDS {
            return Err(TooMany);
        }
        let none = |count: usize| vec![Columns::NONE; count];
        Ok(Self { next: none(2 * edges.len()), prev: none(2 * edges.len()), outgoing: none(points.len()) })
    }

    /// Links a one-ring. Counter-clockwise from straight down it begins with the half-edges to the right, upwards; then
    /// come those to the left, downwards.
    #[inline]
    pub(super) fn link(&mut self, one_ring: &OneRing<'_>) {
        self.link_all(one_ring.point, one_ring.right.iter().chain(one_ring.left.iter().rev()).copied());
    }

    /// Links the half-edges that leave a point, counter-clockwise from straight down.
    #[inline]
    pub(super) fn link_all(&mut self, point: u32, half_edges: impl Iterator<Item = u32>) {
        let mut last = None;
        for h in half_edges {
            match last.replace(h) {
                None => self.outgoing[point as usize] = h,
                Some(before) => self.meet(before, h),
            }
        }
        if let Some(last) = last {
            self.meet(last, self.outgoing[point as usize]);
        }
    }

    /// The half-edges with their links, but for their faces. `edges` are those of the graph.
    pub(super) fn into_columns(self, edges: Vec<[u32; 2]>) -> Columns {
        let Self { next, prev, outgoing } = self;
        let origin = edges.into_flattened();
        Columns { face: vec![Columns::NONE; origin.len()], origin, next, prev, outgoing, boundary: vec![Columns::NONE] }
    }

    /// The half-edge with which a one-ring begins.
    #[inline]
    pub(super) fn begin(&mut self, point: u32, h: u32) {
        self.outgoing[point as usize] = h;
    }

    /// Turns one-rings, which are counter-clockwise, so that they begin with the first half-edge counter-clockwise from
    /// straight down. That is most often so already.
    pub(super) fn begin_straight_down(&mut self, graph: &Graph) {
        let Graph { points, edges, .. } = graph;
        let to = |h: u32| points[edges.as_flattened()[(h ^ 1) as usize] as usize];
        let Self { next, prev, outgoing } = self;
        for (&at, first) in points.iter().zip(outgoing).filter(|(_, first)| **first != Columns::NONE) {
            let given = *first;
            let last = next[(given ^ 1) as usize];
            if last == given || is_before_round(at, to(given), to(last)) {
                continue;
            }
            let mut h = prev[given as usize] ^ 1;
            while h != given && !is_before_round(at, to(h), to(next[(h ^ 1) as usize])) {
                h = prev[h as usize] ^ 1;
            }
            *first = h;
        }
    }

    /// Of two half-edges of a one-ring the second follows the first, counter-clockwise.
    #[inline]
    pub(super) fn meet(&mut self, g: u32, h: u32) {
        self.next[(h ^ 1) as usize] = g;
        self.prev[g as usize] = h ^ 1;
    }
}
