//! How a grading run is to be made: its seed, and what only the instructor knows.
//!
//! ```toml
//!   # secret.toml, kept outside the repository     hidden cases come from the same generators as the random ones,
//!   seed = 81726354                                with a seed and weights that no student can know; feedback on
//!   sequences = 40                                 them names the promise that was broken, never the case
//!   calls = 16
//!   split_face = 2
//!   split_in_half = 1
//! ```

use super::cases::random::fresh_seed;
use super::toml_file::{ManifestError, TomlFile};
use serde::Deserialize;

/// How a run is to be made.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Plan {
    /// The seed of the random cases; it is written into the report.
    pub seed: u64,
    /// The instructor's hidden cases.
    pub secret: Option<Secret>,
    /// Only the suites that decide this test and those that it needs are run; the others are left out.
    pub only: Option<String>,
}

impl Plan {
    /// A run with this seed and nothing hidden.
    #[must_use]
    pub fn with_seed(seed: u64) -> Self {
        Self { seed, ..Self::default() }
    }

    /// A run with the seed that the environment variable `LAB_SEED` holds, else with a fresh one.
    #[must_use]
    pub fn from_environment() -> Self {
        let given = std::env::var("LAB_SEED").ok().and_then(|text| text.trim().parse().ok());
        Self::with_seed(given.unwrap_or_else(fresh_seed))
    }
}

/// The instructor's own seed and weights.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Secret {
    /// The seed of the hidden cases.
    pub seed: u64,
    /// How many hidden sequences are asked for each test that has sequences.
    #[serde(default = "Secret::usual_sequences")]
    pub sequences: usize,
    /// How many calls each of them makes.
    #[serde(default = "Secret::usual_calls")]
    pub calls: usize,
    /// How often `split_face` is called, in relation to `split_in_half`.
    #[serde(default = "Secret::usual_weight")]
    pub split_face: usize,
    /// How often `split_in_half` is called.
    #[serde(default = "Secret::usual_weight")]
    pub split_in_half: usize,
}

impl Secret {
    /// More would take longer than a submission is worth.
    const MOST: usize = 200;

    const fn usual_sequences() -> usize {
        24
    }

    const fn usual_calls() -> usize {
        14
    }

    const fn usual_weight() -> usize {
        1
    }

    /// Reads the instructor's file; `source` is its name in messages.
    ///
    /// # Errors
    /// [`ManifestError`] with the place: not TOML, an unknown key, a number that would ask nothing or too much.
    pub fn parse(text: &str, source: &str) -> Result<Self, ManifestError> {
        let file = TomlFile { text, source };
        let secret: Self = file.read()?;
        let in_range = |n: usize| (1..=Self::MOST).contains(&n);
        if ![secret.sequences, secret.calls].into_iter().all(in_range) {
            let what = format!("`sequences` and `calls` are from 1 to {}", Self::MOST);
            return Err(file.error(0, what));
        }
        match secret.split_face.checked_add(secret.split_in_half) {
            None | Some(0) => Err(file.error(0, "`split_face` and `split_in_half` are weights: not both 0")),
            Some(_) => Ok(secret),
        }
    }
}
