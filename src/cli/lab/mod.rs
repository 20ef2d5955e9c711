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

use super::{Answer, Failure, Output};

/// Do a lab, or set one; alone, it says how far you are in the course
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Alone it lists the labs of the course.toml in this folder or one above, or else all labs, with what the last
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

#[derive(clap::Subcommand, Debug)]
enum Command {
    List(list::Args),
    Start(start::Args),
    Check(check::Args),
    Watch(watch::Args),
    Hint(hint::Args),
    Idea(idea::Args),
    Reset(reset::Args),
    Verify(verify::Args),
    New(new::Args),
    Export(export::Args),
    #[command(hide = true)]
    Bundle(bundle::Args),
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let Some(command) = &args.command else { return progress::run(out) };
    match command {
        Command::List(args) => list::run(args, out),
        Command::Start(args) => start::run(args, out),
        Command::Check(args) => check::run(args, out),
        Command::Watch(args) => watch::run(args, out),
        Command::Verify(args) => verify::run(args, out),
        Command::New(args) => new::run(args, out),
        Command::Hint(args) => hint::run(args, out),
        Command::Idea(args) => idea::run(args, out),
        Command::Reset(args) => reset::run(args, out),
        Command::Export(args) => export::run(args, out),
        Command::Bundle(args) => bundle::run(args, out),
    }
}

/// The lab of that name, or which ones there are.
fn bundled(name: &str) -> Result<dcel_lab::LabFiles, Failure> {
    dcel_lab::LabFiles::bundled(name).map_err(|error| {
        let what = error.to_string();
        let (what, help) = what.split_once("; ").unwrap_or((&what, ""));
        Failure::input(what, help)
    })
}

/// A lab that is compiled in, ready to grade.
pub(super) fn lab(name: &str) -> Result<dcel_lab::Lab, Failure> {
    dcel_lab::Lab::new(bundled(name)?).map_err(Failure::kit)
}
