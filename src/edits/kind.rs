//! What rows say about arguments and results: kinds of elements, places, numbers.

use crate::ids::Element;

crate::named! {
    /// The kinds of elements.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Kind {
        /// A vertex.
        Vertex = "a vertex",
        /// A half-edge.
        HalfEdge = "a half-edge",
        /// An edge.
        Edge = "an edge",
        /// A face.
        Face = "a face",
    }

    /// `a half-edge`
    fn a;
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
    /// An affine map: the rows of its matrix, then its shift; six numbers in the plane, twelve in space.
    Map,
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
#[non_exhaustive]
pub enum Given {
    /// New elements of this kind, or those of a new path: `let` may name the first.
    New(Kind),
    /// Elements of this kind that are gone.
    Gone(Kind),
}
