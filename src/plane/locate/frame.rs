//! Where the cells lie, how many there are, and which of them an edge passes.
//!
//! ```text
//!   ┌───┬───┬─╱─┐     Rounding: an edge covers every cell that it passes within a margin of, which is far more than what
//!   │   │   │╱  │     the arithmetic here may be off. So lists may hold too much, never too little.
//!   ├───┼───╱───┤
//!   │   │  ╱│   │     Rows are covered by themselves, so that bands of rows can be filled one by one.
//!   └───┴─╱─┴───┘
//! ```

use super::order::Ends;
use crate::plane::{Point, SMALLEST};
use std::ops::Range;

/// Places in lists, for each edge beside its first one, with one cell for each edge. Where edges are so long that they
/// would need more, the cells are made so large that one is enough: most will be crowded, and a tree is better then.
const MOST_LISTED: f64 = 7.0;

/// Where the cells lie.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    low: Point,
    high: Point,
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// The size of a cell.
    step: Point,
    /// Cells for a unit of length.
    per_unit: Point,
    /// More than everything here may be off by rounding.
    margin: f64,
}

/// The greatest and total extents of edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    low: Point,
    high: Point,
    /// The sum of the widths, and of the heights, of all edges.
    total: Point,
    count: usize,
}

impl Extent {
    /// Of no edge.
    pub(super) const NONE: Self = {
        let inf = f64::INFINITY;
        Self { low: Point::new(inf, inf), high: Point::new(-inf, -inf), total: Point::new(0.0, 0.0), count: 0 }
    };

    /// With one edge more.
    #[inline]
    pub(super) fn with(self, [a, b]: Ends) -> Self {
        let total = Point::new(b.x - a.x, (b.y - a.y).abs());
        self.and(&Self { low: Point::new(a.x, a.y.min(b.y)), high: Point::new(b.x, a.y.max(b.y)), total, count: 1 })
    }

    /// Of the edges of both.
    #[inline]
    pub(super) fn and(self, other: &Self) -> Self {
        let Self { low, high, total, count } = other;
        Self {
            low: Point::new(self.low.x.min(low.x), self.low.y.min(low.y)),
            high: Point::new(self.high.x.max(high.x), self.high.y.max(high.y)),
            total: Point::new(self.total.x + total.x, self.total.y + total.y),
            count: self.count + count,
        }
    }
}

impl Frame {
    /// About `density` cells for each edge and vertex, fewer if edges are so long that they pass very many; the cells
    /// are wide where edges are.
    pub(super) fn over(extent: &Extent, density: f64) -> Self {
        let Extent { mut low, mut high, total, count } = *extent;
        if count == 0 {
            (low, high) = (Point::default(), Point::default());
        }
        let [width, height] = [high.x - low.x, high.y - low.y];
        let largest = [low.x, low.y, high.x, high.y].map(f64::abs).into_iter().fold(0.0, f64::max);
        let margin = largest * 2f64.powi(-47);
        // How often the edges together run from one side to the other.
        let share = |total: f64, size: f64| if size > 0.0 { total / size } else { 0.0 };
        let [across, up] = [share(total.x, width), share(total.y, height)];
        let n = count as f64;
        let wanted = (n * density).clamp(1.0, 1e9);
        let most = |size: f64| if size > 0.0 { (size / (16.0 * margin)).clamp(1.0, wanted) } else { 1.0 };
        // Across and up cost as many listed edges each.
        let shape = if across > 0.0 || up > 0.0 { up / across } else { width / height.max(SMALLEST) };
        let mut columns = (wanted * shape).sqrt().clamp(1.0, most(width));
        let mut rows = (wanted / columns).clamp(1.0, most(height));
        let listed = across * columns + up * rows;
        if listed > (MOST_LISTED * density.max(1.0).sqrt() * n).min(3e9) {
            let smaller = n / listed;
            (columns, rows) = ((columns * smaller).max(1.0), (rows * smaller).max(1.0));
        }
        let (columns, rows) = (columns.floor(), rows.floor());
        let per_unit = |cells: f64, size: f64| if size > 0.0 { cells / size } else { 0.0 };
        Self {
            low,
            high,
            columns: columns as usize,
            rows: rows as usize,
            step: Point::new(width / columns, height / rows),
            per_unit: Point::new(per_unit(columns, width), per_unit(rows, height)),
            margin,
        }
    }

    pub(super) fn count(&self) -> usize {
        self.columns * self.rows
    }

    #[inline]
    fn column(&self, x: f64) -> usize {
        (((x - self.low.x) * self.per_unit.x) as usize).min(self.columns - 1)
    }

    #[inline]
    fn row(&self, y: f64) -> usize {
        (((y - self.low.y) * self.per_unit.y) as usize).min(self.rows - 1)
    }

    /// Row and column of the cell of a point; `None` outside.
    #[inline]
    pub(super) fn place_of(&self, p: Point) -> Option<[usize; 2]> {
        let inside = p.x >= self.low.x && p.x <= self.high.x && p.y >= self.low.y && p.y <= self.high.y;
        inside.then(|| [self.row(p.y), self.column(p.x)])
    }

    #[inline]
    pub(super) fn number(&self, [row, column]: [usize; 2]) -> usize {
        row * self.columns + column
    }

    /// A point to the lower left of all points of the cell.
    #[inline]
    pub(super) fn corner(&self, [row, column]: [usize; 2]) -> Point {
        let x = self.low.x + column as f64 * self.step.x - self.margin;
        let y = self.low.y + row as f64 * self.step.y - self.margin;
        Point::new(x, y)
    }

    /// A coordinate to the right of all points of the cell.
    pub(super) fn right_of(&self, [_, column]: [usize; 2]) -> f64 {
        self.low.x + (column + 1) as f64 * self.step.x + self.margin
    }

    /// The first and the last row that the edge passes within the margin of.
    #[inline]
    pub(super) fn rows_of(&self, [a, b]: Ends) -> [usize; 2] {
        let m = 2.0 * self.margin;
        [self.row(a.y.min(b.y) - m), self.row(a.y.max(b.y) + m)]
    }

    /// Calls `visit` for every cell of these rows that the edge passes within the margin of, once each. O(cells).
    #[inline]
    pub(super) fn cover(&self, [a, b]: Ends, within: &Range<usize>, mut visit: impl FnMut(usize)) {
        let m = 2.0 * self.margin;
        let (bottom, top) = (a.y.min(b.y), a.y.max(b.y));
        let [first, last] = self.rows_of([a, b]);
        if first == last {
            (self.column(a.x - m)..=self.column(b.x + m)).for_each(|column| visit(self.number([first, column])));
            return;
        }
        let slope = if top > bottom { (b.x - a.x) / (b.y - a.y) } else { 0.0 };
        for row in first.max(within.start)..(last + 1).min(within.end) {
            let low = self.low.y + row as f64 * self.step.y - m;
            let at = |y: f64| a.x + (y.clamp(bottom, top) - a.y) * slope;
            let ends = if top > bottom { [at(low), at(low + self.step.y + 2.0 * m)] } else { [a.x, b.x] };
            let (left, right) = (ends[0].min(ends[1]).max(a.x), ends[0].max(ends[1]).min(b.x));
            (self.column(left - m)..=self.column(right + m)).for_each(|column| visit(self.number([row, column])));
        }
    }
}
