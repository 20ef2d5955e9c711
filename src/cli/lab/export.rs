//! `dcel lab export`: what an instructor hands out, and what a course system runs.

use super::super::{Answer, Failure, Output};
use super::{bundled, folder};
use dcel_kit::lab::{Kit, Packed, gradescope_files, student_files, zipped};
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Pack a lab for students, or its grader for Gradescope
#[derive(clap::Args, Debug)]
#[command(after_help = "\
For students: the folder that `dcel lab start` makes, without solution and bugs. For Gradescope: the archive to
upload as the autograder; with a kit in a checkout, its sources are in it.

Examples:
  dcel lab export 04 --student lab04.zip --kit version=0.1
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
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = bundled(&args.lab)?;
    let kit = args.kit.clone().unwrap_or_else(Kit::running);
    if let Some(target) = &args.student {
        let files = student_files(&lab, &kit);
        if is_zip(target) {
            let inside = |(path, text): (String, String)| (format!("{}/{path}", lab.name()), Packed::from(text));
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
        let files = gradescope_files(lab.name(), &kit)
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
    fs::write(target, bytes).map_err(|error| Failure::writing(target.display(), &error))
}
