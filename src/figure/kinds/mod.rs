//! Drawings of one subject each, made of what a structure figure is made of, or of a sketch.
//!
//! ```text
//!   structure.rs  inset.rs  interactive.rs  focus.rs  panels.rs  tables.rs  records.rs     half-edges and their pointers
//!   dual.rs  voronoi.rs  triangulation.rs  overlay.rs  located.rs  robustness.rs   the plane
//!   navmesh/  solid/                                               paths, solids
//! ```

pub(crate) mod dual;
pub(crate) mod focus;
pub(crate) mod inset;
pub(crate) mod interactive;
pub(crate) mod located;
#[cfg(feature = "navmesh")]
pub mod navmesh;
pub(crate) mod overlay;
pub(crate) mod panels;
pub(crate) mod records;
pub(crate) mod robustness;
#[cfg(feature = "solid")]
pub(crate) mod solid;
pub(crate) mod structure;
pub(crate) mod tables;
pub(crate) mod triangulation;
pub(crate) mod voronoi;
