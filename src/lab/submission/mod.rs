//! Taking a submission in: the student's file out of whatever was handed in, into a tree that holds nothing else of
//! theirs, and the program that is built from it.
//!
//! ```text
//!   alice/src/lab.rs ──look──▶ text ──scan──▶ pristine tree ──cargo──▶ program
//!   alice/build.rs   ✗         UTF-8           own manifest   own target directory
//!   alice/.cargo/    ✗         at most 1 MB    given files    no solution anywhere near
//! ```
//!
//! Handed in is a folder, a single file, or an archive, which is looked into and never unpacked. Only the files that
//! `lab.toml` names are ever read, once; manifests, build scripts and settings of cargo are not even looked at, and
//! links are not followed.

#[cfg(feature = "grade")]
mod archive;
mod build;
#[cfg(feature = "grade")]
mod handed;
mod intake;
#[cfg(feature = "grade")]
mod linker;
mod parts;
mod reads;
mod scan;
mod toolchain;
mod tree;
#[cfg(feature = "grade")]
mod work_folder;

pub(crate) use build::{Built, build};
#[cfg(feature = "grade")]
pub use handed::{ClassError, Submission};
pub use intake::{Intake, IntakeError, take_in};
#[cfg(feature = "grade")]
pub(crate) use intake::{scan_all, take_in_unscanned};
pub use scan::{Forbidden, ScanError, scan};
pub(crate) use toolchain::Toolchain;
pub(crate) use tree::Tree;
#[cfg(feature = "grade")]
pub(crate) use work_folder::WorkFolders;

use super::Limits;

/// What a build may use, if nothing else is said: many times what a lab's file takes.
pub(crate) const USUAL_BUILD: Limits = Limits {
    seconds: 30.0,
    cpu_seconds: 40,
    memory_mb: 4096,
    output_kb: 4096,
    file_kb: 256 * 1024,
    files: 1024,
    processes: 256,
};
