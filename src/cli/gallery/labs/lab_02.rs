//! The reference figure of lab 02.

use crate::gallery::Made;

/// The triangulation that lab 02 asks for.
pub(in crate::gallery) fn triangulation() -> Made<String> {
    Ok(dcel_lab::courses::triangulation::drawing::picture())
}
