//! Numbers of the command line, and numbers that messages propose.

pub(super) use crate::choice::number;

/// A number with few digits that is no less.
pub(super) fn above(x: f64) -> f64 {
    let step = 10f64.powf(x.abs().max(f64::MIN_POSITIVE).log10().floor() - 1.0);
    let rounded = format!("{:.1e}", (x / step).ceil() * step).parse().unwrap_or(x);
    if rounded >= x && f64::is_finite(rounded) { rounded } else { x }
}
