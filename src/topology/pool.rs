//! Coming and going of records: free lists, undo, compaction.
//!
//! ```text
//!   free.edge ──> e4 ──> e1 ──> e7 ──> end      the link to the next free slot stands in the dead record
//!                                               itself, in both halves of an edge, so that h ^ 1 survives
//! ```
//!
//! An edit allocates before it frees, so a slot is never taken again by the edit that freed it.
//!
//! An owner can keep all ids of a moment (`keep_ids`): what is removed of these is in no list, and its slot is empty
//! until the owner offers that very id to the next edit.

use super::Dcel;
#[cfg(any(feature = "navmesh", test))]
use super::links::FreeLists;
use super::links::{Columns, FREE_END, NONE, TAG};
use super::record::{Change, Journal, Recorder};
use crate::ids::{EdgeId, EdgeMap, Element, FaceId, FaceMap, HalfEdgeId, MAX_IDS, VertexId, VertexMap, must_be_below};

/// An id that names no element of this structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum IdError {
    /// The element was removed and its slot has not been used again.
    #[error("{0} was removed earlier; ask the structure for a live element")]
    Removed(Element),
    /// No element ever had so high a number.
    #[error("{}", element.missing(*count, *bound))]
    OutOfRange {
        /// The id that was given.
        element: Element,
        /// How many elements of this kind there are.
        count: usize,
        /// One more than the highest number in use.
        bound: usize,
    },
}

/// The structure cannot have more elements of this kind: ids must stay below 2^31 - 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the structure is full: at most {MAX_IDS} elements of one kind")]
pub struct TooMany;

impl TooMany {
    /// Whether so many elements can have ids.
    #[inline]
    pub(crate) fn check(vertices: usize, edges: usize, faces: usize) -> Result<(), Self> {
        let fits = vertices <= MAX_IDS && edges <= MAX_IDS / 2 && faces <= MAX_IDS;
        if fits { Ok(()) } else { Err(Self) }
    }
}

/// Where every element went when a structure was compacted; `None` for removed ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renumbering {
    /// Old vertex to new vertex.
    pub vertices: VertexMap<Option<VertexId>>,
    /// Old edge to new edge.
    pub edges: EdgeMap<Option<EdgeId>>,
    /// Old face to new face.
    pub faces: FaceMap<Option<FaceId>>,
}

impl Renumbering {
    /// Where a half-edge went: the same half of its edge's new number.
    #[must_use]
    #[track_caller]
    pub fn half_edge(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        must_be_below(h, h.index(), 2 * self.edges.len());
        self.edges[h.edge()].map(|e| e.half_edges()[(h.number() & 1) as usize])
    }
}

