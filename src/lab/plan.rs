//! How a grading run is to be made: its seed, and what only the instructor knows.
//!
//! ```toml
//!   # secret.toml, kept outside the repository     hidden cases come from the same generators as the random ones,
//!   seed = 81726354                                with a seed and weights that no student can know; feedback on
//!   sequences = 40                                 them names the promise that was broken, never the case
//!   calls = 16
//!   split_face = 2                                 weights of the lab's functions (here those of lab 04)
//!   split_in_half = 1
//! ```

use super::cases::random::fresh_seed;
use super::toml_file::{ManifestError, TomlFile};
use std::collections::BTreeMap;
use toml::{Spanned, Value};

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
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Secret {
    /// The seed of the hidden cases.
    pub seed: u64,
    /// How many hidden sequences are asked for each test that has sequences.
    pub sequences: usize,
    /// How many calls each of them makes.
    pub calls: usize,
    /// How often a function is called, in relation to the others; once if nothing is said.
    weights: BTreeMap<String, usize>,
}

impl Secret {
    /// More would take longer than a submission is worth.
    const MOST: usize = 200;
    /// What is asked if the file does not say it.
    const USUAL: [usize; 2] = [24, 14];

    /// A secret with a seed and nothing else.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let [sequences, calls] = Self::USUAL;
        Self { seed, sequences, calls, weights: BTreeMap::new() }
    }

    /// How often a function is called, in relation to the others.
    #[must_use]
    pub fn weight(&self, function: &str) -> usize {
        self.weights.get(function).copied().unwrap_or(1)
    }

    /// Reads the instructor's file; `source` is its name in messages, `weighted` the functions of the lab that can have
    /// weights (see [`Judge::weighted`](crate::judge::Judge::weighted)).
    ///
    /// # Errors
    /// [`ManifestError`] with the place: not TOML, an unknown key, a number that would ask nothing or too much.
    pub fn parse(text: &str, source: &str, weighted: &[&str]) -> Result<Self, ManifestError> {
        let file = TomlFile { text, source };
        let table: BTreeMap<Spanned<String>, Spanned<Value>> = file.read()?;
        let mut seed = None;
        let mut secret = Self::new(0);
        for (key, value) in table {
            let name = key.get_ref().as_str();
            let at = value.span().start;
            let number = value.get_ref().as_integer().and_then(|number| u64::try_from(number).ok());
            let known = matches!(name, "seed" | "sequences" | "calls") || weighted.contains(&name);
            if !known {
                let known = ["seed", "sequences", "calls"].iter().chain(weighted).copied().collect::<Vec<_>>();
                return Err(
                    file.error(key.span().start, format!("unknown key `{name}`; there is {}", known.join(", ")))
                );
            }
            let Some(number) = number else {
                return Err(file.error(at, format!("`{name}` is a whole number that is not negative")));
            };
            if name == "seed" {
                seed = Some(number);
                continue;
            }
            let least = usize::from(matches!(name, "sequences" | "calls"));
            let Some(count) = usize::try_from(number).ok().filter(|count| (least..=Self::MOST).contains(count)) else {
                return Err(file.error(at, format!("`{name}` is from {least} to {}", Self::MOST)));
            };
            match name {
                "sequences" => secret.sequences = count,
                "calls" => secret.calls = count,
                _ => drop(secret.weights.insert(name.to_owned(), count)),
            }
        }
        if !weighted.is_empty() && weighted.iter().all(|function| secret.weight(function) == 0) {
            let words: Vec<String> = weighted.iter().map(|function| format!("`{function}`")).collect();
            return Err(file.error(0, format!("{} are weights: not all 0", words.join(" and "))));
        }
        secret.seed = seed.ok_or_else(|| file.error(0, "there is no seed; write `seed = NUMBER`"))?;
        Ok(secret)
    }
}
