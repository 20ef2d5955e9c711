//! The two primitives, vertex split and face split, and what grows from them.

#![allow(clippy::unwrap_used)] // a test may panic
#![allow(clippy::float_cmp)] // what stays, stays bit for bit

#[path = "../common/mod.rs"]
mod common;

mod collapse;
mod edits;
mod extrude;
mod grow;
mod refusals;
mod subdivide;
