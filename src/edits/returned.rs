//! What an edit gives back, or why it was refused.

use super::kind::Kind;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::{InsertedEdge, InsertedSegment};
use std::error::Error;
use std::fmt;
use std::sync::Arc;

/// What an edit gave back.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Returned {
    elements: Vec<Element>,
    named: Option<Element>,
}

impl Returned {
    /// From the value of the method.
    #[must_use]
    pub fn of(value: impl Returns) -> Self {
        let mut elements = Vec::new();
        value.put(&mut elements);
        Self { elements, named: None }
    }

    /// With what a name for it means: its first element of this kind.
    pub(super) fn named_by(mut self, kind: Option<Kind>) -> Self {
        let of_kind = |kind| self.elements.iter().copied().find(|&element| Kind::of(element) == kind);
        self.named = kind.and_then(of_kind);
        self
    }

    /// What `let` names: the new half-edge, vertex or face.
    #[must_use]
    pub fn named(&self) -> Option<Element> {
        self.named
    }

    /// The new half-edge, if there is one.
    #[must_use]
    pub fn half_edge(&self) -> Option<HalfEdgeId> {
        self.named.and_then(HalfEdgeId::from_element)
    }

    /// All that was returned, in order.
    #[must_use]
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }
}

impl fmt::Display for Returned {
    /// `h12, f2`, or `nothing`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.elements.is_empty() {
            return f.write_str("nothing");
        }
        let names: Vec<String> = self.elements.iter().map(ToString::to_string).collect();
        f.write_str(&names.join(", "))
    }
}

/// A value that an edit may return: elements, tuples and lists of them, or nothing.
pub trait Returns {
    /// Appends its elements.
    fn put(self, elements: &mut Vec<Element>);
}

macro_rules! returns_element {
    ($($id:ty),*) => {
        $(impl Returns for $id {
            fn put(self, elements: &mut Vec<Element>) {
                elements.push(self.into());
            }
        })*
    };
}

returns_element!(VertexId, HalfEdgeId, EdgeId, FaceId);

impl Returns for () {
    fn put(self, _: &mut Vec<Element>) {}
}

impl Returns for bool {
    fn put(self, _: &mut Vec<Element>) {}
}

impl<A: Returns, B: Returns> Returns for (A, B) {
    fn put(self, elements: &mut Vec<Element>) {
        self.0.put(elements);
        self.1.put(elements);
    }
}

impl<A: Returns> Returns for Option<A> {
    fn put(self, elements: &mut Vec<Element>) {
        self.into_iter().for_each(|value| value.put(elements));
    }
}

impl<A: Returns> Returns for Vec<A> {
    fn put(self, elements: &mut Vec<Element>) {
        self.into_iter().for_each(|value| value.put(elements));
    }
}

impl Returns for InsertedEdge {
    fn put(self, elements: &mut Vec<Element>) {
        (self.half_edge, self.new_face).put(elements);
    }
}

impl Returns for InsertedSegment {
    fn put(self, elements: &mut Vec<Element>) {
        (self.half_edges, self.crossings).put(elements);
    }
}

/// Why an edit was refused: the error of its method, which can be asked for by its type.
///
/// ```
/// use dcel_kit::edits::Call;
/// use dcel_kit::plane::{PlaneJournal, SplitFaceError, Subdivision};
/// let call: Call<Subdivision> = "split_face h0 h2".parse()?;
/// let error = call.apply(&mut Subdivision::lab_rectangle(), &mut PlaneJournal::new()).unwrap_err();
/// assert!(matches!(error.downcast_ref(), Some(SplitFaceError::Topology(_))));
/// # Ok::<(), dcel_kit::edits::CallError>(())
/// ```
#[derive(Clone, Debug, thiserror::Error)]
#[error(transparent)]
pub struct EditError(Arc<dyn Error + Send + Sync>);

impl EditError {
    /// The refusal for this reason.
    #[must_use]
    pub fn new(error: impl Error + Send + Sync + 'static) -> Self {
        Self(Arc::new(error))
    }

    /// The error of the method, if it is of this type.
    #[must_use]
    pub fn downcast_ref<E: Error + 'static>(&self) -> Option<&E> {
        self.0.downcast_ref()
    }
}

impl PartialEq for EditError {
    /// Refusals are the same if they say the same.
    fn eq(&self, other: &Self) -> bool {
        self.to_string() == other.to_string()
    }
}
