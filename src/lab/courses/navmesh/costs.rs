//! How many records a call looks at in a large mesh.
//!
//! Time plays no part: reads are counted, and are the same on every machine.

use crate::fault::{Fault, answered};
use crate::many::too_many_reads;
use crate::protocol::{Case, CaseAnswer, Reply, Start, Step, Structure};

/// How many reads the neighbours of one triangle may take. The solution needs 10.
const READS_OF_A_TRIANGLE: u64 = 200;
/// How many reads a walk through at most 400 of 33,800 triangles may make. The solution needs a third of it.
const READS_OF_A_WALK: u64 = 24_000;
/// How many reads each triangle of a corridor may cost. The solution needs 12.
const READS_OF_A_PORTAL: u64 = 60;

/// Calls, each followed by more steps.
pub(super) fn asks(name: String, start: &Start, lines: impl IntoIterator<Item: AsRef<str>>, after: &[Step]) -> Case {
    let calls = lines.into_iter().map(|line| Step::of_line(line.as_ref()));
    Case::new(name, start.clone()).step(start.dump()).calls(calls, after)
}

/// Calls, each followed by a count of its reads.
pub(super) fn with_reads(name: String, start: &Start, lines: impl IntoIterator<Item = String>) -> Case {
    asks(name, start, lines, &[Step::Reads])
}

/// What is wrong with the numbers of reads in a case.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let records = case.start.structure().map_or(0, Structure::len);
    let mut called: Option<(&str, &[String])> = None;
    for (step, asked, reply) in answered(case, answer) {
        match (asked, reply) {
            (Step::Call { function, arguments }, _) => called = Some((function, arguments)),
            (Step::Reads, Reply::Reads(reads)) => {
                let Some((function, arguments)) = called else { continue };
                let (limit, example) = match function {
                    "neighbours" => (READS_OF_A_TRIANGLE, "ten"),
                    "portals" => (READS_OF_A_PORTAL * arguments.len() as u64, "a dozen for each triangle"),
                    _ => (READS_OF_A_WALK, "those of the triangles on the way"),
                };
                if *reads > limit {
                    let size = ("structure", records, "records");
                    return vec![too_many_reads(test, step, (function, *reads), size, example)];
                }
            }
            _ => {}
        }
    }
    Vec::new()
}
