//! One page that needs nothing from outside and no script: for a student, or for a whole class.
//!
//! ```text
//!   ┌──────────────────────────────────┐
//!   │ anna: 62 of 100 points           │  class: a row each, linked to the section below
//!   │ Next: task 5, step 3 …           │
//!   ├──────────────────────────────────┤
//!   │ ✗ split_face, step 3 …           │  what failed: one sentence, the pictures, the rest folded
//!   │   [before] [expected] [yours]    │
//!   │ Still to do                      │  what is to be written, what waits for something else
//!   │ ▸ ✓ 9 tests passed, 52 points    │  one folded line
//!   └──────────────────────────────────┘
//! ```
//!
//! Pictures are images with the SVG in their address: their ids cannot collide, and nothing in them can reach the
//! page. They follow dark mode as the page does, share one scale, and are never shown so small that their letters could
//! not be read: a narrow screen scrolls them. "Enlarge" shows one alone, by its place on the page.

use super::words;
use crate::{Picture, Points, Report, TestResult, Verdict};
use std::fmt::Write;

const CSS: &str = include_str!("html.css");

/// The page of one submission.
pub(super) fn one(report: &Report) -> String {
    let title = format!("{}: {}", report.lab, words::author(report));
    let mut body = String::new();
    submission(&mut body, report, 0, true);
    document(&title, &body)
}

pub(super) fn submission(out: &mut String, report: &Report, number: usize, alone: bool) {
    let heading = if alone { "h1" } else { "h2" };
    let _ = writeln!(
        out,
        "<section id=\"s{number}\">\n<{heading}>{}: {} points</{heading}>",
        escaped(&words::author(report)),
        words::points(report),
    );
    let next = words::next(report).filter(|_| report.message.is_none());
    let next = next.map_or_else(String::new, |next| format!(" Next: {}.", escaped(&next)));
    let _ = writeln!(out, "<p class=\"next\">{}{next}</p>", standing(report));
    if let Some(message) = &report.message {
        let _ = writeln!(out, "<pre>{}</pre>\n<p>{}</p>", escaped(message), report.verdict.next_action());
    } else {
        for (i, test) in report.tests.iter().enumerate().filter(|(_, test)| is_told(test)) {
            failed(out, test, &format!("s{number}-t{i}"), if alone { "h2" } else { "h3" });
        }
    }
    let (passed, open): (Vec<_>, Vec<_>) = report
        .tests
        .iter()
        .filter(|test| report.message.is_some() || !is_told(test))
        .partition(|test| test.verdict.is_passed());
    if !open.is_empty() {
        let title = if report.message.is_some() { "Not graded" } else { "Still to do" };
        table(out, &format!("<caption>{title}</caption>"), &open);
    }
    if !passed.is_empty() {
        let points: Points = passed.iter().map(|test| test.points).sum();
        let tests = if passed.len() == 1 { "test" } else { "tests" };
        let _ = writeln!(
            out,
            "<details class=\"passed\"><summary><span class=\"yes\">✓ {} {tests} passed</span>, {points} points</summary>",
            passed.len(),
        );
        table(out, "", &passed);
        out.push_str("</details>\n");
    }
    for adjustment in report.all_adjustments() {
        let _ = writeln!(out, "<p>{:+} points: {}</p>", adjustment.points, escaped(&adjustment.reason));
    }
    let printed = ("What the program printed".to_owned(), report.printed.clone());
    let printed = Some(&printed).filter(|(_, text)| !text.is_empty());
    for (name, text) in report.attachments.iter().chain(printed) {
        let _ = writeln!(out, "<details><summary>{}</summary><pre>{}</pre></details>", escaped(name), escaped(text));
    }
    let _ = writeln!(out, "<p class=\"small\">{}</p>\n</section>", escaped(&words::circumstances(report).join(" ")));
}

/// Whether a test has a part of its own on the page: the code was run, and something is wrong.
fn is_told(test: &TestResult) -> bool {
    !matches!(test.verdict, Verdict::Passed | Verdict::Skipped | Verdict::Unattempted)
}

/// Tests of which there is little to say.
fn table(out: &mut String, caption: &str, tests: &[&TestResult]) {
    let _ = writeln!(
        out,
        "<table>{caption}<thead><tr><th scope=\"col\">test</th><th scope=\"col\">verdict</th><th scope=\"col\">points</th></tr></thead>\n<tbody>"
    );
    for test in tests {
        let message = if test.message.is_empty() || test.verdict == Verdict::Unattempted {
            String::new()
        } else {
            format!("<br><small>{}</small>", escaped(&test.message))
        };
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{}<br><small>{}</small></th><td>{}{message}</td><td>{} of {}</td></tr>",
            escaped(&test.title),
            escaped(&test.name),
            sign(test.verdict),
            test.points,
            test.max_points,
        );
    }
    out.push_str("</tbody></table>\n");
}

