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
use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};
use std::ops::Range;

impl NavSurface {
    /// Makes the tree of boxes. O(n log n).
    pub(super) fn index(&mut self) {
        let boxes: Vec<[f64; 4]> = (0..self.triangle_count()).map(|t| around(&self.corners(t))).collect();
        self.boxes = Boxes::new(&boxes);
    }

    /// Gives every polygon its layer. O(n log n) for up to 63 layers; with more, and what lies over each other.
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
        let mut tree = Floods::new(self, polygons);
        let mut members = Vec::new();
        for (number, &(key, seed)) in (0..).zip(&seeds) {
            if tree.flood[seed] != NONE {
                continue;
            }
            members.clear();
            let mut queue = BinaryHeap::from([Reverse((key, seed))]);
            while let Some(Reverse((_, p))) = queue.pop() {
                if tree.flood[p] != NONE || tree.is_over(self, p, number) {
                    continue;
                }
                tree.take(self, p, number);
                members.push(p);
                for s in 3 * self.starts[p] as usize..3 * self.starts[p + 1] as usize {
                    let twin = self.sides[s].twin;
                    if twin != NONE {
                        let beyond = self.polygon[twin as usize / 3] as usize;
                        if tree.flood[beyond] == NONE {
                            queue.push(Reverse((height(beyond), beyond)));
                        }
                    }
                }
            }
            let mut met = Met::default();
            members.iter().for_each(|&p| tree.meet_layers(self, p, number, &mut met));
            let layer = met.first_free();
            for &p in &members {
                self.layer[p] = layer;
                tree.put_into_layer(self, p, layer);
            }
            self.layer_count = self.layer_count.max(layer as usize + 1);
        }
    }

    fn triangles_of(&self, p: usize) -> Range<usize> {
        self.starts[p] as usize..self.starts[p + 1] as usize
    }
}

/// What the floods have so far, with a summary in every node of the tree of boxes: so that whoever looks for one flood, or
/// for layers that he does not know yet, goes nowhere else.
struct Floods {
    /// The flood of each polygon.
    flood: Vec<u32>,
    leaves: Vec<u32>,
    /// For each node the last flood that has a triangle below it.
    last: Vec<u32>,
    /// For each node the layers below it, see [`bit`].
    layers: Vec<u64>,
}

/// The bit of a layer; all from 63 on have the last one.
fn bit(layer: u32) -> u64 {
    1 << layer.min(63)
}

/// The layers that somebody has met.
#[derive(Default)]
struct Met {
    /// Those below 63.
    low: u64,
    high: BTreeSet<u32>,
}

impl Met {
    fn has(&self, layer: u32) -> bool {
        if layer < 63 { self.low & bit(layer) != 0 } else { self.high.contains(&layer) }
    }

    fn insert(&mut self, layer: u32) {
        if layer < 63 {
            self.low |= bit(layer);
        } else {
            self.high.insert(layer);
        }
    }

    fn first_free(&self) -> u32 {
        let low = (!self.low).trailing_zeros();
        if low < 63 { low } else { (63..).find(|layer| !self.high.contains(layer)).unwrap_or(u32::MAX) }
    }
}

impl Floods {
    fn new(surface: &NavSurface, polygons: usize) -> Self {
        let nodes = surface.boxes.node_count();
        let leaves = surface.boxes.leaves();
        Self { flood: vec![NONE; polygons], leaves, last: vec![NONE; nodes], layers: vec![0; nodes] }
    }

    /// Whether polygon `p` lies over or under one that the flood `number`, the latest, has.
    fn is_over(&self, surface: &NavSurface, p: usize, number: u32) -> bool {
        let mut found = false;
        for t in surface.triangles_of(p) {
            let here = surface.corners(t);
            let wanted = |node: usize| self.last[node] == number;
            surface.boxes.visit_within(around(&here), wanted, |other| {
                let is_of_flood = self.flood[surface.polygon[other] as usize] == number;
                found = found || (is_of_flood && overlap(here, surface.corners(other)));
            });
        }
        found
    }

    /// Adds the layers of all that polygon `p` lies over or under and that another flood has.
    fn meet_layers(&self, surface: &NavSurface, p: usize, number: u32, met: &mut Met) {
        for t in surface.triangles_of(p) {
            let here = surface.corners(t);
            let known = Cell::new(met.low);
            let wanted = |node: usize| self.layers[node] & !known.get() != 0;
            surface.boxes.visit_within(around(&here), wanted, |other| {
                let polygon = surface.polygon[other] as usize;
                let flood = self.flood[polygon];
                let layer = surface.layer[polygon];
                if flood != NONE && flood != number && !met.has(layer) && overlap(here, surface.corners(other)) {
                    met.insert(layer);
                    known.set(met.low);
                }
            });
        }
    }

    /// The flood `number` takes polygon `p`.
    fn take(&mut self, surface: &NavSurface, p: usize, number: u32) {
        self.flood[p] = number;
        for t in surface.triangles_of(p) {
            for node in Boxes::up(self.leaves[t] as usize) {
                if std::mem::replace(&mut self.last[node], number) == number {
                    break;
                }
            }
        }
    }

    fn put_into_layer(&mut self, surface: &NavSurface, p: usize, layer: u32) {
        for t in surface.triangles_of(p) {
            for node in Boxes::up(self.leaves[t] as usize) {
                if self.layers[node] & bit(layer) != 0 {
                    break;
                }
                self.layers[node] |= bit(layer);
            }
        }
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
