//! The graded tests of a lab's package: each looks up its own result in one grading run.

use super::page::page;
use super::test_text;
use crate::judge::Judge;
use crate::{FolderCheck, Lab, LabFiles, Plan, Report, TestResult, Verdict, check_folder, typed};
use std::io::Write;
use std::path::Path;
use std::sync::OnceLock;

/// The run of this process. A package has one lab and one folder, so there is one.
static CHECK: OnceLock<Result<FolderCheck, String>> = OnceLock::new();

/// Judges one graded test of a lab that is compiled into the kit, in the student's folder.
///
/// For `tests/graded.rs`: `folder` is `CARGO_MANIFEST_DIR`, `work` is `CARGO_TARGET_TMPDIR`. The first call takes the
/// student's file in, builds and judges it as [`check_folder`] does, and so as a grader does; the others look up
/// their result. `LAB_SEED` repeats the random cases of a report.
///
/// # Panics
/// If the test is not passed, with all that there is to say about it: this is how a test fails.
#[track_caller]
pub fn graded(lab: &str, folder: &Path, work: &Path, test: &str) {
    judged(lab, || Lab::bundled(lab).map_err(|error| error.to_string()), folder, work, test);
}

/// [`graded`] for a lab that brings its judge along, in the folder `judges` beside the lab's files.
///
/// # Panics
/// As [`graded`].
#[track_caller]
pub fn graded_by(judge: &'static dyn Judge, judges: &Path, folder: &Path, work: &Path, test: &str) {
    let lab = || -> Result<Lab, String> {
        // In a student's folder the lab is what was handed out; in the instructor's it is what stands there.
        let archive = judges.join("lab.txt");
        let files = match std::fs::read_to_string(&archive) {
            Ok(text) => LabFiles::from_archive(&text),
            Err(_) => LabFiles::read(&judges.join("..")),
        };
        Lab::with_judge(files.map_err(|error| error.to_string())?, judge).map_err(|error| error.to_string())
    };
    judged("lab", lab, folder, work, test);
}

#[track_caller]
fn judged(name: &str, lab: impl FnOnce() -> Result<Lab, String>, folder: &Path, work: &Path, test: &str) {
    let work = work.join(name);
    let check = CHECK.get_or_init(|| {
        let lab = lab()?;
        let check = check_folder(&lab, folder, &work, &Plan::from_environment());
        // Past the harness, which shows what tests print only if they fail.
        let mut out = std::io::stderr().lock();
        for note in &check.notes {
            let _ = writeln!(out, "note: {note}");
        }
        Ok(check)
    });
    let failure = match check {
        Ok(FolderCheck { report, .. }) => match report.tests.iter().find(|result| result.name == test) {
            Some(result) if result.verdict == Verdict::Passed => return,
            Some(result) => text(report, result, &work),
            None => format!("{test} is no graded test of {}", report.lab),
        },
        Err(error) => format!("{}: {error}", Verdict::GraderFault),
    };
    panic!("\n\n{failure}");
}

/// The text, with the case and the page written into the work folder.
fn text(report: &Report, test: &TestResult, work: &Path) -> String {
    if let Some(message) = &report.message {
        return format!("{}: {}\n\n{message}\n\n{}\n", test.name, test.verdict, test.verdict.next_action());
    }
    let write = |ending: &str, text: &str| {
        std::fs::create_dir_all(work).ok()?;
        let path = work.join(format!("{}.{ending}", test.name));
        std::fs::write(&path, text).ok()?;
        Some(path)
    };
    let case = test.script.as_ref().and_then(|script| write("case", script));
    let replay = case.map(|path| format!("cargo run -q -- {}", typed(&path)));
    let mut text = test_text(report, test, replay.as_deref());
    if let Some(picture) = &test.picture {
        let page = page(&format!("{}: {}", test.name, test.verdict), &text, picture);
        if let Some(path) = write("html", &page) {
            text.push_str(&format!("Pictures: {}\n", path.display()));
        }
    }
    text
}
