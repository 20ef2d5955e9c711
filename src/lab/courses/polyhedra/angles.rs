//! Deficit and dihedral angles, and what usual ways to compute them lose.

use super::surface::Surface;
use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::View;
use std::f64::consts::{PI, TAU};

/// How far an angle may be from the right one.
pub(super) const TOLERANCE: f64 = 1e-9;

pub(super) type Vector = [f64; 3];

pub(super) fn minus(p: Vector, q: Vector) -> Vector {
    [0, 1, 2].map(|i| p[i] - q[i])
}

fn plus(p: Vector, q: Vector) -> Vector {
    [0, 1, 2].map(|i| p[i] + q[i])
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    let size = length(a);
    a.map(|x| x / size)
}

/// The angle between two vectors, from 0 to pi, good to the last digits everywhere.
///
/// Source: W. Kahan, *How futile are mindless assessments of roundoff in floating-point computation?*, 2006, section 12.
fn between(a: Vector, b: Vector) -> f64 {
    let (a, b) = (unit(a), unit(b));
    2.0 * length(minus(a, b)).atan2(length(plus(a, b)))
}

/// 2 pi minus the angles of the faces at a vertex.
pub(super) fn deficit(surface: &Surface, v: u32) -> Option<f64> {
    Some(TAU - wedges(surface, v)?.into_iter().map(|[a, b]| between(a, b)).sum::<f64>())
}

/// At right angles to a face, outwards; its length is twice the area.
fn outwards(surface: &Surface, h: HalfEdgeId) -> Option<Vector> {
    let corners = surface.of_face(surface.table.face(h)?).into_iter().map(|h| surface.place(h));
    let corners: Vec<Vector> = corners.collect::<Option<_>>()?;
    let triangles = corners.windows(2).map(|side| cross(minus(side[0], corners[0]), minus(side[1], corners[0])));
    Some(triangles.fold([0.0; 3], plus))
}

/// The angle inside the solid between the two faces of an edge: between the directions that lead from the edge into the
/// faces. It is the one beyond pi if the right face rises above the plane of the left one.
pub(super) fn dihedral(surface: &Surface, h: HalfEdgeId) -> Option<f64> {
    let twin = surface.table.twin(h)?;
    let (from, to) = (surface.place(h)?, surface.place(twin)?);
    let (left, right) = (unit(outwards(surface, h)?), unit(outwards(surface, twin)?));
    let (into_left, into_right) = (cross(left, minus(to, from)), cross(right, minus(from, to)));
    let angle = between(into_left, into_right);
    Some(if dot(into_right, left) > 0.0 { TAU - angle } else { angle })
}

/// Whether a computed angle is too far from the right one; NaN is.
fn is_off(found: f64, expected: f64) -> bool {
    found.is_nan() || (found - expected).abs() > TOLERANCE
}

pub(super) fn wrong_deficit(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (surface, v) = (Surface::of(exchange.records_before()?), *exchange.called?.0.first()?);
    let expected = deficit(&surface, v)?;
    let outer = PI * surface.spokes(v).len() as f64 - (TAU - expected);
    let [Value::Number(found)] = values else { return Some(Wrong::kind("one number")) };
    let is = |other: f64| !is_off(*found, other);
    is_off(*found, expected).then(|| {
        Wrong::value(&Value::Number(expected), "2 pi minus the angles of the faces at the vertex").is([
            (is(TAU - expected), "the sum of the angles, not subtracted from 2 pi"),
            (is(expected.to_degrees()), "the angle in degrees"),
            (is(PI - (TAU - expected)), "pi minus the angles"),
            (is(TAU - outer), "2 pi minus the outer angles, those by which one turns at the corners"),
            (is(-expected), "the opposite sign"),
            (found.is_nan(), "NaN, not a number"),
        ])
    })
}

pub(super) fn wrong_dihedral(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let expected = dihedral(&Surface::of(exchange.records_before()?), HalfEdgeId::new(*exchange.called?.0.first()?))?;
    let [Value::Number(found)] = values else { return Some(Wrong::kind("one number")) };
    let is = |other: f64| !is_off(*found, other);
    is_off(*found, expected).then(|| {
        Wrong::value(&Value::Number(expected), "the angle inside the solid between the two faces").is([
            (is((PI - expected).abs()), "the angle between the normals of the faces"),
            (is(TAU - expected), "the angle outside of the solid"),
            (is(expected.to_degrees()), "the angle in degrees"),
            (found.is_nan(), "NaN, not a number"),
        ])
    })
}

/// The angle between two vectors by the arc cosine of a quotient.
fn by_arc_cosine(a: Vector, b: Vector) -> f64 {
    (dot(a, b) / (length(a) * length(b))).acos()
}

