//! Lab 02, polygon triangulation: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the cases, test by test          polygons.rs  the polygons they begin with
//!   lists.rs     polygons as records of corners   geometry.rs  diagonals and triangles, decided exactly
//!   splits.rs    what a split should leave        soups.rs     what a triangulation should leave
//!   features.rs  what can be said of a call       drawing.rs   the picture
//! ```

pub mod drawing;
mod features;
pub mod geometry;
mod lists;
mod polygons;
mod soups;
mod splits;
mod suites;

pub use suites::Triangulation;
