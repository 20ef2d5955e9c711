//! Why faces cannot be triangulated.

use crate::ids::{Element, FaceId, VertexId};
use crate::topology::{IdError, TooMany};

/// Why faces cannot be triangulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TriangulateError {
    /// The face does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// The outer face is unbounded.
    #[error("f0, the outer face, is unbounded and cannot be cut into triangles: choose a bounded face")]
    OuterFace,
    /// The positions do not fit the structure: edges cross, or overlap. That can only be if the subdivision was
    /// converted without the full check.
    #[error(
        "{face} cannot be triangulated: near {vertex} its edges cross or overlap; `dcel validate`, or Subdivision::geometry_violations, says where"
    )]
    NotPlanar {
        /// The face.
        face: FaceId,
        /// A vertex of it near the place where it was noticed.
        vertex: VertexId,
    },
}

impl TriangulateError {
    /// The elements that it is about.
    #[must_use]
    pub fn elements(&self) -> Vec<Element> {
        match *self {
            Self::NotPlanar { face, vertex } => vec![face.into(), vertex.into()],
            Self::Id(_) | Self::TooMany(_) | Self::OuterFace => Vec::new(),
        }
    }
}
