//! Comma-separated values for a spreadsheet, one row for each submission.
//!
//! A cell that begins with `=`, `+`, `-`, `@` (also the wide ones), a tab or a line break gets an apostrophe in front,
//! because a spreadsheet would take it for a formula, and the name of a submission is chosen by its author. Blanks
//! before such a sign do not help: spreadsheets pass over them.
//!
//! Where the grader failed there are no points, because that is no grade: the cell is empty.

use super::{rows::rows, words};
use crate::Report;

/// The points of every test, the total and the named bugs of each submission.
pub(super) fn write(reports: &[Report]) -> String {
    let mut head = vec!["submission", "verdict", "points", "max_points"];
    // Reports of one lab have the same tests; one that was stored by an older version may have others.
    let mut tests: Vec<&str> = Vec::new();
    for test in reports.iter().flat_map(|r| &r.tests) {
        if !tests.contains(&test.name.as_str()) {
            tests.push(&test.name);
        }
    }
    head.extend(&tests);
    head.extend(["adjustments", "bugs", "message", "notes", "similar", "seed", "lab_version", "kit"]);
    let row = |report: &Report| {
        let mut row = vec![
            words::author(report),
            report.verdict.to_string(),
            words::points_or_nothing(report),
            report.max_points().to_string(),
        ];
        row.extend(tests.iter().map(|name| {
            report.tests.iter().find(|t| t.name == *name).map_or_else(String::new, |t| t.points.to_string())
        }));
        let adjustments: Vec<String> =
            report.all_adjustments().iter().map(|a| format!("{}: {:+}", a.reason, a.points)).collect();
        let bugs: Vec<String> =
            super::bugs::count(std::slice::from_ref(report)).into_iter().map(|(bug, _)| bug).collect();
        let message = report.message.as_deref().and_then(|m| m.lines().next()).unwrap_or_default();
        row.extend([
            adjustments.join("; "),
            bugs.join("; "),
            message.to_owned(),
            report.notes.join("; "),
            words::similar(report).join("; "),
            report.seed.to_string(),
            report.lab_version.clone(),
            report.kit.clone(),
        ]);
        row
    };
    rows(&head, reports.iter().map(row).collect())
}
