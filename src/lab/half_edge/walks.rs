//! The functions that only read: round a face, round a vertex, to the other end of a half-edge.
//!
//! ```text
//!   walk_face f1          h0 h2 h4      any start, counter-clockwise along next
//!   walk_vertices f1      v0 v1 v2      their origins
//!   walk_vertex v0        h0 h5         any start, counter-clockwise: prev.twin
//!   destination h0        v1            origin of the twin
//! ```

use super::{costs, readings};
use crate::checks::cyclic::{self, WalkFault};
use crate::checks::spec::{cycle, star};
use crate::fault::{Exchange, Fault, FaultKind, Instead, exchanges};
use crate::protocol::{CallEnd, Case, CaseAnswer, Value};
use dcel_kit::topology::{Table, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};

/// Judges every call of a case by what it returned.
pub(super) fn judge(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let mut faults: Vec<Fault> = exchanges(case, answer).iter().filter_map(|exchange| fault(test, exchange)).collect();
    faults.extend(costs::judge(test, case, answer));
    faults
}

fn fault(test: &'static str, exchange: &Exchange) -> Option<Fault> {
    let Exchange { step, function, .. } = *exchange;
    let call = format!("{function} {}", exchange.words.join(" "));
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
            let alone = exchange.before.is_some_and(|table| match function {
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
    let found: Vec<u32> = values.iter().filter_map(|value| number(*value)).collect();
    let (&argument, table) = (arguments.first()?, exchange.before?);
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

fn number(value: Value) -> Option<u32> {
    match value {
        Value::Number(n) => Some(n),
        Value::Truth(_) => None,
    }
}

/// What a call should return.
pub(super) struct Walk {
    /// The numbers, in order, from any start.
    pub(super) elements: Vec<u32>,
    /// What a number names.
    pub(super) element: fn(u32) -> Element,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Face,
    Corners,
    Star,
    Destination(HalfEdgeId),
}

/// The right answer to a reading call; `None` for other functions and for elements without pointers.
pub(super) fn expected(table: &Table, function: &str, argument: u32) -> Option<Walk> {
    let half_edge = |n| Element::HalfEdge(HalfEdgeId::new(n));
    let vertex = |n| Element::Vertex(VertexId::new(n));
    let numbers = |walk: Vec<HalfEdgeId>| walk.into_iter().map(HalfEdgeId::number).collect::<Vec<_>>();
    Some(match function {
        "walk_face" => {
            let elements = numbers(cycle(table, table.boundary(FaceId::new(argument))?));
            Walk { elements, element: half_edge, kind: Kind::Face }
        }
        "walk_vertices" => {
            let walk = cycle(table, table.boundary(FaceId::new(argument))?);
            let elements = walk.into_iter().filter_map(|h| table.origin(h)).map(VertexId::number).collect();
            Walk { elements, element: vertex, kind: Kind::Corners }
        }
        "walk_vertex" => {
            let elements = numbers(star(table, table.outgoing(VertexId::new(argument))?));
            Walk { elements, element: half_edge, kind: Kind::Star }
        }
        "destination" | "destination_by_next" => {
            let h = HalfEdgeId::new(argument);
            let end = if function == "destination" { table.twin(h)? } else { table.next(h)? };
            let elements = vec![table.origin(end)?.number()];
            Walk { elements, element: vertex, kind: Kind::Destination(h) }
        }
        _ => return None,
    })
}

impl Walk {
    fn list(&self, numbers: &[u32]) -> String {
        let names: Vec<String> = numbers.iter().take(12).map(|&n| (self.element)(n).to_string()).collect();
        match numbers.len() {
            0 => "nothing".to_owned(),
            13.. => format!("{} … ({} in all)", names.join(" "), numbers.len()),
            _ => names.join(" "),
        }
    }

    fn any_start(&self) -> &'static str {
        if self.elements.len() > 1 { " (from any start)" } else { "" }
    }

    /// What went wrong, more closely than a comparison of lists can say.
    fn explain(&self, table: &Table, found: &[u32], wrong: WalkFault) -> (String, String) {
        let twin = |n: u32| table.twin(HalfEdgeId::new(n)).map_or(u32::MAX, HalfEdgeId::number);
        let twins = || self.elements.iter().map(|&n| twin(n)).collect::<Vec<_>>();
        let reversed = |list: &[u32]| list.iter().rev().copied().collect::<Vec<_>>();
        let said = |tag: &str, words: &str| (tag.to_owned(), words.to_owned());
        match self.kind {
            Kind::Face if cyclic::is_rotation(found, &twins()) || cyclic::is_rotation(found, &reversed(&twins())) => {
                said("Twins", "these are the twins, on the other side of the boundary")
            }
            Kind::Star if cyclic::is_rotation(found, &twins()) || cyclic::is_rotation(found, &reversed(&twins())) => {
                said("Incoming", "these end at the vertex; take the ones that start there")
            }
            Kind::Star if matches!(wrong, WalkFault::StopsEarly | WalkFault::OneMissing) => {
                (format!("{wrong:?}"), "the walk round the vertex does not come all the way round".to_owned())
            }
            Kind::Destination(h) if found.len() == 1 && table.origin(h).map(VertexId::number) == Some(found[0]) => {
                said("Origin", "that is the origin")
            }
            Kind::Destination(_) => said("Elsewhere", "the half-edge does not end there"),
            _ => (format!("{wrong:?}"), wrong.to_string()),
        }
    }
}
