//! The sources of the whole program, for a grader that is built elsewhere: those that the packages below carry along,
//! and its own.

mod sources;

use dcel_lab::KitBuild;

/// What is generated beside the sources: where it goes, and its text.
const MADE: [(&str, &str); 4] = [
    ("Cargo.toml", include_str!("dcel-kit.toml.txt")),
    ("src/lab/Cargo.toml", include_str!("dcel-lab.toml.txt")),
    ("src/cli/Cargo.toml", include_str!("dcel.toml.txt")),
    ("Cargo.lock", include_str!("Cargo.lock.txt")),
];

/// The files of a folder in which `cargo install --locked --path src/cli` makes this program: path and text.
pub(crate) fn program_sources() -> impl Iterator<Item = (&'static str, &'static str)> {
    dcel_lab::sources(KitBuild::Program).chain(sources::FURTHER.iter().copied()).chain(MADE)
}
