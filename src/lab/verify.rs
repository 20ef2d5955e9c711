//! Proof that a lab grades rightly: its solution, its starter and its bugs, built and graded like a submission.
//!
//! ```text
//!                  graded test   1 2 3 4 5 …
//!   bug  1  walks clockwise      x . . . .      x  fails it      -  not judged, an earlier test failed
//!   bug  2  …                    . x - - .      .  passes it
//! ```
//!
//! Every bug must be caught by a test and named, no bug may be called by a wrong name, and every test must catch a
//! bug: a check that no wrong program fails checks nothing.

use super::grade::{RandomCases, grade, suites};
use super::judge::Suite;
use super::lanes::in_lanes;
use super::mutants::with_conditions;
use super::signatures::{Signature, Signatures};
use super::student::{Kit, student_files};
use super::{Driver, Lab, Plan, Report, Verdict, starter};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The seed of every verification: two of them give the same bytes.
const SEED: u64 = 4;
/// The conditions under which known mistakes fail are learnt from the random cases of so many seeds more.
const SEEDS: u64 = 4;
/// The file that the solution and every bug stand in for.
const GRADED: &str = "src/lab.rs";
/// What every program is called until it is built: under another name the compiler would begin anew, which takes four
/// times as long.
const SAME_NAME: &str = "built";
/// Where a function stands for each graded test.
const GRADED_TESTS: &str = "tests/graded.rs";
/// The one marked source.
const SOLUTION: &str = "solution/lab.rs";

/// What a verification found.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Verification {
    /// What is wrong with the lab, a sentence each; none if it grades rightly.
    pub problems: Vec<String>,
    /// The graded tests, in the order of the manifest.
    pub tests: Vec<String>,
    /// One row for each bug.
    pub rows: Vec<BugRow>,
    /// How the bugs fail, for `bugs/signatures.toml`.
    pub signatures: Signatures,
}

/// A bug and the tests.
#[derive(Clone, PartialEq, Debug)]
pub struct BugRow {
    /// Its number.
    pub number: u32,
    /// Its sentence.
    pub title: String,
    /// What each test said.
    pub verdicts: Vec<Verdict>,
    /// The names by which it was called.
    pub named: BTreeSet<String>,
}

impl Verification {
    /// Whether nothing is wrong.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.problems.is_empty()
    }

    /// The matrix of bugs and tests, then a summary.
    #[must_use]
    pub fn matrix(&self) -> String {
        let mut out = String::new();
        for (i, test) in self.tests.iter().enumerate() {
            let _ = writeln!(out, "  {:>2} {test}", i + 1);
        }
        let ruler: String = (1..=self.tests.len()).map(|i| char::from(b'0' + (i % 10) as u8)).collect();
        let _ = writeln!(out, "\n  bug  {ruler}");
        for row in &self.rows {
            let marks: String = row.verdicts.iter().map(|&verdict| mark(verdict)).collect();
            let _ = writeln!(out, "  {:>3}  {marks}  {}", row.number, row.title);
        }
        let uniquely = self.rows.iter().filter(|row| row.named.len() == 1).count();
        let _ = writeln!(
            out,
            "\n{} bugs, all against {} tests; {uniquely} have a name of their own, {} share one",
            self.rows.len(),
            self.tests.len(),
            self.rows.iter().filter(|row| row.named.len() > 1).count(),
        );
        out
    }
}

fn mark(verdict: Verdict) -> char {
    match verdict {
        Verdict::Passed => '.',
        Verdict::Skipped | Verdict::Unattempted => '-',
        _ => 'x',
    }
}

/// A program to be built and graded.
enum Variant<'a> {
    Solution,
    Starter,
    Bug(&'a super::Bug),
}

/// What came of one.
#[derive(PartialEq)]
struct Outcome {
    report: Report,
    signature: Signature,
}

/// Verifies a lab in `room`, an empty folder that is left to the caller.
///
/// Cost: the compilation of one small program for each bug, two at a time or more, and their runs.
///
/// # Errors
/// If files cannot be written, or there is no compiler.
pub fn verify(lab: &Lab, room: &Path) -> io::Result<Verification> {
    verify_chosen(lab, room, |_| true, true)
}

