//! Axes: from values to places, and the round numbers along the way.
//!
//! ```text
//!   linear    0 ──┬── 20 ──┬── 40        steps of 1, 2 or 5 times a power of ten, about five of them
//!   log       1 ──── 10 ──── 100         whole powers of ten; 1, 2, 5 where there are few
//! ```
//!
//! Round numbers are made of integers and decimal exponents, never by adding up steps: 0.3 is 0.3.

use crate::figure::kinds::chart::log::log2;

/// One axis of a chart.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    pub(super) title: String,
    unit: Option<String>,
    pub(super) is_log: bool,
    range: Option<[f64; 2]>,
}

impl Axis {
    fn new(title: impl AsRef<str>, is_log: bool) -> Self {
        Self { title: crate::figure::canvas::text::clean(title.as_ref()), unit: None, is_log, range: None }
    }

    /// Equal differences, equal distances. It begins at 0 if the values are far from each other.
    pub fn linear(title: impl AsRef<str>) -> Self {
        Self::new(title, false)
    }

    /// Equal ratios, equal distances: powers are straight lines if both axes are like that. Values that are not
    /// positive have no place; they are noted.
    pub fn log(title: impl AsRef<str>) -> Self {
        Self::new(title, true)
    }

    /// The unit, written behind the title.
    #[must_use]
    pub fn unit(mut self, unit: impl AsRef<str>) -> Self {
        self.unit = Some(crate::figure::canvas::text::clean(unit.as_ref()));
        self
    }

    /// The least and the greatest value, instead of those of the points. Nonsense changes nothing.
    #[must_use]
    pub fn range(mut self, from: f64, to: f64) -> Self {
        let is_good = from.is_finite() && to.is_finite() && from < to && (!self.is_log || from > 0.0);
        self.range = is_good.then_some([from, to]);
        self
    }

    /// Title and unit.
    pub(super) fn words(&self) -> String {
        self.unit.as_ref().map_or_else(|| self.title.clone(), |unit| format!("{} ({unit})", self.title))
    }

    /// Whether a value has a place on it.
    pub(super) fn takes(&self, value: f64) -> bool {
        value.is_finite() && value.abs() < 1e290 && (!self.is_log || value > 1e-290)
    }

    /// Chooses what the axis shows of these values, which it all takes.
    pub(super) fn scale(&self, values: impl Iterator<Item = f64>) -> Option<Scale> {
        let least = values.fold(None, |range: Option<[f64; 2]>, v| {
            let [low, high] = range.unwrap_or([v, v]);
            Some([low.min(v), high.max(v)])
        });
        let [mut low, mut high] = self.range.or(least)?;
        let is_log = self.is_log;
        if self.range.is_none() {
            if is_log {
                low = round_below(low);
                high = round_above(high);
            } else {
                low = if low > 0.0 && low <= 0.4 * high { 0.0 } else { low };
            }
        }
        let size = low.abs().max(high.abs());
        if is_log && high / low < 1.001 {
            (low, high) = (0.5 * low, 2.0 * high);
        } else if !is_log && high - low <= 1e-9 * size {
            let half = if size > 0.0 { 0.1 * size } else { 1.0 };
            (low, high) = (low - half, high + half);
        }
        if self.range.is_none() && !is_log {
            // A wider range may ask for wider steps.
            for _ in 0..3 {
                let (step, exponent) = step(high - low);
                let unit = decimal(step, exponent);
                low = (low / unit + 1e-9).floor() * unit;
                high = (high / unit - 1e-9).ceil() * unit;
            }
        }
        Some(Scale { low, high, is_log })
    }
}

/// What an axis shows.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Scale {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) is_log: bool,
}

/// A round number.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Tick {
    pub(super) value: f64,
    /// Small ticks have none.
    pub(super) label: Option<String>,
}

