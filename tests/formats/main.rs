//! Every format brings back what was written, refuses bad input at the right place, and never panics.

#![allow(clippy::unwrap_used)] // helpers of tests stop at the first surprise
#![allow(clippy::float_cmp)] // numbers come back exactly

mod bad_input;
mod columns;
mod outputs;
mod round_trips;
mod segments;
mod shared;
mod shared_sides;
mod soups;
mod support;