/// Verifies solution, starter and the known mistakes of these numbers: a sample that is quick enough to be tried often.
/// That every test catches a mistake is not asked of a sample.
///
/// # Errors
/// As [`verify`].
pub fn verify_some(lab: &Lab, room: &Path, numbers: &[u32]) -> io::Result<Verification> {
    verify_chosen(lab, room, |number| numbers.contains(&number), false)
}

fn verify_chosen(lab: &Lab, room: &Path, chosen: impl Fn(u32) -> bool, whole: bool) -> io::Result<Verification> {
    let mut problems = Vec::new();
    if lab.judge().is_none() {
        problems.push(format!("{}: nothing judges this lab; its own program does, in the folder `program`", lab.name));
        return Ok(Verification { problems, ..Verification::default() });
    }
    let missing = missing(lab);
    if !missing.is_empty() {
        return Ok(Verification { problems: missing, ..Verification::default() });
    }
    let solution = lab.files.get(SOLUTION).unwrap_or_default();
    let given = starter(solution).unwrap_or_else(|error| {
        problems.push(format!("{SOLUTION}: {error}"));
        String::new()
    });
    if lab.files.get(GRADED) != Some(given.as_str()) {
        problems.push(format!("{GRADED} is not {SOLUTION} with its marked blocks replaced"));
    }
    problems.extend(leaks(lab, solution));
    let mut unmade = Vec::new();
    let mut variants = vec![(Variant::Solution, solution.to_owned()), (Variant::Starter, given)];
    for bug in lab.bugs.iter().filter(|bug| chosen(bug.number)) {
        match bug.apply(solution) {
            Ok(text) => variants.push((Variant::Bug(bug), text)),
            Err(error) => unmade.push(error.to_string()),
        }
    }
    // What does not fit is told at once, before anything is built.
    if !unmade.is_empty() {
        problems.extend(unmade);
        return Ok(Verification { problems, ..Verification::default() });
    }
    let outcomes = grade_all(lab, room, &variants)?;
    let tests: Vec<String> = lab.manifest.tests.iter().map(|test| test.name.clone()).collect();
    let mut rows = Vec::new();
    let mut signatures = BTreeMap::new();
    for ((variant, _), outcome) in variants.iter().zip(outcomes) {
        match (variant, outcome) {
            (_, Err(error)) => problems.push(format!("{}: {error}", name(variant))),
            (Variant::Solution, Ok(outcome)) => problems.extend(check_solution(&outcome.report)),
            (Variant::Starter, Ok(outcome)) => problems.extend(check_starter(&outcome.report)),
            (Variant::Bug(bug), Ok(outcome)) => {
                signatures.insert(bug.number, outcome.signature);
                rows.push(row(bug, &outcome.report));
            }
        }
    }
    let signatures = Signatures::new(signatures);
    let as_known = rows.iter().all(|row| signatures.get(row.number) == lab.signatures.get(row.number));
    if !as_known || whole && signatures != lab.signatures {
        problems
            .push("bugs/signatures.toml is not how the bugs fail; write it with `dcel lab verify --write`".to_owned());
    }
    for row in &rows {
        problems.extend(check_row(lab, row));
    }
    for (i, test) in tests.iter().enumerate() {
        if whole && !rows.iter().any(|row| mark(row.verdicts[i]) == 'x') {
            problems.push(format!("{test} catches no bug"));
        }
    }
    Ok(Verification { problems, tests, rows, signatures })
}

/// What a lab lacks, a sentence each with what to do.
fn missing(lab: &Lab) -> Vec<String> {
    let mut problems = Vec::new();
    let mut needs = |path: &str, why: &str| {
        if lab.files.get(path).is_none() {
            problems.push(format!("{path} is not there: {why}"));
        }
    };
    needs(SOLUTION, "the starter and the known mistakes are made of it; mark in it what students write");
    needs("src/main.rs", "it is the program that reads the cases and calls what students write");
    needs("README.md", "it is the handout");
    needs(GRADED_TESTS, "it has a function for each graded test");
    for task in &lab.manifest.tasks {
        let why = format!("`dcel lab hint` reads it for task {} of lab.toml, {}", task.number, task.title);
        needs(&format!("hints/task-{}.md", task.number), &why);
    }
    if let Some(tests) = lab.files.get(GRADED_TESTS) {
        let without = |name: &&str| !tests.contains(&format!("fn {name}("));
        for name in lab.manifest.tests.iter().map(|test| test.name.as_str()).filter(without) {
            problems.push(format!("{GRADED_TESTS} has no function `{name}`: lab.toml has a test of that name"));
        }
    }
    problems
}

