//! A style as a JSON file: the fields of [`Style`] by their names, only those that differ from the default.
//!
//! ```json
//! { "light": { "half_edge": "#0067a5" }, "dark": null, "tints": ["#0072b2", "#e69f00"], "edge_width": 2 }
//! ```

use crate::figure::canvas::style::{Colour, Palette, Style};
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::str::FromStr;

/// The text is not a style.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {what}")]
pub struct StyleError {
    /// Line of the text, from 1.
    pub line: usize,
    /// Column of the text, from 1.
    pub column: usize,
    /// What is wrong there.
    pub what: String,
}

/// The text is not a colour.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a colour: write # and six hexadecimal digits, for example #0067a5")]
pub struct ParseColourError {
    text: String,
}

impl FromStr for Colour {
    type Err = ParseColourError;

    /// Reads `#rrggbb` or `#rgb`.
    fn from_str(text: &str) -> Result<Self, ParseColourError> {
        let error = || ParseColourError { text: text.to_owned() };
        let digits = text.strip_prefix('#').filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit())).ok_or_else(error)?;
        let value = u32::from_str_radix(digits, 16).map_err(|_| error())?;
        match digits.len() {
            6 => Ok(Self(value)),
            3 => Ok(Self([8, 4, 0].into_iter().fold(0, |sum, shift| (sum << 8) + 17 * (value >> shift & 15)))),
            _ => Err(error()),
        }
    }
}

impl<'de> Deserialize<'de> for Colour {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

/// The fields of a palette that a file changes, from the names of its colours.
macro_rules! palette_file {
    ($($colour:ident)*) => {
        #[derive(Deserialize, Default)]
        #[serde(default, deny_unknown_fields)]
        struct PaletteFile {
            $($colour: Option<Colour>,)*
            tint_opacity: Option<f64>,
        }

        impl PaletteFile {
            fn change(self, usual: &Palette) -> Palette {
                Palette {
                    $($colour: self.$colour.unwrap_or(usual.$colour),)*
                    tint_opacity: self.tint_opacity.unwrap_or(usual.tint_opacity),
                }
            }
        }
    };
}
palette_file!(background ink half_edge edge face hatch next twin origin wrong dim grey hit);

/// The default light palette with the changes of the file.
pub(crate) fn light<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Palette, D::Error> {
    Ok(PaletteFile::deserialize(deserializer)?.change(&Style::default().light))
}

/// The default dark palette with the changes of the file; `null`: none.
pub(crate) fn dark<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Palette>, D::Error> {
    let file = Option::<PaletteFile>::deserialize(deserializer)?;
    Ok(file.and_then(|file| Some(file.change(Style::default().dark.as_ref()?))))
}

/// One to seven tints; fewer than seven are repeated.
pub(crate) fn tints<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[Colour; 7], D::Error> {
    let given = Vec::<Colour>::deserialize(deserializer)?;
    match given.len() {
        1..=7 => Ok(std::array::from_fn(|i| given[i % given.len()])),
        other => Err(D::Error::custom(format!("{other} tints: write 1 to 7 colours"))),
    }
}

impl Style {
    /// Reads a style from JSON. The keys are the names of the fields of [`Style`] and, in `light` and `dark`, of
    /// [`Palette`]; what is not named keeps its default. Colours are `"#rrggbb"` or `"#rgb"`, `"dark": null`
    /// means light only, `tints` is a list of one to seven colours. Numbers out of range are drawn as the nearest
    /// that can be drawn.
    ///
    /// # Errors
    /// [`StyleError`] with line and column: no JSON, an unknown key, a wrong type, a wrong colour.
    ///
    /// ```
    /// # use dcel_kit::figure::{Colour, Style};
    /// let style = Style::from_json(r##"{ "light": { "ink": "#333" }, "edge_width": 2 }"##)?;
    /// assert_eq!((style.light.ink, style.edge_width), (Colour(0x333333), 2.0));
    /// let error = Style::from_json("{ \"ink\": 1 }").unwrap_err();
    /// assert!(error.to_string().starts_with("1:7: unknown field `ink`"));
    /// # Ok::<(), dcel_kit::figure::StyleError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, StyleError> {
        serde_json::from_str(text).map_err(|error| {
            let what = error.to_string();
            let place = format!(" at line {} column {}", error.line(), error.column());
            let what = what.strip_suffix(&place).unwrap_or(&what).to_owned();
            StyleError { line: error.line(), column: error.column(), what }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_the_file_names_changes() {
        let text = r##"{"dark": {"edge": "#abc"}, "tints": ["#111111", "#222222"], "font": "Arial"}"##;
        let style = Style::from_json(text).unwrap();
        let usual = Style::default();
        let dark = style.dark.unwrap();
        assert_eq!(dark.edge, Colour(0x00aa_bbcc));
        assert_eq!(dark.ink, usual.dark.as_ref().unwrap().ink);
        assert_eq!(style.light, usual.light);
        assert_eq!(style.tints.map(|t| t.0 & 0xff), [0x11, 0x22, 0x11, 0x22, 0x11, 0x22, 0x11]);
        assert_eq!(style.font, "Arial");
        assert_eq!(Style::from_json(r#"{"dark": null}"#).unwrap().dark, None);
        assert_eq!(Style::from_json("{}").unwrap(), usual);
    }

    #[test]
    fn errors_name_the_place() {
        for (text, line, part) in [
            ("{\n \"light\": { \"inc\": \"#000\" } }", 2, "unknown field `inc`"),
            ("{\n\n \"offset\": \"wide\" }", 3, "invalid type"),
            ("{ \"light\": { \"ink\": \"red\" } }", 1, "`red` is not a colour"),
            ("{ \"light\": { \"ink\": \"#12\" } }", 1, "`#12` is not a colour"),
            ("{ \"tints\": [] }", 1, "0 tints"),
            ("", 1, "EOF"),
        ] {
            let error = Style::from_json(text).unwrap_err();
            assert_eq!(error.line, line, "{text}: {error}");
            assert!(error.what.contains(part), "{text}: {error}");
            assert!(!error.what.contains("at line"), "{error}");
        }
    }
}
