//! What can be said of a call of this lab before it is made.

use super::mistakes::{self, Again};
use super::{angles, edges, flip};
use crate::FeatureSet;
use crate::checks::walks::half_edges;
use crate::fault::Exchange;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

crate::features! {
    Border "border" "the edge is on the border",
    InnerHalf "inner_half" "the edge is on the border, and the half-edge has its triangle on the left",
    OuterHalf "outer_half" "the half-edge is on the outer face",
    Inner "inner" "there is a triangle on both sides of the edge",
    Illegal "illegal" "the edge is not legal",
    OnCircle "on_circle" "the corner across lies on the circle",
    OffCircle "off_circle" "there is a corner across, and it does not lie on the circle",
    OutsideCircle "outside_circle" "the corner across lies outside of the circle",
    Doubles "doubles" "doubles are wrong about the circle",
    OuterTriangle "outer_triangle" "the edge is on the border, and would be illegal if the outer face were a triangle",
    OuterTriangleInner "outer_triangle_inner" "the same, and the half-edge has its triangle on the left",
    ZeroOuter "zero_outer" "the answer is another one if f0 is taken for the outer face",
    Everywhere "everywhere" "the edge is legal, and a vertex further away lies inside of the circle",

    Straight "straight" "the quadrilateral is straight at an end of the edge",
    Reflex "reflex" "the quadrilateral turns right at an end of the edge",
    NotConvex "not_convex" "the quadrilateral is not convex",
    BendsAtOrigin "bends_at_origin" "the quadrilateral is not convex where the half-edge begins",
    BendsAtEnd "bends_at_end" "the quadrilateral is not convex where the half-edge ends",
    Convex "convex" "the quadrilateral is convex",

    EndStores "end_stores" "an end of the edge stores a half of it",
    FaceStores "face_stores" "one of the triangles stores a half-edge that leaves it",
    OuterNotZero "outer_not_zero" "the outer face is not f0",
    Degree3 "degree_3" "an end of the edge has three edges",
    Beside "beside" "one of the other sides is on the border",
    Blind "blind" "all vertices are at one place",
    Odd "odd" "two edges have the same ends",

    AllLegal "all_legal" "all edges are legal from the beginning",
    Due "due" "an edge is not legal",
    Cocircular "cocircular" "four corners are on one circle",
    OnceDown "once_down" "it is not enough to look once at each edge, the last number first",
    OnceUp "once_up" "it is not enough to look once at each edge, the first number first",
    LeftOnly "left_only" "it is not enough to look again at the edges of one of the two triangles",

    StoredAngles "stored_angles" "the smallest angle is not where the stored half-edge of a face begins",
    Cosine "cosine" "an arc cosine rounds the smallest angle away",

    Alone "alone" "there is one triangle",
    Past256 "past_256" "there are more than 256 half-edges",
    Fine "fine" "a coordinate has a fraction",
}

/// Of a structure with more half-edges nothing is said: it would take too long.
const LARGE: usize = 10_000;

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let table = exchange.before()?;
    if table.half_edges.len() > LARGE {
        return None;
    }
    let mut set = FeatureSet::default();
    match exchange.function {
        "is_legal" => legal(table, edges::asked(exchange)?, &mut set),
        "can_flip" => can_flip(table, edges::asked(exchange)?, &mut set),
        "flip" => flips(table, edges::asked(exchange)?, &mut set),
        "delaunify" => delaunify(table, &mut set),
        "smallest_angle" => {
            set.add(Word::StoredAngles, angles::differs_at_stored(table));
            set.add(Word::Cosine, angles::differs_by_cosine(table));
        }
        _ => return None,
    }
    set.add(Word::OuterNotZero, table.outer_face != Some(FaceId::new(0)));
    set.add(Word::Alone, table.faces.len() == 2);
    set.add(Word::Past256, table.half_edges.len() > 256);
    let places = table.vertices.iter().flatten().filter_map(|row| row.position);
    set.add(Word::Fine, places.flatten().any(|x| x.fract() != 0.0));
    Some(set.bits())
}

fn side(table: &Table, h: HalfEdgeId, set: &mut FeatureSet) {
    let outer = edges::outer_half(table, h);
    set.either(Word::Border, Word::Inner, outer.is_some());
    set.add(Word::OuterHalf, outer == Some(h));
    set.add(Word::InnerHalf, outer.is_some() && outer != Some(h));
}

