//! Solids: surfaces that grow and shrink, measures, hulls, duals and support points, each against a second opinion.

#![allow(clippy::unwrap_used)] // a test may panic
#![allow(clippy::float_cmp)] // exact equality is meant

#[path = "../common/mod.rs"]
mod common;

mod bent;
mod collapse;
mod dynamic;
mod hull;
mod local;
mod measures;
mod rejections;
mod seen;
mod shapes;
mod shared;
mod stl;
mod support;
