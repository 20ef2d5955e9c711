//! On which side of a ray a point is: quickly if it is clear, exactly if it is not.
//!
//! ```text
//!       · left            (x, y) = p - from
//!   ───────────> along    along.x · y - along.y · x, and a bound on how much rounding may have changed it
//!    from  · right
//! ```
//!
//! A ray is asked about many points, so its direction is kept. If the product is greater than the bound its sign is
//! right; else [`orientation`] decides. Either way the sign is exact.
//!
//! Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997, for
//! the bound.

use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// How much of the sum of the two products rounding may change: (3 + 16 e) e, with e = 2^-53.
const ROUNDING: f64 = 3.330_669_073_875_472e-16;

/// A directed line through two points that were given.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    from: Point,
    to: Point,
    along: [f64; 2],
}

impl Ray {
    #[inline]
    pub(super) fn new(from: Point, to: Point) -> Self {
        Self { from, to, along: [to.x - from.x, to.y - from.y] }
    }

    /// `Greater` if `p` is on the left, `Less` if it is on the right, `Equal` if it is on the line.
    #[inline]
    pub(super) fn turn(&self, p: Point) -> Ordering {
        let [height, bound] = self.height(p);
        if height > bound {
            Ordering::Greater
        } else if height < -bound {
            Ordering::Less
        } else {
            orientation(self.from, self.to, p)
        }
    }

    /// How far left `p` is, times the distance of the two points, and by how much that may be wrong.
    #[inline]
    pub(super) fn height(&self, p: Point) -> [f64; 2] {
        let [x, y] = [p.x - self.from.x, p.y - self.from.y];
        let [a, b] = [self.along[0] * y, self.along[1] * x];
        [a - b, ROUNDING * (a.abs() + b.abs())]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quick_sign_is_the_exact_one() {
        // Points a few last places beside a line, as far from it as rounding may matter, and a little further.
        let line = [Point::new(0.1, 0.1), Point::new(12.3, 12.3)];
        let ray = Ray::new(line[0], line[1]);
        let [mut clear, mut close] = [0, 0];
        for i in -10..=10_i64 {
            for (x, step) in [(24.7, 1), (0.5, 1), (1e-3, 64), (1e6, 1)] {
                let p = Point::new(x, f64::from_bits((f64::to_bits(x) as i64 + i * step) as u64));
                assert_eq!(ray.turn(p), orientation(line[0], line[1], p), "{p}");
                let [height, bound] = ray.height(p);
                if height.abs() > bound { clear += 1 } else { close += 1 }
            }
        }
        assert!(clear >= 20 && close >= 20, "{clear} are clear, {close} are not: the bound is not put to the test");
    }
}
