//! Equal points, and all places from left to right, with the help of a grid.
//!
//! ```text
//!   ┌───┬───┬───┐     Columns of cells from left to right: a point's column and row are monotone functions of its
//!   │. :│   │ . │     coordinates, so equal points meet in one cell, and every point of a column comes before every
//!   ├───┼───┼───┤     point of the next one. What is left is to compare the few points of a cell with each other,
//!   │   │ . │...│     and to sort the distinct ones of a column.
//!   └───┴───┴───┘
//! ```
//!
//! A cell or a column that most points crowd into is sorted: never worse than O(n log n).

use super::equal::{FEW, of_crowd};
use super::grouping::grouped;
use super::point::{Point, corners};
use super::predicates::sort_key;

/// A grid of columns and rows over points.
struct Grid {
    low: Point,
    scale: [f64; 2],
    columns: usize,
    rows: usize,
}

impl Grid {
    /// About one cell for two points.
    fn new(points: impl ExactSizeIterator<Item = Point>) -> Self {
        let count = points.len();
        let [low, high] = corners(points);
        let side = ((count / 2) as f64).sqrt().ceil().max(1.0);
        // Too small a difference gives an infinite scale: then all points are in the last column or the first.
        let scale = [high.x - low.x, high.y - low.y].map(|length| if length > 0.0 { side / length } else { 0.0 });
        Self { low, scale, columns: side as usize, rows: side as usize }
    }

    /// The cell of a point, column by column. A cast takes what is no number for 0.
    #[inline]
    fn cell(&self, p: Point) -> usize {
        let column = ((p.x - self.low.x) * self.scale[0]) as usize;
        let row = ((p.y - self.low.y) * self.scale[1]) as usize;
        column.min(self.columns - 1) * self.rows + row.min(self.rows - 1)
    }
}

/// For each point the number of the first one at its place; and these first ones from left to right, those above each
/// other from bottom to top.
///
/// Cost: expected O(n) where points are spread over the plane, apart from the sort of the distinct points of each
/// column; O(n log n) at worst. Points that come from left to right already cost O(n), and a sort of those above each other.
pub(crate) fn first_at_each_place(points: &[Point]) -> (Vec<u32>, Vec<u32>) {
    if points.is_sorted_by(|p, q| p.x <= q.x) {
        return above_each_other(points);
    }
    let grid = Grid::new(points.iter().copied());
    let (starts, mut list) = grouped(grid.columns * grid.rows, points.len(), |i| grid.cell(points[i]));
    let key = |i: u32| {
        let p = points[i as usize];
        (sort_key(p.x), sort_key(p.y))
    };
    let mut first_of: Vec<u32> = vec![0; points.len()];
    let mut by_place = Vec::new();
    let mut column: Vec<(u64, u64, u32)> = Vec::new();
    for starts in starts.windows(grid.rows + 1).step_by(grid.rows) {
        column.clear();
        for ends in starts.windows(2) {
            let cell = &mut list[ends[0] as usize..ends[1] as usize];
            if cell.len() > FEW {
                of_crowd(cell, key, &mut first_of, |first| {
                    let (x, y) = key(first);
                    column.push((x, y, first));
                });
                continue;
            }
            let start = column.len();
            for &mut i in cell {
                let (x, y) = key(i);
                let same = column[start..].iter().find(|&&(other_x, other_y, _)| (other_x, other_y) == (x, y));
                first_of[i as usize] = same.map_or(i, |&(_, _, first)| first);
                if same.is_none() {
                    column.push((x, y, i));
                }
            }
        }
        column.sort_unstable();
        by_place.extend(column.iter().map(|&(_, _, first)| first));
    }
    (first_of, by_place)
}

/// The same for points whose x does not fall.
fn above_each_other(points: &[Point]) -> (Vec<u32>, Vec<u32>) {
    let mut first_of: Vec<u32> = (0..points.len() as u32).collect();
    let mut by_place = Vec::with_capacity(points.len());
    let mut column: Vec<(u64, u32)> = Vec::new();
    let mut start = 0;
    for column_of in points.chunk_by(|p, q| p.x >= q.x) {
        column.clear();
        column.extend((start..).zip(column_of).map(|(i, p)| (sort_key(p.y), i)));
        start += column_of.len() as u32;
        column.sort_unstable();
        for same in column.chunk_by(|a, b| a.0 == b.0) {
            by_place.push(same[0].1);
            same.iter().for_each(|&(_, i)| first_of[i as usize] = same[0].1);
        }
    }
    (first_of, by_place)
}

/// The numbers of coordinates from the smallest to the greatest, equal ones by their numbers; each with its [`sort_key`].
///
/// Cost: expected O(n) where they are spread evenly; O(n log n) at worst.
pub(crate) fn by_coordinate(coordinates: &[f64]) -> Vec<(u64, u32)> {
    let least = coordinates.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = coordinates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let columns = coordinates.len() / 2 + 1;
    let scale = if greatest > least { columns as f64 / (greatest - least) } else { 0.0 };
    // Monotone, whatever is rounded; a cast takes what is no number for 0.
    let column = |i: usize| (((coordinates[i] - least) * scale) as usize).min(columns - 1);
    let (starts, list) = grouped(columns, coordinates.len(), column);
    let mut order: Vec<(u64, u32)> = list.into_iter().map(|i| (sort_key(coordinates[i as usize]), i)).collect();
    for ends in starts.windows(2).filter(|ends| ends[1] - ends[0] > 1) {
        order[ends[0] as usize..ends[1] as usize].sort_unstable();
    }
    order
}

