//! Figures, a file for each promise: read back from the SVG text and from the pages.
#![allow(clippy::unwrap_used, reason = "a test helper that fails is a failed test")]

mod cases;
#[path = "../common/mod.rs"]
mod common;
mod compare;
mod drawn;
mod film;
mod font;
mod hard;
mod kinds;
#[cfg(feature = "cli")]
mod options;
mod pages;
mod pointers;
#[cfg(feature = "cli")]
#[path = "../shell/mod.rs"]
mod shell;
mod structure;
mod vocabulary;