fn legal(table: &Table, h: HalfEdgeId, set: &mut FeatureSet) {
    side(table, h, set);
    let across = edges::across(table, h);
    set.add(Word::Illegal, across.is_some_and(std::cmp::Ordering::is_gt));
    set.add(Word::OnCircle, across.is_some_and(std::cmp::Ordering::is_eq));
    set.add(Word::OffCircle, across.is_some_and(std::cmp::Ordering::is_ne));
    set.add(Word::OutsideCircle, across.is_some_and(std::cmp::Ordering::is_lt));
    set.add(Word::Doubles, mistakes::rounded_goes_wrong(table, h));
    let outer = mistakes::outer_goes_wrong(table, h);
    let outer_half = edges::outer_half(table, h);
    set.add(Word::OuterTriangle, outer);
    set.add(Word::OuterTriangleInner, outer && outer_half != Some(h));
    set.add(Word::ZeroOuter, mistakes::zero_goes_wrong(table, h));
    set.add(Word::Everywhere, mistakes::everywhere_goes_wrong(table, h));
}

fn can_flip(table: &Table, h: HalfEdgeId, set: &mut FeatureSet) {
    side(table, h, set);
    let bends = edges::bends(table, h);
    set.add(Word::Straight, bends.is_some_and(|(_, turn)| turn.is_eq()));
    set.add(Word::Reflex, bends.is_some_and(|(_, turn)| turn.is_lt()));
    set.add(Word::NotConvex, bends.is_some());
    let origin = table.origin(h);
    set.add(Word::BendsAtOrigin, bends.is_some_and(|(v, _)| Some(v) == origin));
    set.add(Word::BendsAtEnd, bends.is_some_and(|(v, _)| Some(v) != origin));
    set.add(Word::Convex, bends.is_none() && flip::corners(table, h).is_some());
    set.add(Word::Illegal, !edges::is_legal(table, h));
}

fn flips(table: &Table, h: HalfEdgeId, set: &mut FeatureSet) {
    let Some(twin) = table.twin(h) else { return };
    let stores = |h: HalfEdgeId| table.origin(h).is_some_and(|v| table.outgoing(v) == Some(h));
    set.add(Word::EndStores, stores(h) || stores(twin));
    let leaves = |h: HalfEdgeId| table.face(h).is_some_and(|f| table.half_edge(f) == table.next(h));
    set.add(Word::FaceStores, leaves(h) || leaves(twin));
    let others = [h, twin].into_iter().flat_map(|h| [table.next(h), table.prev(h)]).flatten();
    let across = |h: HalfEdgeId| table.twin(h).and_then(|twin| table.face(twin));
    set.add(Word::Beside, others.into_iter().any(|h| across(h) == table.outer_face));
    let degree = |v: Option<VertexId>| half_edges(table).filter(|&h| table.origin(h) == v).count();
    set.add(Word::Degree3, degree(table.origin(h)) == 3 || degree(table.origin(twin)) == 3);
    let places = || table.vertices.iter().flatten().filter_map(|row| row.position);
    set.add(Word::Blind, places().zip(places().skip(1)).all(|(p, q)| p.map(f64::to_bits) == q.map(f64::to_bits)));
    let mut seen = BTreeSet::new();
    let ends = |h| [table.origin(h), table.twin(h).and_then(|twin| table.origin(twin))];
    set.add(Word::Odd, !half_edges(table).all(|h| seen.insert(ends(h))));
}

fn delaunify(table: &Table, set: &mut FeatureSet) {
    let due = edges::due(table).is_some();
    set.either(Word::Due, Word::AllLegal, due);
    let mut all = half_edges(table);
    set.add(Word::Cocircular, all.any(|h| edges::across(table, h).is_some_and(std::cmp::Ordering::is_eq)));
    set.add(Word::OnceDown, mistakes::some_stay(table, Again::Nothing, false));
    set.add(Word::OnceUp, mistakes::some_stay(table, Again::Nothing, true));
    set.add(Word::LeftOnly, mistakes::some_stay(table, Again::Left, false));
}
