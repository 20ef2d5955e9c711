//! Ink: shapes with classes, styles, texts and how wide they are, and the way from them to SVG.
//!
//! ```text
//!   vector.rs  number.rs  unit.rs       points of the canvas, numbers as they are written, lengths of paper
//!   text.rs (advances.rs, fonts/)       how much room a text takes
//!   scene.rs  crop.rs                   groups, lines, areas, discs, texts; a window on them
//!   style/                              every colour, size and font, also from a file
//!   sheet.rs (selectors.rs)  plain.rs   the style sheet of one drawing; or every element with its own colours
//!   svg_out.rs  png.rs                  the document; pixels
//! ```

mod advances;
pub(crate) mod crop;
pub(crate) mod number;
mod plain;
#[cfg(feature = "png")]
pub(crate) mod png;
pub(crate) mod scene;
pub(crate) mod selectors;
mod sheet;
pub(crate) mod style;
pub(crate) mod svg_out;
pub(crate) mod text;
pub(crate) mod unit;
pub(crate) mod vector;
