//! Numbers as sums of two doubles, with a bound of what is missing: between intervals and exact sums.
//!
//! ```text
//!   true number  =  high + low  ±  error          about 100 bits, on the stack; whoever needs more
//!                   106 bits                      than the bound promises asks an exact sum
//! ```
//!
//! All bounds hold for points that pass the check at the door, for polynomials in their differences up to degree 3, and for
//! quotients of these: nothing overflows. What a quotient may lose below 2^-1022, and what products make of that, is less than
//! 2^-800: so no sign is told of anything smaller, unless it is exactly 0.
//!
//! Source: Dekker, *A floating-point technique for extending the available precision*, 1971.

use super::expansion::{two_product, two_sum};
use super::two::{Doubles, Two};
use std::array::from_fn;
use std::cmp::Ordering;

/// How far one rounding can be off, relatively.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// What is lost below the smallest doubles stays below this.
const LOST: f64 = f64::from_bits((1023 - 800) << 52);
/// A quotient nearer to 0 is not computed: its digits may lie below the smallest doubles.
const TINY: f64 = f64::from_bits((1023 - 400) << 52);
/// Bounds are sums of a few products, all positive: this covers their own roundings.
const SPARE: f64 = 1.0 + 16.0 * f64::EPSILON;

/// A number known up to `error`; or two of them, computed with at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble<F = f64> {
    high: F,
    low: F,
    error: F,
}

impl<F: Doubles> DoubleDouble<F> {
    /// A double as it is.
    #[inline(always)]
    pub(crate) fn of(a: F) -> Self {
        Self { high: a, low: F::all(0.0), error: F::all(0.0) }
    }

    /// a - b, exactly.
    #[inline(always)]
    pub(crate) fn difference(a: F, b: F) -> Self {
        let (high, low) = two_sum(a, -b);
        Self { high, low, error: F::all(0.0) }
    }

    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let (sum, rest) = two_sum(self.high, other.high);
        let (low, lost) = two_sum(self.low, other.low);
        let (low, more) = two_sum(rest, low);
        let (high, low) = two_sum(sum, low);
        Self { high, low, error: (self.error + other.error + lost.abs() + more.abs()) * F::all(SPARE) }
    }

    #[inline(always)]
    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low, error: other.error })
    }

    #[inline(always)]
    pub(crate) fn times(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let (product, rest) = two_product(a.high, b.high);
        let inherited = a.high.abs() * b.error + (b.high.abs() + b.error) * a.error;
        // A bound must not become 0 by rounding.
        let least = F::choose((a.error + b.error).are_zero(), F::all(0.0), F::all(f64::MIN_POSITIVE));
        let inherited = inherited + least;
        // Left out: low times low, and five roundings of numbers that are small beside the product already.
        let (across, along) = (a.high * b.low, a.low * b.high);
        let (high, low) = two_sum(product, rest + (across + along));
        let left_out = (a.low * b.low).abs() + F::all(3.0 * ROUNDING) * (rest.abs() + across.abs() + along.abs());
        let all = inherited + (a.low.abs() * b.error + b.low.abs() * a.error) + left_out;
        // The product of two doubles has no part that is left out.
        let are_doubles = F::both(a.low.are_zero(), b.low.are_zero());
        Self { high, low, error: F::choose(are_doubles, inherited, all) * F::all(SPARE) }
    }

    /// The quotient; besides, for [`is_known`], how far the divisor is from its high part, relatively, and the quotient of
    /// the high parts.
    #[inline(always)]
    fn divided(self, by: Self) -> (Self, [F; 2]) {
        let divisor = by.high.abs();
        let blurred = (by.low.abs() + by.error) / divisor * F::all(SPARE);
        let first = self.high / by.high;
        let left = self.minus(Self::of(first).times(by));
        let is_exact = F::both(F::both(left.high.are_zero(), left.low.are_zero()), left.error.are_zero());
        let second = left.high / by.high;
        let rest = (left.low.abs() + left.error) / divisor * F::all(1.0 + 1e-11);
        let error = rest + second.abs() * (F::all(2.0) * blurred + F::all(ROUNDING)) + F::all(f64::MIN_POSITIVE);
        let (high, low) = two_sum(first, second);
        (Self { high, low, error: F::choose(is_exact, F::all(0.0), error * F::all(SPARE)) }, [blurred, first])
    }
}

/// Whether a quotient is known: the divisor is known well, and the quotient is not too near to 0.
fn is_known(blurred: f64, first: f64) -> bool {
    blurred <= 1e-12 && (first == 0.0 || first.abs() >= TINY)
}

