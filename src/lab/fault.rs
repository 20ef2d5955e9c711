//! A broken promise at one step of a case, before it becomes part of a report.

use super::protocol::{CallEnd, Case, CaseAnswer, Pattern, Records, Reply, Step, Structure};
use super::verdict::Verdict;
use dcel_kit::Element;
use dcel_kit::topology::Table;
use std::sync::Arc;

/// A broken promise.
#[derive(Clone, PartialEq, Debug)]
pub struct Fault {
    /// The graded test that it counts against.
    pub test: &'static str,
    /// What it makes of the verdict.
    pub kind: FaultKind,
    /// The step of the case at which it showed.
    pub step: usize,
    /// The check or law: `split_face.3`, `N2`.
    pub rule: String,
    /// What tells it from other ways to break the same rule: the field and the part that the element plays. The
    /// same for every right and wrong numbering.
    pub tag: String,
    /// What is wrong.
    pub words: String,
    /// The elements concerned, in the numbers of the student's structure.
    pub elements: Vec<Element>,
    /// What stands there instead, if it is a wrong value.
    pub instead: Option<Instead>,
}

/// A wrong value, in words: what can be said of it in this call. What can be said of it in every failing call tells
/// how the code has come to it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Instead {
    /// What is wrong: `origin of he`, `the answer`.
    pub subject: String,
    /// All that holds of the value: `the new vertex`, `what it was before the call`. What says most comes first.
    pub is: Vec<&'static str>,
}

/// What a fault says about the code.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FaultKind {
    /// It is a `todo!()` still.
    Unattempted,
    /// It gave something wrong.
    Wrong,
    /// It panicked, overflowed its stack, aborted, or ended the program.
    Crashed {
        /// What it said.
        message: String,
        /// Where.
        place: Option<String>,
    },
    /// It read far more records than there are, and was stopped.
    DoesNotComeBack {
        /// Where it read last, in the student's file.
        place: Option<String>,
    },
    /// Its answers are right, but it looks at everything.
    TooSlow {
        /// Where it read last, in the student's file.
        place: Option<String>,
    },
    /// It was still running at the deadline.
    TimedOut,
    /// It wanted too much memory.
    OutOfMemory,
    /// The program could not be asked.
    GraderFault,
}

impl Fault {
    /// A fault of no elements in particular, without a word about what stands there instead.
    #[must_use]
    pub fn new(test: &'static str, kind: FaultKind, step: usize, [rule, tag]: [&str; 2], words: String) -> Self {
        let [rule, tag] = [rule, tag].map(str::to_owned);
        Self { test, kind, step, rule, tag, words, elements: Vec::new(), instead: None }
    }

    /// What happened, in a sentence: of a call that did not return, first how it ended, then what it has left behind.
    pub(super) fn what_happened(&self, exchange: Option<&Exchange>) -> String {
        let called = exchange.and_then(|exchange| Some((exchange, exchange.called?.1)));
        let Some((exchange, end)) = called else { return self.words.clone() };
        let (how, known) = match (&self.kind, end) {
            (FaultKind::DoesNotComeBack { .. } | FaultKind::TooSlow { .. }, CallEnd::Stopped(stopped)) => {
                (stopped.words(), stopped.words())
            }
            (FaultKind::Crashed { .. }, CallEnd::Panicked { message, .. }) => {
                (format!("panicked: {message}"), message.clone())
            }
            _ => return self.words.clone(),
        };
        if self.words.contains(&known) {
            return self.words.clone();
        }
        format!("{}: {how}. Left behind: {}", exchange.line(), self.words)
    }
}

impl FaultKind {
    /// Of a call that did not return: what is still to do, a crash, or a loop that was stopped.
    #[must_use]
    pub fn of_end(end: &CallEnd) -> Option<Self> {
        match end {
            CallEnd::Returned(_) => None,
            _ if end.is_todo() => Some(Self::Unattempted),
            CallEnd::Panicked { message, place } => {
                Some(Self::Crashed { message: message.clone(), place: place.clone() })
            }
            CallEnd::Stopped(stopped) if stopped.pattern == Pattern::Scan => {
                Some(Self::TooSlow { place: stopped.place.clone() })
            }
            CallEnd::Stopped(stopped) => Some(Self::DoesNotComeBack { place: stopped.place.clone() }),
        }
    }

    /// Whether it was stopped because it read too many records.
    #[must_use]
    pub fn is_endless(&self) -> bool {
        matches!(self, Self::DoesNotComeBack { .. } | Self::TooSlow { .. })
    }