/// A test that failed: what happened in one sentence, what the failing cases have in common, the pictures; the rest
/// is folded.
fn failed(out: &mut String, test: &TestResult, id: &str, heading: &str) {
    let _ = writeln!(
        out,
        "<article id=\"{id}\">\n<{heading}>{}</{heading}>\n<p class=\"small\">{} · {} of {} points · {}</p>",
        escaped(&test.title),
        sign(test.verdict),
        test.points,
        test.max_points,
        escaped(&test.name),
    );
    let place = test.place.as_ref().map_or_else(String::new, |at| format!(" At <code>{}</code>.", escaped(at)));
    if !test.message.is_empty() || !place.is_empty() {
        let _ = writeln!(out, "<p class=\"what\">{}{place}</p>", escaped(&test.message));
    }
    if let Some(pattern) = &test.pattern {
        let _ = writeln!(out, "<p class=\"bug\">{}</p>", escaped(pattern));
    }
    if !test.bugs.is_empty() {
        let _ = writeln!(out, "<p class=\"bug\">{}</p>", escaped(&words::same_failures(&test.bugs)));
    }
    if let Some(picture) = &test.picture {
        pictures(out, picture, id);
    }
    let _ = writeln!(out, "<p><strong>Next:</strong> {}</p>", test.verdict.next_action());
    if !test.findings.is_empty() {
        out.push_str("<details><summary>All that is wrong in this case</summary>\n<ul>\n");
        for finding in &test.findings {
            let (words, section) = (escaped(&finding.words), escaped(&finding.section));
            let _ = writeln!(out, "<li>{words} <small>(handout: {section})</small></li>");
        }
        out.push_str("</ul></details>\n");
    }
    if let Some(picture) = test.picture.as_ref().filter(|picture| !picture.ascii.is_empty()) {
        let ascii = escaped(&picture.ascii);
        let _ = writeln!(out, "<details><summary>The pictures as text</summary><pre>{ascii}</pre></details>");
    }
    if let Some(script) = &test.script {
        let _ = writeln!(
            out,
            "<details><summary>The shortest case that fails so</summary>\n<pre>{}</pre>",
            escaped(script)
        );
        if let Some(replay) = &test.replay {
            let _ = writeln!(out, "<p>{} <code>{}</code></p>", escaped(&words::to_replay(test)), escaped(replay));
        }
        out.push_str("</details>\n");
    }
    out.push_str("</article>\n");
}

/// The least width of a picture, in px. None is shown smaller than it was drawn: its smallest letters are of 9 px.
const LEAST: f64 = 480.0;

/// Before, expected, yours.
fn pictures(out: &mut String, picture: &Picture, id: &str) {
    let all = [("before", &picture.before), ("expected", &picture.expected), ("yours", &picture.yours)];
    let least = all.iter().map(|(_, svg)| width(svg)).fold(LEAST, f64::max);
    let _ = writeln!(out, "<div class=\"pictures\" style=\"--least:{least:.0}px\">");
    for (caption, svg) in all {
        let width = width(svg);
        let _ = writeln!(
            out,
            "<figure id=\"{id}-{caption}\"><figcaption>{caption} <a class=\"larger\" \
             href=\"#{id}-{caption}\">enlarge</a><a class=\"back\" href=\"#{id}\">back to the report</a></figcaption>\
             <img alt=\"the structure: {caption}\" width=\"{width:.0}\" src=\"data:image/svg+xml,{}\"></figure>",
            in_address(svg, b"-_.~=:/,;()")
        );
    }
    out.push_str("</div>\n");
}

/// The width that a drawing states, in px.
fn width(svg: &str) -> f64 {
    let stated = svg.split_once(" width=\"").and_then(|(_, rest)| rest.split('"').next());
    stated.and_then(|text| text.trim_end_matches("px").parse().ok()).filter(|w: &f64| w.is_finite()).unwrap_or(LEAST)
}

/// How a submission stands, with a sign.
pub(super) fn standing(report: &Report) -> String {
    let (class, sign) = class_and_sign(report.verdict);
    format!("<span class=\"{class}\">{sign} {}</span>", words::standing(report))
}

/// A verdict as a word with a sign, so that it needs no colour.
fn sign(verdict: Verdict) -> String {
    let (class, sign) = class_and_sign(verdict);
    format!("<span class=\"{class}\">{sign} {verdict}</span>")
}

fn class_and_sign(verdict: Verdict) -> (&'static str, &'static str) {
    match verdict {
        Verdict::Passed => ("yes", "✓"),
        Verdict::Unattempted | Verdict::Skipped => ("open", "○"),
        Verdict::GraderFault => ("open", "!"),
        _ => ("no", "✗"),
    }
}

/// A text as part of an address: what is neither a letter, nor a digit, nor one of `plain` by its number.
pub(super) fn in_address(text: &str, plain: &[u8]) -> String {
    let mut out = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || plain.contains(&byte) {
            out.push(char::from(byte));
        } else {
            let _ = write!(out, "%{byte:02x}");
        }
    }
    out
}

pub(super) fn document(title: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>\n{CSS}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        escaped(title)
    )
}

/// The text with the characters that HTML reserves as entities, and nothing that steers a reader's screen.
pub(super) fn escaped(text: &str) -> String {
    dcel_kit::figure::escaped(&words::clean(text))
}
