//! Edits that are not in the kit: the recorded setters, and a look at all that was touched before it is final.
//!
//! ```text
//!   edit_with ──> your function, with an Editing ──> are the invariants kept at all that was touched?
//!                   add_…  remove_…  set_…                yes: the recorder gets every change
//!                                                         no, or your function refused: everything is taken back
//! ```

use super::Dcel;
use super::pool::{IdError, TooMany};
use super::record::{Change, Journal, Recorder, Slot};
use super::validate::{Violation, violations};
use super::{
    CollapseEdgeError, FlipEdgeError, JoinEdgesError, JoinFacesError, JoinVerticesError, SplitEdgeError,
    SplitFaceError, SplitVertexError,
};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;
use std::ops::Deref;

/// Why an edit that is not in the kit was not made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OwnEditError<E> {
    /// The edit itself refused.
    #[error(transparent)]
    Refused(E),
    /// The edit has written to an element that does not exist. Everything has been taken back.
    #[error("the edit writes to an element that does not exist: {0}")]
    Id(IdError),
    /// The edit left an invariant broken. Everything has been taken back.
    #[error(
        "the edit would break an invariant: {}; see the invariants at dcel_kit::topology::violations",
        violations.first().map_or_else(String::new, ToString::to_string)
    )]
    Broken {
        /// All violations, the first ones first.
        violations: Vec<Violation>,
    },
}

/// A structure while an edit is being made on it: read as a [`Dcel`], written by recorded setters.
///
/// Between two setters the structure may be half-linked; walks must not be trusted until it is whole again.
#[derive(Debug)]
pub struct Editing<'a> {
    dcel: &'a mut Dcel,
    journal: Journal,
    /// The first write to an element that does not exist; it was not made.
    astray: Option<IdError>,
}

impl Deref for Editing<'_> {
    type Target = Dcel;

    fn deref(&self) -> &Dcel {
        self.dcel
    }
}

/// Edits of the kit as parts of a larger one.
macro_rules! kit_edits {
    ($($edit:ident / $with:ident ( $($argument:ident: $type:ty),* ) -> Result<$value:ty, $error:ty>;)*) => {
        $(
            #[doc = concat!("[`Dcel::", stringify!($edit), "`], recorded with the rest.")]
            ///
            /// # Errors
            /// Those of the edit; then it has changed nothing.
            pub fn $edit(&mut self, $($argument: $type),*) -> Result<$value, $error> {
                self.dcel.$with($($argument,)* &mut self.journal)
            }
        )*
    };
}

