//! Lab 11, dynamic meshes and the support function: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs   the cases, test by test           model.rs    what the mesh should be after each edit
//!   solids.rs   the starts of cases               laws.rs     the records of a dump against the model
//!   answers.rs  what is wrong with an answer      features.rs what can be said of a call
//!   picture.rs  the climb over the gem            mistakes.rs would a usual mistake show in a call?
//! ```

mod answers;
mod features;
mod laws;
mod mistakes;
mod model;
mod picture;
mod solids;
mod suites;

pub use suites::SupportJudge;
