//! Paths as they are typed in a terminal.

use std::path::Path;

/// The path as one word of a command line: in quotes if it needs them.
///
/// ```
/// use std::path::Path;
/// assert_eq!(dcel_lab::typed(Path::new("my-lab")), "my-lab");
/// # #[cfg(unix)]
/// assert_eq!(dcel_lab::typed(Path::new("my lab's")), r"'my lab'\''s'");
/// ```
#[must_use]
pub fn typed(path: &Path) -> String {
    word(&path.to_string_lossy())
}

/// A text as one word of a command line.
pub(crate) fn word(text: &str) -> String {
    // What every shell takes as it stands; a word that begins with `-` or `~` would mean something else.
    let plain = |c: char| c.is_alphanumeric() || "/._-+=:,@%".contains(c) || (cfg!(windows) && c == '\\');
    if !text.is_empty() && !text.starts_with('-') && text.chars().all(plain) {
        text.to_owned()
    } else if cfg!(windows) {
        // No name of a file holds a quote there.
        format!("\"{text}\"")
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}
