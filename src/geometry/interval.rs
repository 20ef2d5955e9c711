//! Numbers known up to rounding: a quick look before the exact one.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// All numbers from `low` to `high`; the true one is among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// The least and the greatest of some numbers; of none, bounds that hold nothing.
pub(crate) fn range(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

impl Interval {
    pub(crate) const fn of(a: f64) -> Self {
        Self { low: a, high: a }
    }

    /// From the smallest to the largest of the values, each of which may be off by one rounding.
    fn around(values: &[f64]) -> Self {
        let [low, high] = range(values.iter().copied());
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// The number, if it is known exactly.
    pub(crate) fn only(self) -> Option<f64> {
        (self.low >= self.high).then_some(self.low)
    }

    /// The sign, if it is certain.
    pub(crate) fn sign(self) -> Option<Ordering> {
        if self.low > 0.0 {
            Some(Ordering::Greater)
        } else if self.high < 0.0 {
            Some(Ordering::Less)
        } else if self.low == 0.0 && self.high == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// The order of the two numbers, if it is certain.
    pub(crate) fn order(self, other: Self) -> Option<Ordering> {
        if self.high < other.low {
            Some(Ordering::Less)
        } else if self.low > other.high {
            Some(Ordering::Greater)
        } else {
            (self.only().is_some() && self.low >= other.high && self.high <= other.low).then_some(Ordering::Equal)
        }
    }

    /// The quotient; `None` if the divisor may be 0.
    pub(crate) fn over(self, by: Self) -> Option<Self> {
        by.sign()?;
        let (a, b) = (self, by);
        Some(Self::around(&[a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high]))
    }

    /// The part within the limits, which hold the true number for another reason.
    pub(crate) fn within(self, a: f64, b: f64) -> Self {
        Self { low: self.low.max(a.min(b)), high: self.high.min(a.max(b)) }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { low: (self.low + other.low).next_down(), high: (self.high + other.high).next_up() }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { low: (self.low - other.high).next_down(), high: (self.high - other.low).next_up() }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self::around(&[a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high])
    }
}
