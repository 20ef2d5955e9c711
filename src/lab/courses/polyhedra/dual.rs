//! What the dual of a surface should be.

use super::surface::Surface;
use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::View;
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// How far the middle of a face may be from the mean of its corners, for each unit of the largest coordinate.
const TOLERANCE: f64 = 1e-9;

/// The mean of some points.
pub(super) fn mean(points: impl ExactSizeIterator<Item = [f64; 3]>) -> [f64; 3] {
    let share = 1.0 / points.len() as f64;
    points.fold([0.0; 3], |sum, p| [0, 1, 2].map(|i| sum[i] + share * p[i]))
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let [Value::Structure(found)] = values else { return Some(Wrong::kind("a polyhedron")) };
    let dual = Surface::of(found.records()?);
    let counts = [
        ("vertices", dual.points.len(), surface.table.faces.len(), "one for each face"),
        ("half-edges", dual.table.half_edges.len(), surface.table.half_edges.len(), "one for each half-edge"),
        ("faces", dual.table.faces.len(), surface.points.len(), "one for each vertex"),
    ];
    for (name, own, expected, why) in counts {
        if own != expected {
            return Some(Wrong::because(name, format!("it has {own} {name}, expected {expected}: {why}")));
        }
    }
    half_edges(&surface, &dual).or_else(|| representatives(&dual)).or_else(|| places(&surface, &dual))
}

/// A number in a sentence.
fn named(letter: char, number: Option<u32>) -> String {
    number.map_or("not set".to_owned(), |number| format!("{letter}{number}"))
}

/// The dual half-edge h runs from the face on the right of h to the one on its left, with the origin of h on its left; so
/// round each face of the dual run those that start at one vertex.
fn half_edges(surface: &Surface, dual: &Surface) -> Option<Wrong> {
    let (from, to) = (&surface.table, &dual.table);
    let number = HalfEdgeId::number;
    for h in surface.half_edges() {
        let opposite = from.twin(h);
        let start = surface.start(h);
        let checks = [
            (
                "origin",
                'v',
                to.origin(h).map(VertexId::number),
                opposite.and_then(|twin| from.face(twin)).map(FaceId::number),
            ),
            ("twin", 'h', to.twin(h).map(number), opposite.map(number)),
            ("face", 'f', to.face(h).map(FaceId::number), start),
        ];
        for (field, letter, own, expected) in checks {
            if own != expected {
                let (own, expected) = (named(letter, own), named(letter, expected));
                let because = format!("the {field} of its h{} is {own}, expected {expected}", h.number());
                return Some(Wrong::because(field, because));
            }
        }
        // The next one starts at the face where this one ends, and crosses what starts at the same vertex.
        let ends = surface.of_face(from.face(h)?).into_iter().find(|&g| surface.end(g) == start);
        let next = ends.and_then(|g| from.twin(g)).map(number);
        let own = to.next(h).map(number);
        if own != next {
            // The half-edge before: it ends where this one starts, and crosses what starts at the same vertex, too.
            let before = from.twin(h).and_then(|twin| from.next(twin)).map(number);
            let tag = if own == before { "next is prev" } else { "next" };
            let (own, next) = (named('h', own), named('h', next));
            let because = format!("the next of its h{} is {own}, expected {next}", h.number());
            return Some(Wrong::because(tag, because));
        }
        let back = to.next(h).and_then(|next| to.prev(next)).map(number);
        if back != Some(h.number()) {
            let (next, back) = (named('h', own), named('h', back));
            let because = format!("the next of its h{} is {next}, but the prev of its {next} is {back}", h.number());
            return Some(Wrong::because("prev", because));
        }
    }
    None
}

/// Each vertex has a half-edge that starts there, each face one that has it on its left.
pub(super) fn representatives(surface: &Surface) -> Option<Wrong> {
    let rows = &surface.table.half_edges;
    let is_gone = |h: Option<HalfEdgeId>| h.is_some_and(|h| rows.get(h.index()).is_some_and(Option::is_none));
    for (v, row) in (0..).zip(&surface.table.vertices) {
        let own = row.as_ref().and_then(|row| row.outgoing);
        if own.and_then(|h| surface.start(h)) != Some(v) {
            let why = if is_gone(own) { "was removed" } else { "does not start there" };
            let own = named('h', own.map(HalfEdgeId::number));
            let because = format!("the outgoing half-edge of v{v} is {own}, which {why}");
            return Some(Wrong::because("outgoing", because));
        }
    }
    for f in surface.faces() {
        let own = surface.table.faces.get(f.index()).and_then(|row| row.as_ref()?.half_edge);
        if own.and_then(|h| surface.table.face(h)) != Some(f) {
            let why = if is_gone(own) { "was removed" } else { "has another face" };
            let own = named('h', own.map(HalfEdgeId::number));
            let because = format!("the incident half-edge of {f} is {own}, which {why}");
            return Some(Wrong::because("boundary", because));
        }
    }
    None
}

/// Whether the mean of the first three corners of some face, from the stored half-edge on, is not that of all.
pub(super) fn differs_from_first_three(surface: &Surface) -> bool {
    let differs = |f| {
        let corners: Vec<[f64; 3]> = surface.of_face(f).into_iter().filter_map(|h| surface.place(h)).collect();
        let size = corners.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
        let first = mean(corners.iter().take(3).copied());
        let all = mean(corners.iter().copied());
        (0..3).any(|i| (first[i] - all[i]).abs() > TOLERANCE * size)
    };
    surface.faces().any(differs)
}

fn places(surface: &Surface, dual: &Surface) -> Option<Wrong> {
    for f in surface.faces() {
        let corners: Vec<[f64; 3]> = surface.of_face(f).into_iter().filter_map(|h| surface.place(h)).collect();
        let size = corners.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
        let expected = mean(corners.iter().copied());
        let own = dual.points[f.index()];
        if (0..3).any(|i| own[i].is_nan() || (own[i] - expected[i]).abs() > TOLERANCE * size) {
            let [x, y, z] = own;
            let [a, b, c] = expected;
            let because = format!(
                "its v{} is at ({x}, {y}, {z}), expected ({a}, {b}, {c}), the mean of the corners of {f}",
                f.number()
            );
            let close = |p: [f64; 3]| (0..3).all(|i| (own[i] - p[i]).abs() <= TOLERANCE * size);
            let n = corners.len();
            let of_three = (0..n).any(|k| close(mean([0, 1, 2].map(|i| corners[(k + i) % n]).into_iter())));
            let thirds = close(expected.map(|x| x * n as f64 / 3.0));
            let wrong = Wrong::because(if of_three { "place_of_three" } else { "place" }, because);
            return Some(wrong.is([
                (of_three, "the mean of three corners"),
                (thirds, "a third of the sum of the corners"),
                (close([0.0; 3]), "(0, 0, 0)"),
            ]));
        }
    }
    None
}
