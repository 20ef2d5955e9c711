//! What differs, in one sentence.

use super::super::flat::NONE;
use crate::ids::{Element, FaceId, HalfEdgeId};
use crate::topology::Violation;
use std::fmt;

/// One of the two views that were compared.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Which {
    /// The first argument: what was found.
    First,
    /// The second argument: what was expected.
    Second,
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::First { "first" } else { "second" })
    }
}

/// Why two views are not equal up to numbers. Elements are those of the first view unless said otherwise.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Difference {
    /// One of the views breaks an invariant, so there is nothing to compare.
    #[error("the {which} structure is broken: {violation}")]
    Broken {
        /// Which view.
        which: Which,
        /// Its first violation.
        violation: Box<Violation>,
    },
    /// The numbers of elements differ.
    #[error("{found} {what}, expected {expected}")]
    Count {
        /// What was counted.
        what: &'static str,
        /// The number in the first view.
        found: usize,
        /// The number in the second view.
        expected: usize,
    },
    /// The numbers of vertices with some degree differ.
    #[error("{found} {} of degree {degree}, expected {expected}", plural(*found, "vertex", "vertices"))]
    Degrees {
        /// The lowest degree at which they differ.
        degree: usize,
        /// The number in the first view.
        found: usize,
        /// The number in the second view.
        expected: usize,
    },
    /// The numbers of faces with some number of half-edges differ.
    #[error("{found} {} with {length} half-edges, expected {expected}", plural(*found, "face", "faces"))]
    FaceLengths {
        /// The lowest number of half-edges at which they differ.
        length: usize,
        /// The number in the first view.
        found: usize,
        /// The number in the second view.
        expected: usize,
    },
    /// An element has no partner with the same key, state and fixed number.
    #[error("{}", unpaired(*element, *which, *fixed))]
    Unpaired {
        /// The element.
        element: Element,
        /// The view it is in.
        which: Which,
        /// Whether it was to be its own partner.
        fixed: bool,
    },
    /// A pointer leads to the wrong partner.
    #[error("{pointer} = {found}, {} (expected {expected})", corresponding(*corresponds))]
    Pointer {
        /// The pointer in the first view: `h3.next`.
        pointer: String,
        /// Where it leads.
        found: Element,
        /// The partner of that in the second view, if it has one yet.
        corresponds: Option<Element>,
        /// Where the pointer of the partner leads in the second view.
        expected: Element,
    },
    /// A component, together with what lies in its faces, has no partner.
    #[error("the component of {h} ({half_edges} half-edges) and what lies in its faces has no counterpart")]
    Component {
        /// One half-edge of the component.
        h: HalfEdgeId,
        /// The number of half-edges of the component.
        half_edges: usize,
    },
    /// What lies in a face has no partner.
    #[error("what lies in {face} has no counterpart")]
    Content {
        /// The face.
        face: FaceId,
    },
    /// Faces join components in a circle, which cannot be so in the plane: not compared.
    #[error("{face} joins components in a circle, which cannot be so in the plane: such structures are not compared")]
    Undecided {
        /// A face of the circle.
        face: FaceId,
    },
}

fn plural(count: usize, one: &'static str, many: &'static str) -> &'static str {
    if count == 1 { one } else { many }
}

fn unpaired(element: Element, which: Which, fixed: bool) -> String {
    let kind = match element {
        Element::Vertex(_) => "vertex",
        Element::Face(_) => "face",
        Element::HalfEdge(_) | Element::Edge(_) => "half-edge",
    };
    let (here, other) = match which {
        Which::First => (which, Which::Second),
        Which::Second => (which, Which::First),
    };
    if fixed {
        format!("{element} is to stay what it is, but is not the same {kind} in both structures")
    } else {
        format!("{element} of the {here} structure has no {kind} like it in the {other}: key, position or state differ")
    }
}

fn corresponding(partner: Option<Element>) -> String {
    partner.map_or("which corresponds to nothing there".to_owned(), |partner| format!("which corresponds to {partner}"))
}

/// The view a world number belongs to.
pub(super) fn which(x: u32, split: u32) -> Which {
    debug_assert_ne!(x, NONE);
    if x < split { Which::First } else { Which::Second }
}
