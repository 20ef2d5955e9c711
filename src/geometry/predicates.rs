//! Exact signs. Every geometric decision of the kit comes down to these.

use super::point::Point;
use robust::Coord;
use std::cmp::Ordering;

fn coord(p: Point) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// On which side of the directed line a -> b the point c lies: `Greater` = left (a, b, c turn
/// counter-clockwise), `Less` = right, `Equal` = on the line. Exact for all points that pass
/// [`Point::check`].
///
/// Mostly the difference of two products is clear; if it is not, crate `robust` decides. (It asks for the signs of the
/// products first, which no processor can guess.)
///
/// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997.
#[must_use]
#[inline]
pub fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let [one, other] = [(a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x)];
    let (difference, doubt) = (one - other, ROUNDING * (one.abs() + other.abs()));
    if difference > doubt {
        Ordering::Greater
    } else if difference < -doubt {
        Ordering::Less
    } else {
        sign(robust::orient2d(coord(a), coord(b), coord(c)))
    }
}

/// How much of the sum of two products of differences rounding may change their difference: (3 + 16 e) e, e = 2^-53.
pub(crate) const ROUNDING: f64 = 3.330_669_073_875_472e-16;

/// Whether d lies inside (`Greater`), on (`Equal`) or outside (`Less`) the circle through a, b, c, which must
/// turn counter-clockwise. Exact, as [`orientation`].
#[must_use]
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    sign(robust::incircle(coord(a), coord(b), coord(c), coord(d)))
}

/// Twice the area of the triangle a, b, c: positive if it runs counter-clockwise. The sign is exact, the size rounded.
#[must_use]
#[inline]
pub fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    robust::orient2d(coord(a), coord(b), coord(c))
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
pub(crate) fn sort_key(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_that_is_clear_is_the_one_of_all_digits() {
        // A few last places beside a line through two points, where plain products are often wrong (Kettner and
        // others, *Classroom examples of robustness problems in geometric computations*, 2008), and further off.
        let [b, c] = [Point::new(12.0, 12.0), Point::new(24.0, 24.0)];
        let [mut wrong, mut clear, mut on_the_line] = [0, 0, 0];
        for (i, k) in (0..48).flat_map(|i| (0..48).map(move |k| (i, k))) {
            for step in [1, 9] {
                let [x, y] = [i, k].map(|i| f64::from_bits(f64::to_bits(0.5) + i * step));
                let a = Point::new(x, y);
                let exact = sign(robust::orient2d(coord(a), coord(b), coord(c)));
                for (p, q, r) in [(a, b, c), (b, c, a), (c, a, b)] {
                    assert_eq!(orientation(p, q, r), exact, "{p} {q} {r}");
                    let [one, other] = [(p.x - r.x) * (q.y - r.y), (p.y - r.y) * (q.x - r.x)];
                    wrong += i32::from(sign(one - other) != exact);
                    clear += i32::from((one - other).abs() > ROUNDING * (one.abs() + other.abs()));
                }
                on_the_line += i32::from(exact.is_eq());
            }
        }
        assert!(wrong > 500 && clear > 100 && on_the_line >= 96, "{wrong} {clear} {on_the_line}: an easy test");
    }
}
