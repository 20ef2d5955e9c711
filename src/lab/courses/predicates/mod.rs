//! Lab 01, geometric predicates: what its functions should return, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the cases, test by test       points.rs    the points they are made of
//!   functions.rs what is right of each answer  sum.rs       sums of products without any rounding
//!   features.rs  what can be said of a call    map.rs       the map of wrong signs
//! ```

mod features;
mod functions;
pub mod map;
mod points;
mod suites;
pub mod sum;

pub use suites::Predicates;
