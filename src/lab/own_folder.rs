//! Grading the folder in which a student works, on the student's own machine.
//!
//! ```text
//!   cargo test      ┐                                                    ┌ the same report
//!   dcel lab check  ┼─▶ take in ▸ scan ▸ pristine tree ▸ build ▸ judge ──┤
//!   dcel grade      ┘   what is handed in, and nothing else              └ in the sandbox, too
//! ```
//!
//! What stands in the folder besides is not handed in, so it is not judged: an own module, a change of a given file, a
//! dependency. The notes say so, at the first check and not after the deadline.

use super::submission::{Built, Intake, Toolchain, Tree, USUAL_BUILD, build, take_in};
use super::task::OwnMachine;
use super::{Driver, Lab, LabFiles, Plan, Report, Verdict, grade_program};
use dcel_kit::files::ScratchFolder;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The manifest of a student's folder.
const MANIFEST: &str = "Cargo.toml";

/// What came of a folder.
#[derive(Clone, PartialEq, Debug)]
pub struct FolderCheck {
    /// The verdicts, those that the grader would give.
    pub report: Report,
    /// What in the folder will not be handed in, a sentence each.
    pub notes: Vec<String>,
}

impl FolderCheck {
    /// Why nothing could be judged, if that is the fault of the kit or of the machine and not of the student.
    #[must_use]
    pub fn set_up_fault(&self) -> Option<&str> {
        self.report.message.as_deref().filter(|_| self.report.verdict == Verdict::GraderFault)
    }
}

/// Grades a student's folder as a grader would: only the files that the lab grades are taken, scanned, and built with
/// the given files that are compiled into the kit. `work` is a folder for the build; it is made if it is not there.
///
/// The program runs with limits but without a sandbox: it is the student's own. Never panics; a fault of the machine (no
/// toolchain, no room) is a report with [`Verdict::GraderFault`].
///
/// Cost: one compilation of a small program, then as [`grade_program`].
#[must_use]
pub fn check_folder(lab: &Lab, folder: &Path, work: &Path, plan: &Plan) -> FolderCheck {
    Workbench { work: work.to_owned(), again: false, place: None, toolchain: None }.check(lab, folder, plan)
}

/// A place to check folders in again and again, a lab each time the same: what the compiler made for one check it uses
/// for the next, so a check after a small change takes a third of the time. The verdicts are those of [`check_folder`].
///
/// What was made is removed when this is dropped; if the process is killed, by the next check.
#[derive(Debug)]
pub struct Workbench {
    work: PathBuf,
    again: bool,
    /// Where the last check was built.
    place: Option<ScratchFolder>,
    toolchain: Option<Toolchain>,
}

impl Workbench {
    /// A workbench in the folder `work`, which is made if it is not there.
    #[must_use]
    pub fn new(work: &Path) -> Self {
        Self { work: work.to_owned(), again: true, place: None, toolchain: None }
    }

    /// As [`check_folder`].
    #[must_use]
    pub fn check(&mut self, lab: &Lab, folder: &Path, plan: &Plan) -> FolderCheck {
        FolderCheck { report: self.report(lab, folder, plan), notes: not_handed_in(lab, folder) }
    }

    fn report(&mut self, lab: &Lab, folder: &Path, plan: &Plan) -> Report {
        let stopped = |verdict: Verdict, message: String| {
            let report = Report::untested(&lab.manifest, verdict, message);
            Report { seed: plan.seed, ..report }
        };
        let intake = match take_in(&lab.manifest, folder) {
            Ok(intake) => intake,
            Err(error) => return stopped(error.verdict(), error.to_string()),
        };
        let toolchain = match self.toolchain.take().map_or_else(Toolchain::installed, Ok) {
            Ok(toolchain) => self.toolchain.insert(toolchain).clone(),
            Err(why) => return stopped(Verdict::GraderFault, why),
        };
        let tree = match self.lay(lab, &intake) {
            Ok(tree) => tree,
            Err(error) => {
                let work = self.work.display();
                return stopped(Verdict::GraderFault, format!("{work}: no folder to build in: {error}"));
            }
        };
        match build(&tree, &toolchain, USUAL_BUILD, &OwnMachine) {
            Built::Program(program) => grade_program(lab, &Driver::new(program, lab.manifest.limits), plan),
            Built::Not { verdict, message } => stopped(verdict, message),
        }
    }

    fn lay(&mut self, lab: &Lab, intake: &Intake) -> io::Result<Tree> {
        // The first time; or somebody has cleaned up.
        if self.place.as_ref().is_none_or(|place| !place.path().exists()) {
            fs::create_dir_all(&self.work)?;
            self.place = Some(ScratchFolder::beside(&std::path::absolute(&self.work)?.join("tree"))?);
        }
        let room = self.place.as_ref().map(|place| place.path().join("room")).unwrap_or_default();
        if self.again {
            Tree::lay_again(room, lab, intake, &OwnMachine)
        } else {
            Tree::lay(room, lab, intake, &OwnMachine)
        }
    }
}

