//! The file of a course, as it is written, and the checks of it.

use super::late::{Every, LateRule, Takes};
use super::time::Time;
use super::{Course, CourseLab};
use crate::manifest::LimitsTable;
use crate::toml_file::{ManifestError, TomlFile};
use crate::{Lab, LabError, Manifest, Points, Secret, Visibility};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::value::Datetime;

/// Why there is no course.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CourseError {
    /// The file cannot be read.
    #[error("{}: {error}", path.display())]
    Unreadable {
        /// Which.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// Something in it, or in a file that it names, is wrong.
    #[error(transparent)]
    Wrong(#[from] ManifestError),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: String,
    utc_offset: Option<Spanned<String>>,
    late: Option<Spanned<LateTable>>,
    #[serde(default)]
    lab: Vec<Spanned<LabTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LabTable {
    name: Spanned<String>,
    weight: Option<Spanned<Points>>,
    due: Option<Spanned<Datetime>>,
    late: Option<Spanned<LateTable>>,
    #[serde(default)]
    needs: Vec<Spanned<String>>,
    least: Option<Spanned<Points>>,
    most: Option<Spanned<Points>>,
    secret: Option<Spanned<String>>,
    own_tests: Option<Spanned<Points>>,
    idea: Option<bool>,
    total: Option<Spanned<Points>>,
    limits: Option<Spanned<LimitsTable>>,
    #[serde(default)]
    test: BTreeMap<Spanned<String>, TestTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TestTable {
    points: Option<Spanned<Points>>,
    visibility: Option<Visibility>,
    needs: Option<Vec<Spanned<String>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LateTable {
    every: Every,
    takes: Option<Spanned<Points>>,
    takes_points: Option<Spanned<Points>>,
    most: Option<Spanned<Points>>,
    closes_after: Option<u32>,
    #[serde(default)]
    grace_minutes: u32,
}

/// Reads a course; without its secrets if these are not at hand.
pub(super) fn course(path: &Path, with_secrets: bool) -> Result<Course, CourseError> {
    let unreadable = |error| CourseError::Unreadable { path: path.to_owned(), error };
    let text = std::fs::read_to_string(path).map_err(unreadable)?;
    let source = path.display().to_string();
    let toml = TomlFile { text: &text, source: &source };
    let file: File = toml.read()?;
    let reader =
        Reader { toml, folder: path.parent().unwrap_or(Path::new("")), clock: clock(toml, &file)?, with_secrets };
    let late = file.late.as_ref().map(|late| reader.late(late)).transpose()?;
    if file.lab.is_empty() {
        return Err(toml
            .error(0, "the course has no lab; write `[[lab]]` and below it `name = \"04-half-edge\"`")
            .into());
    }
    let mut labs: Vec<CourseLab> = Vec::new();
    for table in &file.lab {
        let lab = reader.lab(table, &labs, late.as_ref())?;
        labs.push(lab);
    }
    Ok(Course { title: file.title, labs })
}

/// How far the clock of the course is ahead of UTC, in minutes.
fn clock(toml: TomlFile, file: &File) -> Result<Option<i16>, ManifestError> {
    let Some(written) = &file.utc_offset else { return Ok(None) };
    let text = written.get_ref();
    let number =
        |text: &str, below: i16| text.parse::<i16>().ok().filter(|n| text.len() == 2 && (0..below).contains(n));
    let parts = text.strip_prefix('-').map(|rest| (-1, rest)).or_else(|| text.strip_prefix('+').map(|rest| (1, rest)));
    let minutes = parts.and_then(|(sign, rest)| {
        let (hours, minutes) = rest.split_once(':')?;
        Some(sign * (number(hours, 15)? * 60 + number(minutes, 60)?))
    });
    match minutes {
        Some(minutes) => Ok(Some(minutes)),
        None => Err(toml.error(written.span().start, format!("{text:?} is no clock; write utc_offset = \"+02:00\""))),
    }
}

struct Reader<'a> {
    toml: TomlFile<'a>,
    folder: &'a Path,
    clock: Option<i16>,
    with_secrets: bool,
}

impl Reader<'_> {
    fn error<T>(&self, at: &Spanned<T>, what: impl Into<String>) -> ManifestError {
        self.toml.error(at.span().start, what)
    }

    fn lab(
        &self,
        table: &Spanned<LabTable>,
        earlier: &[CourseLab],
        late: Option<&LateRule>,
    ) -> Result<CourseLab, ManifestError> {
        let LabTable { name: written, needs, .. } = table.get_ref();
        let table = table.get_ref();
        let lab = Lab::bundled(written.get_ref()).map_err(|error| match error {
            LabError::Manifest(error) => error,
            other => self.error(written, other.to_string()),
        })?;
        let name = lab.name.clone();
        if earlier.iter().any(|other| other.name == name) {
            return Err(self.error(written, format!("{name} was given before; a lab stands in a course once")));
        }
        for need in needs {
            if !earlier.iter().any(|other| other.name == *need.get_ref()) {
                let known: Vec<&str> = earlier.iter().map(|other| other.name.as_str()).collect();
                let known = if known.is_empty() {
                    "it is the first".to_owned()
                } else {
                    format!("there is {}", known.join(", "))
                };
                let what = format!("{name} needs {}, which is no earlier lab of the course; {known}", need.get_ref());
                return Err(self.error(need, what));
            }
        }
        let manifest = self.manifest(table, &lab.manifest)?;
        self.total(table, &manifest, &lab.manifest)?;
        let weight = self.not_negative(table.weight.as_ref())?.unwrap_or_else(|| Points::from(1));
        let [least, most] = [&table.least, &table.most].map(|bound| self.not_negative(bound.as_ref()));
        let (least, most) = (least?, most?);
        if let (Some(low), Some(high), Some(at)) = (least, most, &table.most)
            && high < low
        {
            return Err(self.error(at, format!("most = {high} is below least = {low}; exchange them")));
        }
        let due = table
            .due
            .as_ref()
            .map(|due| Time::new(due.get_ref(), self.clock).map_err(|what| self.error(due, format!("due: {what}"))));
        let own_late = table.late.as_ref().map(|late| self.late(late)).transpose()?;
        if let (Some(late), None) = (&table.late, &table.due) {
            return Err(
                self.error(late, format!("{name} has a late rule and no due date; write `due = 2026-10-12T23:59:00`"))
            );
        }
        let secret =
            table.secret.as_ref().filter(|_| self.with_secrets).map(|secret| self.secret(secret, &lab)).transpose()?;
        Ok(CourseLab {
            manifest,
            weight,
            due: due.transpose()?,
            late: own_late.or_else(|| late.cloned()),
            needs: needs.iter().map(|need| need.get_ref().clone()).collect(),
            least,
            most,
            secret,
            own_tests: self.not_negative(table.own_tests.as_ref())?.unwrap_or_default(),
            idea: table.idea.unwrap_or(true),
            name,
        })
    }

    /// The lab's manifest with what the course changes.
    fn manifest(&self, table: &LabTable, of_lab: &Manifest) -> Result<Manifest, ManifestError> {
        let mut manifest = of_lab.clone();
        for (written, change) in &table.test {
            let name = written.get_ref();
            let Some(place) = manifest.tests.iter().position(|test| test.name == *name) else {
                let known: Vec<&str> = of_lab.tests.iter().map(|test| test.name.as_str()).collect();
                let what = format!("{} has no test `{name}`; there is {}", of_lab.name, known.join(", "));
                return Err(self.error(written, what));
            };
            for need in change.needs.iter().flatten() {
                if !manifest.tests[..place].iter().any(|test| test.name == *need.get_ref()) {
                    let what = format!("{name} needs {}, which is no earlier test of the lab", need.get_ref());
                    return Err(self.error(need, what));
                }
            }
            let points = self.not_negative(change.points.as_ref())?;
            let test = &mut manifest.tests[place];
            test.points = points.unwrap_or(test.points);
            test.visibility = change.visibility.unwrap_or(test.visibility);
            if let Some(needs) = &change.needs {
                test.needs = needs.iter().map(|need| need.get_ref().clone()).collect();
            }
        }
        if let Some(limits) = &table.limits {
            manifest.limits = limits.get_ref().over(manifest.limits);
            if !LimitsTable::can_run(&manifest.limits) {
                return Err(self.error(limits, "a limit is not above 0; nothing could run"));
            }
        }
        Ok(manifest)
    }

    /// The points of the graded tests have the sum that is said, or that of the lab.
    fn total(&self, table: &LabTable, manifest: &Manifest, of_lab: &Manifest) -> Result<(), ManifestError> {
        let (sum, total) =
            (manifest.max_points(), table.total.as_ref().map_or(of_lab.max_points(), |total| *total.get_ref()));
        if sum == total {
            return Ok(());
        }
        let last =
            table.test.iter().filter(|(_, change)| change.points.is_some()).map(|(name, _)| name.span().start).max();
        let at = table.total.as_ref().map(|total| total.span().start).or(last).unwrap_or_default();
        let (name, [sum, total]) = (&of_lab.name, [sum, total].map(Points::written));
        let what = format!(
            "the points of the tests of {name} are {sum} together, not {total}; change a test's points, or write \
             `total = {sum}`"
        );
        Err(self.toml.error(at, what))
    }

    fn late(&self, table: &Spanned<LateTable>) -> Result<LateRule, ManifestError> {
        let LateTable { every, takes, takes_points, most, closes_after, grace_minutes } = table.get_ref();
        let share = |share: &Spanned<Points>| {
            let value = *share.get_ref();
            if (Points::ZERO..=Points::from(1)).contains(&value) {
                return Ok(value);
            }
            let what =
                format!("{value} is no share: write \"10 %\" or \"1/10\"; `takes_points = {value}` takes points");
            Err(self.error(share, what))
        };
        let takes = match (takes, takes_points) {
            (Some(takes), None) => Takes::Share(share(takes)?),
            (None, Some(points)) => Takes::Points(self.not_negative(Some(points))?.unwrap_or_default()),
            _ => return Err(self.error(table, "a late rule has `takes = \"10 %\"` or `takes_points = 5`, one of them")),
        };
        let most = most.as_ref().map(share).transpose()?;
        Ok(LateRule { every: *every, takes, most, closes_after: *closes_after, grace_minutes: *grace_minutes })
    }

    fn secret(&self, written: &Spanned<String>, lab: &Lab) -> Result<(PathBuf, Secret), ManifestError> {
        let file = self.folder.join(written.get_ref());
        let text = std::fs::read_to_string(&file).map_err(|error| {
            let what =
                format!("the secret {}: {error}; write a file with a line `seed = NUMBER` there", file.display());
            self.error(written, what)
        })?;
        let weighted = lab.judge().map_or(&[][..], |judge| judge.weighted());
        let secret = Secret::parse(&text, &file.display().to_string(), weighted)?;
        Ok((file, secret))
    }

    fn not_negative(&self, points: Option<&Spanned<Points>>) -> Result<Option<Points>, ManifestError> {
        match points {
            Some(points) if *points.get_ref() < Points::ZERO => {
                Err(self.error(points, format!("{} is below 0; write 0 or more", points.get_ref())))
            }
            points => Ok(points.map(|points| *points.get_ref())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    const GOOD: &str = r#"
title = "Geometry"
utc_offset = "+02:00"

[late]
every = "day"
takes = "1/10"

[[lab]]
name = "half-edge"
weight = 2.5
due = 2026-10-12T23:59:00
secret = "hidden.toml"
own_tests = "20/3"
idea = false
least = 10
most = 105
[lab.limits]
seconds = 9.5
[lab.test]
face_walk = { points = "22/3", visibility = "after_due_date" }
face_vertices = { points = "14/3" }
destination_by_next = { needs = ["destination_by_twin"] }
"#;

    fn read(text: &str) -> Result<Course, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("course.toml");
        fs::write(&file, text).unwrap();
        fs::write(folder.path().join("hidden.toml"), "seed = 5\nsplit_face = 3\n").unwrap();
        fs::write(folder.path().join("bad.toml"), "seed = 5\nsplit_faces = 3\n").unwrap();
        let place = format!("{}/", folder.path().display());
        course(&file, true).map_err(|error| error.to_string().replace(&place, ""))
    }

    #[test]
    fn a_course_changes_a_lab_without_building_anything() {
        let course = read(GOOD).unwrap();
        let lab = course.lab("04-half-edge").unwrap();
        let points = |name: &str| lab.manifest.test(name).unwrap().points;
        assert_eq!((points("face_walk"), points("face_vertices")), ("22/3".parse().unwrap(), "14/3".parse().unwrap()));
        assert_eq!(lab.manifest.max_points(), 100);
        assert_eq!(lab.manifest.test("face_walk").unwrap().visibility, Visibility::AfterDueDate);
        assert_eq!(lab.manifest.test("destination_by_next").unwrap().needs, ["destination_by_twin"]);
        assert_eq!((lab.manifest.limits.seconds, lab.manifest.limits.cpu_seconds), (9.5, 2));
        assert_eq!(lab.due.unwrap().to_string(), "2026-10-12 23:59:00+02:00");
        assert_eq!(lab.secret.as_ref().unwrap().1.weight("split_face"), 3);
        assert_eq!((lab.least, lab.most, lab.idea), (Some(10.into()), Some(105.into()), false));
        assert_eq!((lab.weight, lab.own_tests), ("2.5".parse().unwrap(), "20/3".parse().unwrap()));
        assert_eq!(lab.late.as_ref().unwrap().takes, Takes::Share("10 %".parse().unwrap()));
    }

    #[test]
    fn being_late_may_take_points_in_place_of_a_share() {
        let rule =
            |takes: &str| read(&GOOD.replace("takes = \"1/10\"", takes)).map(|mut course| course.labs.remove(0).late);
        assert_eq!(rule("takes_points = 2.5").unwrap().unwrap().takes, Takes::Points("2.5".parse().unwrap()));
        let both = rule("takes = \"1/10\"\ntakes_points = 2.5").unwrap_err();
        assert!(both.starts_with("course.toml:5:1: ") && both.contains("one of them"), "{both}");
        let below = rule("takes_points = -1").unwrap_err();
        assert!(below.starts_with("course.toml:7:16: ") && below.contains("below 0"), "{below}");
    }

    #[test]
    fn the_course_of_the_instructors_chapter_is_one() {
        let chapter = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../labs/README.md");
        let chapter = fs::read_to_string(chapter).unwrap();
        let text = chapter.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
        let lab = &read(text).unwrap().labs[0];
        assert_eq!((lab.name.as_str(), lab.manifest.max_points()), ("04-half-edge", 100.into()));
        assert!(read(&text.replace("# secret = \"secret/04.toml\"", "secret = \"hidden.toml\"")).is_ok());
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place_and_a_way_out() {
        let changed = |from: &str, to: &str| {
            assert!(GOOD.contains(from), "{from}");
            read(&GOOD.replace(from, to)).map(|_| ()).unwrap_err()
        };
        for (from, to, place, words) in [
            ("half-edge", "half-edges", "course.toml:10:8: ", "there is no lab `half-edges`; choose one of "),
            ("face_walk", "face_walks", "course.toml:21:1: ", "has no test `face_walks`; there is face_walk, "),
            ("22/3", "23/3", "course.toml:22:1: ", "04-half-edge are \"301/3\" together, not 100;"),
            ("2026-10-12T23", "2026-13-12T23", "course.toml:12:7: ", "month between 01 and 12"),
            ("2026-10-12T23", "2026-02-30T23", "course.toml:12:", ""),
            ("due = 2026-10-12T23:59:00", "due = 23:59:00", "course.toml:12:7: ", "the day is missing"),
            ("due = 2026-10-12T23:59:00", "due = \"tomorrow\"", "course.toml:12:7: ", ""),
            ("utc_offset = \"+02:00\"", "", "course.toml:12:7: ", "write 2026-10-12T23:59:00+02:00"),
            ("+02:00", "CEST", "course.toml:3:14: ", "write utc_offset = \"+02:00\""),
            ("weight", "wieght", "course.toml:11:1: ", "unknown field `wieght`"),
            ("weight = 2.5", "weight = -1", "course.toml:11:10: ", "below 0"),
            ("takes = \"1/10\"", "takes = 10", "course.toml:7:9: ", "write \"10 %\""),
            ("takes = \"1/10\"", "", "course.toml:5:1: ", "takes_points"),
            ("every = \"day\"", "every = \"week\"", "course.toml:6:9: ", "unknown variant `week`"),
            ("\"20/3\"", "\"20/17\"", "course.toml:14:13: ", "are no points; write 8, 7.5"),
            ("most = 105", "most = 5", "course.toml:17:8: ", "below least = 10"),
            ("hidden.toml", "no.toml", "course.toml:13:10: ", "`seed = NUMBER`"),
            ("hidden.toml", "bad.toml", "bad.toml:2:1: ", "unknown key `split_faces`"),
            ("seconds = 9.5", "seconds = 0", "course.toml:18:1: ", "a limit is not above 0"),
            ("destination_by_twin", "split_face_1", "course.toml:23:34: ", "is no earlier test"),
            ("least = 10", "needs = [\"03-hulls\"]", "course.toml:16:10: ", "no earlier lab of the course"),
            ("title", "titel", "course.toml:2:1: ", "unknown field `titel`"),
            ("[[lab]]", "[lab]", "course.toml:", ""),
        ] {
            let error = changed(from, to);
            assert!(error.starts_with(place) && error.contains(words), "{to}: {error}");
        }
        let twice = read(&format!("{GOOD}\n[[lab]]\nname = \"04\"\n")).unwrap_err();
        assert!(twice.starts_with("course.toml:26:8: 04-half-edge was given before"), "{twice}");
        assert!(read("title = \"x\"\n").unwrap_err().contains("write `[[lab]]`"));
        assert_eq!(
            read(&GOOD.replace("22/3", "23/3").replace("least", "total = \"301/3\"\nleast")).map(|_| ()),
            Ok(())
        );
    }
}
