//! What the dual of a surface should be.

use super::surface::Surface;
use crate::answers::Wrong;
use crate::checks::duals;
use crate::checks::faults::named;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::FaceId;
use dcel_kit::topology::View;

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
    duals::counts(&surface.table, &dual.table)
        .or_else(|| half_edges(&surface, &dual))
        .or_else(|| duals::representatives("", &dual.table))
        .or_else(|| places(&surface, &dual))
}

/// The dual half-edge h runs from the face on the right of h to the one on its left, with the origin of h on its left; so
/// round each face of the dual run those that start at one vertex.
fn half_edges(surface: &Surface, dual: &Surface) -> Option<Wrong> {
    let (from, to) = (&surface.table, &dual.table);
    for h in surface.half_edges() {
        let crossing = duals::crossing(from, to, h);
        if crossing.is_some() {
            return crossing;
        }
        // The next one starts at the face where this one ends, and crosses what starts at the same vertex.
        let ends = surface.of_face(from.face(h)?).into_iter().find(|&g| surface.end(g) == surface.start(h));
        let (own, next) = (to.next(h), ends.and_then(|g| from.twin(g)));
        if own != next {
            // The half-edge before: it ends where this one starts, and crosses what starts at the same vertex, too.
            let before = from.twin(h).and_then(|twin| from.next(twin));
            let tag = if own == before { "next is prev" } else { "next" };
            return duals::field("next", h, own, next).map(|wrong| Wrong { tag: tag.to_owned(), ..wrong });
        }
        let back = to.next(h).and_then(|next| to.prev(next));
        if back != Some(h) {
            let (next, back) = (named(own), named(back));
            let because = format!("the next of its {h} is {next}, but the prev of its {next} is {back}");
            return Some(Wrong::because("prev", because));
        }
    }
    None
}

/// The corners of a face, and their largest coordinate.
fn corners(surface: &Surface, f: FaceId) -> (Vec<[f64; 3]>, f64) {
    let corners: Vec<[f64; 3]> = surface.of_face(f).into_iter().filter_map(|h| surface.place(h)).collect();
    let size = corners.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    (corners, size)
}

/// Whether the mean of the first three corners of some face, from the stored half-edge on, is not that of all.
pub(super) fn differs_from_first_three(surface: &Surface) -> bool {
    let differs = |f| {
        let (corners, size) = corners(surface, f);
        let first = mean(corners.iter().take(3).copied());
        let all = mean(corners.iter().copied());
        (0..3).any(|i| (first[i] - all[i]).abs() > TOLERANCE * size)
    };
    surface.faces().any(differs)
}

fn places(surface: &Surface, dual: &Surface) -> Option<Wrong> {
    for f in surface.faces() {
        let (corners, size) = corners(surface, f);
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
