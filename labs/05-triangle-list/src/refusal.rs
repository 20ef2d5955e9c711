//! Why a list of faces is no subdivision. Each refusal names the place, so that whoever made the list can find it.

// You need not use everything that is given here.
#![allow(dead_code)]

use crate::dcel::VertexId;
use std::fmt;

/// What is wrong with a list. Faces are named by their place in the list, from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// A face names a vertex that does not exist.
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The number that no vertex has.
        vertex: VertexId,
    },
    /// A face has fewer than three corners.
    TooFewCorners {
        /// The face.
        face: usize,
    },
    /// A face comes to a vertex twice.
    VertexTwice {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: VertexId,
    },
    /// Two half-edges run from the same vertex to the same vertex.
    EdgeTwice {
        /// Where both begin.
        from: VertexId,
        /// Where both end.
        to: VertexId,
    },
    /// The border comes to a vertex more than once.
    Pinched {
        /// The vertex.
        vertex: VertexId,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchVertex { face, vertex } => write!(f, "face {face} of the list: there is no vertex {vertex}"),
            Self::TooFewCorners { face } => write!(f, "face {face} of the list has fewer than three corners"),
            Self::VertexTwice { face, vertex } => write!(f, "face {face} of the list has vertex {vertex} twice"),
            Self::EdgeTwice { from, to } => write!(f, "the edge from vertex {from} to vertex {to} comes twice"),
            Self::Pinched { vertex } => write!(f, "the border comes to vertex {vertex} more than once"),
        }
    }
}
