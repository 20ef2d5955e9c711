//! The lists of cells, and what is asked of one: its few edges are looked at one after the other.
//!
//! ```text
//!   cells   first ──┐   first ──┐   first ──┐         A crowded cell has one word in its list: the number of its crowd.
//!           face    │   face    │   face    │         Its face bears the TAG.
//!   listed          h h h       h h         c
//! ```

use super::Location;
use super::crowd::Crowds;
use super::lines::{Lines, TAG, face_right_of, on_edge};
use super::order::{Ends, crosses_level, is_above, is_above_level, is_left_of, is_right};
use crate::geometry::predicates::orientation;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use std::cmp::Ordering;

/// One cell: where its list starts, and the face at its corner.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Cell {
    pub(super) first: u32,
    pub(super) face: u32,
}

/// What each cell of some rows knows.
#[derive(Clone, Default, Debug)]
pub(super) struct Lists {
    /// Row by row from the lower left; one more at the end.
    pub(super) cells: Vec<Cell>,
    /// Half-edges from left to right, or isolated vertices with the `TAG`.
    pub(super) listed: Vec<u32>,
    pub(super) crowds: Crowds,
    /// The most edges that one query looks at.
    pub(super) worst: usize,
}

impl Lists {
    /// The list of a cell, or the number of its crowd.
    #[inline]
    pub(super) fn of(&self, cell: usize) -> Result<&[u32], u32> {
        let list = &self.listed[self.cells[cell].first as usize..self.cells[cell + 1].first as usize];
        if self.cells[cell].face & TAG == 0 { Ok(list) } else { Err(list[0]) }
    }

    /// The face at the corner of a cell.
    #[inline]
    pub(super) fn corner_face(&self, cell: usize) -> FaceId {
        FaceId::new(self.cells[cell].face & !TAG)
    }

    /// The bytes of all arrays.
    pub(super) fn memory_bytes(&self) -> usize {
        self.cells.capacity() * size_of::<Cell>()
            + self.listed.capacity() * size_of::<u32>()
            + self.crowds.memory_bytes()
    }
}

/// Where the point lies in a cell with a list, unless it lies in the face at the corner.
#[inline]
pub(super) fn locate(lines: &impl Lines, list: &[u32], corner: Point, p: Point) -> Option<Location> {
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
pub(super) fn left_along_bottom(lines: &impl Lines, list: &[u32], corner: Point, x: f64) -> Option<FaceId> {
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
