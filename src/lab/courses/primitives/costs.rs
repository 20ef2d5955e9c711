//! A large surface: are the splits right where numbers are large, and do they cost what they should?
//!
//! ```text
//!   a torus of 130 times 130 quads         101,400 records; numbers of half-edges up to 67,599
//!   many 10000 spur 1000000                who looks at everything has used the reads up
//!   many 10000 cut_corner 1000000
//! ```

use crate::cases::cycles::{from_cycles, torus};
use crate::fault::{Fault, FaultKind, answered};
use crate::many::{self, QUESTIONS};
use crate::protocol::{Called, Case, CaseAnswer, Reply, Start, Step, grouped};
use dcel_kit::topology::Table;
use std::sync::{Arc, LazyLock};

const SIDE: u32 = 130;
/// How many reads the many splits of a kind have together. The solution needs about 320,000.
const BUDGET: u64 = 1_000_000;
const RECORDS: u64 = 6 * SIDE as u64 * SIDE as u64;

static LARGE_TORUS: LazyLock<Arc<Table>> = LazyLock::new(|| {
    let quads = torus(SIDE, SIDE);
    let faces: Vec<&[u32]> = quads.iter().map(<[u32; 4]>::as_slice).collect();
    Arc::new(from_cycles(&vec![[0.0; 2]; (SIDE * SIDE) as usize], &faces))
});

/// Single splits, then many.
pub(super) fn questions() -> Case {
    let case = Case::new("large.torus", Start::table(LARGE_TORUS.clone())).step(Step::Changes);
    let lines =
        ["split_vertex h67000 h67000.prev.twin", "split_vertex h300 h300", "split_face h67200 h67200.next.next"];
    case.calls(lines.map(Step::of_line), &[Step::Changes])
        .calls(["spur", "cut_corner"].map(|function| many::step(function, BUDGET)), &[])
}

/// What is wrong with many splits.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    answered(case, answer).filter_map(|(step, asked, reply)| fault(test, step, asked, reply)).collect()
}

fn fault(test: &'static str, step: usize, asked: &Step, reply: &Reply) -> Option<Fault> {
    let Step::Many { function, .. } = asked else { return None };
    let split = if function == "spur" { "split_vertex" } else { "split_face" };
    let (kind, tag, words) = match reply {
        Reply::Many(many) if many.asked < QUESTIONS || many.reads > BUDGET => {
            let words = format!(
                "{split} looks at everything: {} reads for h{} in a structure of {} records",
                grouped(many.most),
                many.element,
                grouped(RECORDS),
            );
            (FaultKind::TooSlow { place: many.place.clone() }, "reads", words)
        }
        Reply::Called(Called { end, .. }) => {
            let words = format!("{split}, asked for many splits of a large structure, {}", end.words());
            (FaultKind::of_end(end)?, "end", words)
        }
        _ => return None,
    };
    Some(Fault::new(test, kind, step, [&format!("cost.{split}"), tag], words))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::{first_violation, measure};

    #[test]
    fn the_large_surface_is_a_torus_of_as_many_records_as_it_says() {
        let table = Table { outer_face: None, ..LARGE_TORUS.as_ref().clone() };
        assert!(first_violation(&table).is_none());
        assert_eq!(measure(&table).genus(), 1);
        let records = table.vertices.len() + table.half_edges.len() + table.faces.len();
        assert_eq!(records as u64, RECORDS);
    }
}
