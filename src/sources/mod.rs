//! Texts of this package, for the packages `dcel-lab` and `dcel`: a published package reads nothing outside of its own
//! folder, so each of them hands out its own files.
//!
//! ```text
//!   dcel-kit ──▶ list.rs   the files that a student's folder and an autograder are built from
//!            └─▶ this file the map, the grid and the scripts that samples, tour and reference figures begin with
//! ```
//!
//! No part of the public interface: it changes with every file.

mod list;

pub use list::{CHECK, FURTHER};

/// The states of the USA, as TopoJSON with y down.
pub const STATES: &[u8] = include_bytes!("../../figures/data/states-albers-10m.json");
/// A grid map of some rooms.
pub const ROOMS_MAP: &[u8] = include_bytes!("../../figures/data/rooms.map");
/// Queries on [`ROOMS_MAP`], with the lengths of the paths.
pub const ROOMS_SCEN: &[u8] = include_bytes!("../../figures/data/rooms.scen");
/// The lab's structure from a rectangle.
pub const LAB: &str = include_str!("../../figures/scripts/lab.dcels");
/// The drawing of lab 04.
pub const LAB_04_DRAWING: &str = include_str!("../../figures/scripts/lab-04-drawing.dcels");
/// The colours of its faces.
pub const LAB_04_COLOURS: &str = include_str!("../../figures/scripts/lab-04-drawing.colours");
/// One join of two faces.
pub const JOIN_FACES: &str = include_str!("../../figures/scripts/join-faces.dcels");
/// One split of a face.
pub const SPLIT_FACE: &str = include_str!("../../figures/scripts/split-face.dcels");
/// One split of an edge at its midpoint.
pub const SPLIT_IN_HALF: &str = include_str!("../../figures/scripts/split-in-half.dcels");
