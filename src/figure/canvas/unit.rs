//! Lengths of paper: a figure of 12 cm is laid out like one of 453.5 px, and says 12 cm.

use crate::figure::canvas::number::drawn;
use std::str::FromStr;

/// The unit of the width and the height that a file states.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum Unit {
    /// CSS px, 96 of them an inch.
    #[default]
    Px,
    /// Millimetres.
    Mm,
    /// Centimetres.
    Cm,
}

/// The text is not a length.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a length: write a number of px, or one with mm or cm, for example 800, 120mm or 12cm")]
pub struct ParseLengthError {
    text: String,
}

impl Unit {
    /// How many px one unit has.
    #[must_use]
    pub const fn px(self) -> f64 {
        match self {
            Self::Px => 1.0,
            Self::Mm => 96.0 / 25.4,
            Self::Cm => 96.0 / 2.54,
        }
    }

    /// Reads a length: `800`, `800px`, `120mm`, `12cm`. The number is in px.
    ///
    /// # Errors
    /// [`ParseLengthError`].
    ///
    /// ```
    /// # use dcel_kit::figure::Unit;
    /// assert_eq!(Unit::parse_length("2.54cm")?, (96.0, Unit::Cm));
    /// assert!(Unit::parse_length("12 inches").is_err());
    /// # Ok::<(), dcel_kit::figure::ParseLengthError>(())
    /// ```
    pub fn parse_length(text: &str) -> Result<(f64, Self), ParseLengthError> {
        let ends = [("px", Self::Px), ("mm", Self::Mm), ("cm", Self::Cm)];
        let split = ends.into_iter().find_map(|(end, unit)| Some((text.strip_suffix(end)?, unit)));
        let (number, unit) = split.unwrap_or((text, Self::Px));
        let px = f64::from_str(number.trim_end()).ok().map(|value| value * unit.px());
        px.filter(|px| px.is_finite()).map(|px| (px, unit)).ok_or_else(|| ParseLengthError { text: text.to_owned() })
    }

    /// A length of the canvas as the file states it.
    pub(crate) fn state(self, px: f64) -> String {
        match self {
            Self::Px => drawn(px),
            Self::Mm => format!("{}mm", drawn(px / Self::Mm.px())),
            Self::Cm => format!("{}cm", drawn(px / Self::Cm.px())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_that_is_finite_in_its_unit_alone_is_refused() {
        assert!(Unit::parse_length("1e306cm").is_ok_and(|(px, _)| px > 1e307));
        assert!(Unit::parse_length("1e308px").is_ok());
        assert!(Unit::parse_length("1e308mm").is_err());
    }
}
