//! Local edits of a surface: vertices, edges and faces are moved, split, joined, and cut off.
//!
//! ```text
//!   set_point transform                      points move
//!   split_edge split_face  join_edges join_faces  flip_edge          one vertex, one edge
//!   bevel_vertex bevel_edge                  hub.rs   a face takes the place of a vertex or an edge
//!   inset_face extrude_face bevel_face       rim.rs   a smaller face stands inside, or above, a face
//! ```
//!
//! One promise for all: **a refused edit leaves everything bit for bit as it was**; a made one keeps all invariants and the
//! Euler characteristic. Borders stay borders: no edit here gives a boundary face a positive side, or takes it away.
//!
//! Source: the local operations of Scotty3D (Carnegie Mellon, 15-462/662); Mäntylä, *An Introduction to Solid
//! Modeling*, 1988, chapter 9 (Euler operators).
//!
//! ```text
//!   one_edge.rs  Edits of one edge on a surface
//! ```

mod bevel_edge;
mod bevel_vertex;
mod hub;
mod one_edge;
mod place;
mod rim;

pub use bevel_edge::BevelEdgeError;
pub use bevel_vertex::BevelVertexError;
pub use one_edge::SurfaceEditError;
pub use place::{PlaceError, SpaceTransformError};
pub use rim::RimError;
