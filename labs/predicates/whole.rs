//! Whole numbers of any length, with a sign: as many as it takes to add, subtract and multiply without rounding.

use std::cmp::Ordering;

/// A whole number.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Whole {
    negative: bool,
    /// Its digits to the base 2^32, the lowest first; the last one is not 0.
    digits: Vec<u32>,
}

/// A double is m times 2 to the power p, with a whole number m below 2^53: this is p.
pub(super) fn power(x: f64) -> i32 {
    let field = (x.to_bits() >> 52 & 0x7ff) as i32;
    field.max(1) - 1075
}

impl Whole {
    /// x divided by 2 to the power `lowest`, which is at most the power of x.
    pub(super) fn scaled(x: f64, lowest: i32) -> Self {
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let m = if bits >> 52 & 0x7ff == 0 { fraction } else { fraction | 1 << 52 };
        if m == 0 {
            return Self::of(false, Vec::new());
        }
        let shift = (power(x) - lowest) as usize;
        let mut digits = vec![0; shift / 32];
        let mut rest = u128::from(m) << (shift % 32);
        while rest > 0 {
            digits.push(rest as u32);
            rest >>= 32;
        }
        Self::of(x < 0.0, digits)
    }

    fn of(negative: bool, mut digits: Vec<u32>) -> Self {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Self { negative: negative && !digits.is_empty(), digits }
    }

    /// 1, 0 or -1.
    pub(super) fn sign(&self) -> i32 {
        match (self.digits.is_empty(), self.negative) {
            (true, _) => 0,
            (_, true) => -1,
            _ => 1,
        }
    }

    /// The sum.
    pub(super) fn plus(&self, other: &Self) -> Self {
        if self.negative == other.negative {
            return Self::of(self.negative, sum(&self.digits, &other.digits));
        }
        match compare(&self.digits, &other.digits) {
            Ordering::Less => Self::of(other.negative, difference(&other.digits, &self.digits)),
            _ => Self::of(self.negative, difference(&self.digits, &other.digits)),
        }
    }

    /// The difference.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&Self::of(!other.negative, other.digits.clone()))
    }

    /// The product, digit by digit as on paper.
    pub(super) fn times(&self, other: &Self) -> Self {
        let mut digits = vec![0_u32; self.digits.len() + other.digits.len()];
        for (i, &a) in self.digits.iter().enumerate() {
            let mut carry = 0_u64;
            for (j, &b) in other.digits.iter().enumerate() {
                carry += u64::from(a) * u64::from(b) + u64::from(digits[i + j]);
                digits[i + j] = carry as u32;
                carry >>= 32;
            }
            digits[i + other.digits.len()] = carry as u32;
        }
        Self::of(self.negative != other.negative, digits)
    }
}

fn compare(a: &[u32], b: &[u32]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

fn sum(a: &[u32], b: &[u32]) -> Vec<u32> {
    let mut digits = Vec::with_capacity(a.len().max(b.len()) + 1);
    let mut carry = 0_u64;
    for i in 0..a.len().max(b.len()) {
        carry += u64::from(a.get(i).copied().unwrap_or(0)) + u64::from(b.get(i).copied().unwrap_or(0));
        digits.push(carry as u32);
        carry >>= 32;
    }
    digits.push(carry as u32);
    digits
}

/// a - b, where b is not above a.
fn difference(a: &[u32], b: &[u32]) -> Vec<u32> {
    let mut borrow = 0_i64;
    let mut digits = Vec::with_capacity(a.len());
    for (i, &digit) in a.iter().enumerate() {
        let left = i64::from(digit) - i64::from(b.get(i).copied().unwrap_or(0)) + borrow;
        digits.push(left as u32);
        borrow = left >> 32;
    }
    digits
}