    /// That a call has not come to its end, as the promise that a fault of a hidden case breaks.
    #[must_use]
    pub fn unfinished(&self) -> Option<&'static str> {
        match self {
            Self::Crashed { .. } => Some("a call panics, or ends the program"),
            Self::TimedOut | Self::OutOfMemory | Self::DoesNotComeBack { .. } => Some("a call does not come back"),
            _ => None,
        }
    }

    /// The line of the student's file that the fault points to.
    #[must_use]
    pub fn place(&self) -> Option<&str> {
        match self {
            Self::Crashed { place, .. } | Self::DoesNotComeBack { place } | Self::TooSlow { place } => place.as_deref(),
            _ => None,
        }
    }

    /// The verdict on a test whose first fault is of this kind.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self {
            Self::Unattempted => Verdict::Unattempted,
            Self::Wrong => Verdict::Wrong,
            Self::Crashed { .. } => Verdict::Crashed,
            Self::DoesNotComeBack { .. } => Verdict::DoesNotComeBack,
            Self::TooSlow { .. } => Verdict::TooSlow,
            Self::TimedOut => Verdict::TimedOut,
            Self::OutOfMemory => Verdict::OutOfMemory,
            Self::GraderFault => Verdict::GraderFault,
        }
    }
}

/// A call of a case with all that is known about it.
#[derive(Clone, Copy, Debug)]
pub struct Exchange<'a> {
    /// The number of the step.
    pub step: usize,
    /// The function.
    pub function: &'a str,
    /// The words of its arguments.
    pub words: &'a [String],
    /// The arguments as numbers, and how it ended; `None` if a word led nowhere.
    pub called: Option<(&'a [u32], &'a CallEnd)>,
    /// The structure before the call, as it was dumped last.
    pub structure_before: Option<&'a Structure>,
    /// The structure after the call, if the next step dumps it.
    pub structure_after: Option<&'a Structure>,
}

impl<'a> Exchange<'a> {
    /// The half-edges before the call.
    #[must_use]
    pub fn before(&self) -> Option<&'a Arc<Table>> {
        self.structure_before?.half_edges()
    }

    /// The half-edges after the call, if the next step dumps them.
    #[must_use]
    pub fn after(&self) -> Option<&'a Arc<Table>> {
        self.structure_after?.half_edges()
    }

    /// The records before the call, of a lab that declares its own.
    #[must_use]
    pub fn records_before(&self) -> Option<&'a Arc<Records>> {
        self.structure_before?.records()
    }

    /// The records after the call.
    #[must_use]
    pub fn records_after(&self) -> Option<&'a Arc<Records>> {
        self.structure_after?.records()
    }

    /// The call as it stands in the case: `split_face h2 h8`.
    #[must_use]
    pub fn line(&self) -> String {
        format!("{} {}", self.function, self.words.join(" ")).trim_end().to_owned()
    }

    /// The words of the arguments as numbers, up to the first that is none.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        self.words.iter().map_while(|word| word.parse().ok()).collect()
    }
}

/// The steps of a case that are answered, by their numbers, with what was answered to them so far.
pub fn answered<'a>(case: &'a Case, answer: &'a CaseAnswer) -> impl Iterator<Item = (usize, &'a Step, &'a Reply)> {
    let asked = case.steps.iter().enumerate().filter(|(_, step)| step.is_answered());
    asked.zip(&answer.replies).map(|((number, step), reply)| (number, step, reply))
}

/// The calls of a case that were answered.
#[must_use]
pub fn exchanges<'a>(case: &'a Case, answer: &'a CaseAnswer) -> Vec<Exchange<'a>> {
    let mut out: Vec<Exchange> = Vec::new();
    let (mut now, mut saved) = (None, None);
    let mut replies = answer.replies.iter();
    let mut just_called = false;
    for (step, asked) in case.steps.iter().enumerate() {
        match asked {
            Step::Save => saved = now,
            Step::Restore => now = saved,
            _ => {
                let Some(reply) = replies.next() else { break };
                match (asked, reply) {
                    (Step::Call { function, arguments: words }, reply) => {
                        let called = match reply {
                            Reply::Called(called) => Some((&*called.arguments, &called.end)),
                            _ => None,
                        };
                        let (structure_before, structure_after) = (now, None);
                        out.push(Exchange { step, function, words, called, structure_before, structure_after });
                    }
                    (_, Reply::Dump(structure)) => {
                        now = Some(structure);
                        if let Some(last) = out.last_mut().filter(|_| just_called) {
                            last.structure_after = now;
                        }
                    }
                    _ => {}
                }
            }
        }
        // A count of reads may stand between a call and the structure that it leaves.
        just_called = matches!(asked, Step::Call { .. }) || just_called && *asked == Step::Reads;
    }
    out
}

/// The number of the step that was not answered, if the answer stops before the end; the last call if only the end
/// of the case is missing.
#[must_use]
pub fn first_unanswered(case: &Case, answer: &CaseAnswer) -> usize {
    let mut answered = case.steps.iter().enumerate().filter(|(_, step)| step.is_answered()).map(|(i, _)| i);
    let last_call = || case.steps.iter().rposition(|step| matches!(step, Step::Call { .. }));
    answered.nth(answer.replies.len()).or_else(last_call).unwrap_or(0)
}
