//! Numbers as sums of two doubles, with a bound of what is missing: between intervals and exact sums.
//!
//! ```text
//!   true number  =  high + low  ±  error          about 100 bits, on the stack; whoever needs more
//!                   106 bits                      than the bound promises asks an exact sum
//! ```
//!
//! All bounds hold for points that pass the check at the door and for polynomials in their differences up to degree 3:
//! nothing overflows, and nothing is lost below.
//!
//! Source: Dekker, *A floating-point technique for extending the available precision*, 1971.

use super::expansion::{two_product, two_sum};

/// How far one rounding can be off, relatively.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// Bounds are sums of a few products, all positive: this covers their own roundings.
const SPARE: f64 = 1.0 + 16.0 * f64::EPSILON;

/// A number known up to `error`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
    error: f64,
}

impl DoubleDouble {
    /// A double as it is.
    pub(crate) const fn of(a: f64) -> Self {
        Self { high: a, low: 0.0, error: 0.0 }
    }

    /// a - b, exactly.
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, -b);
        Self { high, low, error: 0.0 }
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let (sum, rest) = two_sum(self.high, other.high);
        let (low, lost) = two_sum(self.low, other.low);
        let (low, more) = two_sum(rest, low);
        let (high, low) = two_sum(sum, low);
        Self { high, low, error: (self.error + other.error + lost.abs() + more.abs()) * SPARE }
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low, error: other.error })
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let (product, rest) = two_product(a.high, b.high);
        let inherited = a.high.abs() * b.error + (b.high.abs() + b.error) * a.error;
        if a.low == 0.0 && b.low == 0.0 {
            return Self { high: product, low: rest, error: inherited * SPARE };
        }
        // Left out: low times low, and five roundings of numbers that are small beside the product already.
        let (across, along) = (a.high * b.low, a.low * b.high);
        let (high, low) = two_sum(product, rest + (across + along));
        let left_out = (a.low * b.low).abs() + 3.0 * ROUNDING * (rest.abs() + across.abs() + along.abs());
        Self { high, low, error: (inherited + (a.low.abs() * b.error + b.low.abs() * a.error) + left_out) * SPARE }
    }

    /// The quotient as the nearest double, what is missing to it, and how far off that can be; `None` if the next double
    /// may be nearer, or if the divisor is not known well.
    pub(crate) fn nearest_quotient(self, by: Self) -> Option<Quotient> {
        let divisor = by.high.abs();
        // How far the divisor is from its high part, relatively.
        let blurred = (by.low.abs() + by.error) / divisor * SPARE;
        if blurred.is_nan() || blurred > 1e-12 {
            return None;
        }
        let first = self.high / by.high;
        let left = self.minus(Self::of(first).times(by));
        let second = left.high / by.high;
        let error = if left == Self::of(0.0) {
            0.0
        } else {
            ((left.low.abs() + left.error) / divisor * (1.0 + 1e-11) + second.abs() * (2.0 * blurred + ROUNDING))
                * SPARE
        };
        let (nearest, rest) = two_sum(first, second);
        let gap = (nearest.next_up() - nearest).min(nearest - nearest.next_down());
        (rest.abs() + error < gap * 0.499).then_some(Quotient { nearest, rest, error })
    }
}

