//! Lists of the class: names, and points that a person gives or takes.
//!
//! ```text
//!   submission,name            submission,points,reason
//!   s1234,Anna Arndt           s1234,5,answers
//!   s1235,Ben Bach             s1235,-10,two days late
//! ```
//!
//! And times, by which a course counts lateness; `due` is for who has a date of their own, and may be left out:
//!
//! ```text
//!   submission,handed_in,due
//!   s1234,2026-10-13T01:30:00+02:00,2026-10-14T23:59:00+02:00
//! ```
//!
//! Everything in them is checked before the first submission is graded.

use super::super::{Failure, failure};
use dcel_lab::course::CourseLab;
use dcel_lab::{Adjustment, HandedIn, Lab, Report, Verdict};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::path::Path;

/// The lists of a run.
#[derive(Debug, Default)]
pub(super) struct Lists {
    names: Vec<Name>,
    adjustments: Vec<Points>,
    times: Vec<(String, HandedIn)>,
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
    points: dcel_lab::Points,
    reason: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct TimeOf {
    submission: String,
    handed_in: String,
    #[serde(default)]
    due: Option<String>,
}

/// What the lists say, submission by submission.
#[derive(Debug)]
pub(super) struct Resolved {
    /// The names in the reports, in the order of the submissions; no two are equal.
    pub(super) names: Vec<String>,
    adjustments: Vec<Vec<Adjustment>>,
    /// Those in the list of names who handed in nothing.
    missing: Vec<(String, Vec<Adjustment>)>,
    times: Vec<Option<HandedIn>>,
}

impl Lists {
    pub(super) fn read(names: Option<&Path>, adjust: Option<&Path>) -> Result<Self, Failure> {
        let names: Vec<Name> = names.map_or(Ok(Vec::new()), |file| rows(file, "submission,name"))?;
        for (i, name) in names.iter().enumerate() {
            if names[..i].iter().any(|earlier| earlier.submission == name.submission) {
                let what = format!("the list of names has `{}` twice", name.submission);
                return Err(Failure::input(what, "keep one of the lines"));
            }
        }
        let adjustments = adjust.map_or(Ok(Vec::new()), |file| rows(file, "submission,points,reason"))?;
        Ok(Self { names, adjustments, times: Vec::new() })
    }

    /// With a list of times, for a lab of a course.
    pub(super) fn with_times(mut self, file: &Path, lab: &CourseLab) -> Result<Self, Failure> {
        for row in rows::<TimeOf>(file, "submission,handed_in")? {
            let handed_in = lab.by_list(&row.handed_in, row.due.as_deref()).map_err(|what| {
                let what = format!("{}: {}: {what}", file.display(), row.submission);
                Failure::input(what, "write the time with its clock: 2026-10-12T23:59:00+02:00")
            })?;
            if self.times.iter().any(|(name, _)| *name == row.submission) {
                let what = format!("{}: `{}` is there twice", file.display(), row.submission);
                return Err(Failure::input(what, "keep the line that counts"));
            }
            self.times.push((row.submission, handed_in));
        }
        Ok(self)
    }

