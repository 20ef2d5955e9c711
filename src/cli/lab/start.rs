//! `dcel lab start`: a folder to do a lab in.

use super::super::{Answer, Failure, Output};
use super::{folder, lab, progress};
use dcel_lab::{Kit, typed};
use std::io::Write;
use std::path::PathBuf;

/// Make a folder to do a lab in
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The folder is a package of its own: it can be moved, to another machine too, and its code depends on nothing but the \
standard library. Only its tests use the kit, whose sources lie in kit/; --kit names another place. What the kit itself \
needs is downloaded with the first `cargo test`; with --vendor it lies in vendor/, for a room without the network.

Examples:
  dcel lab start 04 my-lab
  dcel lab start half-edge ~/labs/half-edge --kit version=0.1")]
pub(crate) struct Args {
    /// The lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: String,
    /// The folder to make
    #[arg(value_name = "DIR")]
    dir: PathBuf,
    /// Where the tests take the kit from: path=FOLDER, git=URL or version=NUMBER
    #[arg(long, value_name = "PLACE")]
    kit: Option<Kit>,
    /// Put all crates that the tests need into the folder, too: nothing is downloaded later
    #[arg(long, conflicts_with = "kit")]
    vendor: bool,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = lab(&args.lab)?;
    let manifest = &lab.manifest;
    let files = folder::files(&lab.files, &args.kit.clone().unwrap_or_default(), args.vendor)?;
    folder::make(&args.dir, &files)?;
    progress::note_needs(&lab.name, &args.dir);
    let dir = args.dir.display();
    writeln!(out, "{}: {}, in {dir}", lab.name, manifest.title)?;
    writeln!(out, "  {dir}/README.md    what to do")?;
    for graded in &manifest.graded {
        writeln!(out, "  {dir}/{graded}   what you write")?;
    }
    let dir = typed(&args.dir);
    writeln!(out, "\nNext:\n  cd {dir}\n  dcel lab check       or, without this program: cargo test")?;
    Ok(Answer::Yes)
}
