//! What a course says of the lab that is graded, and when each submission was handed in.
//!
//! ```text
//!   a list of times ▷ the metadata of Gradescope ▷ Canvas' mark in the name ▷ the time of the file, which is said
//! ```

use super::super::Failure;
use super::super::input::text_of;
use super::Args;
use super::lists::{Lists, Resolved};
use dcel_lab::course::{Course, CourseLab};
use dcel_lab::{HandedIn, Lab, Points, Report, Secret, Submission};
use std::path::{Path, PathBuf};

/// The terms of a course; without one, nothing changes.
#[derive(Debug, Default)]
pub(super) struct Terms {
    lab: Option<CourseLab>,
    metadata: Option<HandedIn>,
}

impl Terms {
    /// Reads the course that the call names.
    pub(super) fn read(args: &Args, lab: &Lab) -> Result<Self, Failure> {
        let Some(file) = &args.course else { return Ok(Self::default()) };
        let course = course(file)?;
        let known: Vec<&str> = course.labs.iter().map(|lab| lab.name.as_str()).collect();
        let of_course = course.lab(&lab.name).cloned().ok_or_else(|| {
            let what = format!("{}: the course has no lab {}", file.display(), lab.name);
            Failure::input(what, format!("add a `[[lab]]` with its name, or grade one of {}", known.join(", ")))
        })?;
        if of_course.due.is_none() && (args.metadata.is_some() || args.times.is_some()) {
            let what = format!("{}: {} has no due date, so no time matters", file.display(), lab.name);
            return Err(Failure::input(what, "write `due = 2026-10-12T23:59:00` below its name"));
        }
        let metadata = args.metadata.as_deref().map(|file| metadata(file, &of_course)).transpose()?;
        Ok(Self { lab: Some(of_course), metadata })
    }

    /// The lab as the course has it.
    pub(super) fn applied_to(&self, lab: Lab) -> Lab {
        match &self.lab {
            Some(of_course) => of_course.applied_to(lab),
            None => lab,
        }
    }

    /// The lists with the times of the call.
    pub(super) fn lists(&self, lists: Lists, times: Option<&Path>) -> Result<Lists, Failure> {
        match (times, &self.lab) {
            (Some(times), Some(lab)) => lists.with_times(times, lab),
            _ => Ok(lists),
        }
    }

    /// The hidden cases of the course, and their file.
    pub(super) fn secret(&self) -> Option<&(PathBuf, Secret)> {
        self.lab.as_ref()?.secret.as_ref()
    }

    /// When submission `i` was handed in.
    pub(super) fn when(&self, lists: &Resolved, i: usize, submission: &Submission) -> Option<HandedIn> {
        let lab = self.lab.as_ref().filter(|lab| lab.due.is_some())?;
        let by_file = || lab.by_file_time(submission.changed(&lab.manifest.graded)?);
        let by_name = || submission.marked_late().map(CourseLab::by_course_system);
        lists.time(i).or_else(|| self.metadata.clone()).or_else(by_name).or_else(by_file)
    }

    /// Puts the terms into a report.
    pub(super) fn settle(&self, report: &mut Report, when: Option<HandedIn>) {
        let Some(lab) = &self.lab else { return };
        if when.is_some() {
            report.terms.handed_in = when;
        }
        const UNKNOWN: &str = "when it was handed in is not known, so lateness is not counted";
        report.notes.retain(|note| note != UNKNOWN);
        if lab.due.is_some() && report.terms.handed_in.is_none() {
            report.notes.push(UNKNOWN.to_owned());
        }
        lab.settle(report);
    }

    /// Points for own tests need the known mistakes.
    pub(super) fn check_own_tests(&self) -> Result<(), Failure> {
        match &self.lab {
            Some(lab) if lab.own_tests > Points::ZERO => {
                let what = format!("the course gives {} points for own tests of {}", lab.own_tests, lab.name);
                Err(Failure::input(
                    what,
                    "add --own DIR: the folder `labs` of a checkout, which has the known mistakes",
                ))
            }
            _ => Ok(()),
        }
    }

    /// One file of metadata tells of one submission.
    pub(super) fn check_count(&self, count: usize) -> Result<(), Failure> {
        if self.metadata.is_some() && count != 1 {
            let help = "grade one submission with --metadata, or give a list of times with --times";
            return Err(Failure::input(format!("the metadata is that of one submission, and there are {count}"), help));
        }
        Ok(())
    }
}

/// A course file.
pub(crate) fn course(file: &Path) -> Result<Course, Failure> {
    Course::read(file).map_err(|error| {
        let help = "see the worked course.toml in labs/README.md";
        Failure::input(error, help)
    })
}

/// The metadata of Gradescope.
fn metadata(file: &Path, lab: &CourseLab) -> Result<HandedIn, Failure> {
    let text = text_of(file, "name submission_metadata.json")?;
    lab.by_gradescope(&text).map_err(|what| {
        let what = format!("{}: {what}", file.display());
        Failure::input(what, "name the submission_metadata.json that Gradescope wrote")
    })
}
