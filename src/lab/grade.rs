//! Grading a program: all suites, a verdict for each test, the report.
//!
//! ```text
//!   the first case of a test that fails decides its verdict      crashed, timed out, out of memory, wrong ...
//!   a test that it needs did not pass                            skipped
//!   nothing of its task is there but todo!()                     unattempted
//!   no fault in any case, and every case answered                passed
//! ```

use super::course::{Source, Suite, course};
use super::fault::{Fault, FaultKind};
use super::feedback;
use super::manifest::Test;
use super::plan::Plan;
use super::program::Program;
use super::report::{Finding, Report, TestResult};
use super::run::{PATIENCE, SuiteRun, run_suite};
use super::the_lab::Lab;
use super::verdict::Verdict;
use super::zoo::{self, Signature};
use std::collections::{BTreeMap, BTreeSet};
use std::time::Instant;

/// What is said of a test that was not asked any more.
const GIVEN_UP: &str =
    "It was not run: the program had to be ended twice before, because of time or memory. Mend the test above first.";
/// How many findings are listed.
const FINDINGS: usize = 10;
/// How much of the student's printing is in the report.
const PRINTED: usize = 4 * 1024;

/// A suite that was run.
pub(super) struct Graded<'a> {
    pub(super) suite: &'a Suite,
    pub(super) run: SuiteRun,
}

/// What is known of a test before it becomes a result.
struct State<'a> {
    test: &'a Test,
    verdict: Verdict,
    /// The suite that decides it, and the first case with a fault of this test.
    failing: Option<(usize, usize)>,
    hash: Option<String>,
}

impl<'a> State<'a> {
    fn without_cases(test: &'a Test) -> Self {
        Self { test, verdict: Verdict::GraderFault, failing: None, hash: None }
    }
}

/// Runs all cases of a lab with a program, and says what came of it.
///
/// Never panics, whatever the program prints. The same program, seed and lab give the same report, times aside.
/// Cost: a few processes and some thousand small structures; below half a second for a right solution.
#[must_use]
pub fn grade_program(lab: &Lab, program: &dyn Program, plan: &Plan) -> Report {
    grade_and_sign(lab, program, plan).0
}

/// [`grade_program`], and how the program fails in the fixed cases: what the zoo keeps of each bug. The signature is
/// empty for a right program, and for one that cannot be run, and does not depend on the seed.
#[must_use]
pub fn grade_and_sign(lab: &Lab, program: &dyn Program, plan: &Plan) -> (Report, Signature) {
    let begin = Instant::now();
    let mut report = empty_report(lab, plan, program);
    let Some(course) = course(&lab.name) else {
        report.message = Some(format!("this version of the kit has no cases for {}", lab.name));
        return (report, Signature::new());
    };
    let suites = wanted(course.suites(plan), lab, plan);
    let mut graded: Vec<Graded> = Vec::new();
    let mut exhausted = 0;
    for suite in &suites {
        let last = graded.iter().rev().find_map(|graded| graded.run.exhausted_by());
        let run = match last {
            // What builds on a test that fails would be skipped anyway, and may hang on what that has left behind.
            _ if is_blocked(lab, suite, &graded) => SuiteRun::default(),
            Some(end) if exhausted >= PATIENCE => SuiteRun::given_up(end),
            _ => run_suite(program, course, suite, exhausted),
        };
        exhausted += run.exhausted;
        report.printed.push_str(&run.printed);
        graded.push(Graded { suite, run });
    }
    let mut cut = report.printed.len().min(PRINTED);
    while !report.printed.is_char_boundary(cut) {
        cut -= 1;
    }
    report.printed.truncate(cut);
    let mut states = states(lab, &graded);
    if plan.only.is_none() {
        // A test without cases can never be passed.
        let known: BTreeSet<&str> = states.iter().map(|state| state.test.name.as_str()).collect();
        let lost = lab.manifest.tests.iter().filter(|test| !known.contains(test.name.as_str()));
        let lost: Vec<State> = lost.map(State::without_cases).collect();
        states.extend(lost);
    }
    let signature = signature_of(&states);
    let skipped: BTreeSet<&str> = states
        .iter()
        .filter(|state| matches!(state.verdict, Verdict::Skipped | Verdict::Unattempted))
        .map(|state| state.test.name.as_str())
        .collect();
    let context = feedback::Context { lab, program, course };
    for state in &states {
        let mut result = TestResult::new(state.test, state.verdict);
        describe(&mut result, state, &graded, lab, &states);
        if state.verdict.is_failure() {
            let task = state.test.task;
            result.bugs = zoo::names(&lab.signatures, &lab.bugs, &lab.manifest, task, &signature, &skipped);
            if let Some((suite, case)) = state.failing {
                context.illustrate(&mut result, &graded[suite], case);
            }
        }
        report.tests.push(result);
    }
    report.verdict = report.tests.iter().map(|test| test.verdict).max().unwrap_or(Verdict::GraderFault);
    report.millis = begin.elapsed().as_millis() as u64;
    (report, signature)
}

