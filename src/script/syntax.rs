//! What a script says, after all its words have been looked up.

use super::edit::EditKind;
use super::ground::Ground;
use crate::ids::Element;
use crate::plane::{Point, Subdivision};

/// A checked script: a start and the statements after it. [`Script::parse`] makes one of the plane,
/// [`Script::parse_kernel`] one without coordinates; [`run`](Script::run) and [`play`](Script::play) carry it out.
#[derive(Clone, PartialEq, Debug)]
pub struct Script<G = Subdivision> {
    pub(super) start: G,
    pub(super) statements: Vec<Statement>,
    /// The names given by `let`, each once.
    pub(super) names: Vec<Name>,
}

impl<G: Ground> Script<G> {
    /// The structure that the script starts from.
    #[must_use]
    pub fn start(&self) -> &G {
        &self.start
    }

    /// The statements after the start.
    #[must_use]
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }
}

/// A line of a script.
#[derive(Clone, PartialEq, Debug)]
pub struct Statement {
    pub(super) line: u32,
    pub(super) text: String,
    pub(super) action: Action,
}

impl Statement {
    /// The number of its line, from 1.
    #[must_use]
    pub fn line(&self) -> u32 {
        self.line
    }

    /// The line as written, without its comment.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// A name given by `let`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) line: u32,
    pub(super) kind: Kind,
}

/// What a statement does.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Action {
    Edit { kind: EditKind, arguments: Vec<Path>, point: Option<Point>, name: Option<usize> },
    Name { path: Path, name: usize },
    WalkFace(Path),
    WalkVertex(Path),
    Highlight(Vec<Path>),
    Caption(String),
    Dump,
}

/// An element by a word and links from it: `h0.next.twin`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Path {
    pub(super) base: Base,
    pub(super) links: Vec<Link>,
    /// As written.
    pub(super) text: String,
}

/// What a path begins with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Base {
    Given(Element),
    /// An index into the names of the script.
    Named(usize),
}

/// The kinds of elements.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Vertex,
    HalfEdge,
    Edge,
    Face,
}

impl Kind {
    pub(super) fn of(element: Element) -> Self {
        match element {
            Element::Vertex(_) => Self::Vertex,
            Element::HalfEdge(_) => Self::HalfEdge,
            Element::Edge(_) => Self::Edge,
            Element::Face(_) => Self::Face,
        }
    }

    pub(super) fn a(self) -> &'static str {
        match self {
            Self::Vertex => "a vertex",
            Self::HalfEdge => "a half-edge",
            Self::Edge => "an edge",
            Self::Face => "a face",
        }
    }
}

/// A step from one element to another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Link {
    /// The half-edge after a half-edge.
    Next,
    /// The half-edge before a half-edge.
    Prev,
    /// The other half of the edge.
    Twin,
    /// The vertex a half-edge starts at.
    Origin,
    /// The vertex a half-edge ends at.
    Destination,
    /// The face on the left of a half-edge.
    Face,
    /// The edge of a half-edge.
    Edge,
    /// The stored half-edge of a vertex.
    Outgoing,
    /// The stored half-edge of a face.
    Boundary,
}

impl Link {
    /// All links.
    pub const ALL: [Self; 9] = [
        Self::Next,
        Self::Prev,
        Self::Twin,
        Self::Origin,
        Self::Destination,
        Self::Face,
        Self::Edge,
        Self::Outgoing,
        Self::Boundary,
    ];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Next => "next",
            Self::Prev => "prev",
            Self::Twin => "twin",
            Self::Origin => "origin",
            Self::Destination => "destination",
            Self::Face => "face",
            Self::Edge => "edge",
            Self::Outgoing => "outgoing",
            Self::Boundary => "boundary",
        }
    }

    pub(super) fn from(self) -> Kind {
        match self {
            Self::Outgoing => Kind::Vertex,
            Self::Boundary => Kind::Face,
            _ => Kind::HalfEdge,
        }
    }

    pub(super) fn to(self) -> Kind {
        match self {
            Self::Origin | Self::Destination => Kind::Vertex,
            Self::Face => Kind::Face,
            Self::Edge => Kind::Edge,
            _ => Kind::HalfEdge,
        }
    }
}
