//! The records of the flat view and the marks in their words.
//!
//! ```text
//!   origin   v5 | TURN          across   f9 | CLOSED, or f9 | DEAD_END          len   3 | BLOCKED | PEELED
//! ```
//!
//! What each of them means is told in `mesh.rs`.

/// Ids are smaller than this: two bits of a word are marks.
pub(super) const MOST: usize = 1 << 30;
/// No face, no component.
pub(super) const NONE: u32 = u32::MAX;
/// In `across`: the side must not be crossed.
pub(super) const CLOSED: u32 = 1 << 31;
/// In `across`, on open sides: what lies behind leads nowhere else.
pub(super) const DEAD_END: u32 = 1 << 30;
/// In `origin`: a shortest path may bend here.
pub(super) const TURN: u32 = 1 << 31;
/// The id without its marks.
pub(super) const ID: u32 = DEAD_END - 1;
/// In `len`: the face is blocked.
pub(super) const BLOCKED: u32 = 1 << 31;
/// In `len`: the face is a dead end. Its portal is its only open side that does not lead into another one.
pub(super) const PEELED: u32 = 1 << 30;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SideRecord {
    /// The vertex the side starts from, with the mark [`TURN`].
    pub(super) origin: u32,
    /// The face behind the side, with the marks [`CLOSED`] and [`DEAD_END`].
    pub(super) across: u32,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct FaceRecord {
    /// The first of the sides.
    pub(super) start: u32,
    /// How many sides, with the marks [`BLOCKED`] and [`PEELED`]; 0 if this is no face of the mesh.
    pub(super) len: u32,
    pub(super) component: u32,
}

impl FaceRecord {
    pub(super) const ABSENT: Self = Self { start: 0, len: 0, component: NONE };

    /// A face with sides `start .. end` and no marks.
    pub(super) fn new(start: usize, end: usize) -> Self {
        Self { start: start as u32, len: (end - start) as u32, ..Self::ABSENT }
    }

    /// The indices of the sides.
    #[inline]
    pub(super) fn range(&self) -> std::ops::Range<usize> {
        let start = self.start as usize;
        start..start + (self.len & !(BLOCKED | PEELED)) as usize
    }
}
