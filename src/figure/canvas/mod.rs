//! Ink: shapes with classes, styles, texts and how wide they are, and the way from them to SVG.
//!
//! ```text
//!   vector.rs  number.rs  unit.rs       points of the canvas, numbers as they are written, lengths of paper
//!   arc.rs                              arcs of circles as curves
//!   text.rs (advances.rs, fonts/)       how much room a text takes
//!   scripts.rs                          small letters below and above the line
//!   scene.rs  crop.rs                   groups, lines, areas, discs, texts; a window on them
//!   style/                              every colour, size and font, also from a file
//!   sheet.rs  plain.rs                the style sheet of one drawing; or every element with its own colours
//!   selectors.rs (blocks.rs)            what fits which element
//!   untold.rs                           rules of which that cannot be told
//!   svg_out.rs  tikz_out.rs             the document; a picture for TeX
//!   png.rs  pdf.rs                      pixels; a page of paper
//! ```

mod advances;
pub(crate) mod arc;
pub(crate) mod blocks;
pub(crate) mod crop;
pub(crate) mod number;
#[cfg(feature = "png")]
pub(crate) mod pdf;
mod plain;
#[cfg(feature = "png")]
pub(crate) mod png;
pub(crate) mod scene;
pub(crate) mod scripts;
pub(crate) mod selectors;
mod sheet;
pub(crate) mod style;
pub(crate) mod svg_out;
pub(crate) mod text;
mod tikz_out;
pub(crate) mod unit;
#[cfg(feature = "compare")]
pub(crate) mod untold;
pub(crate) mod vector;
