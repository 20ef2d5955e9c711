//! Lab 06, paths on a navigation mesh: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs    the cases, test by test               mesh.rs      meshes of triangles: made, numbered, read
//!   answers.rs   what each function should answer      funnel.rs    the shortest path through portals
//!   costs.rs     how many records a call looks at      picture.rs   the picture of the map
//!   features.rs  what can be said of a call            mistakes.rs  usual mistakes, carried out
//! ```

mod answers;
mod costs;
mod features;
mod funnel;
mod mesh;
mod mistakes;
mod picture;
mod suites;

pub use suites::NavMeshJudge;
