//! What can be said of a call of lab 11 before it is made, so that failing calls can be told from passing ones.
//!
//! ```text
//!   the records before the call ──▶ a model of them ──▶ edits: what is in the way, what is there, what is free
//!                                                   └─▶ heights: would a usual mistake show here? (mistakes.rs)
//! ```

use super::answers::{is_edit, numbers};
use super::laws::is_live;
use super::mistakes::{self, Plateau};
use super::model::{Model, Place};
use crate::fault::Exchange;
use crate::features::FeatureSet;
use crate::protocol::{Cell, Records};
use std::collections::{BTreeMap, BTreeSet};

crate::features! {
    FreeVertex "free_vertex" "a vertex record is free",
    TwoFree "two_free" "two vertex records or more are free",
    Legal "legal" "the triangle is legal",
    Refused "refused" "the triangle has to be refused",
    SameCorner "same_corner" "two of the corners are the same, and nothing else is in the way",
    FreeCorner "free_corner" "one of the corners is a vertex that was removed, and nothing else is in the way",
    NoVertex "no_vertex" "one of the corners is no vertex, and nothing else is in the way",
    Taken "taken" "a half-edge of the triangle has a face already, and nothing else is in the way",
    EdgeThere "edge_there" "the triangle is legal, and one of its edges is there already",
    EdgeMade "edge_made" "the triangle is legal, and one of its edges was made by an earlier call",
    EdgeGone "edge_gone" "the triangle is legal, and one of its edges was there once and was removed",
    NewEdge "new_edge" "the triangle is legal, and one of its edges is new",
    FreeFace "free_face" "a face record is free",
    FreeHalfEdge "free_half_edge" "half-edge records are free",
    AtBorder "at_border" "no triangle lies on the other side of one of the edges",
    Beside "beside" "a triangle lies on the other side of an edge",
    Inside "inside" "triangles lie on the other sides of all three edges",
    Stored "stored" "a corner stores a half-edge of the triangle",
    FirstBorder "first_border" "after it, the first half-edge that starts at a corner, by the other end, has no face",
    HasFace "has_face" "the vertex has triangles",
    NoFace "no_face" "the vertex has no triangle",
    SecondFan "second_fan" "a turn from the stored half-edge comes to a border before it has met all triangles",
    Open "open" "the triangles of the vertex do not close round it",
    Closed "closed" "the triangles of the vertex close round it",
    Empty "empty" "there is no vertex",
    NotPositive "not_positive" "no height is above 0",
    FreeHigher "free_higher" "a vertex that was removed would be the highest",
    Rounded "rounded" "rounded dot products lead to a lower vertex",
    Up "up" "a neighbour of the first vertex is higher",
    Longer "longer" "the climb has more than one step",
    FirstHigher "first_higher" "in one of the steps, the first neighbour that is higher is not the highest",
    EndLevel "end_level" "a neighbour of the vertex where the climb ends is as high as that",
    Stuck "stuck" "the climb ends on a plateau below the top",
    Deep "deep" "the step up is not beside a neighbour of the vertex where the climb ends",
    Level "level" "a neighbour of the first vertex is as high as that",
    Alone "alone" "the vertex has no neighbour",
    Axis "axis" "the direction is parallel to an axis",
    BigNumbers "big_numbers" "a coordinate has more than 50 bits",
}

/// Of a structure with more half-edges nothing is said: it would take too long.
const LARGE: usize = 10_000;

fn place(row: &[Cell]) -> Option<Place> {
    Some([row[0].number()?, row[1].number()?, row[2].number()?])
}

/// The two ends of a half-edge.
fn ends(records: &Records, row: &[Cell]) -> Option<(usize, usize)> {
    let to = records.row(1, row[1].to()? as usize)?[0].to()?;
    Some((row[0].to()? as usize, to as usize))
}

/// The mesh that the records stand for.
fn model_of(records: &Records) -> Model {
    let vertices = records.rows(0).map(|row| place(row).filter(|_| is_live(row))).collect();
    let mut across = BTreeMap::new();
    for row in records.rows(1).filter(|row| is_live(row) && row[4].to().is_some()) {
        let corner = row[3].to().and_then(|prev| records.row(1, prev as usize)?[0].to());
        if let (Some(side), Some(corner)) = (ends(records, row), corner) {
            across.insert(side, corner as usize);
        }
    }
    Model::of_sides(vertices, across)
}

