//! Naming a mistake: by failing in exactly the same way as a known mistake of the lab.
//!
//! ```text
//!   the cases that are always the same ──▶ (case, step, rule, part that the element plays, what is said: told.rs)
//!                                                                                          ──▶ one hash a test
//!   all other calls                    ──▶ the condition under which the mistake shows     ──▶ features
//!
//!   bugs/signatures.toml     [12]                                                     written by `dcel lab verify`
//!                            split_face_5_representatives = "8f3a… stored_new"        for every known mistake
//! ```
//!
//! A mistake is named for a task if all tests of the task fail as they do with it, and nothing that it makes fail
//! elsewhere fails differently. So two mistakes at once give no name, which is better than a wrong one.
//!
//! Random cases must agree, too. The mistake itself cannot be run beside the student's program, whose build never
//! holds its text. So `verify` runs it on the fixed cases and on those of several seeds, and keeps the condition, made
//! of features of the calls, that holds in exactly the calls in which it shows. A name is given only if each random
//! call that decides a test fails where the condition holds, and nowhere else. Where no such condition was found, no
//! name is given once a random call decides the test.

use super::conditions::{Calls, When};
use super::judge::Feature;
use super::signatures::Signature;
#[cfg(feature = "grade")]
use super::signatures::hash_in;
use super::the_lab::Lab;
use std::collections::{BTreeMap, BTreeSet};

/// For each test, the calls that decide it, by their features.
pub(super) type Evidence = BTreeMap<String, Calls>;

/// How a student's program fails.
pub(super) struct Found<'a> {
    /// In the fixed cases.
    pub(super) signature: &'a Signature,
    /// The tests that were not judged.
    pub(super) skipped: &'a BTreeSet<&'a str>,
    /// In all other cases.
    pub(super) evidence: &'a Evidence,
}

/// The condition of an entry of a signature.
fn when_in(entry: &str, vocabulary: &[Feature]) -> Option<When> {
    When::parse(entry.split_once(' ')?.1, vocabulary)
}

/// Adds the conditions under which its tests fail to the signature of a mistake.
#[cfg(feature = "grade")]
pub(super) fn with_conditions(signature: &mut Signature, evidence: &Evidence, vocabulary: &[Feature]) {
    for (test, entry) in signature {
        if let Some(when) = evidence.get(test).and_then(When::learn) {
            *entry = format!("{} {}", hash_in(entry), when.to_text(vocabulary));
        }
    }
}

/// Whether the calls that decide a test fail as a mistake does of which this is the entry.
fn agrees(entry: Option<&String>, calls: &Calls, vocabulary: &[Feature]) -> bool {
    match entry {
        None => calls.failing.is_empty(),
        Some(entry) => match when_in(entry, vocabulary) {
            Some(when) => {
                calls.failing.iter().all(|&call| when.holds(call))
                    && !calls.passing.iter().any(|&call| when.holds(call))
            }
            None => calls.failing.is_empty() && calls.passing.is_empty(),
        },
    }
}

/// What the tests of one task fail at, in the words of the lab: the titles of all known mistakes that fail like this,
/// with those declared to be the same.
pub(super) fn names(lab: &Lab, vocabulary: &[Feature], task: u32, found: &Found) -> Vec<String> {
    let tests = lab.manifest.tests.iter().filter(|test| test.task == task).map(|test| test.name.as_str());
    let tests: BTreeSet<&str> = tests.collect();
    let agreeing = |number: &u32| {
        let Some(signature) = lab.signatures.get(*number) else { return false };
        let concerned = tests.iter().copied().chain(signature.keys().map(String::as_str)).collect::<BTreeSet<_>>();
        let mut calls = concerned.iter().filter_map(|&test| Some((test, found.evidence.get(test)?)));
        calls.all(|(test, calls)| agrees(signature.get(test), calls, vocabulary))
    };
    let matching = lab.signatures.matching(found.signature, &tests, found.skipped);
    let mut numbers: BTreeSet<u32> = matching.into_iter().filter(agreeing).collect();
    let same = lab.bugs.iter().filter(|bug| numbers.contains(&bug.number)).flat_map(|bug| bug.same_as.clone());
    numbers.extend(same.collect::<Vec<_>>());
    lab.bugs.iter().filter(|bug| numbers.contains(&bug.number)).map(|bug| bug.title.clone()).collect()
}

/// A hash of sorted lines that is the same on every machine and with every version of the compiler.
///
/// Source: FNV-1a, 64 bits, Fowler, Noll and Vo.
pub(super) fn hash(lines: &BTreeSet<String>) -> String {
    let mut state = 0xcbf2_9ce4_8422_2325_u64;
    for byte in lines.iter().flat_map(|line| line.bytes().chain([b'\n'])) {
        state = (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{state:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_do_not_change_with_the_compiler() {
        assert_eq!(hash(&BTreeSet::new()), "cbf29ce484222325");
        assert_eq!(hash(&["a".to_owned()].into()), "089bdc07b544e7b2");
    }
}
