//! Subdivisions of the plane: a file for each promise.

#![allow(clippy::float_cmp)] // exact equality is meant

mod areas;
mod arranged;
mod convert;
mod edits;
mod exact;
mod inserts;
mod locate;
mod marked;
mod mend;
mod moves;
mod numbers;
mod overlay;
mod progress;
mod segments;
mod settled;
mod shared_mend;
mod shared_plane;
mod shared_segments;
mod tracer;
mod true_areas;
