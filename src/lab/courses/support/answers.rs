//! What is wrong with the answers of a case: the model makes the same edits, and each dump is compared with it.

use super::laws::broken;
use super::model::{Model, Place};
use crate::checks::faults::{Broken, law, told};
use crate::fault::{Exchange, Fault, FaultKind, answered};
use crate::many::too_many_reads;
use crate::protocol::{CallEnd, Called, Case, CaseAnswer, Reply, Step, Structure, Value};

/// How many records a call may look at in a large mesh. The solutions need a fifth of it.
const READS_OF_AN_EDIT: u64 = 2_000;
const READS_OF_A_CLIMB: u64 = 15_000;
/// The rule of a fault that some edit in a row of them has made, nobody knows which.
pub(super) const SEQUENCE: &str = "sequence";

/// The numbers of a call.
pub(super) fn numbers(words: &[String]) -> Vec<f64> {
    words.iter().filter_map(|word| word.trim_start_matches('v').parse().ok()).collect()
}

fn ids(words: &[String]) -> Vec<usize> {
    numbers(words).into_iter().map(|x| x as usize).collect()
}

fn direction(numbers: &[f64]) -> Place {
    [0, 1, 2].map(|i| numbers.get(i).copied().unwrap_or_default())
}

/// Whether a function changes the mesh.
pub(super) fn is_edit(function: &str) -> bool {
    function.starts_with("add") || function.starts_with("remove")
}

/// Whether a call is for what is there; makes the edit, if it is one.
pub(super) fn may_be_asked(model: &mut Model, function: &str, words: &[String]) -> bool {
    let is_there = match (function, &ids(words)[..]) {
        ("remove_face", &[a, b]) => model.across.contains_key(&(a, b)),
        ("remove_vertex" | "climb" | "support", &[v, ..]) => model.place(v).is_some(),
        _ => true,
    };
    if is_there && is_edit(function) {
        wrong(model, function, words, &[]);
    }
    is_there
}

/// Of edits, the first thing that is wrong: what comes after it follows from it. Of questions, all that is wrong.
pub(super) fn judge(test: &'static str, model: &Model, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let fault = |step, kind, rule: &str, tag: &str, words| Fault::new(test, kind, step, [rule, tag], words);
    let mut model = model.clone();
    let mut last: Option<Exchange> = None;
    // How many edits were made since the mesh was looked at.
    let mut unseen = 0;
    let mut out = Vec::new();
    for (step, asked, reply) in answered(case, answer) {
        match (asked, reply) {
            (Step::Call { function, arguments: words }, reply) => {
                let at =
                    Exchange { step, function, words, called: None, structure_before: None, structure_after: None };
                last = Some(at);
                unseen += usize::from(is_edit(at.function));
                if let Some((kind, tag, words)) = wrong_call(&mut model, &at, reply) {
                    // The calls after which the mesh is looked at come after each other: the next one is wrong, too.
                    let looked_at = next_seen(case, step).filter(|&next| is_edit(at.function) && next != step);
                    out.push(fault(step, kind.clone(), function, tag, words.clone()));
                    out.extend(looked_at.map(|next| fault(next, kind, function, tag, words)));
                    if is_edit(at.function) {
                        return out;
                    }
                }
            }
            (Step::Reads, Reply::Reads(reads)) => {
                let Some(at) = last else { continue };
                let limit = if is_edit(at.function) { READS_OF_AN_EDIT } else { READS_OF_A_CLIMB };
                if *reads > limit {
                    let size = ("structure", case.start.structure().map_or(0, Structure::len), "records");
                    out.push(too_many_reads(test, step, (&at.line(), *reads), size, "a few hundred"));
                    // Once is enough: the others are the same.
                    return out;
                }
            }
            (_, Reply::Dump(structure)) => {
                let broken = structure.records().and_then(|records| broken(records, &model));
                if let Some((tag, words)) = broken {
                    let (step, rule, after) = match last {
                        Some(at) if unseen > 1 => {
                            (at.step, SEQUENCE, format!("after {unseen} more edits, the last of them {}: ", at.line()))
                        }
                        Some(at) => (at.step, at.function, format!("after {}: ", at.line())),
                        None => (step, "start", String::new()),
                    };
                    out.push(fault(step, FaultKind::Wrong, rule, tag, format!("{after}{words}")));
                    return out;
                }
                unseen = 0;
            }
            _ => {}
        }
    }
    out
}

