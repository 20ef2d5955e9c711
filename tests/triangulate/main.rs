//! Promise: every bounded face is cut into triangles of positive area by diagonals inside it, n + 2r - 2 of them,
//! whatever its shape, by both methods; nothing else changes.

#![allow(clippy::unwrap_used)] // a test may panic

#[path = "../common/mod.rs"]
mod common;
mod judge;
mod refusals;
mod shapes;
mod shared;
mod small;
