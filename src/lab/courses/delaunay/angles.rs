//! The smallest angle of a triangulation.

use super::edges::place;
use crate::answers::Wrong;
use crate::checks::walks::half_edges;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId};

/// How far an answer may be off, as a part of the angle.
const OFF: f64 = 1e-9;

/// The angle of the triangle of a half-edge at its origin.
///
/// Source: W. Kahan, *How futile are mindless assessments of roundoff in floating-point computation?*, 2006, section 12:
/// right for small angles, too.
pub(super) fn angle(table: &Table, h: HalfEdgeId) -> Option<f64> {
    let at = |h| place(table, table.origin(h)?);
    let (p, q, r) = (at(h)?, at(table.next(h)?)?, at(table.prev(h)?)?);
    let (u, v) = ([q.x - p.x, q.y - p.y], [r.x - p.x, r.y - p.y]);
    let (long, other) = (u[0].hypot(u[1]), v[0].hypot(v[1]));
    let [difference, sum] = [-1.0, 1.0].map(|sign| [0, 1].map(|i| other * u[i] + sign * long * v[i]));
    Some(2.0 * difference[0].hypot(difference[1]).atan2(sum[0].hypot(sum[1])))
}

/// The half-edges at whose origins a triangle has an angle.
pub(super) fn sides(table: &Table) -> impl Iterator<Item = HalfEdgeId> {
    half_edges(table).filter(|&h| table.face(h) != table.outer_face)
}

/// The smallest angle.
pub(super) fn smallest(table: &Table) -> Option<f64> {
    sides(table).filter_map(|h| angle(table, h)).reduce(f64::min)
}

/// Whether the smallest of the angles where stored half-edges begin is another one.
pub(super) fn differs_at_stored(table: &Table) -> bool {
    let stored = (0..table.faces.len() as u32).map(FaceId::new).filter(|&f| Some(f) != table.outer_face);
    let least = stored.filter_map(|f| angle(table, table.half_edge(f)?)).reduce(f64::min);
    least.zip(smallest(table)).is_some_and(|(found, expected)| is_off(found, expected))
}

/// Whether the smallest angle by the arc cosine is off.
pub(super) fn differs_by_cosine(table: &Table) -> bool {
    let by_cosine = |h: HalfEdgeId| {
        let at = |h| place(table, table.origin(h)?);
        let (p, q, r) = (at(h)?, at(table.next(h)?)?, at(table.prev(h)?)?);
        let [(dx, dy), (ex, ey)] = [q, r].map(|to| (to.x - p.x, to.y - p.y));
        Some(((dx * ex + dy * ey) / (dx.hypot(dy) * ex.hypot(ey))).acos())
    };
    let least = sides(table).filter_map(by_cosine).reduce(f64::min);
    least.zip(smallest(table)).is_some_and(|(found, expected)| is_off(found, expected))
}

fn is_off(found: f64, expected: f64) -> bool {
    found.is_nan() || (found - expected).abs() > OFF * expected
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let expected = smallest(exchange.before()?)?;
    let [Value::Number(found)] = values else { return Some(Wrong::kind("a number")) };
    let off = |other: f64| !is_off(*found, other);
    let wrong = Wrong::value(&Value::Number(expected), "the smallest angle of all triangles, in radians");
    let is = [(off(expected.to_degrees()), "the angle in degrees"), (*found <= 0.0, "not above 0")];
    let tag = is.iter().find(|(holds, _)| *holds).map_or("value", |(_, words)| words).to_owned();
    is_off(*found, expected).then(|| Wrong { tag, ..wrong.is(is) })
}

#[cfg(test)]
mod tests {
    use super::super::meshes::{slanted_mesh, swept};
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    #[test]
    fn angles_are_known_and_sum_up() {
        let of = |points: &[[f64; 2]]| smallest(&swept("", points).unwrap().table()).unwrap();
        assert!((of(&[[0., 0.], [1., 0.], [0., 1.]]) - FRAC_PI_4).abs() < 1e-15);
        assert!((of(&[[0., 0.], [1e8, 0.], [0., 1.]]) - 1e-8).abs() < 1e-22);
        let table = slanted_mesh(3, 2).table();
        let sum: f64 = sides(&table).filter_map(|h| angle(&table, h)).sum();
        assert!((sum - 12.0 * std::f64::consts::PI).abs() < 1e-12);
    }
}
