//! Half-edge structures to learn with.

// Nothing may panic on data: an error, or expect() with the reason why it cannot happen.
#![warn(clippy::unwrap_used)]

pub mod figure;
pub mod ids;
pub mod io;
pub mod plane;
pub mod solid;
pub mod topology;

pub use ids::{
    EdgeId, EdgeMap, Element, FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, Id, IdMap, ParseIdError, VertexId, VertexMap,
};
