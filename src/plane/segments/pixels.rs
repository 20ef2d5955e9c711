//! The hot pixels that a segment passes.
//!
//! ```text
//!   ┏━━━┓          nodes   0 [all]  1 [left half]  2 [..]  3 [..]  4 [right half] ...
//!   ┃ ● ┃╲                 └─ skip ────────────────────────────────> behind it
//!   ┗━━━┛ ╲┏━━━┓
//!          ╲ ● ┃   A tree of boxes over the pixels, in the order of a walk: a box that the segment surely misses is
//!          ┗╲━━┛   skipped with all that is in it. At the leaves each pixel is tested, exactly.
//! ```

use crate::geometry::point::corners;
use crate::geometry::predicates::orientation;
use crate::plane::Point;
use crate::plane::meet::Grid;
use std::cmp::Ordering;

/// So many pixels are tested one by one.
const LEAF: usize = 8;

/// The middles of the hot pixels, to be searched.
pub(super) struct Pixels {
    grid: Grid,
    /// The middles, from left to right, those above each other from bottom to top.
    pub(super) middles: Vec<Point>,
    /// The middles with their numbers, those of each node together.
    order: Vec<(Point, u32)>,
    nodes: Vec<Node>,
}

/// A box with the pixels `start..end` of the order.
struct Node {
    low: Point,
    high: Point,
    start: u32,
    end: u32,
    /// The first node that is no part of this one.
    skip: u32,
}

impl Pixels {
    /// The pixels round grid points, from left to right and each once. O(n log n).
    pub(super) fn new(grid: Grid, middles: Vec<Point>) -> Self {
        let order = middles.iter().copied().zip(0..).collect();
        let mut pixels = Self { grid, middles, order, nodes: Vec::new() };
        if !pixels.order.is_empty() {
            pixels.grow(0, pixels.order.len());
        }
        pixels
    }

    /// Adds the node of a part of the order, and all below it. The depth is the logarithm of the part.
    fn grow(&mut self, start: usize, end: usize) {
        let [low, high] = corners(self.order[start..end].iter().map(|&(middle, _)| middle));
        let node = self.nodes.len();
        self.nodes.push(Node { low, high, start: start as u32, end: end as u32, skip: 0 });
        if end - start > LEAF {
            let middle = usize::midpoint(start, end);
            let wide = high.x - low.x >= high.y - low.y;
            let key = |(middle, _): &(Point, u32)| if wide { middle.x } else { middle.y };
            self.order[start..end].select_nth_unstable_by(middle - start, |p, q| key(p).total_cmp(&key(q)));
            self.grow(start, middle);
            self.grow(middle, end);
        }
        self.nodes[node].skip = self.nodes.len() as u32;
    }

    /// The pixels that the segment passes, in its order.
    ///
    /// Cost: O(log n) and a little for each pixel nearby; for a long segment among n pixels spread evenly O(√n).
    pub(super) fn passed(&self, a: Point, b: Point, found: &mut Vec<u32>) {
        found.clear();
        let near = Near::new(a, b, 2.0 * self.grid.size());
        let mut i = 0;
        while let Some(node) = self.nodes.get(i) {
            if near.misses(node.low, node.high) {
                i = node.skip as usize;
                continue;
            }
            if node.skip as usize == i + 1 {
                let part = &self.order[node.start as usize..node.end as usize];
                let is_passed = |p: Point| !near.misses(p, p) && passes(self.grid, p, a, b);
                found.extend(part.iter().filter(|(middle, _)| is_passed(*middle)).map(|&(_, i)| i));
            }
            i += 1;
        }
        // A segment runs through columns in one direction and through rows in one direction: so do the pixels.
        found.sort_unstable_by(|&p, &q| {
            let (p, q) = (self.middles[p as usize], self.middles[q as usize]);
            let along = |from: f64, to: f64, p: f64, q: f64| if from <= to { p.total_cmp(&q) } else { q.total_cmp(&p) };
            along(a.x, b.x, p.x, q.x).then(along(a.y, b.y, p.y, q.y))
        });
    }
}

/// A segment, and what is near it.
struct Near {
    a: Point,
    /// Along the segment.
    dx: f64,
    dy: f64,
    /// Its box, and a distance more on each side.
    low: Point,
    high: Point,
    more: f64,
}

impl Near {
    fn new(a: Point, b: Point, more: f64) -> Self {
        let [low, high] = corners([a, b]);
        let [low, high] = [Point::new(low.x - more, low.y - more), Point::new(high.x + more, high.y + more)];
        Self { a, dx: b.x - a.x, dy: b.y - a.y, low, high, more }
    }

    /// Whether the segment surely misses all pixels whose middles are in a box. With a grid step to spare for rounding.
    #[inline(always)]
    fn misses(&self, low: Point, high: Point) -> bool {
        if self.high.x < low.x || self.low.x > high.x || self.high.y < low.y || self.low.y > high.y {
            return true;
        }
        let half = |low: f64, high: f64| (high - low) / 2.0 + self.more;
        let (reach_x, reach_y) = (half(low.x, high.x), half(low.y, high.y));
        let (x, y) = (f64::midpoint(low.x, high.x) - self.a.x, f64::midpoint(low.y, high.y) - self.a.y);
        let (one, other) = (self.dx * y, self.dy * x);
        let reach = self.dx.abs() * reach_y + self.dy.abs() * reach_x;
        (one - other).abs() > reach + 1e-14 * (one.abs() + other.abs() + reach)
    }
}

