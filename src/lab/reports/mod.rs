//! Reports written in the formats that students, instructors and course systems read.
//!
//! ```text
//!                    ┌─ one submission: text html markdown json   gradescope classroom50 exercism
//!   Report(s) ───────┤
//!                    └─ a class:        text html markdown json   junit csv bugs statistics
//! ```
//!
//! Every format is written from the same plain data. A report is written whatever became of the submission: one
//! that does not compile has the message, every test, and no points. What students may read never says more about
//! a hidden test than that it exists and what it gave.
//!
//! The bytes depend on the reports alone, and the only time in them is the one that Gradescope asks for.

mod bugs;
mod class_page;
mod classroom;
mod exercism;
mod gradescope;
mod html;
mod junit;
mod markdown;
mod rows;
mod sheet;
mod statistics;
mod text;
mod words;

pub(super) use rows::rows;

use super::{Report, TestResult, Visibility};

dcel_kit::named! {
    /// A form in which reports can be written.
    #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
    #[non_exhaustive]
    pub enum Format {
        /// For a terminal.
        Text = "text",
        /// One page without anything from outside, pictures in it.
        Html = "html",
        /// A summary for a page of a code host, without pictures.
        Markdown = "markdown",
        /// The reports themselves, from which every other format can be written again.
        Json = "json",
        /// `results.json` of Gradescope.
        Gradescope = "gradescope",
        /// `result.json` of Classroom 50.
        Classroom50 = "classroom50",
        /// `results.json` of an exercism test runner, version 3.
        Exercism = "exercism",
        /// JUnit XML, a suite for each submission.
        Junit = "junit",
        /// A row for each submission, for a spreadsheet.
        Csv = "csv",
        /// A row for each named bug with how many have it, for a spreadsheet.
        Bugs = "bugs",
        /// A row for each test with what the class makes of it, for a spreadsheet.
        Statistics = "statistics",
    }

    /// Its name on the command line.
    fn name as Display;
    /// All formats.
    const ALL;
}

impl Format {
    /// The format of that name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// Whether one file can hold a whole class.
    #[must_use]
    pub fn holds_a_class(self) -> bool {
        !matches!(self, Self::Gradescope | Self::Classroom50 | Self::Exercism)
    }

    /// Writes one submission.
    ///
    /// Cost: linear in the size of the report.
    #[must_use]
    pub fn one(self, report: &Report) -> String {
        match self {
            Self::Json => pretty(report),
            _ => self.write(std::slice::from_ref(report)),
        }
    }

    /// Writes a class, in the order given.
    ///
    /// Cost: linear in the size of the reports.
    ///
    /// # Errors
    /// The formats that course systems read one submission at a time, see [`holds_a_class`](Self::holds_a_class).
    pub fn class(self, reports: &[Report]) -> Result<String, OneAtATime> {
        if self.holds_a_class() { Ok(self.write(reports)) } else { Err(OneAtATime(self)) }
    }

    fn write(self, reports: &[Report]) -> String {
        match self {
            Self::Gradescope => reports.iter().map(gradescope::write).collect(),
            Self::Classroom50 => reports.iter().map(classroom::write).collect(),
            Self::Exercism => reports.iter().map(exercism::write).collect(),
            Self::Text => text::class(reports),
            Self::Html => class_page::class(reports),
            Self::Markdown => markdown::class(reports),
            Self::Json => pretty(&reports),
            Self::Junit => junit::write(reports),
            Self::Csv => sheet::write(reports),
            Self::Bugs => bugs::write(reports),
            Self::Statistics => statistics::write(reports),
        }
    }
}

/// A class was to be written in a format for one submission.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
#[error("a {0} file holds one submission; write one each, with {{submission}} in the name of the file")]
pub struct OneAtATime(pub Format);

/// A page of a class with links to a page for each submission, in the order of the reports. `total` is how many
/// there will be: until then the page says that some are missing.
///
/// Cost: linear in the size of the reports. What only the linked pages tell may be left out of them, see
/// [`Report::without_details`].
#[must_use]
pub fn index(reports: &[Report], pages: &[String], total: usize) -> String {
    class_page::index(reports, pages, total)
}

/// Whether the author of a submission may read what the test found.
fn open_to_the_student(test: &TestResult) -> bool {
    test.visibility == Visibility::Visible
}

/// JSON with two spaces of indentation and a line break at its end.
fn pretty<T: serde::Serialize + ?Sized>(value: &T) -> String {
    // Plain structures with text keys: there is nothing that JSON could not hold.
    let mut text = serde_json::to_string_pretty(value).unwrap_or_else(|e| format!("\"{e}\""));
    text.push('\n');
    text
}
