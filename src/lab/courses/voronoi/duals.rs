//! The dual of a structure, and the Voronoi vertices.

use super::centres;
use crate::answers::Wrong;
use crate::checks::duals;
use crate::checks::walks::{cycle, half_edges, place};
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, VertexId};

/// The dual that a call gave back.
fn returned(values: &[Value]) -> Option<&Table> {
    let [Value::Structure(found)] = values else { return None };
    found.half_edges().map(AsRef::as_ref)
}

/// What is wrong with a dual, places aside.
fn links(table: &Table, dual: &Table) -> Option<Wrong> {
    let half_edge = |h| {
        // Round a vertex, half-edge after half-edge.
        let next = table.prev(h).and_then(|prev| table.twin(prev));
        let prev = table.twin(h).and_then(|twin| table.next(twin));
        duals::crossing(table, dual, h)
            .or_else(|| duals::field("next", h, dual.next(h), next))
            .or_else(|| duals::field("prev", h, dual.prev(h), prev))
    };
    duals::counts(table, dual)
        .or_else(|| half_edges(table).find_map(half_edge))
        .or_else(|| duals::representatives("its ", dual))
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let Some(dual) = returned(values) else { return Some(Wrong::kind("a structure")) };
    let all = (0..table.faces.len() as u32).map(FaceId::new);
    links(table, dual).or_else(|| all.filter_map(|f| moved(dual, f, "where all vertices of a dual are")).next())
}

/// What is wrong with the vertex of a face that should be at (0, 0).
fn moved(dual: &Table, f: FaceId, why: &str) -> Option<Wrong> {
    let [x, y] = place(dual, VertexId::new(f.number()))?;
    let is_moved = [x, y].iter().any(|x| x.is_nan() || x.abs() > 0.0);
    is_moved.then(|| Wrong::because("at_zero", format!("its v{} is at ({x}, {y}), expected (0, 0), {why}", f.number())))
}

/// The corners of a triangle.
pub(super) fn corners(table: &Table, f: FaceId) -> Option<[[f64; 2]; 3]> {
    let round = cycle(table, table.half_edge(f)?);
    let corners: Vec<[f64; 2]> = round.into_iter().map(|h| place(table, table.origin(h)?)).collect::<Option<_>>()?;
    corners.try_into().ok()
}

/// The centre of the circle of a triangle, and its radius.
pub(super) fn centre(table: &Table, f: FaceId) -> Option<([f64; 2], f64)> {
    let [a, b, c] = corners(table, f)?;
    centres::centre(a, b, c)
}

/// The faces but the outer one.
pub(super) fn triangles(table: &Table) -> impl Iterator<Item = FaceId> {
    (0..table.faces.len() as u32).map(FaceId::new).filter(|f| Some(*f) != table.outer_face)
}

pub(super) fn wrong_voronoi(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let Some(voronoi) = returned(values) else { return Some(Wrong::kind("a structure")) };
    if let Some(wrong) = links(table, voronoi) {
        return Some(wrong);
    }
    for f in triangles(table) {
        let (expected, radius) = centre(table, f)?;
        let own = place(voronoi, VertexId::new(f.number()))?;
        if centres::is_off(own, expected, radius) {
            let ([x, y], [a, b]) = (own, expected);
            let because = format!("its v{} is at ({x}, {y}), expected ({a}, {b}), the centre of {f}", f.number());
            let is_centre = |g| centre(table, g).is_some_and(|(place, radius)| !centres::is_off(own, place, radius));
            let of_other = triangles(table).any(|g| g != f && is_centre(g));
            let mean =
                corners(table, f)?.into_iter().fold([0.0; 2], |sum, p| [sum[0] + p[0] / 3.0, sum[1] + p[1] / 3.0]);
            let is_mean = !centres::is_off(own, mean, radius);
            let tag = if is_mean { "mean" } else { "place" };
            let is = [(is_mean, "the mean of the corners"), (of_other, "the centre of another triangle")];
            return Some(Wrong::because(tag, because).is(is));
        }
    }
    moved(voronoi, table.outer_face?, "as it stands for the outer face")
}