impl Scale {
    /// Where a value lies: 0 at the low end, 1 at the high end.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        if self.is_log {
            let (low, high) = (log2(self.low)?, log2(self.high)?);
            Some((log2(value)? - low) / (high - low))
        } else {
            Some((value - self.low) / (self.high - self.low))
        }
    }

    /// The value in the middle of two, as seen.
    fn middle(&self, a: f64, b: f64) -> f64 {
        if self.is_log { a.sqrt() * b.sqrt() } else { 0.5 * a + 0.5 * b }
    }

    /// Values from end to end, equally far from each other as seen.
    pub(super) fn values(&self) -> Vec<f64> {
        let mut out = vec![self.low, self.high];
        for _ in 0..6 {
            let mut finer = vec![out[0]];
            for w in out.windows(2) {
                finer.extend([self.middle(w[0], w[1]), w[1]]);
            }
            out = finer;
        }
        out
    }

    /// The round numbers from end to end.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        if self.is_log && self.high / self.low >= 3.0 { self.decade_ticks() } else { self.linear_ticks() }
    }

    fn linear_ticks(&self) -> Vec<Tick> {
        let (step, exponent) = step(self.high - self.low);
        let unit = decimal(step, exponent);
        let first = (self.low / unit - 1e-6).ceil() as i64;
        let last = (self.high / unit + 1e-6).floor() as i64;
        let greatest = self.low.abs().max(self.high.abs());
        let plain = greatest < 1e7 && exponent >= -5;
        let tick = |k: i64| {
            let digits = k * step;
            let label = if plain { plainly(digits, exponent) } else { scientifically(digits, exponent) };
            Tick { value: decimal(digits, exponent), label: Some(label) }
        };
        (first..=last.min(first + 50)).map(tick).collect()
    }

    fn decade_ticks(&self) -> Vec<Tick> {
        let (from, to) = (exponent(self.low), exponent(self.high));
        let decades = to - from;
        let every = (decades / 8 + 1).max(1);
        let plain = from >= -3 && to <= 4;
        let mut out = Vec::new();
        for e in from..=to {
            for digit in 1..=9i64 {
                let value = decimal(digit, e);
                if value < self.low * (1.0 - 1e-9) || value > self.high * (1.0 + 1e-9) {
                    continue;
                }
                let labelled = match decades {
                    0 | 1 => [1, 2, 5].contains(&digit),
                    _ => digit == 1 && (e - from) % every == 0,
                };
                let label = labelled.then(|| if plain { plainly(digit, e) } else { scientifically(digit, e) });
                if labelled || decades <= 5 || digit == 1 {
                    out.push(Tick { value, label });
                }
            }
        }
        out
    }
}

