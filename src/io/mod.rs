//! Formats in and out.
//!
//! ```text
//!   obj off ply ─┐                           ┌─> PolygonSoup ──(builders)──> structure ─┐
//!   .node .ele  ─┼─> read_path, read_bytes ──┤      points, faces, places               ├─> write ─> files
//!   *json mesh  ─┤                           ├─> SegmentSoup ──(arrange)───> structure ─┤
//!   wkt .poly   ─┤                           └─> Table  ──────────────────> validator  ─┘
//!   segments dcel┘
//! ```
//!
//! A reader takes a file as it is: it checks the syntax, the numbers and the range of the indices, names the
//! place of the first problem, and tells in [`Read::notes`] what it left out. Whether the polygons fit together
//! is the builders' business; [`Places`] lets them name the line.
//!
//! No reader trusts a count in a file: memory grows with the data that are there. None panics or hangs.
//!
//! | task | types |
//! |---|---|
//! | from a file to a structure | [`load()`], [`LoadOptions`], [`Structure`] |
//! | from a structure to a file | [`write_path`], [`Model`], [`Format`] |
//! | from bytes, without building anything | [`read_bytes`], [`Document`], [`PolygonSoup`], [`SegmentSoup`] |
//! | points alone | [`read_points`], [`PointList`] |
//! | grid maps and their queries | [`Grid`], [`Scenario`] |
//! | what is wrong, and where | [`ReadError`], [`LoadError`], [`Places`] |

// The files of this folder:
//
//   ways in       read.rs load.rs        from bytes or a path to a Document (document.rs), and on to a structure
//   ways out      write.rs model.rs      from a structure to a file; names.rs writes ids; losses.rs tells what is lost
//   polygons      obj.rs off.rs ply/ stl.rs triangle.rs mesh/ grid.rs     one format each, into soup.rs, line_numbers.rs, labels.rs
//   JSON          json.rs -> geojson.rs topojson.rs -> geometries.rs arrays.rs nodes.rs
//                 rings.rs  repaired.rs  joins equal points of rings    left_out.rs  what is read over
//   both          wkt.rs                 polygons into rings.rs, or segments
//   segments      segments.rs poly.rs -> arrange.rs
//   others        dcel.rs tables.rs      whole structures       scen/  queries       points.rs  points alone
//   formats       format.rs sniff.rs     by name or by content
//   text          blocks.rs block.rs     files in pieces       text.rs announced.rs    words with places, numbers with their words
//                 words.rs near.rs       words that were meant
//   faults        problem.rs load_error.rs misfit.rs outline.rs touches.rs write_error.rs       room.rs  asks for memory before it is needed
//   repair        mend.rs                polygons that are split so that they fit

mod announced;
mod arrange;
mod arrays;
mod block;
mod blocks;
pub mod dcel;
mod document;
mod format;
pub mod geojson;
mod geometries;
pub mod grid;
mod json;
mod labels;
mod left_out;
mod line_numbers;
mod load;
mod load_error;
mod losses;
mod mend;
pub mod mesh;
mod misfit;
mod model;
mod names;
mod near;
mod nodes;
pub mod obj;
pub mod off;
mod outline;
pub mod ply;
mod points;
pub mod poly;
mod problem;
mod read;
mod repaired;
mod rings;
mod room;
pub mod scen;
pub mod segments;
mod sniff;
mod soup;
pub mod stl;
pub mod tables;
mod text;
pub mod topojson;
mod touches;
pub mod triangle;
pub mod wkt;
mod words;
mod write;
mod write_error;

pub use crate::geometry::number::Number;
pub use arrange::{arrange, arrange_with, describe, faults_with_places, is_as_given, on_grid};
pub use document::{Document, Read, ReadOptions};
pub use format::{Format, UnknownFormat};
pub use grid::Grid;
pub use labels::Labels;
pub use left_out::LeftOut;
pub use line_numbers::LineNumbers;
pub use load::{LoadOptions, Loaded, NOTHING_TO_MEND, Structure, assemble, load};
pub use load_error::LoadError;
pub use losses::losses;
pub use mend::Covering;
pub use model::Model;
pub use near::closest;
pub use points::{PointList, points_from_text, read_points};
pub use problem::{ReadError, ReadProblem};
pub use read::{read_bytes, read_path, read_triangle, read_whole, source_name};
pub use scen::{Misfits, Optimum, Query, Scenario, Verdict};
pub use soup::{Axis, Places, PolygonSoup, SegmentSoup};
pub use words::{at_most, counted};
pub use write::{write, write_path, write_triangle};
pub use write_error::WriteError;
