//! The graded tests of a lab's package: each looks up its own result in one grading run.

use super::page::page;
use super::test_text;
use crate::lab::{Driver, Lab, Plan, Report, TestResult, Verdict, grade_program};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The run of this process. A package has one lab and one driver, so there is one.
static REPORT: OnceLock<Result<Report, String>> = OnceLock::new();

/// Judges one graded test of a lab that is compiled into the kit, by the driver at `driver`.
///
/// For `tests/graded.rs`. The first call runs all cases; the others look up their result. If the environment variable
/// `LAB_DRIVER` is set, it names the driver instead. `LAB_SEED` repeats the random cases of a report.
///
/// # Panics
/// If the test is not passed, with all that there is to say about it: this is how a test fails.
#[track_caller]
pub fn graded(lab: &str, driver: &Path, test: &str) {
    let driver = std::env::var_os("LAB_DRIVER").map_or_else(|| driver.to_owned(), PathBuf::from);
    let report = REPORT.get_or_init(|| {
        let lab = Lab::bundled(lab).map_err(|error| error.to_string())?;
        let program = Driver::new(&driver, lab.manifest.limits);
        Ok(grade_program(&lab, &program, &Plan::from_environment()))
    });
    let failure = match report {
        Ok(report) => match report.tests.iter().find(|result| result.name == test) {
            Some(result) if result.verdict == Verdict::Passed => return,
            Some(result) => text(report, result, &driver),
            None => format!("{test} is no graded test of {lab}"),
        },
        Err(error) => format!("{}: {error}", Verdict::GraderFault),
    };
    panic!("\n\n{failure}");
}

/// The text, with the case and the page written beside the driver.
fn text(report: &Report, test: &TestResult, driver: &Path) -> String {
    let folder = driver.parent().and_then(Path::parent).map(|target| target.join("tmp").join(&report.lab));
    let write = |ending: &str, text: &str| {
        let folder = folder.as_ref()?;
        std::fs::create_dir_all(folder).ok()?;
        let path = folder.join(format!("{}.{ending}", test.name));
        std::fs::write(&path, text).ok()?;
        Some(path)
    };
    let case = test.script.as_ref().and_then(|script| write("case", script));
    let replay = case.map(|path| format!("cargo run -q -- {}", path.display()));
    let mut text = test_text(report, test, replay.as_deref());
    if let Some(picture) = &test.picture {
        let page = page(&format!("{}: {}", test.name, test.verdict), &text, picture);
        if let Some(path) = write("html", &page) {
            text.push_str(&format!("Pictures: {}\n", path.display()));
        }
    }
    text
}
