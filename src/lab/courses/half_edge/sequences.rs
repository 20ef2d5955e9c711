//! One split after the other, on what the ones before have made, with stored representatives as arguments.
//!
//! Every call is judged by the structure that the student's program had before it. The first fault ends the
//! sequence: what comes after it has no right start.

use super::starts::{antenna, bridge, outer_antenna, petals, rectangle, tree};
use super::{costs, split_face, split_in_half};
use crate::cases::random::Random;
use crate::cases::starts;
use crate::fault::{Fault, FaultKind, exchanges};
use crate::protocol::{Case, CaseAnswer, Start, Step};

/// What a random sequence is made of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Mix {
    /// How many calls.
    pub(super) calls: usize,
    /// How often `split_face` is called, and how often `split_in_half`.
    pub(super) weights: [usize; 2],
}

/// Judges the calls up to the first fault, which counts against `test`.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    for exchange in exchanges(case, answer) {
        if exchange.called.is_none() {
            let words = format!("{}: a link of `{}` is not set", exchange.function, exchange.words.join(" "));
            return vec![Fault::new(test, FaultKind::Wrong, exchange.step, ["R1", "unresolved"], words)];
        }
        let faults = match exchange.function {
            "split_face" => split_face::judge(&exchange, &[test; 6]),
            "split_in_half" => split_in_half::judge(&exchange, &[test; 4]),
            _ => Vec::new(),
        };
        if !faults.is_empty() {
            return faults;
        }
        // A call whose result is not shown is judged by its end alone.
        if let (Some((_, end)), None) = (exchange.called, exchange.after())
            && let Some(kind) = FaultKind::of_end(end)
        {
            let words = format!("{}: {}", exchange.line(), end.words());
            return vec![Fault::new(test, kind, exchange.step, ["R1", "end"], words)];
        }
    }
    costs::judge(test, case, answer)
}

/// A case that dumps after every call. `calls` are lines such as `split_face h0 h4`.
pub(super) fn sequence(name: &str, start: Start, calls: &str) -> Case {
    followed(name, start, &calls.split("; ").map(Step::of_line).collect::<Vec<_>>())
}

/// The same for steps.
pub(super) fn followed(name: &str, start: Start, calls: &[Step]) -> Case {
    let dump = start.dump();
    Case::new(name, start).step(dump.clone()).calls(calls.iter().cloned(), &[dump])
}

/// A random sequence, on a start that a student can type.
pub(super) fn random(name: &str, mix: Mix, random: &mut Random) -> Case {
    let (start, counts) = start(random);
    let mut case = Case::new(name, start).step(Step::Dump);
    for _ in 0..mix.calls {
        let first = word(counts, random);
        let step = if random.below(mix.weights[0] + mix.weights[1]) < mix.weights[0] {
            let second = match random.below(8) {
                0 => word(counts, random),
                1 => first.clone(),
                2 => format!("{first}.prev.prev"),
                _ => format!("{first}{}", ".next".repeat(1 + random.below(4))),
            };
            Step::call("split_face", [first, second])
        } else {
            Step::call("split_in_half", [first])
        };
        case = case.step(step).step(Step::Dump);
    }
    case
}

/// A start, and how many half-edges, vertices and faces it has. Some have dangling edges, bridges, corners that touch.
fn start(random: &mut Random) -> (Start, [usize; 3]) {
    let odd = [antenna, outer_antenna, bridge, petals, tree];
    match random.below(8) {
        0 => (rectangle(), [12, 6, 2]),
        i @ 1..=4 => (polygon(i + 2), [2 * (i + 2), i + 2, 2]),
        _ => {
            let table = odd[random.below(odd.len())]();
            let counts = [table.half_edges.len(), table.vertices.len(), table.faces.len()];
            (Start::table(table), counts)
        }
    }
}

/// A polygon of the classes, as a line.
pub(super) fn polygon(corners: usize) -> Start {
    let table = super::classes::polygon(corners).unwrap_or_default();
    let places: Vec<[f64; 2]> = table.vertices.iter().flatten().filter_map(|row| row.position).collect();
    starts::polygon(&places)
}

/// A half-edge: a given one or a stored one, then up to two links.
fn word([half_edges, vertices, faces]: [usize; 3], random: &mut Random) -> String {
    let given = format!("h{}", random.below(half_edges));
    let base = match random.below(8) {
        0 => format!("f{}.half_edge", random.below(faces)),
        1 => format!("v{}.outgoing", random.below(vertices)),
        2 => format!("{given}.face.half_edge"),
        3 => format!("{given}.origin.outgoing"),
        _ => given,
    };
    let links = [".next", ".prev", ".twin"];
    (0..random.below(3)).fold(base, |word, _| word + links[random.below(3)])
}
