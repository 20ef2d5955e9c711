//! What a row of the table says.

use super::arguments::Arguments;
use super::kind::{Given, Kind, Parameter};
use super::returned::{EditError, Returned};
use crate::plane::{PlaneJournal, Subdivision};
#[cfg(feature = "solid")]
use crate::solid::{Polyhedron, SurfaceJournal};
use crate::topology::{Dcel, Journal};
use std::fmt;

/// How an edit is made on a structure `S` with a log `L`.
pub type Apply<S, L> = fn(&mut S, &mut Arguments<'_>, &mut L) -> Result<Returned, EditError>;

/// An edit: its word, what it takes and gives, how structures make it.
pub struct Row {
    /// The word for it.
    pub word: &'static str,
    /// What it takes, in order.
    pub takes: &'static [Parameter],
    /// What it gives back, in order.
    pub gives: &'static [Given],
    /// What it does, in one sentence.
    pub help: &'static str,
    pub(super) kernel: Option<Apply<Dcel, Journal>>,
    pub(super) plane: Option<Apply<Subdivision, PlaneJournal>>,
    #[cfg(feature = "solid")]
    pub(super) solid: Option<Apply<Polyhedron, SurfaceJournal>>,
}

impl Row {
    /// A row that no structure can make yet; see [`on_kernel`](Self::on_kernel), [`on_plane`](Self::on_plane) and
    /// `on_solid`.
    #[must_use]
    pub const fn new(
        word: &'static str,
        takes: &'static [Parameter],
        gives: &'static [Given],
        help: &'static str,
    ) -> Self {
        Self {
            word,
            takes,
            gives,
            help,
            kernel: None,
            plane: None,
            #[cfg(feature = "solid")]
            solid: None,
        }
    }

    /// The row, made like this on the kernel.
    #[must_use]
    pub const fn on_kernel(mut self, apply: Apply<Dcel, Journal>) -> Self {
        self.kernel = Some(apply);
        self
    }

    /// The row, made like this in the plane.
    #[must_use]
    pub const fn on_plane(mut self, apply: Apply<Subdivision, PlaneJournal>) -> Self {
        self.plane = Some(apply);
        self
    }

    /// The row, made like this on a surface in space.
    #[cfg(feature = "solid")]
    #[must_use]
    pub const fn on_solid(mut self, apply: Apply<Polyhedron, SurfaceJournal>) -> Self {
        self.solid = Some(apply);
        self
    }

    /// The kind of what a name for its result means: a new half-edge, else a new vertex, else a new face; `None` if the
    /// edit makes nothing new.
    #[must_use]
    pub fn names(&self) -> Option<Kind> {
        let order = [Kind::HalfEdge, Kind::Vertex, Kind::Face, Kind::Edge];
        order.into_iter().find(|&kind| self.gives.contains(&Given::New(kind)))
    }
}

impl PartialEq for Row {
    /// Rows differ if they say something else.
    fn eq(&self, other: &Self) -> bool {
        (self.word, self.takes, self.gives) == (other.word, other.takes, other.gives)
    }
}

impl fmt::Debug for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Row").field("word", &self.word).field("takes", &self.takes).finish_non_exhaustive()
    }
}