impl Dcel {
    /// The number of live vertices. O(1), as the other counts.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_bound() - self.free.vertices as usize
    }

    /// The number of live edges.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.edge_bound() - self.free.edges as usize
    }

    /// The number of live half-edges, twice the number of edges.
    #[must_use]
    pub fn half_edge_count(&self) -> usize {
        2 * self.edge_count()
    }

    /// The number of live faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.face_bound() - self.free.faces as usize
    }

    /// Fails unless the element exists.
    #[inline]
    pub fn check(&self, element: impl Into<Element>) -> Result<(), IdError> {
        let element = element.into();
        let (live, index, count, bound) = match element {
            Element::Vertex(v) => (self.has_vertex(v), v.index(), self.vertex_count(), self.vertex_bound()),
            Element::HalfEdge(h) => (self.has_half_edge(h), h.index(), self.half_edge_count(), self.half_edge_bound()),
            Element::Edge(e) => (self.has_edge(e), e.index(), self.edge_count(), self.edge_bound()),
            Element::Face(f) => (self.has_face(f), f.index(), self.face_count(), self.face_bound()),
        };
        if live {
            Ok(())
        } else if index < bound {
            Err(IdError::Removed(element))
        } else {
            Err(IdError::OutOfRange { element, count, bound })
        }
    }

    /// What is wrong with a half-edge whose pointer leads nowhere.
    #[cold]
    pub(super) fn not_linked(&self, h: HalfEdgeId, pointer: &str) -> String {
        match Self::has_record(self, h.into()) {
            true => format!("{h}.{pointer} is not set yet"),
            false => format!("{}", IdError::Removed(h.into())),
        }
    }

    /// In debug builds, ends with a message that names the element if it was removed and its slot is free.
    #[inline]
    #[track_caller]
    pub(crate) fn debug_assert_not_removed(&self, element: impl Into<Element>) {
        if cfg!(debug_assertions) {
            let element = element.into();
            if let Err(error @ IdError::Removed(_)) = self.check(element) {
                assert!(self.has_record(element), "{error}");
            }
        }
    }

    /// Whether so many more elements fit. Edits ask before they write.
    #[inline]
    pub(crate) fn room_for(&self, vertices: usize, edges: usize, faces: usize) -> Result<(), TooMany> {
        TooMany::check(self.vertex_count() + vertices, self.edge_count() + edges, self.face_count() + faces)
    }

    #[inline(always)]
    pub(crate) fn add_vertex_record(&mut self, rec: &mut impl Recorder) -> VertexId {
        let reused = self.free.vertex != FREE_END;
        let v = if reused {
            let v = VertexId(self.free.vertex);
            self.free.vertex = std::mem::replace(self.vertex_word(v), NONE) & !TAG;
            self.free.vertices -= 1;
            v
        } else {
            self.push_vertex()
        };
        rec.record(Change::Added { element: v.into(), reused });
        v
    }

    #[inline(always)]
    pub(crate) fn add_edge_record(&mut self, rec: &mut impl Recorder) -> EdgeId {
        let reused = self.free.edge != FREE_END;
        let e = if reused {
            let e = EdgeId(self.free.edge);
            let words = self.edge_words(e);
            let link = words[0] & !TAG;
            words.fill(NONE);
            self.free.edge = link;
            self.free.edges -= 1;
            e
        } else {
            self.push_edge()
        };
        rec.record(Change::Added { element: e.into(), reused });
        e
    }

    #[inline(always)]
    pub(crate) fn add_face_record(&mut self, rec: &mut impl Recorder) -> FaceId {
        let reused = self.free.face != FREE_END;
        let f = if reused {
            let f = FaceId(self.free.face);
            self.free.face = std::mem::replace(self.face_word(f), NONE) & !TAG;
            self.free.faces -= 1;
            f
        } else {
            self.push_face()
        };
        rec.record(Change::Added { element: f.into(), reused });
        f
    }

    /// Removes a vertex; clears its `outgoing` first.
    pub(crate) fn remove_vertex_record(&mut self, v: VertexId, rec: &mut impl Recorder) {
        self.set_outgoing(v, None, rec);
        self.free_vertex(v);
        rec.record(Change::Removed { element: v.into() });
    }

    /// Removes an edge; clears the pointers of both halves first.
    pub(crate) fn remove_edge_record(&mut self, e: EdgeId, rec: &mut impl Recorder) {
        self.clear_edge(e, rec);
        self.free_edge(e);
        rec.record(Change::Removed { element: e.into() });
    }

    /// Removes a face; clears its `half_edge` first.
    pub(crate) fn remove_face_record(&mut self, f: FaceId, rec: &mut impl Recorder) {
        self.set_half_edge(f, None, rec);
        self.free_face(f);
        rec.record(Change::Removed { element: f.into() });
    }

    /// From now on no edit uses the number of an element that is removed, if it is below the present bounds, unless it
    /// is offered by [`offer_edge`](Self::offer_edge) or [`offer_face`](Self::offer_face). O(1).
    #[cfg(any(feature = "navmesh", test))]
    pub(crate) fn keep_ids(&mut self) {
        let [vertices, edges, faces] = [self.vertex_bound(), self.edge_bound(), self.face_bound()];
        self.free.kept = [vertices, edges, faces].map(|bound| bound as u32);
        (self.free.vertex, self.free.edge, self.free.face) = (FREE_END, FREE_END, FREE_END);
    }

    /// Takes back [`keep_ids`](Self::keep_ids): every number that is free can be used by any edit. O(n).
    #[cfg(any(feature = "navmesh", test))]
    pub(crate) fn release_ids(&mut self) {
        self.free = FreeLists::EMPTY;
        let [vertices, edges, faces] =
            [self.vertex_bound(), self.edge_bound(), self.face_bound()].map(|bound| (0..bound as u32).rev());
        let edges_and_faces = edges.map(|e| EdgeId(e).into()).chain(faces.map(|f| FaceId(f).into()));
        let all = vertices.map(|v| VertexId(v).into()).chain(edges_and_faces);
        for element in all {
            if !self.has_record(element) {
                self.undo_added(element, true);
            }
        }
    }

    /// The next edge that is made gets this number, which is kept and of no edge now.
    #[cfg(any(feature = "navmesh", test))]
    pub(crate) fn offer_edge(&mut self, e: EdgeId) {
        debug_assert!(e.0 < self.free.kept[1] && !self.has_edge(e), "{e} is no kept number, or in use");
        let link = TAG | self.free.edge;
        self.edge_words(e).fill(link);
        self.free.edge = e.0;
    }

    /// The next face that is made gets this number, which is kept and of no face now.
    #[cfg(any(feature = "navmesh", test))]
    pub(crate) fn offer_face(&mut self, f: FaceId) {
        debug_assert!(f.0 < self.free.kept[2] && !self.has_face(f), "{f} is no kept number, or in use");
        *self.face_word(f) = TAG | self.free.face;
        self.free.face = f.0;
    }

    fn free_vertex(&mut self, v: VertexId) {
        *self.vertex_word(v) = TAG | self.free.vertex;
        if v.0 >= self.free.kept[0] {
            self.free.vertex = v.0;
        }
        self.free.vertices += 1;
    }

    fn free_edge(&mut self, e: EdgeId) {
        let link = TAG | self.free.edge;
        self.edge_words(e).fill(link);
        if e.0 >= self.free.kept[1] {
            self.free.edge = e.0;
        }
        self.free.edges += 1;
    }

    fn free_face(&mut self, f: FaceId) {
        *self.face_word(f) = TAG | self.free.face;
        if f.0 >= self.free.kept[2] {
            self.free.face = f.0;
        }
        self.free.faces += 1;
    }

    /// Takes back the changes of `journal` from its end until `mark` are left. Afterwards the structure is
    /// bit for bit what it was, free slots included, provided that all edits since then were recorded in it.
    ///
    /// Cost: O(changes taken back).
    pub fn undo(&mut self, journal: &mut Journal, mark: usize) {
        while journal.len() > mark {
            match journal.pop() {
                Some(Change::Write { slot, old, .. }) => self.put(slot, old),
                Some(Change::Added { element, reused }) => self.undo_added(element, reused),
                Some(Change::Removed { element }) => self.undo_removed(element),
                None => break,
            }
        }
        journal.drop_empty_steps();
    }

    fn undo_added(&mut self, element: Element, reused: bool) {
        match (element, reused) {
            (Element::Vertex(v), true) => self.free_vertex(v),
            (Element::Edge(e), true) => self.free_edge(e),
            (Element::Face(f), true) => self.free_face(f),
            (Element::Vertex(_), false) => self.pop_vertex(),
            (Element::Edge(_), false) => self.pop_edge(),
            (Element::Face(_), false) => self.pop_face(),
            (Element::HalfEdge(_), _) => {}
        }
    }

    fn undo_removed(&mut self, element: Element) {
        let [vertices, edges, faces] = self.free.kept;
        match element {
            Element::Vertex(v) if v.0 < vertices => {
                *self.vertex_word(v) = NONE;
                self.free.vertices -= 1;
            }
            Element::Edge(e) if e.0 < edges => {
                self.edge_words(e).fill(NONE);
                self.free.edges -= 1;
            }
            Element::Face(f) if f.0 < faces => {
                *self.face_word(f) = NONE;
                self.free.faces -= 1;
            }
            Element::Vertex(_) => drop(self.add_vertex_record(&mut super::NoRecorder)),
            Element::Edge(_) => drop(self.add_edge_record(&mut super::NoRecorder)),
            Element::Face(_) => drop(self.add_face_record(&mut super::NoRecorder)),
            Element::HalfEdge(_) => {}
        }
    }

    /// Drops the dead records and renumbers the rest along a walk, so that neighbours stand close together
    /// in memory (worth a factor of ten and more in walks over a shuffled structure).
    ///
    /// Faces are visited breadth first from `f0`, each one's half-edges along `next`; an edge, a vertex and a
    /// face get their numbers when they are first met. `f0` stays `f0`; each half-edge keeps its parity.
    /// Elements that no face reaches (isolated vertices, faces without boundary) follow in their old order.
    ///
    /// Cost: O(V + E + F) time and as much memory again.
    #[must_use = "every id held outside must be translated by the renumbering"]
    pub fn compact(&mut self) -> Renumbering {
        self.compact_from(&[])
    }

    /// [`compact`](Self::compact), starting from given half-edges (after `f0`): for owners of inner components.
    pub(crate) fn compact_from(&mut self, seeds: &[HalfEdgeId]) -> Renumbering {
        let mut order = Order::new(self);
        for f in 0..self.face_bound() {
            let f = FaceId(f as u32);
            if self.has_face(f) {
                order.face(f);
                if let Some(h) = self.half_edge(f) {
                    order.walk_from(self, h);
                }
            }
            if f.0 == 0 {
                seeds.iter().for_each(|&h| order.walk_from(self, h));
            }
        }
        for h in (0..self.half_edge_bound()).map(|i| HalfEdgeId(i as u32)) {
            if self.has_half_edge(h) {
                order.walk_from(self, h);
            }
        }
        for v in (0..self.vertex_bound()).map(|i| VertexId(i as u32)) {
            if self.has_vertex(v) {
                order.vertex(v);
            }
        }
        let Order { map, vertices, edges, faces, .. } = order;
        let new_half = |h: HalfEdgeId| map.half_edge(h).map_or(NONE, |h| h.0);
        let mut columns = Columns {
            origin: Vec::with_capacity(2 * edges.len()),
            next: Vec::with_capacity(2 * edges.len()),
            prev: Vec::with_capacity(2 * edges.len()),
            face: Vec::with_capacity(2 * edges.len()),
            outgoing: vertices.iter().map(|&v| self.outgoing(v).map_or(NONE, new_half)).collect(),
            boundary: faces.iter().map(|&f| self.half_edge(f).map_or(NONE, new_half)).collect(),
        };
        for h in edges.iter().flat_map(|e| e.half_edges()) {
            columns.origin.push(map.vertices[self.origin(h)].map_or(NONE, |v| v.0));
            columns.next.push(new_half(self.next(h)));
            columns.prev.push(new_half(self.prev(h)));
            columns.face.push(map.faces[self.face(h)].map_or(NONE, |f| f.0));
        }
        *self = Self::from_columns(columns);
        map
    }
}