impl DoubleDouble<Two> {
    /// The one in each place.
    #[inline(always)]
    pub(crate) fn each(self) -> [DoubleDouble; 2] {
        from_fn(|i| DoubleDouble { high: self.high.0[i], low: self.low.0[i], error: self.error.0[i] })
    }

    /// One of each, in the same place.
    #[inline(always)]
    pub(crate) fn of_places(self, other: Self, i: usize) -> Self {
        let pair = |a: Two, b: Two| Two([a.0[i], b.0[i]]);
        Self { high: pair(self.high, other.high), low: pair(self.low, other.low), error: pair(self.error, other.error) }
    }

    /// That in one place, in both.
    #[inline(always)]
    pub(crate) fn only(self, i: usize) -> Self {
        self.of_places(self, i)
    }

    /// The quotients; `None` where the divisor is not known well.
    #[inline(always)]
    pub(crate) fn over(self, by: Self) -> [Option<DoubleDouble>; 2] {
        let (quotients, [blurred, first]) = self.divided(by);
        let each = quotients.each();
        from_fn(|i| is_known(blurred.0[i], first.0[i]).then_some(each[i]))
    }
}

impl DoubleDouble {
    /// The number as one double.
    pub(crate) const fn estimate(self) -> f64 {
        self.high
    }

    /// The nearest double, and how far the number is from it: more, by at most ten digits; `None` if the next double may
    /// be nearer, or if so many digits are not known.
    pub(crate) fn nearest(self) -> Option<(f64, f64)> {
        let Self { high, low, error } = self;
        let gap = (high.next_up() - high).min(high - high.next_down());
        let known = low.abs() + error < gap * 0.499 && error <= low.abs() * 1e-10;
        known.then(|| (high + 0.0, low.abs() + error))
    }

    /// How far the number lies above a double: not less than the first bound, and not more than the second.
    pub(crate) fn above(self, x: f64) -> [f64; 2] {
        let Self { high, low, error } = self.minus(Self::of(x));
        let off = (low.abs() + error) * SPARE;
        [(high - off).next_down(), (high + off).next_up()]
    }

    /// The order of the two numbers, if it is certain.
    pub(crate) fn order(self, other: Self) -> Option<Ordering> {
        self.minus(other).sign()
    }

