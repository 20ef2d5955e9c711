//! Exact sums and products of doubles: a number as a sum of doubles that do not overlap.
//!
//! ```text
//!   2^60 + 1  =  1152921504606846976 + 1          terms from the smallest to the largest, no zeros:
//!                                                 the last one has the sign of all
//! ```
//!
//! For points that pass the check at the door a polynomial of degree 5 in differences of coordinates neither
//! overflows (5 x 202 < 1023 bits above 1) nor loses a bit below (5 x 194 < 1074 bits).
//!
//! Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997.

use super::two::Doubles;
use std::cmp::Ordering;

/// An exact number.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Expansion(Vec<f64>);

#[inline(always)]
pub(super) fn two_sum<F: Doubles>(a: F, b: F) -> (F, F) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

#[inline(always)]
fn halves<F: Doubles>(a: F) -> (F, F) {
    let c = F::all(134_217_729.0) * a;
    let high = c - (c - a);
    (high, a - high)
}

#[inline(always)]
pub(super) fn two_product<F: Doubles>(a: F, b: F) -> (F, F) {
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    (product, a0 * b0 - (((product - a1 * b1) - a0 * b1) - a1 * b0))
}

impl Expansion {
    /// A double as it is.
    pub(crate) fn of(a: f64) -> Self {
        Self(if a == 0.0 { Vec::new() } else { vec![a] })
    }

    /// a - b.
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        let (sum, rest) = two_sum(a, -b);
        Self([rest, sum].into_iter().filter(|&term| term != 0.0).collect())
    }

    /// Adds a b.
    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let (high, low) = two_product(a, b);
        self.grow(low);
        self.grow(high);
    }

    /// Adds a b c.
    #[cfg(feature = "solid")]
    pub(crate) fn add_product_of_three(&mut self, a: f64, b: f64, c: f64) {
        let (high, low) = two_product(a, b);
        self.add_product(low, c);
        self.add_product(high, c);
    }

    /// Adds one double.
    fn grow(&mut self, b: f64) {
        let mut sum = b;
        let mut kept = 0;
        for i in 0..self.0.len() {
            let (total, rest) = two_sum(sum, self.0[i]);
            sum = total;
            if rest != 0.0 {
                self.0[kept] = rest;
                kept += 1;
            }
        }
        self.0.truncate(kept);
        if sum != 0.0 {
            self.0.push(sum);
        }
    }

    pub(crate) fn plus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&term| self.grow(term));
        self
    }

    pub(crate) fn minus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&term| self.grow(-term));
        self
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for &a in &self.0 {
            for &b in &other.0 {
                let (high, low) = two_product(a, b);
                product.grow(low);
                product.grow(high);
            }
        }
        product.compressed()
    }

    /// The same with as few terms as possible.
    fn compressed(mut self) -> Self {
        let Some(mut sum) = self.0.pop() else { return self };
        let mut terms = Vec::with_capacity(self.0.len() + 1);
        while let Some(term) = self.0.pop() {
            let (total, rest) = two_sum(sum, term);
            if rest == 0.0 {
                sum = total;
            } else {
                terms.push(total);
                sum = rest;
            }
        }
        terms.push(sum);
        terms.reverse();
        Self(terms)
    }

    pub(crate) fn negated(mut self) -> Self {
        self.0.iter_mut().for_each(|term| *term = -*term);
        self
    }

    /// The double next to it, or the one beside that; 0 only for 0.
    pub(crate) fn rounded(self) -> f64 {
        self.compressed().estimate()
    }

    pub(crate) fn sign(&self) -> Ordering {
        self.0.last().map_or(Ordering::Equal, |last| last.total_cmp(&0.0))
    }

    /// The double next to it, or one beside that; 0, and not -0, of nothing.
    pub(crate) fn estimate(&self) -> f64 {
        self.0.iter().fold(0.0, |sum, term| sum + term)
    }
}

/// a.x b.y - a.y b.x
pub(crate) fn cross(a: &[Expansion; 2], b: &[Expansion; 2]) -> Expansion {
    a[0].times(&b[1]).minus(&a[1].times(&b[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_are_exact() {
        let mut state = 7_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 40) as i64 - (1 << 23)) as i128
        };
        let big = |n: i128| {
            // In three pieces that doubles hold.
            let (high, rest) = (n >> 80, n & ((1 << 80) - 1));
            Expansion::of(high as f64 * 2f64.powi(80))
                .plus(&Expansion::of((rest >> 40) as f64 * 2f64.powi(40)))
                .plus(&Expansion::of((rest & ((1 << 40) - 1)) as f64))
        };
        for _ in 0..2000 {
            let [a, b, c, d, e] = [(); 5].map(|()| next());
            let [x, y, z, u, v] = [a, b, c, d, e].map(|n| Expansion::of(n as f64));
            // Degree 5 in 24-bit numbers: 120 bits.
            let product = x.times(&y).times(&z).times(&u).times(&v);
            assert_eq!(product.clone().minus(&big(a * b * c * d * e)).sign(), Ordering::Equal, "{a} {b} {c} {d} {e}");
            let cancelled = product.clone().plus(&Expansion::of(1.0)).minus(&product);
            assert_eq!(cancelled, Expansion::of(1.0));
            let p = [Expansion::difference(a as f64, b as f64), Expansion::difference(c as f64, d as f64)];
            let q = [Expansion::of(e as f64), Expansion::of(1.0)];
            assert_eq!(cross(&p, &q).sign(), (a - b - (c - d) * e).cmp(&0));
        }
        let tiny = Expansion::difference(1.0, 2f64.powi(-140));
        assert_eq!(tiny.clone().minus(&Expansion::of(1.0)).negated(), Expansion::of(2f64.powi(-140)));
        assert_eq!(tiny.times(&tiny).minus(&Expansion::of(1.0)).sign(), Ordering::Less);
    }
}
