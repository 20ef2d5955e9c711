//! `dcel lab`: the labs, for those who do them and for those who set them.
//!
//! ```text
//!   list ── start ── check ⇄ watch     the student's way; hint and reset on the side
//!   verify ── export                   the instructor's
//! ```

mod bundle;
mod export;
mod folder;
mod list;
mod reset;
mod start;

use super::{Answer, Failure, Output};

/// Do a lab, or set one
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel lab list
  dcel lab start 04 my-lab")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand, Debug)]
enum Command {
    List(list::Args),
    Start(start::Args),
    Reset(reset::Args),
    Export(export::Args),
    #[command(hide = true)]
    Bundle(bundle::Args),
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    match &args.command {
        Command::List(args) => list::run(args, out),
        Command::Start(args) => start::run(args, out),
        Command::Reset(args) => reset::run(args, out),
        Command::Export(args) => export::run(args, out),
        Command::Bundle(args) => bundle::run(args, out),
    }
}

/// The lab of that name, or which ones there are.
fn bundled(name: &str) -> Result<dcel_kit::lab::LabFiles, Failure> {
    dcel_kit::lab::LabFiles::bundled(name).map_err(|error| {
        let what = error.to_string();
        let (what, help) = what.split_once("; ").unwrap_or((&what, ""));
        Failure::input(what, help)
    })
}

/// The manifest of a lab that is compiled in.
fn manifest(lab: &dcel_kit::lab::LabFiles) -> Result<dcel_kit::lab::Manifest, Failure> {
    let source = format!("{}/lab.toml", lab.name());
    dcel_kit::lab::Manifest::parse(lab.get("lab.toml").unwrap_or_default(), &source).map_err(Failure::kit)
}
