//! Why an edge cannot be flipped. Each refusal names the place, so that whoever asked can find it.

// You need not use everything that is given here.
#![allow(dead_code)]

use crate::dcel::{HalfEdgeId, VertexId};
use std::fmt;

/// Why an edge cannot be flipped.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// The edge is on the border: there is a triangle on one side only.
    OnBorder {
        /// That half of the edge which has the outer face on its left.
        half_edge: HalfEdgeId,
    },
    /// The two triangles at the edge make a quadrilateral that is straight, or turns right, at an end of the edge.
    NotConvex {
        /// That end.
        vertex: VertexId,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OnBorder { half_edge } => write!(f, "half-edge {half_edge} is on the outer face"),
            Self::NotConvex { vertex } => write!(f, "the quadrilateral does not turn left at vertex {vertex}"),
        }
    }
}