/// The new order while it is being found.
struct Order {
    map: Renumbering,
    vertices: Vec<VertexId>,
    edges: Vec<EdgeId>,
    faces: Vec<FaceId>,
    seen: Vec<bool>,
    queue: std::collections::VecDeque<HalfEdgeId>,
}

impl Order {
    fn new(dcel: &Dcel) -> Self {
        Self {
            map: Renumbering {
                vertices: VertexMap::filled(dcel.vertex_bound(), None),
                edges: EdgeMap::filled(dcel.edge_bound(), None),
                faces: FaceMap::filled(dcel.face_bound(), None),
            },
            vertices: Vec::with_capacity(dcel.vertex_count()),
            edges: Vec::with_capacity(dcel.edge_count()),
            faces: Vec::with_capacity(dcel.face_count()),
            seen: vec![false; dcel.half_edge_bound()],
            queue: std::collections::VecDeque::new(),
        }
    }

    fn vertex(&mut self, v: VertexId) {
        if self.map.vertices[v].is_none() {
            self.map.vertices[v] = Some(VertexId(self.vertices.len() as u32));
            self.vertices.push(v);
        }
    }

    fn face(&mut self, f: FaceId) {
        if self.map.faces[f].is_none() {
            self.map.faces[f] = Some(FaceId(self.faces.len() as u32));
            self.faces.push(f);
        }
    }

