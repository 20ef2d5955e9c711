//! Promise: Delaunay triangulations are right for all points, degenerate ones above all; flips find the same ones;
//! fixed edges stay.

#![allow(clippy::unwrap_used)] // a test may panic

#[path = "../common/mod.rs"]
mod common;

mod bulk;
mod constrained;
mod families;
mod lawson;
mod points_in;
mod shared;
mod voronoi;
