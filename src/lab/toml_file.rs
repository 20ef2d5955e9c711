//! Files of a lab in TOML, with the place of what is wrong in them.

use serde::de::DeserializeOwned;
use std::fmt;

/// Why a manifest or a bug cannot be used. Prints as `source:line:column: what`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ManifestError {
    /// The file.
    pub source: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// What is wrong, and what to try.
    pub what: String,
}

impl fmt::Display for ManifestError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { source, line, column, what } = self;
        write!(f, "{source}:{line}:{column}: {what}")
    }
}

impl std::error::Error for ManifestError {}

/// A text that is TOML, and its name in messages.
#[derive(Clone, Copy)]
pub(super) struct TomlFile<'a> {
    pub(super) text: &'a str,
    pub(super) source: &'a str,
}

impl TomlFile<'_> {
    pub(super) fn read<T: DeserializeOwned>(&self) -> Result<T, ManifestError> {
        toml::from_str(self.text).map_err(|error| {
            let at = error.span().map_or(self.text.len(), |span| span.start);
            self.error(at, error.message().replace('\n', "; "))
        })
    }

    /// An error at a byte of the text. Messages are one line, whatever names are in them.
    pub(super) fn error(&self, at: usize, what: impl Into<String>) -> ManifestError {
        let before = self.text.get(..at).unwrap_or(self.text);
        let shown = |c: char| if c.is_control() { c.escape_debug().to_string() } else { c.to_string() };
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        ManifestError {
            source: self.source.to_owned(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            what: what.into().chars().map(shown).collect(),
        }
    }
}

/// A key as it is written: bare if it can be.
pub(super) fn key(name: &str) -> String {
    let is_bare = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-');
    if !name.is_empty() && name.bytes().all(is_bare) { name.to_owned() } else { quoted(name) }
}

/// A text in quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            c if c.is_control() => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_texts_are_read_back_as_they_were() {
        for (name, written) in [
            ("face_walk", "face_walk"),
            ("04-half-edge", "04-half-edge"),
            ("", "\"\""),
            ("a b", "\"a b\""),
            ("a.b", "\"a.b\""),
        ] {
            assert_eq!(key(name), written);
            let table: toml::Table = toml::from_str(&format!("{} = {}", key(name), quoted(name))).unwrap();
            assert_eq!(table.get(name).and_then(|text| text.as_str()), Some(name));
        }
        let odd = "\"\\\t\u{1}é";
        let table: toml::Table = toml::from_str(&format!("a = {}", quoted(odd))).unwrap();
        assert_eq!(table["a"].as_str(), Some(odd));
    }
}
