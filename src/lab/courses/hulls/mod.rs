//! Lab 03, convex hulls: what its functions should answer, and the cases that ask for it.
//!
//! ```text
//!   suites.rs     the judge: its cases, test by test      starts.rs    the points and polygons they begin with
//!   hull.rs       the hull of points                      tangents.rs  from a point, and common ones of two polygons
//!   merge.rs      what merging two polygons has left      picture.rs   the picture of the handout
//!   polygons.rs   points and corners of a dump            features.rs  what can be said of a call
//!   mistakes.rs   usual mistakes, carried out
//! ```
//!
//! Expected answers come from the definitions, with exact signs: the tangents from trying all corners, the hull from
//! the kit's own, which is compared with the definition in a test.

mod features;
mod hull;
mod merge;
mod mistakes;
mod picture;
mod polygons;
mod starts;
mod suites;
mod tangents;

pub use suites::Hulls;
