//! What a failing student is shown: the shortest failing script, what is wrong in it, and before, expected, yours.
//!
//! ```text
//!   a failing case ──▶ shrink.rs ──▶ run once more by itself ──▶ picture.rs   three drawings
//!                                                            ├─▶ ascii.rs     the same for a terminal
//!                                                            └─▶ text.rs      the whole of it in words
//! ```

mod ascii;
mod graded;
mod page;
mod picture;
mod shrink;
mod text;

pub use graded::{graded, graded_by};
pub use text::test_text;

use super::fault::{Exchange, Fault, FaultKind, exchanges};
use super::findings::findings;
use super::judge::{Asked, Judge, Source, Suite};
use super::judged::Needs;
use super::program::Program;
use super::protocol::{Case, CaseAnswer, Step};
use super::report::TestResult;
use super::run::{Graded, run_suite};
use super::the_lab::Lab;

/// A structure with more half-edges is not drawn: nobody could see anything in it.
const DRAWN: usize = 1500;

/// What is needed to show a fault.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    pub(super) lab: &'a Lab,
    pub(super) program: &'a dyn Program,
    pub(super) judge: &'a dyn Judge,
}

/// A case that fails, run by itself.
struct Shown {
    case: Case,
    answer: CaseAnswer,
    faults: Vec<Fault>,
}

impl Context<'_> {
    /// Adds script, replay and picture to a result, from a case in which its test fails. Hidden cases stay hidden.
    pub(super) fn illustrate(&self, result: &mut TestResult, graded: &Graded, case: usize, step: usize, needs: &Needs) {
        let (suite, asked) = (graded.suite, &graded.suite.asked[case]);
        let first = graded.run.faults[case].iter().find(|fault| fault.test == result.name && fault.step == step);
        let (Some(first), false) = (first, asked.source == Source::Hidden) else { return };
        let dumped = asked.case.steps.get(first.step + 1).is_some_and(Step::shows);
        let (reduced, _) = asked.case.reduced_to(first.step, dumped);
        if first.kind == FaultKind::TimedOut {
            // A hang costs the whole deadline each time, and would show nothing new.
            result.script = Some(reduced.script());
            result.replay = Some(replay(&result.name));
            return;
        }
        let Some(shown) = self.shown(suite, reduced, first, needs) else {
            // It does not happen again by itself: show the case in which it did.
            result.script = Some(asked.case.script());
            return;
        };
        let faults: Vec<&Fault> = shown.faults.iter().filter(|fault| fault.test == result.name).collect();
        let section = self.lab.manifest.task(result.task).map_or("", |task| task.section.as_str());
        result.findings = findings(self.judge, &faults, section, false);
        if let Some(fault) = faults.first() {
            let count = result.message.rfind(" (").map_or("", |at| &result.message[at..]);
            result.place = fault.kind.place().map(str::to_owned).or_else(|| result.place.take());
            let exchange = exchanges(&shown.case, &shown.answer).into_iter().find(|e| e.step == fault.step);
            let fits = |e: &Exchange| e.before().is_none_or(|table| table.half_edges.len() <= DRAWN);
            let exchange = exchange.filter(fits);
            result.message = format!("{}{count}", fault.what_happened(exchange.as_ref()));
            result.picture = exchange.and_then(|exchange| {
                let own = self.judge.picture(&exchange, &faults);
                own.or_else(|| picture::of(self.judge, &exchange, &faults))
            });
        }
        result.script = Some(shown.case.script());
        result.replay = Some(replay(&result.name));
    }

    /// The shortest case that fails like `first`, and how.
    fn shown(&self, suite: &Suite, reduced: Case, first: &Fault, needs: &Needs) -> Option<Shown> {
        let failing = |cases| self.run(suite, cases, first, needs);
        let reduced = failing(vec![reduced]).pop()?;
        Some(shrink::shrink(reduced, |case| self.judge.shorter(case), failing))
    }

    /// Runs cases and keeps those that fail like `first`: the same rule of the same test, where all that the test
    /// needs holds.
    fn run(&self, suite: &Suite, cases: Vec<Case>, first: &Fault, needs: &Needs) -> Vec<Shown> {
        // They keep their name: a judge may know by it what the case begins with, or asks.
        let asked = cases.into_iter().map(|case| Asked { case, source: Source::Fixed });
        let suite = Suite { asked: asked.collect(), ..suite.clone() };
        let run = run_suite(self.program, self.judge, &suite);
        let answered = suite.asked.into_iter().zip(run.answers).zip(run.faults);
        let alike = |faults: &[Fault]| {
            if faults.iter().any(|fault| needs.has_here(fault.test)) {
                return false;
            }
            let own = faults.iter().find(|fault| fault.test == first.test);
            own.is_some_and(|own| own.rule == first.rule && same_kind(&own.kind, &first.kind))
        };
        answered
            .filter(|(_, faults)| alike(faults))
            .map(|((asked, answer), faults)| Shown { case: asked.case, answer, faults })
            .collect()
    }
}

/// The driver reads a case from a file; the script of a test is kept under the test's name.
fn replay(test: &str) -> String {
    format!("cargo run -q -- {test}.case")
}

fn same_kind(a: &FaultKind, b: &FaultKind) -> bool {
    std::mem::discriminant(a) == std::mem::discriminant(b)
}
