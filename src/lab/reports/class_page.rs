//! The page of a class: a table, what looks alike, the named bugs, what the class
//! makes of each test, then each submission or links to their pages.
//!
//! ```text
//!   anna   62 of 100   wrong      a row each, linked to a section below or to a page of its own
//!   ben    …
//! ```

use super::html::{document, escaped, in_address, one, standing, submission};
use super::{bugs, statistics, words};
use crate::Report;
use std::fmt::Write;

/// The page of a class.
pub(super) fn class(reports: &[Report]) -> String {
    if let [report] = reports {
        return one(report);
    }
    let lab = reports.first().map_or("lab", |r| r.lab.as_str());
    let mut body = format!("<h1>{}: {} submissions</h1>\n", escaped(lab), reports.len());
    table(&mut body, reports, |i| format!("#s{i}"));
    similar(&mut body, reports, |i| format!("#s{i}"));
    named_bugs(&mut body, reports);
    statistics::section(&mut body, reports);
    for (i, report) in reports.iter().enumerate() {
        submission(&mut body, report, i, false);
    }
    document(&format!("{lab}: {} submissions", reports.len()), &body)
}

/// A page of a class that links to a page for each submission, `total` of which there will be.
pub(super) fn index(reports: &[Report], pages: &[String], total: usize) -> String {
    let lab = reports.first().map_or("lab", |r| r.lab.as_str());
    let title = format!("{lab}: {} of {total} submissions", reports.len());
    let mut body = format!("<h1>{}</h1>\n", escaped(&title));
    if reports.len() < total {
        body.push_str("<p>Not all are graded yet: the same command goes on where it stopped.</p>\n");
    }
    let link = |i: usize| pages.get(i).map_or_else(String::new, |page| in_address(page, b"-_.~/"));
    table(&mut body, reports, link);
    similar(&mut body, reports, link);
    named_bugs(&mut body, reports);
    statistics::section(&mut body, reports);
    document(&title, &body)
}

/// A row for each submission, with a link.
fn table(out: &mut String, reports: &[Report], link: impl Fn(usize) -> String) {
    out.push_str("<table class=\"class\"><thead><tr><th scope=\"col\">submission</th><th scope=\"col\">points</th><th scope=\"col\">verdict</th></tr></thead>\n<tbody>\n");
    for (i, report) in reports.iter().enumerate() {
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\"><a href=\"{}\">{}</a></th><td>{}</td><td>{}</td></tr>",
            link(i),
            escaped(&words::author(report)),
            words::points(report),
            standing(report),
        );
    }
    out.push_str("</tbody></table>\n");
}

/// Those that look alike, each linked to its section.
fn similar(out: &mut String, reports: &[Report], link: impl Fn(usize) -> String) {
    let alike: Vec<_> = reports.iter().enumerate().filter(|(_, report)| !report.similar.is_empty()).collect();
    if alike.is_empty() {
        return;
    }
    let _ = write!(out, "<h2>Look alike</h2>\n<p>{}</p>\n<ul>\n", words::LOOK_ALIKE);
    for (i, report) in alike {
        let (author, others) = (words::author(report), words::similar(report).join(", "));
        let _ = writeln!(out, "<li><a href=\"{}\">{}</a>: {}</li>", link(i), escaped(&author), escaped(&others));
    }
    out.push_str("</ul>\n");
}

/// What to talk about in the next lecture.
fn named_bugs(out: &mut String, reports: &[Report]) {
    let named = bugs::count(reports);
    if !named.is_empty() {
        out.push_str("<h2>Named bugs</h2>\n<ul>\n");
        for (bug, authors) in named {
            let _ = writeln!(
                out,
                "<li><strong>{}</strong> {} ({})</li>",
                authors.len(),
                escaped(&bug),
                escaped(&authors.join(", "))
            );
        }
        out.push_str("</ul>\n");
    }
}
