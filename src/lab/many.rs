//! Many small questions in a large structure: who looks at everything has the reads used up after a few of them.
//!
//! ```text
//!   many 10000 vertices_around 1000000     answers 40000 reads 130000
//!                                          or: asked 7 reads 1000012, the most for v300
//! ```
//!
//! Time plays no part: reads are counted, and are the same on every machine.

use super::answers::{self, Function};
use super::fault::{Fault, FaultKind, answered};
use super::protocol::{Called, Case, CaseAnswer, Reply, Start, Step, grouped};
use std::fmt::Display;

/// How many questions are asked.
pub const QUESTIONS: usize = 10_000;

/// Many questions for a function, which have so many reads together.
#[must_use]
pub fn step(function: &str, budget: u64) -> Step {
    Step::Many { function: function.to_owned(), count: QUESTIONS, budget }
}

/// A case of a large structure: single questions for a function, then many.
pub fn questions<T: Display>(
    name: &str,
    start: Start,
    function: &str,
    single: impl IntoIterator<Item = T>,
    budget: u64,
) -> Case {
    let single = single.into_iter().map(|word| Step::call(function, [word]));
    Case::new(name, start).step(Step::Changes).calls(single, &[]).step(step(function, budget))
}

/// A case of a large structure: two calls are looked at closely, of the others only the reads are counted.
pub fn looked_at(name: &str, start: Start, calls: impl IntoIterator<Item = Step>) -> Case {
    let mut calls = calls.into_iter();
    let case = Case::new(name, start).step(Step::Changes).calls(calls.by_ref().take(2), &[Step::Reads, Step::Changes]);
    case.calls(calls, &[Step::Reads])
}

/// A large structure, and what many questions about it should give.
pub struct Large {
    /// How many records it has.
    pub records: u64,
    /// How many values all answers have together.
    pub answers: u64,
    /// What most of the elements have, as it stands in a sentence: `which has 4 neighbours`.
    pub one: &'static str,
    /// What is asked for: `vertices`.
    pub elements: &'static str,
    /// What the numbers of these begin with.
    pub letter: char,
}

/// A call that made more reads than it may: of what the structure is, and what would do.
#[must_use]
pub fn too_many_reads(
    test: &'static str,
    step: usize,
    (call, reads): (&str, u64),
    (structure, size, records): (&str, usize, &str),
    enough: &str,
) -> Fault {
    let (reads, size) = (grouped(reads), grouped(size as u64));
    let of = format!("{structure} of {size} {records}");
    let words = format!("{call} looks at everything: {reads} reads in a {of}, where {enough} would do");
    Fault::new(test, FaultKind::TooSlow { place: None }, step, ["cost", "reads"], words)
}

/// What is wrong with the single answers of a case, and with those to its many questions.
pub fn judge(
    functions: &[Function],
    test: &'static str,
    large: &Large,
    case: &Case,
    answer: &CaseAnswer,
) -> Vec<Fault> {
    let mut faults = answers::judge(functions, case, answer);
    let many = answered(case, answer).filter_map(|(step, asked, reply)| fault(test, large, step, asked, reply));
    faults.extend(many);
    faults
}

fn fault(test: &'static str, large: &Large, step: usize, asked: &Step, reply: &Reply) -> Option<Fault> {
    let Step::Many { function, count, budget } = asked else { return None };
    let (kind, tag, words) = match reply {
        Reply::Many(many) if many.asked < *count || many.reads > *budget => {
            let words = format!(
                "{function} looks at everything: {} reads for {}{}, {}, in a structure of {} records",
                grouped(many.most),
                large.letter,
                many.element,
                large.one,
                grouped(large.records),
            );
            (FaultKind::TooSlow { place: many.place.clone() }, "reads", words)
        }
        Reply::Many(many) if many.answers != large.answers => {
            let words = format!(
                "{function}, asked for {} {}, gave {} values altogether, expected {}",
                grouped(*count as u64),
                large.elements,
                grouped(many.answers),
                grouped(large.answers),
            );
            (FaultKind::Wrong, "answers", words)
        }
        Reply::Called(Called { end, .. }) => {
            let words = format!("{function}, asked for many {} of a large structure, {}", large.elements, end.words());
            (FaultKind::of_end(end)?, "end", words)
        }
        _ => return None,
    };
    Some(Fault::new(test, kind, step, ["cost", tag], words))
}
