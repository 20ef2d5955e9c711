//! The memory layout, known to this file and to `pen.rs` alone.
//!
//! ```text
//!              h0   h1   h2   h3  ...        four plain columns of u32, 16 bytes a half-edge;
//!   origin   [ v0 | v1 | v1 | v2 | ... ]     a walk touches only the columns it needs.
//!   next     [ h2 | h7 | h4 | h1 | ... ]     twin(h) = h ^ 1 and edge(h) = h >> 1 cost nothing.
//!   prev     [ h6 | h3 | h0 | h5 | ... ]
//!   face     [ f1 | f0 | f1 | f0 | ... ]     outgoing: one u32 a vertex, boundary: one u32 a face
//! ```
//!
//! A word with the top bit set is not an id: `NONE` is a pointer to nothing, any other such word stands in
//! the record of a removed element and holds the next free slot (see `pool.rs`).

pub(super) use super::pen::{NONE, TAG};
use super::pen::{Pen, element, target};
use super::record::{Recorder, Slot};
use super::view::Words;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};

/// Ends a free list.
pub(super) const FREE_END: u32 = 0x7fff_fffe;

/// A half-edge structure: vertices, half-edges and faces joined by `next`, `prev`, `twin`, `face` and
/// `origin`, and nothing else. It knows no coordinate.
///
/// ```text
///                    twin(h)
///           ●<────────────────────●
///   origin(h) ───────── h ──────> ● destination(h) = origin(twin(h))
///           ^                      \
///            \      face(h)         \  next(h)
///    prev(h)  \    on the left       v
/// ```
///
/// Properties: `twin(twin(h)) == h`, `next(prev(h)) == h == prev(next(h))`,
/// `origin(next(h)) == destination(h)`, `face(next(h)) == face(h)`, `face(half_edge(f)) == f`,
/// `origin(outgoing(v)) == v`. Every public edit keeps them; [`violations`](super::violations) checks them.
///
/// The structure accepts whatever is combinatorially legal: loops, parallel edges, dangling edges, a torus.
/// Two structures are `==` when they agree bit for bit, free slots included; for equality up to the names of
/// the elements use [`isomorphic`](super::isomorphic).
///
/// Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.2 (the doubly-connected edge list).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Dcel {
    columns: Columns,
    pub(super) free: FreeLists,
}

/// Heads and lengths of the three free lists. Which ids are kept makes no difference to `==`.
#[derive(Clone, Copy, Eq, Debug)]
pub(super) struct FreeLists {
    pub(super) vertex: u32,
    pub(super) edge: u32,
    pub(super) face: u32,
    pub(super) vertices: u32,
    pub(super) edges: u32,
    pub(super) faces: u32,
    /// Numbers of vertices, edges and faces below these are in no list: see `pool.rs`.
    pub(super) kept: [u32; 3],
}

impl PartialEq for FreeLists {
    fn eq(&self, other: &Self) -> bool {
        let lists = |free: &Self| [free.vertex, free.edge, free.face, free.vertices, free.edges, free.faces];
        lists(self) == lists(other)
    }
}

impl FreeLists {
    pub(super) const EMPTY: Self =
        Self { vertex: FREE_END, edge: FREE_END, face: FREE_END, vertices: 0, edges: 0, faces: 0, kept: [0; 3] };
}

/// The columns of a structure, as a builder fills them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Columns {
    pub(crate) origin: Vec<u32>,
    pub(crate) next: Vec<u32>,
    pub(crate) prev: Vec<u32>,
    pub(crate) face: Vec<u32>,
    pub(crate) outgoing: Vec<u32>,
    pub(crate) boundary: Vec<u32>,
}

impl Columns {
    /// The word of a pointer that has no target: an isolated vertex's `outgoing`.
    pub(crate) const NONE: u32 = NONE;

    /// The four columns that have a word for each half-edge.
    #[inline(always)]
    pub(super) fn of_half_edges(&mut self) -> [&mut Vec<u32>; 4] {
        [&mut self.origin, &mut self.next, &mut self.prev, &mut self.face]
    }

    pub(super) fn words(&self) -> Words<'_> {
        let Self { origin, next, prev, face, outgoing, boundary } = self;
        Words { origin, next, prev, face, outgoing, boundary }
    }
}

impl Default for Dcel {
    fn default() -> Self {
        Self::new()
    }
}

/// Whether the word of a vertex or face is not the link of a removed one: an id, or `NONE`.
#[inline]
fn is_live(word: u32) -> bool {
    word.wrapping_add(1) <= TAG
}

