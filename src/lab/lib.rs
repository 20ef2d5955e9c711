//! Labs graded from outside: the student's program is run as a process of its own, and judged by what it prints.
//!
//! ```text
//!   labs/NN-name/lab.toml      what there is to do, what it is worth
//!   case ──text──▶ driver + the student's file ──dump──▶ checks ──▶ findings ──▶ verdict ──▶ report
//!     ▲            (a process in the sandbox)                │
//!     └──────────── shrinking: the shortest failing case ◀─┘──▶ mutants.rs: the mistake by its name
//! ```
//!
//! Nothing that the student wrote is ever linked to the tests, so nothing in it can decide about them: a pass needs
//! a complete and right dump for every case. `cargo test` in a lab's folder and `dcel grade` call the same functions
//! here and give the same verdicts.
//!
//! Without the feature `grade` there is what those tests need, and nothing more.

// Nothing may panic on data: an error, or expect() with the reason why it cannot happen.
#![warn(clippy::unwrap_used)]

pub mod answers;
#[cfg(feature = "grade")]
mod batch;
mod bug;
#[cfg(feature = "grade")]
mod cache;
pub mod cases;
pub mod checks;
mod conditions;
#[cfg(feature = "grade")]
pub mod course;
pub mod courses;
#[cfg(feature = "grade")]
mod export;
pub mod fault;
mod features;
mod feedback;
mod files;
mod findings;
mod grade;
pub mod judge;
mod judged;
#[cfg(feature = "grade")]
mod kit;
mod lanes;
#[cfg(feature = "grade")]
mod learn;
mod manifest;
pub mod many;
mod markers;
mod mutants;
#[cfg(feature = "grade")]
mod own_cases;
mod own_folder;
#[cfg(feature = "grade")]
mod own_lab;
pub mod pictures;
mod plan;
mod points;
mod program;
pub mod protocol;
mod report;
#[cfg(feature = "grade")]
pub mod reports;
mod run;
#[cfg(feature = "grade")]
mod sandbox;
mod signatures;
#[cfg(feature = "grade")]
mod similar;
mod stop;
#[cfg(feature = "grade")]
mod student;
mod submission;
mod task;
mod the_lab;
mod told;
mod toml_file;
mod typed;
#[cfg(feature = "grade")]
mod vendor;
mod verdict;
#[cfg(feature = "grade")]
mod verify;

#[cfg(feature = "grade")]
pub use batch::{GradeOptions, Grader, Outcome};
// What judges of half-edge structures are written with.
pub use dcel_kit::topology::{Table, View};
pub use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};

pub use bug::{Bug, BugError, Edit};
#[cfg(feature = "grade")]
pub use export::{CourseFiles, Packed, classroom50_files, gradescope_files, zipped};
pub use features::FeatureSet;
pub use feedback::{graded, graded_by, test_text};
pub use files::{LabFiles, LabFilesError};
pub use grade::{grade_and_sign, grade_program};
#[cfg(feature = "grade")]
pub use kit::{COPIES, KitBuild, Package, Read, Sources, sources, texts_of};
pub use manifest::{Manifest, Task, Test};
pub use markers::{MarkError, starter};
#[cfg(feature = "grade")]
pub use own_cases::{KnownMistakes, OWN_CASES, OwnCaseError, OwnCases, built};
pub use own_folder::{FolderCheck, Workbench, check_folder};
#[cfg(feature = "grade")]
pub use own_lab::{NewLabError, new_lab};
pub use plan::{Plan, Secret};
pub use points::Points;
pub use program::{Driver, End, Limits, Program, Ran, end_of, signal_name};
pub use report::{
    Adjustment, Barrier, Finding, HandedIn, OwnTests, Picture, Report, Similar, Terms, TestResult, Visibility,
};
#[cfg(feature = "grade")]
pub use sandbox::{Hidden, Sandbox, SandboxChoice, SandboxedProgram, launched};
pub use signatures::{Signature, Signatures};
pub use stop::Stop;
#[cfg(feature = "grade")]
pub use student::{Kit, student_files};
#[cfg(feature = "grade")]
pub use submission::{ClassError, Submission};
pub use submission::{Forbidden, Intake, IntakeError, ScanError, scan, take_in};
pub use the_lab::{Lab, LabError};
pub use toml_file::ManifestError;
pub use typed::typed;
#[cfg(feature = "grade")]
pub use vendor::vendored;
pub use verdict::Verdict;
#[cfg(feature = "grade")]
pub use verify::{BugRow, Verification, verify, verify_some};
