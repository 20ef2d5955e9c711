//! The columns while an edit writes to them.
//!
//! ```text
//!   records are made ──> pen: slices of the columns ──> many reads and writes ──> records go
//!                        the four of the half-edges of one length: an id that was looked up in one is in all
//! ```
//!
//! What is written through a vector may, as far as a compiler knows, be the vector itself, so each access would ask again
//! where the column lies. Slices in local variables stay where they are.

use super::record::{Change, Recorder, Slot};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};

/// No target.
pub(super) const NONE: u32 = u32::MAX;
/// Marks a word that is not an id.
pub(super) const TAG: u32 = 1 << 31;

/// The number of the element that a word names.
#[inline]
pub(super) fn target(word: u32) -> Option<u32> {
    (word & TAG == 0).then_some(word)
}

/// All columns of a structure, to be written while no record comes or goes.
///
/// It reads what stands there, also where debug builds would say that an element was removed: an edit has looked before.
pub(crate) struct Pen<'a> {
    pub(super) origin: &'a mut [u32],
    pub(super) next: &'a mut [u32],
    pub(super) prev: &'a mut [u32],
    pub(super) face: &'a mut [u32],
    pub(super) outgoing: &'a mut [u32],
    pub(super) boundary: &'a mut [u32],
}

impl Pen<'_> {
    #[inline(always)]
    pub(crate) fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId(self.origin[h.index()])
    }

    #[inline(always)]
    pub(crate) fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.next[h.index()])
    }

    #[inline(always)]
    pub(crate) fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.prev[h.index()])
    }

    #[inline(always)]
    pub(crate) fn face(&self, h: HalfEdgeId) -> FaceId {
        FaceId(self.face[h.index()])
    }

    /// Whether the stored half-edge of a vertex is this one.
    #[inline(always)]
    pub(crate) fn has_outgoing(&self, v: VertexId, h: HalfEdgeId) -> bool {
        self.outgoing[v.index()] == h.0
    }

    /// Whether the stored half-edge of a face is this one.
    #[inline(always)]
    pub(crate) fn has_half_edge(&self, f: FaceId, h: HalfEdgeId) -> bool {
        self.boundary[f.index()] == h.0
    }

    #[inline(always)]
    pub(super) fn word(&mut self, slot: Slot) -> &mut u32 {
        match slot {
            Slot::Origin(h) => &mut self.origin[h.index()],
            Slot::Next(h) => &mut self.next[h.index()],
            Slot::Prev(h) => &mut self.prev[h.index()],
            Slot::Face(h) => &mut self.face[h.index()],
            Slot::Outgoing(v) => &mut self.outgoing[v.index()],
            Slot::HalfEdge(f) => &mut self.boundary[f.index()],
        }
    }

    #[inline(always)]
    fn write(&mut self, slot: Slot, word: u32, rec: &mut impl Recorder) {
        let old = std::mem::replace(self.word(slot), word);
        rec.record(Change::Write { slot, old: element(slot, old), new: element(slot, word) });
    }

    // ---- recorded setters, for the edits --------------------------------------------------------------

    #[inline(always)]
    pub(crate) fn set_origin(&mut self, h: HalfEdgeId, v: VertexId, rec: &mut impl Recorder) {
        self.write(Slot::Origin(h), v.0, rec);
    }

    /// Makes `g` follow `h`: the lab's `makeNext`.
    #[inline(always)]
    pub(crate) fn set_next(&mut self, h: HalfEdgeId, g: HalfEdgeId, rec: &mut impl Recorder) {
        self.write(Slot::Next(h), g.0, rec);
        self.write(Slot::Prev(g), h.0, rec);
    }

    #[inline(always)]
    pub(crate) fn set_face(&mut self, h: HalfEdgeId, f: FaceId, rec: &mut impl Recorder) {
        self.write(Slot::Face(h), f.0, rec);
    }

    #[inline(always)]
    pub(crate) fn set_outgoing(&mut self, v: VertexId, h: Option<HalfEdgeId>, rec: &mut impl Recorder) {
        self.write(Slot::Outgoing(v), h.map_or(NONE, |h| h.0), rec);
    }

    #[inline(always)]
    pub(crate) fn set_half_edge(&mut self, f: FaceId, h: Option<HalfEdgeId>, rec: &mut impl Recorder) {
        self.write(Slot::HalfEdge(f), h.map_or(NONE, |h| h.0), rec);
    }

    /// Clears every pointer of both halves of an edge, before it is removed.
    pub(super) fn clear(&mut self, halves: [HalfEdgeId; 2], rec: &mut impl Recorder) {
        for h in halves {
            for slot in [Slot::Origin(h), Slot::Next(h), Slot::Prev(h), Slot::Face(h)] {
                self.write(slot, NONE, rec);
            }
        }
    }
}

/// The element that a word of this pointer names, if any.
#[inline(always)]
pub(super) fn element(slot: Slot, word: u32) -> Option<Element> {
    target(word).map(|i| match slot {
        Slot::Origin(_) => VertexId(i).into(),
        Slot::Face(_) => FaceId(i).into(),
        _ => HalfEdgeId(i).into(),
    })
}
