//! What lies over each other, and what does not.
//!
//! ```text
//!   from the lowest face on, the flood takes the lowest neighbour first, as long as it lies over nothing that the
//!   flood has; what it leaves is for the next one. A flood that lies over nothing of a layer joins it.
//! ```

use super::boxes::{Boxes, around};
use super::{NONE, NavSurface, Space};
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

impl NavSurface {
    /// Makes the tree of boxes. O(n log n).
    pub(super) fn index(&mut self) {
        let boxes: Vec<[f64; 4]> = (0..self.triangle_count()).map(|t| around(&self.corners(t))).collect();
        self.boxes = Boxes::new(&boxes);
    }

    /// Gives every polygon its layer. O(n log n), and what lies over each other.
    pub(super) fn find_layers(&mut self) {
        let polygons = self.layer.len();
        let height = |p: usize| {
            let range = 3 * self.starts[p] as usize..3 * self.starts[p + 1] as usize;
            let count = range.len().max(1) as f64;
            let z = range.map(|s| self.points[self.sides[s].origin as usize][2]).sum::<f64>() / count;
            // Bits in the order of the numbers, negative ones among them.
            let bits = z.to_bits();
            if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
        };
        let mut seeds: Vec<(u64, usize)> =
            (0..polygons).filter(|&p| self.starts[p] < self.starts[p + 1]).map(|p| (height(p), p)).collect();
        seeds.sort_unstable();
        let mut flood = vec![NONE; polygons];
        let mut members = Vec::new();
        for (number, &(key, seed)) in (0..).zip(&seeds) {
            if flood[seed] != NONE {
                continue;
            }
            members.clear();
            let mut queue = BinaryHeap::from([Reverse((key, seed))]);
            while let Some(Reverse((_, p))) = queue.pop() {
                if flood[p] != NONE || self.any_over(p, |other| flood[other] == number) {
                    continue;
                }
                flood[p] = number;
                members.push(p);
                for s in 3 * self.starts[p] as usize..3 * self.starts[p + 1] as usize {
                    let twin = self.sides[s].twin;
                    if twin != NONE {
                        let beyond = self.polygon[twin as usize / 3] as usize;
                        if flood[beyond] == NONE {
                            queue.push(Reverse((height(beyond), beyond)));
                        }
                    }
                }
            }
            let mut taken = BTreeSet::new();
            for &p in &members {
                self.any_over(p, |other| {
                    if flood[other] != NONE && flood[other] != number {
                        taken.insert(self.layer[other]);
                    }
                    false
                });
            }
            let layer = (0..).find(|layer| !taken.contains(layer)).unwrap_or(0);
            members.iter().for_each(|&p| self.layer[p] = layer);
            self.layer_count = self.layer_count.max(layer as usize + 1);
        }
    }

    /// Whether some polygon over or under a part of polygon `p` suits.
    fn any_over(&self, p: usize, mut suits: impl FnMut(usize) -> bool) -> bool {
        let mut found = false;
        for t in self.starts[p] as usize..self.starts[p + 1] as usize {
            let here = self.corners(t);
            self.boxes.visit(around(&here), |other| {
                let polygon = self.polygon[other] as usize;
                found = found || (polygon != p && overlap(here, self.corners(other)) && suits(polygon));
            });
        }
        found
    }
}

pub(super) fn plan(p: Space) -> Point {
    Point::new(p[0], p[1])
}

/// Whether the insides of two triangles meet in the plan. Exact; they run counter-clockwise, or have no area there.
fn overlap(a: [Space; 3], b: [Space; 3]) -> bool {
    let [a, b] = [a, b].map(|t| t.map(plan));
    let is_flat = |t: &[Point; 3]| orientation(t[0], t[1], t[2]).is_eq();
    let parts = |t: &[Point; 3], other: &[Point; 3]| {
        (0..3).any(|i| other.iter().all(|&p| orientation(t[i], t[(i + 1) % 3], p).is_le()))
    };
    !is_flat(&a) && !is_flat(&b) && !parts(&a, &b) && !parts(&b, &a)
}