/// `digits · 10^exponent`, correctly rounded.
fn decimal(digits: i64, exponent: i32) -> f64 {
    format!("{digits}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// The power of ten at or below a positive number, from its shortest decimal.
fn exponent(value: f64) -> i32 {
    let text = format!("{value:e}");
    text.rsplit('e').next().and_then(|e| e.parse().ok()).unwrap_or(0)
}

/// About a fifth of a span as 1, 2 or 5 times a power of ten.
fn step(span: f64) -> (i64, i32) {
    let raw = span / 5.5;
    let e = exponent(raw);
    match raw / decimal(1, e) {
        m if m <= 1.2 => (1, e),
        m if m <= 2.4 => (2, e),
        m if m <= 6.0 => (5, e),
        _ => (1, e + 1),
    }
}

/// The next 1, 2 or 5 times a power of ten that is not above (not below) a value.
fn round_below(value: f64) -> f64 {
    let e = exponent(value);
    let fits = |digit: &i64| decimal(*digit, e) <= value;
    [5, 2].into_iter().find(fits).map_or_else(|| decimal(1, e), |digit| decimal(digit, e))
}

fn round_above(value: f64) -> f64 {
    let e = exponent(value);
    let fits = |digit: &i64| decimal(*digit, e) >= value;
    [1, 2, 5].into_iter().find(fits).map_or_else(|| decimal(1, e + 1), |digit| decimal(digit, e))
}

/// `-12,500` or `0.25`.
fn plainly(digits: i64, exponent: i32) -> String {
    let sign = if digits < 0 { "-" } else { "" };
    let mut text = digits.unsigned_abs().to_string();
    if digits == 0 {
        return text;
    }
    if exponent >= 0 {
        text.push_str(&"0".repeat(exponent as usize));
        for at in (1..text.len()).rev().filter(|at| (text.len() - at).is_multiple_of(3)).collect::<Vec<_>>() {
            text.insert(at, ',');
        }
        return format!("{sign}{text}");
    }
    let places = exponent.unsigned_abs() as usize;
    let text = format!("{text:0>width$}", width = places + 1);
    let (whole, part) = text.split_at(text.len() - places);
    let part = part.trim_end_matches('0');
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

/// `10⁵` or `2.5·10⁻³`.
fn scientifically(digits: i64, exponent: i32) -> String {
    if digits == 0 {
        return "0".to_owned();
    }
    let all = digits.unsigned_abs().to_string();
    let e = exponent + all.len() as i32 - 1;
    let part = all[1..].trim_end_matches('0');
    let mantissa = if part.is_empty() { all[..1].to_owned() } else { format!("{}.{part}", &all[..1]) };
    let sign = if digits < 0 { "-" } else { "" };
    let raised: String = e.to_string().chars().map(superscript).collect();
    match (mantissa.as_str(), e) {
        (_, 0) => format!("{sign}{mantissa}"),
        ("1", _) => format!("{sign}10{raised}"),
        _ => format!("{sign}{mantissa}·10{raised}"),
    }
}

fn superscript(c: char) -> char {
    match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, values: &[f64]) -> Vec<String> {
        let scale = axis.scale(values.iter().copied()).unwrap();
        scale.ticks().into_iter().filter_map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_as_many_as_one_can_read() {
        let linear = Axis::linear("x");
        assert_eq!(labels(&linear, &[0.0, 0.31]), ["0", "0.1", "0.2", "0.3", "0.4"]);
        assert_eq!(labels(&linear, &[3.0, 24_800.0]), ["0", "5,000", "10,000", "15,000", "20,000", "25,000"]);
        assert_eq!(labels(&linear, &[-2.0, 2.0]), ["-2", "-1", "0", "1", "2"]);
        assert_eq!(labels(&linear, &[1e9, 4e9]), ["0", "10⁹", "2·10⁹", "3·10⁹", "4·10⁹"]);
        for (low, high) in [(0.0, 1.0), (1e-12, 3e-12), (-7.0, 1e6), (1e15, 1e15 + 8.0), (5.0, 5.0), (0.0, 0.0)] {
            let labels = labels(&linear, &[low, high]);
            assert!((3..=9).contains(&labels.len()), "{low} to {high}: {labels:?}");
            let mut distinct = labels.clone();
            distinct.dedup();
            assert_eq!(distinct, labels);
        }
    }

    #[test]
    fn log_ticks_are_powers_of_ten_or_few_of_their_multiples() {
        let log = Axis::log("n");
        assert_eq!(labels(&log, &[3.0, 700.0]), ["10", "100", "1,000"]);
        assert_eq!(labels(&log, &[1e4, 1e7]), ["10⁴", "10⁵", "10⁶", "10⁷"]);
        assert_eq!(labels(&log, &[20.0, 90.0]), ["20", "50", "100"]);
        assert_eq!(labels(&log, &[1.0, 1.0]), ["0.5", "1", "2"]);
        assert!(labels(&log, &[1e-200, 1e200]).len() <= 10);
        assert_eq!(labels(&log, &[0.9, 0.99]), ["0.5", "0.6", "0.7", "0.8", "0.9", "1"]);
    }

    #[test]
    fn equal_ratios_have_equal_distances() {
        let scale = Axis::log("n").scale([1.0, 1e6].into_iter()).unwrap();
        for (k, value) in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6].into_iter().enumerate() {
            assert!((scale.place(value).unwrap() - k as f64 / 6.0).abs() < 1e-15, "{value}");
        }
        let values = scale.values();
        assert_eq!(values.len(), 65);
        assert!(values.windows(2).all(|w| (w[1] / w[0] - 1.240_937_760_751_72).abs() < 1e-9), "{values:?}");
    }

    #[test]
    fn ranges_of_the_caller_are_kept() {
        let scale = Axis::linear("x").range(0.2, 1.1).scale([5.0].into_iter()).unwrap();
        assert_eq!([scale.low, scale.high].map(f64::to_bits), [0.2f64, 1.1].map(f64::to_bits));
        assert!(Axis::log("x").range(-1.0, 1.0).scale([5.0].into_iter()).unwrap().low > 0.0);
    }
}
