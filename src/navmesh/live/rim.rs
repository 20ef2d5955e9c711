//! What an obstacle has inside, told by how often its sides run round it.
//!
//! ```text
//!    0  ●───<───●        Left of a side the number is greater by one than right of it. Rounding can lay two sides of an
//!       │  1    │        obstacle on one edge: run both ways, it has the same number on both sides. What is left of the
//!       ●───>───●══●     leftmost corner has number 0; from there it is counted round each corner, and along each side.
//! ```

use super::cut::splits;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::Subdivision;
use crate::plane::predicates::{left_to_right, orientation};
use crate::topology::Change;
use std::collections::{BTreeMap, BTreeSet};

/// The edges along the sides of an obstacle, and how many sides run along the first half of each, those along the other
/// half taken off.
#[derive(Default)]
pub(super) struct Rim {
    runs: BTreeMap<EdgeId, i32>,
}

impl Rim {
    /// A side runs along the half-edge.
    pub(super) fn put(&mut self, h: HalfEdgeId) {
        *self.runs.entry(h.edge()).or_default() += sign(h);
    }

    /// Of edges that were split both parts are run along.
    pub(super) fn follow(&mut self, changes: &[Change]) {
        for (h, new) in splits(changes) {
            if self.runs.contains_key(&h.edge()) {
                // The first half of the new edge goes on where the twin of h ends.
                self.runs.insert(new, self.along(h.twin()));
            }
        }
    }

    fn along(&self, h: HalfEdgeId) -> i32 {
        self.runs.get(&h.edge()).map_or(0, |runs| sign(h) * runs)
    }

    /// The bounded faces that the sides run round counter-clockwise. O(faces inside, degrees of the vertices on the rim).
    pub(super) fn inside(&self, map: &Subdivision) -> BTreeSet<FaceId> {
        let mut inside: BTreeSet<FaceId> = BTreeSet::new();
        let mut known: BTreeSet<VertexId> = BTreeSet::new();
        let mut next: Vec<(HalfEdgeId, i32)> = self.outermost(map).map(|h| (h, 0)).into_iter().collect();
        while let Some((start, number)) = next.pop() {
            if !known.insert(map.origin(start)) {
                continue;
            }
            let (mut h, mut left) = (start, number);
            loop {
                if left > 0 {
                    inside.insert(map.face(h));
                }
                if self.runs.contains_key(&h.edge()) {
                    next.push((h.twin(), left - self.along(h)));
                }
                h = map.prev(h).twin();
                left += self.along(h);
                if h == start {
                    break;
                }
            }
        }
        let mut stack: Vec<FaceId> = inside.iter().copied().collect();
        while let Some(f) = stack.pop() {
            let sides = map.cycles(f).flat_map(|h| map.cycle(h));
            for h in sides.filter(|&h| self.along(h) == 0) {
                let beside = map.face(h.twin());
                if inside.insert(beside) {
                    stack.push(beside);
                }
            }
        }
        inside.remove(&map.outer_face());
        inside
    }

    /// The half-edge from the leftmost vertex of the rim, the lowest of several, that has no other of the rim on its left.
    fn outermost(&self, map: &Subdivision) -> Option<HalfEdgeId> {
        let place = |h: &HalfEdgeId| map.point(map.origin(*h));
        let halves = || self.runs.keys().flat_map(|e| e.half_edges());
        let first = halves().min_by(|g, h| left_to_right(place(g), place(h)))?;
        let corner = map.point(map.origin(first));
        let end = |h: HalfEdgeId| map.point(map.destination(h));
        let there = halves().filter(|&h| map.origin(h) == map.origin(first));
        there.reduce(|best, h| if orientation(corner, end(best), end(h)).is_gt() { h } else { best })
    }
}

/// 1 for the first half of an edge, -1 for the other.
fn sign(h: HalfEdgeId) -> i32 {
    1 - 2 * (h.number() % 2) as i32
}
