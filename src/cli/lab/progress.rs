//! `dcel lab` alone: how far the course is, and what comes next.
//!
//! ```text
//!   course/                 course.toml, if there is one: which labs, in which order, what they need
//!     my-lab-01/ my-lab-04/   their folders, one or two levels below; what the last `dcel lab check` said lies
//!                             in target/check/progress.json of each
//! ```

use super::super::{Answer, Failure, Output, failure, output};
use super::{folder, lab};
use dcel_lab::course::Course;
use dcel_lab::{LabFiles, Manifest, Points, Report, typed};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The file of a course.
pub(super) const COURSE: &str = "course.toml";

/// What a check said last.
#[derive(Serialize, Deserialize, Debug)]
struct Last {
    lab: String,
    points: Points,
    max_points: Points,
    passed: bool,
    /// What is to be done next; none if everything passed.
    next: Option<String>,
}

/// Remembers what a check said. If it cannot be written, the lab counts as not checked.
pub(super) fn remember(dir: &Path, report: &Report) {
    let next = report.next_test().map(|test| format!("task {}, {}", test.task, test.title));
    let (points, max_points) = (report.points(), report.max_points());
    let passed = report.verdict.is_passed();
    let last = Last { lab: report.lab.clone(), points, max_points, passed, next };
    folder::remember(dir, PROGRESS, &last);
}

const PROGRESS: &str = "progress.json";

/// The course around a place, and its file: in this folder or one above.
pub(super) fn course_above(place: &Path) -> Result<Option<(PathBuf, Course)>, Failure> {
    let Some(file) = place.ancestors().map(|above| above.join(COURSE)).find(|file| file.is_file()) else {
        return Ok(None);
    };
    let course = Course::read_for_students(&file)
        .map_err(|error| Failure::input(error, "put back the course.toml that your instructor gave you"))?;
    Ok(Some((file, course)))
}

/// A lab of the table.
struct Row {
    name: String,
    title: String,
    points: Points,
    weight: Option<Points>,
    due: Option<String>,
    needs: Vec<String>,
    dir: Option<PathBuf>,
    last: Option<Last>,
}

impl Row {
    fn has_passed(&self) -> bool {
        self.last.as_ref().is_some_and(|last| last.passed)
    }

    /// The labs that must be passed before this one, of those that are not.
    fn waits_for<'a>(&'a self, rows: &'a [Self]) -> Vec<&'a str> {
        let open = |need: &&String| !rows.iter().any(|row| row.name == **need && row.has_passed());
        self.needs.iter().filter(open).map(String::as_str).collect()
    }

    fn standing(&self, rows: &[Self]) -> String {
        let waits = self.waits_for(rows);
        match (&self.last, &self.dir) {
            (Some(last), _) if last.passed => "passed".to_owned(),
            (Some(_), _) => "begun".to_owned(),
            (None, _) if !waits.is_empty() => format!("opens after {}", waits.join(", ")),
            (None, Some(_)) => "not checked yet".to_owned(),
            (None, None) => "open".to_owned(),
        }
    }

    fn earned(&self) -> String {
        let [earned, most] = match &self.last {
            Some(last) => [last.points.to_string(), last.max_points.to_string()],
            None => ["-".to_owned(), self.points.to_string()],
        };
        format!("{earned} of {most}")
    }
}

/// Tells who begins a lab, or goes on with it, which labs the course wants to be passed before; nothing is refused,
/// since they may have been passed on another machine.
pub(super) fn note_needs(lab: &str, dir: &Path) {
    let Ok(dir) = std::path::absolute(dir) else { return };
    let Ok(Some((file, course))) = course_above(&dir) else { return };
    let mut folders = Vec::new();
    labs_below(file.parent().unwrap_or(&dir), 2, &mut folders);
    let Ok(rows) = rows(Some(&course), &folders) else { return };
    let waits = rows.iter().find(|row| row.name == lab).map(|row| row.waits_for(&rows)).unwrap_or_default();
    if !waits.is_empty() {
        let which = waits.join(", ");
        failure::say("note", format_args!("in this course {lab} comes after {which}, which has not passed here yet"));
    }
}

