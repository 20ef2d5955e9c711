//! How far everything is where a unit of length costs more in some faces than in others.
//!
//! ```text
//!   ●──·──·──●        Nodes are the corners of faces and some points on every side, see `steiner.rs`. Within a face one
//!   │ ╲   1  ·        goes straight from node to node, for the length times the cost of the face. So each answer is what
//!   ·   ╲    ·        some path costs, and never less than the least; where all faces cost the same, searches without
//!   ●──·──·──●        costs give the exact answer.
//! ```
//!
//! Source: Lanthier, Maheshwari and Sack, *Approximating shortest paths on weighted polyhedral surfaces*, 2001.

use super::Work;
use super::steiner::{Side, distance, steiner_points};
use super::surface::Space;
use crate::geometry::grouping::Groups;
use crate::ids::{FaceId, FaceMap};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// Convex faces with nodes on their sides. The height of a point of a map of the plane is 0.
#[derive(Default)]
pub(super) struct Cells {
    at: Vec<Space>,
    sides: Vec<Side>,
    /// Places inside of cells, where paths begin or end.
    stops: Vec<Space>,
    /// Which cell has which node.
    has: Vec<[u32; 2]>,
    costs: Vec<f64>,
    /// From node to node, for a price.
    jumps: BTreeMap<u32, Vec<(u32, f64)>>,
}

impl Cells {
    /// Another node.
    pub(super) fn node(&mut self, at: Space) -> u32 {
        self.at.push(at);
        self.at.len() as u32 - 1
    }

    /// Another node, where paths begin or end.
    pub(super) fn stop(&mut self, at: Space) -> u32 {
        self.stops.push(at);
        self.node(at)
    }

    /// A side of the cells beside it, whose points will be nodes of theirs.
    pub(super) fn side(&mut self, ends: [Space; 2], cells: [Option<u32>; 2]) {
        self.sides.push(Side { ends, cells });
    }

    /// A cell has a node.
    pub(super) fn put(&mut self, cell: u32, node: u32) {
        self.has.push([cell, node]);
    }

    /// Another cell.
    pub(super) fn cell(&mut self, cost: f64) -> u32 {
        self.costs.push(cost.max(0.0));
        self.costs.len() as u32 - 1
    }

    /// A way from one node to another.
    pub(super) fn jump(&mut self, [from, to]: [u32; 2], cost: f64) {
        self.jumps.entry(from).or_default().push((to, cost));
    }

    /// What it costs to get from a node to each node, as far as it is no more than `limit`; infinite beyond.
    ///
    /// Cost: O(k² log n) for each cell with k nodes.
    pub(super) fn spread(mut self, start: u32, limit: f64) -> (Vec<f64>, Work) {
        let sides = std::mem::take(&mut self.sides);
        for (side, share) in steiner_points(&sides, self.costs.len(), &self.stops) {
            let side = &sides[side as usize];
            let node = self.node(side.at(share));
            side.cells.into_iter().flatten().for_each(|cell| self.put(cell, node));
        }
        let of_cell = Groups::new(self.costs.len(), self.has.iter().map(|&[cell, node]| (cell as usize, node)));
        let of_node = Groups::new(self.at.len(), self.has.iter().map(|&[cell, node]| (node as usize, cell)));
        let mut least = vec![f64::INFINITY; self.at.len()];
        let mut work = Work::default();
        // Keys are the bits of costs: they are in the order of the costs.
        let mut queue = BinaryHeap::from([Reverse((0u64, start))]);
        least[start as usize] = 0.0;
        while let Some(Reverse((key, node))) = queue.pop() {
            work.pops += 1;
            let here = f64::from_bits(key);
            if here > least[node as usize] {
                continue;
            }
            let mut reach = |other: u32, cost: f64| {
                // Sums of many parts may be smaller by rounding alone.
                if cost < least[other as usize] * (1.0 - 2.0 * f64::EPSILON) && cost <= limit {
                    least[other as usize] = cost;
                    work.pushes += 1;
                    queue.push(Reverse((cost.to_bits(), other)));
                }
            };
            for &cell in of_node.of(node as usize) {
                work.expansions += 1;
                for &other in of_cell.of(cell as usize) {
                    let [a, b] = [node, other].map(|node| self.at[node as usize]);
                    reach(other, here + self.costs[cell as usize] * distance(a, b));
                }
            }
            for &(other, cost) in self.jumps.get(&node).into_iter().flatten() {
                reach(other, here + cost);
            }
        }
        (least, work)
    }
}

/// The cost that all of these faces have, if there is one.
pub(super) fn common(costs: &FaceMap<f64>, mut faces: impl Iterator<Item = FaceId>) -> Option<f64> {
    let first = costs[faces.next()?].max(0.0);
    faces.all(|f| costs[f].max(0.0).total_cmp(&first).is_eq()).then_some(first)
}
