//! A large surface: is the answer right where numbers are large, and does it cost what it should?
//!
//! ```text
//!   torus 150 150                          135,000 records; numbers of half-edges up to 89,999
//!   many 10000 vertices_around 1000000     answers 40000 reads 130000   who looks at everything has used the reads up
//! ```

use super::shapes::{blind, torus};
use crate::fault::{Fault, FaultKind};
use crate::protocol::{Called, Case, CaseAnswer, Reply, Start, Step, Structure, grouped};
use std::sync::{Arc, OnceLock};

/// How many questions are asked, and how many reads they have together. The solution needs 130,000.
const QUESTIONS: usize = 10_000;
const BUDGET: u64 = 1_000_000;
/// Around every vertex there are four others.
const ANSWERS: u64 = 4;
const RECORDS: u64 = 135_000;

/// The large surface.
pub(super) fn large_torus() -> Start {
    static MADE: OnceLock<Structure> = OnceLock::new();
    let make = || Structure::Records(Arc::new(blind(&torus(150, 150)).records()));
    Start::known("torus 150 150", MADE.get_or_init(make).clone())
}

/// Questions about single vertices, then about many.
pub(super) fn questions() -> Case {
    let mut case = Case::new("vertices_around_large.torus", large_torus()).step(Step::Changes);
    case.steps.extend([22_499, 16_400, 300].map(|v| Step::call("vertices_around", [format!("v{v}")])));
    case.step(Step::Many { function: "vertices_around".to_owned(), count: QUESTIONS, budget: BUDGET })
}

/// What is wrong with the answers to many questions.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let asked = case.steps.iter().enumerate().filter(|(_, step)| step.is_answered());
    asked.zip(&answer.replies).filter_map(|((step, asked), reply)| fault(test, step, asked, reply)).collect()
}

fn fault(test: &'static str, step: usize, asked: &Step, reply: &Reply) -> Option<Fault> {
    let Step::Many { function, .. } = asked else { return None };
    let (kind, tag, words) = match reply {
        Reply::Many(many) if many.asked < QUESTIONS || many.reads > BUDGET => {
            let words = format!(
                "{function} looks at everything: {} reads for v{}, which has {ANSWERS} neighbours, in a structure of {} \
                 records",
                grouped(many.most),
                many.element,
                grouped(RECORDS),
            );
            (FaultKind::TooSlow { place: many.place.clone() }, "reads", words)
        }
        Reply::Many(many) if many.answers != ANSWERS * QUESTIONS as u64 => {
            let words = format!(
                "{function}, asked for {} vertices, gave {} values altogether, expected {}",
                grouped(QUESTIONS as u64),
                grouped(many.answers),
                grouped(ANSWERS * QUESTIONS as u64),
            );
            (FaultKind::Wrong, "answers", words)
        }
        Reply::Called(Called { end, .. }) => {
            let words = format!("{function}, asked for many vertices of a large structure, {}", end.words());
            (FaultKind::of_end(end)?, "end", words)
        }
        _ => return None,
    };
    let rule = "cost".to_owned();
    Some(Fault { test, kind, step, rule, tag: tag.to_owned(), words, elements: Vec::new(), instead: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_large_surface_has_as_many_records_as_it_says() {
        assert_eq!(large_torus().structure().map(Structure::len), Some(RECORDS as usize));
    }
}
