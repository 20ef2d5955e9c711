//! Boxes in a balanced tree, to find the few that matter at a place of the paper.
//!
//! ```text
//!   ┌───────────────┐          the box of a node holds those of its two halves; cut in the middle of the items,
//!   │ ┌───┐   ┌───┐ │          across the longest side: left and right, low and high, or near and far
//!   │ │ 3 │   │1,7│ │
//!   │ └───┘   └───┘ │          whoever asks says of each box whether to go on there
//!   └───────────────┘
//! ```
//!
//! Source: Ericson, *Real-Time Collision Detection*, chapter 6 (bounding volume hierarchies, top-down, median cut).

use crate::geometry::interval::range;
use crate::plane::Point;

/// A box over the paper: its sides, and how near to the eye it reaches.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Bounds {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) low: f64,
    pub(super) high: f64,
    /// The greatest nearness inside; infinite if it is not known.
    pub(super) near: f64,
}

impl Bounds {
    /// Holds nothing yet.
    pub(super) const NONE: Self = Self {
        left: f64::INFINITY,
        right: f64::NEG_INFINITY,
        low: f64::INFINITY,
        high: f64::NEG_INFINITY,
        near: f64::NEG_INFINITY,
    };

    /// A single place, as far away as can be.
    pub(super) fn at(p: Point) -> Self {
        Self { left: p.x, right: p.x, low: p.y, high: p.y, near: f64::NEG_INFINITY }
    }

    /// A box that reaches further by so much on all four sides.
    pub(super) fn wider(self, margin: f64) -> Self {
        let Self { left, right, low, high, near } = self;
        Self { left: left - margin, right: right + margin, low: low - margin, high: high + margin, near }
    }

    /// Whether the place lies in the box or on its sides.
    pub(super) fn holds(&self, p: Point) -> bool {
        p.x >= self.left && p.x <= self.right && p.y >= self.low && p.y <= self.high
    }

    /// Whether the boxes have a place in common.
    pub(super) fn touches(&self, other: &Self) -> bool {
        self.left <= other.right && other.left <= self.right && self.low <= other.high && other.low <= self.high
    }

    /// Whether the line through `a` and `b` meets the box, or passes so close that rounding does not tell.
    pub(super) fn meets_line(&self, a: Point, b: Point) -> bool {
        let middle = Point::new(f64::midpoint(self.left, self.right), f64::midpoint(self.low, self.high));
        let (x, y) = (b.x - a.x, b.y - a.y);
        let far = (middle.x - a.x) * y - (middle.y - a.y) * x;
        let reach = 0.5 * ((self.right - self.left) * y.abs() + (self.high - self.low) * x.abs());
        far.abs() <= reach * (1.0 + 1e-9)
    }

    /// The smallest box that holds both.
    pub(super) fn with(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            right: self.right.max(other.right),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            near: self.near.max(other.near),
        }
    }
}

/// A node: its items are a stretch of the list, halved between its two children. The left child comes right after it.
struct Node {
    bounds: Bounds,
    items: [u32; 2],
    /// The right child; 0 for a leaf.
    right: u32,
}

/// Items `0 .. n`, found by their boxes.
pub(super) struct Tree {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

/// No node with so few items is cut.
const FEW: usize = 4;

impl Tree {
    /// A tree over items with these boxes; `middle` tells where an item lies: x, y, nearness. Cost: O(n log n).
    pub(super) fn new(bounds: &[Bounds], middle: impl Fn(usize) -> [f64; 3]) -> Self {
        let middles: Vec<[f64; 3]> = (0..bounds.len()).map(middle).collect();
        let mut tree = Self { nodes: Vec::new(), items: (0..bounds.len() as u32).collect() };
        let mut items = std::mem::take(&mut tree.items);
        // So that near and far can be compared with left and right.
        let scale = extents(&items, &middles).map(|size| if size > 0.0 { 1.0 / size } else { 0.0 });
        tree.cut(&mut items, 0, bounds, &middles, scale);
        tree.items = items;
        tree
    }

