//! Subdivisions of the plane: a file for each promise.

mod convert;
mod edits;
mod inserts;
mod locate;
mod numbers;
mod overlay;
mod segments;
mod shared_plane;
mod shared_segments;
mod tracer;
