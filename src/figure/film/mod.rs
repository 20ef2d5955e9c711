//! Films of edits: before, one frame for each step of the operation, after.
//!
//! ```text
//!   journal ──> moments.rs ──> frames.rs ──> draw.rs      what one frame shows of a step ──> tables ──> pictures
//!   script.rs                                drawn.rs ──> reel.rs   the pictures of all frames, with their captions
//!   a film of a script                       sheet.rs     side by side in rows: a strip; or one at a time, by links:
//!                                                         a stepper (style.rs)
//!                                            player.rs    a page that plays a film
//!   beside.rs    an edit beside the same edit with slips: assignments that are forgotten or wrong (slip.rs)
//!   space.rs     surfaces in space, a frame an edit       sides.rs     what is glued has one letter
//!   room.rs      room where the edits are, if a structure without coordinates is large
//!   sketches.rs  films of sketches, for what is not an edit: algorithms/
//! ```
//!
//! A frame shows the structure as it is at the end of its step, which may be half-linked: the changes of the
//! journal are written into a table one by one, and the table is drawn. What the step has written is blue, the
//! pointers it has replaced are red and dashed, the rest is grey. All frames share one canvas and one layout.

pub mod algorithms;
mod beside;
mod draw;
mod drawn;
mod frames;
mod moments;
mod player;
mod reel;
mod room;
#[cfg(feature = "script")]
mod script;
mod sheet;
mod sides;
mod sketches;
mod slip;
#[cfg(feature = "solid")]
mod space;
mod style;

pub use beside::{SlipError, SlipFilm};
pub use frames::{Fate, Film, Frame, Written};
#[cfg(feature = "script")]
pub use script::{Filmed, ScriptFilm};
pub use sketches::SketchFilm;
pub use slip::Slip;
