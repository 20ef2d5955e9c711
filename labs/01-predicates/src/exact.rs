//! Two operations that lose nothing: a sum or a product of two doubles, as the sum of two doubles.
//!
//! ```text
//!   two_sum(1e16, 1.0)  =  (1e16, 1.0)          1e16 + 1 is no double: the nearest one is 1e16, and 1 is missing
//!   two_product(a, b)   =  (a * b, what the rounding of a * b has cost)
//! ```
//!
//! Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997.

// You need not use every function that is given here.
#![allow(dead_code)]

/// The sum of two doubles as doubles have it, and what is missing: `sum + missing` is exactly `a + b`.
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// The product of two doubles as doubles have it, and what is missing: `product + missing` is exactly `a * b`.
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    // Multiplied and subtracted with one rounding; and what is left of the product is a double.
    (product, a.mul_add(b, -product))
}
