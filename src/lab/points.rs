//! Points, and shares of points: fractions that add up exactly.
//!
//! ```text
//!   8    7.5    20/3    10 %          read
//!   8    7.5    6.667                 shown, with three digits at most
//! ```
//!
//! Points are counted in small units, of which every half, third, quarter ... up to the sixteenth and every thousandth
//! is a whole number. So three tests of 20/3 points are 20 points, and not 19.999.

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::iter::Sum;
use std::ops::{Add, Neg, Sub};
use std::str::FromStr;

/// A number of points, or a share of them; may be negative.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Points(i64);

/// How many units a point is: a multiple of 1000, of 16 and of all numbers below it.
const UNIT: i64 = 18_018_000;
/// More points than any course has; sums of them do not overflow.
const MOST: i64 = 1_000_000;

impl Points {
    /// No points.
    pub const ZERO: Self = Self(0);

    /// This share of the points, to the nearest unit: the tenth of 7.5 points is 0.75 points.
    #[must_use]
    pub fn share(self, share: Self) -> Self {
        let product = i128::from(self.0) * i128::from(share.0);
        let rounded = (2 * product + i128::from(UNIT)).div_euclid(2 * i128::from(UNIT));
        Self(i64::try_from(rounded).unwrap_or(i64::MAX))
    }

    /// So many of so many equal parts, to the nearest unit; nothing if there are no parts.
    #[must_use]
    pub fn part(self, some: usize, of: usize) -> Self {
        if of == 0 {
            return Self::ZERO;
        }
        let (some, of) = (some as i128, of as i128);
        Self(i64::try_from((2 * i128::from(self.0) * some + of).div_euclid(2 * of)).unwrap_or(i64::MAX))
    }

    /// As many times.
    #[must_use]
    pub fn times(self, count: u32) -> Self {
        Self(self.0.saturating_mul(i64::from(count)))
    }

    /// The nearest number.
    #[must_use]
    pub fn as_f64(self) -> f64 {
        self.0 as f64 / UNIT as f64
    }

    /// The nearest whole number of points, a half upwards.
    #[must_use]
    pub fn rounded(self) -> i64 {
        (2 * self.0 + UNIT).div_euclid(2 * UNIT)
    }

    /// The number of points, if it is a whole one.
    #[must_use]
    pub fn whole(self) -> Option<i64> {
        (self.0 % UNIT == 0).then_some(self.0 / UNIT)
    }

    /// As it is written in a file, exactly.
    #[cfg(feature = "grade")]
    pub(crate) fn written(self) -> String {
        serde_json::to_string(&self).unwrap_or_default()
    }

    /// In thousandths, if it is a whole number of them.
    fn thousandths(self) -> Option<i64> {
        (self.0 % (UNIT / 1000) == 0).then_some(self.0 / (UNIT / 1000))
    }

    fn of_fraction(above: i64, below: i64) -> Option<Self> {
        let in_range = above.abs() <= MOST && (1..=MOST).contains(&below);
        (in_range && above * UNIT % below == 0).then(|| Self(above * UNIT / below))
    }

    fn of_decimal(text: &str) -> Option<Self> {
        let (sign, digits) = text.strip_prefix('-').map_or((1, text), |digits| (-1, digits));
        let digits = digits.strip_prefix('+').unwrap_or(digits);
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let is_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
        let part = part.trim_end_matches('0');
        if whole.is_empty() || !is_digits(whole) || !is_digits(part) || part.len() > 3 {
            return None;
        }
        let thousandths: i64 = format!("{whole}{part:0<3}").parse().ok()?;
        (thousandths <= MOST * 1000).then(|| Self(sign * thousandths * (UNIT / 1000)))
    }
}

impl FromStr for Points {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let trimmed = text.trim();
        let number = |text: &str| text.trim().parse::<i64>().ok();
        let found = if let Some((above, below)) = trimmed.split_once('/') {
            number(above).zip(number(below)).and_then(|(above, below)| Self::of_fraction(above, below))
        } else if let Some(percent) = trimmed.strip_suffix('%') {
            // Percents have one digit more before they are too fine.
            Self::of_decimal(percent.trim()).filter(|points| points.0 % 100 == 0).map(|points| Self(points.0 / 100))
        } else {
            Self::of_decimal(trimmed)
        };
        found.ok_or_else(|| {
            format!("{text:?} are no points; write 8, 7.5, \"20/3\" or \"10 %\": three digits or sixteenths at most")
        })
    }
}

impl fmt::Display for Points {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // To the nearest thousandth, away from zero in the middle.
        let thousandths = (2 * self.0.unsigned_abs() + UNIT as u64 / 1000) / (2 * UNIT as u64 / 1000);
        let mut text = format!("{}.{:03}", thousandths / 1000, thousandths % 1000);
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
        f.pad_integral(self.0 >= 0 || thousandths == 0, "", &text)
    }
}

impl fmt::Debug for Points {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} points")
    }
}

impl From<u32> for Points {
    fn from(points: u32) -> Self {
        Self(i64::from(points) * UNIT)
    }
}

impl From<i32> for Points {
    fn from(points: i32) -> Self {
        Self(i64::from(points) * UNIT)
    }
}

