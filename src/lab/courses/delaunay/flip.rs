//! The flip, in the three steps of the handout.
//!
//! ```text
//!   1 origins of both halves, and what a and b refer to         c                c
//!   2 next and prev of all six half-edges                     ╱   ╲            ╱ │ ╲
//!   3 faces, and what they refer to                         a ──h──▶ b  ==>  a   h   b
//!                                                             ╲   ╱            ╲ │ ╱
//!                                                               d                d
//! ```

use crate::cases::cycles::row_mut;
use crate::checks::align::{Aligned, Difference, Field, New, differences};
use crate::checks::steps::{ELSEWHERE, Steps};
use crate::fault::{Exchange, Fault};
use dcel_kit::topology::{HalfEdgeRow, Table, View};
use dcel_kit::{Element, HalfEdgeId, VertexId};

/// The graded test of each step; there is no step 0, because every call is legal.
pub(super) const TESTS: [&str; 4] = ["flip_1_origins", "flip_1_origins", "flip_2_links", "flip_3_faces"];

/// Whether two different triangles, neither of them the outer face, lie at an edge.
pub(super) fn is_between_triangles(table: &Table, h: HalfEdgeId) -> bool {
    let Some(twin) = table.twin(h) else { return false };
    let inside = |h| table.face(h).is_some() && table.face(h) != table.outer_face;
    inside(h) && inside(twin) && table.face(h) != table.face(twin)
}

/// The corners of the two triangles at an edge: its origin, its end, the corner on its left and that on its right.
pub(super) fn corners(table: &Table, h: HalfEdgeId) -> Option<[VertexId; 4]> {
    let twin = table.twin(h)?;
    let across = |h| table.prev(h).and_then(|prev| table.origin(prev));
    is_between_triangles(table, h).then_some(())?;
    Some([table.origin(h)?, table.origin(twin)?, across(h)?, across(twin)?])
}

/// Whether an edge between two triangles is no loop, and will be none after a flip.
pub(super) fn is_plain(table: &Table, h: HalfEdgeId) -> bool {
    corners(table, h).is_some_and(|[a, b, c, d]| a != b && c != d)
}

/// Turns an edge between two triangles counter-clockwise, each half on the left of its own face.
pub(super) fn flip(table: &mut Table, h: HalfEdgeId) -> Option<()> {
    let [a, b, c, d] = corners(table, h)?;
    let twin = table.twin(h)?;
    // Each triangle is made anew: the edge, the side that stays, the side that comes over.
    let around = [(h, d, table.prev(h)?, c, table.next(twin)?, a), (twin, c, table.prev(twin)?, d, table.next(h)?, b)];
    let faces = [table.face(h)?, table.face(twin)?];
    for ((edge, from, stays, apex, comes, last), face) in around.into_iter().zip(faces) {
        let cycle = [(edge, from), (stays, apex), (comes, last)];
        for (i, &(side, origin)) in cycle.iter().enumerate() {
            let row = row_mut(table, side)?;
            let (after, before) = (cycle[(i + 1) % 3].0, cycle[(i + 2) % 3].0);
            *row = HalfEdgeRow {
                origin: Some(origin),
                next: Some(after),
                prev: Some(before),
                face: Some(face),
                twin: row.twin,
            };
        }
        table.faces.get_mut(face.index())?.as_mut()?.half_edge = Some(edge);
        table.vertices.get_mut(last.index())?.as_mut()?.outgoing = Some(comes);
    }
    Some(())
}

/// The structure that a call should leave behind.
pub(super) fn expected(exchange: &Exchange) -> Option<Table> {
    let mut table = exchange.before()?.as_ref().clone();
    flip(&mut table, HalfEdgeId::new(*exchange.called?.0.first()?))?;
    Some(table)
}

