//! Why a surface cannot be grown.

use crate::ids::{FaceId, HalfEdgeId};
use crate::topology::{IdError, PolygonError, SplitFaceError, SplitVertexError, TooMany};

/// Why a surface cannot be grown. Nothing was changed, unless the structure ran full on the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GrowError {
    /// An element does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// A number of the shape is too small.
    #[error("{what}: {given} is too few, take at least {least}")]
    TooFew {
        /// What was counted.
        what: &'static str,
        /// The number that was given.
        given: usize,
        /// The smallest that is allowed.
        least: usize,
    },
    /// The structure is not the seed of the shape.
    #[error("this structure is not the seed of the shape: begin with Shape::seed")]
    NotTheSeed,
    /// A face with too few sides for the procedure.
    #[error("{face} has {sides} sides along {h}: at least {least} are needed")]
    FewSides {
        /// A half-edge of the cycle.
        h: HalfEdgeId,
        /// The face.
        face: FaceId,
        /// The sides of the cycle.
        sides: usize,
        /// How many are needed.
        least: usize,
    },
    /// Steps of two do not go round an odd number of sides.
    #[error("{face} has {sides} sides along {h}: quads need an even number; split_edge one of them first")]
    OddSides {
        /// A half-edge of the cycle.
        h: HalfEdgeId,
        /// The face.
        face: FaceId,
        /// The sides of the cycle.
        sides: usize,
    },
    /// The selected faces have no border: none is selected, or all of a component are.
    #[error("{selected} of {faces} faces are selected, and no edge lies between them and the others")]
    NoBorder {
        /// The number of selected faces.
        selected: usize,
        /// The number of all faces.
        faces: usize,
    },
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// The ring cannot be made.
    #[error(transparent)]
    Ring(#[from] PolygonError),
    /// A vertex split was refused.
    #[error(transparent)]
    SplitVertex(#[from] SplitVertexError),
    /// A face split was refused.
    #[error(transparent)]
    SplitFace(#[from] SplitFaceError),
}