/// Whole points may be compared with plain numbers.
impl PartialEq<i32> for Points {
    fn eq(&self, points: &i32) -> bool {
        *self == Self::from(*points)
    }
}

impl Add for Points {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Points {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Neg for Points {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Sum for Points {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::ZERO, Add::add)
    }
}

/// A number where that is exact, else a text such as `"20/3"`.
impl Serialize for Points {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.thousandths() {
            Some(thousandths) if thousandths % 1000 == 0 => serializer.serialize_i64(thousandths / 1000),
            Some(_) => serializer.serialize_f64(self.as_f64()),
            None => {
                let common = greatest_common_divisor(self.0.unsigned_abs(), UNIT as u64) as i64;
                serializer.collect_str(&format_args!("{}/{}", self.0 / common, UNIT / common))
            }
        }
    }
}

fn greatest_common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

impl<'de> Deserialize<'de> for Points {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Reader)
    }
}

struct Reader;

impl Visitor<'_> for Reader {
    type Value = Points;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("points: 8, 7.5, \"20/3\" or \"10 %\"")
    }

    fn visit_i64<E: Error>(self, points: i64) -> Result<Points, E> {
        points.to_string().parse().map_err(E::custom)
    }

    fn visit_u64<E: Error>(self, points: u64) -> Result<Points, E> {
        points.to_string().parse().map_err(E::custom)
    }

    fn visit_f64<E: Error>(self, points: f64) -> Result<Points, E> {
        points.to_string().parse().map_err(E::custom)
    }

    fn visit_str<E: Error>(self, points: &str) -> Result<Points, E> {
        // Shares are rounded to a unit, and written down as they are: these are read back.
        let fraction = points.split_once('/').and_then(|(a, b)| Some((a.parse::<i64>().ok()?, b.parse::<i64>().ok()?)));
        match fraction.filter(|(above, below)| *below > 0 && UNIT % below == 0 && above.abs() / below <= MOST) {
            Some((above, below)) => Ok(Points(above * (UNIT / below))),
            None => points.parse().map_err(E::custom),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Points {
        text.parse().unwrap()
    }

    #[test]
    fn fractions_add_up_exactly() {
        let third = points("20/3");
        assert_eq!(third + third + third, Points::from(20));
        assert_eq!(points("7.5"), points("15/2"));
        assert_eq!(points("10 %").times(10), Points::from(1));
        assert_eq!(points("0.1").times(3), points("0.3"));
        assert_eq!([third, third].into_iter().sum::<Points>() - third, third);
        assert!((1..=16).all(|n| points(&format!("1/{n}")).times(n) == Points::from(1)));
    }

    #[test]
    fn a_share_is_exact_where_it_can_be_and_else_rounded() {
        assert_eq!(points("7.5").share(points("10 %")), points("0.75"));
        assert_eq!(points("62").share(points("1/3")), points("62/3"));
        assert_eq!((-points("62")).share(points("1/3")), -points("62/3"));
        assert_eq!((points("6").part(1, 4), points("6").part(3, 0)), (points("1.5"), Points::ZERO));
        // A thousandth of a thousandth of a point is no whole number of units.
        let tiny = points("0.001").share(points("0.001"));
        assert!((tiny.as_f64() - 1e-6).abs() < 1.0 / UNIT as f64, "{tiny:?}");
    }

    #[test]
    fn whole_numbers_of_points_are_known() {
        let whole = ["8", "-3", "0", "7.5", "20/3"].map(|text| points(text).whole());
        assert_eq!(whole, [Some(8), Some(-3), Some(0), None, None]);
    }

    #[test]
    fn what_is_no_number_of_points_is_refused() {
        for wrong in ["", "x", "1/0", "1/17", "1.2345", "1e3", "NaN", "1/-2", "--1", "9999999", "1/2/3", "%", "0.001 %"]
        {
            let error = wrong.parse::<Points>().unwrap_err();
            assert!(error.contains("write 8, 7.5"), "{wrong}: {error}");
        }
    }

    #[test]
    fn they_are_shown_with_three_digits_and_kept_exactly() {
        for (text, shown, kept) in [
            ("8", "8", "8"),
            ("-7.5", "-7.5", "-7.5"),
            ("20/3", "6.667", "\"20/3\""),
            ("-20/3", "-6.667", "\"-20/3\""),
            ("0.001", "0.001", "0.001"),
            ("100.000", "100", "100"),
        ] {
            let value = points(text);
            assert_eq!(value.to_string(), shown);
            assert_eq!(serde_json::to_string(&value).unwrap(), kept);
            assert_eq!(serde_json::from_str::<Points>(kept).unwrap(), value);
        }
        let odd = points("0.007").share(points("1/13")).share(points("1/11"));
        assert_eq!(serde_json::from_str::<Points>(&serde_json::to_string(&odd).unwrap()).unwrap(), odd);
        assert_eq!(format!("{:+} {:>5}", Points::from(3), points("2.5")), "+3   2.5");
        assert_eq!((points("2.5").rounded(), points("-2.5").rounded(), points("2.499").rounded()), (3, -2, 2));
    }
}
