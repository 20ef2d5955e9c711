//! Lab 09, two primitives: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs     the cases, test by test       reference.rs  the primitives, and what is made of them, on tables
//!   growth.rs     what is wrong with a call     revolve.rs    where the vertices are in space
//!   costs.rs      splits of a large surface     picture.rs    the picture of the handout
//!   features.rs   what can be said of a call    shorter.rs    the same on smaller surfaces
//!   asked.rs      a function asked of a surface
//! ```
//!
//! Surfaces are told apart by what is joined to what: all vertices are at one place, and only `revolve` gives places
//! back. Old elements keep their numbers, new ones may be numbered at will.

mod asked;
mod costs;
mod features;
mod growth;
mod picture;
mod reference;
mod revolve;
mod shorter;
mod suites;

pub use suites::Primitives;
