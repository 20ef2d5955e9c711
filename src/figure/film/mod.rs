//! Films of edits: before, one frame for each step of the operation, after.
//!
//! ```text
//!   journal ──> frames.rs ──> sheet.rs    a strip: all frames side by side, in rows
//!               (tables)   draw.rs     a stepper: the same frames, one at a time, by links (style.rs)
//! ```
//!
//! A frame shows the structure as it is at the end of its step, which may be half-linked: the changes of the
//! journal are written into a table one by one, and the table is drawn. What the step has written is blue, the
//! pointers it has replaced are red and dashed, the rest is grey. All frames share one canvas and one layout.

mod draw;
mod frames;
mod sheet;
mod style;

pub use frames::{Fate, Film, Frame, Written};
