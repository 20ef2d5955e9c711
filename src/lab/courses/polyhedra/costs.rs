//! A large surface: is the answer right where numbers are large, and does it cost what it should?
//!
//! ```text
//!   torus 150 150                          135,000 records; numbers of half-edges up to 89,999
//!   many 10000 vertices_around 1000000     answers 40000 reads 130000   who looks at everything has used the reads up
//! ```

use super::shapes::{blind, torus};
use crate::many::{self, Large, QUESTIONS};
use crate::protocol::{Case, Start, Structure};
use std::sync::{Arc, LazyLock};

/// How many reads the many questions have together. The solution needs 130,000.
const BUDGET: u64 = 1_000_000;

/// The large surface.
pub(super) static LARGE_TORUS: LazyLock<Start> =
    LazyLock::new(|| Start::known("torus 150 150", Structure::Records(Arc::new(blind(&torus(150, 150)).records()))));

/// Questions about single vertices, then about many.
pub(super) fn questions() -> Case {
    many::questions(
        "vertices_around_large.torus",
        LARGE_TORUS.clone(),
        "vertices_around",
        ["v22499", "v16400", "v300"],
        BUDGET,
    )
}

/// What many questions about it should give: around every vertex there are four others.
pub(super) const LARGE: Large = Large {
    records: 135_000,
    answers: 4 * QUESTIONS as u64,
    one: "which has 4 neighbours",
    elements: "vertices",
    letter: 'v',
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_large_surface_has_as_many_records_as_it_says() {
        assert_eq!(LARGE_TORUS.structure().map(Structure::len), Some(LARGE.records as usize));
    }
}
