//! On which side of a ray a point is: quickly if it is clear, exactly if it is not.
//!
//! ```text
//!       · left            (x, y) = p - from
//!   ───────────> along    along.x · y - along.y · x, and a bound on how much rounding may have changed it
//!    from  · right
//! ```
//!
//! A ray is asked about many points, so its direction is kept. If the product is greater than the bound its sign is
//! right; else the exact sign of the points that were given decides. Either way the sign is exact.
//!
//! Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997, for
//! the bound.

use crate::plane::Point;
use crate::plane::predicates::ROUNDING;
use std::cmp::Ordering;

/// 1 on the left, -1 on the right, 0 on the line.
pub(super) type Turn = i8;

/// A ray by its direction: the difference of two points that were given, on the line of the ray.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    pub(super) from: Point,
    pub(super) along: [f64; 2],
}

impl Ray {
    /// On which side of the ray `p` is. If that cannot be told from the direction, `exactly` does.
    #[inline]
    pub(super) fn turn(&self, p: Point, exactly: impl FnOnce() -> Ordering) -> Turn {
        let [height, bound] = self.height(p);
        if height > bound {
            1
        } else if height < -bound {
            -1
        } else {
            exactly() as Turn
        }
    }

    /// How far left `p` is, times the distance of the two points, and by how much that may be wrong.
    #[inline]
    pub(super) fn height(&self, p: Point) -> [f64; 2] {
        let [x, y] = difference(self.from, p);
        let [a, b] = [self.along[0] * y, self.along[1] * x];
        [a - b, ROUNDING * (a.abs() + b.abs())]
    }
}

/// The way from `a` to `b`.
#[inline]
pub(super) fn difference(a: Point, b: Point) -> [f64; 2] {
    [b.x - a.x, b.y - a.y]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::predicates::orientation;

    #[test]
    fn the_quick_sign_is_the_exact_one() {
        // Points a few last places beside a line, as far from it as rounding may matter, and a little further; the
        // ray begins at the first point, or at the second and goes on.
        let line = [Point::new(0.1, 0.1), Point::new(12.3, 12.3)];
        for from in line {
            let ray = Ray { from, along: difference(line[0], line[1]) };
            let [mut clear, mut close] = [0, 0];
            for i in -10..=10_i64 {
                for (x, step) in [(24.7, 1), (0.5, 1), (1e-3, 64), (1e6, 1)] {
                    let p = Point::new(x, f64::from_bits((f64::to_bits(x) as i64 + i * step) as u64));
                    let exact = orientation(line[0], line[1], p);
                    let quick = ray.turn(p, || {
                        close += 1;
                        exact
                    });
                    clear += 1;
                    assert_eq!(quick, exact as Turn, "{p}");
                }
            }
            clear -= close;
            assert!(clear >= 20 && close >= 20, "{clear} are clear, {close} are not: the bound is not put to the test");
        }
    }
}
