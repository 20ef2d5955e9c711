//! How the known mistakes of a lab fail, in a file.

use super::toml_file::{ManifestError, TomlFile, key, quoted};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// How a program fails: for each failing test that was not skipped, a hash of what fails in the fixed cases. In a file
/// a blank and the condition under which it fails may follow.
pub type Signature = BTreeMap<String, String>;

/// The hash of an entry of a signature.
pub(super) fn hash_in(entry: &str) -> &str {
    entry.split(' ').next().unwrap_or_default()
}

/// The signatures of the known mistakes, by their numbers.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Signatures {
    bugs: BTreeMap<u32, Signature>,
}

impl Signatures {
    /// The signatures of some bugs.
    pub fn new(bugs: impl IntoIterator<Item = (u32, Signature)>) -> Self {
        Self { bugs: bugs.into_iter().collect() }
    }

    /// Reads `signatures.toml`; `source` is its name in messages.
    ///
    /// # Errors
    /// [`ManifestError`] with the place.
    pub fn parse(text: &str, source: &str) -> Result<Self, ManifestError> {
        let file = TomlFile { text, source };
        let tables: BTreeMap<String, Signature> = file.read()?;
        let mut bugs = BTreeMap::new();
        for (number, signature) in tables {
            let number = number.parse().map_err(|_| file.error(0, format!("`{number}` is not the number of a bug")))?;
            bugs.insert(number, signature);
        }
        Ok(Self { bugs })
    }

    /// The text of `signatures.toml`.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = "# How each known mistake fails. Generated: `dcel lab verify --write`.\n".to_owned();
        for (number, signature) in &self.bugs {
            let _ = writeln!(out, "\n[{number}]");
            for (test, hash) in signature {
                let _ = writeln!(out, "{} = {}", key(test), quoted(hash));
            }
        }
        out
    }

    /// The signature of a bug.
    #[must_use]
    pub fn get(&self, bug: u32) -> Option<&Signature> {
        self.bugs.get(&bug)
    }

    /// The numbers of the bugs that fail in a task as `found` does. `skipped` are the tests that were not judged.
    #[must_use]
    pub fn matching(&self, found: &Signature, task: &BTreeSet<&str>, skipped: &BTreeSet<&str>) -> Vec<u32> {
        let of_task = |signature: &Signature| -> Signature {
            let of_task = signature.iter().filter(|(test, _)| task.contains(test.as_str()));
            of_task.map(|(test, entry)| (test.clone(), hash_in(entry).to_owned())).collect()
        };
        let here = of_task(found);
        if here.is_empty() {
            return Vec::new();
        }
        let fits = |signature: &Signature| {
            let agrees = |(test, hash): (&String, &String)| match found.get(test) {
                Some(other) => hash_in(other) == hash_in(hash),
                None => skipped.contains(test.as_str()),
            };
            of_task(signature) == here && signature.iter().all(agrees)
        };
        let fitting: Vec<(u32, &Signature)> = self
            .bugs
            .iter()
            .filter(|(_, signature)| fits(signature))
            .map(|(&number, signature)| (number, signature))
            .collect();
        // One that explains more than another is the better name: what it does elsewhere is seen, too.
        let covers = |more: &Signature, less: &Signature| {
            let same =
                |(test, entry): (&String, &String)| more.get(test).is_some_and(|own| hash_in(own) == hash_in(entry));
            more.len() > less.len() && less.iter().all(same)
        };
        let is_best = |own: &Signature| !fitting.iter().any(|(_, other)| covers(other, own));
        fitting.iter().filter(|(_, own)| is_best(own)).map(|(number, _)| *number).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signature(pairs: &[(&str, &str)]) -> Signature {
        pairs.iter().map(|(test, hash)| ((*test).to_owned(), (*hash).to_owned())).collect()
    }

    #[test]
    fn only_equal_failures_have_a_name() {
        let mutants = Signatures::new([
            (1, signature(&[("a", "11")])),
            (2, signature(&[("a", "22"), ("b", "33")])),
            (3, signature(&[("a", "11")])),
            (4, signature(&[("a", "44"), ("other", "55")])),
        ]);
        let task = ["a", "b"].into();
        let none = BTreeSet::new();
        let named =
            |found: &[(&str, &str)], skipped: &BTreeSet<&str>| mutants.matching(&signature(found), &task, skipped);
        assert_eq!(named(&[("a", "11")], &none), [1, 3]);
        assert_eq!(named(&[("a", "22"), ("b", "33")], &none), [2]);
        // One more or less, or another hash: no name.
        assert_eq!(named(&[("a", "22")], &none), [0; 0]);
        assert_eq!(named(&[("a", "11"), ("b", "33")], &none), [0; 0]);
        assert_eq!(named(&[("a", "99")], &none), [0; 0]);
        assert_eq!(named(&[], &none), [0; 0]);
        // What the bug does to another task must be there, too, unless that was not judged.
        assert_eq!(named(&[("a", "44")], &none), [0; 0]);
        assert_eq!(named(&[("a", "44"), ("other", "55")], &none), [4]);
        assert_eq!(named(&[("a", "44")], &["other"].into()), [4]);
        // Of two that fit, the one that explains more.
        let wide = Signatures::new([(5, signature(&[("a", "11")])), (6, signature(&[("a", "11"), ("other", "66")]))]);
        let found = |pairs: &[(&str, &str)]| wide.matching(&signature(pairs), &task, &none);
        assert_eq!(found(&[("a", "11"), ("other", "66")]), [6]);
        assert_eq!(found(&[("a", "11")]), [5]);
        // What fails elsewhere for reasons of its own does not matter.
        assert_eq!(named(&[("a", "11"), ("other", "66")], &none), [1, 3]);
    }

    #[test]
    fn signatures_are_read_as_they_are_written() {
        let mutants = Signatures::new([(7, signature(&[("a", "11"), ("b", "22")])), (12, signature(&[("a", "33")]))]);
        assert_eq!(Signatures::parse(&mutants.to_text(), "x").unwrap(), mutants);
        let odd = Signatures::new([(7, signature(&[("a b", "\"\\\n\u{1}"), ("", "é")]))]);
        assert_eq!(Signatures::parse(&odd.to_text(), "x").unwrap(), odd);
        let error = Signatures::parse("[seven]\na = \"11\"\n", "signatures.toml").unwrap_err();
        assert_eq!(error.to_string(), "signatures.toml:1:1: `seven` is not the number of a bug");
    }
}
