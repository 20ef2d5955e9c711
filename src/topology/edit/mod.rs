//! The edits, one a file, in inverse pairs.
//!
//! One promise for all: **a refused edit leaves everything bit for bit as it was**, the free lists and the next
//! ids included. Each edit gathers what it needs, checks (`can_…` is exactly that phase), makes room, and then
//! writes; the write phase cannot fail.

mod join_edges;
mod join_faces;
mod split_edge;
mod split_face;

pub use join_edges::JoinEdgesError;
pub use join_faces::JoinFacesError;
pub use split_edge::SplitEdgeError;
pub use split_face::SplitFaceError;
