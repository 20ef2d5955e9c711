//! What is wrong with a call: the structure after it against the one that the reference makes.

use super::reference::{self, round};
use crate::answers;
use crate::checks::faults::Faults;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Dcel, Difference, IsomorphismOptions, Table, View, isomorphic_with, measure};
use dcel_kit::{Element, HalfEdgeId, VertexId};

/// A table without an outer face: these surfaces have none.
pub(super) fn closed(table: &Table) -> Table {
    Table { outer_face: None, ..table.clone() }
}

/// The genus of a surface.
pub(super) fn genus(table: &Table) -> i64 {
    measure(&closed(table)).genus()
}

/// The surface that a function should make, and how many numbers it is asked with.
fn shape(function: &str, numbers: &[usize]) -> Option<Table> {
    match (function, numbers) {
        ("torus_seed", []) => Some(Table::from_view(&Dcel::torus())),
        ("ring", &[sides]) => reference::ring(sides),
        ("grid", &[n, m]) => reference::grid(n, m),
        ("torus", &[n, m]) => reference::torus(n, m),
        ("cylinder", &[sides, layers]) => reference::tube(sides, layers, [false; 2]),
        ("cone", &[sides, layers]) => reference::tube(sides, layers.checked_sub(1)?, [true, false]),
        ("sphere", &[sides, bands]) => reference::tube(sides, bands.checked_sub(2)?, [true; 2]),
        ("cube", &[steps]) => reference::cube(steps),
        _ => None,
    }
}

/// What is wrong with a call.
pub(super) fn judge(exchange: &Exchange, test: &'static str, faults: &mut Faults) -> Option<()> {
    let (ids, end) = exchange.called?;
    let values = faults.returned(end, &[test])?;
    let numbers: Vec<usize> = exchange.words.iter().filter_map(|word| word.parse().ok()).collect();
    let Some(after) = exchange.after().map(|after| closed(after)) else {
        count(exchange.function, test, &closed(exchange.before()?), values, faults);
        return None;
    };
    if let Some(expected) = shape(exchange.function, &numbers) {
        compare(test, &after, &expected, |_| false, faults);
        return None;
    }
    let before = closed(exchange.before()?);
    let mut expected = before.clone();
    let h = |i: usize| ids.get(i).map(|&id| HalfEdgeId::new(id));
    let (first, second) = (h(0)?, h(1));
    let number = |i: usize| numbers.get(i).copied().unwrap_or(1);
    let belong = match (exchange.function, second) {
        ("split_vertex", Some(last)) => before.origin(first) == before.origin(last),
        ("split_face", Some(other)) => before.face(first) == before.face(other),
        _ => true,
    };
    let [alike, unlike] = if exchange.function == "split_vertex" {
        ["start at the same vertex", "start at different vertices"]
    } else {
        ["have the same face", "have different faces"]
    };
    if !belong {
        if !matches!(values, [Value::Refusal(_)]) {
            faults.wrong(test, "accepted", &format!("expected None: the two half-edges {unlike}"), &[]);
        } else if after != before {
            faults.wrong(test, "refused.changed", "returned None, and has changed the structure", &[]);
        }
        return None;
    }
    if matches!(values, [Value::Refusal(_)]) {
        faults.wrong(test, "refused", &format!("returned None, but the two half-edges {alike}"), &[]);
        return None;
    }
    let made = match (exchange.function, second) {
        ("split_vertex", Some(last)) => reference::split_vertex(&mut expected, first, last).map(|_| ()),
        ("split_face", Some(other)) => reference::split_face(&mut expected, first, other).map(|_| ()),
        ("pole", _) => reference::pole(&mut expected, first),
        ("divide", _) => reference::divide(&mut expected, first, number(0)),
        ("fill", _) => reference::fill(&mut expected, first, number(0), number(1)),
        ("extrude", _) => reference::extrude(&mut expected, first).map(|_| ()),
        _ => None,
    };
    let keeps = |element| is_old(&before, element) && !may_move(exchange.function, &before, first, element);
    if made.is_some() && compare(test, &after, &expected, keeps, faults) {
        returned(exchange.function, test, [&before, &after], (first, number(0)), values, faults);
    }
    Some(())
}

