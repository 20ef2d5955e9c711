//! Judging the picture that a student's program draws: as it is seen; how it is written does not matter.

use super::fault::{Fault, FaultKind, answered};
use super::protocol::{Called, Case, CaseAnswer, Reply, Step};
use dcel_kit::compare::{Options, compare};

/// What is wrong with a picture, compared with a reference that has the coordinates which the handout asks for.
///
/// `reply` is the answer to a step `svg`, `step` the number of that step, `test` the graded test. A picture shows more
/// or less than the reference, in other places or colours: one fault for each difference.
#[must_use]
pub fn judge(test: &'static str, step: usize, reply: &Reply, reference: &str) -> Vec<Fault> {
    let fault = |kind: FaultKind, words: String| Fault::new(test, kind, step, ["picture", ""], words);
    let svg = match reply {
        Reply::Svg(svg) => svg,
        Reply::Called(Called { end, .. }) => {
            let kind = FaultKind::of_end(end).unwrap_or(FaultKind::Wrong);
            return vec![fault(kind, format!("the picture {}", end.words()))];
        }
        _ => return vec![fault(FaultKind::Wrong, "there is no picture".to_owned())],
    };
    match compare(reference, svg, &Options::new()) {
        Ok(comparison) => {
            let differences = comparison.differences().iter();
            differences.map(|difference| fault(FaultKind::Wrong, difference.text.clone())).collect()
        }
        Err(error) => vec![fault(FaultKind::Wrong, error.to_string())],
    }
}

/// What is wrong with the pictures that a case asks for, compared with a reference that is made if there are any.
pub fn judge_case(test: &'static str, case: &Case, answer: &CaseAnswer, reference: impl Fn() -> String) -> Vec<Fault> {
    let drawn = answered(case, answer).filter(|(_, step, _)| **step == Step::Svg);
    drawn.flat_map(|(step, _, reply)| judge(test, step, reply, &reference())).collect()
}

/// As [`judge_case`]; here what differs tells one mistake from another.
pub fn told_apart(test: &'static str, case: &Case, answer: &CaseAnswer, reference: impl Fn() -> String) -> Vec<Fault> {
    let faults = judge_case(test, case, answer, reference).into_iter();
    faults.map(|fault| Fault { tag: fault.words.clone(), ..fault }).collect()
}
