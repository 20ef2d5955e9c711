//! `dcel lab export`: what an instructor hands out, and what a course system runs.
//!
//! ```text
//!   course.rs  a whole course: archives, autograders, the course page
//!   page.rs    handouts as pages
//! ```

mod course;
mod page;

use super::super::{Answer, Failure, Output, save};
use super::{bundled, folder, kit};
use course::Export;
use dcel_lab::{Kit, Packed, classroom50_files, gradescope_files, zipped};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Pack a lab for students, or its grader for Gradescope or Classroom 50; or all of a course
#[derive(clap::Args, Debug)]
#[command(after_help = "\
For students: the folder that `dcel lab start` makes, without solution and bugs; it is also the template of an \
assignment in Classroom 50. For Gradescope: the archive to upload as the autograder. For Classroom 50: what belongs in \
CLASSROOM/autograders/ASSIGNMENT/. The sources of the kit lie in all of them, so they need nothing of this machine; \
--kit names another place for them. What the kit itself needs is downloaded when it is built, or lies in the student's \
folder (--vendor).

--course FILE packs all labs of a course.toml into the folder --out, a new one: site/ is the course page with every \
handout, its figures and the archives for students, for any web server or none; gradescope/ and classroom50/ hold an \
autograder for each lab, with the points and limits of the course. Hidden cases are in gradescope/ alone. If own tests \
give points, the labs with their known mistakes are needed: --labs DIR, or a checkout around this folder.

Examples:
  dcel lab export 04 --student lab04.zip
  dcel lab export 04 --student lab04.zip --vendor
  dcel lab export 04 --student lab04/
  dcel lab export 04 --gradescope autograder.zip
  dcel lab export 04 --classroom50 autograder.zip
  dcel lab export --course course.toml --out handed-out",
    group(clap::ArgGroup::new("what").required(true).multiple(true).args(["student", "gradescope", "classroom50", "course"])),
    group(clap::ArgGroup::new("folders").multiple(true).args(["student", "course"]))
)]
pub(crate) struct Args {
    /// The lab: its name, or its number
    #[arg(value_name = "LAB", required_unless_present = "course")]
    lab: Option<String>,
    /// The student's folder, as a zip archive or as a folder
    #[arg(long, value_name = "FILE.zip|DIR")]
    student: Option<PathBuf>,
    /// The autograder for Gradescope
    #[arg(long, value_name = "FILE.zip")]
    gradescope: Option<PathBuf>,
    /// The autograder for Classroom 50, as a zip archive or as a folder
    #[arg(long, value_name = "FILE.zip|DIR")]
    classroom50: Option<PathBuf>,
    /// Where the kit comes from: path=FOLDER, git=URL or version=NUMBER
    #[arg(long, value_name = "PLACE")]
    kit: Option<Kit>,
    /// Put all crates that a student's tests need into the folder, too: for a room without the network
    #[arg(long, requires = "folders", conflicts_with = "kit")]
    vendor: bool,
    /// A course, with all its labs
    #[arg(long, value_name = "FILE", requires = "out", conflicts_with_all = ["lab", "student", "gradescope", "classroom50"])]
    course: Option<PathBuf>,
    /// The folder to make for the course
    #[arg(long, value_name = "DIR", requires = "course")]
    out: Option<PathBuf>,
    /// Where the labs with their known mistakes are: the folder `labs` of a checkout
    #[arg(long, value_name = "DIR", requires = "course")]
    labs: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let place = args.kit.clone().unwrap_or_default();
    if let (Some(file), Some(to)) = (&args.course, &args.out) {
        let export = Export { file, labs: args.labs.as_deref(), kit: &place, vendor: args.vendor };
        return export.write(to, out).map(|()| Answer::Yes);
    }
    let lab = bundled(args.lab.as_deref().unwrap_or_default())?;
    if let Some(target) = &args.student {
        let above = if is_zip(target) { format!("{}/", lab.name()) } else { String::new() };
        let files = folder::files(&lab, &place, args.vendor)?.into_iter();
        write(target, &files.map(|(path, file)| (format!("{above}{path}"), file)).collect())?;
        writeln!(out, "{}: {} for students", target.display(), lab.name())?;
    }
    if let Some(target) = &args.gradescope {
        if !is_zip(target) {
            let what = format!("{}: an autograder is a zip archive", target.display());
            return Err(Failure::input(what, "let its name end in .zip"));
        }
        let files = of_kit(gradescope_files(lab.name(), &place, kit::program_sources(), None))?;
        write(target, &files)?;
        writeln!(out, "{}: the autograder of {}", target.display(), lab.name())?;
    }
    if let Some(target) = &args.classroom50 {
        let files = of_kit(classroom50_files(lab.name(), &place, kit::program_sources(), None))?;
        write(target, &files)?;
        writeln!(out, "{}: the autograder of {}", target.display(), lab.name())?;
    }
    Ok(Answer::Yes)
}

/// Files that need the sources of the kit.
fn of_kit<T>(files: std::io::Result<T>) -> Result<T, Failure> {
    files.map_err(|error| Failure::input(format!("the sources of the kit: {error}"), "say --kit path=CHECKOUT"))
}

fn is_zip(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"))
}

/// Writes the files as an archive or a folder, as the name says.
fn write(target: &Path, files: &BTreeMap<String, Packed>) -> Result<(), Failure> {
    if is_zip(target) { save::put(target, packed(files)?.bytes) } else { folder::make(target, files) }
}

/// One archive of the files.
fn packed(files: &BTreeMap<String, Packed>) -> Result<Packed, Failure> {
    let bytes = zipped(files).map_err(Failure::kit)?;
    Ok(Packed { bytes, executable: false })
}