    /// The sign, if it is certain.
    pub(crate) fn sign(self) -> Option<Ordering> {
        let Self { high, low, error } = self;
        // The high part is the nearest double to the sum of both, so it has the sign of the sum.
        if high.abs() - low.abs() > error * SPARE + LOST {
            high.partial_cmp(&0.0)
        } else {
            (high == 0.0 && error == 0.0).then_some(Ordering::Equal)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::expansion::Expansion;

    impl DoubleDouble {
        /// The quotient; `None` if the divisor is not known well.
        fn over(self, by: Self) -> Option<Self> {
            let (quotient, [blurred, first]) = self.divided(by);
            is_known(blurred, first).then_some(quotient)
        }
    }

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
                2 if last != 0.0 => last.next_up(),
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
    fn quotients_are_within_the_bound_and_round_to_the_nearest_doubles() {
        let mut known = 0;
        for numbers in doubles(5 * 20_000).chunks_exact(5) {
            let &[a, b, c, d, e] = numbers else { unreachable!() };
            let number = DoubleDouble::difference(a, b).times(DoubleDouble::of(c));
            let by = DoubleDouble::difference(d, e);
            let Some(quotient) = number.over(by) else { continue };
            let (exact, exact_by) = (Expansion::difference(a, b).times(&Expansion::of(c)), Expansion::difference(d, e));
            // The sign of number / by - x.
            let beyond = |x: &Expansion| {
                let sign = exact.clone().minus(&x.times(&exact_by)).sign();
                if exact_by.sign().is_lt() { sign.reverse() } else { sign }
            };
            let DoubleDouble { high, low, error } = quotient;
            let at = |x: f64| Expansion::of(high).plus(&Expansion::of(x));
            assert!(beyond(&at(low).plus(&Expansion::of(error))).is_le(), "{numbers:?}");
            assert!(beyond(&at(low).minus(&Expansion::of(error))).is_ge(), "{numbers:?}");
            for x in [high.next_down(), high, e] {
                let [least, most] = quotient.above(x).map(|off| Expansion::of(x).plus(&Expansion::of(off)));
                assert!(beyond(&least).is_ge() && beyond(&most).is_le(), "{numbers:?}");
            }
            let Some((nearest, off)) = quotient.nearest() else { continue };
            known += 1;
            assert_eq!(nearest.to_bits(), (high + 0.0).to_bits());
            assert!(beyond(&at((high.next_up() - high) / 2.0)).is_le(), "{numbers:?}");
            assert!(beyond(&at((high.next_down() - high) / 2.0)).is_ge(), "{numbers:?}");
            assert!(beyond(&at(off)).is_le() && beyond(&at(-off)).is_ge(), "{numbers:?}");
        }
        assert!(known > 15_000, "{known}");
        let over = |a: f64, b: f64| DoubleDouble::of(a).over(DoubleDouble::of(b));
        assert_eq!(over(1.0, 3.0).and_then(DoubleDouble::nearest).map(|(nearest, _)| nearest), Some(1.0 / 3.0));
        assert_eq!(over(1.5, 3.0).and_then(DoubleDouble::nearest), Some((0.5, 0.0)));
        assert_eq!(over(1.5, 0.0), None);
        // Half way between two doubles: neither is said to be nearer.
        let tie = DoubleDouble::of(1.0).plus(DoubleDouble::of(f64::EPSILON / 2.0));
        assert_eq!(tie.nearest(), None);
    }

    fn formula<F: Doubles>([a, b, c, d]: [F; 4]) -> [DoubleDouble<F>; 3] {
        let product = DoubleDouble::difference(a, b).times(DoubleDouble::difference(c, d));
        let sum = product.plus(DoubleDouble::of(a).times(DoubleDouble::of(c)));
        let by = DoubleDouble::difference(d, b).times(DoubleDouble::of(c));
        [product, sum, sum.minus(product).divided(by).0]
    }

    #[test]
    fn two_at_once_are_each_what_they_are_by_themselves() {
        let mut unlike = 0;
        for numbers in doubles(8 * 20_000).chunks_exact(8) {
            let (one, other) = numbers.split_at(4);
            let both = formula(from_fn(|i| Two([one[i], other[i]])));
            let by_themselves = [one, other].map(|numbers| formula(from_fn(|i| numbers[i])));
            for (i, both) in both.into_iter().enumerate() {
                // As texts, which tell 0 and -0 apart, and where something was divided by 0 are equal, too.
                let expected = by_themselves.map(|formula| formula[i]);
                assert_eq!(format!("{:?}", both.each()), format!("{expected:?}"), "{numbers:?}");
            }
            // One is exact, the other is not.
            let [[product, ..], [other, ..]] = by_themselves;
            unlike += usize::from((product.error == 0.0) != (other.error == 0.0));
        }
        assert!(unlike > 1000, "{unlike}");
    }

    #[test]
    fn signs_are_right_or_not_told() {
        let mut told = [0; 2];
        for numbers in doubles(4 * 20_000).chunks_exact(4) {
            let &[a, b, c, d] = numbers else { unreachable!() };
            // The second number is nearly the first.
            let (p, q) = (DoubleDouble::difference(a, b), DoubleDouble::difference(c, d));
            let close = p.times(q).plus(DoubleDouble::of(a * 2f64.powi(-100)));
            let exact = Expansion::difference(a, b).times(&Expansion::difference(c, d));
            let exact_close = exact.clone().plus(&Expansion::of(a * 2f64.powi(-100)));
            let expected = exact_close.minus(&exact).sign();
            let found = close.order(p.times(q));
            assert!(found.is_none_or(|found| found == expected), "{numbers:?}");
            told[usize::from(found.is_some())] += 1;
        }
        assert!(told[0] > 1000 && told[1] > 1000, "{told:?}");
        let third = DoubleDouble::of(1.0).over(DoubleDouble::of(3.0)).unwrap();
        assert_eq!(
            (third.order(third), DoubleDouble::of(2.0).order(DoubleDouble::of(2.0))),
            (None, Some(Ordering::Equal))
        );
        assert_eq!(third.order(DoubleDouble::of(1.0 / 3.0)), Some(Ordering::Greater));
        // Near the smallest doubles nothing is told but an exact 0.
        let tiny = DoubleDouble::of(2f64.powi(-600));
        assert_eq!((tiny.sign(), tiny.over(DoubleDouble::of(1.0))), (Some(Ordering::Greater), None));
        assert_eq!(DoubleDouble::of(2f64.powi(-900)).sign(), None);
        let nothing = third.minus(third).times(DoubleDouble::of(2f64.powi(-190)));
        assert_eq!((nothing.high, nothing.sign()), (0.0, None));
    }
}