/// The two edges of each face at a vertex, as vectors.
fn wedges(surface: &Surface, v: u32) -> Option<Vec<[Vector; 2]>> {
    let here = *surface.points.get(v as usize)?;
    let ends = surface.spokes(v).into_iter().map(|h| surface.points.get(surface.end(h)? as usize).copied());
    let arms: Vec<Vector> = ends.map(|end| Some(minus(end?, here))).collect::<Option<_>>()?;
    Some((0..arms.len()).map(|i| [arms[i], arms[(i + 1) % arms.len()]]).collect())
}

/// Whether the deficit is lost if the angles come from the arc cosine: near 1 it has half of the digits only.
pub(super) fn arc_cosine_loses_deficit(surface: &Surface, v: u32) -> Option<bool> {
    let sum: f64 = wedges(surface, v)?.into_iter().map(|[a, b]| by_arc_cosine(a, b)).sum();
    Some(is_off(TAU - sum, deficit(surface, v)?))
}

/// Whether a face has an angle of more than a right one at a vertex.
pub(super) fn has_obtuse_corner(surface: &Surface, v: u32) -> Option<bool> {
    Some(wedges(surface, v)?.into_iter().any(|[a, b]| between(a, b) > PI / 2.0 + TOLERANCE))
}

/// Whether all faces at a vertex are regular polygons: then the angle of one with p corners is pi (1 - 2 / p).
pub(super) fn has_regular_corners(surface: &Surface, v: u32) -> Option<bool> {
    let spokes = surface.spokes(v);
    let corner = |(h, [a, b]): (&HalfEdgeId, [Vector; 2])| {
        let corners = surface.of_face(surface.table.face(*h)?).len() as f64;
        let angle = between(a, b);
        Some(!is_off(angle, PI * (1.0 - 2.0 / corners)))
    };
    let all: Option<Vec<bool>> = spokes.iter().zip(wedges(surface, v)?).map(corner).collect();
    Some(all?.into_iter().all(|regular| regular))
}

/// Whether the angle of an edge is lost if it comes from the arc cosine between the normals, on the right side of pi.
pub(super) fn arc_cosine_loses_dihedral(surface: &Surface, h: HalfEdgeId) -> Option<bool> {
    let along = |h: HalfEdgeId| Some(minus(surface.place(surface.table.twin(h)?)?, surface.place(h)?));
    let normal = |h: HalfEdgeId| Some(cross(along(h)?, along(surface.table.next(h)?)?));
    let (left, right) = (normal(h)?, normal(surface.table.twin(h)?)?);
    let angle = by_arc_cosine(left, right);
    let convex = dot(along(h)?, cross(left, right)) >= 0.0;
    Some(is_off(if convex { PI - angle } else { PI + angle }, dihedral(surface, h)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::counts::euler_of;
    use crate::courses::polyhedra::starts;

    #[test]
    fn the_deficits_of_every_solid_add_up_to_2_pi_times_its_euler_number() {
        for (name, surface) in starts::solids() {
            let sum: f64 = (0..surface.points.len() as u32).map(|v| deficit(&surface, v).unwrap()).sum();
            let expected = TAU * euler_of(&surface) as f64;
            assert!((sum - expected).abs() < 1e-11, "{name}: {sum}, expected {expected}");
        }
    }

    #[test]
    fn the_edges_of_the_regular_solids_have_the_angles_of_the_books() {
        let golden = f64::midpoint(1.0, 5f64.sqrt());
        let expected = [
            (1.0_f64 / 3.0).acos(),
            PI / 2.0,
            (-1.0_f64 / 3.0).acos(),
            2.0 * golden.atan(),
            2.0 * (golden * golden).atan(),
        ];
        for ((name, surface), expected) in starts::solids().into_iter().zip(expected) {
            for h in surface.half_edges() {
                let found = dihedral(&surface, h).unwrap();
                assert!((found - expected).abs() < 1e-12, "{name}, {h}: {found}, expected {expected}");
            }
        }
    }

    #[test]
    fn an_edge_is_convex_flat_or_reflex_and_its_twin_agrees() {
        let all = starts::solids();
        let of = |wanted: &str| all.iter().find(|(name, _)| name == wanted).map(|(_, solid)| solid).unwrap();
        let count = |wanted: &str, is: fn(f64) -> bool| {
            let surface = of(wanted);
            surface.half_edges().filter(|&h| is(dihedral(surface, h).unwrap())).count()
        };
        assert_eq!(count("dented_cube", |angle| angle > PI + 0.1), 8, "four edges into the dent");
        assert_eq!(count("cut_cube", |angle| (angle - PI).abs() < 1e-12), 12, "six diagonals");
        assert_eq!(count("frame", |angle| angle > PI + 0.1), 8, "four edges of the hole");
    }
}
