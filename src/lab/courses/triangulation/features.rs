//! What can be said of a call of lab 02 before it is made.

use super::geometry::{Diagonal, cross, diagonal, ear, turn};
use super::lists::{cycle, next, place, places};
use crate::fault::Exchange;
use crate::features::FeatureSet;
use crate::protocol::Records;

crate::features! {
    Same "same" "u and v are the same corner",
    Next "next" "v is the next of u",
    Prev "prev" "u is the next of v",
    Neighbours "neighbours" "u and v are neighbours",
    Refused "refused" "the call must be refused",
    Cut "cut" "the call is a cut",
    CutSeen "cut_seen" "the call is a cut, and the two corners have different positions",
    Ear "ear" "one corner lies between u and v, counter-clockwise",
    OtherEar "other_ear" "one corner lies between v and u, counter-clockwise",
    Longer "longer" "more than one corner lies between u and v, counter-clockwise",
    UGreater "u_greater" "u has a greater number than v",
    VGreater "v_greater" "v has a greater number than u",
    Blind "blind" "all corners have the same position",
    Several "several" "there are several polygons",
    Later "later" "another split of the sequence came before it",
    NotZero "not_zero" "the corner is not c0",
    NotRising "not_rising" "the numbers of the corners do not rise by one along the polygon",
    Yes "yes" "the line is a diagonal",
    No "no" "the line is no diagonal",
    Side "side" "the line is a side",
    Outside "outside" "the line begins outside of the polygon",
    Touches "touches" "another corner lies on the line",
    TouchesOnly "touches_only" "another corner lies on the line, and no side crosses it",
    Crosses "crosses" "a side crosses the line",
    CrossesOrTouches "crosses_or_touches" "the line begins inside of the polygon, and meets its boundary on the way",
    AllOutside "all_outside" "the line meets no side, and lies outside of the polygon",
    ReflexU "reflex_u" "u is a reflex corner",
    ConvexU "convex_u" "u is no reflex corner",
    ReflexV "reflex_v" "v is a reflex corner",
    StraightU "straight_u" "u is a straight corner",
    YesReflexU "yes_reflex_u" "the line is a diagonal, and u is a reflex corner",
    YesBehind "yes_behind" "the line is a diagonal, and on the left of only one of the two sides at u",
    OutsideFree "outside_free" "the line is outside, on the left of one of the two sides at u, and nothing is in its way",
    Reflex "reflex" "the corner is reflex",
    Straight "straight" "the corner is straight",
    ReflexOrStraight "reflex_or_straight" "the corner is reflex or straight",
    Convex "convex" "the corner is convex",
    ConvexNoEar "convex_no_ear" "the corner is convex, and no ear",
    IsEar "is_ear" "the corner is an ear",
    NoEar "no_ear" "the corner is no ear",
    NextDiffers "next_differs" "of the corner and its next, one is an ear and the other one is not",
    InTriangle "in_triangle" "another corner lies inside the triangle of the corner and its neighbours",
    OnCut "on_cut" "another corner lies on the line between the neighbours of the corner, and none inside the triangle",
    HasStraight "has_straight" "the polygon has a straight corner",
    HasReflex "has_reflex" "the polygon has a reflex corner",
    FirstNoEar "first_no_ear" "the corner that is given is no ear",
    SecondNoEar "second_no_ear" "the next of the corner that is given is no ear",
    SecondRound "second_round" "who goes round once, cutting off ears, has not cut off all",
    TakesNonEar "takes_non_ear" "a convex corner is no ear",
    Fraction "fraction" "a coordinate is not a whole number",
    _Corners3 "corners_3" "the polygon has more than 3 corners",
    _Corners4 "corners_4" "the polygon has more than 4 corners",
    _Corners5 "corners_5" "the polygon has more than 5 corners",
    _Corners6 "corners_6" "the polygon has more than 6 corners",
    _Corners8 "corners_8" "the polygon has more than 8 corners",
    _Corners12 "corners_12" "the polygon has more than 12 corners",
    _Corners16 "corners_16" "the polygon has more than 16 corners",
    _Corners32 "corners_32" "the polygon has more than 32 corners",
    _Corners64 "corners_64" "the polygon has more than 64 corners",
    Numbers255 "numbers_255" "there are corners with numbers above 255",
}