/// Whether the records before a call are those that it finds. In a long row of edits only some are shown: each call that
/// is known to stand in a row of shown ones has at most two steps between itself and the one before.
fn is_seen(earlier: &[&Exchange], exchange: &Exchange) -> bool {
    exchange.structure_after.is_some() && exchange.step <= 3 * earlier.len() + 1
}

/// What holds of a call.
pub(super) fn of(earlier: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let records = exchange.records_before()?;
    let numbers = numbers(exchange.words);
    let ids: Vec<usize> = numbers.iter().map(|&x| x as usize).collect();
    let is_edit = is_edit(exchange.function);
    if is_edit && !is_seen(earlier, exchange) {
        return None;
    }
    if records.len(1) > LARGE {
        return None;
    }
    let model = model_of(records);
    let mut set = FeatureSet::default();
    if is_edit {
        let free = |table: usize| records.rows(table).filter(|row| !is_live(row)).count();
        set.add(Word::FreeVertex, free(0) > 0);
        set.add(Word::TwoFree, free(0) > 1);
        set.add(Word::FreeHalfEdge, free(1) > 0);
        set.add(Word::FreeFace, free(2) > 0);
    }
    match (exchange.function, &ids[..]) {
        ("add_face", &[a, b, c]) => add_face(&mut set, &model, earlier, [a, b, c]),
        ("remove_face", &[a, b]) => remove_face(&mut set, &model, records, (a, b))?,
        ("remove_vertex", &[v]) => remove_vertex(&mut set, &model, records, v),
        ("climb" | "support", &[from, ..]) => {
            heights(&mut set, &model, records, numbers.get(1..)?)?;
            climbs(&mut set, &model, from, numbers.get(1..)?.try_into().ok()?);
        }
        ("support_by_scan", _) => heights(&mut set, &model, records, &numbers)?,
        _ => {}
    }
    Some(set.bits())
}

fn both(side: (usize, usize), model: &Model) -> bool {
    model.across.contains_key(&side) || model.across.contains_key(&(side.1, side.0))
}

fn add_face(set: &mut FeatureSet, model: &Model, earlier: &[&Exchange], corners: [usize; 3]) {
    let [a, b, c] = corners;
    let sides = [(a, b), (b, c), (c, a)];
    let is_legal = model.refusal(corners).is_none();
    let there = |side: &(usize, usize)| both(*side, model);
    set.either(Word::Legal, Word::Refused, is_legal);
    let same = a == b || b == c || c == a;
    let missing = corners.iter().any(|&v| model.place(v).is_none());
    let taken = sides.iter().any(|side| model.across.contains_key(side));
    set.add(Word::SameCorner, same && !missing && !taken);
    set.add(Word::NoVertex, missing && !same && !taken);
    set.add(Word::FreeCorner, missing && !same && !taken && corners.iter().all(|&v| v < model.vertices.len()));
    set.add(Word::Taken, taken && !same && !missing);
    set.add(Word::EdgeThere, is_legal && sides.iter().any(there));
    set.add(Word::NewEdge, is_legal && !sides.iter().all(there));
    // What the calls before it have made and removed.
    let (mut made, mut gone) = (BTreeSet::new(), BTreeSet::new());
    let states: Vec<Model> = earlier.iter().filter_map(|call| call.records_before()).map(|r| model_of(r)).collect();
    for (before, after) in states.iter().zip(states.iter().skip(1).chain([model])) {
        let edges = |model: &Model| -> BTreeSet<(usize, usize)> {
            model.across.keys().map(|&(a, b)| (a.min(b), a.max(b))).collect()
        };
        let [before, after] = [edges(before), edges(after)];
        made.extend(after.difference(&before).copied());
        gone.extend(before.difference(&after).copied());
    }
    let known = |all: &BTreeSet<(usize, usize)>, (a, b): (usize, usize)| all.contains(&(a.min(b), a.max(b)));
    set.add(Word::EdgeMade, is_legal && sides.iter().any(|&side| there(&side) && known(&made, side)));
    set.add(Word::EdgeGone, is_legal && sides.iter().any(|&side| !there(&side) && known(&gone, side)));
}