/// Whether every test of a suite needs, at once or through others, one that has been run and fails. Code that is
/// still to be written blocks nothing: what is said of it depends on all that the task has.
fn is_blocked(lab: &Lab, suite: &Suite, graded: &[Graded]) -> bool {
    let states = states(lab, graded);
    let fails = |name: &str| {
        let state = states.iter().find(|state| state.test.name == name);
        let open = [Verdict::Passed, Verdict::Unattempted, Verdict::GraderFault];
        state.is_some_and(|state| !open.contains(&state.verdict))
    };
    suite.tests.iter().all(|test| {
        let needs = lab.manifest.test(test).map_or(&[][..], |test| &test.needs);
        needs.iter().any(|need| fails(need))
    })
}

fn signature_of(states: &[State]) -> Signature {
    states.iter().filter_map(|state| Some((state.test.name.clone(), state.hash.clone()?))).collect()
}

fn empty_report(lab: &Lab, plan: &Plan, program: &dyn Program) -> Report {
    Report {
        kit: env!("CARGO_PKG_VERSION").to_owned(),
        lab: lab.name.clone(),
        lab_version: lab.manifest.version.clone(),
        submission: None,
        seed: plan.seed,
        verdict: Verdict::GraderFault,
        message: None,
        tests: Vec::new(),
        walls: program.walls(),
        printed: String::new(),
        attachments: Vec::new(),
        adjustments: Vec::new(),
        notes: Vec::new(),
        similar: Vec::new(),
        millis: 0,
    }
}

/// The suites that decide the test that is wanted, and those that it needs; all if none is wanted.
fn wanted(suites: Vec<Suite>, lab: &Lab, plan: &Plan) -> Vec<Suite> {
    let Some(only) = &plan.only else { return suites };
    let mut names: BTreeSet<&str> = [only.as_str()].into();
    // Tests need earlier ones only, so one way back through the list finds all.
    for test in lab.manifest.tests.iter().rev() {
        if names.contains(test.name.as_str()) {
            names.extend(test.needs.iter().map(String::as_str));
        }
    }
    suites.into_iter().filter(|suite| suite.tests.iter().any(|test| names.contains(test))).collect()
}

fn states<'a>(lab: &'a Lab, graded: &[Graded]) -> Vec<State<'a>> {
    let mut states: Vec<State> = lab.manifest.tests.iter().filter_map(|test| state(test, graded)).collect();
    let own: BTreeMap<String, Verdict> = states.iter().map(|s| (s.test.name.clone(), s.verdict)).collect();
    let untouched = |task: u32| {
        let of_task = lab.manifest.tests.iter().filter(|test| test.task == task);
        of_task.into_iter().all(|test| own.get(&test.name).is_none_or(|v| *v == Verdict::Unattempted))
    };
    let mut done: BTreeMap<&str, Verdict> = BTreeMap::new();
    for state in &mut states {
        let is_open = |need: &String| done.get(need.as_str()).is_some_and(|verdict| !verdict.is_passed());
        let program_fails = graded.iter().any(|g| g.run.grader_fault.is_some());
        if !program_fails && state.test.needs.iter().any(is_open) && !untouched(state.test.task) {
            state.verdict = Verdict::Skipped;
            state.hash = None;
        }
        done.insert(&state.test.name, state.verdict);
    }
    states
}

/// A test by itself, whatever it needs; `None` if its suite was not asked for.
fn state<'a>(test: &'a Test, graded: &[Graded]) -> Option<State<'a>> {
    let suite = graded.iter().position(|g| g.suite.tests.contains(&test.name.as_str()));
    let suite = suite?;
    let Graded { suite: asked, run } = &graded[suite];
    if run.grader_fault.is_some() {
        return Some(State { test, verdict: Verdict::GraderFault, failing: None, hash: None });
    }
    if let Some(end) = &run.given_up {
        return Some(State { test, verdict: end.verdict(), failing: None, hash: None });
    }
    let first = run.faults.iter().enumerate().find_map(|(case, faults)| {
        let fault = faults.iter().find(|fault| fault.test == test.name)?;
        Some((case, fault))
    });
    let verdict = match first {
        Some((_, fault)) => fault.kind.verdict(),
        // Every case must have been answered: a suite that was broken off has a fault, but be sure.
        None if run.faults.len() == asked.asked.len() && !asked.asked.is_empty() => Verdict::Passed,
        None => Verdict::GraderFault,
    };
    let hash = (!matches!(verdict, Verdict::Passed | Verdict::Unattempted | Verdict::GraderFault))
        .then(|| hash_of(asked, run, &test.name));
    Some(State { test, verdict, failing: first.map(|(case, _)| (suite, case)), hash: hash.flatten() })
}