/// What holds of a call.
pub(super) fn of(earlier: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let records = exchange.records_before()?;
    let arguments = exchange.called?.0;
    let first = *arguments.first()?;
    let corners = cycle(records, first)?;
    let mut set = FeatureSet::default();
    let n = corners.len();
    set.more(VOCABULARY, "corners_N", n);
    set.add(Word::Numbers255, records.len(0) > 256);
    set.add(Word::NotZero, first != 0);
    set.add(Word::Several, records.len(0) > n);
    set.add(Word::NotRising, corners.windows(2).any(|pair| pair[1] != pair[0] + 1));
    set.add(Word::Later, !earlier.is_empty());
    match (exchange.function, arguments) {
        ("split", &[u, v]) => add_split(&mut set, records, u, v),
        ("is_diagonal", &[u, v]) => {
            let place = corners.iter().position(|&corner| corner == v)?;
            let (polygon, from) = (places(records, u)?, 0);
            add_diagonal(&mut set, &polygon, from, place);
        }
        ("is_ear", _) => add_ear(&mut set, &places(records, first)?),
        ("triangulate", _) => add_polygon(&mut set, &places(records, first)?),
        _ => {}
    }
    Some(set.bits())
}

fn add_split(set: &mut FeatureSet, records: &Records, u: u32, v: u32) {
    let to = |corner| next(records, corner);
    let refused = u == v || to(u) == Some(v) || to(v) == Some(u);
    set.add(Word::Same, u == v);
    set.add(Word::Next, to(u) == Some(v));
    set.add(Word::Prev, to(v) == Some(u));
    set.add(Word::Neighbours, u != v && refused);
    set.either(Word::Refused, Word::Cut, refused);
    set.add(Word::CutSeen, !refused && place(records, u) != place(records, v));
    set.add(Word::Ear, !refused && to(u).and_then(to) == Some(v));
    set.add(Word::OtherEar, !refused && to(v).and_then(to) == Some(u));
    set.add(Word::Longer, !refused && to(u).and_then(to) != Some(v));
    set.add(Word::UGreater, u > v);
    set.add(Word::VGreater, v > u);
    let mut all = records.rows(0).map(|row| [row[0].number(), row[1].number()]);
    let place = all.next();
    set.add(Word::Blind, all.all(|other| Some(other) == place));
}

fn at(polygon: &[[f64; 2]], i: usize) -> i32 {
    let n = polygon.len();
    turn(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n])
}

