//! An index over the faces: the plane in equal cells, each with the faces that may reach into it.
//!
//! ```text
//!   ┌────┬────┬────┐    A point's cell is found by two products. A cell with one face, or with one hole and no face,
//!   │  ╲ │  . │    │    is the answer. Else its faces are looked at, most of them on a lattice only (`coarse.rs`).
//!   ├───╲┼────┼────┤    If none has the point it lies in a hole: most cells see one hole only, and know it. In a cell
//!   │    ╲    │    │    that sees several, a ray to the left tells which: the first border it meets is the border of
//!   └────┴╲───┴────┘    that hole.
//! ```
//!
//! Point to cell is a monotone function of each coordinate, and cells take in too many faces rather than too few, so
//! rounding never loses a face. One cell for two faces: some 16 bytes a face, and 12 for the lattice. Where faces are so
//! long and thin that they would be listed very often, the cells are made larger, and points are asked of another index
//! (`slivers.rs`).
//!
//! When faces come and go, the cells they reach into are written anew, and no others (`grid_cells.rs`). A list that has become
//! too long for its place is put behind the last one; once half of all places are spent, the lists close ranks. Only
//! when there are twice as many entries as in the beginning the whole is made anew, with smaller cells.

use super::coarse::Coarse;
use super::hole_edges::HoleEdge;
use super::marks::ID;
use super::records::FaceTable;
use super::slivers::Slivers;
use crate::plane::Point;
use std::collections::BTreeMap;

/// In an item: no face, but the hole that the cell sees. It is the last item of its cell.
pub(super) const GAP: u32 = 1 << 31;
/// In an item: a face, and the last item of its cell.
pub(super) const LAST: u32 = 1 << 30;
/// The cell sees several holes.
pub(super) const SEVERAL: u32 = GAP | ID;
/// The cell sees no border at all.
pub(super) const NOTHING: u32 = SEVERAL - 1;

/// What the index says of a point at first sight.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Look {
    /// Strictly inside this face.
    Face(u32),
    /// In no face, but in this hole.
    Hole(u32),
    /// In no face.
    SomeHole,
    /// The signs have to be asked.
    Unclear,
}

fn look_at_hole(item: u32) -> Look {
    if item == SEVERAL || item == NOTHING { Look::SomeHole } else { Look::Hole(item & ID) }
}

#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Grid {
    pub(super) min: Point,
    pub(super) max: Point,
    /// Cells per unit.
    pub(super) scale: [f64; 2],
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Per cell its only item, which is marked as the last one, or where its items start.
    pub(super) cells: Vec<u32>,
    /// Per cell with several items its faces, then at most one hole.
    pub(super) items: Vec<u32>,
    /// How many places of `items` are of no use any more.
    pub(super) spent: usize,
    /// How many entries the cells have, and had when they were made.
    pub(super) entries: [usize; 2],
    /// How many cells were written since they were made.
    pub(super) written: usize,
    pub(super) coarse: Coarse,
    pub(super) hole_edges: Vec<HoleEdge>,
    /// The edges between holes that reach into each cell: the cell, and which edge.
    pub(super) hole_cells: Vec<(u32, u32)>,
    /// The index that is asked if cells of one size would see too many faces each.
    pub(super) slivers: Option<Box<Slivers>>,
    /// On a map of slivers the faces that came later, per cell.
    pub(super) late: BTreeMap<u32, Vec<u32>>,
    pub(super) late_count: usize,
}

impl Grid {
    /// Bytes of the arrays.
    pub(super) fn memory(&self) -> usize {
        4 * (self.cells.len() + self.items.len() + self.late_count)
            + size_of_val(&*self.hole_edges)
            + size_of_val(&*self.hole_cells)
            + self.coarse.memory()
            + self.slivers.as_ref().map_or(0, |slivers| slivers.memory())
    }

    /// The index to ask before this one, if there is one.
    #[inline]
    pub(super) fn slivers(&self) -> Option<&Slivers> {
        self.slivers.as_deref()
    }

    /// The faces that came later and may have the point, on a map of slivers.
    pub(super) fn late_faces(&self, p: Point) -> &[u32] {
        let [column, row] = self.cell(p);
        self.late.get(&((row * self.columns + column) as u32)).map_or(&[], Vec::as_slice)
    }

    /// Whether no face came later, on a map of slivers.
    pub(super) fn is_fresh(&self) -> bool {
        self.late.is_empty()
    }

    /// How many cells were written since they were made.
    pub(super) fn written(&self) -> usize {
        self.written
    }

    /// The column and the row of a point; points outside go to the nearest cell.
    #[inline]
    pub(super) fn cell(&self, p: Point) -> [usize; 2] {
        // A cast of a negative number gives 0.
        let column = ((p.x - self.min.x) * self.scale[0]) as usize;
        let row = ((p.y - self.min.y) * self.scale[1]) as usize;
        [column.min(self.columns - 1), row.min(self.rows - 1)]
    }

    /// Whether a point is in the box round all faces; never so for coordinates that are no numbers.
    #[inline]
    pub(super) fn contains(&self, p: Point) -> bool {
        p.x >= self.min.x && p.x <= self.max.x && p.y >= self.min.y && p.y <= self.max.y
    }

    /// The point of the box that is the closest to `p`, which has no coordinate that is no number.
    pub(super) fn clamp(&self, p: Point) -> Point {
        Point::new(p.x.clamp(self.min.x, self.max.x), p.y.clamp(self.min.y, self.max.y))
    }

