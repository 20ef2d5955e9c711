//! Numbers with their words.

/// A distance that is not exceeded, with three digits: rounded up.
///
/// ```
/// use dcel_kit::io::at_most;
/// assert_eq!([1.231e-16, 1.23e-16, 0.0].map(at_most), ["1.24e-16", "1.23e-16", "0.00e0"]);
/// ```
#[must_use]
pub fn at_most(distance: f64) -> String {
    let nearest = format!("{distance:.2e}");
    if nearest.parse().is_ok_and(|written: f64| written >= distance) {
        return nearest;
    }
    // Half a unit of the last digit more, so that it is the next one.
    let unit: f64 = nearest
        .split_once('e')
        .and_then(|(_, e)| format!("0.5e{}", e.parse::<i32>().ok()? - 2).parse().ok())
        .unwrap_or(0.0);
    format!("{:.2e}", distance + unit)
}

/// `1 face`, `3 faces`: a count with the word that fits it.
///
/// ```
/// use dcel_kit::io::counted;
/// assert_eq!(counted(1, "vertex", "vertices"), "1 vertex");
/// assert_eq!(counted(0, "vertex", "vertices"), "0 vertices");
/// ```
#[must_use]
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Notes how many of something there are, and what is to say of them, if there are any.
pub(super) fn note(notes: &mut Vec<String>, count: usize, one: &str, many: &str, rest: &str) {
    if count > 0 {
        notes.push(counted(count, one, many) + rest);
    }
}
