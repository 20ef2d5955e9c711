//! Where things go: how large a drawing is and how much of it there is room for, where ink lies already, and where a
//! label still fits.
//!
//! ```text
//!   options.rs ──▶ fit.rs     width, crop, scale, level of detail
//!                  crowd.rs   where there is ink already
//!                  pole.rs    the pole of inaccessibility: the best place for a label in a face
//!                  grid.rs    panels of one size in rows and columns
//! ```

pub(crate) mod crowd;
pub(crate) mod fit;
pub(crate) mod grid;
pub(crate) mod options;
pub(crate) mod pole;