/// What is wrong with a call.
pub(super) fn judge(exchange: &Exchange) -> Vec<Fault> {
    let Some(((mut steps, [h]), expected)) = Steps::of(exchange, &TESTS).zip(expected(exchange)) else {
        return Vec::new();
    };
    let (before, after) = (steps.before, steps.after);
    let counts = [
        steps.count(1, "vertices", [before.vertices.len(), after.vertices.len()], 0),
        steps.count(2, "half-edges", [before.half_edges.len(), after.half_edges.len()], 0),
        steps.count(3, "faces", [before.faces.len(), after.faces.len()], 0),
    ];
    if counts.contains(&false) {
        return steps.faults;
    }
    let differences = differences(&expected, after);
    let twin = before.twin(h);
    let [next, prev] = [before.next(h), before.prev(h)];
    let of_twin = |step: fn(&Table, HalfEdgeId) -> Option<HalfEdgeId>| twin.and_then(|twin| step(before, twin));
    let [twin_next, twin_prev] = [of_twin(View::next), of_twin(View::prev)];
    let corners = corners(before, h);
    let role = |element| match element {
        Element::HalfEdge(g) if g == h => "h",
        Element::HalfEdge(g) if Some(g) == twin => "the twin",
        Element::HalfEdge(g) if Some(g) == next => "the one that was after h",
        Element::HalfEdge(g) if Some(g) == prev => "the one before h",
        Element::HalfEdge(g) if Some(g) == twin_next => "the one that was after the twin",
        Element::HalfEdge(g) if Some(g) == twin_prev => "the one before the twin",
        Element::Vertex(v) if corners.is_some_and(|all| all[0] == v) => "the vertex where h began",
        Element::Vertex(v) if corners.is_some_and(|all| all[1] == v) => "the vertex where h ended",
        Element::Vertex(v) if corners.is_some_and(|all| all[2] == v) => "the corner on the left",
        Element::Vertex(v) if corners.is_some_and(|all| all[3] == v) => "the corner on the right",
        Element::Face(f) if before.face(h) == Some(f) => "the face of h",
        Element::Face(f) if twin.is_some_and(|twin| before.face(twin) == Some(f)) => "the face of the twin",
        _ => ELSEWHERE,
    };
    steps.differences(&Aligned { expected, new: New::default(), differences }, step_of, role);
    steps.must_have_returned();
    steps.faults
}

fn step_of(difference: &Difference) -> usize {
    match difference.field {
        Field::Next | Field::Prev => 2,
        Field::Face | Field::Boundary | Field::OuterFace => 3,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::super::meshes::fixed;
    use super::*;
    use crate::checks::walks::half_edges;
    use dcel_kit::plane::{Point, Subdivision};
    use dcel_kit::topology::violations;
    use std::collections::BTreeSet;

    /// The triangles of a table, each from its smallest corner.
    fn triangles(table: &Table) -> BTreeSet<[u32; 3]> {
        let inside = half_edges(table).filter(|&h| table.face(h) != table.outer_face);
        let corners = inside.map(|h| {
            let round = [Some(h), table.next(h), table.prev(h)].map(|h| table.origin(h.unwrap()).unwrap().number());
            let least = (0..3).min_by_key(|&i| round[i]).unwrap();
            [0, 1, 2].map(|i| round[(i + least) % 3])
        });
        corners.collect()
    }

    /// The kit's own flips, on its own records, lead to the same triangles.
    #[test]
    fn a_flip_is_that_of_the_kit_and_four_change_nothing() {
        for mesh in fixed().into_iter().filter(|mesh| mesh.triangles.len() < 40) {
            let table = mesh.table();
            let places: Vec<Point> = mesh.points.iter().copied().map(Point::from).collect();
            for h in half_edges(&table).filter(|&h| is_between_triangles(&table, h)) {
                let mut own = table.clone();
                flip(&mut own, h).unwrap();
                assert_eq!(violations(&own), []);
                let mut kit = Subdivision::from_triangles(places.clone(), &mesh.triangles).unwrap();
                let [a, b, c, d] = corners(&table, h).unwrap();
                let edge = kit.find_half_edge(a, b).unwrap();
                if kit.flip_edge(edge).is_ok() {
                    let all: BTreeSet<[u32; 3]> = triangles(&Table::from_view(&kit));
                    assert_eq!(triangles(&own), all, "{} {h}", mesh.name);
                }
                assert_eq!([own.origin(h), own.origin(own.twin(h).unwrap())], [Some(d), Some(c)]);
                (0..3).for_each(|_| flip(&mut own, h).unwrap());
                assert_eq!(differences(&table, &own), []);
            }
        }
    }
}
