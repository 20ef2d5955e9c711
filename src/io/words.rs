//! Numbers with their words.

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
