//! The structure figure, element by element.
//!
//! ```text
//!   view ─▶ skeleton.rs (part.rs)   what of it can be drawn
//!        ─▶ picture.rs (notes.rs)   scale, level of detail; faces; tiles.rs where it is large
//!        ─▶ plate.rs (look.rs)      placed once:   faces.rs  vertices.rs  half_edges.rs
//!                                   names:         captions.rs  labels.rs  leaders.rs
//!                                   colours:       tints.rs  overrides.rs
//!           pointer.rs (arrows.rs, face_arrows.rs, pointer_style.rs)   the pointers of the half-edges as arrows
//! ```

pub(crate) mod arrows;
pub(crate) mod captions;
pub(crate) mod face_arrows;
pub(crate) mod faces;
pub(crate) mod half_edges;
mod labels;
mod leaders;
pub(crate) mod look;
pub(crate) mod notes;
pub(crate) mod overrides;
pub(crate) mod part;
pub(crate) mod picture;
pub(crate) mod plate;
pub(crate) mod pointer;
pub(crate) mod pointer_style;
pub(crate) mod skeleton;
pub(crate) mod tiles;
mod tints;
mod vertices;
