//! `dcel lab start`: a folder to do a lab in.

use super::super::{Answer, Failure, Output};
use super::{bundled, folder, manifest};
use dcel_kit::lab::{Kit, student_files};
use std::io::Write;
use std::path::PathBuf;

/// Make a folder to do a lab in
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The folder is a package of its own: it can be moved, and its code depends on nothing but the standard library. Only
its tests use the kit, from the checkout that this program was built in; --kit names another place.

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
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = bundled(&args.lab)?;
    let manifest = manifest(&lab)?;
    let files = student_files(&lab, &args.kit.clone().unwrap_or_else(Kit::running));
    folder::make(&args.dir, &files)?;
    let dir = args.dir.display();
    writeln!(out, "{}: {}, in {dir}", lab.name(), manifest.title)?;
    writeln!(out, "  {dir}/README.md    what to do")?;
    for graded in &manifest.graded {
        writeln!(out, "  {dir}/{graded}   what you write")?;
    }
    writeln!(out, "\nNext:\n  cd {dir}\n  dcel lab check       or, without this program: cargo test")?;
    Ok(Answer::Yes)
}