/// The values of `euler` and `genus`.
fn count(function: &str, test: &'static str, before: &Table, values: &[Value], faults: &mut Faults) {
    let counts = measure(before);
    let expected = if function == "euler" { counts.closed_euler() } else { counts.genus() };
    if values != [Value::Number(expected as f64)] {
        faults.wrong(test, function, &format!("expected {expected}"), &[]);
    }
}

/// Whether an element was there before the call.
fn is_old(before: &Table, element: Element) -> bool {
    match element {
        Element::Vertex(v) => v.index() < before.vertices.len(),
        Element::HalfEdge(h) => h.index() < before.half_edges.len(),
        Element::Face(f) => f.index() < before.faces.len(),
        _ => false,
    }
}

/// Whether an old number may be that of any part: of a face that is cut, of an edge that is cut. The handout leaves it open.
fn may_move(function: &str, before: &Table, h: HalfEdgeId, element: Element) -> bool {
    match (function, element) {
        ("pole" | "fill", Element::Face(f)) => before.face(h) == Some(f),
        ("divide", Element::HalfEdge(other)) => other == h || before.twin(h) == Some(other),
        _ => false,
    }
}

/// Whether the structure is as expected, with those elements that keep their numbers.
fn compare(
    test: &'static str,
    after: &Table,
    expected: &Table,
    keeps: impl Fn(Element) -> bool,
    faults: &mut Faults,
) -> bool {
    match isomorphic_with(after, expected, &IsomorphismOptions::new().fixed(&keeps)) {
        Ok(_) => return true,
        Err(Difference::Broken { violation, .. }) => {
            faults.wrong(test, &format!("law.{}", violation.rule.id), &violation.to_string(), &[]);
        }
        Err(Difference::Unpaired { element, fixed: true, .. }) => {
            let words = format!("{element} was there before and is to keep its place; it has another one now");
            faults.wrong(test, "shape", &words, &[]);
        }
        Err(difference) => faults.wrong(test, "shape", &difference.to_string(), &[]),
    }
    false
}

/// What a function returns of the structure that it has made rightly.
fn returned(
    function: &str,
    test: &'static str,
    [before, after]: [&Table; 2],
    (h, pieces): (HalfEdgeId, usize),
    values: &[Value],
    faults: &mut Faults,
) {
    let id = if let [Value::Id(id)] = values { Some(*id) } else { None };
    let edge = id.map(HalfEdgeId::new);
    let is_new = id.is_some_and(|id| id as usize >= before.half_edges.len());
    let right = match function {
        "split_vertex" => {
            let end = edge.and_then(|edge| after.twin(edge)).and_then(|twin| after.origin(twin));
            is_new && end.is_some_and(|v| v.index() >= before.vertices.len())
        }
        "split_face" => {
            let face = edge.and_then(|edge| after.face(edge));
            is_new && face.is_some_and(|f| f.index() >= before.faces.len())
        }
        "pole" => id.is_some_and(|id| VertexId::new(id).index() == before.vertices.len()),
        "divide" => edge.is_some_and(|edge| {
            let round = round(after, edge).unwrap_or_default();
            let pieces = round.get(..pieces).unwrap_or_default();
            let is_new = |h: &HalfEdgeId| after.origin(*h).is_some_and(|v| v.index() >= before.vertices.len());
            // They run from where h started along new vertices, and one of them is h itself.
            after.origin(edge) == before.origin(h)
                && after.face(edge) == before.face(h)
                && pieces.contains(&h)
                && pieces.iter().skip(1).all(is_new)
        }),
        "extrude" => edge.is_some_and(|edge| {
            let across = after.twin(edge).and_then(|twin| after.next(twin)).and_then(|up| after.next(up));
            after.face(edge) == before.face(h) && across == Some(h)
        }),
        _ => true,
    };
    if !right {
        let due = match function {
            "split_vertex" => "the new half-edge that ends at the new vertex",
            "split_face" => "the new half-edge with the new face on its left",
            "pole" => "the new vertex",
            "divide" => "the piece that starts where the half-edge started, in its face",
            _ => "the half-edge of the face on top that lies above the given one",
        };
        let words = format!("the structure is right, but {} was returned, which is not {due}", answers::listed(values));
        faults.wrong(test, &format!("{function}.returned"), &words, &[]);
    }
}
