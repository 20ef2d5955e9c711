//! The functions that only read: round a face, round a vertex, to the other end of a half-edge.
//!
//! ```text
//!   walk_face f1          h0 h2 h4      any start, counter-clockwise along next
//!   walk_vertices f1      v0 v1 v2      their origins
//!   walk_vertex v0        h0 h5         any start, counter-clockwise: prev.twin
//!   destination h0        v1            origin of the twin
//! ```

use super::walk::expected;
use super::{costs, readings};
use crate::checks::cyclic;
use crate::fault::{Exchange, Fault, FaultKind, Instead, exchanges};
use crate::protocol::{CallEnd, Case, CaseAnswer, Value};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::View;

/// Judges every call of a case by what it returned.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let mut faults: Vec<Fault> = exchanges(case, answer).iter().filter_map(|exchange| fault(test, exchange)).collect();
    faults.extend(costs::judge(test, case, answer));
    faults
}

fn fault(test: &'static str, exchange: &Exchange) -> Option<Fault> {
    let Exchange { step, function, .. } = *exchange;
    let call = exchange.line();
    let fault = |kind, tag: String, words, elements| {
        Some(Fault { test, kind, step, rule: function.to_owned(), tag, words, elements, instead: None })
    };
    let Some((arguments, end)) = exchange.called else {
        return fault(FaultKind::GraderFault, "unresolved".to_owned(), format!("{call}: no such element"), Vec::new());
    };
    let values = match end {
        CallEnd::Returned(values) => values,
        CallEnd::Panicked { .. } | CallEnd::Stopped(_) => {
            let kind = FaultKind::of_end(end)?;
            let h = HalfEdgeId::new(*arguments.first()?);
            let alone = exchange.before().is_some_and(|table| match function {
                "destination" => table.next(h).is_none(),
                "destination_by_next" => table.twin(h).is_none(),
                _ => false,
            });
            let why = match (alone, function) {
                (true, "destination") => "; only twins are set here, and the twin is all that it needs",
                (true, _) => "; no twin is set here: find the destination without it",
                _ => "",
            };
            return fault(kind, "panic".to_owned(), format!("{call} {}{why}", end.words()), Vec::new());
        }
    };
    let found: Vec<u32> = values.iter().filter_map(Value::id).collect();
    let (&argument, table) = (arguments.first()?, exchange.before()?);
    let walk = expected(table, function, argument)?;
    if found.len() != values.len() {
        let words = format!("{call} did not return numbers of elements");
        return fault(FaultKind::Wrong, "type".to_owned(), words, Vec::new());
    }
    let wrong = cyclic::compare(&found, &walk.elements)?;
    let (tag, because) = walk.explain(table, &found, wrong);
    let words = format!(
        "{call} returned {}, expected {}{}: {because}",
        walk.list(&found),
        walk.list(&walk.elements),
        walk.any_start()
    );
    let wrong = fault(FaultKind::Wrong, tag, words, found.iter().map(|&n| (walk.element)(n)).collect());
    let is = readings::of(table, function, argument, &found);
    wrong.map(|fault| Fault { instead: Some(Instead { subject: "the answer".to_owned(), is }), ..fault })
}
