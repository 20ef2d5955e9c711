//! `course.toml`: which labs a course has, what they are worth, when they are due, and what lateness costs.
//!
//! ```toml
//!   title = "Computational geometry"
//!   utc_offset = "+02:00"                    # the clock of times that do not name one
//!
//!   [late]                                   # for all labs; [lab.late] is for one
//!   every = "day"                            # or "hour"; one that has begun counts
//!   takes = "10 %"                           # of what was earned; or takes_points = 5
//!   most = "1/2"
//!   closes_after = 5
//!   grace_minutes = 15
//!
//!   [[lab]]
//!   name = "04-half-edge"
//!   weight = 2
//!   due = 2026-10-12T23:59:00
//!   secret = "secret/04.toml"
//!   total = 99.5
//!   test.face_walk = { points = 7.5, visibility = "after_due_date", needs = [] }
//! ```
//!
//! Nothing is built to read it: the manifests of the labs are compiled in. What it says of a lab is put into the
//! lab's manifest, so all that grades or lists labs obeys it.
//!
//! ```text
//!   read.rs   the file, with the place of what is wrong in it      late.rs   what lateness costs
//!   time.rs   due dates                                             share.rs  the file as others may have it
//!   gradebook.rs  all labs together
//! ```

mod gradebook;
mod late;
mod read;
#[cfg(feature = "grade")]
mod share;
mod time;

pub use gradebook::{Gradebook, GradebookError, GradedLab, LabGrade, StudentGrades};
pub use late::{Every, LateRule, Takes};
pub use read::CourseError;
#[cfg(feature = "grade")]
pub use share::{SECRET_BESIDE, SharedCourse};
pub use time::Time;

use crate::{HandedIn, Lab, Manifest, Points, Report, Secret, Verdict};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// A course.
#[derive(Clone, PartialEq, Debug)]
pub struct Course {
    /// A line for people.
    pub title: String,
    /// In the order in which they are done.
    pub labs: Vec<CourseLab>,
}

/// A lab as a course has it.
#[derive(Clone, PartialEq, Debug)]
pub struct CourseLab {
    /// As its folder is called.
    pub name: String,
    /// The manifest of the lab with what the course changes in it: points, visibility, needs, limits.
    pub manifest: Manifest,
    /// How much it counts among the labs.
    pub weight: Points,
    /// When it is due.
    pub due: Option<Time>,
    /// What lateness costs.
    pub late: Option<LateRule>,
    /// The labs that come before it.
    pub needs: Vec<String>,
    /// Nobody who handed something in gets less.
    pub least: Option<Points>,
    /// Nobody gets more.
    pub most: Option<Points>,
    /// The file of the hidden cases, and what it says.
    pub secret: Option<(PathBuf, Secret)>,
    /// What own tests are worth that catch all known mistakes.
    pub own_tests: Points,
    /// Whether the idea of the solution may be read when all is passed.
    pub idea: bool,
}

impl Course {
    /// Reads a course; the files that it names lie beside it.
    ///
    /// # Errors
    /// [`CourseError`] with file, line, column and what to write instead.
    pub fn read(file: &Path) -> Result<Self, CourseError> {
        read::course(file, true)
    }

    /// Reads a course without the secrets that it names, which a student does not have.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_for_students(file: &Path) -> Result<Self, CourseError> {
        read::course(file, false)
    }

    /// The lab of a name.
    #[must_use]
    pub fn lab(&self, name: &str) -> Option<&CourseLab> {
        self.labs.iter().find(|lab| lab.name == name)
    }
}

impl CourseLab {
    /// The lab with what the course changes in it.
    #[must_use]
    pub fn applied_to(&self, mut lab: Lab) -> Lab {
        lab.manifest = self.manifest.clone();
        lab
    }

    /// Puts what the course says into a report: points and visibility of each test, bounds, and what lateness costs.
    /// To do it twice is to do it once; so a stored report can be settled anew by a changed course.
    pub fn settle(&self, report: &mut Report) {
        for result in &mut report.tests {
            if let Some(test) = self.manifest.test(&result.name) {
                result.max_points = test.points;
                result.points = if result.verdict.is_passed() { test.points } else { Points::ZERO };
                result.visibility = test.visibility;
            }
        }
        if let Some(own) = &mut report.terms.own_tests {
            own.be_worth(self.own_tests);
        }
        let earned = report.earned();
        let due = report.terms.handed_in.as_ref().and_then(|handed_in| handed_in.due.as_ref());
        let due = due.and_then(|due| due.parse().ok()).or(self.due);
        let late = |(rule, (handed_in, due)): (&LateRule, (&HandedIn, Time))| rule.cost(earned, handed_in, due);
        report.terms.late = self.late.as_ref().zip(report.terms.handed_in.as_ref().zip(due)).and_then(late);
        (report.terms.least, report.terms.most) = (self.least, self.most);
        // The grader's own fault is no grade, and neither is nothing.
        if report.verdict == Verdict::GraderFault {
            report.terms.least = None;
        }
    }

    /// When a file was changed last, for want of anything better.
    #[must_use]
    pub fn by_file_time(&self, changed: SystemTime) -> Option<HandedIn> {
        let at = Time::of_system(changed, self.due?);
        let known_from = "the time of the file, for want of a better one: copying a file can change it".to_owned();
        Some(HandedIn { at: Some(at.to_string()), known_from, ..HandedIn::default() })
    }

    /// What the name tells that a course system gave to what was handed in.
    #[must_use]
    pub fn by_course_system(marked_late: bool) -> HandedIn {
        HandedIn { marked_late, known_from: "the mark of the course system".to_owned(), ..HandedIn::default() }
    }

    /// A time that somebody wrote, by the clock of the course.
    ///
    /// # Errors
    /// What is no time, as a sentence.
    pub fn by_list(&self, at: &str, due: Option<&str>) -> Result<HandedIn, String> {
        let time = |text: &str| -> Result<String, String> {
            let time: Time = text.parse()?;
            Ok(self.due.map_or(time, |due| time.by_clock_of(due)).to_string())
        };
        let due = due.map(str::trim).filter(|due| !due.is_empty()).map(time).transpose()?;
        Ok(HandedIn { at: Some(time(at)?), due, known_from: "the list of times".to_owned(), marked_late: false })
    }

    /// When it was handed in, by the `submission_metadata.json` of Gradescope. A student whose due date is another one
    /// than that of the assignment keeps it.
    ///
    /// # Errors
    /// What is missing there, as a sentence.
    pub fn by_gradescope(&self, metadata: &str) -> Result<HandedIn, String> {
        let metadata: serde_json::Value = serde_json::from_str(metadata).map_err(|error| error.to_string())?;
        let at = metadata["created_at"].as_str().ok_or("it has no `created_at`")?;
        let of_all = metadata["assignment"]["due_date"].as_str();
        let users = metadata["users"].as_array().map_or(&[][..], Vec::as_slice);
        // Of a group, the last date counts.
        let own = users.iter().filter_map(|user| user["assignment"]["due_date"].as_str());
        let own = own.filter(|own| Some(*own) != of_all).filter_map(|own| Some((own.parse::<Time>().ok()?, own)));
        let own = own.reduce(|a, b| if a.0.seconds_after(b.0) >= 0 { a } else { b }).map(|(_, own)| own);
        let known_from = "the metadata of Gradescope".to_owned();
        Ok(HandedIn { known_from, ..self.by_list(at, own)? })
    }
}
