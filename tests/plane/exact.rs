//! Exact numbers for the tests, by other means than the kit's: doubles as whole numbers of one unit.

use dcel_kit::plane::Point;
use num_bigint::{BigInt, Sign};

/// The exponent of the last bit of a double; large for 0.
fn last_bit(x: f64) -> i32 {
    let bits = x.to_bits();
    let (exponent, mantissa) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    match (exponent, mantissa) {
        (0, 0) => i32::MAX,
        (0, m) => -1074 + m.trailing_zeros() as i32,
        (e, m) => e - 1075 + (m | 1 << 52).trailing_zeros() as i32,
    }
}

/// A unit of which all the numbers are whole multiples, as a power of two.
pub(crate) fn unit(numbers: impl IntoIterator<Item = f64>) -> i32 {
    numbers.into_iter().map(last_bit).min().unwrap_or(0).min(0)
}

/// The number in units of 2^`unit`.
pub(crate) fn whole(x: f64, unit: i32) -> BigInt {
    if x == 0.0 {
        return BigInt::ZERO;
    }
    let last = last_bit(x);
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let mantissa = if exponent == 0 { bits & ((1 << 52) - 1) } else { bits & ((1 << 52) - 1) | 1 << 52 };
    let mantissa = mantissa >> mantissa.trailing_zeros();
    let size = BigInt::from(mantissa) << usize::try_from(last - unit).expect("the unit fits");
    if x < 0.0 { -size } else { size }
}

/// A point in units.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Whole {
    pub(crate) x: BigInt,
    pub(crate) y: BigInt,
}

impl Whole {
    pub(crate) fn new(p: Point, unit: i32) -> Self {
        Self { x: whole(p.x, unit), y: whole(p.y, unit) }
    }
}

/// (b - a) x (c - a)
pub(crate) fn cross(a: &Whole, b: &Whole, c: &Whole) -> BigInt {
    (&b.x - &a.x) * (&c.y - &a.y) - (&b.y - &a.y) * (&c.x - &a.x)
}

/// (b - a) . (c - a)
pub(crate) fn dot(a: &Whole, b: &Whole, c: &Whole) -> BigInt {
    (&b.x - &a.x) * (&c.x - &a.x) + (&b.y - &a.y) * (&c.y - &a.y)
}

/// Whether p lies on the segment a-b, its ends included.
fn on([a, b]: [&Whole; 2], p: &Whole) -> bool {
    cross(a, b, p).sign() == Sign::NoSign && dot(p, a, b).sign() != Sign::Plus
}

/// Whether two segments meet anywhere but at ends that both have.
pub(crate) fn meet([a, b]: [&Whole; 2], [c, d]: [&Whole; 2]) -> bool {
    let sides = [cross(a, b, c), cross(a, b, d), cross(c, d, a), cross(c, d, b)].map(|n| n.sign());
    let opposite = |s: Sign, t: Sign| s != Sign::NoSign && s == -t;
    if opposite(sides[0], sides[1]) && opposite(sides[2], sides[3]) {
        return true;
    }
    let inside = |ends: [&Whole; 2], p: &Whole| on(ends, p) && ends[0] != p && ends[1] != p;
    let same = (a == c && b == d) || (a == d && b == c);
    same || inside([a, b], c) || inside([a, b], d) || inside([c, d], a) || inside([c, d], b)
}

/// Whether p is no further from the segment a-b than `far` units.
pub(crate) fn within([a, b]: [&Whole; 2], p: &Whole, far: &BigInt) -> bool {
    let square = |p: &Whole, q: &Whole| dot(p, q, q);
    let far = far * far;
    if dot(a, b, p).sign() == Sign::Minus {
        return square(a, p) <= far;
    }
    if dot(b, a, p).sign() == Sign::Minus {
        return square(b, p) <= far;
    }
    let turn = cross(a, b, p);
    &turn * &turn <= far * square(a, b)
}
