//! One page that needs nothing from outside and no script: for a student, or for a whole class.
//!
//! ```text
//!   ┌──────────────────────────────────┐
//!   │ anna   62 of 100   wrong         │  class: a row each, linked to the section below
//!   │ ben    …                         │
//!   ├──────────────────────────────────┤
//!   │ anna                             │
//!   │   split_face_4   wrong   0 of 6  │  a test: what happened, the bug by name, the script
//!   │   [before] [expected] [yours]    │
//!   └──────────────────────────────────┘
//! ```
//!
//! Pictures are images with the SVG in their address: their ids cannot collide, and nothing in them can reach the
//! page. They follow dark mode as the page does.

use super::words;
use crate::lab::{Report, TestResult, Verdict};
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
    let _ = writeln!(out, "<p>{}</p>", sign(report.verdict));
    if let Some(message) = &report.message {
        let _ = writeln!(out, "<pre>{}</pre>\n<p>{}</p>", escaped(message), report.verdict.next_action());
    }
    let _ = writeln!(
        out,
        "<table><caption>Tests</caption><thead><tr><th scope=\"col\">test</th><th scope=\"col\">verdict</th><th scope=\"col\">points</th></tr></thead>\n<tbody>"
    );
    for (i, test) in report.tests.iter().enumerate() {
        let told = told(report, test);
        let name =
            if told { format!("<a href=\"#s{number}-t{i}\">{}</a>", escaped(&test.name)) } else { escaped(&test.name) };
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{name}<br><small>{}</small></th><td>{}</td><td>{} of {}</td></tr>",
            escaped(&test.title),
            sign(test.verdict),
            test.points,
            test.max_points,
        );
    }
    for adjustment in &report.adjustments {
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{}</th><td></td><td>{:+}</td></tr>",
            escaped(&adjustment.reason),
            adjustment.points
        );
    }
    out.push_str("</tbody></table>\n");
    for (i, test) in report.tests.iter().enumerate().filter(|(_, test)| told(report, test)) {
        details(out, test, &format!("s{number}-t{i}"), if alone { "h2" } else { "h3" });
    }
    for (name, text) in &report.attachments {
        let _ = writeln!(out, "<details><summary>{}</summary><pre>{}</pre></details>", escaped(name), escaped(text));
    }
    if !report.printed.is_empty() {
        let _ = writeln!(
            out,
            "<details><summary>What the program printed</summary><pre>{}</pre></details>",
            escaped(&report.printed)
        );
    }
    let _ = writeln!(out, "<p class=\"small\">{}</p>\n</section>", escaped(&words::circumstances(report).join(" ")));
}

/// Whether a test has a part of its own on the page.
fn told(report: &Report, test: &TestResult) -> bool {
    report.message.is_none() && !test.verdict.is_passed() && test.verdict != Verdict::Skipped
}

fn details(out: &mut String, test: &TestResult, id: &str, heading: &str) {
    let _ =
        writeln!(out, "<article id=\"{id}\">\n<{heading}>{} {}</{heading}>", escaped(&test.name), sign(test.verdict));
    if !test.message.is_empty() {
        let _ = writeln!(out, "<p>{}</p>", escaped(&test.message));
    }
    if let Some(place) = &test.place {
        let _ = writeln!(out, "<p>at <code>{}</code></p>", escaped(place));
    }
    if !test.bugs.is_empty() {
        let _ = writeln!(out, "<p class=\"bug\">{}</p>", escaped(&words::same_failures(&test.bugs)));
    }
    if !test.findings.is_empty() {
        out.push_str("<ul>\n");
        for finding in &test.findings {
            let _ = writeln!(
                out,
                "<li><code>{}</code> {} <small>(handout: {})</small></li>",
                escaped(&finding.rule),
                escaped(&finding.words),
                escaped(&finding.section),
            );
        }
        out.push_str("</ul>\n");
    }
    if let Some(picture) = &test.picture {
        out.push_str("<div class=\"pictures\">\n");
        for (caption, svg) in [("before", &picture.before), ("expected", &picture.expected), ("yours", &picture.yours)]
        {
            let alt = format!("the structure: {caption}");
            let _ = writeln!(
                out,
                "<figure><img alt=\"{alt}\" src=\"{}\"><figcaption>{caption}</figcaption></figure>",
                address(svg)
            );
        }
        out.push_str("</div>\n");
        if !picture.ascii.is_empty() {
            let _ = writeln!(
                out,
                "<details><summary>The same as text</summary><pre>{}</pre></details>",
                escaped(&picture.ascii)
            );
        }
    }
    if let Some(script) = &test.script {
        let _ = writeln!(out, "<p>Shortest failing script:</p>\n<pre>{}</pre>", escaped(script));
    }
    if let Some(replay) = &test.replay {
        let _ = writeln!(out, "<p>Replay it: <code>{}</code></p>", escaped(replay));
    }
    let _ = writeln!(out, "<p><strong>Next:</strong> {}</p>\n</article>", test.verdict.next_action());
}

/// A verdict as a word with a sign, so that it needs no colour.
pub(super) fn sign(verdict: Verdict) -> String {
    let (class, sign) = match verdict {
        Verdict::Passed => ("yes", "✓"),
        Verdict::Unattempted | Verdict::Skipped => ("open", "○"),
        Verdict::GraderFault => ("open", "!"),
        _ => ("no", "✗"),
    };
    format!("<span class=\"{class}\">{sign} {verdict}</span>")
}

/// An SVG as the address of an image.
fn address(svg: &str) -> String {
    let mut out = String::from("data:image/svg+xml,");
    for byte in svg.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' => out.push(char::from(byte)),
            b'-' | b'_' | b'.' | b'~' | b'=' | b':' | b'/' | b',' | b';' | b'(' | b')' => out.push(char::from(byte)),
            _ => {
                let _ = write!(out, "%{byte:02x}");
            }
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
    crate::figure::page::escaped(&words::clean(text))
}
