//! Lists of the class: names, and points that a person gives or takes.
//!
//! ```text
//!   submission,name            submission,points,reason
//!   s1234,Anna Arndt           s1234,5,answers
//!   s1235,Ben Bach             s1235,-10,two days late
//! ```

use super::super::{Failure, failure};
use dcel_kit::lab::{Adjustment, Lab, Report, Verdict};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::path::Path;

/// The lists of a run.
#[derive(Debug, Default)]
pub(super) struct Lists {
    names: Vec<Name>,
    adjustments: Vec<Points>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Name {
    submission: String,
    name: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Points {
    submission: String,
    points: i32,
    reason: String,
}

impl Lists {
    pub(super) fn read(names: Option<&Path>, adjust: Option<&Path>) -> Result<Self, Failure> {
        Ok(Self {
            names: names.map_or(Ok(Vec::new()), |file| rows(file, "submission,name"))?,
            adjustments: adjust.map_or(Ok(Vec::new()), |file| rows(file, "submission,points,reason"))?,
        })
    }

    /// Adds what is missing, gives and takes points, then puts names for submissions.
    pub(super) fn apply(&self, lab: &Lab, reports: &mut Vec<Report>) -> Result<(), Failure> {
        for name in &self.names {
            if !reports.iter().any(|report| is_of(report, &name.submission)) {
                let mut missing = Report::untested(&lab.manifest, Verdict::Unattempted, "Nothing was handed in.");
                missing.submission = Some(name.submission.clone());
                reports.push(missing);
            }
        }
        for given in &self.adjustments {
            let Some(report) = reports.iter_mut().find(|report| is_of(report, &given.submission)) else {
                let what = format!("there are points for `{}`, but no such submission", given.submission);
                return Err(Failure::input(what, "write it as the file or folder is called"));
            };
            report.adjustments.push(Adjustment { reason: given.reason.clone(), points: given.points });
        }
        if self.names.is_empty() {
            return Ok(());
        }
        for report in reports {
            match self.names.iter().find(|name| is_of(report, &name.submission)) {
                Some(name) => report.submission = Some(name.name.clone()),
                None => failure::say("note", format_args!("{} is not in the list of names", named(report))),
            }
        }
        Ok(())
    }
}

fn is_of(report: &Report, submission: &str) -> bool {
    report.submission.as_deref() == Some(submission)
}

fn named(report: &Report) -> &str {
    report.submission.as_deref().unwrap_or("a submission")
}

fn rows<T: DeserializeOwned>(file: &Path, columns: &str) -> Result<Vec<T>, Failure> {
    let help = format!("write a first line `{columns}`, then a line for each");
    let cannot = |error: csv::Error| Failure::input(format!("{}: {error}", file.display()), &help);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(file).map_err(cannot)?;
    reader.deserialize().map(|row| row.map_err(cannot)).collect()
}
