//! What comes into a lab from outside: what a student's program prints, the files of a lab, a file handed in.

use crate::{Ends, Outcome, assert_place};
use dcel_kit::compare::{Options, compare_tables, diff_figure};
use dcel_kit::figure::FigureOptions;
use dcel_kit::topology::{Table, violations};
use dcel_lab::cases::large::grid;
use dcel_lab::checks::align::differences;
use dcel_lab::protocol::{Case, CaseAnswer, Reply, Schema, Start, Step, Structure, read_answers};
use dcel_lab::{Bug, LabFiles, Manifest, ManifestError, ScanError, Secret, Signatures, scan, starter};
use std::sync::OnceLock;

/// The word before the lines of the driver.
const TOKEN: &str = "K7";

/// The cases that every input is read as the answer to.
fn cases() -> &'static [Case] {
    static CASES: OnceLock<Vec<Case>> = OnceLock::new();
    CASES.get_or_init(|| {
        let many = || Step::Many { function: "degree".to_owned(), count: 9, budget: 100 };
        vec![
            Case::new("ears", Start::line("rectangle"))
                .step(Step::Dump)
                .step(Step::call("split_face", ["h2", "h8"]))
                .step(Step::Dump)
                .step(Step::Reads)
                .step(Step::Save)
                .step(Step::call("split_in_half", ["h0"]))
                .step(Step::Changes)
                .step(Step::Restore)
                .step(Step::Svg),
            Case::new("grid", Start::known("grid 2 2", Structure::HalfEdges(grid(2, 2))))
                .step(many())
                .step(Step::Changes)
                .step(Step::call("walk", ["h0"])),
        ]
    })
}

/// What a driver printed.
pub(crate) fn protocol(data: &[u8]) -> Outcome {
    let data = &data[..data.len().min(1 << 15)];
    let cases: Vec<&Case> = cases().iter().collect();
    let answers = read_answers(data, TOKEN, &cases, Schema::HalfEdges);
    assert!(answers.cases.len() <= cases.len());
    // Bytes that are no text take three each.
    assert!(answers.printed.len() <= 3 * 4096, "{} bytes are kept", answers.printed.len());
    assert!(answers.complaint.as_ref().is_none_or(|complaint| complaint.len() < 400));
    let mut outcome = Outcome(u64::from(answers.done)).and(Outcome(u64::from(answers.complaint.is_some())));
    for (answer, case) in answers.cases.iter().zip(&cases) {
        outcome = outcome.and(answered(answer, case));
    }
    outcome
}

fn answered(answer: &CaseAnswer, case: &Case) -> Outcome {
    let due = case.steps.iter().filter(|step| step.is_answered()).count();
    assert!(answer.replies.len() <= due, "more replies than questions");
    assert!(!answer.complete || answer.replies.len() == due && answer.broken.is_none(), "complete, and it is not");
    let mut outcome = Outcome(answer.replies.len() as u64).and(Outcome(u64::from(answer.complete)));
    if let Some(broken) = &answer.broken {
        let message = broken.to_string();
        assert!(message.starts_with("line ") && message.len() < 600, "{message}");
        outcome = outcome.and(Outcome::of(&message));
    }
    for reply in &answer.replies {
        match reply {
            Reply::Dump(Structure::HalfEdges(table)) => outcome = outcome.and(judged(table)),
            Reply::Dump(other) => panic!("half-edges were asked for: {other:?}"),
            Reply::Called(called) => outcome = outcome.and(Outcome::of(&called.end.words())),
            _ => {}
        }
    }
    outcome
}

/// Whatever a program says its structure is, it is judged.
fn judged(table: &Table) -> Outcome {
    let broken = violations(table);
    let expected = grid(2, 2);
    let answer = compare_tables(&expected, table, &Options::new());
    assert!(!answer.text().is_empty());
    let _ = diff_figure(&expected, table, &FigureOptions::new("Yours"));
    let all = differences(&expected, table);
    let same = *expected == *table;
    assert!(!same || broken.is_empty() && answer.is_equal() && all.is_empty(), "the right answer is found wrong");
    // As lines of a dump it comes back.
    let script = Case::new("again", Start::table(table.clone())).script();
    let lines = script.strip_prefix("table\n").and_then(|rest| rest.strip_suffix("end_table\n")).expect("a table");
    let mut said = format!("@{TOKEN} case again\n@{TOKEN} dump\n");
    lines.lines().for_each(|line| said.push_str(&format!("@{TOKEN} {line}\n")));
    said.push_str(&format!("@{TOKEN} end_dump\n@{TOKEN} end_case again\n@{TOKEN} done\n"));
    let case = Case::new("again", Start::line("rectangle")).step(Step::Dump);
    let again = read_answers(said.as_bytes(), TOKEN, &[&case], Schema::HalfEdges);
    let [CaseAnswer { complete: true, replies, .. }] = &again.cases[..] else { panic!("{again:?}\n{said}") };
    let [Reply::Dump(read)] = &replies[..] else { panic!("{replies:?}") };
    // NaN is not equal to itself; its text is.
    let text = Case::new("again", Start::structure_of(read.clone())).script();
    assert_eq!(text, script, "the dump changed");
    broken.first().map_or(Outcome(1), |violation| Outcome::of(&violation.to_string()))
}

