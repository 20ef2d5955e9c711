//! Lab 08, Voronoi diagrams as duals: what its functions should answer, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the judge: its cases, test by test      starts.rs   the triangulations they begin with
//!   centres.rs   centres of circles, to 30 digits        duals.rs    the dual, and its vertices in their places
//!   cells.rs     rays and the corners of cells           picture.rs  the picture of the handout
//!   costs.rs     a large triangulation                     features.rs  what can be said of a call
//! ```
//!
//! Expected answers come from the definitions: a dual half-edge lies between two faces and has a vertex on its left; a
//! centre is as far from one corner as from the others, computed with twice the digits of a double.

mod cells;
mod centres;
mod costs;
mod duals;
mod features;
mod picture;
mod starts;
mod suites;

pub use suites::VoronoiDiagrams;