    /// Numbers the cycle of `start` and, breadth first, all cycles reached over twins.
    fn walk_from(&mut self, dcel: &Dcel, start: HalfEdgeId) {
        self.queue.push_back(start);
        while let Some(first) = self.queue.pop_front() {
            if self.seen[first.index()] {
                continue;
            }
            self.face(dcel.face(first));
            for h in dcel.cycle(first) {
                self.seen[h.index()] = true;
                self.vertex(dcel.origin(h));
                if self.map.edges[h.edge()].is_none() {
                    self.map.edges[h.edge()] = Some(EdgeId(self.edges.len() as u32));
                    self.edges.push(h.edge());
                }
                if !self.seen[h.twin().index()] {
                    self.queue.push_back(h.twin());
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::NoRecorder;

    #[test]
    fn compact_keeps_what_no_boundary_reaches() {
        let mut dcel = Dcel::polygon(3).expect("three corners");
        let (v, f) = (dcel.add_vertex_record(&mut NoRecorder), dcel.add_face_record(&mut NoRecorder));
        let map = dcel.compact();
        assert_eq!((map.vertices[v], map.faces[f]), (Some(VertexId(3)), Some(FaceId(2))));
        assert_eq!((dcel.vertex_count(), dcel.face_count()), (4, 3));
        assert_eq!((dcel.outgoing(VertexId(3)), dcel.half_edge(FaceId(2))), (None, None));
    }

    #[test]
    #[should_panic(expected = "there is no v3: there are 3 vertices")]
    fn the_first_number_beyond_the_vertices_is_not_that_of_a_removed_one() {
        let _ = Dcel::polygon(3).expect("three corners").outgoing(VertexId(3));
    }
}