/// Whether the segment has a point in the pixel round a grid point. Exact.
///
/// The right and the upper side are no part of the pixel: they are moved inwards by less than anything else in sight,
/// the upper one by e, the right one by e². On which side of the line a moved corner lies that was on it before, the
/// direction of the line tells.
fn passes(grid: Grid, middle: Point, a: Point, b: Point) -> bool {
    let half = grid.half();
    let (left, right, bottom, top) = (middle.x - half, middle.x + half, middle.y - half, middle.y + half);
    if a.x.max(b.x) < left || a.x.min(b.x) >= right || a.y.max(b.y) < bottom || a.y.min(b.y) >= top {
        return false;
    }
    let by = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    // Down from the line is to its right where it runs to the right; left from it is to its left where it runs up.
    let lowered = by(a.x, b.x);
    let moved_left = by(b.y, a.y);
    let side = |x: f64, y: f64| orientation(a, b, Point::new(x, y));
    let sides = [
        side(left, bottom),
        side(right, bottom).then(moved_left),
        side(left, top).then(lowered),
        side(right, top).then(lowered).then(moved_left),
    ];
    !(sides.iter().all(|s| s.is_gt()) || sides.iter().all(|s| s.is_lt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::predicates::left_to_right;
    use crate::geometry::random::xorshift;

    /// Whether the segment has a point in the half-open unit square round whole numbers (i, j), in fractions: the
    /// parts of the segment between the sides, as intervals with open and closed ends.
    fn passes_in_fractions([i, j]: [i64; 2], a: [i64; 2], b: [i64; 2]) -> bool {
        // All in quarters; t = 0..1 as fractions n / d with d > 0. Conditions 4i - 2 <= a + t d < 4i + 2.
        let mut low = (0_i64, 1_i64, true);
        let mut high = (1_i64, 1_i64, true);
        let less = |(n, d): (i64, i64), (m, e): (i64, i64)| n * e < m * d;
        for (c, axis) in [(i, 0), (j, 1)] {
            let (from, step) = (a[axis], b[axis] - a[axis]);
            for (line, at_least) in [(4 * c - 2, true), (4 * c + 2, false)] {
                if step == 0 {
                    if (at_least && from < line) || (!at_least && from >= line) {
                        return false;
                    }
                    continue;
                }
                // at_least: from + t step >= line; else from + t step < line.
                let (n, d) = if step > 0 { (line - from, step) } else { (from - line, -step) };
                let from_below = at_least == (step > 0);
                let (bound, new) =
                    if from_below { (&mut low, (n, d, at_least)) } else { (&mut high, (n, d, at_least)) };
                let tighter =
                    if from_below { less((bound.0, bound.1), (n, d)) } else { less((n, d), (bound.0, bound.1)) };
                let equal = !less((n, d), (bound.0, bound.1)) && !less((bound.0, bound.1), (n, d));
                if tighter {
                    *bound = new;
                } else if equal {
                    bound.2 &= at_least;
                }
            }
        }
        less((low.0, low.1), (high.0, high.1)) || (!less((high.0, high.1), (low.0, low.1)) && low.2 && high.2)
    }

    #[test]
    fn a_pixel_is_passed_where_fractions_say_so_with_all_its_sides_and_corners() {
        let grid = Grid::of(4.0).unwrap();
        let mut counts = [0; 2];
        for ax in -7..=7_i64 {
            for ay in -7..=7_i64 {
                for bx in -7..=7_i64 {
                    for by in -7..=7_i64 {
                        if [ax, ay] == [bx, by] {
                            continue;
                        }
                        let [a, b] = [(ax, ay), (bx, by)].map(|(x, y)| Point::new(x as f64, y as f64));
                        let expected = passes_in_fractions([0, 0], [ax, ay], [bx, by]);
                        assert_eq!(passes(grid, Point::new(0.0, 0.0), a, b), expected, "{a} {b}");
                        counts[usize::from(expected)] += 1;
                    }
                }
            }
        }
        assert!(counts[0] > 10_000 && counts[1] > 10_000, "{counts:?}");
    }

    #[test]
    fn the_tree_finds_what_a_look_at_each_pixel_finds_in_the_order_of_the_segment() {
        let grid = Grid::of(1.0).unwrap();
        let mut random = xorshift(0x9e37_79b9_7f4a_7c15);
        let mut next = |below: u64| ((random() >> 20) % below) as f64;
        let mut hits = 0;
        for count in [0, 1, 7, 60, 400] {
            let mut middles: Vec<Point> = (0..count).map(|_| Point::new(next(40) - 20.0, next(40) - 20.0)).collect();
            middles.sort_by(|&p, &q| left_to_right(p, q));
            middles.dedup();
            let pixels = Pixels::new(grid, middles.clone());
            let mut found = Vec::new();
            for _ in 0..600 {
                let mut end = || Point::new(next(177) / 4.0 - 22.0, next(177) / 4.0 - 22.0);
                let (a, b) = (end(), end());
                if a == b {
                    continue;
                }
                pixels.passed(a, b, &mut found);
                let mut expected: Vec<u32> =
                    (0..middles.len() as u32).filter(|&i| passes(grid, middles[i as usize], a, b)).collect();
                let along = |i: &u32| {
                    let p = middles[*i as usize];
                    (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)
                };
                expected.sort_by(|i, j| along(i).total_cmp(&along(j)));
                assert_eq!(found, expected, "{a} {b}");
                hits += found.len();
            }
        }
        assert!(hits > 3000, "{hits}");
    }
}
