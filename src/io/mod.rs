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
//! ```text
//!   text.rs   words with places          problem.rs  what can be wrong     read.rs, write.rs  the ways in and out
//!   soup.rs   points and polygons        rings.rs    joining equal points  model.rs           what is written
//!   load.rs   from a file to a structure, with the places of what does not fit     arrange.rs  of segments
//!   misfit.rs what does not fit, in the words of the file      mend.rs  polygons that are split so that they fit
//!   obj.rs off.rs ply/ stl.rs triangle.rs mesh/ grid.rs (scen.rs) geojson.rs topojson.rs (json.rs arrays.rs)
//!   wkt.rs poly.rs segments.rs dcel.rs tables.rs   one format each
//!   points.rs points alone, of any of them or of plain text    words.rs  numbers with their words
//!   labels.rs groups and materials of faces
//!   room.rs   memory that is asked for before it is needed
//! ```

mod arrange;
mod arrays;
pub mod dcel;
mod format;
pub mod geojson;
pub mod grid;
mod json;
mod labels;
mod load;
mod mend;
pub mod mesh;
mod misfit;
mod model;
mod near;
pub mod obj;
pub mod off;
pub mod ply;
mod points;
pub mod poly;
mod problem;
mod read;
mod rings;
mod room;
pub mod scen;
pub mod segments;
mod soup;
pub mod stl;
pub mod tables;
mod text;
pub mod topojson;
pub mod triangle;
pub mod wkt;
mod words;
mod write;

pub use crate::geometry::number::Number;
pub use arrange::{arrange, arrange_with, describe, faults_with_places, on_grid};
pub use format::{Format, UnknownFormat};
pub use grid::Grid;
pub use labels::Labels;
pub use load::{LoadError, LoadOptions, Loaded, NOTHING_TO_MEND, Structure, assemble, load};
pub use mend::Covering;
pub use model::Model;
pub use near::closest;
pub use points::{PointList, points_from_text, read_points};
pub use problem::{ReadError, ReadProblem};
pub use read::{Document, Read, ReadOptions, read_bytes, read_path, read_triangle, source_name};
pub use scen::{Misfits, Optimum, Query, Scenario, Verdict};
pub use segments::SegmentSoup;
pub use soup::{Axis, Places, PolygonSoup};
pub use words::counted;
pub use write::{WriteError, write, write_path, write_triangle};