/// The files that make a lab: a manifest, a secret, a known mistake, signatures, an archive.
pub(crate) fn lab_files(data: &[u8]) -> Outcome {
    let Ok(text) = std::str::from_utf8(&data[..data.len().min(1 << 14)]) else { return Outcome(0) };
    let at_place = |error: &ManifestError| {
        let message = error.to_string();
        assert!(message.starts_with("file:") && !error.what.is_empty(), "{message}");
        assert!(!message.contains('\n'), "an error of several lines: {message}");
        // The parser takes LF and CR LF for line ends.
        let found = text.split('\n').nth(error.line - 1).unwrap_or_else(|| panic!("no such line: {message}"));
        assert!((1..=found.chars().count() + 1).contains(&error.column), "no such column: {message}");
        Outcome::of(&error.what)
    };
    let manifest = match Manifest::parse(text, "file") {
        Ok(manifest) => {
            assert!(!manifest.graded.is_empty() && manifest.limits.seconds > 0.0);
            let inside = |path: &String| !path.starts_with('/') && path.split('/').all(|part| part != "..");
            assert!(manifest.graded.iter().all(inside), "{manifest:?}");
            assert!(manifest.tests.iter().all(|test| manifest.task(test.task).is_some()), "{manifest:?}");
            let _ = manifest.max_points();
            Outcome(1)
        }
        Err(error) => at_place(&error),
    };
    let secret = match Secret::parse(text, "file", &["split_face", "split_in_half"]) {
        Ok(secret) => {
            assert!((1..=200).contains(&secret.sequences) && (1..=200).contains(&secret.calls), "{secret:?}");
            Outcome(2)
        }
        Err(error) => at_place(&error),
    };
    let bug = match Bug::parse(text, "file") {
        Ok(bug) => match bug.apply(text) {
            Ok(changed) => Outcome(3 + u64::from(changed == text)),
            Err(error) => Outcome::of(&error.to_string()),
        },
        Err(error) => at_place(&error),
    };
    let signatures = match Signatures::parse(text, "file") {
        Ok(signatures) => {
            let written = signatures.to_text();
            let again = Signatures::parse(&written, "written").unwrap_or_else(|error| panic!("{error}\n{written}"));
            assert_eq!(again, signatures, "{written}");
            Outcome(5)
        }
        Err(error) => at_place(&error),
    };
    let archive = match LabFiles::from_archive(text) {
        Ok(files) => {
            let again = LabFiles::from_archive(&files.to_archive()).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(again, files);
            let _ = (files.handout(), files.handed_out());
            Outcome(6)
        }
        Err(error) => Outcome::of(&error.to_string()),
    };
    manifest.and(secret).and(bug).and(signatures).and(archive)
}

/// A student's file: what it may not say, and the starter that a marked solution becomes.
pub(crate) fn submission(data: &[u8]) -> Outcome {
    let Ok(text) = std::str::from_utf8(&data[..data.len().min(1 << 14)]) else { return Outcome(0) };
    let scanned = match scan(text) {
        Ok(()) => Outcome(1),
        Err(error) => {
            let found = match &error {
                ScanError::Forbidden(found) => &found[..],
                ScanError::NotRust(found) => std::slice::from_ref(found),
            };
            assert!(!found.is_empty() && found.iter().all(|found| !found.what.is_empty()), "a refusal without words");
            for found in found {
                assert_place(text.as_bytes(), Ends::Lf, found.line as u64, Some(found.column as u64), &found.what);
            }
            found.iter().fold(Outcome(0), |all, one| all.and(Outcome::of(&one.what)))
        }
    };
    let marked = match starter(text) {
        Ok(starter) => {
            assert!(!starter.contains("BEGIN SOLUTION") || text.contains("BEGIN SOLUTION"));
            Outcome(2)
        }
        Err(error) => Outcome::of(&error.to_string()),
    };
    scanned.and(marked)
}
