//! How the cells come to know what they know.
//!
//! ```text
//!   edges   ▒▒▒▒│▒▒▒▒│▒▒▒▒│▒▒       1. stretches of the numbering: the half from left to right of each edge, their extent
//!           └─┬┴──┬─┘                2. every stretch tells which bands of rows its edges pass
//!   bands   ═════════ ═════════      3. every band counts, fills its lists, gathers crowds and names the corners
//! ```
//!
//! The points of a band stay in the cache while it is filled, whatever the order of the numbering; and threads share the
//! stretches and the bands. The face at the left end of every row is the outer one, so that rows need not know each other.

use super::crowd::Crowds;
use super::frame::{Extent, Frame};
use super::lines::{Lines, TAG};
use super::lists::{Cell, Lists, left_along_bottom};
use super::order::Ends;
use crate::geometry::grouping::Groups;
use crate::geometry::predicates::left_to_right;
use crate::geometry::threads::pieces;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::progress::Stage;
use std::ops::Range;

/// Cells with more edges than this get a tree.
const CROWDED: u32 = 24;
/// Edges of a stretch.
const STRETCH: usize = 1 << 16;
/// Cells of a band, about: all that is read while it is filled takes a megabyte or two.
const BAND: usize = 1 << 16;

/// The lists of all rows.
#[derive(Clone, Debug)]
pub(super) struct Bands {
    /// A band has two to this power of rows, the last one what is left.
    height: u32,
    /// From the bottom up.
    bands: Vec<Lists>,
}

impl Bands {
    /// The frame over the words, which are half-edges, one of each edge, and isolated vertices with the `TAG`; and what
    /// the cells in it know.
    pub(super) fn filled<L: Lines>(
        lines: &L,
        words: impl Iterator<Item = u32>,
        outer: FaceId,
        density: f64,
    ) -> (Frame, Self) {
        let mut stretches = Stretch::cut(words);
        pieces(&mut stretches, 1, |_, stretch| stretch[0].measure(lines));
        let frame = Frame::over(&stretches.iter().fold(Extent::NONE, |all, stretch| all.and(&stretch.extent)), density);
        let height = (BAND / frame.columns).max(1).ilog2();
        let count = ((frame.rows - 1) >> height) + 1;
        pieces(&mut stretches, 1, |_, stretch| stretch[0].share_out(lines, &frame, height, count));
        let stage = Stage::new("preparing location", frame.rows);
        let mut bands = vec![Lists::default(); count];
        pieces(&mut bands, 1, |number, band| {
            let rows = number << height..frame.rows.min((number + 1) << height);
            let shares = stretches.iter().filter_map(|stretch| stretch.by_band.as_ref());
            let words = shares.flat_map(|all| all.of(number)).copied();
            Band { lines, frame: &frame, rows, lists: &mut band[0] }.fill(words, outer);
            stage.add(1 << height);
        });
        (frame, Self { height, bands })
    }

    /// The lists of a row, and the number of a cell of the row in them.
    #[inline]
    pub(super) fn at(&self, frame: &Frame, [row, column]: [usize; 2]) -> (&Lists, usize) {
        let row_of_band = row & ((1 << self.height) - 1);
        (&self.bands[row >> self.height], frame.number([row_of_band, column]))
    }

    /// The most edges that one query looks at.
    pub(super) fn worst(&self) -> usize {
        self.bands.iter().map(|band| band.worst).max().unwrap_or(0)
    }

    /// The bytes of all arrays.
    pub(super) fn memory_bytes(&self) -> usize {
        self.bands.iter().map(|band| size_of::<Lists>() + band.memory_bytes()).sum()
    }
}

/// The ends of an edge; of an isolated vertex, its place twice.
#[inline]
fn ends(lines: &impl Lines, word: u32) -> Ends {
    if word & TAG == 0 { lines.ends(HalfEdgeId::new(word)) } else { [lines.point(VertexId::new(word & !TAG)); 2] }
}

/// Edges and isolated vertices that are next to each other in the numbering.
struct Stretch {
    words: Vec<u32>,
    extent: Extent,
    /// The words again, by the bands that they pass.
    by_band: Option<Groups<u32>>,
}

impl Stretch {
    fn cut(mut words: impl Iterator<Item = u32>) -> Vec<Self> {
        let mut all = Vec::new();
        loop {
            let words: Vec<u32> = words.by_ref().take(STRETCH).collect();
            if words.is_empty() {
                return all;
            }
            all.push(Self { words, extent: Extent::NONE, by_band: None });
        }
    }

