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
use crate::geometry::threads;
use crate::plane::Point;
use std::cmp::Ordering;
use std::ops::Range;

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

/// How many grids there may be inside a crowded cell, one in a cell of the other.
pub(super) const FINER: usize = 2;

/// A cell with more points than this is crowded.
const CROWDED: usize = 32;

/// Points in the order in which they are divided, each place once.
pub(super) struct Ordered {
    pub(super) sites: Vec<Site>,
    /// The keys of the sites in the finer grids of crowded cells, `NONE` outside of these; they may end behind the last of
    /// these cells.
    finer: [Vec<u32>; FINER],
    /// Points that repeat an earlier one: both input numbers.
    pub(super) repeated: Vec<(u32, u32)>,
}

impl Ordered {
    const NONE: u32 = u32::MAX;

    /// Where the grid at a depth, 0 for that of all points, parts the points of one of its parts, and in which direction:
    /// where the highest bit of their keys changes. None if they have one key.
    #[inline]
    pub(super) fn cut(&self, depth: usize, low: u32, high: u32) -> Option<(u32, Axis)> {
        let range = low as usize..high as usize;
        let (cut, axis) = match depth.checked_sub(1) {
            None => highest_bit(&self.sites[range], |site| site.key),
            Some(finer) => highest_bit(self.finer[finer].get(range)?, |&key| key),
        }?;
        Some((low + cut, axis))
    }

    /// Puts sites of greater keys behind these. O(their number).
    fn append(&mut self, other: Self) {
        let count = self.sites.len();
        self.sites.extend(other.sites);
        for (keys, more) in self.finer.iter_mut().zip(other.finer).filter(|(_, more)| !more.is_empty()) {
            keys.resize(count, Self::NONE);
            keys.extend(more);
        }
        self.repeated.extend(other.repeated);
        self.repeated.sort_unstable();
    }
}

/// How many come before the highest bit of their keys changes, and the direction that this bit parts.
#[inline]
fn highest_bit<T>(range: &[T], key: impl Fn(&T) -> u32) -> Option<(u32, Axis)> {
    let bit = (key(&range[0]) ^ key(&range[range.len() - 1])).checked_ilog2()?;
    let cut = range.partition_point(|item| key(item) >> bit & 1 == 0);
    Some((cut as u32, if bit % 2 == 1 { Axis::X } else { Axis::Y }))
}

/// More points than this are put in order by two threads, if there are two.
const LARGE: usize = 1 << 15;

/// Puts points in order. Expected O(n) when they are spread over the plane or over parts of it, O(n log n) always.
pub(super) fn ordered(points: &[Point]) -> Ordered {
    let grid = Grid::over(points.iter().copied());
    if !threads::are_many() || points.len() <= LARGE {
        return in_order(&grid, grid.sites(points, 0).collect());
    }
    // Each thread takes the points on its side of a key; the first one has room for those of the other, which follow.
    let (cut, count) = (middle_key(&grid, points), points.len());
    let (mut low, high) = threads::both(
        || in_order(&grid, sites_where(&grid, points, count, |key| key < cut)),
        || in_order(&grid, sites_where(&grid, points, count / 2 + count / 8, |key| key >= cut)),
    );
    low.append(high);
    low
}

/// The sites of those points whose keys are wanted, in a vector with so much room. Which ones these are cannot be foreseen, so
/// each is written, and the next one over it if it is not.
fn sites_where(grid: &Grid, points: &[Point], room: usize, is_wanted: impl Fn(u32) -> bool) -> Vec<Site> {
    const BLOCK: usize = 256;
    let mut wanted = Vec::with_capacity(room);
    let mut block = [Site { point: Point::default(), key: 0, index: 0 }; BLOCK];
    for (first, points) in (0..).step_by(BLOCK).zip(points.chunks(BLOCK)) {
        let mut count = 0;
        for site in grid.sites(points, first) {
            block[count] = site;
            count += usize::from(is_wanted(site.key));
        }
        wanted.extend_from_slice(&block[..count]);
    }
    wanted
}

/// A key that about half of the points are below. O(1).
fn middle_key(grid: &Grid, points: &[Point]) -> u32 {
    const ASKED: usize = 1 << 10;
    let mut keys: Vec<u32> = points.iter().step_by(points.len() / ASKED + 1).map(|&p| grid.key(p)).collect();
    let middle = keys.len() / 2;
    *keys.select_nth_unstable(middle).1
}

/// Puts sites that have their keys in order.
fn in_order(grid: &Grid, mut sites: Vec<Site>) -> Ordered {
    let count = sites.len();
    let mut scratch = sites.clone();
    if grid.sort(&mut sites, &mut scratch) {
        std::mem::swap(&mut sites, &mut scratch);
    }
    let order = Ordered { sites, finer: Default::default(), repeated: Vec::new() };
    let mut sorting = Sorting { order, scratch, kept: 0 };
    sorting.cells(0..count, &mut Vec::with_capacity(FINER + 1));
    let Sorting { mut order, kept, .. } = sorting;
    order.sites.truncate(kept);
    for keys in order.finer.iter_mut().filter(|keys| !keys.is_empty()) {
        keys.resize(kept, Ordered::NONE);
    }
    order.repeated.sort_unstable();
    order
}