    /// The lower left and the upper right corner of the box round all faces.
    pub(super) fn corners(&self) -> [Point; 2] {
        [self.min, self.max]
    }

    /// How many columns and rows.
    pub(super) fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// The shorter side of a cell.
    pub(super) fn step(&self) -> f64 {
        (1.0 / self.scale[0]).min(1.0 / self.scale[1])
    }

    /// The items of a cell as it was built, and some that are not its own behind the last one.
    #[inline]
    pub(super) fn items(&self, cell: usize) -> &[u32] {
        let word = &self.cells[cell];
        if *word & (GAP | LAST) == 0 { &self.items[*word as usize..] } else { std::slice::from_ref(word) }
    }

    /// The faces that may reach into a cell.
    #[inline]
    pub(super) fn faces(&self, [column, row]: [usize; 2]) -> impl Iterator<Item = u32> + '_ {
        let cell = row * self.columns + column;
        let late = if self.late.is_empty() { None } else { self.late.get(&(cell as u32)) };
        let mut more = true;
        let built = self.items(cell).iter().map_while(move |&item| {
            let is_face = more && item & GAP == 0;
            more = item & LAST == 0;
            is_face.then_some(item & ID)
        });
        built.chain(late.into_iter().flatten().copied())
    }

    /// The column and the row of a cell that [`visit_cells`](Self::visit_cells) told.
    pub(super) fn place_of(&self, cell: u32) -> [usize; 2] {
        [cell as usize % self.columns, cell as usize / self.columns]
    }

    /// What is plain to see of a point of the box.
    #[inline]
    pub(super) fn look(&self, faces: &FaceTable, p: Point) -> Look {
        let [column, row] = self.cell(p);
        let cell = row * self.columns + column;
        let word = self.cells[cell];
        if word & (GAP | LAST) != 0 {
            return if word & GAP == 0 { Look::Face(word & ID) } else { look_at_hole(word) };
        }
        let place = self.coarse.place(p);
        for &item in &self.items[word as usize..] {
            if item & GAP != 0 {
                return look_at_hole(item);
            }
            match self.coarse.is_inside(slot_of(faces, item & ID), place) {
                Some(true) => return Look::Face(item & ID),
                Some(false) if item & LAST == 0 => {}
                _ => break,
            }
        }
        Look::Unclear
    }

    /// Whether so much has come that a new index is worth its cost.
    pub(super) fn is_stale(&self) -> bool {
        self.late_count > self.most_late() || self.entries[0] > self.most_entries()
    }

    /// The most faces that may come late, per cell.
    pub(super) fn most_late(&self) -> usize {
        64 + self.items.len() / 2
    }

    /// The most entries that cells of this size may have.
    pub(super) fn most_entries(&self) -> usize {
        2 * self.entries[1] + 64
    }

    /// The items of a cell, with their marks; nothing for one that has none.
    pub(super) fn own_items(&self, cell: usize) -> &[u32] {
        let items = self.items(cell);
        let last = items.iter().position(|item| item & (GAP | LAST) != 0).map_or(items.len(), |last| last + 1);
        if items[0] == NOTHING { &[] } else { &items[..last] }
    }

    /// Leaves out the places that no cell has.
    pub(super) fn close_ranks(&mut self) {
        let mut items = Vec::with_capacity(self.items.len() - self.spent + self.spent / 4);
        for cell in 0..self.cells.len() {
            if self.cells[cell] & (GAP | LAST) == 0 {
                let start = items.len();
                items.extend_from_slice(self.own_items(cell));
                self.cells[cell] = start as u32;
            }
        }
        (self.items, self.spent) = (items, 0);
    }

    /// The middle of a cell, rounded.
    pub(super) fn middle(&self, [column, row]: [usize; 2]) -> Point {
        let [x, y] = [(column, self.scale[0]), (row, self.scale[1])].map(|(i, scale)| (i as f64 + 0.5) / scale);
        Point::new(self.min.x + x, self.min.y + y)
    }

    /// Calls `visit` with every cell that the convex polygon may reach into, and perhaps some beside it.
    pub(super) fn visit_cells(&self, corners: &[Point], mut visit: impl FnMut(u32)) {
        let size = |of: fn(&Point) -> f64| corners.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        let [bottom, top] = [-size(|p| -p.y), size(|p| p.y)];
        let largest = [self.min, self.max].iter().flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max);
        // More than the rounding of what follows: the line between two rows, and where a side meets it.
        let slack = largest * 2f64.powi(-49);
        let [_, first] = self.cell(Point::new(self.min.x, bottom));
        let [_, last] = self.cell(Point::new(self.min.x, top));
        for row in first..=last {
            let below = self.min.y + row as f64 / self.scale[1] - slack;
            let above = self.min.y + (row + 1) as f64 / self.scale[1] + slack;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (i, &a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
                if first != last && (high.y < below || low.y > above) {
                    continue;
                }
                let at = |y: f64, end: Point, beyond: bool| {
                    if beyond {
                        low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)).clamp(0.0, 1.0)
                    } else {
                        end.x
                    }
                };
                for x in [at(below, low, low.y < below), at(above, high, high.y > above)] {
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            let [from, _] = self.cell(Point::new(left - slack, self.min.y));
            let [to, _] = self.cell(Point::new(right + slack, self.min.y));
            (from..=to).for_each(|column| visit((row * self.columns + column) as u32));
        }
    }
}

/// Where the face is on the lattice.
#[inline]
pub(super) fn slot_of(faces: &FaceTable, f: u32) -> u32 {
    faces.slot(f as usize).map_or(f, |slot| slot as u32)
}
