//! A tree of boxes over triangles in the plan.
//!
//! ```text
//!        0                 The boxes of a node hold those of the two below it; the middle of the wider direction parts
//!       ╱ ╲                them. The children of node i are 2i + 1 and 2i + 2, so nothing but the boxes is stored.
//!      1   2
//! ```

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Boxes `[x0, y0, x1, y1]`, and the order of the triangles in the leaves.
#[derive(Clone, Debug, Default)]
pub(super) struct Boxes {
    nodes: Vec<[f64; 4]>,
    order: Vec<u32>,
    /// The leaves are node `leaves` and those after it; leaf i has the triangles `ranges[i] .. ranges[i + 1]`.
    leaves: usize,
    ranges: Vec<u32>,
}

/// At most so many triangles lie in a leaf, about.
const LEAF: usize = 4;

const EMPTY: [f64; 4] = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

fn join(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

fn meet(a: &[f64; 4], b: &[f64; 4]) -> bool {
    a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3]
}

impl Boxes {
    /// The tree over these boxes. O(n log n).
    pub(super) fn new(boxes: &[[f64; 4]]) -> Self {
        let leaves = (boxes.len() / LEAF).max(1).next_power_of_two();
        let mut tree = Self {
            nodes: vec![EMPTY; 2 * leaves - 1],
            order: (0..boxes.len() as u32).collect(),
            leaves: leaves - 1,
            ranges: vec![0; leaves + 1],
        };
        tree.ranges[leaves] = boxes.len() as u32;
        tree.part(boxes, 0, 0, boxes.len());
        for i in 0..leaves {
            tree.nodes[tree.leaves + i] = tree.leaf(i).iter().fold(EMPTY, |all, &t| join(all, boxes[t as usize]));
        }
        for i in (0..tree.leaves).rev() {
            tree.nodes[i] = join(tree.nodes[2 * i + 1], tree.nodes[2 * i + 2]);
        }
        tree
    }

    /// Parts the triangles `start .. end` of the order among the leaves below a node.
    fn part(&mut self, boxes: &[[f64; 4]], node: usize, start: usize, end: usize) {
        if node >= self.leaves {
            self.ranges[node - self.leaves] = start as u32;
            return;
        }
        let part = &mut self.order[start..end];
        let all = part.iter().fold(EMPTY, |all, &t| join(all, boxes[t as usize]));
        let axis = usize::from(all[3] - all[1] > all[2] - all[0]);
        let middle = part.len() / 2;
        if middle > 0 {
            let key = |t: u32| boxes[t as usize][axis] + boxes[t as usize][axis + 2];
            part.select_nth_unstable_by(middle, |&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
        }
        self.part(boxes, 2 * node + 1, start, start + middle);
        self.part(boxes, 2 * node + 2, start + middle, end);
    }

    /// The triangles of a leaf.
    fn leaf(&self, i: usize) -> &[u32] {
        &self.order[self.ranges[i] as usize..self.ranges[i + 1] as usize]
    }

    /// How many nodes there are.
    pub(super) fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The leaf of each triangle. O(n).
    pub(super) fn leaves(&self) -> Vec<u32> {
        let mut leaves = vec![0; self.order.len()];
        for i in 0..=self.leaves {
            self.leaf(i).iter().for_each(|&t| leaves[t as usize] = (self.leaves + i) as u32);
        }
        leaves
    }

    /// A node and all that hold it, up to the root.
    pub(super) fn up(node: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(node), |&node| (node > 0).then(|| (node - 1) / 2))
    }

    /// Calls `visit` with every triangle in a leaf whose box meets `around`.
    pub(super) fn visit(&self, around: [f64; 4], visit: impl FnMut(usize)) {
        self.visit_within(around, |_| true, visit);
    }

    /// The same, below nodes only that are `wanted`.
    pub(super) fn visit_within(&self, around: [f64; 4], wanted: impl Fn(usize) -> bool, mut visit: impl FnMut(usize)) {
        let mut stack = vec![0];
        while let Some(node) = stack.pop() {
            if !meet(&self.nodes[node], &around) || !wanted(node) {
                continue;
            }
            if node >= self.leaves {
                self.leaf(node - self.leaves).iter().for_each(|&t| visit(t as usize));
            } else {
                stack.extend([2 * node + 2, 2 * node + 1]);
            }
        }
    }

    /// Calls `visit` with the triangles of one leaf after the other, the one whose box is the nearest to a point first, as
    /// long as boxes are no further away than what it has returned: how far the best is that was found.
    pub(super) fn visit_near(&self, p: [f64; 2], mut visit: impl FnMut(usize) -> f64) {
        // Distances to boxes and to what they hold are rounded one by one.
        const SLACK: f64 = 1.0 - 1e-12;
        let distance = |node: usize| {
            let [x0, y0, x1, y1] = self.nodes[node];
            let out = |low: f64, high: f64, at: f64| (low - at).max(at - high).max(0.0);
            out(x0, x1, p[0]).hypot(out(y0, y1, p[1])) * SLACK
        };
        // Keys are the bits of distances: they are in the order of the distances.
        let mut queue = BinaryHeap::from([Reverse((0, 0))]);
        let mut best = f64::INFINITY;
        while let Some(Reverse((key, node))) = queue.pop() {
            if f64::from_bits(key) > best {
                return;
            }
            if node >= self.leaves {
                self.leaf(node - self.leaves).iter().for_each(|&t| best = best.min(visit(t as usize)));
            } else {
                queue.extend([2 * node + 1, 2 * node + 2].map(|node| Reverse((distance(node).to_bits(), node))));
            }
        }
    }
}

/// The box round points of the plan.
pub(super) fn around(points: &[[f64; 3]]) -> [f64; 4] {
    points.iter().fold(EMPTY, |all, p| join(all, [p[0], p[1], p[0], p[1]]))
}
