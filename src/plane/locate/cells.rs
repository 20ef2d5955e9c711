//! The grid: every cell knows the edges through it and the face at its corner.
//!
//! ```text
//!     ┌──────────╲─────┐      From p straight down: the first edge met inside the cell gives the face: it lies above
//!     │   p       ╲    │      that edge. If none is met: left along the bottom of the cell; the first edge met
//!     │   │    ────╲───┼      there tells the face, it lies right of that edge. If none is met, p lies in the face
//!     │   │         ╲  │      at the corner c.
//!     c<──┘          ╲─┘
//! ```
//!
//! All of it is decided by signs of [`orientation`]. Ties are broken as if the way down ran an infinitesimal to the
//! right of p, and the bottom lay a (greater) infinitesimal lower than it does: see `order.rs`.
//!
//! Rounding: corners are pulled to the lower left, and edges listed in every cell that they pass within a margin of,
//! which is far more than what the arithmetic of the grid may be off. So the lists may hold too much, never too little.

use super::Location;
use super::crowd::Crowds;
use super::lines::{Lines, TAG, face_right_of, on_edge};
use super::order::{Ends, crosses_level, is_above, is_above_level, is_left_of, is_right};
use crate::geometry::predicates::orientation;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, SMALLEST};
use std::cmp::Ordering;

/// Cells with more edges than this get a tree.
const CROWDED: u32 = 24;
/// Places in lists, for each edge beside its first one, with one cell for each edge. Where edges are so long that they
/// would need more, the cells are made so large that one is enough: most will be crowded, and a tree is better then.
const MOST_LISTED: f64 = 7.0;

/// One cell: where its list starts, and the face at its corner. A crowded cell has the number of its crowd as list.
#[derive(Clone, Copy, Default, Debug)]
struct Cell {
    first: u32,
    face: u32,
}

/// A grid over edges that do not cross, and isolated vertices.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    frame: Frame,
    outer: FaceId,
    /// Row by row from the lower left; one more at the end.
    cells: Vec<Cell>,
    /// Half-edges from left to right, or isolated vertices with the `TAG`.
    listed: Vec<u32>,
    crowds: Crowds,
    /// The most edges that one query looks at.
    worst: usize,
}

impl Cells {
    /// The grid over the edges, each by its half from left to right, and the isolated vertices, with about
    /// `density` cells for each of them.
    ///
    /// Cost: O(n) while cells are not crowded, O(n log n) expected for whatever is crowded.
    pub(crate) fn new(
        lines: &impl Lines,
        edges: &(impl Iterator<Item = HalfEdgeId> + Clone),
        isolated: &(impl Iterator<Item = VertexId> + Clone),
        outer: FaceId,
        density: f64,
    ) -> Self {
        let frame = Frame::over(lines, edges.clone(), isolated.clone(), density);
        let spots = || isolated.clone().map(|v| (v.number() | TAG, [lines.point(v); 2]));
        let words = || edges.clone().map(|h| (h.number(), lines.ends(h))).chain(spots());
        let mut cells = vec![Cell::default(); frame.count() + 1];
        words().for_each(|(_, ends)| frame.cover(ends, |cell| cells[cell + 1].first += 1));
        (1..cells.len()).for_each(|i| cells[i].first += cells[i - 1].first);
        let mut listed = vec![0; cells.last().map_or(0, |cell| cell.first) as usize];
        // Fills each list from its end, so that `first` of the cell after it ends up where the list starts.
        words().for_each(|(word, ends)| {
            frame.cover(ends, |cell| {
                cells[cell + 1].first -= 1;
                listed[cells[cell + 1].first as usize] = word;
            });
        });
        cells.rotate_left(1);
        if let Some(end) = cells.last_mut() {
            end.first = listed.len() as u32;
        }
        let mut grid = Self { frame, outer, cells, listed, crowds: Crowds::default(), worst: 0 };
        grid.gather_crowds(lines);
        grid.name_corners(lines);
        grid
    }

    /// Gives every crowded cell its tree, and its list up.
    fn gather_crowds(&mut self, lines: &impl Lines) {
        let mut kept = 0;
        let lists = std::mem::take(&mut self.listed);
        self.listed = Vec::with_capacity(lists.len());
        for cell in 0..self.frame.count() {
            let (first, end) = (self.cells[cell].first, self.cells[cell + 1].first);
            let list = &lists[first as usize..end as usize];
            self.cells[cell].first = kept;
            if list.len() as u32 > CROWDED {
                let place = self.frame.place(cell);
                let (corner, right) = (self.frame.corner(place), self.frame.right_of(place));
                let number = self.crowds.add(lines, list, corner, right);
                self.listed.push(number);
                self.cells[cell].face = TAG;
            } else {
                self.listed.extend_from_slice(list);
                self.worst = self.worst.max(list.len());
            }
            kept = self.listed.len() as u32;
        }
        if let Some(end) = self.cells.last_mut() {
            end.first = kept;
        }
        self.listed.shrink_to_fit();
        self.worst = self.worst.max(self.crowds.worst());
    }

