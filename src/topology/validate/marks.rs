//! What has been found of each half-edge, a byte for each.

use std::cell::Cell;

/// T1 and T2 hold.
pub(super) const TWIN: u8 = 1;
/// N2 holds: its `next` leads on, and back.
pub(super) const NEXT: u8 = 2;
/// D1 holds.
pub(super) const END: u8 = 4;
/// F1 holds.
pub(super) const FACE: u8 = 8;
/// A walk has come by.
const SEEN: u8 = 16;

/// Sets of the above. A walk reads some of them and writes others in turn.
pub(super) struct Marks(Vec<Cell<u8>>);

impl Marks {
    pub(super) fn new(half_edges: usize) -> Self {
        Self(vec![Cell::new(0); half_edges])
    }

    /// Whether a half-edge has all of the marks.
    #[inline]
    pub(super) fn has(&self, h: u32, marks: u8) -> bool {
        self.0[h as usize].get() & marks == marks
    }

    #[inline]
    pub(super) fn set(&self, h: u32, mark: u8) {
        let marks = &self.0[h as usize];
        marks.set(marks.get() | mark);
    }

    /// Whether no walk has come by a half-edge since [`forget_seen`](Self::forget_seen); one has now.
    #[inline]
    pub(super) fn is_new(&self, h: u32) -> bool {
        let is_new = !self.has(h, SEEN);
        self.set(h, SEEN);
        is_new
    }

    pub(super) fn forget_seen(&self) {
        self.0.iter().for_each(|marks| marks.set(marks.get() & !SEEN));
    }
}