impl Editing<'_> {
    /// The changes that follow belong to this step, for films.
    pub fn step(&mut self, number: u32, what: &'static str) {
        self.journal.step(number, what);
    }

    /// A new vertex. Its `outgoing` is not set.
    ///
    /// # Errors
    /// [`TooMany`] if the structure is full.
    pub fn add_vertex(&mut self) -> Result<VertexId, TooMany> {
        self.dcel.room_for(1, 0, 0)?;
        Ok(self.dcel.add_vertex_record(&mut self.journal))
    }

    /// A new edge, by its two halves. None of their pointers but `twin` is set.
    ///
    /// # Errors
    /// [`TooMany`] if the structure is full.
    pub fn add_edge(&mut self) -> Result<[HalfEdgeId; 2], TooMany> {
        self.dcel.room_for(0, 1, 0)?;
        Ok(self.dcel.add_edge_record(&mut self.journal).half_edges())
    }

    /// A new face. Its `half_edge` is not set.
    ///
    /// # Errors
    /// [`TooMany`] if the structure is full.
    pub fn add_face(&mut self) -> Result<FaceId, TooMany> {
        self.dcel.room_for(0, 0, 1)?;
        Ok(self.dcel.add_face_record(&mut self.journal))
    }

    /// Removes a vertex.
    ///
    /// # Errors
    /// [`IdError`] if there is no such vertex.
    pub fn remove_vertex(&mut self, v: VertexId) -> Result<(), IdError> {
        self.dcel.check(v)?;
        self.dcel.remove_vertex_record(v, &mut self.journal);
        Ok(())
    }

    /// Removes an edge, both halves of it.
    ///
    /// # Errors
    /// [`IdError`] if there is no such edge.
    pub fn remove_edge(&mut self, e: EdgeId) -> Result<(), IdError> {
        self.dcel.check(e)?;
        self.dcel.remove_edge_record(e, &mut self.journal);
        Ok(())
    }

    /// Removes a face.
    ///
    /// # Errors
    /// [`IdError`] if there is no such face.
    pub fn remove_face(&mut self, f: FaceId) -> Result<(), IdError> {
        self.dcel.check(f)?;
        self.dcel.remove_face_record(f, &mut self.journal);
        Ok(())
    }

    /// Whether the element can be written to; if not, the whole edit will fail.
    fn may_write(&mut self, element: impl Into<Element>) -> bool {
        let element = element.into();
        if self.dcel.has_record(element) {
            return true;
        }
        self.astray = self.astray.or(self.dcel.check(element).err());
        false
    }

    /// Lets `h` start at `v`. As with all setters: if the element that is written to does not exist, nothing is
    /// written, and the whole edit fails with [`OwnEditError::Id`].
    pub fn set_origin(&mut self, h: HalfEdgeId, v: VertexId) {
        if self.may_write(h) {
            self.dcel.set_origin(h, v, &mut self.journal);
        }
    }

    /// Lets `g` follow `h`: sets the `next` of `h` and the `prev` of `g`.
    pub fn set_next(&mut self, h: HalfEdgeId, g: HalfEdgeId) {
        if self.may_write(h) && self.may_write(g) {
            self.dcel.set_next(h, g, &mut self.journal);
        }
    }

    /// Lets `f` lie on the left of `h`.
    pub fn set_face(&mut self, h: HalfEdgeId, f: FaceId) {
        if self.may_write(h) {
            self.dcel.set_face(h, f, &mut self.journal);
        }
    }

    /// Sets the stored half-edge of a vertex, or none.
    pub fn set_outgoing(&mut self, v: VertexId, h: Option<HalfEdgeId>) {
        if self.may_write(v) {
            self.dcel.set_outgoing(v, h, &mut self.journal);
        }
    }

    /// Sets the stored half-edge of a face, or none.
    pub fn set_half_edge(&mut self, f: FaceId, h: Option<HalfEdgeId>) {
        if self.may_write(f) {
            self.dcel.set_half_edge(f, h, &mut self.journal);
        }
    }

    kit_edits! {
        split_face / split_face_with(h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError>;
        split_edge / split_edge_with(h: HalfEdgeId) -> Result<(VertexId, HalfEdgeId), SplitEdgeError>;
        split_vertex / split_vertex_with(first: HalfEdgeId, last: HalfEdgeId)
            -> Result<(HalfEdgeId, VertexId), SplitVertexError>;
        join_faces / join_faces_with(h: HalfEdgeId) -> Result<FaceId, JoinFacesError>;
        join_edges / join_edges_with(h: HalfEdgeId) -> Result<VertexId, JoinEdgesError>;
        join_vertices / join_vertices_with(h: HalfEdgeId) -> Result<VertexId, JoinVerticesError>;
        collapse_edge / collapse_edge_with(h: HalfEdgeId) -> Result<VertexId, CollapseEdgeError>;
        flip_edge / flip_edge_with(h: HalfEdgeId) -> Result<(), FlipEdgeError>;
    }
}