fn add_diagonal(set: &mut FeatureSet, polygon: &[[f64; 2]], u: usize, v: usize) {
    let kind = diagonal(polygon, u, v);
    let back = diagonal(polygon, v, u);
    let either = |one| kind == one || back == one;
    let n = polygon.len();
    let others = (0..n).filter(|k| ![u, v].contains(k));
    let (a, b) = (polygon[u], polygon[v]);
    let apart = |k: &usize| ![u, v].contains(&((k + 1) % n));
    let crossed = others.clone().filter(apart).any(|k| cross([a, b], [polygon[k], polygon[(k + 1) % n]]));
    let touched = others.clone().any(|k| super::geometry::on_segment(polygon[k], a, b));
    set.either(Word::Yes, Word::No, kind == Diagonal::Yes);
    set.add(Word::Same, kind == Diagonal::Same);
    set.add(Word::Side, kind == Diagonal::Side);
    let line = !matches!(kind, Diagonal::Side | Diagonal::Same);
    set.add(Word::Outside, kind == Diagonal::Outside);
    set.add(Word::Touches, line && touched);
    set.add(Word::TouchesOnly, line && either(Diagonal::Touches) && !crossed);
    set.add(Word::Crosses, kind == Diagonal::Crosses);
    set.add(Word::CrossesOrTouches, matches!(kind, Diagonal::Crosses | Diagonal::Touches));
    set.add(Word::AllOutside, line && kind == Diagonal::Outside && !crossed && !touched);
    set.either(Word::ReflexU, Word::ConvexU, at(polygon, u) < 0);
    set.add(Word::ReflexV, at(polygon, v) < 0);
    set.add(Word::StraightU, at(polygon, u) == 0);
    set.add(Word::YesReflexU, kind == Diagonal::Yes && at(polygon, u) < 0);
    let (one, other) = (turn(a, polygon[(u + 1) % n], b), turn(polygon[(u + n - 1) % n], a, b));
    set.add(Word::YesBehind, kind == Diagonal::Yes && !(one > 0 && other > 0));
    let free = line && !crossed && !touched && (one > 0 || other > 0);
    set.add(Word::OutsideFree, kind == Diagonal::Outside && free);
    set.add(Word::Fraction, polygon.iter().flatten().any(|x| x.fract() != 0.0));
}

fn add_ear(set: &mut FeatureSet, polygon: &[[f64; 2]]) {
    let n = polygon.len();
    let (kind, angle) = (ear(polygon, 0), at(polygon, 0));
    let [a, b, c] = [polygon[n - 1], polygon[0], polygon[1]];
    let inside = |p: &[f64; 2]| turn(a, b, *p) > 0 && turn(b, c, *p) > 0 && turn(c, a, *p) > 0;
    let on_cut = |p: &[f64; 2]| super::geometry::on_segment(*p, a, c);
    let others = &polygon[2..n - 1];
    set.add(Word::Reflex, angle < 0);
    set.add(Word::Straight, angle == 0);
    set.either(Word::Convex, Word::ReflexOrStraight, angle > 0);
    set.add(Word::ConvexNoEar, angle > 0 && kind != Diagonal::Yes);
    set.either(Word::IsEar, Word::NoEar, kind == Diagonal::Yes);
    set.add(Word::NextDiffers, (kind == Diagonal::Yes) != (ear(polygon, 1) == Diagonal::Yes));
    set.add(Word::InTriangle, angle > 0 && others.iter().any(inside));
    set.add(Word::OnCut, angle > 0 && others.iter().any(on_cut) && !others.iter().any(inside));
    set.add(Word::Fraction, polygon.iter().flatten().any(|x| x.fract() != 0.0));
}

fn add_polygon(set: &mut FeatureSet, polygon: &[[f64; 2]]) {
    let n = polygon.len();
    set.add(Word::HasStraight, (0..n).any(|i| at(polygon, i) == 0));
    set.add(Word::HasReflex, (0..n).any(|i| at(polygon, i) < 0));
    set.add(Word::FirstNoEar, n > 3 && ear(polygon, 0) != Diagonal::Yes);
    set.add(Word::SecondNoEar, n > 3 && ear(polygon, 1) != Diagonal::Yes);
    set.add(Word::SecondRound, !one_round(polygon));
    set.add(Word::TakesNonEar, n > 3 && (0..n).any(|i| at(polygon, i) > 0 && ear(polygon, i) != Diagonal::Yes));
    set.add(Word::Fraction, polygon.iter().flatten().any(|x| x.fract() != 0.0));
}

/// Whether going round a polygon once, and cutting off each corner that is an ear, leaves one triangle.
fn one_round(polygon: &[[f64; 2]]) -> bool {
    let mut left = polygon.to_vec();
    for _ in polygon {
        if left.len() == 3 {
            return true;
        }
        // The corner that is looked at stands first.
        if ear(&left, 0) == Diagonal::Yes {
            left.remove(0);
        } else {
            left.rotate_left(1);
        }
    }
    left.len() == 3
}