    fn cut(&mut self, items: &mut [u32], first: usize, bounds: &[Bounds], middles: &[[f64; 3]], scale: [f64; 3]) {
        let whole = items.iter().fold(Bounds::NONE, |all, &i| all.with(bounds[i as usize]));
        let node = self.nodes.len();
        self.nodes.push(Node { bounds: whole, items: [first as u32, (first + items.len()) as u32], right: 0 });
        if items.len() <= FEW {
            return;
        }
        let sizes = extents(items, middles);
        let size = |axis: usize| sizes[axis] * scale[axis];
        let axis = (1..3).fold(0, |best, axis| if size(axis) > size(best) { axis } else { best });
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |&a, &b| {
            middles[a as usize][axis].total_cmp(&middles[b as usize][axis]).then(a.cmp(&b))
        });
        let (left, right) = items.split_at_mut(half);
        self.cut(left, first, bounds, middles, scale);
        self.nodes[node].right = self.nodes.len() as u32;
        self.cut(right, first + half, bounds, middles, scale);
    }

    /// Looks for an item that `is_found` accepts, where all boxes round it pass `goes_on`. In no order that means
    /// anything.
    pub(super) fn any(&self, goes_on: impl Fn(&Bounds) -> bool, mut is_found: impl FnMut(usize) -> bool) -> bool {
        // The tree is cut in the middle, so that it is no deeper than a number has bits.
        let mut waiting = Vec::with_capacity(32);
        waiting.push(0);
        while let Some(at) = waiting.pop() {
            let Some(node) = self.nodes.get(at) else { continue };
            if !goes_on(&node.bounds) {
                continue;
            }
            if node.right == 0 {
                let [first, end] = node.items.map(|i| i as usize);
                if self.items[first..end].iter().any(|&i| is_found(i as usize)) {
                    return true;
                }
            } else {
                waiting.extend([node.right as usize, at + 1]);
            }
        }
        false
    }
}

/// How far the middles of the items reach along each axis; 0 along one where they are not finite.
fn extents(items: &[u32], middles: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let [low, high] = range(items.iter().map(|&i| middles[i as usize][axis]));
        if (high - low).is_finite() { high - low } else { 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every item whose box holds a place is visited, however boxes lie, and far fewer than all are looked at.
    #[test]
    fn no_box_that_holds_a_place_is_missed_and_few_others_are_looked_at() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (count, size) in [(0, 0.1), (1, 0.5), (5, 0.5), (2000, 0.01), (2000, 0.4)] {
            let bounds: Vec<Bounds> = (0..count)
                .map(|_| {
                    let at = Bounds::at(Point::new(random(), random()));
                    Bounds { near: random(), ..at.wider(size * random()) }
                })
                .collect();
            let tree = Tree::new(&bounds, |i| [bounds[i].left, bounds[i].low, bounds[i].near]);
            let mut looked_at = 0;
            for _ in 0..100 {
                let (at, near) = (Point::new(random(), random()), random());
                let holds = |b: &Bounds| b.holds(at) && b.near >= near;
                let mut found: Vec<usize> = Vec::new();
                let stopped = tree.any(holds, |i| {
                    looked_at += 1;
                    found.extend(holds(&bounds[i]).then_some(i));
                    false
                });
                assert!(!stopped);
                found.sort_unstable();
                let all: Vec<usize> = (0..count).filter(|&i| holds(&bounds[i])).collect();
                assert_eq!(found, all, "{count} boxes of {size}");
                assert_eq!(tree.any(holds, |i| holds(&bounds[i])), !all.is_empty());
            }
            assert!(
                count < 2000 || size > 0.1 || looked_at < 100 * count / 20,
                "{looked_at} of {count} boxes of {size}"
            );
        }
    }

    /// A box is met by a line that passes it, and by no other.
    #[test]
    fn lines_beside_a_box_do_not_meet_it() {
        let square = Bounds { left: 0.0, right: 2.0, low: 0.0, high: 2.0, near: 0.0 };
        let meets = |a: [f64; 2], b: [f64; 2]| square.meets_line(a.into(), b.into());
        assert!(meets([-1.0, 1.0], [3.0, 1.5]) && meets([0.0, 3.0], [3.0, 0.0]) && meets([-1.0, 2.0], [1.0, 2.0]));
        assert!(!meets([2.0, 3.0], [5.0, 0.0]) && !meets([-1.0, 2.5], [1.0, 2.5]));
    }
}
