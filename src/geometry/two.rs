//! Two doubles at once: the same formula for both coordinates of a point, in the time of one.
//!
//! ```text
//!   x  =  a.x + b.x        one instruction of the processor adds both;
//!   y  =  a.y + b.y        each result is, to the last bit, what it would be by itself
//! ```

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A double, or two of them: what formulas without a branch are written for.
pub(crate) trait Doubles:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// An answer for each.
    type Answers: Copy;

    /// The same number in each place.
    fn all(x: f64) -> Self;

    /// Without signs.
    fn abs(self) -> Self;

    /// Which of them are 0.
    fn are_zero(self) -> Self::Answers;

    /// Where both answers are yes.
    fn both(a: Self::Answers, b: Self::Answers) -> Self::Answers;

    /// The numbers of `yes` where the answer is yes, of `no` elsewhere.
    fn choose(answers: Self::Answers, yes: Self, no: Self) -> Self;
}

impl Doubles for f64 {
    type Answers = bool;

    #[inline(always)]
    fn all(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn are_zero(self) -> bool {
        self == 0.0
    }

    #[inline(always)]
    fn both(a: bool, b: bool) -> bool {
        a & b
    }

    #[inline(always)]
    fn choose(answers: bool, yes: Self, no: Self) -> Self {
        if answers { yes } else { no }
    }
}

/// Two doubles.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Two(pub(crate) [f64; 2]);

impl Doubles for Two {
    type Answers = [bool; 2];

    #[inline(always)]
    fn all(x: f64) -> Self {
        Self([x; 2])
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(from_fn(|i| self.0[i].abs()))
    }

    #[inline(always)]
    fn are_zero(self) -> [bool; 2] {
        from_fn(|i| self.0[i] == 0.0)
    }

    #[inline(always)]
    fn both(a: [bool; 2], b: [bool; 2]) -> [bool; 2] {
        from_fn(|i| a[i] & b[i])
    }

    #[inline(always)]
    fn choose(answers: [bool; 2], yes: Self, no: Self) -> Self {
        Self(from_fn(|i| if answers[i] { yes.0[i] } else { no.0[i] }))
    }
}

impl Neg for Two {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(from_fn(|i| -self.0[i]))
    }
}

macro_rules! by_place {
    ($($trait:ident $of:ident $sign:tt)+) => {$(
        impl $trait for Two {
            type Output = Self;

            #[inline(always)]
            fn $of(self, other: Self) -> Self {
                Self(from_fn(|i| self.0[i] $sign other.0[i]))
            }
        }
    )+};
}
by_place! { Add add + Sub sub - Mul mul * Div div / }
