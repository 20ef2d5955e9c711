//! `dcel lab export`: what an instructor hands out, and what a course system runs.

use super::super::{Answer, Failure, Output, save};
use super::{bundled, folder, kit};
use dcel_kit::lab::{Kit, Packed, gradescope_files, zipped};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Pack a lab for students, or its grader for Gradescope
#[derive(clap::Args, Debug)]
#[command(after_help = "\
For students: the folder that `dcel lab start` makes, without solution and bugs. For Gradescope: the archive to
upload as the autograder. The sources of the kit lie in both, so they need nothing of this machine; --kit names another
place for them. What the kit itself needs is downloaded when it is built, or lies in the student's folder (--vendor).

Examples:
  dcel lab export 04 --student lab04.zip
  dcel lab export 04 --student lab04.zip --vendor
  dcel lab export 04 --student lab04/
  dcel lab export 04 --gradescope autograder.zip",
    group(clap::ArgGroup::new("what").required(true).args(["student", "gradescope"]))
)]
pub(crate) struct Args {
    /// The lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: String,
    /// The student's folder, as a zip archive or as a folder
    #[arg(long, value_name = "FILE.zip|DIR")]
    student: Option<PathBuf>,
    /// The autograder for Gradescope
    #[arg(long, value_name = "FILE.zip")]
    gradescope: Option<PathBuf>,
    /// Where the kit comes from: path=FOLDER, git=URL or version=NUMBER
    #[arg(long, value_name = "PLACE")]
    kit: Option<Kit>,
    /// Put all crates that a student's tests need into the folder, too: for a room without the network
    #[arg(long, requires = "student", conflicts_with = "kit")]
    vendor: bool,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = bundled(&args.lab)?;
    let place = args.kit.clone().unwrap_or_default();
    if let Some(target) = &args.student {
        let files = folder::files(&lab, &place, args.vendor)?;
        if is_zip(target) {
            let inside = |(path, file): (String, Packed)| (format!("{}/{path}", lab.name()), file);
            write(target, &files.into_iter().map(inside).collect())?;
        } else {
            folder::make(target, &files)?;
        }
        writeln!(out, "{}: {} for students", target.display(), lab.name())?;
    }
    if let Some(target) = &args.gradescope {
        if !is_zip(target) {
            let what = format!("{}: an autograder is a zip archive", target.display());
            return Err(Failure::input(what, "let its name end in .zip"));
        }
        let files = gradescope_files(lab.name(), &place, kit::program_sources())
            .map_err(|error| Failure::input(format!("the sources of the kit: {error}"), "say --kit path=CHECKOUT"))?;
        write(target, &files)?;
        writeln!(out, "{}: the autograder of {}", target.display(), lab.name())?;
    }
    Ok(Answer::Yes)
}

fn is_zip(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"))
}

fn write(target: &Path, files: &BTreeMap<String, Packed>) -> Result<(), Failure> {
    let bytes = zipped(files).map_err(Failure::kit)?;
    save::put(target, bytes)
}