impl Dcel {
    /// Makes an edit that is not in the kit, whole or not at all. `edit` writes by the setters of [`Editing`]; when it
    /// is done, the invariants are checked at all it has touched, and `rec` gets every change.
    ///
    /// Cost: that of the edit, and O(sizes of the cycles and rounds that it has touched) for the check.
    ///
    /// # Errors
    /// [`OwnEditError`]; then everything is bit for bit as it was, and `rec` has heard of nothing.
    ///
    /// ```
    /// use dcel_kit::{HalfEdgeId, VertexId};
    /// use dcel_kit::topology::{Dcel, NoRecorder, OwnEditError};
    /// let mut square = Dcel::polygon(4)?;
    /// let before = square.clone();
    /// let refused = square.edit_with(&mut NoRecorder, |e| {
    ///     e.set_origin(HalfEdgeId::new(0), VertexId::new(2)); // and nothing else
    ///     Ok::<_, std::convert::Infallible>(())
    /// });
    /// assert!(matches!(refused, Err(OwnEditError::Broken { .. })));
    /// assert_eq!(square, before);
    /// # Ok::<(), dcel_kit::topology::PolygonError>(())
    /// ```
    pub fn edit_with<T, E>(
        &mut self,
        rec: &mut impl Recorder,
        edit: impl FnOnce(&mut Editing<'_>) -> Result<T, E>,
    ) -> Result<T, OwnEditError<E>> {
        let mut editing = Editing { dcel: self, journal: Journal::new(), astray: None };
        let result = edit(&mut editing);
        let (mut journal, astray) = (editing.journal, editing.astray);
        let refusal = match (result, astray) {
            (Ok(_), Some(error)) => OwnEditError::Id(error),
            (Ok(value), None) if self.is_sound_at(journal.changes()) => {
                journal.replay(rec, |_, _| {});
                return Ok(value);
            }
            (Ok(_), None) => OwnEditError::Broken { violations: violations(self) },
            (Err(error), _) => OwnEditError::Refused(error),
        };
        self.undo(&mut journal, 0);
        Err(refusal)
    }

    /// Whether all invariants hold at the elements that the changes speak of, if they held everywhere before.
    fn is_sound_at(&self, changes: &[Change]) -> bool {
        let mut touched: BTreeSet<Element> = BTreeSet::new();
        for change in changes {
            match *change {
                Change::Write { slot, old, new } => {
                    touched.extend([old, new].into_iter().flatten());
                    touched.insert(slot.owner());
                }
                Change::Added { element: Element::Edge(e), .. } => {
                    touched.extend(e.half_edges().map(Element::from));
                }
                Change::Added { element, .. } | Change::Removed { element } => drop(touched.insert(element)),
            }
        }
        // All links first, so that walks cannot get lost.
        let live = |&element: &Element| self.check(element).is_ok();
        let mut rounds: BTreeSet<VertexId> = BTreeSet::new();
        let mut cycles: BTreeSet<HalfEdgeId> = BTreeSet::new();
        let mut faces: BTreeSet<FaceId> = BTreeSet::new();
        for element in touched.into_iter().filter(live) {
            match element {
                Element::HalfEdge(h) => {
                    if ![h, h.twin()].into_iter().all(|h| self.has_sound_links(h)) {
                        return false;
                    }
                    rounds.extend([self.raw_origin(h), self.raw_origin(h.twin())].into_iter().flatten());
                    cycles.extend([h, h.twin()]);
                }
                Element::Vertex(v) => drop(rounds.insert(v)),
                Element::Face(f) => drop(faces.insert(f)),
                Element::Edge(_) => {}
            }
        }
        self.rounds_are_sound(&rounds, &cycles) && self.cycles_are_sound(cycles, faces)
    }

    /// The links of one half-edge lead to live elements, there and back.
    fn has_sound_links(&self, h: HalfEdgeId) -> bool {
        let [next, prev] = [Slot::Next(h), Slot::Prev(h)]
            .map(|slot| self.raw(slot).and_then(HalfEdgeId::from_element).filter(|&g| self.has_half_edge(g)));
        let (Some(next), Some(prev)) = (next, prev) else { return false };
        let face = self.raw(Slot::Face(h));
        self.raw(Slot::Prev(next)) == Some(h.into())
            && self.raw(Slot::Next(prev)) == Some(h.into())
            && self.raw_origin(h).is_some_and(|v| self.has_vertex(v))
            && self.raw_origin(next) == self.raw_origin(h.twin())
            && face.is_some_and(|face| self.check(face).is_ok())
            && self.raw(Slot::Face(next)) == face
    }

    fn raw_origin(&self, h: HalfEdgeId) -> Option<VertexId> {
        self.raw(Slot::Origin(h)).and_then(VertexId::from_element)
    }

    /// Each vertex has one round, with all touched half-edges that start there.
    fn rounds_are_sound(&self, vertices: &BTreeSet<VertexId>, touched: &BTreeSet<HalfEdgeId>) -> bool {
        let mut met: BTreeSet<HalfEdgeId> = BTreeSet::new();
        for &v in vertices {
            let Some(first) = self.outgoing(v) else { continue };
            let mut h = first;
            loop {
                if !self.has_half_edge(h) || !self.has_sound_links(h) || self.raw_origin(h) != Some(v) || !met.insert(h)
                {
                    return false;
                }
                h = self.prev(h).twin();
                if h == first {
                    break;
                }
            }
        }
        touched.iter().all(|h| met.contains(h))
    }

    /// Each touched cycle belongs to one face, which stores a half-edge of it; each touched face stores one.
    fn cycles_are_sound(&self, touched: BTreeSet<HalfEdgeId>, mut faces: BTreeSet<FaceId>) -> bool {
        let mut met: BTreeSet<HalfEdgeId> = BTreeSet::new();
        let mut seen: BTreeSet<FaceId> = BTreeSet::new();
        let stored: Option<Vec<HalfEdgeId>> = faces.iter().map(|&f| self.half_edge(f)).collect();
        let Some(stored) = stored else { return false };
        for first in touched.into_iter().chain(stored) {
            if met.contains(&first) {
                continue;
            }
            if !self.has_half_edge(first) {
                return false;
            }
            let face = self.face(first);
            let (mut h, mut has_stored) = (first, false);
            loop {
                if !self.has_half_edge(h) || !self.has_sound_links(h) || self.face(h) != face || !met.insert(h) {
                    return false;
                }
                has_stored |= self.half_edge(face) == Some(h);
                h = self.next(h);
                if h == first {
                    break;
                }
            }
            if !has_stored || !seen.insert(face) {
                return false;
            }
            faces.remove(&face);
        }
        // A face that was touched and has no cycle left would store a half-edge of another.
        faces.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_of_an_own_edit_is_told_before_its_first_change() {
        let mut heard = Journal::new();
        let answer = Dcel::new().edit_with(&mut heard, |e| {
            for (number, what) in [(1, "One."), (2, "Two.")] {
                e.step(number, what);
                e.add_vertex()?;
            }
            Ok::<_, TooMany>(())
        });
        assert_eq!(answer, Ok(()));
        assert_eq!(heard.steps().iter().map(|step| (step.number, step.start)).collect::<Vec<_>>(), [(1, 0), (2, 1)]);
    }
}
