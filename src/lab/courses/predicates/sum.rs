//! Sums of products of doubles without any rounding: an independent check of exact signs.
//!
//! ```text
//!   a double is  m · 2^e,  |m| < 2^53        a product of two is  m · 2^e,  |m| < 2^106
//!
//!   place      0        1        2     …      each place counts 2^-2200 · 2^(32 · place); what is too large for a
//!             [ ]      [ ]      [ ]           place is carried on to the next one only in the end
//! ```

/// Bits of a place.
const BITS: i32 = 32;
/// The exponent of place 0: below that of the product of the two smallest doubles.
const LOWEST: i32 = -2200;
/// As many places as the largest product and many sums need.
const PLACES: usize = 140;

/// A sum that is never rounded.
#[derive(Clone, Debug)]
pub struct ExactSum {
    places: Vec<i128>,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self { places: vec![0; PLACES] }
    }
}

impl ExactSum {
    /// Adds a double, which is finite.
    pub fn add(&mut self, x: f64) {
        let (m, e) = parts(x);
        self.add_parts(i128::from(m), e);
    }

    /// Adds the product of two doubles, which are finite.
    pub fn add_product(&mut self, a: f64, b: f64) {
        let ((m, e), (n, f)) = (parts(a), parts(b));
        self.add_parts(i128::from(m) * i128::from(n), e + f);
    }

    fn add_parts(&mut self, m: i128, e: i32) {
        let shift = e - LOWEST;
        let (mut place, low) = ((shift / BITS) as usize, shift % BITS);
        // A number of 106 bits, moved by less than a place, does not fit: its lower half is moved and added by itself.
        let (upper, lower) = (m >> 64, m & ((1 << 64) - 1));
        for mut rest in [lower << low, upper << low] {
            let from = place;
            while rest != 0 && rest != -1 {
                self.places[place] += rest & ((1 << BITS) - 1);
                rest >>= BITS;
                place += 1;
            }
            self.places[place] += rest;
            place = from + 2;
        }
    }

    /// The sign: 1, 0 or -1.
    #[must_use]
    pub fn sign(&self) -> i32 {
        let (mut carry, mut nonzero) = (0, false);
        for place in &self.places {
            let all = place + carry;
            nonzero |= all & ((1 << BITS) - 1) != 0;
            carry = all >> BITS;
        }
        // What is carried out of the last place is 0, or -1 below zero.
        if carry < 0 { -1 } else { i32::from(nonzero || carry > 0) }
    }
}

/// `m · 2^e`.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (m, e) = if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    (if x < 0.0 { -m } else { m }, e)
}

/// Which way three points turn, exactly.
#[must_use]
pub fn orientation([px, py]: [f64; 2], [qx, qy]: [f64; 2], [rx, ry]: [f64; 2]) -> i32 {
    let mut sum = ExactSum::default();
    for (a, b) in [(qx, ry), (-qx, py), (-px, ry), (-qy, rx), (qy, px), (py, rx)] {
        sum.add_product(a, b);
    }
    sum.sign()
}

/// The sign of a sum of doubles, exactly.
#[must_use]
pub fn sign_of(numbers: &[f64]) -> i32 {
    let mut sum = ExactSum::default();
    numbers.iter().for_each(|&x| sum.add(x));
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::random::Random;
    use dcel_kit::plane::{Point, predicates};
    use std::cmp::Ordering;

    #[test]
    fn signs_of_sums_are_those_of_whole_numbers() {
        assert_eq!([&[][..], &[0.0, -0.0], &[1e16, 1.0, -1e16], &[1e16, -1.0, -1e16]].map(sign_of), [0, 0, 1, -1]);
        assert_eq!([&[1e300, 1e-300, -1e300][..], &[5e-324], &[-5e-324, 5e-324]].map(sign_of), [1, 1, 0]);
        assert_eq!(sign_of(&[0.1, 0.2, -0.3]), 1);
        let mut random = Random::new(1, "sums");
        for _ in 0..500 {
            let numbers: Vec<i64> = (0..random.below(6)).map(|_| random.bits() as i64 >> (random.below(60))).collect();
            // Whole numbers of 53 bits are doubles.
            let numbers: Vec<i64> = numbers.into_iter().map(|n| n >> 11 << random.below(9)).collect();
            let sum: i64 = numbers.iter().sum();
            let doubles: Vec<f64> = numbers.iter().map(|&n| n as f64).collect();
            assert_eq!(sign_of(&doubles), sum.signum() as i32, "{numbers:?}");
        }
    }

    #[test]
    fn turns_are_those_of_the_kit() {
        let mut random = Random::new(2, "turns");
        let mut signs = [0; 2];
        for _ in 0..2000 {
            let scale = [1.0, 1e-30, 1e15][random.below(3)];
            let mut unit = || random.bits() as f64 / u64::MAX as f64 * scale;
            let (p, q) = ([unit(), unit()], [unit(), unit()]);
            let t = unit() / scale;
            let mut r = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
            if random.below(4) == 0 {
                r = [2.0 * q[0], 2.0 * q[1]];
            }
            let [a, b, c] = [p, q, r].map(|[x, y]| Point::new(x, y));
            let expected = predicates::orientation(a, b, c);
            assert_eq!(orientation(p, q, r).cmp(&0), expected, "{p:?} {q:?} {r:?}");
            signs[usize::from(expected == Ordering::Greater)] += 1;
            assert_eq!(orientation([0.0; 2], q, [2.0 * q[0], 2.0 * q[1]]), 0);
        }
        assert!(signs.iter().all(|&n| n > 100), "{signs:?}");
    }
}
