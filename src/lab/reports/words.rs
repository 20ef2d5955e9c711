//! What a test found, as lines of plain text: the same words in every format.

use crate::{Points, Report, Similar, TestResult, Verdict};
use std::fmt::Write;

/// What happened in one test, without its name and verdict: message, place, findings, bug, script, replay, what to
/// do next. Empty for a test that passed without a word.
pub(super) fn of_test(test: &TestResult) -> String {
    let mut out = String::new();
    if !test.message.is_empty() {
        out.push_str(&test.message);
        out.push('\n');
    }
    if let Some(place) = &test.place {
        let _ = writeln!(out, "at {place}");
    }
    if let Some(pattern) = &test.pattern {
        let _ = writeln!(out, "{pattern}");
    }
    if !test.bugs.is_empty() {
        let _ = writeln!(out, "{}", same_failures(&test.bugs));
    }
    for finding in &test.findings {
        let _ = writeln!(out, "- {} (handout: {})", finding.words, finding.section);
    }
    if let Some(script) = &test.script {
        out.push_str("Shortest failing script:\n");
        for line in script.lines() {
            let _ = writeln!(out, "    {line}");
        }
    }
    if let Some(replay) = &test.replay {
        let _ = writeln!(out, "{} {replay}", to_replay(test));
    }
    if !test.verdict.is_passed() {
        let _ = writeln!(out, "Next: {}", test.verdict.next_action());
    }
    clean(&out)
}

/// The text without control characters other than tabs and line breaks, and without marks that turn the direction
/// of writing: nothing that a submission chose or printed can steer a terminal or hide what stands beside it.
pub(super) fn clean(text: &str) -> String {
    let keep = |c: char| match c {
        '\n' | '\t' => c,
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => '\u{fffd}',
        c if c.is_control() => '\u{fffd}',
        c => c,
    };
    text.chars().map(keep).collect()
}

/// What stands before the command that replays a case. A report that was made elsewhere brings no file along.
pub(super) fn to_replay(test: &TestResult) -> String {
    let file = format!("{}.case", test.name);
    let is_there = test.replay.as_ref().is_some_and(|replay| !replay.ends_with(&format!(" {file}")));
    if is_there {
        "Replay it:".to_owned()
    } else {
        format!("To replay it, save it as {file} in your lab's folder, and type there:")
    }
}

/// How a submission stands, in a few words: a verdict, or how far it is.
pub(super) fn standing(report: &Report) -> &'static str {
    match report.verdict {
        Verdict::Unattempted | Verdict::Skipped if report.points() > Points::ZERO => "not finished",
        Verdict::Unattempted | Verdict::Skipped => "not begun",
        verdict => verdict.word(),
    }
}

/// What to do next, as a sentence; `None` if nothing is left.
pub(super) fn next(report: &Report) -> Option<String> {
    let test = report.next_test()?;
    let what = match test.verdict {
        Verdict::Unattempted => "is still to be written",
        verdict => verdict.word(),
    };
    Some(format!("task {}, {}: {what}", test.task, test.title))
}

/// The bug by its name, or both names of a pair that cannot be told apart.
pub(super) fn same_failures(bugs: &[String]) -> String {
    format!("Same failures as: {}", bugs.join(", or: "))
}

/// Who handed it in, on one line.
pub(super) fn author(report: &Report) -> String {
    report.submission.as_deref().map_or_else(|| "your files".to_owned(), line)
}

/// The text on one line: what would break it, or move what follows in a table, is a blank.
pub(super) fn line(text: &str) -> String {
    let flat = |c: char| {
        if matches!(c, '\n' | '\r' | '\t' | '\u{2028}' | '\u{2029}' | '\u{b}' | '\u{c}' | '\u{85}') { ' ' } else { c }
    };
    clean(&text.chars().map(flat).collect::<String>())
}

/// What stands above a list of submissions that look alike.
pub(super) const LOOK_ALIKE: &str =
    "Submissions that look alike, names and comments aside. Compare them yourself: small tasks have similar answers.";

/// The submissions that look like this one: `anna (identical), ben (93 %)`. Not for its author.
pub(super) fn similar(report: &Report) -> Vec<String> {
    let one = |similar: &Similar| {
        let how = if similar.identical { "identical".to_owned() } else { format!("{} %", similar.percent) };
        format!("{} ({how})", line(&similar.submission))
    };
    report.similar.iter().map(one).collect()
}

/// The points as a cell of a table: nothing where the grader failed, because that is no grade.
pub(super) fn points_or_nothing(report: &Report) -> String {
    if report.verdict == Verdict::GraderFault { String::new() } else { report.points().to_string() }
}

/// The points as `62 of 100`.
pub(super) fn points(report: &Report) -> String {
    format!("{} of {}", report.points(), report.max_points())
}

/// The seed, the versions and the barriers, one sentence each.
pub(super) fn circumstances(report: &Report) -> Vec<String> {
    let mut lines = vec![
        format!("Lab {} version {}, kit {}.", report.lab, report.lab_version, report.kit),
        format!("Seed {}: LAB_SEED={} gives the same random cases.", report.seed, report.seed),
    ];
    lines.extend(report.terms.handed_in.iter().map(|when| format!("Handed in: {}.", line(&when.words()))));
    if let Some(own) = &report.terms.own_tests {
        let words = line(&own.words());
        lines.push(format!("{}{}.", words[..1].to_uppercase(), &words[1..]));
        lines.extend(own.problems.iter().map(|problem| format!("Own tests: {}.", line(problem))));
    }
    lines.extend(report.notes.iter().map(|note| format!("Note: {}.", line(note))));
    let up: Vec<&str> = report.sandbox.iter().filter(|w| w.missing.is_none()).map(|w| w.name.as_str()).collect();
    if !up.is_empty() {
        lines.push(format!("Sandbox: {}.", up.join(", ")));
    }
    for barrier in &report.sandbox {
        if let Some(why) = &barrier.missing {
            lines.push(format!("Not in the sandbox: {}: {why}.", barrier.name));
        }
    }
    lines
}