/// The hash of what fails in the fixed cases; `None` if nothing does.
fn hash_of(suite: &Suite, run: &SuiteRun, test: &str) -> Option<String> {
    let fixed = suite.asked.iter().zip(&run.faults).filter(|(asked, _)| asked.source == Source::Fixed);
    let line = |case: &str, fault: &Fault| {
        let kind = match &fault.kind {
            FaultKind::Crashed { .. } => "crashed".to_owned(),
            FaultKind::DoesNotComeBack { .. } => "DoesNotComeBack".to_owned(),
            FaultKind::TooSlow { .. } => "TooSlow".to_owned(),
            kind => format!("{kind:?}"),
        };
        format!("{case} {} {} {} {kind}", fault.step, fault.rule, fault.tag)
    };
    let lines: BTreeSet<String> = fixed
        .flat_map(|(asked, faults)| {
            faults.iter().filter(|fault| fault.test == test).map(|fault| line(&asked.case.name, fault))
        })
        .collect();
    (!lines.is_empty()).then(|| zoo::hash(&lines))
}

/// The message, the place and the findings.
fn describe(result: &mut TestResult, state: &State, graded: &[Graded], lab: &Lab, all: &[State]) {
    match state.verdict {
        Verdict::Passed => return,
        Verdict::Skipped => {
            let open = state.test.needs.iter().filter_map(|need| all.iter().find(|other| other.test.name == *need));
            let open: Vec<String> = open
                .filter(|other| !other.verdict.is_passed())
                .map(|other| format!("{} ({})", other.test.name, other.verdict))
                .collect();
            result.message = format!("It builds on {}.", open.join(" and "));
            return;
        }
        Verdict::GraderFault => {
            let faults = graded.iter().filter(|g| g.suite.tests.contains(&state.test.name.as_str()));
            let why = faults.filter_map(|g| g.run.grader_fault.clone()).next();
            result.message = why.unwrap_or_else(|| "the cases of this test could not be asked".to_owned());
            return;
        }
        _ => {}
    }
    let Some((suite, case)) = state.failing else {
        result.message = GIVEN_UP.to_owned();
        return;
    };
    let Graded { suite, run } = &graded[suite];
    let name = state.test.name.as_str();
    let section = lab.manifest.task(state.test.task).map_or("", |task| task.section.as_str());
    let failing = run.faults.iter().filter(|faults| faults.iter().any(|fault| fault.test == name)).count();
    let hidden = suite.asked[case].source == Source::Hidden;
    let faults: Vec<&Fault> = run.faults[case].iter().filter(|fault| fault.test == name).collect();
    result.place = faults.first().and_then(|fault| fault.kind.place()).map(str::to_owned);
    if state.verdict == Verdict::Unattempted {
        result.message = "It is still to be written.".to_owned();
        return;
    }
    let answered = run.faults.len();
    let what = faults.first().map_or_else(String::new, |fault| fault.words.clone());
    result.message = if hidden {
        "A hidden case fails; the cases that you can see do not.".to_owned()
    } else {
        format!("{what} ({failing} of {answered} cases fail.)")
    };
    result.findings = findings(&faults, section, hidden);
}

/// The faults of one case as findings: each sentence once. Of hidden cases only the promise is said.
pub(super) fn findings(faults: &[&Fault], section: &str, hidden: bool) -> Vec<Finding> {
    let mut out: Vec<Finding> = Vec::new();
    for fault in faults {
        let words = if hidden { promise(fault) } else { fault.words.clone() };
        let finding = Finding { rule: fault.rule.clone(), words, section: section.to_owned() };
        if out.len() < FINDINGS && !out.contains(&finding) {
            out.push(finding);
        }
    }
    out
}

/// The promise that a hidden case found broken, without anything of the case.
fn promise(fault: &Fault) -> String {
    let sentence = match (&fault.kind, fault.rule.as_str()) {
        (FaultKind::Crashed { .. }, _) => "after some splits, the next one panics or ends the program",
        (FaultKind::TooSlow { .. }, _) => "each call looks at a few records only, however large the structure is",
        (FaultKind::DoesNotComeBack { .. } | FaultKind::TimedOut | FaultKind::OutOfMemory, _) => {
            "after some splits, the next one does not come back"
        }
        (_, "split_face.0") => "split_face refuses illegal calls, and only these, without changing anything",
        (_, "split_face.1") => "split_face makes one face and no vertex",
        (_, "split_face.2") => "split_face makes two half-edges, twins with the right origins",
        (_, "split_face.3") => "after split_face, next and prev close both cycles",
        (_, "split_face.4") => "after split_face, every half-edge knows its face",
        (_, "split_face.5") => "after split_face, faces and vertices know a half-edge of their own",
        (_, "split_in_half.1") => "split_in_half makes one vertex, at the midpoint",
        (_, "split_in_half.2") => "split_in_half makes two half-edges with the right origins and twins",
        (_, "split_in_half.3") => "after split_in_half, links, faces and what vertices refer to are right",
        _ => "after some splits, all laws of the structure hold",
    };
    format!("broken in a hidden case: {sentence}")
}
