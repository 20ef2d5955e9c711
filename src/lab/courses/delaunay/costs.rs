//! How many records a call looks at in a large triangulation.
//!
//! ```text
//!   slanted 128 128     98,816 half-edges, numbers past 65,536       is_legal, flip: a few records each
//!   a polygon of 324 corners on a circle, and a vertex in its first triangle: one flip after the other becomes due;
//!   who looks at all edges again, in rounds or after each flip, needs many times as many reads as there are edges
//! ```
//!
//! Time plays no part: reads are counted, and are the same on every machine.

use super::meshes::{slanted, wave};
use crate::cases::random::Random;
use crate::fault::{Fault, FaultKind, answered, exchanges};
use crate::many::{self, too_many_reads};
use crate::protocol::{CallEnd, Called, Case, CaseAnswer, Pattern, Reply, Start, Step, Value, grouped};
use std::sync::LazyLock;

/// The cells of the large triangulation in a row, and the rows.
const CELLS: u32 = 128;
/// How many reads the many questions have together. The solution needs 14 each.
const BUDGET: u64 = 1_000_000;
/// How many reads a flip may make. The solution needs 31.
const READS_OF_A_FLIP: u64 = 500;
/// How many reads `delaunify` may make for each half-edge. The solution needs about 30.
const READS_OF_A_HALF_EDGE: u64 = 100;
/// The radius of a circle with 324 points of whole coordinates.
const RADIUS: i64 = 32_045;

static SLANTED: LazyLock<Start> = LazyLock::new(|| slanted(CELLS, CELLS));

/// Questions about edges of the large triangulation: single ones at large numbers, then many.
pub(super) fn questions() -> Case {
    many::questions("is_legal.large", SLANTED.clone(), "is_legal", ["h65538", "h65537", "h96002", "h98815"], BUDGET)
}

/// Flips of long diagonals of the large triangulation: two are looked at closely, of the others only the reads.
pub(super) fn flips() -> Case {
    let call = |cell| Step::call("flip", [format!("h{}", 6 * cell + 2)]);
    many::looked_at("flip.large", SLANTED.clone(), [16_000, 11_000, 3_000, 100].map(call))
}

/// Triangulations in which many flips are due.
pub(super) fn delaunify() -> Vec<Case> {
    let mut order = Random::new(7, "waves");
    let mut waves: Vec<Start> = [false, true].map(|back| wave("wave", RADIUS, back).start()).into();
    let mixed = super::meshes::renumbered(&wave("wave", RADIUS, false).table(), &mut order);
    waves.push(Start::table(mixed));
    let mut all: Vec<Case> = Vec::new();
    for (i, start) in waves.into_iter().enumerate() {
        let case = Case::new(format!("delaunify_large.wave.{i}"), start).step(Step::Dump);
        all.push(case.step(Step::of_line("delaunify")).step(Step::Reads).step(Step::Dump));
    }
    let case = Case::new("delaunify_large.slanted", SLANTED.clone());
    all.push(case.step(Step::of_line("count_flips")).step(Step::Reads).step(Step::of_line("summary")));
    all
}

