//! What the exact search runs through: the faces of the mesh, or the merged ones.
//!
//! Both are convex faces with the marks of `mesh.rs`, and the same vertices; the records differ. What is written for
//! rooms is compiled for each of them.

use super::NavMesh;
use super::marks::{ID, SideRecord};
use crate::plane::Point;
use std::ops::Range;

/// A corner of a room, and the side that starts there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Where it is.
    pub(super) at: Point,
    /// The vertex, with its marks.
    pub(super) vertex: u32,
    /// Whether the side is closed, or leads into a dead end, by the marks.
    pub(super) marks: u32,
}

/// Convex faces in flat arrays. Side s runs from corner s to the next one of its room.
pub(super) trait Rooms {
    /// What there is to know of side `s` and the corner it starts from.
    fn corner(&self, s: usize) -> Corner;

    /// Where side `s` starts.
    fn place(&self, s: usize) -> Point;

    /// Where a vertex is.
    fn point(&self, v: u32) -> Point;

    /// What a cone keeps of the side `s` that it crosses.
    fn portal(&self, s: usize) -> u32;

    /// The side that a portal is, as seen from the room before.
    fn side(&self, portal: u32) -> usize;

    /// The room behind a portal.
    fn behind(&self, portal: u32) -> u32;

    /// The indices of the sides of the room behind a portal, and among them the one that starts at its right endpoint.
    fn enter(&self, portal: u32) -> (Range<usize>, usize);

    /// The indices of the sides of a room.
    fn range(&self, room: u32) -> Range<usize>;

    /// The side after `s`, one of `range`.
    #[inline]
    fn next(&self, range: &Range<usize>, s: usize) -> usize {
        if s + 1 == range.end { range.start } else { s + 1 }
    }

    /// The side before `s`, one of `range`.
    #[inline]
    fn prev(&self, range: &Range<usize>, s: usize) -> usize {
        if s == range.start { range.end - 1 } else { s - 1 }
    }
}

impl Rooms for NavMesh {
    #[inline]
    fn corner(&self, s: usize) -> Corner {
        let SideRecord { origin, across } = self.sides[s];
        Corner { at: self.points[(origin & ID) as usize], vertex: origin, marks: across }
    }

    #[inline]
    fn place(&self, s: usize) -> Point {
        self.points[(self.sides[s].origin & ID) as usize]
    }

    #[inline]
    fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    #[inline]
    fn portal(&self, s: usize) -> u32 {
        s as u32
    }

    #[inline]
    fn side(&self, portal: u32) -> usize {
        portal as usize
    }

    #[inline]
    fn behind(&self, portal: u32) -> u32 {
        self.sides[portal as usize].across & ID
    }

    #[inline]
    fn enter(&self, portal: u32) -> (Range<usize>, usize) {
        let SideRecord { origin, across } = self.sides[portal as usize];
        let range = self.faces[(across & ID) as usize].range();
        let first = self.sides[range.clone()].iter().position(|side| (side.origin ^ origin) & ID == 0);
        let first = range.start + first.unwrap_or(0);
        (range, first)
    }

    #[inline]
    fn range(&self, room: u32) -> Range<usize> {
        self.faces[room as usize].range()
    }
}
