//! What a script says, after all its words have been looked up.

use crate::edits::{Argument, Editable, Kind, Row};
use crate::ids::Element;
use crate::old_words::OldWord;
use crate::plane::Subdivision;
use crate::topology::View;

/// A checked script: a start and the statements after it. [`Script::parse`] makes one of the plane,
/// [`Script::parse_kernel`] one without coordinates; [`run`](Script::run) and [`play`](Script::play) carry it out.
#[derive(Clone, PartialEq, Debug)]
pub struct Script<G = Subdivision> {
    pub(super) start: G,
    pub(super) statements: Vec<Statement>,
    /// The names given by `let`, each once.
    pub(super) names: Vec<Name>,
    /// Old words that were met, each once.
    pub(super) old_words: Vec<&'static OldWord>,
}

impl<G: Editable> Script<G> {
    /// The structure that the script starts from.
    #[must_use]
    pub fn start(&self) -> &G {
        &self.start
    }

    /// Old words in it, each once: for the user.
    #[must_use]
    pub fn old_words(&self) -> &[&'static OldWord] {
        &self.old_words
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
    Edit { row: &'static Row, arguments: Vec<Value>, name: Option<usize> },
    Name { path: Path, name: usize },
    WalkFace(Path),
    WalkVertex(Path),
    Highlight(Vec<Path>),
    Caption(String),
    Dump,
}

/// An argument of an edit, as written.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Value {
    /// An element, which is looked up when the edit is made.
    Element(Path),
    /// Anything else.
    Plain(Argument),
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

crate::named! {
    /// A step from one element to another.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    #[non_exhaustive]
    pub enum Link {
        /// The half-edge after a half-edge.
        Next = "next",
        /// The half-edge before a half-edge.
        Prev = "prev",
        /// The other half of the edge.
        Twin = "twin",
        /// The vertex a half-edge starts at.
        Origin = "origin",
        /// The vertex a half-edge ends at.
        Destination = "destination",
        /// The face on the left of a half-edge.
        Face = "face",
        /// The edge of a half-edge.
        Edge = "edge",
        /// The stored half-edge of a vertex.
        Outgoing = "outgoing",
        /// The stored half-edge of a face.
        HalfEdge = "half_edge",
    }

    /// The word for it.
    fn word;
    /// All links.
    const ALL;
}

impl Link {
    pub(crate) fn from(self) -> Kind {
        match self {
            Self::Outgoing => Kind::Vertex,
            Self::HalfEdge => Kind::Face,
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

/// Where a link leads; `None` if the element has no such link, or it is not set.
pub(crate) fn follow<V: View>(on: &V, element: Element, link: Link) -> Option<Element> {
    Some(match (element, link) {
        (Element::HalfEdge(h), Link::Next) => on.next(h)?.into(),
        (Element::HalfEdge(h), Link::Prev) => on.prev(h)?.into(),
        (Element::HalfEdge(h), Link::Twin) => on.twin(h)?.into(),
        (Element::HalfEdge(h), Link::Origin) => on.origin(h)?.into(),
        (Element::HalfEdge(h), Link::Destination) => on.origin(on.twin(h)?)?.into(),
        (Element::HalfEdge(h), Link::Face) => on.face(h)?.into(),
        (Element::HalfEdge(h), Link::Edge) => h.edge().into(),
        (Element::Vertex(v), Link::Outgoing) => on.outgoing(v)?.into(),
        (Element::Face(f), Link::HalfEdge) => on.half_edge(f)?.into(),
        _ => return None,
    })
}
