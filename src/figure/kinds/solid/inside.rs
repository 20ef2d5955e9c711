//! Whether a place of the paper lies in a face, by the number of its sides to the right.
//!
//! ```text
//!    y ┬ ●───────●            a face with many corners: the heights of its corners cut the paper into rows, a
//!      │  ╲   ╱╲  ╲           balanced tree joins rows to wider ones, and every side is listed in the few that make
//!      ├   ●─●  ●──●          up its height, from left to right. In each row above the place a search by halves
//!                             counts the sides to the right of it.
//! ```
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 10.3 (segment trees).

use crate::geometry::grouping::Groups;
use crate::plane::Point;

/// With fewer corners a look at all sides is as fast.
const MANY: usize = 32;

type Side = [Point; 2];

/// The outline of a face.
#[derive(Clone, Default)]
pub(super) struct Outline {
    corners: Vec<Point>,
    rows: Option<Rows>,
}

impl Outline {
    /// Cost: O(n log n).
    pub(super) fn new(corners: Vec<Point>) -> Self {
        let rows = (corners.len() > MANY).then(|| Rows::new(&corners));
        Self { corners, rows }
    }

    /// Whether the place lies inside: O(log² n) where no two sides cross on the paper.
    pub(super) fn contains(&self, at: Point) -> bool {
        let crossed = match &self.rows {
            Some(rows) => rows.to_the_right(at),
            None => sides(&self.corners).filter(|side| is_beside(side, at) && is_right_of(side, at)).count(),
        };
        crossed % 2 == 1
    }
}

fn sides(corners: &[Point]) -> impl Iterator<Item = Side> + '_ {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Whether the side is met on the level of the place.
fn is_beside([a, b]: &Side, at: Point) -> bool {
    (a.y > at.y) != (b.y > at.y)
}

/// Whether the side, which is met on the level of the place, is met to the right of it.
fn is_right_of(side: &Side, at: Point) -> bool {
    at.x < x_at(side, at.y)
}

fn x_at([a, b]: &Side, y: f64) -> f64 {
    a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)
}

/// A segment tree over the heights of the sides.
#[derive(Clone)]
struct Rows {
    /// The heights of the corners, from low to high, each once: row i lies between i and i + 1.
    levels: Vec<f64>,
    /// The nodes of the tree as in a heap: those of node i are 2 i and 2 i + 1; row r is node `leaves + r`.
    leaves: usize,
    /// The sides of each node, from left to right; `crossing` ones in any order.
    listed: Groups<Side>,
    /// Whether some of the sides of a node cross, so that there is no order from left to right.
    crossing: Vec<bool>,
}

impl Rows {
    fn new(corners: &[Point]) -> Self {
        let mut levels: Vec<f64> = corners.iter().map(|p| p.y).collect();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup();
        let leaves = levels.len().next_power_of_two();
        let listed = Groups::new(2 * leaves, std::iter::empty());
        let mut rows = Self { levels, leaves, listed, crossing: Vec::new() };
        let mut nodes_of = Vec::new();
        for side in sides(corners) {
            rows.cover(&side, |node| nodes_of.push((node, side)));
        }
        rows.listed = Groups::new(2 * leaves, nodes_of.into_iter());
        rows.crossing = (0..2 * leaves).map(|node| rows.put_in_order(node)).collect();
        rows
    }

    /// The few nodes whose rows together are those of the side.
    fn cover(&self, [a, b]: &Side, mut visit: impl FnMut(usize)) {
        let row = |y: f64| self.levels.partition_point(|&level| level < y) + self.leaves;
        let (mut low, mut high) = (row(a.y.min(b.y)), row(a.y.max(b.y)));
        while low < high {
            if low % 2 == 1 {
                visit(low);
                low += 1;
            }
            if high % 2 == 1 {
                high -= 1;
                visit(high);
            }
            (low, high) = (low / 2, high / 2);
        }
    }

    /// Sorts the sides of a node. Returns whether some of them cross.
    fn put_in_order(&mut self, node: usize) -> bool {
        let [low, high] = self.span(node);
        let list = self.listed.of_mut(node);
        if list.len() < 2 {
            return false;
        }
        let middle = f64::midpoint(low, high);
        list.sort_by(|s, t| x_at(s, middle).total_cmp(&x_at(t, middle)));
        let reach = list.iter().flatten().map(|p| p.x.abs()).fold(0.0, f64::max);
        list.windows(2).any(|pair| [low, high].iter().any(|&y| x_at(&pair[0], y) > x_at(&pair[1], y) + 1e-12 * reach))
    }

    /// From which height to which the rows of a node reach.
    fn span(&self, node: usize) -> [f64; 2] {
        let below = (self.leaves.ilog2() - node.max(1).ilog2()) as usize;
        let first = (node << below) - self.leaves.min(node << below);
        let level = |row: usize| self.levels[row.min(self.levels.len() - 1)];
        [level(first), level(first + (1 << below))]
    }

    /// How many sides are met on the level of the place to the right of it.
    fn to_the_right(&self, at: Point) -> usize {
        let above = self.levels.partition_point(|&level| level <= at.y);
        if above == 0 || above == self.levels.len() {
            return 0;
        }
        let (mut node, mut count) = (above - 1 + self.leaves, 0);
        while node > 0 {
            let list = self.listed.of(node);
            count += match self.crossing[node] {
                true => list.iter().filter(|side| is_right_of(side, at)).count(),
                false => list.len() - list.partition_point(|side| !is_right_of(side, at)),
            };
            node /= 2;
        }
        count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A whole number below `bound`, from a fixed sequence.
    fn below(state: &mut u64, bound: u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) % bound
    }

    /// The rows tell the same as a look at all sides: for outlines that cross themselves, too, on the heights of
    /// corners, and on the sides.
    #[test]
    fn rows_count_what_a_look_at_all_sides_counts() {
        let mut state = 15;
        for size in [3, 4, 7, 33, 64, 200] {
            for kind in 0..3 {
                let corner = |i: usize, state: &mut u64| {
                    // Half the angle by its tangent: nearly once round, without a sine.
                    let half = 6.0 * (i as f64 + 0.5) / size as f64 - 3.0;
                    let turn = [1.0 - half * half, 2.0 * half].map(|x| x / (1.0 + half * half));
                    let out = 4.0 + below(state, 9) as f64;
                    match kind {
                        0 => Point::new(out * turn[0], out * turn[1]),
                        1 => Point::new(below(state, 12) as f64, below(state, 12) as f64),
                        _ => Point::new(i as f64, if i.is_multiple_of(2) { 0.0 } else { out }),
                    }
                };
                let corners: Vec<Point> = (0..size).map(|i| corner(i, &mut state)).collect();
                let rows = Rows::new(&corners);
                for _ in 0..400 {
                    let at =
                        Point::new(below(&mut state, 64) as f64 / 4.0 - 4.0, below(&mut state, 64) as f64 / 4.0 - 4.0);
                    let all = sides(&corners).filter(|side| is_beside(side, at) && is_right_of(side, at)).count();
                    assert_eq!(rows.to_the_right(at) % 2, all % 2, "kind {kind}, {size} corners, {at}");
                }
            }
        }
    }
}
