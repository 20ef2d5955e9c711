//! Whether an edge is legal, and whether it can be flipped: by the kit's exact predicates.

use super::flip::corners;
use crate::answers::Wrong;
use crate::checks::walks::{self, half_edges};
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{in_circle, orientation};
use dcel_kit::topology::{Table, View};
use dcel_kit::{HalfEdgeId, VertexId};
use std::cmp::Ordering;

/// Where a vertex is.
pub(super) fn place(table: &Table, v: VertexId) -> Option<Point> {
    walks::place(table, v).map(Point::from)
}

/// The half-edge that a call asks about.
pub(super) fn asked(exchange: &Exchange) -> Option<HalfEdgeId> {
    Some(HalfEdgeId::new(*exchange.called?.0.first()?))
}

/// Whether the corner across an edge is inside the circle of the other triangle, on it or outside; nothing for an edge
/// of the border.
pub(super) fn across(table: &Table, h: HalfEdgeId) -> Option<Ordering> {
    let [a, b, c, d] = corners(table, h)?.map(|v| place(table, v).unwrap_or_default());
    Some(in_circle(a, b, c, d))
}

/// Whether an edge is legal.
pub(super) fn is_legal(table: &Table, h: HalfEdgeId) -> bool {
    across(table, h).is_none_or(Ordering::is_le)
}

/// The half-edges of edges that are not legal.
pub(super) fn illegal(table: &Table) -> impl Iterator<Item = HalfEdgeId> {
    half_edges(table).filter(|&h| !is_legal(table, h))
}

/// One of them, if there are any.
pub(super) fn due(table: &Table) -> Option<HalfEdgeId> {
    illegal(table).next()
}

pub(super) fn wrong_legal(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let h = asked(exchange)?;
    let [Value::Truth(found)] = values else { return Some(Wrong::kind("`true` or `false`")) };
    let because = match across(table, h) {
        None => "the edge is on the border",
        Some(Ordering::Less) => "the corner across lies outside of the circle",
        Some(Ordering::Equal) => "the corner across lies on the circle, and that is legal",
        Some(Ordering::Greater) => "the corner across lies inside of the circle",
    };
    let expected = is_legal(table, h);
    (*found != expected).then(|| Wrong::value(&Value::Truth(expected), because))
}

/// Where the quadrilateral of an edge is straight or turns right: which end of the edge, and how it turns there.
pub(super) fn bends(table: &Table, h: HalfEdgeId) -> Option<(VertexId, Ordering)> {
    let all = corners(table, h)?;
    let [a, b, c, d] = all.map(|v| place(table, v).unwrap_or_default());
    let turns = [(all[0], orientation(c, a, d)), (all[1], orientation(d, b, c))];
    turns.into_iter().find(|(_, turn)| turn.is_le())
}

/// The half of an edge that is on the outer face.
pub(super) fn outer_half(table: &Table, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let halves = [Some(h), table.twin(h)];
    halves.into_iter().flatten().find(|&half| table.face(half) == table.outer_face)
}

/// The refusal that is due.
fn refusal(table: &Table, h: HalfEdgeId) -> Option<String> {
    if let Some(half) = outer_half(table, h) {
        return Some(format!("half-edge {} is on the outer face", half.number()));
    }
    let (vertex, _) = bends(table, h)?;
    Some(format!("the quadrilateral does not turn left at vertex {}", vertex.number()))
}

pub(super) fn wrong_can_flip(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let due = refusal(table, asked(exchange)?);
    match (values, due) {
        ([Value::Truth(true)], None) => None,
        ([Value::Truth(true)], Some(due)) => Some(Wrong::because("accepted", format!("it returned Ok, but {due}"))),
        ([Value::Refusal(_)], None) => {
            let because = "there are two triangles, and they make a convex quadrilateral";
            Some(Wrong::because("refused", because))
        }
        ([Value::Refusal(why)], Some(due)) if *why != due => {
            let first = |text: &str| text.split(' ').next().unwrap_or_default().to_owned();
            let tag = if first(why) == first(&due) { "place" } else { "reason" };
            Some(Wrong::because(tag, format!("that is not so: {due}")))
        }
        ([Value::Refusal(_)], Some(_)) => None,
        _ => Some(Wrong::kind("Ok or a refusal")),
    }
}

#[cfg(test)]
mod tests {
    use super::super::meshes::fixed;
    use super::*;

    /// By rational numbers: the sign of the determinant of four points with small whole coordinates.
    fn brute(p: [[i128; 2]; 4]) -> i128 {
        let [a, b, c] = [0, 1, 2].map(|i| [p[i][0] - p[3][0], p[i][1] - p[3][1]]);
        let size = |p: [i128; 2]| p[0] * p[0] + p[1] * p[1];
        let cross = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - p[1] * q[0];
        (size(a) * cross(b, c) - size(b) * cross(a, c) + size(c) * cross(a, b)).signum()
    }

    #[test]
    fn edges_are_judged_as_whole_numbers_judge_them_and_as_the_kit_refuses_them() {
        let mut seen = [0; 3];
        for mesh in fixed() {
            let whole = |p: [f64; 2]| p.iter().all(|x| x.fract() == 0.0 && x.abs() < 1e6);
            let table = mesh.table();
            let places: Vec<Point> = mesh.points.iter().copied().map(Point::from).collect();
            let built = dcel_kit::plane::Subdivision::from_triangles(places, &mesh.triangles).unwrap();
            for h in half_edges(&table) {
                let Some(all) = corners(&table, h) else {
                    assert!(outer_half(&table, h).is_some());
                    continue;
                };
                let edge = built.find_half_edge(all[0], all[1]).unwrap();
                assert_eq!(built.can_flip_edge(edge).is_ok(), bends(&table, h).is_none(), "{} {h}", mesh.name);
                assert_eq!(built.is_locally_delaunay(edge), is_legal(&table, h), "{} {h}", mesh.name);
                let places = all.map(|v| mesh.points[v.index()]);
                if places.iter().all(|&p| whole(p)) {
                    let sign = brute(places.map(|p| p.map(|x| x as i128)));
                    assert_eq!(across(&table, h).unwrap() as i128, sign, "{} {h}", mesh.name);
                    seen[(sign + 1) as usize] += 1;
                }
                // What is not legal can be flipped.
                assert!(is_legal(&table, h) || bends(&table, h).is_none());
            }
        }
        assert!(seen.iter().all(|&count| count > 20), "{seen:?}");
    }
}
