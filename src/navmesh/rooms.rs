//! What the exact search runs through: the faces of the mesh, or the merged ones.
//!
//! Both are convex faces in flat arrays with the marks of `mesh.rs`; ids of vertices and places in the list of points
//! are the same.

use super::NavMesh;
use super::mesh::{CLOSED, FaceRecord, ID, SideRecord};
use crate::plane::Point;
use std::ops::Range;

/// The arrays of a search.
#[derive(Clone, Copy)]
pub(super) struct Rooms<'a> {
    pub(super) points: &'a [Point],
    pub(super) faces: &'a [FaceRecord],
    pub(super) sides: &'a [SideRecord],
}

impl<'a> Rooms<'a> {
    /// The merged faces, if there are any, else the faces themselves.
    pub(super) fn of(mesh: &'a NavMesh) -> Self {
        let own = (&*mesh.faces, &*mesh.sides);
        let (faces, sides) = mesh.merged.as_ref().map_or(own, |merged| (&*merged.faces, &*merged.sides));
        Self { points: &mesh.points, faces, sides }
    }

    /// The indices of the sides of a room.
    #[inline]
    pub(super) fn range(&self, room: u32) -> Range<usize> {
        self.faces[room as usize].range()
    }

    /// The vertex at which side `s`, one of `range`, ends; without marks.
    #[inline]
    pub(super) fn end(&self, range: &Range<usize>, s: usize) -> u32 {
        self.sides[if s + 1 == range.end { range.start } else { s + 1 }].origin & ID
    }

    /// The side of a room that starts at `v`. O(sides of the room).
    #[inline]
    pub(super) fn side_from(&self, room: u32, v: u32) -> Option<usize> {
        self.range(room).find(|&s| self.sides[s].origin & ID == v)
    }

    /// The side that starts at the first corner, clockwise, of the wedge to which the corner at the start of side `s`
    /// belongs. O(sides of the rooms of the wedge).
    pub(super) fn first_corner_of_wedge(&self, s: usize) -> usize {
        let v = self.sides[s].origin & ID;
        let mut at = s;
        while self.sides[at].across & CLOSED == 0
            && let Some(next) = self.side_from(self.sides[at].across & ID, v)
            && next != s
        {
            at = next;
        }
        at
    }
}