fn remove_face(set: &mut FeatureSet, model: &Model, records: &Records, (a, b): (usize, usize)) -> Option<()> {
    let c = *model.across.get(&(a, b))?;
    let sides = [(a, b), (b, c), (c, a)];
    let count = sides.iter().filter(|&&(a, b)| model.across.contains_key(&(b, a))).count();
    set.add(Word::AtBorder, count < 3);
    set.add(Word::Beside, count > 0);
    set.add(Word::Inside, count == 3);
    let stored = |&(from, to): &(usize, usize)| {
        let outgoing = records.row(0, from)?[3].to()?;
        Some(ends(records, records.row(1, outgoing as usize)?)? == (from, to))
    };
    set.add(Word::Stored, sides.iter().any(|side| stored(side) == Some(true)));
    let mut after = model.clone();
    after.remove_face(a, b);
    let first = |v: usize| after.neighbours(v).into_iter().next().is_some_and(|u| !after.across.contains_key(&(v, u)));
    set.add(Word::FirstBorder, [a, b, c].into_iter().any(first));
    Some(())
}

fn remove_vertex(set: &mut FeatureSet, model: &Model, records: &Records, v: usize) {
    let with = model.sides_from(v).len();
    let all = model.neighbours(v).len();
    set.either(Word::NoFace, Word::HasFace, with == 0);
    set.add(Word::Open, with > 0 && with < all);
    set.add(Word::Closed, with > 0 && with == all);
    // A turn by the twin of the previous one, from the half-edge that is stored.
    let outgoing = records.row(0, v).and_then(|row| row[3].to());
    let first = outgoing.and_then(|h| ends(records, records.row(1, h as usize)?));
    let (mut met, mut at) = (BTreeSet::new(), first.map(|(_, to)| to));
    while let Some(to) = at.filter(|to| met.insert(*to)) {
        at = model.across.get(&(v, to)).copied();
    }
    let turned = met.iter().filter(|&&to| model.across.contains_key(&(v, to))).count();
    set.add(Word::SecondFan, turned < with);
}

fn heights(set: &mut FeatureSet, model: &Model, records: &Records, d: &[f64]) -> Option<()> {
    let d: Place = d.try_into().ok()?;
    set.add(Word::Axis, d.iter().filter(|x| **x != 0.0).count() == 1);
    let is_big = |x: &f64| x.abs() > 2.0_f64.powi(50);
    set.add(Word::BigNumbers, records.rows(0).filter_map(place).flatten().any(|x| is_big(&x)));
    let Some(best) = model.highest(d) else {
        set.add(Word::Empty, true);
        return Some(());
    };
    set.add(Word::NotPositive, model.height(d, best) <= 0);
    let mut with_free = model.clone();
    with_free.vertices = records.rows(0).map(place).collect();
    let highest = with_free.highest(d);
    set.add(Word::FreeHigher, highest.is_some_and(|v| with_free.higher(d, v, best).is_gt()));
    let rounded = mistakes::rounded_scan(model, d);
    set.add(Word::Rounded, rounded.is_some_and(|v| model.higher(d, best, v).is_gt()));
    Some(())
}

fn climbs(set: &mut FeatureSet, model: &Model, from: usize, d: Place) {
    let neighbours = model.neighbours(from);
    let is_beside =
        |v: usize, order: std::cmp::Ordering| model.neighbours(v).into_iter().any(|u| model.higher(d, u, v) == order);
    set.add(Word::Alone, neighbours.is_empty());
    set.add(Word::Up, is_beside(from, std::cmp::Ordering::Greater));
    set.add(Word::Level, is_beside(from, std::cmp::Ordering::Equal));
    let climb = mistakes::climb(model, from, d);
    let end = climb.last().copied().unwrap_or(from);
    set.add(Word::Longer, climb.len() > 2);
    set.add(Word::EndLevel, is_beside(end, std::cmp::Ordering::Equal));
    set.add(Word::FirstHigher, mistakes::goes_to_first_higher(model, from, d));
    let Some(best) = model.highest(d) else { return };
    let below = |v: usize| model.higher(d, best, v).is_gt();
    set.add(Word::Stuck, below(end));
    set.add(Word::Deep, below(mistakes::support(model, from, d, Plateau::Neighbours)));
}