    /// Takes the halves that run from left to right, or up, and finds the extent.
    fn measure(&mut self, lines: &impl Lines) {
        for word in &mut self.words {
            let [mut a, mut b] = ends(lines, *word);
            if left_to_right(a, b).is_gt() {
                *word = HalfEdgeId::new(*word).twin().number();
                (a, b) = (b, a);
            }
            self.extent = self.extent.with([a, b]);
        }
    }

    /// Gives the words to the bands of so many rows.
    fn share_out(&mut self, lines: &impl Lines, frame: &Frame, height: u32, count: usize) {
        let words = std::mem::take(&mut self.words);
        let mut pairs = Vec::with_capacity(words.len() + words.len() / 4);
        for word in words {
            let [first, last] = frame.rows_of(ends(lines, word)).map(|row| row >> height);
            pairs.extend((first..=last).map(|band| (band as u32, word)));
        }
        self.by_band = Some(Groups::new(count, pairs.iter().map(|&(band, word)| (band as usize, word))));
    }
}

/// Rows that are filled together.
struct Band<'a, L> {
    lines: &'a L,
    frame: &'a Frame,
    rows: Range<usize>,
    lists: &'a mut Lists,
}

impl<L: Lines> Band<'_, L> {
    fn fill(&mut self, words: impl Iterator<Item = u32>, outer: FaceId) {
        let Self { lines, frame, rows, .. } = self;
        let base = rows.start * frame.columns;
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for word in words {
            frame.cover(ends(*lines, word), rows, |cell| pairs.push(((cell - base) as u32, word)));
        }
        let mut cells = vec![Cell::default(); rows.len() * frame.columns + 1];
        pairs.iter().for_each(|&(cell, _)| cells[cell as usize + 1].first += 1);
        (1..cells.len()).for_each(|i| cells[i].first += cells[i - 1].first);
        let mut listed = vec![0; pairs.len()];
        // Fills each list from its end, so that `first` of the cell after it ends up where the list starts.
        for (cell, word) in pairs {
            let next = &mut cells[cell as usize + 1];
            next.first -= 1;
            listed[next.first as usize] = word;
        }
        cells.rotate_left(1);
        if let Some(end) = cells.last_mut() {
            end.first = listed.len() as u32;
        }
        *self.lists = Lists { cells, listed, crowds: Crowds::default(), worst: 0 };
        self.gather_crowds();
        self.name_corners(outer);
    }

    /// Gives every crowded cell its tree, and its list up.
    fn gather_crowds(&mut self) {
        let Lists { cells, listed, crowds, worst } = &mut *self.lists;
        let mut kept = 0;
        for cell in 0..cells.len() - 1 {
            let list = cells[cell].first as usize..cells[cell + 1].first as usize;
            cells[cell].first = kept as u32;
            if list.len() as u32 > CROWDED {
                let place = [self.rows.start + cell / self.frame.columns, cell % self.frame.columns];
                let (corner, right) = (self.frame.corner(place), self.frame.right_of(place));
                listed[kept] = crowds.add(self.lines, &listed[list], corner, right);
                cells[cell].face = TAG;
                kept += 1;
            } else {
                *worst = (*worst).max(list.len());
                let len = list.len();
                listed.copy_within(list, kept);
                kept += len;
            }
        }
        listed.truncate(kept);
        listed.shrink_to_fit();
        if let Some(end) = cells.last_mut() {
            end.first = kept as u32;
        }
        *worst = (*worst).max(crowds.worst());
    }

    /// Finds the face at the corner of every cell: row by row along the bottoms, from the outer face on the left.
    fn name_corners(&mut self, outer: FaceId) {
        let mut cell = 0;
        for row in self.rows.clone() {
            let mut face = outer;
            for column in 0..self.frame.columns {
                self.lists.cells[cell].face |= face.number();
                let (corner, next) = (self.frame.corner([row, column]), self.frame.corner([row, column + 1]).x);
                let met = match self.lists.of(cell) {
                    Ok(list) => left_along_bottom(self.lines, list, corner, next),
                    Err(crowd) => self.lists.crowds.left_along_bottom(self.lines, crowd, Point::new(next, corner.y)),
                };
                face = met.unwrap_or(face);
                cell += 1;
            }
        }
    }
}
