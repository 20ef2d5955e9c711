//! Which submissions of a class look alike, names and comments aside.
//!
//! ```text
//!   text ─▶ tokens: own names are all one, comments are gone
//!        ─▶ every stretch of K tokens as a number ─▶ winnowing: the smallest of each W in a row
//!        ─▶ less those of the given file ─▶ fingerprints
//!   percent of a pair = 2 · shared / all of both                        from THRESHOLD on it is told
//! ```
//!
//! Winnowing (Schleimer, Wilkerson, Aiken 2003) finds every stretch of `K + W - 1` tokens that two files share, and
//! needs time linear in the length of a file. What the lab gives does not count, and is no name of anybody's own.
//!
//! Two honest solutions of a small task are alike in parts: everybody walks round a face with the same loop. The
//! threshold is measured on lab 04: among six whole solutions of different make the most alike pair has 46 percent,
//! and the same solution with other names, without comments and with its functions moved has 97 and more. Known
//! mistakes differ from the solution by a few lines, and are above it, as they should be: see `tests/labs/alike.rs`.

mod tokens;

use crate::LabFiles;
use crate::cache::hash_of;
use std::collections::{BTreeSet, HashMap};
use tokens::{names, tokens};

/// How many tokens a stretch has.
const K: usize = 12;
/// Of so many stretches in a row, one is kept at least.
const W: usize = 6;
/// From here on a pair is told if nothing else is asked for, in percent.
pub(crate) const THRESHOLD: u8 = 80;
/// Who wrote less than this much cannot be told from another.
const FEWEST: usize = 15;
/// How many are told of one submission.
const MOST: usize = 10;

/// The fingerprints of what a student wrote: sorted, each once.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Fingerprints(Vec<u64>);

impl Fingerprints {
    /// Whether nothing is there but what was given.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// What a lab gives, and what therefore tells nothing.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Given {
    names: BTreeSet<String>,
    prints: Vec<u64>,
}

impl Given {
    /// From the files of the lab: names from all that is given, fingerprints from the graded files as they are given.
    pub(crate) fn new(files: &LabFiles, graded: &[String]) -> Self {
        let sources = files.iter().filter(|(path, _)| path.starts_with("src/") && path.ends_with(".rs"));
        let names: BTreeSet<String> = sources.flat_map(|(_, text)| names(text)).collect();
        let mut given = Self { names, prints: Vec::new() };
        let files: Vec<_> = graded.iter().filter_map(|path| Some((path, files.get(path)?))).collect();
        let prints = files.into_iter().filter_map(|(_, text)| given.all_prints(text)).flatten();
        let prints: BTreeSet<u64> = prints.collect();
        given.prints = prints.into_iter().collect();
        given
    }

    /// The fingerprints of graded files; `None` if one of them is no Rust.
    ///
    /// Cost: linear in the length of the text, but for the sorting of the fingerprints.
    pub(crate) fn fingerprints(&self, graded: &[(String, String)]) -> Option<Fingerprints> {
        let mut prints = BTreeSet::new();
        for (_, text) in graded {
            prints.extend(self.all_prints(text)?);
        }
        Some(Fingerprints(prints.into_iter().filter(|print| self.prints.binary_search(print).is_err()).collect()))
    }

    fn all_prints(&self, text: &str) -> Option<Vec<u64>> {
        Some(winnowed(&tokens(text, &self.names)?))
    }
}

/// The smallest number of each `W` stretches in a row; all of them if there are fewer.
fn winnowed(tokens: &[u64]) -> Vec<u64> {
    let stretches: Vec<u64> = tokens.windows(K).map(|stretch| hash_of(&stretch)).collect();
    let mut kept: Vec<u64> = Vec::new();
    let mut last = None;
    for start in 0..(stretches.len() + 1).saturating_sub(W).max(usize::from(!stretches.is_empty())) {
        let window = &stretches[start..stretches.len().min(start + W)];
        let smallest = window.iter().enumerate().rev().min_by_key(|(_, number)| **number);
        if let Some((i, &number)) = smallest.filter(|(i, _)| last != Some(start + i)) {
            last = Some(start + i);
            kept.push(number);
        }
    }
    kept
}

fn percent(shared: usize, a: &Fingerprints, b: &Fingerprints) -> u8 {
    u8::try_from(200 * shared / (a.0.len() + b.0.len()).max(1)).unwrap_or(100)
}

/// For each submission, those that look like it, from `threshold` percent on: the most alike first, at most ten.
///
/// Cost: for each fingerprint, the number of those who have it, for each of them.
pub(crate) fn alike(class: &[Option<&Fingerprints>], threshold: u8) -> Vec<Vec<(usize, u8)>> {
    let mut who_has: HashMap<u64, Vec<usize>> = HashMap::new();
    let enough = |prints: &&&Fingerprints| prints.0.len() >= FEWEST;
    for (i, prints) in class.iter().enumerate() {
        for &print in prints.as_ref().filter(enough).map_or(&[][..], |prints| &prints.0) {
            who_has.entry(print).or_default().push(i);
        }
    }
    let mut shared = vec![0; class.len()];
    let pairs = |i: usize| {
        let Some(own) = class[i].as_ref().filter(enough) else { return Vec::new() };
        shared.fill(0);
        for print in &own.0 {
            who_has[print].iter().for_each(|&j| shared[j] += 1);
        }
        let others = shared.iter().enumerate().filter(|&(j, &shared)| j != i && shared > 0);
        let percents = others.filter_map(|(j, &shared)| Some((j, percent(shared, own, class[j]?))));
        let mut told: Vec<(usize, u8)> = percents.filter(|&(_, percent)| percent >= threshold).collect();
        told.sort_by_key(|&(j, percent)| (std::cmp::Reverse(percent), j));
        told.truncate(MOST);
        told
    };
    (0..class.len()).map(pairs).collect()
}