/// Getters that accept every id: `None` if the element does not exist, or the pointer is not set.
macro_rules! optional_pointers {
    ($($column:ident($from:ty) -> $to:ident as $name:ident;)*) => {
        $(
            #[inline]
            pub(crate) fn $name(&self, from: $from) -> Option<$to> {
                self.columns.$column.get(from.index()).copied().and_then(target).map($to)
            }
        )*
    };
}

/// The setters of a pen that is used once.
macro_rules! recorded_setters {
    ($($(#[$doc:meta])* $name:ident($from:ident: $from_type:ty, $to:ident: $to_type:ty);)*) => {
        $(
            $(#[$doc])*
            #[inline]
            pub(crate) fn $name(&mut self, $from: $from_type, $to: $to_type, rec: &mut impl Recorder) {
                self.pen().$name($from, $to, rec);
            }
        )*
    };
}

impl Dcel {
    /// A structure without any element.
    #[must_use]
    pub fn new() -> Self {
        Self::from_columns(Columns::default())
    }

    /// Takes columns that obey the invariants and have no dead record.
    pub(crate) fn from_columns(columns: Columns) -> Self {
        Self { columns, free: FreeLists::EMPTY }
    }

    /// Gives the columns back.
    pub(crate) fn into_columns(self) -> Columns {
        self.columns
    }

    /// All columns.
    pub(crate) fn all_words(&self) -> Words<'_> {
        self.columns.words()
    }

    /// One more than the greatest vertex number ever used: the length of a [`VertexMap`](crate::VertexMap).
    #[must_use]
    #[inline]
    pub fn vertex_bound(&self) -> usize {
        self.columns.outgoing.len()
    }

    /// One more than the greatest half-edge number ever used.
    #[must_use]
    #[inline]
    pub fn half_edge_bound(&self) -> usize {
        self.columns.next.len()
    }

    /// One more than the greatest edge number ever used.
    #[must_use]
    #[inline]
    pub fn edge_bound(&self) -> usize {
        self.columns.next.len() / 2
    }

    /// One more than the greatest face number ever used.
    #[must_use]
    #[inline]
    pub fn face_bound(&self) -> usize {
        self.columns.boundary.len()
    }

    /// The vertex a half-edge starts at. O(1).
    ///
    /// # Panics
    /// If `h` was never allocated, as every getter does: `there is no h99: there are 10 half-edges`. In debug builds also
    /// if `h` was removed and its slot has not been used again: `h12 was removed earlier`. In release builds that is not
    /// looked at, and the answer then means nothing; [`check`](Self::check) tells.
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId(self.read_link(&self.columns.origin, h.index(), h, "origin"))
    }

    /// The vertex a half-edge ends at: the origin of its twin. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        VertexId(self.read_link(&self.columns.origin, h.twin().index(), h, "destination"))
    }

    /// The other half of the same edge. O(1), no memory access.
    #[must_use]
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        h.twin()
    }

    /// The edge of a half-edge. O(1), no memory access.
    #[must_use]
    #[inline]
    pub fn edge(&self, h: HalfEdgeId) -> EdgeId {
        h.edge()
    }

    /// The half-edge after `h` along the boundary of its face. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.read_link(&self.columns.next, h.index(), h, "next"))
    }

    /// The half-edge before `h` along the boundary of its face. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.read_link(&self.columns.prev, h.index(), h, "prev"))
    }

    /// The face on the left of `h`. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn face(&self, h: HalfEdgeId) -> FaceId {
        FaceId(self.read_link(&self.columns.face, h.index(), h, "face"))
    }

    /// One half-edge that starts at `v`; none if `v` is isolated. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.debug_assert_not_removed(v);
        target(self.read(&self.columns.outgoing, v.index(), v)).map(HalfEdgeId)
    }

    /// One half-edge whose face is `f` (the lab's `incidentHalfEdge`); none if `f` has no boundary. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn half_edge(&self, f: FaceId) -> Option<HalfEdgeId> {
        self.debug_assert_not_removed(f);
        target(self.read(&self.columns.boundary, f.index(), f)).map(HalfEdgeId)
    }

    /// A pointer of a half-edge that must be set. Only debug builds look whether it is.
    #[inline(always)]
    #[track_caller]
    fn read_link(&self, column: &[u32], index: usize, h: HalfEdgeId, pointer: &str) -> u32 {
        let word = self.read(column, index, h);
        debug_assert!(word & TAG == 0, "{}", self.not_linked(h, pointer));
        word
    }

    /// A word of a column, for an element that has one there.
    #[inline(always)]
    #[track_caller]
    fn read(&self, column: &[u32], index: usize, element: impl Into<Element>) -> u32 {
        match column.get(index) {
            Some(&word) => word,
            None => self.no_such(element),
        }
    }

    /// Ends with the message that an id is of no element: `there is no v99: there are 5 vertices`.
    #[cold]
    #[inline(never)]
    #[track_caller]
    pub(crate) fn no_such(&self, element: impl Into<Element>) -> ! {
        match self.check(element.into()) {
            Err(error) => panic!("{error}"),
            Ok(()) => panic!("an id that exists was not found"),
        }
    }

    /// Whether `h` has no face yet: a border half-edge while a structure is being built.
    pub(crate) fn lacks_face(&self, h: HalfEdgeId) -> bool {
        self.columns.face[h.index()] == NONE
    }

    /// Whether `v` exists: allocated and not removed. O(1).
    #[must_use]
    #[inline]
    pub fn has_vertex(&self, v: VertexId) -> bool {
        self.columns.outgoing.get(v.index()).is_some_and(|&word| is_live(word))
    }

    /// Whether `h` exists: allocated and not removed. O(1).
    #[must_use]
    #[inline]
    pub fn has_half_edge(&self, h: HalfEdgeId) -> bool {
        self.columns.origin.get(h.index()).is_some_and(|&word| word & TAG == 0)
    }

    /// Whether `e` exists: allocated and not removed. O(1).
    #[must_use]
    #[inline]
    pub fn has_edge(&self, e: EdgeId) -> bool {
        self.has_half_edge(e.half_edges()[0])
    }

    /// Whether `f` exists: allocated and not removed. O(1).
    #[must_use]
    #[inline]
    pub fn has_face(&self, f: FaceId) -> bool {
        self.columns.boundary.get(f.index()).is_some_and(|&word| is_live(word))
    }

    /// Bytes of memory the structure holds: 16 for each half-edge, 4 for each vertex and each face, live or
    /// free (plus what the vectors have in reserve).
    #[must_use]
    pub fn memory_bytes(&self) -> usize {
        let Columns { origin, next, prev, face, outgoing, boundary } = &self.columns;
        let columns = [origin, next, prev, face, outgoing, boundary].map(Vec::capacity);
        columns.iter().sum::<usize>() * size_of::<u32>() + size_of::<Self>()
    }

    /// Makes room for so many more elements, so that edits need not move the columns while they grow. Changes
    /// nothing else.
    ///
    /// ```
    /// # use dcel_kit::topology::Dcel;
    /// let mut square = Dcel::polygon(4)?;
    /// square.reserve(100, 100, 0);
    /// assert_eq!(square, Dcel::polygon(4)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reserve(&mut self, vertices: usize, edges: usize, faces: usize) {
        for column in self.columns.of_half_edges() {
            column.reserve(2 * edges);
        }
        self.columns.outgoing.reserve(vertices);
        self.columns.boundary.reserve(faces);
    }

    // ---- pointers that may not be set, for views --------------------------------------------------------

    optional_pointers! {
        origin(HalfEdgeId) -> VertexId as linked_origin;
        next(HalfEdgeId) -> HalfEdgeId as linked_next;
        prev(HalfEdgeId) -> HalfEdgeId as linked_prev;
        face(HalfEdgeId) -> FaceId as linked_face;
        outgoing(VertexId) -> HalfEdgeId as linked_outgoing;
        boundary(FaceId) -> HalfEdgeId as linked_half_edge;
    }

    // ---- raw words, for pool.rs -----------------------------------------------------------------------

    pub(super) fn vertex_word(&mut self, v: VertexId) -> &mut u32 {
        &mut self.columns.outgoing[v.index()]
    }

    pub(super) fn edge_words(&mut self, e: EdgeId) -> &mut [u32] {
        let first = e.index() * 2;
        &mut self.columns.origin[first..first + 2]
    }

    pub(super) fn face_word(&mut self, f: FaceId) -> &mut u32 {
        &mut self.columns.boundary[f.index()]
    }

    #[inline]
    pub(super) fn push_vertex(&mut self) -> VertexId {
        self.columns.outgoing.push(NONE);
        VertexId(self.columns.outgoing.len() as u32 - 1)
    }

    #[inline(always)]
    pub(super) fn push_edge(&mut self) -> EdgeId {
        for column in self.columns.of_half_edges() {
            // Each of them stays in line, however many edits add edges; `extend` does not.
            column.push(NONE);
            column.push(NONE);
        }
        EdgeId(self.columns.next.len() as u32 / 2 - 1)
    }

    #[inline]
    pub(super) fn push_face(&mut self) -> FaceId {
        self.columns.boundary.push(NONE);
        FaceId(self.columns.boundary.len() as u32 - 1)
    }

    pub(super) fn pop_vertex(&mut self) {
        self.columns.outgoing.pop();
    }

    pub(super) fn pop_edge(&mut self) {
        let bound = self.columns.next.len() - 2;
        for column in self.columns.of_half_edges() {
            column.truncate(bound);
        }
    }

    pub(super) fn pop_face(&mut self) {
        self.columns.boundary.pop();
    }

    /// Whether the record is in use: not removed, though none of its pointers may be set yet.
    pub(super) fn has_record(&self, element: Element) -> bool {
        let live = |column: &[u32], i: usize| column.get(i).is_some_and(|&word| is_live(word));
        match element {
            Element::Vertex(v) => live(&self.columns.outgoing, v.index()),
            Element::HalfEdge(h) => live(&self.columns.origin, h.index()),
            Element::Edge(e) => live(&self.columns.origin, 2 * e.index()),
            Element::Face(f) => live(&self.columns.boundary, f.index()),
        }
    }

    /// Where a pointer leads; `None` if it is not set, or its record is dead.
    pub(super) fn raw(&self, slot: Slot) -> Option<Element> {
        let (column, index) = match slot {
            Slot::Origin(h) => (&self.columns.origin, h.index()),
            Slot::Next(h) => (&self.columns.next, h.index()),
            Slot::Prev(h) => (&self.columns.prev, h.index()),
            Slot::Face(h) => (&self.columns.face, h.index()),
            Slot::Outgoing(v) => (&self.columns.outgoing, v.index()),
            Slot::HalfEdge(f) => (&self.columns.boundary, f.index()),
        };
        column.get(index).and_then(|&word| element(slot, word))
    }

    /// Writes a pointer without recording it.
    pub(super) fn put(&mut self, slot: Slot, to: Option<Element>) {
        *self.pen().word(slot) = to.map_or(NONE, |element| match element {
            Element::Vertex(VertexId(i))
            | Element::HalfEdge(HalfEdgeId(i))
            | Element::Edge(EdgeId(i))
            | Element::Face(FaceId(i)) => i,
        });
    }

    /// The columns, to be written while no record comes or goes.
    #[inline(always)]
    pub(crate) fn pen(&mut self) -> Pen<'_> {
        let Columns { origin, next, prev, face, outgoing, boundary } = &mut self.columns;
        let bound = next.len();
        Pen {
            origin: &mut origin[..bound],
            next,
            prev: &mut prev[..bound],
            face: &mut face[..bound],
            outgoing,
            boundary,
        }
    }

    // ---- recorded setters for edits that write little --------------------------------------------------

    recorded_setters! {
        set_origin(h: HalfEdgeId, v: VertexId);
        /// Makes `g` follow `h`: the lab's `makeNext`.
        set_next(h: HalfEdgeId, g: HalfEdgeId);
        set_face(h: HalfEdgeId, f: FaceId);
        set_outgoing(v: VertexId, h: Option<HalfEdgeId>);
        set_half_edge(f: FaceId, h: Option<HalfEdgeId>);
    }

    /// Clears every pointer of both halves of `e`, before it is removed.
    pub(crate) fn clear_edge(&mut self, e: EdgeId, rec: &mut impl Recorder) {
        self.pen().clear(e.half_edges(), rec);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::NoRecorder;

    #[test]
    fn structures_with_the_same_columns_differ_if_the_free_numbers_do() {
        let mut free = Dcel::new();
        let v = free.add_vertex_record(&mut NoRecorder);
        let mut kept = free.clone();
        kept.keep_ids();
        assert_eq!(free, kept);
        free.remove_vertex_record(v, &mut NoRecorder);
        kept.remove_vertex_record(v, &mut NoRecorder);
        assert_eq!(free.columns.outgoing, kept.columns.outgoing);
        assert_ne!(free, kept);
        kept.release_ids();
        assert_eq!(free, kept);
    }
}
