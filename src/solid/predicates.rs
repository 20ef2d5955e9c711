//! Exact signs in space. Every decision about solids comes down to these.
//!
//! ```text
//!            ● d            above: a, b, c run counter-clockwise when seen from d
//!        c
//!       ●───────● b
//!        ╲     ╱
//!         ╲   ╱
//!          ● a
//! ```

use crate::geometry::space;
use crate::plane::Expansion;
use robust::Coord3D;
use std::cmp::Ordering;

fn coord(p: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x: p[0], y: p[1], z: p[2] }
}

/// Whether d lies above (`Greater`), in (`Equal`) or below (`Less`) the plane through a, b, c. Exact for all points
/// that pass the check at the door.
///
/// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997, by
/// crate `robust`.
#[must_use]
#[inline]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Ordering {
    let from_d = |p: [f64; 3]| [p[0] - d[0], p[1] - d[1], p[2] - d[2]];
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (from_d(a), from_d(b), from_d(c));
    let ([bc, cb], [ca, ac], [ab, ba]) = ([bx * cy, cx * by], [cx * ay, ax * cy], [ax * by, bx * ay]);
    // Positive below the plane.
    let determinant = az * (bc - cb) + bz * (ca - ac) + cz * (ab - ba);
    let size = (bc.abs() + cb.abs()) * az.abs() + (ca.abs() + ac.abs()) * bz.abs() + (ab.abs() + ba.abs()) * cz.abs();
    let doubt = ROUNDING * size;
    if determinant > doubt {
        Ordering::Less
    } else if determinant < -doubt {
        Ordering::Greater
    } else {
        let determinant = robust::orient3d(coord(a), coord(b), coord(c), coord(d));
        0.0_f64.partial_cmp(&determinant).unwrap_or(Ordering::Equal)
    }
}

/// How much of the sum of the sizes of its products rounding may change the determinant: (7 + 56 e) e, e = 2^-53.
const ROUNDING: f64 = 7.771_561_172_376_103e-16;

/// Whether a, b, c lie on one line. Exact: they do if all three shadows do.
#[must_use]
pub fn are_collinear(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> bool {
    space::are_collinear(a, b, c)
}

/// Which of two points lies further in a direction; of two equally far ones, the one with the greater x, then the
/// greater y, then the greater z. `Equal` only for equal points. Exact.
///
/// That order of ties is the direction turned by an infinitely small angle, so it is free of plateaus: on a convex
/// solid a vertex that no neighbour exceeds is the furthest of all.
#[must_use]
#[inline]
pub fn further(direction: [f64; 3], p: [f64; 3], q: [f64; 3]) -> Ordering {
    let terms: [f64; 3] = std::array::from_fn(|i| direction[i] * (p[i] - q[i]));
    let sum = terms[0] + terms[1] + terms[2];
    // Each term carries two roundings and each sum one: five units in the last place of the sizes cover all.
    let error = (terms[0].abs() + terms[1].abs() + terms[2].abs()) * (5.0 * f64::EPSILON);
    let by_distance = if sum > error {
        Ordering::Greater
    } else if -sum > error {
        Ordering::Less
    } else {
        further_exactly(direction, p, q)
    };
    by_distance.then_with(|| by_position(p, q))
}

#[cold]
fn further_exactly(direction: [f64; 3], p: [f64; 3], q: [f64; 3]) -> Ordering {
    let term = |i: usize| Expansion::of(direction[i]).times(&Expansion::difference(p[i], q[i]));
    term(0).plus(&term(1)).plus(&term(2)).sign()
}

/// Order by x, then y, then z.
#[must_use]
pub fn by_position(p: [f64; 3], q: [f64; 3]) -> Ordering {
    let by = |i: usize| p[i].partial_cmp(&q[i]).unwrap_or(Ordering::Equal);
    by(0).then(by(1)).then(by(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn above_is_where_the_three_run_counter_clockwise() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(orient3d(a, b, c, [0.2, 0.2, 1e-300]), Ordering::Greater);
        assert_eq!(orient3d(a, b, c, [0.2, 0.2, -1e-300]), Ordering::Less);
        assert_eq!(orient3d(a, b, c, [7.0, -3.0, 0.0]), Ordering::Equal);
    }

    /// Both distances round to the same double; which one is greater, integers tell.
    #[test]
    fn further_is_exact_where_doubles_are_not() {
        let big = f64::from(1_u32 << 30);
        let direction = [big + 1.0, big - 1.0, 1.0];
        let (p, q) = ([big - 1.0, 0.0, 0.0], [0.0, big + 1.0, 0.0]);
        // (2^30 + 1)(2^30 - 1) on both sides.
        assert_eq!(further(direction, p, q), by_position(p, q));
        assert_eq!(further(direction, p, [0.0, big + 1.0, 2f64.powi(-40)]), Ordering::Less);
        assert_eq!(further(direction, [big - 1.0, 0.0, 2f64.powi(-40)], q), Ordering::Greater);
        assert_eq!(further([0.0, 0.0, 1.0], [1.0, 2.0, 0.0], [1.0, 1.0, 0.0]), Ordering::Greater);
    }
}
