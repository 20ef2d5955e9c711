//! Exact signs. Every geometric decision of the kit comes down to these.

use super::Point;
use robust::Coord;
use std::cmp::Ordering;

fn coord(p: Point) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// On which side of the directed line a -> b the point c lies: `Greater` = left (a, b, c turn
/// counter-clockwise), `Less` = right, `Equal` = on the line. Exact for all points that pass
/// [`Point::check`].
///
/// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*,
/// 1997, by crate `robust`.
#[must_use]
#[inline]
pub fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    sign(robust::orient2d(coord(a), coord(b), coord(c)))
}

/// Whether d lies inside (`Greater`), on (`Equal`) or outside (`Less`) the circle through a, b, c, which must
/// turn counter-clockwise. Exact, as [`orientation`].
#[must_use]
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    sign(robust::incircle(coord(a), coord(b), coord(c), coord(d)))
}

fn sign(value: f64) -> Ordering {
    value.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// Order from left to right, points above each other from bottom to top.
#[must_use]
#[inline]
pub fn left_to_right(a: Point, b: Point) -> Ordering {
    let by = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    by(a.x, b.x).then(by(a.y, b.y))
}

/// A whole number that orders finite numbers as they are, with -0 = 0.
#[inline]
pub(super) fn sort_key(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}
