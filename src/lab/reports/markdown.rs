//! A summary for a page of a code host, such as a step summary: Markdown without pictures, cut below a mebibyte.

use super::{open_to_the_student, words};
use crate::Report;
use std::fmt::Write;

/// Code hosts take less than 1 MiB.
const LONGEST: usize = 1_000_000;

/// One submission.
pub(super) fn one(report: &Report) -> String {
    let mut out = format!("## {}: {} points\n\n", report.lab, words::points(report));
    submission(&mut out, report);
    cut(out)
}

/// A table of the class, then each submission.
pub(super) fn class(reports: &[Report]) -> String {
    if let [report] = reports {
        return one(report);
    }
    let mut out = String::from("| submission | points | verdict |\n|---|---:|---|\n");
    for report in reports {
        let _ = writeln!(out, "| {} | {} | {} |", cell(&words::author(report)), words::points(report), report.verdict);
    }
    let alike: Vec<&Report> = reports.iter().filter(|report| !report.similar.is_empty()).collect();
    if !alike.is_empty() {
        let _ = write!(out, "\n{}\n\n", words::LOOK_ALIKE);
        for report in alike {
            let similar = words::similar(report).join(", ");
            let _ = writeln!(out, "- {}: {}", cell(&words::author(report)), cell(&similar));
        }
    }
    for report in reports {
        let _ = write!(out, "\n## {}: {} points\n\n", cell(&words::author(report)), words::points(report));
        submission(&mut out, report);
    }
    cut(out)
}

fn submission(out: &mut String, report: &Report) {
    if let Some(message) = &report.message {
        let _ = writeln!(out, "**{}**\n", report.verdict);
        fenced(out, message);
    }
    if let Some(next) = words::next(report).filter(|_| report.message.is_none()) {
        let _ = writeln!(out, "{}. Next: {}.\n", words::standing(report), cell(&next));
    }
    out.push_str("| test | verdict | points |\n|---|---|---:|\n");
    for test in &report.tests {
        let title = cell(&test.title);
        let _ =
            writeln!(out, "| `{}` {title} | {} | {} of {} |", test.name, test.verdict, test.points, test.max_points);
    }
    for adjustment in report.all_adjustments() {
        let _ = writeln!(out, "| {} | | {:+} |", cell(&adjustment.reason), adjustment.points);
    }
    if report.message.is_none() {
        for test in report.tests.iter().filter(|t| !t.verdict.is_passed() && open_to_the_student(t)) {
            let _ = write!(out, "\n### {}: {}\n\n", test.name, test.verdict);
            fenced(out, &words::of_test(test));
        }
    }
    let _ = write!(out, "\n{}\n", words::circumstances(report).join(" "));
}

/// A block of code around any text: the fence is longer than every row of backticks in it.
fn fenced(out: &mut String, text: &str) {
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    let _ = write!(out, "{fence}text\n{}\n{fence}\n\n", words::clean(text.trim_end()));
}

/// A text for a cell of a table or a heading: one line, nothing in it is Markdown or HTML.
fn cell(text: &str) -> String {
    let mut out = String::new();
    for c in words::line(text).chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '&' => out.push_str("&amp;"),
            '|' | '`' | '*' | '_' | '[' | ']' | '\\' | '#' | '!' => out.extend(['\\', c]),
            c => out.push(c),
        }
    }
    out
}

fn cut(mut out: String) -> String {
    const REST: &str = "\n\n(The rest is left out: a summary may not be longer.)\n";
    if out.len() > LONGEST {
        let mut end = LONGEST - REST.len();
        while !out.is_char_boundary(end) {
            end -= 1;
        }
        out.truncate(end);
        out.push_str(REST);
    }
    out
}
