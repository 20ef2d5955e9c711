//! What can be said of a call of this lab before it is made.

use super::cells;
use super::centres;
use super::duals::{corners, triangles};
use crate::FeatureSet;
use crate::checks::walks::{place, star};
use crate::fault::Exchange;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;
use dcel_kit::topology::{Table, View};
use dcel_kit::{HalfEdgeId, VertexId};
use std::sync::Arc;

crate::features! {
    OneLine "one_line" "the three points are on one line",
    NotOneLine "not_one_line" "the three points are not on one line",
    DoublesMiss "doubles_miss" "doubles do not say that the points are on one line, or say it wrongly",
    Far "far" "the triangle is so far from (0, 0) that squares of its coordinates lose it",
    Clockwise "clockwise" "the three points turn right",
    LookedAt "looked_at" "there is a circle, and no angle of the triangle is very small",
    NotAtZero "not_at_zero" "the first point is not (0, 0)",

    OuterFace "outer_face" "the half-edge is on the outer face",
    Inside "inside" "the half-edge is not on the outer face",
    BothInside "both_inside" "triangles are on both sides of the edge",
    CentreBeyond "centre_beyond" "the centre of the triangle lies on the edge of the ray, or beyond",
    Border "border" "the vertex is on the border",
    NotBorder "not_border" "the vertex is inside",
    OneTriangle "one_triangle" "the vertex has one triangle",
    SeveralTriangles "several_triangles" "the vertex has more than one triangle",
    BorderStored "border_stored" "the stored half-edge of the vertex is not that after the outer face",
    Backwards "backwards" "the corners of the cell are others when they are read backwards",
    FromStored "from_stored" "the corners are others when they begin at the stored half-edge",
    Degree8 "degree_8" "the vertex has more than 8 triangles",
    Degree3 "degree_3" "a vertex has more than two edges",
    NotTriangles "not_triangles" "a face is no triangle",
    OneFace "one_face" "an edge has one face on both sides",
    Large "large" "there are more than 256 half-edges",
    Blind "blind" "all vertices are at one place",
    OuterNot0 "outer_not_0" "the outer face is not f0",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    let argument = exchange.called.and_then(|(arguments, _)| arguments.first().copied());
    match exchange.function {
        "circle_centre" => of_points(exchange, &mut set)?,
        "ray" => of_ray(exchange.before()?, HalfEdgeId::new(argument?), &mut set),
        "cell" => of_cell(exchange.before()?, VertexId::new(argument?), &mut set)?,
        _ => of_table(exchange.before()?, &mut set),
    }
    let is_other = |table: &Arc<Table>| table.outer_face.is_some_and(|f| f.number() != 0);
    set.add(Word::OuterNot0, exchange.function != "circle_centre" && exchange.before().is_some_and(is_other));
    Some(set.bits())
}

fn of_points(exchange: &Exchange, set: &mut FeatureSet) -> Option<()> {
    let [a, b, c] = centres::asked(exchange)?;
    let turn = orientation(Point::from(a), Point::from(b), Point::from(c));
    let plain = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    set.either(Word::OneLine, Word::NotOneLine, turn.is_eq());
    set.add(Word::DoublesMiss, (plain.abs() <= 0.0) != turn.is_eq());
    set.add(Word::Far, centres::is_lost_from_the_origin([a, b, c]));
    set.add(Word::Clockwise, turn.is_lt());
    set.add(Word::LookedAt, centres::is_looked_at([a, b, c]));
    set.add(Word::NotAtZero, centres::moves_with_a([a, b, c]));
    Some(())
}

fn of_ray(table: &Table, h: HalfEdgeId, set: &mut FeatureSet) {
    let ray = cells::ray(table, h);
    set.either(Word::OuterFace, Word::Inside, ray.is_some());
    let beyond = ray.is_some_and(|([x, y], _, [dx, dy])| {
        let begin = table.origin(h).and_then(|v| place(table, v)).unwrap_or_default();
        let (along, size) = ((x - begin[0]) * dx + (y - begin[1]) * dy, (x - begin[0]).hypot(y - begin[1]));
        along > -1e-9 * size * dx.hypot(dy)
    });
    let other = table.twin(h).and_then(|twin| table.face(twin));
    set.add(Word::BothInside, ray.is_none() && other != table.outer_face);
    set.add(Word::CentreBeyond, beyond);
}

fn of_cell(table: &Table, v: VertexId, set: &mut FeatureSet) -> Option<()> {
    let (corners, open) = cells::cell(table, v)?;
    set.either(Word::Border, Word::NotBorder, open);
    set.either(Word::OneTriangle, Word::SeveralTriangles, corners.len() < 2);
    set.add(Word::Degree8, corners.len() > 8);
    set.add(Word::Backwards, cells::differs_backwards(table, v)?);
    set.add(Word::FromStored, cells::differs_from_stored(table, v)?);
    let stored = table.outgoing(v)?;
    let before = table.twin(stored).and_then(|twin| table.face(twin));
    set.add(Word::BorderStored, open && corners.len() > 1 && before != table.outer_face);
    Some(())
}

fn of_table(table: &Table, set: &mut FeatureSet) {
    let sizes = triangles(table).map(|f| corners(table, f)).collect::<Vec<_>>();
    let degree = |v| table.outgoing(VertexId::new(v)).map_or(0, |h| star(table, h).len());
    set.add(Word::Degree3, (0..table.vertices.len() as u32).any(|v| degree(v) > 2));
    set.add(Word::NotTriangles, sizes.contains(&None));
    let half_edges = || (0..table.half_edges.len() as u32).map(HalfEdgeId::new);
    let one = |h| table.twin(h).is_some_and(|twin| table.face(twin) == table.face(h));
    set.add(Word::OneFace, half_edges().any(one));
    set.add(Word::Large, table.half_edges.len() > 256);
    let places: Vec<_> = (0..table.vertices.len() as u32).map(|v| place(table, VertexId::new(v))).collect();
    set.add(Word::Blind, places.windows(2).all(|pair| pair[0] == pair[1]));
}
