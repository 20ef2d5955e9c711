//! What the walks should list: the vertices around a vertex, the rows of the winged-edge table.

use super::surface::Surface;
use crate::answers::Wrong;
use crate::checks::cyclic;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::View;

/// The vertices that an edge joins with this one, counter-clockwise.
pub(super) fn around(surface: &Surface, v: u32) -> Vec<u32> {
    surface.spokes(v).into_iter().filter_map(|h| surface.end(h)).collect()
}

pub(super) fn vertices_around(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let expected = around(&surface, *exchange.called?.0.first()?);
    let found: Vec<u32> = values.iter().filter_map(Value::id).collect();
    if found.len() != values.len() {
        return Some(Wrong::kind("a list of vertices"));
    }
    let wrong = cyclic::compare(&found, &expected)?;
    let expected = Value::List(expected.into_iter().map(Value::Id).collect());
    Some(Wrong { tag: format!("{wrong:?}"), ..Wrong::value(&expected, wrong.to_string()) })
}

/// The fields of a row.
const FIELDS: [&str; 9] =
    ["edge", "start", "end", "left", "right", "left_before", "left_after", "right_before", "right_after"];

/// The winged-edge table, an edge after the other.
fn table(surface: &Surface) -> Option<Vec<[u32; 9]>> {
    let edge = |h: HalfEdgeId| Some(h.number().min(surface.table.twin(h)?.number()));
    let mut rows = Vec::new();
    for left in surface.half_edges() {
        let right = surface.table.twin(left)?;
        if right < left {
            continue;
        }
        let mut row = vec![left.number(), surface.start(left)?, surface.start(right)?];
        row.extend([surface.table.face(left)?.number(), surface.table.face(right)?.number()]);
        for side in [left, right] {
            row.extend([edge(surface.table.prev(side)?)?, edge(surface.table.next(side)?)?]);
        }
        rows.push(row.try_into().ok()?);
    }
    Some(rows)
}

pub(super) fn winged_edges(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let expected = table(&Surface::of(exchange.records_before()?))?;
    let Some(found) = values.iter().map(Value::ids).collect::<Option<Vec<[u32; 9]>>>() else {
        return Some(Wrong::kind("a list of rows with nine numbers"));
    };
    if found.len() != expected.len() {
        let because = format!("there are {} rows, and {} edges", found.len(), expected.len());
        return Some(Wrong::because("rows", because));
    }
    let at = (0..found.len()).find(|&i| found[i] != expected[i])?;
    let [own, right] = [found[at], expected[at]];
    if own[0] != right[0] {
        let [found_there, due] = [own[0], right[0]].map(|edge| Value::Id(edge).words());
        let because = format!("row {at} is that of edge {found_there}, expected edge {due}");
        return Some(Wrong::because("edge", because));
    }
    let field = (0..9).find(|&i| own[i] != right[i])?;
    let said = |cell: u32| Value::Id(cell).words();
    let [edge, found_there, due] = [own[0], own[field], right[field]].map(said);
    let because = format!("in the row of edge {edge}, {} is {found_there}, expected {due}", FIELDS[field]);
    // The fields that are wrong in any row tell one mistake from another, and so does what stands in them instead.
    let is_wrong = |i: &usize| (0..found.len()).any(|at| found[at][*i] != expected[at][*i]);
    let named = |i: usize| {
        let instead = (0..9).find(|&j| (0..found.len()).all(|at| found[at][i] == expected[at][j]));
        instead.map_or_else(|| FIELDS[i].to_owned(), |j| format!("{}={}", FIELDS[i], FIELDS[j]))
    };
    let tag = (0..9).filter(is_wrong).map(named).collect::<Vec<_>>().join(".");
    Some(Wrong::because(&tag, because))
}
