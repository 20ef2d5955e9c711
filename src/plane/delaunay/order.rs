//! The order in which points are divided: near points near each other, equal points found.
//!
//! ```text
//!    ┌────┬────┐      Every point gets a cell of a fine square grid. The bits of its column and row, taken in
//!    │ 01 ┊ 11 │      turn, are its key: sorted by keys, the points of each half, quarter, eighth, … of the grid
//!    ├┄┄┄┄┼┄┄┄┄┤      stand together, and halves are parted by a line with no point on both sides.
//!    │ 00 ┊ 10 │      Points of one cell are sorted by their coordinates themselves; equal ones meet there.
//!    └────┴────┘
//! ```
//!
//! Source: Dwyer, *A faster divide-and-conquer algorithm for constructing Delaunay triangulations*, 1987 (cuts in
//! turn); Morton, *A computer oriented geodetic data base*, 1966 (the order).

use crate::geometry::point::corners;
use crate::geometry::predicates::left_to_right;
use crate::plane::Point;
use std::cmp::Ordering;

/// A direction in which points are divided.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Axis {
    /// From left to right, points above each other from bottom to top.
    X,
    /// From bottom to top, points beside each other from right to left: the same, turned by a right angle.
    Y,
}

impl Axis {
    pub(super) fn other(self) -> Self {
        match self {
            Self::X => Self::Y,
            Self::Y => Self::X,
        }
    }

    /// Which of two points comes first in this direction.
    #[inline]
    pub(super) fn compare(self, a: Point, b: Point) -> Ordering {
        match self {
            Self::X => left_to_right(a, b),
            Self::Y => left_to_right(Point::new(a.y, -a.x), Point::new(b.y, -b.x)),
        }
    }
}

/// A point in the order, and where it stood in the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site {
    pub(super) point: Point,
    /// Column and row of its cell, bit by bit in turn, the column first.
    pub(super) key: u32,
    pub(super) index: u32,
}

/// Points in the order in which they are divided, each place once.
pub(super) struct Ordered {
    pub(super) sites: Vec<Site>,
    /// Points that repeat an earlier one: both input numbers.
    pub(super) repeated: Vec<(u32, u32)>,
}

/// Puts points in order. Expected O(n) when they are spread over the plane, O(n log n) always.
pub(super) fn ordered(points: &[Point]) -> Ordered {
    // About 16 cells for a point, in at most 2^30 cells.
    let bits = ((points.len().max(2).ilog2() + 5) & !1).min(30);
    let mut sites = keyed(points, bits / 2);
    sort_by_key(&mut sites, bits);
    let mut repeated = Vec::new();
    let mut kept = 0;
    let mut start = 0;
    while start < sites.len() {
        let key = sites[start].key;
        let end = start + sites[start..].iter().take_while(|site| site.key == key).count();
        if end - start == 1 {
            sites[kept] = sites[start];
            kept += 1;
        } else {
            let count = distinct(&mut sites[start..end], &mut repeated);
            divide(&mut sites[start..start + count], Axis::X);
            sites.copy_within(start..start + count, kept);
            kept += count;
        }
        start = end;
    }
    sites.truncate(kept);
    repeated.sort_unstable();
    Ordered { sites, repeated }
}

/// The points with their keys: `half` bits for the column and as many for the row.
fn keyed(points: &[Point], half: u32) -> Vec<Site> {
    let [low, high] = corners(points.iter().copied());
    let cells = f64::from(1_u32 << half);
    // Every step is monotone, so that a greater coordinate never gets a smaller cell.
    let cell = |x: f64, low: f64, high: f64| {
        let share = if high > low { (x - low) / (high - low) } else { 0.0 };
        ((share * cells) as u32).min((1 << half) - 1)
    };
    let site = |(index, &point): (usize, &Point)| {
        let key = spread(cell(point.x, low.x, high.x)) << 1 | spread(cell(point.y, low.y, high.y));
        Site { point, key, index: index as u32 }
    };
    points.iter().enumerate().map(site).collect()
}

/// Puts a 0 before each of the lower 16 bits.
fn spread(x: u32) -> u32 {
    let x = (x | x << 8) & 0x00ff_00ff;
    let x = (x | x << 4) & 0x0f0f_0f0f;
    let x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
}

/// Sorts by key, digit by digit from the lowest on; stable. O(n · bits).
fn sort_by_key(sites: &mut Vec<Site>, bits: u32) {
    const MOST: u32 = 12;
    if sites.len() < 1 << MOST {
        return sites.sort_by_key(|site| site.key);
    }
    let length = bits.div_ceil(bits.div_ceil(MOST));
    let mut sorted = sites.clone();
    for shift in (0..bits).step_by(length as usize) {
        let digit = |site: &Site| (site.key >> shift) as usize & ((1 << length) - 1);
        let mut starts = vec![0_usize; 1 << length];
        sites.iter().for_each(|site| starts[digit(site)] += 1);
        let mut sum = 0;
        for start in &mut starts {
            sum += std::mem::replace(start, sum);
        }
        for site in &*sites {
            let start = &mut starts[digit(site)];
            sorted[*start] = *site;
            *start += 1;
        }
        std::mem::swap(sites, &mut sorted);
    }
}

/// Sorts the points of one cell and moves the first of each place to the front. Returns how many there are.
fn distinct(sites: &mut [Site], repeated: &mut Vec<(u32, u32)>) -> usize {
    sites.sort_unstable_by(|a, b| left_to_right(a.point, b.point).then(a.index.cmp(&b.index)));
    let mut count = 1;
    for i in 1..sites.len() {
        let last = sites[count - 1];
        if sites[i].point == last.point {
            repeated.push((sites[i].index, last.index));
        } else {
            sites[count] = sites[i];
            count += 1;
        }
    }
    count
}

/// Where a cell's points are cut in two.
pub(super) fn middle(count: usize) -> usize {
    count / 2
}

/// Parts the distinct points of one cell at their middle, in turn along both axes, down to three. O(n log n).
fn divide(sites: &mut [Site], axis: Axis) {
    if sites.len() > 3 {
        let (low, _, _) = sites.select_nth_unstable_by(middle(sites.len()), |a, b| axis.compare(a.point, b.point));
        let low = low.len();
        let (low, high) = sites.split_at_mut(low);
        divide(low, axis.other());
        divide(high, axis.other());
    }
}