/// The work of bringing what shares a cell into order.
struct Sorting {
    order: Ordered,
    /// As many sites, to sort with.
    scratch: Vec<Site>,
    /// So many sites are in order, at the front.
    kept: usize,
}

impl Sorting {
    /// Goes through the cells of a grid whose points are sorted by their keys. `path`: the keys of the cells it lies in.
    fn cells(&mut self, range: Range<usize>, path: &mut Vec<u32>) {
        let mut start = range.start;
        while start < range.end {
            let key = self.order.sites[start].key;
            let same = self.order.sites[start..range.end].iter().take_while(|site| site.key == key);
            let end = start + same.count();
            path.push(key);
            if end - start > CROWDED && path.len() <= FINER {
                self.crowded(start..end, path);
            } else {
                self.cell(start..end, path);
            }
            path.pop();
            start = end;
        }
    }

    /// Lays a finer grid over the points of a crowded cell.
    fn crowded(&mut self, range: Range<usize>, path: &mut Vec<u32>) {
        let sites = &mut self.order.sites[range.clone()];
        let grid = Grid::over(sites.iter().map(|site| site.point));
        sites.iter_mut().for_each(|site| site.key = grid.key(site.point));
        let scratch = &mut self.scratch[range.clone()];
        if grid.sort(sites, scratch) {
            sites.copy_from_slice(scratch);
        }
        self.cells(range, path);
    }

    /// The points of one cell, which are parted at their middle, follow those that are in order.
    fn cell(&mut self, range: Range<usize>, path: &[u32]) {
        let start = range.start;
        let mut count = range.len();
        if count > 1 {
            count = distinct(&mut self.order.sites[range], &mut self.order.repeated);
            divide(&mut self.order.sites[start..start + count], Axis::X);
        }
        let kept = self.kept;
        if kept < start {
            self.order.sites.copy_within(start..start + count, kept);
        }
        self.kept += count;
        if let [cell, finer @ ..] = path
            && !finer.is_empty()
        {
            self.order.sites[kept..self.kept].iter_mut().for_each(|site| site.key = *cell);
            for (keys, &key) in self.order.finer.iter_mut().zip(finer) {
                keys.resize(kept, Ordered::NONE);
                keys.resize(self.kept, key);
            }
        }
    }
}

/// A grid over the box of some points, with about 16 cells for each of them, at most 2^30.
struct Grid {
    low: Point,
    high: Point,
    /// The bits of a column, and those of a row.
    half: u32,
}

impl Grid {
    fn over(points: impl Iterator<Item = Point> + Clone) -> Self {
        let half = ((points.clone().count().max(2).ilog2() + 5) / 2).min(15);
        let [low, high] = corners(points);
        Self { low, high, half }
    }

    /// The key of the cell of one of these points.
    #[inline]
    fn key(&self, p: Point) -> u32 {
        let cells = f64::from(1_u32 << self.half);
        // Every step is monotone, so that a greater coordinate never gets a smaller cell.
        let cell = |x: f64, low: f64, high: f64| {
            let share = if high > low { (x - low) / (high - low) } else { 0.0 };
            ((share * cells) as u32).min((1 << self.half) - 1)
        };
        spread(cell(p.x, self.low.x, self.high.x)) << 1 | spread(cell(p.y, self.low.y, self.high.y))
    }

    /// Points of these with their keys; the first one has the given number.
    fn sites(&self, points: &[Point], first: u32) -> impl Iterator<Item = Site> {
        (first..).zip(points).map(|(index, &point)| Site { point, key: self.key(point), index })
    }

    /// Sorts sites by key, digit by digit from the lowest on; stable. Whether they stand in `scratch` then, which is as
    /// long. O(n · bits), with digits of as many bits as n has.
    fn sort(&self, sites: &mut [Site], scratch: &mut [Site]) -> bool {
        const FEW: usize = 256;
        const MOST: u32 = 12;
        if sites.len() < FEW {
            sites.sort_by_key(|site| site.key);
            return false;
        }
        let bits = 2 * self.half;
        let length = bits.div_ceil(bits.div_ceil(sites.len().ilog2().min(MOST)));
        let (mut from, mut to) = (sites, scratch);
        let mut moved = false;
        for shift in (0..bits).step_by(length as usize) {
            let digit = |site: &Site| (site.key >> shift) as usize & ((1 << length) - 1);
            let mut starts = vec![0_usize; 1 << length];
            from.iter().for_each(|site| starts[digit(site)] += 1);
            let mut sum = 0;
            for start in &mut starts {
                sum += std::mem::replace(start, sum);
            }
            for site in &*from {
                let start = &mut starts[digit(site)];
                to[*start] = *site;
                *start += 1;
            }
            std::mem::swap(&mut from, &mut to);
            moved = !moved;
        }
        moved
    }
}

/// Puts a 0 before each of the lower 16 bits.
fn spread(x: u32) -> u32 {
    let x = (x | x << 8) & 0x00ff_00ff;
    let x = (x | x << 4) & 0x0f0f_0f0f;
    let x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
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
