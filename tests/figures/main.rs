//! Figures, a file for each promise: read back from the SVG text and from the pages.
#![allow(clippy::unwrap_used, reason = "a test helper that fails is a failed test")]

mod algorithms;
mod cases;
#[path = "../common/mod.rs"]
mod common;
mod compare;
mod drawn;
mod film;
mod font;
mod hard;
mod kinds;
mod pages;
mod pointers;
mod solids;
mod structure;
mod vocabulary;
