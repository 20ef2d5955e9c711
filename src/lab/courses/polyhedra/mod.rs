//! Lab 10, polyhedra: what its functions should answer, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the judge: its cases, test by test       shapes.rs    the surfaces they begin with, by their faces
//!   surface.rs   surfaces, as a program prints them       starts.rs    how a case states them
//!   counts.rs    Euler's number, triangles, genus         walks.rs     round a vertex, the winged-edge table
//!   dual.rs      the dual                                 angles.rs    deficit and dihedral angles, and what loses them
//!   merging.rs   faces merged, one by one and all         costs.rs     how many records many questions look at
//!   regular.rs   the five regular solids                  picture.rs   the picture of the handout
//!   features.rs  what can be said of a call
//! ```
//!
//! Expected answers come from the definitions, by counting and by going through lists of corners; angles from
//! other formulas than those of the handout.

mod angles;
mod costs;
mod counts;
mod dual;
mod features;
mod merging;
mod picture;
mod regular;
mod shapes;
mod starts;
mod suites;
mod surface;
mod walks;

pub use suites::Polyhedra;
