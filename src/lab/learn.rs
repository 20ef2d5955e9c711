//! Learning the condition under which a known mistake shows.
//!
//! ```text
//!   failing   outer twice      open: both failing calls
//!             bridge           1. `outer`? a passing call has it. `outer+twice`? none has: it explains one call
//!   passing   outer            2. `bridge` explains the other one            ──▶  outer+twice|bridge
//! ```

use super::conditions::{Calls, NEVER, When, of};
use super::judge::Feature;
use std::collections::BTreeSet;

/// The longest conjunction, and the most of them, in the condition of a known mistake.
const TERM: usize = 3;
const TERMS: usize = 6;

impl When {
    /// The condition that holds in exactly the failing calls, built of a few short terms; `None` if there is none.
    ///
    /// Greedy: the term that no passing call fulfils and that explains the most calls comes first. Where no call fails,
    /// what is wrong shows elsewhere (in the count of reads, say): the condition holds never.
    pub(super) fn learn(calls: &Calls) -> Option<Self> {
        let passing: BTreeSet<u128> = calls.passing.iter().copied().collect();
        let mut open: BTreeSet<u128> = calls.failing.iter().copied().collect();
        if open.is_empty() && passing.is_empty() || !open.is_disjoint(&passing) {
            return None;
        }
        let mut terms = Vec::new();
        while !open.is_empty() {
            let term = best_term(&open, &passing)?;
            open.retain(|call| call & term != term);
            terms.push(term);
            if terms.len() > TERMS {
                return None;
            }
        }
        Some(Self(terms))
    }

    /// As [`When::parse`] reads it.
    pub(super) fn to_text(&self, vocabulary: &[Feature]) -> String {
        if self.0.is_empty() {
            return NEVER.to_owned();
        }
        let term = |&term: &u128| {
            let ids: Vec<&str> = of(term, vocabulary).map(|feature| feature.id).collect();
            if ids.is_empty() { "always".to_owned() } else { ids.join("+") }
        };
        self.0.iter().map(term).collect::<Vec<_>>().join("|")
    }
}

/// The shortest term that explains the most of the open calls and no passing one.
fn best_term(open: &BTreeSet<u128>, passing: &BTreeSet<u128>) -> Option<u128> {
    let known = open.iter().fold(0, |all, call| all | call);
    let bits: Vec<u128> = (0..u128::BITS).map(|bit| 1 << bit).filter(|bit| known & bit != 0).collect();
    let mut terms: Vec<u128> = vec![0];
    for length in 0..=TERM {
        let sound = terms.iter().filter(|&&term| !passing.iter().any(|call| call & term == term));
        let explained = |term: u128| open.iter().filter(|&call| call & term == term).count();
        // The first of the best: `max_by_key` would take the last.
        let best = sound.map(|&term| (explained(term), term)).rev().max_by_key(|&(count, _)| count);
        if let Some((_, term)) = best.filter(|&(count, _)| count > 0) {
            return Some(term);
        }
        if length == TERM {
            break;
        }
        terms = bits
            .iter()
            .flat_map(|&bit| terms.iter().filter(move |&&term| term < bit).map(move |&term| term | bit))
            .filter(|&term| open.iter().any(|call| call & term == term))
            .collect();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conditions::tests::{WORDS, calls};

    #[test]
    fn the_condition_of_a_mistake_is_exact_and_read_as_it_is_written() {
        let found = calls(&[0b001, 0b110], &[0b010, 0b100, 0b000]);
        let when = When::learn(&found).unwrap();
        assert!(found.failing.iter().all(|&call| when.holds(call)));
        assert!(!found.passing.iter().any(|&call| when.holds(call)));
        assert_eq!(when.to_text(WORDS), "a|b+c");
        assert_eq!(When::parse("a|b+c", WORDS), Some(when));
        assert_eq!(When::learn(&calls(&[0b1], &[])).unwrap().to_text(WORDS), "always");
        assert_eq!(When::parse("always", WORDS).map(|when| when.holds(0)), Some(true));
        let never = When::learn(&calls(&[], &[0b1])).unwrap();
        assert!(!never.holds(0b1) && never.to_text(WORDS) == "never" && When::parse("never", WORDS) == Some(never));
        assert_eq!(When::learn(&calls(&[], &[])), None, "nothing is known");
        assert_eq!(When::parse("a+z", WORDS), None);
        assert_eq!(When::learn(&calls(&[0b1], &[0b1])), None, "the same call cannot pass and fail");
    }
}
