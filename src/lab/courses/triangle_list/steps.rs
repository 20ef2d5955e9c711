//! Judging `add_face`, `match_twins` and `close_border`, each on what the steps before it should have made.

use super::refused::built;
use super::soup::{Ends, Soup};
use crate::checks::align::half_edge_row;
use crate::checks::faults::{Faults, named};
use crate::checks::walks::half_edges;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{HalfEdgeRow, Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// The tests of `add_face`.
pub(super) const ADD_FACE: [&str; 2] = ["add_face_records", "add_face_links"];
/// The tests of `close_border`, where it builds.
pub(super) const BORDER: [&str; 2] = ["close_border_half_edges", "close_border_links"];

/// What stands in a link of `h` that is wrong, as the end of a rule: it tells mistakes of linking from each other.
fn instead(found: Option<HalfEdgeId>, h: HalfEdgeId, back: Option<HalfEdgeId>) -> &'static str {
    match found {
        None => ".unset",
        Some(to) if to == h => ".itself",
        Some(to) if Some(to) == back => ".back",
        Some(_) => "",
    }
}

/// What is wrong with a call of `add_face`.
pub(super) fn add_face(exchange: &Exchange, faults: &mut Faults) -> Option<()> {
    let values = faults.returned(exchange.called?.1, &ADD_FACE)?;
    let (before, after) = (exchange.before()?, exchange.after()?);
    let corners: Vec<u32> = exchange.words.iter().filter_map(|word| word.parse().ok()).collect();
    let (first, face) = (before.half_edges.len(), FaceId::new(before.faces.len() as u32));
    let [records, links] = ADD_FACE;
    let counts =
        [after.faces.len() - before.faces.len().min(after.faces.len()), after.half_edges.len().saturating_sub(first)];
    if counts != [1, corners.len()] {
        let words = format!("made {} faces and {} half-edges, expected 1 and {}", counts[0], counts[1], corners.len());
        ADD_FACE.iter().for_each(|test| faults.wrong(test, "add_face.count", &words, &[]));
        return None;
    }
    if values != [Value::Id(face.number())] {
        faults.wrong(records, "add_face.returned", &format!("the number of the new face is {}", face.number()), &[]);
    }
    let new: Vec<HalfEdgeId> = half_edges(after).skip(first).collect();
    let mut at: BTreeMap<u32, HalfEdgeId> = BTreeMap::new();
    for &h in &new {
        let origin = after.origin(h).map(VertexId::number);
        if !origin.is_some_and(|v| corners.contains(&v) && at.insert(v, h).is_none()) {
            let words =
                format!("{h}.origin is {}: each corner is the origin of one new half-edge", named(after.origin(h)));
            ADD_FACE.iter().for_each(|test| faults.wrong(test, "add_face.origin", &words, &[h.into()]));
        }
        faults.field(records, "add_face.face", (h, "face"), [after.face(h), Some(face)]);
        if let Some(twin) = after.twin(h) {
            faults.wrong(records, "add_face.twin", &format!("{h}.twin is {twin}, but twins come later"), &[h.into()]);
        }
    }
    if at.len() != corners.len() {
        return None;
    }
    for ends in Soup::sides(&corners) {
        let [h, next] = ends.map(|v| at[&v]);
        let (forth, back) = ([after.next(h), Some(next)], [after.prev(next), Some(h)]);
        let rule = format!("add_face.next{}", instead(forth[0], h, after.prev(h)));
        faults.field(links, &rule, (h, "next"), forth);
        let rule = format!("add_face.prev{}", instead(back[0], next, after.next(next)));
        faults.field(links, &rule, (next, "prev"), back);
    }
    if !after.half_edge(face).is_some_and(|h| new.contains(&h)) {
        let words = format!("{face} knows no half-edge of its own: it is {}", named(after.half_edge(face)));
        faults.wrong(records, "add_face.boundary", &words, &[face.into()]);
    }
    outgoing(records, after, &corners, faults);
    if let Some(h) = half_edges(before).find(|&h| half_edge_row(before, h) != half_edge_row(after, h)) {
        faults.wrong(records, "add_face.others", &format!("{h} of another face has changed"), &[h.into()]);
    }
    Some(())
}

/// Each of these vertices knows a half-edge that starts there.
fn outgoing(test: &'static str, table: &Table, vertices: &[u32], faults: &mut Faults) {
    for v in vertices.iter().map(|&v| VertexId::new(v)) {
        if table.outgoing(v).and_then(|h| table.origin(h)) != Some(v) {
            let words = format!("the outgoing half-edge of {v} is {}: it starts elsewhere", named(table.outgoing(v)));
            let unset = format!("{v} knows no outgoing half-edge, but is a corner of a face");
            let words = if table.outgoing(v).is_none() { unset } else { words };
            let rule = if table.outgoing(v).is_none() { "outgoing.unset" } else { "outgoing" };
            faults.wrong(test, rule, &words, &[v.into()]);
        }
    }
}

/// The half-edges of cycles by their ends.
fn by_ends(table: &Table) -> BTreeMap<Ends, HalfEdgeId> {
    let ends = |h| Some([table.origin(h)?.number(), table.origin(table.next(h)?)?.number()]);
    half_edges(table).filter_map(|h| Some((ends(h)?, h))).collect()
}

