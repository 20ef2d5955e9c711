//! Why a subdivision is no navmesh.

use crate::ids::{FaceId, VertexId};

/// What [`NavMesh::new`](super::NavMesh::new) refuses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NavMeshError {
    /// A face of the domain has a corner that turns the wrong way, or an antenna.
    #[error("{face} is not convex at {corner}: split it there, or triangulate the map")]
    Concave {
        /// The face.
        face: FaceId,
        /// The first such corner along its boundary.
        corner: VertexId,
    },
    /// A face of the domain has something inside.
    #[error("{face} has {rings} ring{} inside: cut it into convex faces, or make what lies inside it part of the map", if *.rings == 1 { "" } else { "s" })]
    Rings {
        /// The face.
        face: FaceId,
        /// How many rings it has.
        rings: usize,
    },
    /// There is nothing to walk on.
    #[error("the map has no bounded face that is not a hole: there is nothing to walk on")]
    NoFaces,
    /// Two bits of every id are marks here.
    #[error("the map is too large for a navmesh: ids must stay below {}", super::marks::MOST)]
    TooMany,
}
