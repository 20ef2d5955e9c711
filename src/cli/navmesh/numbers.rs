//! Numbers of the command line, and numbers that messages propose.

/// A number of the command line.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let finite = text.parse().ok().filter(|x: &f64| x.is_finite());
    finite.ok_or_else(|| "this is no finite number: write it like 1.5".to_owned())
}

/// A number with few digits that is no less.
pub(super) fn above(x: f64) -> f64 {
    let step = 10f64.powf(x.abs().max(f64::MIN_POSITIVE).log10().floor() - 1.0);
    let rounded = format!("{:.1e}", (x / step).ceil() * step).parse().unwrap_or(x);
    if rounded >= x && f64::is_finite(rounded) { rounded } else { x }
}