/// What is wrong with a call of `match_twins`.
pub(super) fn match_twins(exchange: &Exchange, test: &'static str, faults: &mut Faults) -> Option<()> {
    let before = exchange.before()?;
    let soup = Soup::of_table(before)?;
    built(exchange, &[test], &soup.edges_twice(), faults)?;
    let after = exchange.after()?;
    let ends = by_ends(before);
    if after.half_edges.len() != before.half_edges.len() {
        faults.wrong(test, "match_twins.count", "the number of half-edges has changed", &[]);
        return None;
    }
    for (&[a, b], &h) in &ends {
        let twin = ends.get(&[b, a]).copied();
        if after.twin(h) != twin {
            let words =
                format!("{h} runs from v{a} to v{b}; its twin is {}, expected {}", named(after.twin(h)), named(twin));
            faults.wrong(test, "match_twins.twin", &words, &[h.into()]);
        }
        if (HalfEdgeRow { twin: None, ..half_edge_row(after, h) }) != half_edge_row(before, h) {
            faults.wrong(test, "match_twins.others", &format!("{h} has changed not only its twin"), &[h.into()]);
        }
    }
    Some(())
}

/// What is wrong with a call of `close_border`; `tests` are those that a wrong return is charged to.
pub(super) fn close_border(exchange: &Exchange, tests: &[&'static str], faults: &mut Faults) -> Option<()> {
    let before = exchange.before()?;
    let soup = Soup::of_table(before)?;
    built(exchange, tests, &soup.pinched(), faults)?;
    let (after, test) = (exchange.after()?, *tests.first()?);
    let both = |rule: &str, words: &str, faults: &mut Faults| {
        tests.iter().for_each(|test| faults.wrong(test, rule, words, &[]));
    };
    let first = before.half_edges.len();
    let border = soup.border();
    let made = after.half_edges.len().saturating_sub(first);
    if made != border.len() {
        let words = format!("made {made} half-edges, expected {}: one for each that has no twin", border.len());
        both("close_border.count", &words, faults);
        return None;
    }
    let outer = after.outer_face;
    if outer != before.outer_face {
        both("close_border.outer", "another face has become the outer one", faults);
    }
    let ends = by_ends(before);
    let mut of: BTreeMap<Ends, HalfEdgeId> = BTreeMap::new();
    for &[a, b] in &border {
        let inner = ends[&[b, a]];
        let Some(h) = after.twin(inner).filter(|h| h.index() >= first) else {
            let words = format!("{inner}.twin is {}, expected a new half-edge", named(after.twin(inner)));
            both("close_border.twin", &words, faults);
            continue;
        };
        of.insert([a, b], h);
        faults.field(test, "close_border.back", (h, "twin"), [after.twin(h), Some(inner)]);
        if after.origin(h).map(VertexId::number) != Some(a) {
            let words = format!("{h}.origin is {}, expected v{a}, where its twin ends", named(after.origin(h)));
            faults.wrong(test, "close_border.origin", &words, &[h.into()]);
        }
        if after.face(h) != outer || outer.is_none() {
            let words = format!("{h}.face is {}, expected {}", named(after.face(h)), named(outer));
            faults.wrong(test, "close_border.face", &words, &[h.into()]);
        }
    }
    let corners: BTreeSet<u32> = soup.faces.iter().flatten().copied().collect();
    outgoing(test, after, &corners.into_iter().collect::<Vec<_>>(), faults);
    for h in half_edges(before).filter(|&h| before.twin(h).is_some()) {
        if half_edge_row(after, h) != half_edge_row(before, h) {
            let links = |table: &Table| [("next", table.next(h)), ("prev", table.prev(h)), ("twin", table.twin(h))];
            let changed = links(before).into_iter().zip(links(after)).find(|(was, is)| was != is);
            let how = changed.map_or_else(String::new, |((name, was), (_, is))| {
                format!(": its {name} was {}, and is {}", named(was), named(is))
            });
            let words = format!("{h} has a twin already, and has changed{how}");
            faults.wrong(test, "close_border.others", &words, &[h.into()]);
        }
    }
    if let Some(&links) = tests.get(1) {
        cycles(links, after, &soup, &of, faults);
    }
    Some(())
}

/// The links along the border, and the half-edge of the outer face.
fn cycles(test: &'static str, after: &Table, soup: &Soup, of: &BTreeMap<Ends, HalfEdgeId>, faults: &mut Faults) {
    let right = soup.half_edges();
    for (ends, &h) in of {
        let right = right[ends];
        faults.field(test, "close_border.next", (h, "next"), [after.next(h), of.get(&right.next).copied()]);
        faults.field(test, "close_border.prev", (h, "prev"), [after.prev(h), of.get(&right.prev).copied()]);
    }
    let known = after.outer_face.and_then(|f| after.half_edge(f));
    let right = if of.is_empty() { known.is_none() } else { known.is_some_and(|h| of.values().any(|&b| b == h)) };
    if !right {
        let words = format!("the half-edge of the outer face is {}, which is none of the border", named(known));
        let empty = format!("there is no border, but the outer face knows {}", named(known));
        faults.wrong(test, "close_border.boundary", if of.is_empty() { &empty } else { &words }, &[]);
    }
}

/// What is wrong with a call of `check_faces`.
pub(super) fn check_faces(exchange: &Exchange, test: &'static str, faults: &mut Faults) -> Option<()> {
    let soup = Soup::of_words(exchange.before()?.vertices.len(), exchange.words)?;
    built(exchange, &[test], &soup.bad_faces(), faults)
}
