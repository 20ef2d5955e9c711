//! Rays, and the corners of cells.

use super::centres::is_off;
use super::duals::centre;
use crate::answers::Wrong;
use crate::checks::walks::{place, star};
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Table, View};
use dcel_kit::{HalfEdgeId, VertexId};

/// How far a direction may be turned.
const TURNED: f64 = 1e-9;

/// Where the ray of a half-edge of the outer face begins, the radius there, and its direction; nothing for others.
pub(super) fn ray(table: &Table, h: HalfEdgeId) -> Option<([f64; 2], f64, [f64; 2])> {
    if table.face(h) != table.outer_face {
        return None;
    }
    let twin = table.twin(h)?;
    let (begin, radius) = centre(table, table.face(twin)?)?;
    let (p, q) = (place(table, table.origin(h)?)?, place(table, table.origin(twin)?)?);
    Some((begin, radius, [p[1] - q[1], q[0] - p[0]]))
}

pub(super) fn wrong_ray(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let h = HalfEdgeId::new(*exchange.called?.0.first()?);
    let Some((begin, radius, direction)) = ray(table, h) else {
        let refused = matches!(values, [Value::Refusal(_)]);
        return (!refused).then(|| Wrong::because("accepted", "that half-edge is not on the outer face"));
    };
    if let [Value::Refusal(_)] = values {
        return Some(Wrong::because("refused", "that half-edge is on the outer face"));
    }
    let (Some(from), Some(to)) = (values.first().and_then(Value::point), values.get(1).and_then(Value::point)) else {
        return Some(Wrong::kind("two points"));
    };
    if is_off(from, begin, radius) {
        let ([x, y], [a, b]) = (from, begin);
        return Some(Wrong::because("begin", format!("it begins at ({x}, {y}), expected ({a}, {b})")));
    }
    let cross = direction[0] * to[1] - direction[1] * to[0];
    let dot = direction[0] * to[0] + direction[1] * to[1];
    let size = direction[0].hypot(direction[1]) * to[0].hypot(to[1]);
    let off = size.is_nan() || size <= 0.0 || dot <= 0.0 || cross.abs() > TURNED * size;
    off.then(|| {
        let [a, b] = direction;
        let because = format!("the direction is that of ({a}, {b}) or of any positive multiple");
        Wrong::because("direction", because).is([
            (dot < 0.0 && cross.abs() <= TURNED * size, "the opposite direction, into the triangulation"),
            (dot.abs() <= TURNED * size, "a direction along the edge"),
        ])
    })
}

/// A place, and the radius of the circle round it.
type Corner = ([f64; 2], f64);

/// The centres round a vertex, counter-clockwise, with the radii; whether the outer face lies at it: then the first is
/// that after the outer face.
pub(super) fn cell(table: &Table, v: VertexId) -> Option<(Vec<Corner>, bool)> {
    let mut spokes = star(table, table.outgoing(v)?);
    let gap = spokes.iter().position(|&h| table.face(h) == table.outer_face);
    if let Some(gap) = gap {
        spokes.rotate_left(gap);
        spokes.remove(0);
    }
    let corners: Option<Vec<Corner>> = spokes.into_iter().map(|h| centre(table, table.face(h)?)).collect();
    Some((corners?, gap.is_some()))
}

/// Whether a list is that of a cell.
fn fits(found: &[[f64; 2]], (expected, open): &(Vec<Corner>, bool)) -> bool {
    let n = expected.len();
    let from = |start: usize| {
        (0..n).all(|i| {
            let (place, radius) = expected[(start + i) % n];
            !is_off(found[i], place, radius)
        })
    };
    found.len() == n && (0..if *open { 1 } else { n }).any(from)
}

/// Whether the corners of a cell, read backwards, are others.
pub(super) fn differs_backwards(table: &Table, v: VertexId) -> Option<bool> {
    let cell = cell(table, v)?;
    let back: Vec<[f64; 2]> = cell.0.iter().rev().map(|(place, _)| *place).collect();
    Some(!fits(&back, &cell))
}

/// Whether the corners of a cell are others if they begin at the stored half-edge.
pub(super) fn differs_from_stored(table: &Table, v: VertexId) -> Option<bool> {
    let inside = star(table, table.outgoing(v)?).into_iter().filter(|&h| table.face(h) != table.outer_face);
    let stored: Option<Vec<[f64; 2]>> = inside.map(|h| Some(centre(table, table.face(h)?)?.0)).collect();
    Some(!fits(&stored?, &cell(table, v)?))
}

pub(super) fn wrong_cell(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let cell = cell(exchange.before()?, VertexId::new(*exchange.called?.0.first()?))?;
    let Some(found) = values.iter().map(Value::point).collect::<Option<Vec<[f64; 2]>>>() else {
        return Some(Wrong::kind("a list of points"));
    };
    let n = cell.0.len();
    if found.len() != n {
        let corners = if n == 1 { "corner" } else { "corners" };
        let because = format!("the cell has {n} {corners}, one for each triangle, not {}", found.len());
        return Some(Wrong::because("count", because));
    }
    if fits(&found, &cell) {
        return None;
    }
    let words = Value::List(cell.0.iter().map(|(p, _)| Value::Point(p.to_vec())).collect());
    let round = (cell.0, false);
    let back: Vec<[f64; 2]> = found.iter().rev().copied().collect();
    let (tag, because) = match (fits(&found, &round), fits(&back, &round)) {
        (true, _) => ("rotated", "an unbounded cell begins after the outer face"),
        (_, true) => ("backwards", "the corners run counter-clockwise"),
        _ => ("corners", "the corners are the centres of the triangles at the vertex"),
    };
    Some(Wrong { tag: tag.to_owned(), ..Wrong::value(&words, because) })
}
