//! The sources of the whole program, for a grader that is built elsewhere: those that the library carries along, and
//! the rest.

mod sources;

use dcel_kit::lab::lab_sources;

/// The files of a folder in which `cargo install --locked --path .` makes this program: path and text.
pub(super) fn program_sources() -> impl Iterator<Item = (&'static str, &'static str)> {
    let made = [("Cargo.toml", include_str!("Cargo.toml.txt")), ("Cargo.lock", include_str!("Cargo.lock.txt"))];
    lab_sources().iter().chain(&sources::SOURCES).copied().chain(made)
}
