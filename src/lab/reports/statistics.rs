//! What a class makes of each test: how many pass, what they earn, which known mistakes they make.
//!
//! Those who handed in nothing do not count, and neither do faults of the grader: they say nothing of a test. What does
//! not compile counts as not passed.

use super::html::escaped;
use super::rows::rows;
use crate::{Points, Report, Verdict};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// What a class makes of one test.
#[derive(Default)]
struct Row<'a> {
    name: &'a str,
    title: &'a str,
    task: u32,
    graded: usize,
    passed: usize,
    earned: Points,
    most: Points,
    verdicts: BTreeMap<Verdict, usize>,
    /// The known mistakes that were named in it, the most frequent first, with how many have them.
    mistakes: Vec<(&'a str, usize)>,
}

impl Row<'_> {
    fn mean(&self) -> f64 {
        self.earned.as_f64() / self.graded.max(1) as f64
    }

    fn share(&self) -> f64 {
        self.passed as f64 / self.graded.max(1) as f64
    }

    /// The share of the points that was not earned: 0 is easy, 1 is hard.
    fn difficulty(&self) -> f64 {
        1.0 - self.earned.as_f64() / self.most.as_f64().max(f64::MIN_POSITIVE)
    }

    fn most(&self) -> f64 {
        self.most.as_f64() / self.graded.max(1) as f64
    }
}

fn counts(report: &Report) -> bool {
    let is_missing = report.verdict == Verdict::Unattempted && report.message.is_some();
    report.verdict != Verdict::GraderFault && !is_missing
}

fn table(reports: &[Report]) -> Vec<Row<'_>> {
    let counted = || reports.iter().filter(|report| counts(report));
    let mut seen = BTreeSet::new();
    let tests = counted().flat_map(|report| &report.tests).filter(|test| seen.insert(test.name.as_str()));
    tests.map(|test| row_of(&test.name, reports)).collect()
}

fn row_of<'a>(name: &str, reports: &'a [Report]) -> Row<'a> {
    let mut row = Row::default();
    let mut mistakes: BTreeMap<&str, usize> = BTreeMap::new();
    let counted = reports.iter().filter(|report| counts(report));
    for test in counted.flat_map(|report| &report.tests).filter(|test| test.name == name) {
        (row.name, row.title, row.task) = (&test.name, &test.title, test.task);
        row.graded += 1;
        row.passed += usize::from(test.verdict.is_passed());
        row.earned = row.earned + test.points;
        row.most = row.most + test.max_points;
        *row.verdicts.entry(test.verdict).or_default() += 1;
        for bug in &test.bugs {
            *mistakes.entry(bug).or_default() += 1;
        }
    }
    row.mistakes = mistakes.into_iter().collect();
    row.mistakes.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    row
}

/// The name of a column, and what stands in it.
type Column = (&'static str, fn(&Row) -> String);

/// The columns of a file, each with what a test has there.
const COLUMNS: [Column; 11] = [
    ("test", |row| row.name.to_owned()),
    ("title", |row| row.title.to_owned()),
    ("task", |row| row.task.to_string()),
    ("submissions", |row| row.graded.to_string()),
    ("passed", |row| row.passed.to_string()),
    ("pass_share", |row| format!("{:.3}", row.share())),
    ("mean_points", |row| format!("{:.3}", row.mean())),
    ("max_points", |row| format!("{:.3}", row.most())),
    ("difficulty", |row| format!("{:.3}", row.difficulty())),
    ("verdicts", |row| {
        row.verdicts.iter().map(|(verdict, count)| format!("{verdict} {count}")).collect::<Vec<_>>().join("; ")
    }),
    ("known_mistakes", |row| {
        row.mistakes.iter().map(|(name, count)| format!("{count} x {name}")).collect::<Vec<_>>().join("; ")
    }),
];

/// A row for each test.
pub(super) fn write(reports: &[Report]) -> String {
    let row = |row: &Row| COLUMNS.iter().map(|(_, cell)| cell(row)).collect();
    rows(&COLUMNS.map(|(name, _)| name), table(reports).iter().map(row).collect())
}

/// The same as a section of the page of a class.
pub(super) fn section(out: &mut String, reports: &[Report]) {
    let table = table(reports);
    let Some(graded) = table.iter().map(|row| row.graded).max() else { return };
    let _ = write!(
        out,
        "<h2>Tests</h2>\n<p>Of {graded} submissions that were graded. Difficulty is the share of the points that was not \
         earned.</p>\n<table class=\"class\"><thead><tr><th scope=\"col\">test</th><th scope=\"col\">passed</th>\
         <th scope=\"col\">mean points</th><th scope=\"col\">difficulty</th><th scope=\"col\">known mistakes</th></tr>\
         </thead>\n<tbody>\n"
    );
    for row in &table {
        let mistakes: Vec<String> =
            row.mistakes.iter().map(|(name, count)| format!("{count} × {}", escaped(name))).collect();
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{}</th><td>{} of {} ({:.0} %)</td><td>{:.2} of {}</td><td>{:.2}</td><td>{}</td></tr>",
            escaped(row.name),
            row.passed,
            row.graded,
            row.share() * 100.0,
            row.mean(),
            (row.most() * 1000.0).round() / 1000.0,
            row.difficulty(),
            mistakes.join("<br>"),
        );
    }
    out.push_str("</tbody></table>\n");
}