/// What is wrong with the numbers of reads in a case, and with the counts of the large triangulation.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let half_edges = exchanges(case, answer)
        .first()
        .and_then(|exchange| Some(exchange.before()?.half_edges.len()))
        .or_else(|| Some(case.start.half_edges()?.half_edges.len()))
        .unwrap_or_default();
    let mut called = "";
    for (step, asked, reply) in answered(case, answer) {
        let fault = |kind, tag: &str, words| vec![Fault::new(test, kind, step, ["cost", tag], words)];
        if let Step::Call { function, .. } = asked {
            called = function;
        }
        match (asked, reply) {
            (Step::Call { .. }, Reply::Called(Called { end, .. })) if test == LARGE => {
                if let Some(kind) = large_kind(end) {
                    return fault(kind, "end", format!("{called} {}", end.words()));
                }
                if let Some(words) = wrong_summary(called, end) {
                    return fault(FaultKind::Wrong, "summary", words);
                }
            }
            (Step::Reads, Reply::Reads(reads)) => {
                let (limit, example) = match called {
                    "flip" => (READS_OF_A_FLIP, "a few dozen"),
                    _ => (READS_OF_A_HALF_EDGE * half_edges as u64, "thirty for each half-edge"),
                };
                if *reads > limit {
                    let size = ("structure", half_edges, "half-edges");
                    return vec![too_many_reads(test, step, (called, *reads), size, example)];
                }
            }
            (Step::Many { function, count, budget }, Reply::Many(many)) if many.asked < *count => {
                let words = format!(
                    "{function} looks at everything: {} calls made {} reads in a structure of {} half-edges, and had {}",
                    many.asked,
                    grouped(many.reads),
                    grouped(half_edges as u64),
                    grouped(*budget),
                );
                return fault(FaultKind::TooSlow { place: many.place.clone() }, "reads", words);
            }
            (Step::Many { function, .. }, Reply::Called(Called { end, .. })) => {
                if let Some(kind) = FaultKind::of_end(end) {
                    let words = format!("{function}, asked for many half-edges, {}", end.words());
                    return fault(kind, "end", words);
                }
            }
            _ => {}
        }
    }
    Vec::new()
}

/// The test of large triangulations.
pub(super) const LARGE: &str = "delaunify_large";

/// How a call that was stopped counts: whoever has used so many reads up, and runs in no circle, looks at everything.
fn large_kind(end: &CallEnd) -> Option<FaultKind> {
    match end {
        CallEnd::Stopped(stopped) if stopped.pattern != Pattern::Circle => {
            Some(FaultKind::TooSlow { place: stopped.place.clone() })
        }
        end => FaultKind::of_end(end),
    }
}

/// What is wrong with what came of the large triangulation: faces that are no triangles, half-edges that break a rule,
/// half-edges longer than the square root of 2; or with the number of flips, of which each long diagonal needs one. Cells cut
/// along their short diagonals are halves of unit squares, and no longer edge is legal there.
fn wrong_summary(function: &str, end: &CallEnd) -> Option<String> {
    let CallEnd::Returned(values) = end else { return None };
    let number = |value: &Value| if let Value::Id(number) = value { Some(*number) } else { None };
    match function {
        "count_flips" => {
            let flips = values.first().and_then(number)?;
            let least = CELLS * CELLS;
            let words = format!("{flips} flips are told, but {least} edges are not legal in the beginning");
            (flips < least).then_some(words)
        }
        "summary" => {
            let names = [
                "half-edges of faces that are no triangles",
                "half-edges that break a rule",
                "half-edges of long diagonals, which are not legal",
            ];
            let wrong = values.iter().zip(names).find(|(value, _)| number(value) != Some(0))?;
            Some(format!("in the end, there are {} {}", wrong.0.words(), wrong.1))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::edges::{due, illegal};
    use super::super::flip::flip;
    use super::super::meshes::slanted_mesh;
    use super::*;
    use dcel_kit::topology::Table;

    #[test]
    fn every_long_diagonal_is_due_and_a_wave_needs_a_flip_for_each_corner() {
        let table = slanted_mesh(CELLS, CELLS).table();
        assert_eq!(illegal(&table).count() / 2, (CELLS * CELLS) as usize);
        assert_eq!(SLANTED.half_edges().unwrap().half_edges.len(), 98_816);
        let mut table: Table = wave("wave", 65, false).table();
        let mut flips = 0;
        while let Some(h) = due(&table) {
            // At no time are two edges due: they wait for each other.
            assert!(illegal(&table).count() <= 4);
            flip(&mut table, h).unwrap();
            flips += 1;
        }
        assert_eq!(flips, 33);
    }
}
