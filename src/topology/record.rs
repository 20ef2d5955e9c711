//! Watching an edit: every word it writes, in order, for undo and for film strips.
//!
//! ```text
//!   split_face(h4, h10)         step 3: insert the new half-edges into the cyclic lists
//!                                 h12.next: none -> h10
//!                                 h10.prev: h8   -> h12
//!                                 ...
//! ```
//!
//! A recorder is a parameter of the edit, not a part of the structure. [`NoRecorder`] costs nothing: its
//! empty methods are compiled away.

use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use std::fmt;

/// One pointer of one record.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Slot {
    /// `h.origin`
    Origin(HalfEdgeId),
    /// `h.next`
    Next(HalfEdgeId),
    /// `h.prev`
    Prev(HalfEdgeId),
    /// `h.face`
    Face(HalfEdgeId),
    /// `v.outgoing`
    Outgoing(VertexId),
    /// `f.half_edge`
    HalfEdge(FaceId),
}

impl fmt::Display for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Origin(h) => write!(f, "{h}.origin"),
            Self::Next(h) => write!(f, "{h}.next"),
            Self::Prev(h) => write!(f, "{h}.prev"),
            Self::Face(h) => write!(f, "{h}.face"),
            Self::Outgoing(v) => write!(f, "{v}.outgoing"),
            Self::HalfEdge(x) => write!(f, "{x}.half_edge"),
        }
    }
}

impl Slot {
    /// The element whose record the pointer is a part of.
    pub(crate) fn owner(self) -> Element {
        match self {
            Self::Origin(h) | Self::Next(h) | Self::Prev(h) | Self::Face(h) => h.into(),
            Self::Outgoing(v) => v.into(),
            Self::HalfEdge(f) => f.into(),
        }
    }
}

/// One change of a structure.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Change {
    /// A pointer got a new target.
    Write {
        /// Which pointer.
        slot: Slot,
        /// What it pointed to, if anything.
        old: Option<Element>,
        /// What it points to now, if anything.
        new: Option<Element>,
    },
    /// A vertex, edge or face came to be. Its pointers follow as writes.
    Added {
        /// The new element; half-edges come in pairs, as an edge.
        element: Element,
        /// Whether it took the slot of a removed one.
        reused: bool,
    },
    /// A vertex, edge or face went. Its pointers were cleared by writes before.
    Removed {
        /// The element that is gone.
        element: Element,
    },
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |target: &Option<Element>| target.map_or_else(|| "none".to_owned(), |t| t.to_string());
        match self {
            Self::Write { slot, old, new } => write!(f, "{slot}: {} -> {}", name(old), name(new)),
            Self::Added { element: Element::Edge(e), .. } => {
                let [a, b] = e.half_edges();
                write!(f, "new {e} = ({a}, {b})")
            }
            Self::Added { element, .. } => write!(f, "new {element}"),
            Self::Removed { element } => write!(f, "removed {element}"),
        }
    }
}

/// Gets every change of an edit while it is being made.
///
/// Recording is monomorphised: an edit with [`NoRecorder`] is the edit without recording.
pub trait Recorder {
    /// The changes that follow belong to this step of the operation, numbered as in the lab's handout.
    fn step(&mut self, number: u32, what: &'static str) {
        let _ = (number, what);
    }

    /// One change, already made.
    fn record(&mut self, change: Change);
}

/// Records nothing, at no cost.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoRecorder;

impl Recorder for NoRecorder {
    #[inline(always)]
    fn record(&mut self, _: Change) {}
}

/// A step of an operation: its number in the handout and what it does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Step {
    /// The number, from 1.
    pub number: u32,
    /// One sentence.
    pub what: &'static str,
    /// How many changes of the journal come before it.
    pub start: usize,
}

/// Keeps all changes, grouped by step; [`Dcel::undo`](super::Dcel::undo) takes them back.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Journal {
    changes: Vec<Change>,
    steps: Vec<Step>,
}

impl Journal {
    /// An empty journal.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// All changes, oldest first.
    #[must_use]
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// The steps, oldest first.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The changes of the step with index `index`.
    #[must_use]
    pub fn changes_of_step(&self, index: usize) -> &[Change] {
        let start = self.steps[index].start;
        let end = self.steps.get(index + 1).map_or(self.changes.len(), |s| s.start);
        &self.changes[start..end]
    }

    /// How many changes there are: a mark to undo back to.
    #[must_use]
    pub fn len(&self) -> usize {
        self.changes.len()
    }

    /// Whether nothing was recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    pub(super) fn pop(&mut self) -> Option<Change> {
        let change = self.changes.pop();
        while self.steps.last().is_some_and(|s| s.start > self.changes.len()) {
            self.steps.pop();
        }
        change
    }

    /// Tells the steps and the changes again, in their order; `before` is called ahead of each change.
    pub(super) fn replay<R: Recorder>(&self, rec: &mut R, mut before: impl FnMut(&mut R, usize)) {
        let mut steps = self.steps.iter().peekable();
        for (i, &change) in self.changes.iter().enumerate() {
            before(rec, i);
            while let Some(step) = steps.next_if(|step| step.start <= i) {
                rec.step(step.number, step.what);
            }
            rec.record(change);
        }
    }

    pub(super) fn drop_empty_steps(&mut self) {
        while self.steps.last().is_some_and(|s| s.start >= self.changes.len()) {
            self.steps.pop();
        }
    }
}

impl Recorder for Journal {
    fn step(&mut self, number: u32, what: &'static str) {
        self.steps.push(Step { number, what, start: self.changes.len() });
    }

    fn record(&mut self, change: Change) {
        self.changes.push(change);
    }
}

impl<R: Recorder> Recorder for &mut R {
    fn step(&mut self, number: u32, what: &'static str) {
        (**self).step(number, what);
    }

    fn record(&mut self, change: Change) {
        (**self).record(change);
    }
}

/// Lets only the changes through, so that the steps of several edits are one.
pub(crate) struct Quiet<'a, R>(pub(crate) &'a mut R);

impl<R: Recorder> Recorder for Quiet<'_, R> {
    fn record(&mut self, change: Change) {
        self.0.record(change);
    }
}
