//! Why a list of faces is no subdivision of the plane.

use crate::ids::VertexId;
use crate::plane::{CoordinateError, GeometryViolation};
use crate::topology::BuildError;

/// What the converter refuses. Faces and vertices are numbered from 0 in the order of the input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConvertError {
    /// The list is no half-edge structure, whatever the positions.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A vertex whose coordinates cannot be used.
    #[error("vertex {vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// A face without area: all its corners lie on a line.
    #[error("face {face} has no area: its corners lie on one line; remove it")]
    ZeroArea {
        /// The face.
        face: u32,
    },
    /// A face given clockwise. (If it shares an edge with a counter-clockwise one, that is a
    /// [`MixedWinding`](BuildError::MixedWinding).)
    #[error(
        "face {face} runs clockwise{}; list its corners the other way round, orient all faces on reading, or flip y if y points down",
        if *.all { ", as all faces do" } else { "" }
    )]
    Clockwise {
        /// The first such face.
        face: u32,
        /// Whether every face of the list is clockwise.
        all: bool,
    },
    /// Two sides of one face cross.
    #[error("face {face} crosses itself: its side {} -> {} crosses its side {} -> {}", first.0, first.1, second.0, second.1)]
    SelfCrossing {
        /// The face.
        face: u32,
        /// The ends of one side.
        first: (u32, u32),
        /// The ends of the other side.
        second: (u32, u32),
    },
    /// A corner of a face lies on another of its sides, or two of its corners lie at the same place.
    #[error("face {face} touches itself: its corner {vertex} lies on its side {} -> {}", side.0, side.1)]
    SelfTouching {
        /// The face.
        face: u32,
        /// The corner.
        vertex: u32,
        /// The ends of the side.
        side: (u32, u32),
    },
    /// Two faces lie on the same side of their common edge.
    #[error("faces {first} and {second} lie on the same side of the edge {u} -> {v}: they overlap")]
    OverlapAtEdge {
        /// One end of the edge.
        u: u32,
        /// The other end.
        v: u32,
        /// One face.
        first: u32,
        /// The other face.
        second: u32,
    },
    /// Two faces overlap at a common corner.
    #[error("faces {first} and {second} overlap at their common vertex {vertex}")]
    OverlapAtVertex {
        /// The vertex.
        vertex: u32,
        /// One face.
        first: u32,
        /// The other face.
        second: u32,
    },
    /// Found by the full check: edges or vertices that meet where they should not. Vertices keep their input
    /// numbers as ids.
    #[error(transparent)]
    Geometry(#[from] GeometryViolation),
    /// A hole of a face lies outside it.
    #[error("face {face} has a hole outside its outer boundary (at vertex {vertex})")]
    HoleOutside {
        /// The face.
        face: u32,
        /// A vertex of the hole.
        vertex: u32,
    },
    /// The holes of a face cut it into pieces.
    #[error("face {face} is cut into pieces by its holes: give each piece as a face of its own")]
    InPieces {
        /// The face.
        face: u32,
    },
    /// Two cycles of a face run along one edge, in opposite directions: the face would be on both sides of it.
    #[error("two cycles of face {face} share the edge {u} -> {v}: a hole that begins at a side is no hole")]
    CommonEdge {
        /// The face.
        face: u32,
        /// One end of the edge.
        u: u32,
        /// The other end.
        v: u32,
    },
    /// A face lies inside another face that has no hole there.
    #[error("the part of the input at vertex {vertex} lies inside face {face}, which has no hole there: they overlap")]
    InsideFace {
        /// The surrounding face.
        face: u32,
        /// The leftmost vertex of what lies inside.
        vertex: u32,
    },
}

impl ConvertError {
    /// What is wrong, of a polygon that was the only one: in the third person, without its number. `name` says what its
    /// corners are called, by their numbers.
    #[cfg(feature = "navmesh")]
    pub(crate) fn of_one_polygon(&self, name: impl Fn(u32) -> u32) -> String {
        let side = |&(a, b): &(u32, u32)| format!("its side {} -> {}", name(a), name(b));
        match self {
            Self::ZeroArea { .. } => "its corners lie on one line".to_owned(),
            Self::SelfCrossing { first, second, .. } => format!("{} crosses {}", side(first), side(second)),
            Self::SelfTouching { vertex, side: touched, .. } => {
                format!("its corner {} lies on {}", name(*vertex), side(touched))
            }
            other => other.to_string(),
        }
    }

    /// The faces the message speaks of, for callers who know where in a file they stand.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::Build(error) => error.faces(),
            Self::ZeroArea { face }
            | Self::Clockwise { face, .. }
            | Self::SelfCrossing { face, .. }
            | Self::SelfTouching { face, .. }
            | Self::HoleOutside { face, .. }
            | Self::InPieces { face }
            | Self::CommonEdge { face, .. }
            | Self::InsideFace { face, .. } => vec![*face],
            Self::OverlapAtEdge { first, second, .. } | Self::OverlapAtVertex { first, second, .. } => {
                vec![*first, *second]
            }
            Self::Coordinate { .. } | Self::Geometry(_) => Vec::new(),
        }
    }

    /// The vertices the message speaks of.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match *self {
            Self::Build(ref error) => error.vertices(),
            Self::Coordinate { vertex, .. }
            | Self::OverlapAtVertex { vertex, .. }
            | Self::HoleOutside { vertex, .. }
            | Self::InsideFace { vertex, .. } => vec![vertex],
            Self::SelfCrossing { first, second, .. } => {
                vec![first.0, first.1, second.0, second.1]
            }
            Self::SelfTouching { vertex, side, .. } => vec![vertex, side.0, side.1],
            Self::OverlapAtEdge { u, v, .. } | Self::CommonEdge { u, v, .. } => vec![u, v],
            Self::Geometry(ref violation) => violation.vertices().into_iter().map(VertexId::number).collect(),
            Self::ZeroArea { .. } | Self::Clockwise { .. } | Self::InPieces { .. } => Vec::new(),
        }
    }
}