/// Things at numbered points, from left to right, those above each other from bottom to top; those at one place by the
/// numbers of their points, then by themselves.
///
/// Cost: expected O(n) where they are spread evenly; O(n log n) at worst.
pub(crate) fn from_left_to_right<T: Copy + Ord>(
    things: impl Iterator<Item = (u32, T)>,
    at: impl Fn(u32) -> Point,
) -> Vec<(u32, T)> {
    let things: Vec<(u32, T)> = things.collect();
    let order = by_coordinate(&things.iter().map(|&(p, _)| at(p).x).collect::<Vec<_>>());
    let mut sorted: Vec<(u32, T)> = order.iter().map(|&(_, i)| things[i as usize]).collect();
    let mut start = 0;
    for above_each_other in order.chunk_by(|a, b| a.0 == b.0) {
        let end = start + above_each_other.len();
        if above_each_other.len() > 1 {
            sorted[start..end].sort_unstable_by_key(|&(p, thing)| (sort_key(at(p).y), p, thing));
        }
        start = end;
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::equal::first_of_equals;
    use crate::geometry::random::xorshift;
    use std::collections::BTreeMap;

    /// All the work with one sort, in the plainest way.
    fn by_one_map(points: &[Point]) -> (Vec<u32>, Vec<u32>) {
        let mut first_at: BTreeMap<(u64, u64), u32> = BTreeMap::new();
        let key = |p: &Point| (sort_key(p.x), sort_key(p.y));
        let first = points.iter().zip(0..).map(|(p, i)| *first_at.entry(key(p)).or_insert(i)).collect();
        (first, first_at.into_values().collect())
    }

    #[test]
    fn places_are_those_of_one_sort_however_the_points_crowd() {
        for seed in 1..200_u64 {
            let mut random = xorshift(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut next = |below: u64| (random() >> 20) % below;
            let kind = seed % 6;
            let count = 1 + next(300);
            let mut points: Vec<Point> = Vec::new();
            for i in 0..count {
                let [a, b] = [next(40), next(40)].map(|x| x as f64 - 20.0);
                points.push(match kind {
                    0 => Point::new(a, b),
                    1 => Point::new(0.0, b),
                    2 => Point::new(a, -7.5),
                    // All but one crowd into one cell; many are equal.
                    3 if i > 0 => Point::new(a * 1e-9, b * 1e-9),
                    4 => Point::new(if a < 0.0 { -0.0 } else { 0.0 }, if b < 0.0 { -0.0 } else { 0.0 }),
                    // The differences are of all sizes.
                    5 => Point::new(a * 2_f64.powi(-(next(600) as i32)), b * 2_f64.powi(next(200) as i32)),
                    _ => Point::new(1e6, 1e6),
                });
            }
            assert_eq!(first_at_each_place(&points), by_one_map(&points), "seed {seed}");
            assert_eq!(first_of_equals(&points), by_one_map(&points).0, "seed {seed}");
            // In space, with few heights over each place.
            let lifted: Vec<[f64; 3]> = points.iter().map(|p| [p.x, p.y, [-0.0, 0.0, 1.0][next(3) as usize]]).collect();
            let here = |p: [f64; 3]| move |q: &[f64; 3]| q.partial_cmp(&p) == Some(std::cmp::Ordering::Equal);
            let equal = |i: usize| lifted.iter().position(here(lifted[i])).unwrap_or(i) as u32;
            assert_eq!(first_of_equals(&lifted), (0..lifted.len()).map(equal).collect::<Vec<_>>(), "seed {seed}");
            points.sort_by(|p, q| p.x.total_cmp(&q.x));
            assert_eq!(first_at_each_place(&points), by_one_map(&points), "seed {seed}, from left to right");
        }
    }

    #[test]
    fn coordinates_are_sorted_however_they_crowd() {
        for seed in 1..100_u64 {
            let mut random = xorshift(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut next = |below: u64| (random() >> 20) % below;
            let (size, far) = ([3, 1_000, 1 << 40][seed as usize % 3], [0.0, 1e9][seed as usize / 3 % 2]);
            let mut list: Vec<f64> = (0..next(200)).map(|_| next(size) as f64 * 0.1 - far).collect();
            list.extend([-0.0, 0.0, 1e300, -1e-300].iter().filter(|_| seed % 7 == 0));
            let mut expected: Vec<(u64, u32)> = (0..).zip(&list).map(|(i, &x)| (sort_key(x), i)).collect();
            expected.sort_unstable();
            assert_eq!(by_coordinate(&list), expected, "seed {seed}");
        }
    }
}