/// A quotient: `nearest + rest`, up to `error`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quotient {
    pub(crate) nearest: f64,
    pub(crate) rest: f64,
    pub(crate) error: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::expansion::Expansion;
    use std::cmp::Ordering;

    /// Whether an exact number is within the bound.
    fn holds(exact: &Expansion, found: DoubleDouble) -> bool {
        let off = exact.clone().minus(&Expansion::of(found.high)).minus(&Expansion::of(found.low));
        let off = if off.sign().is_lt() { off.negated() } else { off };
        off.minus(&Expansion::of(found.error)).sign() != Ordering::Greater
    }

    /// Doubles of all sizes, some of them with few bits, some close to each other.
    fn doubles(count: usize) -> Vec<f64> {
        let mut state = 11_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 11
        };
        let mut last = 1.0_f64;
        let mut one = |i: usize| {
            let whole = next() as f64 - 2f64.powi(52);
            last = match i % 5 {
                0 => whole * 2f64.powi(next() as i32 % 60 - 30),
                1 => (whole / 2f64.powi(44)).round(),
                2 => last.next_up(),
                3 => last * (1.0 + whole * 2f64.powi(-90)),
                _ => whole * 2f64.powi(-52),
            };
            last
        };
        (0..count).map(&mut one).collect()
    }

    #[test]
    fn the_true_number_is_within_the_bound() {
        let mut inexact = 0;
        for numbers in doubles(7 * 20_000).chunks_exact(7) {
            let &[a, b, c, d, e, f, g] = numbers else { unreachable!() };
            let pair = |a, b| (DoubleDouble::difference(a, b), Expansion::difference(a, b));
            let ((p, exact_p), (q, exact_q), (r, exact_r), (s, exact_s)) =
                (pair(a, b), pair(c, d), pair(e, f), pair(g, a));
            let exact_area = exact_p.times(&exact_q).minus(&exact_r.times(&exact_s));
            let area = p.times(q).minus(r.times(s));
            assert!(holds(&exact_area, area), "{numbers:?}");
            let exact_all = exact_area.times(&exact_r).plus(&Expansion::of(g).times(&exact_area));
            let all = area.times(r).plus(DoubleDouble::of(g).times(area));
            assert!(holds(&exact_all, all), "{numbers:?}");
            assert!(
                all.error
                    <= 1e-27 * (area.high.abs() * (r.high.abs() + g.abs()))
                        + 3.0 * area.error * (r.high.abs() + g.abs())
            );
            inexact += usize::from(all.error > 0.0);
        }
        assert!(inexact > 10_000, "{inexact}");
    }

    #[test]
    fn quotients_are_the_nearest_doubles_or_none() {
        let mut known = 0;
        for numbers in doubles(5 * 20_000).chunks_exact(5) {
            let &[a, b, c, d, e] = numbers else { unreachable!() };
            let number = DoubleDouble::difference(a, b).times(DoubleDouble::of(c));
            let by = DoubleDouble::difference(d, e);
            let Some(Quotient { nearest, rest, error }) = number.nearest_quotient(by) else { continue };
            known += 1;
            let (exact, exact_by) = (Expansion::difference(a, b).times(&Expansion::of(c)), Expansion::difference(d, e));
            // The sign of number / by - x.
            let beyond = |x: &Expansion| {
                let sign = exact.clone().minus(&x.times(&exact_by)).sign();
                if exact_by.sign().is_lt() { sign.reverse() } else { sign }
            };
            let at = |x: f64| Expansion::of(nearest).plus(&Expansion::of(x));
            assert!(beyond(&at(rest).plus(&Expansion::of(error))).is_le(), "{numbers:?}");
            assert!(beyond(&at(rest).minus(&Expansion::of(error))).is_ge(), "{numbers:?}");
            assert!(beyond(&at((nearest.next_up() - nearest) / 2.0)).is_le(), "{numbers:?}");
            assert!(beyond(&at((nearest.next_down() - nearest) / 2.0)).is_ge(), "{numbers:?}");
        }
        assert!(known > 15_000, "{known}");
        let third = DoubleDouble::of(1.0).nearest_quotient(DoubleDouble::of(3.0)).unwrap();
        assert_eq!(third.nearest, 1.0 / 3.0);
        let half = DoubleDouble::of(1.5).nearest_quotient(DoubleDouble::of(3.0));
        assert_eq!(half, Some(Quotient { nearest: 0.5, rest: 0.0, error: 0.0 }));
        // Half way between two doubles: neither is said to be nearer.
        let tie = DoubleDouble::of(1.0).plus(DoubleDouble::of(f64::EPSILON / 2.0));
        assert_eq!(tie.nearest_quotient(DoubleDouble::of(1.0)), None);
        assert_eq!(tie.nearest_quotient(DoubleDouble::of(0.0)), None);
    }
}
