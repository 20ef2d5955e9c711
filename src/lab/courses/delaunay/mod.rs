//! Lab 07, Delaunay by flips: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs     the judge: its cases, test by test      meshes.rs     the triangulations they begin with
//!   edges.rs      is an edge legal, can it be flipped     flip.rs       the flip, in three steps
//!   delaunify.rs  the flips that were told, made again    costs.rs      how often records are looked at
//!   angles.rs     the smallest angle                      picture.rs    the picture of the handout
//!   features.rs   what can be said of a call              mistakes.rs   usual mistakes, carried out
//! ```
//!
//! Expected answers come from the kit's exact predicates and from the definitions. Of the many orders in which edges
//! can be flipped each is right: the flips that a program tells are made again, one by one, and each must be due.

mod angles;
mod costs;
mod delaunify;
mod edges;
mod features;
mod flip;
mod meshes;
mod mistakes;
mod picture;
mod suites;

pub use suites::Delaunay;