fn name(variant: &Variant) -> String {
    match variant {
        Variant::Solution => "the solution".to_owned(),
        Variant::Starter => "the starter".to_owned(),
        Variant::Bug(bug) => format!("bug {}", bug.number),
    }
}

fn check_solution(report: &Report) -> Vec<String> {
    let failing = report.tests.iter().filter(|test| !test.verdict.is_passed());
    failing.map(|test| format!("the solution: {} is {}: {}", test.name, test.verdict, test.message)).collect()
}

fn check_starter(report: &Report) -> Vec<String> {
    let attempted = report.tests.iter().filter(|test| test.verdict != Verdict::Unattempted);
    attempted.map(|test| format!("the starter: {} is {}, not unattempted", test.name, test.verdict)).collect()
}

fn row(bug: &super::Bug, report: &Report) -> BugRow {
    BugRow {
        number: bug.number,
        title: bug.title.clone(),
        verdicts: report.tests.iter().map(|test| test.verdict).collect(),
        named: report.tests.iter().flat_map(|test| test.bugs.iter().cloned()).collect(),
    }
}

/// Whether a bug is caught and called by its name, and by no other than those declared to be the same.
fn check_row(lab: &Lab, row: &BugRow) -> Vec<String> {
    let mut problems = Vec::new();
    if !row.verdicts.iter().any(|&verdict| mark(verdict) == 'x') {
        problems.push(format!("bug {} ({}) passes every test", row.number, row.title));
    }
    let same = lab.bugs.iter().filter(|bug| bug.number == row.number).flat_map(|bug| &bug.same_as);
    let same: BTreeSet<u32> = same.copied().chain([row.number]).collect();
    let titles = lab.bugs.iter().filter(|bug| same.contains(&bug.number)).map(|bug| bug.title.clone());
    let expected: BTreeSet<String> = titles.collect();
    if row.named != expected {
        let words = |names: &BTreeSet<String>| {
            if names.is_empty() { "nothing".to_owned() } else { names.iter().cloned().collect::<Vec<_>>().join("; ") }
        };
        problems.push(format!("bug {} is called {}, not {}", row.number, words(&row.named), words(&expected)));
    }
    problems
}

/// What a student's folder gives away of the solution.
fn leaks(lab: &Lab, solution: &str) -> Vec<String> {
    let files = student_files(&lab.files, &Kit::Version(String::new()));
    let mut problems = Vec::new();
    let blocks = solution.split("// BEGIN SOLUTION").skip(1).filter_map(|rest| rest.split("// END SOLUTION").next());
    let lines: Vec<Vec<&str>> = blocks
        .map(|block| {
            let code = block.lines().map(str::trim);
            code.filter(|line| !line.is_empty() && !line.starts_with("//") && *line != "}").collect()
        })
        .collect();
    for (path, text) in &files {
        if path.starts_with("solution") || path.starts_with("bugs") || text.contains("BEGIN SOLUTION") {
            problems.push(format!("a student's folder has {path}"));
        }
        if path != GRADED {
            continue;
        }
        let given: BTreeSet<&str> = text.lines().map(str::trim).collect();
        for line in lines.iter().flatten().filter(|line| given.contains(**line)) {
            problems.push(format!("the starter has a line of the solution: {line}"));
        }
    }
    problems
}

/// What every variant is asked, made once.
struct Asked {
    /// The suites of the report and of the signatures.
    suites: Vec<Suite>,
    /// Those from which the conditions are learnt.
    more: Vec<RandomCases>,
}