/// The first call, from a step on, after which the mesh is shown.
fn next_seen(case: &Case, from: usize) -> Option<usize> {
    let is_seen = |step: usize| case.steps.get(step + 1).is_some_and(Step::shows);
    (from..case.steps.len()).find(|&step| matches!(case.steps[step], Step::Call { .. }) && is_seen(step))
}

/// What is wrong with a call by itself.
fn wrong_call(model: &mut Model, at: &Exchange, reply: &Reply) -> Option<(FaultKind, &'static str, String)> {
    let Reply::Called(Called { end, .. }) = reply else {
        return Some((FaultKind::Wrong, "unresolved", format!("{}: there is no such record", at.line())));
    };
    match end {
        CallEnd::Returned(values) => {
            let (tag, words) = wrong(model, at.function, at.words, values)?;
            let words = format!("{} returned {}: {words}", at.line(), crate::answers::listed(values));
            Some((FaultKind::Wrong, tag, words))
        }
        end => {
            let kind = FaultKind::of_end(end).unwrap_or(FaultKind::Wrong);
            Some((kind, "end", format!("{} {}", at.line(), end.words())))
        }
    }
}

/// Makes the edit in the model; what is wrong with the values, if anything.
fn wrong(model: &mut Model, function: &str, words: &[String], values: &[Value]) -> Option<Broken> {
    let (numbers, ids) = (numbers(words), ids(words));
    let refused = matches!(values, [Value::Refusal(_)]);
    match (function, &ids[..]) {
        ("add_vertex", _) => {
            let before = model.vertices.len();
            let v = model.add_vertex(direction(&numbers));
            let why = if v < before {
                format!("v{v} became free last, so it is used again")
            } else {
                format!("no vertex is free, so the list grows, and the new one is v{v}")
            };
            (*values != [Value::Id(v as u32)]).then(|| ("number", format!("expected {v}: {why}")))
        }
        ("add_face", &[a, b, c]) => {
            let refusal = model.refusal([a, b, c]);
            model.add_face([a, b, c]);
            match refusal {
                Some(why) => (!refused).then(|| ("accepted", format!("expected a refusal: {why}"))),
                None => refused.then(|| ("refused", "nothing is in the way of this triangle".to_owned())),
            }
        }
        ("remove_face", &[a, b]) => {
            model.remove_face(a, b);
            refused
                .then(|| ("edge_map", format!("the edge map does not lead from v{a}, v{b} to a half-edge with a face")))
        }
        ("remove_vertex", &[v]) => {
            model.remove_vertex(v);
            None
        }
        ("support_by_scan", _) => highest(model, direction(&numbers), values).err(),
        ("support", &[_, ..]) => highest(model, direction(&numbers[1..]), values).err(),
        ("climb", &[from, ..]) => climb(model, from, direction(&numbers[1..]), values).err(),
        _ => None,
    }
}

fn highest(model: &Model, d: Place, values: &[Value]) -> Result<(), Broken> {
    let Some(best) = model.highest(d) else {
        let refused = matches!(values, [Value::Refusal(_)]);
        return law(refused, "accepted", || "there is no vertex, expected a refusal".to_owned());
    };
    let [Value::Id(v)] = values else { return Err(("type", "expected a vertex".to_owned())) };
    law(model.place(*v as usize).is_some(), "dead", || format!("v{v} is no vertex"))?;
    law(model.higher(d, best, *v as usize).is_le(), "lower", || format!("v{best} is higher"))
}

fn climb(model: &Model, from: usize, d: Place, values: &[Value]) -> Result<(), Broken> {
    let found: Option<Vec<usize>> = values.iter().map(|value| value.id().map(|id| id as usize)).collect();
    let found = told(found, "type", || "expected a list of vertices".to_owned())?;
    law(found.first() == Some(&from), "start", || format!("it should begin with v{from}"))?;
    for pair in found.windows(2) {
        let [v, next] = [pair[0], pair[1]];
        law(model.neighbours(v).contains(&next), "neighbour", || format!("v{next} is no neighbour of v{v}"))?;
        law(model.higher(d, next, v).is_gt(), "level", || format!("v{next} is not higher than v{v}"))?;
        if let Some(best) = model.steepest(v, d).filter(|&best| model.higher(d, best, next).is_gt()) {
            return Err(("steepest", format!("of the neighbours of v{v}, v{best} is higher than v{next}")));
        }
    }
    let last = found.last().copied().unwrap_or(from);
    match model.steepest(last, d) {
        Some(higher) => Err(("early", format!("it ends at v{last}, beside which v{higher} is higher"))),
        None => Ok(()),
    }
}
