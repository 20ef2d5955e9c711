//! Solids: surfaces that grow and shrink, measures, hulls, duals and support points, each against a second opinion.

#![allow(clippy::unwrap_used)] // a test may panic
#![allow(clippy::float_cmp)] // exact equality is meant

#[path = "../common/mod.rs"]
mod common;
#[cfg(feature = "cli")]
#[path = "../shell/mod.rs"]
mod shell;

mod bent;
mod collapse;
#[cfg(feature = "cli")]
mod command;
mod dynamic;
mod hull;
mod measures;
mod rejections;
mod seen;
mod shapes;
mod shared;
mod stl;
mod support;
