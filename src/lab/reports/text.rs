//! For a terminal: a line for each test, then what is to be mended.

use super::words;
use crate::Report;
use std::fmt::Write;

/// The widest verdict, in characters.
const VERDICT: usize = 16;

/// One submission.
pub(super) fn one(report: &Report) -> String {
    let (author, points) = (words::author(report), words::points(report));
    let mut out = format!("{}: {author}, {points} points, {}\n", report.lab, words::standing(report));
    if let Some(next) = words::next(report).filter(|_| report.message.is_none()) {
        let _ = writeln!(out, "Next: {next}.");
    }
    for line in words::circumstances(report) {
        let _ = writeln!(out, "{line}");
    }
    if let Some(message) = &report.message {
        let _ = write!(out, "\n{}: {}\n", report.verdict, words::clean(message.trim_end()));
        let _ = writeln!(out, "Next: {}", report.verdict.next_action());
    }
    let mut task = None;
    for test in &report.tests {
        if task != Some(test.task) {
            task = Some(test.task);
            let _ = write!(out, "\ntask {}\n", test.task);
        }
        let points = format!("{}/{}", test.points, test.max_points);
        let _ = writeln!(out, "  {:VERDICT$} {points:>5}  {}", test.verdict.word(), test.name);
    }
    for adjustment in report.all_adjustments() {
        let _ = writeln!(out, "  {:+} points: {}", adjustment.points, adjustment.reason);
    }
    if report.message.is_none() {
        for test in report.tests.iter().filter(|t| !t.verdict.is_passed()) {
            let _ = write!(out, "\n{}: {}, {}\n", test.name, test.verdict, test.title);
            indented(&mut out, &words::of_test(test));
            if let Some(picture) = &test.picture {
                indented(&mut out, &picture.ascii);
            }
        }
    }
    if !report.printed.is_empty() {
        out.push_str("\nYour program printed:\n");
        indented(&mut out, &report.printed);
    }
    for (name, text) in &report.attachments {
        let _ = write!(out, "\n{}:\n", words::clean(name));
        indented(&mut out, text);
    }
    out
}

/// A line for each submission, then the named bugs.
pub(super) fn class(reports: &[Report]) -> String {
    if let [report] = reports {
        return one(report);
    }
    let widest = reports.iter().map(|r| words::author(r).chars().count()).max().unwrap_or(0).min(32);
    let mut out = String::new();
    for report in reports {
        let points = format!("{}/{}", report.points(), report.max_points());
        let _ = writeln!(out, "{:widest$}  {points:>9}  {}", words::author(report), words::standing(report));
    }
    let bugs = super::bugs::count(reports);
    if !bugs.is_empty() {
        out.push_str("\nNamed bugs, and how many have them:\n");
        for (bug, authors) in &bugs {
            let _ = writeln!(out, "{:>5}  {bug}", authors.len());
        }
    }
    let alike: Vec<&Report> = reports.iter().filter(|report| !report.similar.is_empty()).collect();
    if !alike.is_empty() {
        let _ = write!(out, "\n{}\n", words::LOOK_ALIKE);
        for report in alike {
            let _ = writeln!(out, "  {}: {}", words::author(report), words::similar(report).join(", "));
        }
    }
    out
}

fn indented(out: &mut String, text: &str) {
    for line in words::clean(text).lines() {
        let _ = writeln!(out, "  {line}");
    }
}