    /// Finds for each line the submission it means. `own` are the submissions' own names; `is_called(i, name)` says
    /// whether a list may mean submission `i` by a name.
    pub(super) fn resolve(&self, own: &[&str], is_called: impl Fn(usize, &str) -> bool) -> Result<Resolved, Failure> {
        let find = |name: &str| -> Result<Option<usize>, Failure> {
            if let Some(i) = own.iter().position(|own| *own == name) {
                return Ok(Some(i));
            }
            let mut found = (0..own.len()).filter(|&i| is_called(i, name));
            match (found.next(), found.next()) {
                (Some(one), Some(other)) => {
                    let what = format!("`{name}` in a list may be {} or {}", own[one], own[other]);
                    Err(Failure::input(what, "write it as the report of the class does"))
                }
                (found, _) => Ok(found),
            }
        };
        let mut resolved = Resolved {
            names: own.iter().map(|&name| name.to_owned()).collect(),
            adjustments: vec![Vec::new(); own.len()],
            missing: Vec::new(),
            times: vec![None; own.len()],
        };
        let mut listed = vec![false; own.len()];
        for name in &self.names {
            match find(&name.submission)? {
                Some(i) if listed[i] => {
                    let what = format!("two lines of the list of names mean {}", own[i]);
                    return Err(Failure::input(what, "keep one of them"));
                }
                Some(i) => {
                    listed[i] = true;
                    resolved.names[i].clone_from(&name.name);
                }
                None => resolved.missing.push((name.name.clone(), Vec::new())),
            }
        }
        for given in &self.adjustments {
            let adjustment = Adjustment { reason: given.reason.clone(), points: given.points };
            let missing = |name: &&Name| name.submission == given.submission;
            match (find(&given.submission)?, self.names.iter().find(missing)) {
                (Some(i), _) => resolved.adjustments[i].push(adjustment),
                (None, Some(name)) => {
                    let place = resolved.missing.iter_mut().find(|(missing, _)| *missing == name.name);
                    place.into_iter().for_each(|(_, adjustments)| adjustments.push(adjustment.clone()));
                }
                (None, None) => {
                    let what = format!("there are points for `{}`, but no such submission", given.submission);
                    return Err(Failure::input(what, "write it as the file or folder is called"));
                }
            }
        }
        for (name, handed_in) in &self.times {
            let what = || format!("there is a time for `{name}`, but no such submission");
            let i = find(name)?.ok_or_else(|| Failure::input(what(), "write it as the file or folder is called"))?;
            resolved.times[i] = Some(handed_in.clone());
        }
        resolved.tell_apart(own);
        for (name, _) in own.iter().zip(listed).filter(|(_, listed)| !listed && !self.names.is_empty()) {
            failure::say("note", format_args!("{name} is not in the list of names"));
        }
        Ok(resolved)
    }
}

impl Resolved {
    /// Two people may have one name: then what they handed in tells them apart.
    fn tell_apart(&mut self, own: &[&str]) {
        let mut times: BTreeMap<String, usize> = BTreeMap::new();
        for name in &self.names {
            *times.entry(name.clone()).or_default() += 1;
        }
        for (name, own) in self.names.iter_mut().zip(own) {
            if times[name] > 1 && name != own {
                *name = format!("{name} ({own})");
            }
        }
    }

    /// Puts the name of submission `i` into its report, and gives and takes points. Points that a stored report has
    /// already are not given twice.
    pub(super) fn apply(&self, i: usize, report: &mut Report) {
        report.submission = Some(self.names[i].clone());
        for adjustment in &self.adjustments[i] {
            if report.adjustments.contains(adjustment) {
                let what = format!("{} has `{}` already", self.names[i], adjustment.reason);
                failure::say("note", format_args!("{what}: the points are not counted twice"));
            } else {
                report.adjustments.push(adjustment.clone());
            }
        }
    }

    /// The time that a list says for submission `i`.
    pub(super) fn time(&self, i: usize) -> Option<HandedIn> {
        self.times[i].clone()
    }

    /// The reports of those who handed in nothing.
    pub(super) fn missing(&self, lab: &Lab) -> Vec<Report> {
        let one = |(name, adjustments): &(String, Vec<Adjustment>)| {
            let report = Report::untested(&lab.manifest, Verdict::Unattempted, "Nothing was handed in.");
            Report { submission: Some(name.clone()), adjustments: adjustments.clone(), ..report }
        };
        self.missing.iter().map(one).collect()
    }
}

fn rows<T: DeserializeOwned>(file: &Path, columns: &str) -> Result<Vec<T>, Failure> {
    let help = format!("write a first line `{columns}`, then a line for each");
    let cannot = |error: csv::Error| Failure::input(format!("{}: {error}", file.display()), &help);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(file).map_err(cannot)?;
    reader.deserialize().map(|row| row.map_err(cannot)).collect()
}
