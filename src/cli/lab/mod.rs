//! `dcel lab`: the labs, for those who do them and for those who set them.
//!
//! ```text
//!   progress, alone: `dcel lab`
//!   list ── start ── check ⇄ watch     the student's way; hint and reset on the side, idea at the end
//!   new ── verify ── export            the instructor's
//! ```
//!
//! ```text
//!   bundle.rs  `dcel lab bundle`
//!   export/    `dcel lab export`: a lab, or all of a course
//!   folder.rs  The student's folder on disk
//!   own.rs     `dcel lab check --own`
//!   kit/       The sources of the whole program, for a grader that is built elsewhere
//! ```

mod bundle;
mod check;
mod export;
mod folder;
mod hint;
mod idea;
mod kit;
mod list;
mod new;
mod own;
mod progress;
mod reset;
mod start;
mod verify;
mod watch;

pub use kit::program_sources;
pub(crate) use own::known_mistakes;

use super::choice::commands;
use super::{Answer, Failure, Output};

/// Do a lab, or set one; alone, it says how far you are in the course
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Alone it lists the labs of the course.toml in this folder or one above, or else all labs, with what the last \
`dcel lab check` said of those in folders below, and what comes next.

Examples:
  dcel lab
  dcel lab list
  dcel lab start 04 my-lab
  dcel lab check my-lab")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Option<Command>,
}

commands! {
    List list,
    Start start,
    Check check,
    Watch watch,
    Hint hint,
    Idea idea,
    Reset reset,
    Verify verify,
    New new,
    Export export,
    #[command(hide = true)]
    Bundle bundle,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let Some(command) = &args.command else { return progress::run(out) };
    command.run(out)
}

/// The lab of that name, or which ones there are.
fn bundled(name: &str) -> Result<dcel_lab::LabFiles, Failure> {
    dcel_lab::LabFiles::bundled(name).map_err(|error| Failure::helped("", error))
}

/// A lab that is compiled in, ready to grade.
pub(super) fn lab(name: &str) -> Result<dcel_lab::Lab, Failure> {
    dcel_lab::Lab::new(bundled(name)?).map_err(Failure::kit)
}