    /// Finds the face at the corner of every cell: row by row along the bottoms, from the outer face on the left.
    fn name_corners(&mut self, lines: &impl Lines) {
        for row in 0..self.frame.rows {
            let mut face = self.outer;
            for column in 0..self.frame.columns {
                let cell = self.frame.number([row, column]);
                self.cells[cell].face |= face.number();
                let (corner, next) = (self.frame.corner([row, column]), self.frame.corner([row, column + 1]).x);
                let met = match self.list_or_crowd(cell) {
                    Ok(list) => left_along_bottom(lines, list, corner, next),
                    Err(crowd) => self.crowds.left_along_bottom(lines, crowd, Point::new(next, corner.y)),
                };
                face = met.unwrap_or(face);
            }
        }
    }

    /// The list of a cell, or the number of its crowd.
    #[inline]
    fn list_or_crowd(&self, cell: usize) -> Result<&[u32], u32> {
        let list = &self.listed[self.cells[cell].first as usize..self.cells[cell + 1].first as usize];
        if self.cells[cell].face & TAG == 0 { Ok(list) } else { Err(list[0]) }
    }

    /// Where the point lies; edges by their halves from left to right.
    #[inline]
    pub(crate) fn locate(&self, lines: &impl Lines, p: Point) -> Location {
        let Some(place) = self.frame.place_of(p) else { return Location::Face(self.outer) };
        let cell = self.frame.number(place);
        let found = match self.list_or_crowd(cell) {
            Ok([]) => None,
            Ok(list) => in_list(lines, list, self.frame.corner(place), p),
            Err(crowd) => self.crowds.locate(lines, crowd, self.frame.corner(place).y, p),
        };
        found.unwrap_or(Location::Face(FaceId::new(self.cells[cell].face & !TAG)))
    }

    /// The cell of a point, to ask for points of one cell together; points outside come last.
    pub(crate) fn cell_of(&self, p: Point) -> usize {
        self.frame.place_of(p).map_or(self.frame.count(), |place| self.frame.number(place))
    }

    /// The number of cells.
    pub(crate) fn count(&self) -> usize {
        self.frame.count()
    }

    /// The most edges that one query looks at.
    pub(crate) fn worst_case(&self) -> usize {
        self.worst
    }

    /// The bytes of all arrays.
    pub(crate) fn memory_bytes(&self) -> usize {
        self.cells.capacity() * size_of::<Cell>()
            + self.listed.capacity() * size_of::<u32>()
            + self.crowds.memory_bytes()
    }
}

/// Where the point lies in a cell with a list, unless it lies in the face at the corner.
#[inline]
fn in_list(lines: &impl Lines, list: &[u32], corner: Point, p: Point) -> Option<Location> {
    let mut highest: Option<(HalfEdgeId, Ends)> = None;
    for &word in list {
        if word & TAG != 0 {
            let v = VertexId::new(word & !TAG);
            if lines.point(v) == p {
                return Some(Location::Vertex(v));
            }
            continue;
        }
        let h = HalfEdgeId::new(word);
        let ends = lines.ends(h);
        let [a, b] = ends;
        if p.x < a.x || p.x > b.x {
            continue;
        }
        if p.x >= b.x {
            if p == b {
                return Some(Location::Vertex(lines.origin(h.twin())));
            }
            if a.x >= b.x && p.y >= a.y && p.y < b.y {
                return Some(on_edge(lines, h, p));
            }
            continue;
        }
        match orientation(a, b, p) {
            Ordering::Equal => return Some(on_edge(lines, h, p)),
            Ordering::Less => {}
            Ordering::Greater => {
                let higher = highest.is_none_or(|(_, best)| is_above(ends, best));
                if higher && is_above_level(ends, p, corner.y) {
                    highest = Some((h, ends));
                }
            }
        }
    }
    let face = match highest {
        Some((h, _)) => Some(lines.face(h)),
        None => left_along_bottom(lines, list, corner, p.x),
    };
    face.map(Location::Face)
}