/// What differs from the folder that was given, and will not be handed in.
fn not_handed_in(lab: &Lab, folder: &Path) -> Vec<String> {
    let graded = &lab.manifest.graded;
    let only = match &graded[..] {
        [one] => format!("only {one} is handed in"),
        several => format!("only {} are handed in", several.join(", ")),
    };
    let given = |path: &str| path.starts_with("src/") && !graded.iter().any(|file| file == path);
    let mut notes = Vec::new();
    let repository = LabFiles::of_repository(folder);
    let file = |path: &str| match &repository {
        Some(files) => files.get(path).map(str::to_owned),
        None => fs::read_to_string(folder.join(path)).ok(),
    };
    for (path, text) in lab.files.iter().filter(|(path, _)| given(path)) {
        match file(path) {
            Some(there) if there.lines().eq(text.lines()) => {}
            Some(_) => notes.push(format!("{path} differs from the given one; {only}")),
            None => notes.push(format!("{path} cannot be read; the given one is used")),
        }
    }
    let known = |path: &str| lab.files.get(path).is_some() || graded.iter().any(|file| file == path);
    let mut own = Vec::new();
    sources(&folder.join("src"), "src", &mut own);
    own.sort();
    notes.extend(own.iter().filter(|path| !known(path)).map(|path| format!("{path} is not part of the lab; {only}")));
    let manifest = fs::read_to_string(folder.join(MANIFEST)).unwrap_or_default();
    let manifest: toml::Table = manifest.parse().unwrap_or_default();
    if let Some(crates) = manifest.get("dependencies").and_then(toml::Value::as_table).filter(|table| !table.is_empty())
    {
        let names: Vec<&str> = crates.keys().map(String::as_str).collect();
        notes.push(format!(
            "{MANIFEST} asks for {}; only the standard library is there when it is graded",
            names.join(", ")
        ));
    }
    notes
}

/// The paths of the Rust files in a folder, a few levels deep.
fn sources(folder: &Path, prefix: &str, found: &mut Vec<String>) {
    const DEEPEST: usize = 6;
    for entry in fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok) {
        let path = format!("{prefix}/{}", entry.file_name().to_string_lossy());
        match entry.file_type() {
            Ok(kind) if kind.is_dir() && path.matches('/').count() < DEEPEST => sources(&entry.path(), &path, found),
            Ok(kind) if !kind.is_dir() && path.ends_with(".rs") => found.push(path),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A student's folder with the given files of lab 04.
    fn given() -> (Lab, tempfile::TempDir) {
        let lab = Lab::bundled("04").unwrap();
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in lab.files.iter().filter(|(path, _)| path.starts_with("src/")) {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        (lab, folder)
    }

    #[test]
    fn what_is_not_handed_in_is_said_and_nothing_else() {
        let (lab, folder) = given();
        let notes = || not_handed_in(&lab, folder.path());
        assert_eq!(notes(), [""; 0]);
        let write = |path: &str, text: &str| fs::write(folder.path().join(path), text).unwrap();
        write("src/lab.rs", "fn mine() {}\n");
        write("src/lab.rs.1.bak", "");
        write("src/svg.rs", &lab.files.get("src/svg.rs").unwrap().replace('\n', "\r\n"));
        write("Cargo.toml", "[package]\nname = \"x\"\n[dependencies]\n[dev-dependencies]\na = \"1\"\n");
        assert_eq!(notes(), [""; 0], "own work, line ends and tests' crates are nobody's business");
        write("src/dcel.rs", "mod changed;\n");
        write("src/helper.rs", "");
        fs::remove_file(folder.path().join("src/pen.rs")).unwrap();
        write("Cargo.toml", "[package]\nname = \"x\"\n[dependencies]\nrand = \"0.9\"\n");
        assert_eq!(
            notes(),
            [
                "src/dcel.rs differs from the given one; only src/lab.rs is handed in",
                "src/pen.rs cannot be read; the given one is used",
                "src/helper.rs is not part of the lab; only src/lab.rs is handed in",
                "Cargo.toml asks for rand; only the standard library is there when it is graded",
            ]
        );
    }

    #[test]
    fn a_folder_without_the_file_is_not_the_graders_fault() {
        let lab = Lab::bundled("04").unwrap();
        let folder = tempfile::tempdir().unwrap();
        let check = check_folder(&lab, folder.path(), &folder.path().join("target"), &Plan::with_seed(1));
        assert_eq!((check.report.verdict, check.set_up_fault()), (Verdict::Refused, None));
        assert!(check.report.message.unwrap().contains("there is no src/lab.rs"));
    }
}
