//! How a figure writes numbers: the same bytes everywhere.
//!
//! ```text
//!   drawn       620   409.2   76.92   0.5    two decimals, no trailing zeros, no "-0"
//!   in tiles    12.3  .6  -.1                tenths of a px, the shortest form a path allows
//!   of models   0.1   1e-9   6.25e30         the shortest decimal that reads back as the same f64
//! ```

/// A drawn number, rounded to two decimals.
pub(crate) fn drawn(value: f64) -> String {
    let mut out = String::new();
    push_decimal(&mut out, (value * 100.0).round() as i64, 100, true);
    out
}

/// Appends a number of tenths (`unit` 10) or hundredths (100) of a px without a leading zero.
pub(crate) fn push_short(out: &mut String, value: i64, unit: u64) {
    push_decimal(out, value, unit, false);
}

fn push_decimal(out: &mut String, value: i64, unit: u64, leading_zero: bool) {
    if value < 0 {
        out.push('-');
    }
    let (whole, mut part) = (value.unsigned_abs() / unit, value.unsigned_abs() % unit);
    if whole > 0 || leading_zero || part == 0 {
        push_integer(out, whole);
    }
    if part > 0 {
        out.push('.');
        let mut place = unit / 10;
        while part > 0 {
            push_digit(out, part / place);
            part %= place;
            place /= 10;
        }
    }
}

fn push_integer(out: &mut String, value: u64) {
    if value >= 10 {
        push_integer(out, value / 10);
    }
    push_digit(out, value % 10);
}

fn push_digit(out: &mut String, digit: u64) {
    out.push(char::from(b'0' + digit as u8));
}

/// A model coordinate: the shortest decimal that reads back as the same number; `-0` is written `0`.
pub(crate) fn model(value: f64) -> String {
    let text = format!("{:?}", if value == 0.0 { 0.0 } else { value });
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_numbers_are_short_and_have_no_negative_zero() {
        let cases = [
            (620.0, "620"),
            (409.2, "409.2"),
            (0.5, "0.5"),
            (-0.001, "0"),
            (0.3 - 0.1 - 0.2, "0"),
            (-0.5, "-0.5"),
            (76.919_999, "76.92"),
            (1.05, "1.05"),
            (100.0, "100"),
        ];
        for (value, text) in cases {
            assert_eq!(drawn(value), text, "{value}");
        }
    }

    #[test]
    fn tenths_drop_the_leading_zero() {
        for (tenths, text) in [(0, "0"), (6, ".6"), (-1, "-.1"), (123, "12.3"), (-100, "-10")] {
            let mut out = String::new();
            push_short(&mut out, tenths, 10);
            assert_eq!(out, text);
        }
    }

    #[test]
    fn model_numbers_read_back_exactly() {
        for value in [0.1 + 0.2, 1e-43, 6.25e30, 5.0, -3.5, 1e16] {
            let text = model(value);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
        }
        assert_eq!((model(-0.0), model(5.0)), ("0".to_owned(), "5".to_owned()));
    }
}