/// Writes the table and what comes next.
pub(super) fn run(out: &mut Output) -> Result<Answer, Failure> {
    let here = std::env::current_dir().map_err(|error| Failure::input(error, "go into a folder that is there"))?;
    let course = course_above(&here)?;
    let root = match &course {
        Some((file, _)) => file.parent().map_or_else(|| here.clone(), Path::to_owned),
        // In the folder of a lab the others are beside it.
        None if here.join("lab.toml").is_file() => here.parent().map_or_else(|| here.clone(), Path::to_owned),
        None => here.clone(),
    };
    let mut folders = Vec::new();
    labs_below(&root, 2, &mut folders);
    folders.sort();
    let rows = rows(course.as_ref().map(|(_, course)| course), &folders)?;
    match &course {
        Some((_, course)) => writeln!(out, "{}, in {}", course.title, root.display())?,
        None => writeln!(out, "The labs, in {}", root.display())?,
    }
    let cells: Vec<[String; 5]> = rows
        .iter()
        .map(|row| {
            let due = row.due.as_ref().map_or_else(String::new, |due| format!("due {due}"));
            [row.name.clone(), row.earned(), row.standing(&rows), due, row.title.clone()]
        })
        .collect();
    output::table(out, &cells)?;
    if rows.iter().any(|row| row.weight.is_some()) {
        writeln!(out, "\nOf the whole course, by its weights: {:.1} %", share(&rows) * 100.0)?;
    }
    writeln!(out, "\nNext: {}", next(&rows))?;
    Ok(Answer::Yes)
}

/// What of the course is earned, from 0 to 1.
fn share(rows: &[Row]) -> f64 {
    let weight = |row: &Row| row.weight.map_or(1.0, Points::as_f64);
    let of =
        |row: &Row| row.last.as_ref().map_or(0.0, |last| last.points.as_f64() / last.max_points.as_f64().max(1e-9));
    rows.iter().map(|row| weight(row) * of(row)).sum::<f64>() / rows.iter().map(weight).sum::<f64>().max(1e-9)
}

/// What comes next: the first lab that is begun; else the first one that is open.
fn next(rows: &[Row]) -> String {
    let begun = rows.iter().find(|row| row.dir.is_some() && !row.has_passed() && row.waits_for(rows).is_empty());
    if let Some(row) = begun {
        let dir = row.dir.as_deref().map_or_else(String::new, typed);
        return match row.last.as_ref().and_then(|last| last.next.as_ref()) {
            Some(what) => format!("{}: {what}\n  cd {dir}\n  dcel lab check", row.name),
            None => format!("cd {dir}, then dcel lab check"),
        };
    }
    let open = rows.iter().find(|row| row.dir.is_none() && row.waits_for(rows).is_empty());
    match open {
        Some(row) => format!("dcel lab start {0} {0}", row.name),
        None => {
            "everything has passed. `dcel lab idea` in a lab's folder tells how others think of its solution".to_owned()
        }
    }
}

fn rows(course: Option<&Course>, folders: &[(String, PathBuf)]) -> Result<Vec<Row>, Failure> {
    let dir = |name: &str| folders.iter().find(|(lab, _)| lab == name).map(|(_, dir)| dir.clone());
    let last = |name: &str| -> Option<Last> {
        folder::remembered(&dir(name)?, PROGRESS).filter(|last: &Last| last.lab == name)
    };
    let row = |name: &str, manifest: &Manifest| Row {
        name: name.to_owned(),
        title: manifest.title.clone(),
        points: manifest.max_points(),
        weight: None,
        due: None,
        needs: Vec::new(),
        dir: dir(name),
        last: last(name),
    };
    match course {
        Some(course) => Ok(course
            .labs
            .iter()
            .map(|lab| Row {
                weight: Some(lab.weight),
                due: lab.due.map(|due| due.to_string()),
                needs: lab.needs.clone(),
                ..row(&lab.name, &lab.manifest)
            })
            .collect()),
        None => LabFiles::known_names().iter().map(|name| Ok(row(name, &lab(name)?.manifest))).collect(),
    }
}

/// The folders of labs below a place, with the names of their labs.
fn labs_below(place: &Path, levels: usize, found: &mut Vec<(String, PathBuf)>) {
    let toml = place.join("lab.toml");
    if toml.is_file() {
        let manifest = folder::read(&toml).ok().and_then(|text| Manifest::parse(&text, "lab.toml").ok());
        found.extend(manifest.map(|manifest| (manifest.name, place.to_owned())));
        return;
    }
    if levels == 0 {
        return;
    }
    for entry in fs::read_dir(place).into_iter().flatten().flatten() {
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        if !is_hidden && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            labs_below(&entry.path(), levels - 1, found);
        }
    }
}
