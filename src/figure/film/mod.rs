//! Films of edits: before, one frame for each step of the operation, after.
//!
//! ```text
//!   journal ──> frames.rs ──> sheet.rs    a strip: all frames side by side, in rows
//!   script.rs   (tables)   draw.rs     a stepper: the same frames, one at a time, by links (style.rs)
//!   player.rs    a page that plays a film
//!   sketches.rs  films of sketches, for what is not an edit: algorithms/
//!                          space.rs    surfaces in space, a frame an edit      sides.rs  what is glued has one letter
//! ```
//!
//! A frame shows the structure as it is at the end of its step, which may be half-linked: the changes of the
//! journal are written into a table one by one, and the table is drawn. What the step has written is blue, the
//! pointers it has replaced are red and dashed, the rest is grey. All frames share one canvas and one layout.

pub mod algorithms;
mod draw;
mod frames;
mod player;
#[cfg(feature = "script")]
mod script;
mod sheet;
mod sides;
mod sketches;
#[cfg(feature = "solid")]
mod space;
mod style;

pub use frames::{Fate, Film, Frame, Written};
#[cfg(feature = "script")]
pub use script::{Filmed, ScriptFilm};
pub use sketches::SketchFilm;
