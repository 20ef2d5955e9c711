//! Running a suite: all of its cases in one process, and what is left of them in another if that one dies.
//!
//! ```text
//!   case 1 ✓  case 2 ✓  case 3 ✗ (the process died here)      case 3 is judged as far as it got, and by that end
//!                                └──▶ case 4 ✓  case 5 ✓      in a new process
//! ```
//!
//! A process that hangs ends the suite: waiting for the deadline again would teach nothing. Suites that call the
//! same function are not run any more, and the others are. After the third suite that ends by time or memory the
//! submission's run is over: what is left is not asked any more.

use super::cases::random::fresh_seed;
use super::fault::{Fault, FaultKind, first_unanswered};
use super::judge::{Judge, Suite};
use super::program::{End, Program};
use super::protocol::{Case, CaseAnswer, Step, read_answers};

/// How often a suite is taken up again after its process died.
const RESTARTS: usize = 8;

/// After so many suites that ended by time or memory nothing more is asked of a program ...
pub(super) const PATIENCE: usize = 3;
/// ... and after so many ends by memory nothing more of a suite.
const ENDS: usize = 2;

/// The rule that a program breaks which does not answer to the end.
pub(super) const NO_ANSWER: &str = "answer";

/// What came of a suite.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct SuiteRun {
    /// The faults of each case that was run, in the order of the cases.
    pub(super) faults: Vec<Vec<Fault>>,
    /// The answers to them.
    pub(super) answers: Vec<CaseAnswer>,
    /// Why nothing can be said: the program did not start, or did not understand the cases.
    pub(super) grader_fault: Option<String>,
    /// What the student's code printed.
    pub(super) printed: String,
    /// How long the processes took.
    pub(super) millis: u64,
    /// How often its process was ended because of time or memory.
    pub(super) exhausted: usize,
    /// Why the suite was not run.
    pub(super) given_up: Option<String>,
}

impl SuiteRun {
    /// The functions in which the program came to an end by time or memory.
    pub(super) fn exhausted_in<'a>(&'a self, suite: &'a Suite) -> impl Iterator<Item = &'a str> {
        let ends = suite.asked.iter().zip(&self.faults).flat_map(|(asked, faults)| {
            let exhausted = |fault: &&Fault| matches!(fault.kind, FaultKind::TimedOut | FaultKind::OutOfMemory);
            faults.iter().filter(exhausted).filter_map(|fault| asked.case.steps.get(fault.step))
        });
        ends.filter_map(function)
    }

    /// The suite that is not run.
    pub(super) fn given_up(why: String) -> Self {
        Self { given_up: Some(why), ..Self::default() }
    }
}

/// The function of the student that a step calls.
pub(super) fn function(step: &Step) -> Option<&str> {
    match step {
        Step::Call { function, .. } => Some(function),
        Step::Svg => Some("picture"),
        _ => None,
    }
}

/// A suite that was run.
pub(super) struct Graded<'a> {
    pub(super) suite: &'a Suite,
    pub(super) run: SuiteRun,
    /// It was not run, because what all of its tests need did not come back.
    pub(super) blocked: bool,
}

impl Graded<'_> {
    /// Whether every case was asked.
    pub(super) fn is_whole(&self) -> bool {
        !self.blocked && self.run.faults.len() == self.suite.asked.len()
    }
}

/// Runs and judges all cases of a suite.
pub(super) fn run_suite(program: &dyn Program, judge: &dyn Judge, suite: &Suite) -> SuiteRun {
    let mut run = SuiteRun::default();
    for _ in 0..=RESTARTS {
        let cases: Vec<&Case> = suite.asked.iter().skip(run.answers.len()).map(|asked| &asked.case).collect();
        if cases.is_empty() {
            break;
        }
        let token = format!("{:x}", fresh_seed());
        let ran = program.run(&Case::input(&token, cases.iter().copied()));
        run.millis += ran.millis;
        if let End::NotStarted(why) = &ran.end {
            run.grader_fault = Some(format!("the program could not be started: {why}"));
            break;
        }
        let mut answers = read_answers(&ran.stdout, &token, &cases, judge.schema());
        run.printed.push_str(&answers.printed);
        if let Some(complaint) = answers.complaint {
            run.grader_fault = Some(format!("the program does not understand the cases: {complaint}"));
            break;
        }
        if answers.cases.is_empty() {
            answers.cases.push(CaseAnswer::default());
        }
        let last = answers.cases.len() - 1;
        for (i, (case, answer)) in cases.iter().zip(answers.cases).enumerate() {
            let mut faults = judge.judge(suite, case, &answer);
            // The last one counts as answered only if the program went on, or came to its end.
            let died = i == last && !answers.done && (i + 1 == cases.len() || !answer.complete);
            if let Some(broken) = &answer.broken {
                let kind = FaultKind::Wrong;
                faults.extend(of_end_of_answers(judge, suite, case, &answer, &kind, ("broken", &broken.to_string())));
            } else if died || !answer.complete {
                let (kind, tag, words) = of_end(&ran.end);
                faults.extend(of_end_of_answers(judge, suite, case, &answer, &kind, (tag, &words)));
            }
            faults.sort_by_key(|fault| fault.step);
            run.faults.push(faults);
            run.answers.push(answer);
        }
        run.exhausted += usize::from(matches!(ran.end, End::TimedOut | End::OutOfMemory));
        if answers.done || ran.end == End::TimedOut || run.exhausted >= ENDS {
            break;
        }
    }
    run
}

/// A fault where the answers end: it counts against every test that the suite decides, and in the middle of a picture
/// against those of pictures only.
fn of_end_of_answers(
    judge: &dyn Judge,
    suite: &Suite,
    case: &Case,
    answer: &CaseAnswer,
    kind: &FaultKind,
    (tag, words): (&str, &str),
) -> Vec<Fault> {
    let step = first_unanswered(case, answer);
    let of_picture = case.steps.get(step).filter(|step| **step == Step::Svg);
    let tests = of_picture.map(|step| judge.concerns(suite, step, None)).filter(|tests| !tests.is_empty());
    let fault = |test| Fault::new(test, kind.clone(), step, [NO_ANSWER, tag], words.to_owned());
    tests.unwrap_or_else(|| suite.tests.to_vec()).into_iter().map(fault).collect()
}

/// What an end in the middle of a case says.
fn of_end(end: &End) -> (FaultKind, &'static str, String) {
    let crashed = |tag, words: String| (FaultKind::Crashed { message: words.clone(), place: None }, tag, words);
    match end {
        End::Exited(code) => {
            crashed("exit", format!("the program ended itself (exit code {code}) in the middle of a case"))
        }
        End::Signalled { name, signal } => {
            crashed("signal", format!("the program was ended by {name} (signal {signal})"))
        }
        End::StackOverflow => {
            crashed("stack", "stack overflow: a function calls itself without coming to an end".to_owned())
        }
        End::OutputLimit => crashed("output", "the program printed more than it may".to_owned()),
        End::TimedOut => (FaultKind::TimedOut, "time", "the program did not come back before the deadline".to_owned()),
        End::OutOfMemory => (FaultKind::OutOfMemory, "memory", "the program asked for too much memory".to_owned()),
        End::NotStarted(why) => (FaultKind::GraderFault, "start", why.clone()),
    }
}