impl Asked {
    fn of(lab: &Lab) -> Self {
        let more = (SEED + 1..=SEED + SEEDS).map(|seed| RandomCases::of(lab, &Plan::with_seed(seed)));
        Self { suites: suites(lab, &Plan::with_seed(SEED)), more: more.collect() }
    }
}

/// Builds and grades all variants, as many at a time as there are cores; the first ones only if the solution cannot be
/// built.
fn grade_all(lab: &Lab, room: &Path, variants: &[(Variant, String)]) -> io::Result<Vec<Result<Outcome, String>>> {
    let asked = Asked::of(lab);
    let lanes = std::thread::available_parallelism().map_or(1, usize::from);
    let outcomes = in_lanes(lanes, variants.len(), |lane, i| {
        let (variant, text) = &variants[i];
        let program = room.join(format!("program-{i}{}", std::env::consts::EXE_SUFFIX));
        let outcome = grade_variant(lab, &asked, &room.join(lane.to_string()), program, variant, text);
        // Where the solution cannot be built, nothing that is made of it can.
        let is_lost = matches!(variant, Variant::Solution) && matches!(outcome, Ok(Err(_)));
        (outcome, !is_lost)
    });
    outcomes.into_iter().flatten().collect()
}

fn grade_variant(
    lab: &Lab,
    asked: &Asked,
    folder: &Path,
    program: PathBuf,
    variant: &Variant,
    text: &str,
) -> io::Result<Result<Outcome, String>> {
    // The solution and the starter are handed out: they compile without a warning.
    let strict = !matches!(variant, Variant::Bug(_));
    if let Err(error) = compile(lab, folder, &program, text, strict)? {
        return Ok(Err(format!("does not compile: {error}")));
    }
    let program = Driver::new(program, lab.manifest.limits);
    let graded = || {
        let (report, signature, evidence) = grade(lab, &program, &Plan::with_seed(SEED), &asked.suites, true);
        (Outcome { report: Report { millis: 0, ..report }, signature }, evidence)
    };
    let (outcome, mut evidence) = graded();
    if strict && graded().0 != outcome {
        return Ok(Err("two runs gave two reports".to_owned()));
    }
    let Outcome { report, mut signature } = outcome;
    if !signature.is_empty() {
        let failing: BTreeSet<&str> = signature.keys().map(String::as_str).collect();
        for cases in &asked.more {
            for (test, calls) in cases.evidence(lab, &program, &failing) {
                let all = evidence.entry(test).or_default();
                all.failing.extend(calls.failing);
                all.passing.extend(calls.passing);
            }
        }
        with_conditions(&mut signature, &evidence, lab.judge().map_or(&[], |judge| judge.vocabulary()));
    }
    Ok(Ok(Outcome { report, signature }))
}

/// Makes the lab's program with this text as the student's file. What the compiler knows of the other files stays in
/// the folder, for the next text.
pub(crate) fn compile(
    lab: &Lab,
    folder: &Path,
    program: &Path,
    text: &str,
    strict: bool,
) -> io::Result<Result<(), String>> {
    for (path, given) in lab.files.iter().filter(|(path, _)| path.starts_with("src/")) {
        let path_there = folder.join(path);
        std::fs::create_dir_all(path_there.parent().unwrap_or(folder))?;
        std::fs::write(path_there, if path == GRADED { text } else { given })?;
    }
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let mut command = Command::new(compiler);
    command.args([
        "--edition=2024",
        "--crate-name=lab",
        "-Cdebuginfo=0",
        // As what students build again after each save (see `submission/tree.rs`): only the parts with changed functions
        // are compiled, and the large cases run in half of the time.
        "-Copt-level=1",
        "-Clto=off",
        "-Cincremental=known",
        "--color=never",
        "-Funsafe_code",
    ]);
    command.arg(if strict { "-Dwarnings" } else { "-Awarnings" });
    command.arg("-o").arg(SAME_NAME).arg("src/main.rs").current_dir(folder);
    let compiled = command.output()?;
    if compiled.status.success() {
        std::fs::rename(folder.join(SAME_NAME), program)?;
        return Ok(Ok(()));
    }
    Ok(Err(String::from_utf8_lossy(&compiled.stderr).into_owned()))
}
