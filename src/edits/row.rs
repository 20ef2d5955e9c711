//! What a row of the table says.

use super::call::Arguments;
use super::returned::{EditError, Returned};
use super::structure::Editable;
use crate::ids::Element;
use crate::plane::{PlaneJournal, Subdivision};
#[cfg(feature = "solid")]
use crate::solid::{Polyhedron, SurfaceJournal};
use crate::topology::{Dcel, Journal};
use std::fmt;

/// How an edit is made on a structure `S` with a log `L`.
pub type Apply<S, L> = fn(&mut S, &mut Arguments<'_>, &mut L) -> Result<Returned, EditError>;

/// The kinds of elements.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A vertex.
    Vertex,
    /// A half-edge.
    HalfEdge,
    /// An edge.
    Edge,
    /// A face.
    Face,
}

impl Kind {
    /// The kind of an element.
    #[must_use]
    pub const fn of(element: Element) -> Self {
        match element {
            Element::Vertex(_) => Self::Vertex,
            Element::HalfEdge(_) => Self::HalfEdge,
            Element::Edge(_) => Self::Edge,
            Element::Face(_) => Self::Face,
        }
    }

    /// `a half-edge`
    #[must_use]
    pub const fn a(self) -> &'static str {
        match self {
            Self::Vertex => "a vertex",
            Self::HalfEdge => "a half-edge",
            Self::Edge => "an edge",
            Self::Face => "a face",
        }
    }

    /// `half-edge`
    #[must_use]
    pub fn name(self) -> &'static str {
        self.a().trim_start_matches("an ").trim_start_matches("a ")
    }
}

/// What an edit may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Takes {
    /// An element of this kind.
    Element(Kind),
    /// A place: `X Y` in the plane, `X Y Z` in space, nothing in the kernel.
    Place,
    /// A number.
    Number,
    /// `yes` or `no`.
    Switch,
    /// Vertices up to the end of the line, at least one.
    Vertices,
}

/// An argument of an edit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parameter {
    /// Its name in small letters; in help it stands in capital ones.
    pub name: &'static str,
    /// What it may be.
    pub takes: Takes,
}

/// Something that an edit gives back.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Given {
    /// New elements of this kind, or those of a new path: `let` may name the first.
    New(Kind),
    /// Elements of this kind that are gone.
    Gone(Kind),
}

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

    /// How it is written for this structure: `split_edge A X Y`.
    #[must_use]
    pub fn usage<S: Editable>(&self) -> String {
        let mut out = self.word.to_owned();
        for Parameter { name, takes } in self.takes {
            let name = name.to_uppercase();
            match takes {
                Takes::Element(_) | Takes::Number => out.push_str(&format!(" {name}")),
                // A place beside others is told apart by its name.
                Takes::Place => ["X", "Y", "Z"][..S::DIMENSION].iter().for_each(|axis| match name.as_str() {
                    "AT" => out.push_str(&format!(" {axis}")),
                    _ => out.push_str(&format!(" {name}{axis}")),
                }),
                Takes::Switch => out.push_str(" yes|no"),
                Takes::Vertices => out.push_str(&format!(" {name} {name} ...")),
            }
        }
        out
    }
}

impl PartialEq for Row {
    /// Rows are told apart by what they say.
    fn eq(&self, other: &Self) -> bool {
        (self.word, self.takes, self.gives) == (other.word, other.takes, other.gives)
    }
}

impl fmt::Debug for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Row").field("word", &self.word).field("takes", &self.takes).finish_non_exhaustive()
    }
}
