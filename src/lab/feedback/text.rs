//! The result of a test in words: what a failing `cargo test` prints.

use crate::{Report, TestResult};
use std::fmt::Write;

/// Everything that a student is told about one test. `replay` is the command that shows the failing case again, if
/// it is known better than in the result.
#[must_use]
pub fn test_text(report: &Report, test: &TestResult, replay: Option<&str>) -> String {
    let mut out = format!("{}: {}\n{}\n", test.name, test.verdict, test.title);
    let mut line = |text: String| {
        out.push_str(&text);
        out.push('\n');
    };
    if !test.message.is_empty() {
        line(format!("\n{}", test.message));
    }
    if let Some(place) = &test.place {
        line(format!("At {place}."));
    }
    if let Some(pattern) = &test.pattern {
        line(pattern.clone());
    }
    if !test.bugs.is_empty() {
        line(format!("\nThis looks as if {}.", test.bugs.join(", or as if ")));
    }
    if let [_, ..] = &test.findings[..] {
        line("\nWhat is wrong:".to_owned());
        for finding in &test.findings {
            line(format!("  - {}", finding.words));
        }
        let mut sections: Vec<&str> = test.findings.iter().map(|finding| finding.section.as_str()).collect();
        sections.dedup();
        line(format!("See the handout: {}.", sections.join(", ")));
    }
    if let Some(ascii) = test.picture.as_ref().map(|picture| &picture.ascii).filter(|ascii| !ascii.is_empty()) {
        line(format!("\n{}", indented(ascii)));
    }
    if let Some(script) = &test.script {
        line(format!("\nThe shortest case that fails so:\n{}", indented(script)));
        if let Some(replay) = replay.or(test.replay.as_deref()) {
            line(format!("Replay it with\n  {replay}"));
        }
    }
    line(format!("\n{}", test.verdict.next_action()));
    if test.verdict.is_failure() {
        line(format!("The same cases again: LAB_SEED={}", report.seed));
    }
    out
}

fn indented(text: &str) -> String {
    text.lines().fold(String::new(), |mut out, line| {
        let _ = writeln!(out, "  {line}");
        out
    })
}