/// The face right of the first edge met on the way from `x` left to the corner, along the bottom of the cell.
fn left_along_bottom(lines: &impl Lines, list: &[u32], corner: Point, x: f64) -> Option<FaceId> {
    let from = Point::new(x, corner.y);
    let mut first: Option<(HalfEdgeId, Ends)> = None;
    for &word in list.iter().filter(|&word| word & TAG == 0) {
        let h = HalfEdgeId::new(word);
        let ends = lines.ends(h);
        if crosses_level(ends, corner.y)
            && is_left_of(ends, from)
            && !is_left_of(ends, corner)
            && first.is_none_or(|(_, best)| is_right(ends, best))
        {
            first = Some((h, ends));
        }
    }
    first.map(|(h, ends)| face_right_of(lines, h, ends))
}

/// Where the cells lie.
#[derive(Clone, Copy, Debug)]
struct Frame {
    low: Point,
    high: Point,
    columns: usize,
    rows: usize,
    /// The size of a cell.
    step: Point,
    /// Cells for a unit of length.
    per_unit: Point,
    /// More than everything here may be off by rounding.
    margin: f64,
}

/// The greatest and total extents of the edges.
struct Extent {
    low: Point,
    high: Point,
    /// The sum of the widths, and of the heights, of all edges.
    total: Point,
    count: usize,
}

impl Extent {
    fn of(ends: impl Iterator<Item = Ends>) -> Self {
        let (inf, mut count) = (f64::INFINITY, 0);
        let (mut low, mut high, mut total) = (Point::new(inf, inf), Point::new(-inf, -inf), Point::default());
        for [a, b] in ends {
            low = Point::new(low.x.min(a.x), low.y.min(a.y).min(b.y));
            high = Point::new(high.x.max(b.x), high.y.max(a.y).max(b.y));
            total = Point::new(total.x + (b.x - a.x), total.y + (b.y - a.y).abs());
            count += 1;
        }
        if count == 0 {
            (low, high) = (Point::default(), Point::default());
        }
        Self { low, high, total, count }
    }
}

impl Frame {
    /// About `density` cells for each edge and vertex, fewer if edges are so long that they pass very many; the cells
    /// are wide where edges are.
    fn over(
        lines: &impl Lines,
        edges: impl Iterator<Item = HalfEdgeId>,
        isolated: impl Iterator<Item = VertexId>,
        density: f64,
    ) -> Self {
        let ends = edges.map(|h| lines.ends(h)).chain(isolated.map(|v| [lines.point(v); 2]));
        let Extent { low, high, total, count } = Extent::of(ends);
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

    fn count(&self) -> usize {
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
    fn place_of(&self, p: Point) -> Option<[usize; 2]> {
        let inside = p.x >= self.low.x && p.x <= self.high.x && p.y >= self.low.y && p.y <= self.high.y;
        inside.then(|| [self.row(p.y), self.column(p.x)])
    }

    #[inline]
    fn number(&self, [row, column]: [usize; 2]) -> usize {
        row * self.columns + column
    }

    fn place(&self, cell: usize) -> [usize; 2] {
        [cell / self.columns, cell % self.columns]
    }

    /// A point to the lower left of all points of the cell.
    #[inline]
    fn corner(&self, [row, column]: [usize; 2]) -> Point {
        let x = self.low.x + column as f64 * self.step.x - self.margin;
        let y = self.low.y + row as f64 * self.step.y - self.margin;
        Point::new(x, y)
    }

    /// A coordinate to the right of all points of the cell.
    fn right_of(&self, [_, column]: [usize; 2]) -> f64 {
        self.low.x + (column + 1) as f64 * self.step.x + self.margin
    }

    /// Calls `visit` for every cell that the edge passes within the margin of, once each. O(cells).
    #[inline]
    fn cover(&self, [a, b]: Ends, mut visit: impl FnMut(usize)) {
        let m = 2.0 * self.margin;
        let (bottom, top) = (a.y.min(b.y), a.y.max(b.y));
        let rows = self.row(bottom - m)..=self.row(top + m);
        if rows.start() == rows.end() {
            (self.column(a.x - m)..=self.column(b.x + m))
                .for_each(|column| visit(self.number([*rows.start(), column])));
            return;
        }
        let slope = if top > bottom { (b.x - a.x) / (b.y - a.y) } else { 0.0 };
        for row in rows {
            let low = self.low.y + row as f64 * self.step.y - m;
            let at = |y: f64| a.x + (y.clamp(bottom, top) - a.y) * slope;
            let ends = if top > bottom { [at(low), at(low + self.step.y + 2.0 * m)] } else { [a.x, b.x] };
            let (left, right) = (ends[0].min(ends[1]).max(a.x), ends[0].max(ends[1]).min(b.x));
            (self.column(left - m)..=self.column(right + m)).for_each(|column| visit(self.number([row, column])));
        }
    }
}
