//! The reference figure of lab 01.

use super::Made;
use dcel_kit::figure::FigureOptions;

/// The map of wrong signs that lab 01 asks for.
pub(in crate::gallery) fn map(_: &FigureOptions) -> Made<String> {
    Ok(dcel_lab::courses::predicates::map::picture())
}
