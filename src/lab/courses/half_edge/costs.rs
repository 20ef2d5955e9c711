//! Large structures: is the answer right where numbers are large, and does it cost what it should?
//!
//! ```text
//!   grid 150 150                       135,902 records; numbers of half-edges up to 90,599
//!   many 10000 walk_vertex 1000000     answers 39734 reads 89468       who looks at everything has used the reads up
//!                                                                      after a few questions
//! ```
//!
//! Time plays no part: reads are counted, and are the same on every machine.

use super::walk;
use crate::cases::starts::grid;
use crate::fault::{Fault, FaultKind, answered};
use crate::many::{self, too_many_reads};
use crate::protocol::{Called, Case, CaseAnswer, Many, Reply, Start, Step, Structure, grouped};
use dcel_kit::topology::Table;
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};

/// The large structure.
pub(super) fn large_grid() -> Start {
    grid(150, 150)
}

/// A grid with 300 faces and ids past 256, printed whole.
pub(super) fn small_grid() -> Start {
    grid(20, 15)
}

/// How many reads the many questions have together. The solution needs a tenth of it.
const BUDGET: u64 = 1_000_000;
/// How many reads a split of a cell, or of an edge, may make. The solution needs 32.
const READS_OF_A_SPLIT: u64 = 2_000;
/// Half-edges of cells of the grid; those of the first two are past 65,536.
const AT: [u32; 8] = [90_000, 65_538, 80_002, 70_004, 50_006, 30_008, 20_010, 10_012];

/// Questions about the large grid: single ones at large numbers, then many.
pub(super) fn questions(name: &str, function: &str, letter: char) -> Case {
    let single: &[u32] = match letter {
        'f' => &[22_500, 300, 1],
        'v' => &[22_800, 22_649, 400],
        _ => &[90_599, 65_537, 90_000],
    };
    let single = single.iter().map(|number| format!("{letter}{number}"));
    many::questions(&format!("{name}.large"), large_grid(), function, single, BUDGET)
}

/// Splits in the large grid: two are looked at closely, of the others only the reads are counted.
pub(super) fn splits(name: &str, function: &str) -> Case {
    let call = |h| match function {
        "split_face" => Step::call(function, [format!("h{h}"), format!("h{h}.next.next")]),
        _ => Step::call(function, [format!("h{h}")]),
    };
    many::looked_at(&format!("{name}.large"), large_grid(), AT.map(call))
}

/// What is wrong with the numbers of reads in a case.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let mut out = Vec::new();
    let mut called: Option<(&str, String)> = None;
    for (step, asked, reply) in answered(case, answer) {
        let fault = |kind, tag: &str, words| Fault::new(test, kind, step, ["cost", tag], words);
        match (asked, reply) {
            (Step::Call { function, arguments }, _) => called = Some((function, arguments.join(" "))),
            (Step::Reads, Reply::Reads(reads)) if *reads > READS_OF_A_SPLIT => {
                let (function, arguments) = called.clone().unwrap_or_default();
                let size = ("structure", case.start.structure().map_or(0, Structure::len), "records");
                let call = format!("{function} {arguments}");
                // Once is enough: the others are the same.
                out.push(too_many_reads(test, step, (&call, *reads), size, "a few dozen"));
                return out;
            }
            (Step::Many { function, count, budget }, Reply::Many(many)) => {
                let Some(table) = case.start.half_edges() else { continue };
                let wrong = wrong_of_many(table, function, *count, *budget, many);
                out.extend(wrong.map(|(words, tag, kind)| fault(kind, tag, words)));
            }
            (Step::Many { function, .. }, Reply::Called(Called { end, .. })) => {
                let words = format!("{function}, asked for many elements of a large structure, {}", end.words());
                out.extend(FaultKind::of_end(end).map(|kind| fault(kind, "end", words)));
            }
            _ => {}
        }
    }
    out
}

fn wrong_of_many(
    table: &Table,
    function: &str,
    count: usize,
    budget: u64,
    many: &Many,
) -> Option<(String, &'static str, FaultKind)> {
    type Named = fn(u32) -> Element;
    let (length, element): (usize, Named) = match function {
        "walk_face" | "walk_vertices" => (table.faces.len(), |n| FaceId::new(n).into()),
        "walk_vertex" => (table.vertices.len(), |n| VertexId::new(n).into()),
        _ => (table.half_edges.len(), |n| HalfEdgeId::new(n).into()),
    };
    let asked = count.min(length);
    let answers_of = |n: u32| walk::expected(table, function, n).map_or(0, |walk| walk.elements.len() as u64);
    if many.asked < asked || many.reads > budget {
        let words = format!(
            "{function} looks at everything: {} reads for {}, whose answer has {}, in a structure of {} records",
            grouped(many.most),
            element(many.element),
            answers_of(many.element),
            grouped((table.vertices.len() + table.half_edges.len() + table.faces.len()) as u64),
        );
        return Some((words, "reads", FaultKind::TooSlow { place: many.place.clone() }));
    }
    let expected: u64 = (0..asked).map(|i| answers_of((i * length / asked) as u32)).sum();
    (many.answers != expected).then(|| {
        let words = format!(
            "{function}, asked for {} elements of a large structure, gave {} values altogether, expected {}",
            grouped(asked as u64),
            grouped(many.answers),
            grouped(expected),
        );
        (words, "answers", FaultKind::Wrong)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::View;

    #[test]
    fn the_half_edges_of_the_splits_are_those_of_cells() {
        let table = large_grid().half_edges().unwrap().clone();
        for h in AT.map(HalfEdgeId::new) {
            assert!(table.face(h).is_some_and(|f| f.number() != 0), "{h}");
        }
    }
}
