//! Judging `delaunify`: the flips that it tells are made again, one after the other.
//!
//! ```text
//!   before ── flip h4: is it due? ── flip h9: is it due? ── …  ══  after?   and is every edge legal there?
//! ```

use super::edges::{due, is_legal};
use super::flip::flip;
use crate::answers::Wrong;
use crate::checks::align::differences;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};

/// The half-edges of a list of numbers.
fn listed(values: &[Value], table: &Table) -> Option<Vec<HalfEdgeId>> {
    let half_edge = |value: &Value| match value {
        Value::Id(number) => Some(HalfEdgeId::new(*number)).filter(|h| table.has_half_edge(*h)),
        _ => None,
    };
    values.iter().map(half_edge).collect()
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (before, after) = (exchange.before()?, exchange.after()?);
    let Some(flips) = listed(values, before) else { return Some(Wrong::kind("a list of half-edges")) };
    let sizes = |table: &Table| [table.vertices.len(), table.half_edges.len(), table.faces.len()];
    if sizes(before) != sizes(after) {
        return Some(Wrong::because("count", "a flip makes no record, but the number of records has changed"));
    }
    if let Some(h) = due(after) {
        return Some(Wrong::because("illegal", format!("the edge of {h} is not legal in the end")));
    }
    let mut now = before.as_ref().clone();
    for (i, &h) in flips.iter().enumerate() {
        if is_legal(&now, h) {
            let because = format!("its flip number {}, of {h}, was not due: that edge was legal then", i + 1);
            return Some(Wrong::because("not due", because));
        }
        flip(&mut now, h)?;
    }
    let difference = differences(&now, after).into_iter().next()?;
    Some(Wrong::because("list", format!("these flips do not lead to what is there in the end: {difference}")))
}

#[cfg(test)]
mod tests {
    use super::super::edges::place;
    use super::super::meshes::fixed;
    use super::*;
    use crate::checks::walks::half_edges;
    use dcel_kit::plane::predicates::in_circle;
    use dcel_kit::plane::{Point, Subdivision};

    /// The triangles in the end are empty, and as many flips are told as the kit makes in the same order.
    #[test]
    fn when_all_edges_are_legal_no_vertex_is_in_a_circle() {
        for mesh in fixed().into_iter().filter(|mesh| mesh.name != "bay" && !mesh.name.starts_with("arrow")) {
            let mut table = mesh.table();
            let mut flips = 0;
            while let Some(h) = due(&table) {
                flip(&mut table, h).unwrap();
                flips += 1;
            }
            let n = mesh.points.len();
            assert!(flips <= n * (n - 1) / 2, "{}: {flips}", mesh.name);
            for h in half_edges(&table).filter(|&h| table.face(h) != table.outer_face) {
                let corners = [Some(h), table.next(h), table.prev(h)].map(|h| table.origin(h.unwrap()).unwrap());
                let [a, b, c] = corners.map(|v| place(&table, v).unwrap());
                for &p in &mesh.points {
                    assert!(in_circle(a, b, c, p.into()).is_le(), "{}", mesh.name);
                }
            }
            let places: Vec<Point> = mesh.points.iter().copied().map(Point::from).collect();
            let mut kit = Subdivision::from_triangles(places, &mesh.triangles).unwrap();
            assert_eq!(kit.make_delaunay(|_| false) > 0, flips > 0, "{}", mesh.name);
        }
    }
}
