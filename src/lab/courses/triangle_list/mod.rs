//! Lab 05, from a triangle list to half-edges: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the cases, test by test           lists.rs     the lists of faces that they ask about
//!   soup.rs      a list of faces: what is wrong with it, and the tables of its half-edges
//!   steps.rs     add_face, match_twins, close_border           whole.rs     from_faces, of every size
//!   refused.rs   what a function returned: built, or refused   features.rs  what can be said of a call
//!   mistakes.rs  usual mistakes of linking, carried out
//!   drawing.rs   the picture
//! ```
//!
//! No two half-edges of a list that is right run between the same vertices in the same direction. So a half-edge is
//! known by its ends, and structures are compared whatever the numbers of their half-edges are.

mod drawing;
mod features;
mod lists;
mod mistakes;
mod refused;
mod soup;
mod steps;
mod suites;
mod whole;

pub use suites::TriangleList;
