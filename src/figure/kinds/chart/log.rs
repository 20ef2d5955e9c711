//! Logarithms with the same bits on every platform.
//!
//! ```text
//!   x = 2^e · m   with  m in [√½, √2)          log2 x = e + (2 / ln 2) · artanh s,   s = (m - 1) / (m + 1)
//!
//!   artanh s = s + s³/3 + s⁵/5 + …             |s| < 0.172: twelve terms are below the last bit of a double
//! ```
//!
//! `f64::ln` and its kin come from the platform's mathematics library, and these differ in the last bit; a figure
//! drawn with them would differ between machines. Here is nothing but `+ - * /`. Powers of two are exact.
//!
//! Source of the series: Abramowitz and Stegun, *Handbook of Mathematical Functions*, 4.1.27.

/// The binary logarithm of a positive number; `None` for all others. Off by less than 4e-16 of the result plus 1e-16.
pub(crate) fn log2(x: f64) -> Option<f64> {
    if !(x > 0.0 && x.is_finite()) {
        return None;
    }
    // Denormal numbers are lifted into the range where the exponent can be read.
    let (x, lift) = if x < f64::MIN_POSITIVE { (x * (1u64 << 54) as f64, 54.0) } else { (x, 0.0) };
    let bits = x.to_bits();
    let mut exponent = (bits >> 52) as f64 - 1023.0 - lift;
    let mut mantissa = f64::from_bits((bits & ((1 << 52) - 1)) | (1023 << 52));
    if mantissa >= std::f64::consts::SQRT_2 {
        mantissa *= 0.5;
        exponent += 1.0;
    }
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let squared = s * s;
    let series = (0..12).rev().fold(0.0, |sum, k| sum * squared + 1.0 / f64::from(2 * k + 1));
    Some(exponent + 2.0 * std::f64::consts::LOG2_E * s * series)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts;

    #[test]
    fn powers_of_two_are_exact() {
        for e in -1022..=1023i64 {
            let power = f64::from_bits(((e + 1023) as u64) << 52);
            assert_eq!(log2(power).map(f64::to_bits), Some((e as f64).to_bits()), "2^{e}");
        }
        assert_eq!(log2(f64::from_bits(1)), Some(-1074.0));
        assert_eq!(log2(f64::from_bits(1 << 51)), Some(-1023.0));
    }

    #[test]
    fn known_values_and_the_law_of_products() {
        let near = |x: f64, value: f64| {
            let log = log2(x).unwrap();
            assert!((log - value).abs() <= 4e-16 * value.abs() + 1e-16, "log2 {x} = {log:?}, not {value:?}");
        };
        near(10.0, consts::LOG2_10);
        near(consts::E, consts::LOG2_E);
        near(3.0, 1.584_962_500_721_156);
        near(1e100, 332.192_809_488_736_2);
        near(0.1, -consts::LOG2_10);
        near(consts::SQRT_2, 0.5);
        let mut x = 1e-9;
        while x < 1e9 {
            let sum = log2(x).unwrap() + log2(1.7).unwrap();
            assert!((log2(x * 1.7).unwrap() - sum).abs() < 1e-13, "{x}");
            x *= 1.37;
        }
    }

    #[test]
    fn what_has_no_logarithm_has_none() {
        for x in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(log2(x), None, "{x}");
        }
    }
}
