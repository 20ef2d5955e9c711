//! Conditions on calls: what all failing ones have in common and no passing one has.
//!
//! ```text
//!   failing   outer  stored_new  new_4_more        in all failing: stored_new, outer
//!             outer  stored_new                    in a passing one, too: outer
//!   passing   outer              new_4_more   ──▶  "It fails in all 2 calls where the face stores a half-edge that
//!             …                                     goes over to the new face, and in none of the 5 others."
//! ```
//!
//! A sentence is told only if chance is unlikely: with one feature there are at least two failing and three passing
//! calls; with two features at least four and eight, and so many that less than one choice in twenty times the
//! pairs that were tried would look like this. A sentence is true of the calls that were made, whatever the reason.

use super::judge::Feature;

/// Failing and passing calls that one feature needs.
const ONE: [usize; 2] = [2, 3];
/// Failing and passing calls that two features need.
const TWO: [usize; 2] = [4, 8];
/// How many times more likely than chance.
const UNLIKELY: u128 = 20;
/// The condition that holds for no call.
pub(super) const NEVER: &str = "never";

/// The calls of a test, each as the set of its features.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Calls {
    pub(super) failing: Vec<u128>,
    pub(super) passing: Vec<u128>,
}

/// The shortest condition of one or two features that holds in all failing and in no passing calls, as a set of
/// features. Of several, the one whose features come first in the vocabulary.
pub(super) fn shortest(calls: &Calls) -> Option<u128> {
    let bits = common(calls);
    let enough = |[failing, passing]: [usize; 2]| calls.failing.len() >= failing && calls.passing.len() >= passing;
    let separates = |condition: u128| !calls.passing.iter().any(|call| call & condition == condition);
    if !enough(ONE) {
        return None;
    }
    if let Some(&one) = bits.iter().find(|&&bit| separates(bit)) {
        return Some(one);
    }
    let tried = (bits.len() * bits.len() / 2) as u128;
    if !enough(TWO) || choices(calls.failing.len(), calls.passing.len()) < UNLIKELY * tried {
        return None;
    }
    let mut pairs = bits.iter().enumerate().flat_map(|(i, a)| bits[i + 1..].iter().map(move |b| a | b));
    pairs.find(|&pair| separates(pair))
}

/// The feature that all failing calls have and the fewest others, at most half of them; with its share of the others.
/// For calls that no short condition tells apart.
pub(super) fn necessary(calls: &Calls) -> Option<(u128, usize)> {
    let with = |bit: u128| calls.passing.iter().filter(|&&call| call & bit != 0).count();
    let bits = common(calls);
    let (bit, others) = bits.iter().map(|&bit| (bit, with(bit))).rev().min_by_key(|&(_, others)| others)?;
    // By chance each call has the feature as often as the others have it; one in so many features is tried.
    let share = others as f64 / calls.passing.len().max(1) as f64;
    let chance = share.powi(calls.failing.len().min(1000) as i32) * bits.len() as f64;
    let enough = calls.failing.len() >= TWO[0] && calls.passing.len() >= TWO[1];
    (enough && share <= 0.5 && chance * (UNLIKELY as f64) < 1.0).then_some((bit, others))
}

/// The sentence about a feature that [`necessary`] has found.
pub(super) fn necessary_sentence((bit, others): (u128, usize), calls: &Calls, vocabulary: &[Feature]) -> String {
    let (failing, passing) = (calls.failing.len(), calls.passing.len());
    let clause = clauses(bit, vocabulary);
    format!(
        "It fails only where {clause}: in {failing} of those {} calls, and in none of the {} others.",
        failing + others,
        passing - others
    )
}

/// In how many ways `a` of `a + b` can be chosen, or a large number.
fn choices(a: usize, b: usize) -> u128 {
    let (a, b) = (a.min(b) as u128, a.max(b) as u128);
    (1..=a).try_fold(1_u128, |product, i| Some(product.checked_mul(b + i)? / i)).unwrap_or(u128::MAX)
}

/// The sentence about a condition that [`shortest`] has found.
pub(super) fn sentence(condition: u128, calls: &Calls, vocabulary: &[Feature]) -> String {
    let others = match calls.passing.len() {
        1 => "not in the other one".to_owned(),
        others => format!("in none of the {others} others"),
    };
    format!("It fails in all {} calls where {}, and {others}.", calls.failing.len(), clauses(condition, vocabulary))
}

/// What all failing calls have in common, each feature by its bit.
fn common(calls: &Calls) -> Vec<u128> {
    let common = calls.failing.iter().fold(u128::MAX, |all, call| all & call);
    (0..u128::BITS).map(|bit| 1 << bit).filter(|bit| common & bit != 0).collect()
}

/// The clauses of some features.
fn clauses(set: u128, vocabulary: &[Feature]) -> String {
    of(set, vocabulary).map(|feature| feature.clause).collect::<Vec<_>>().join(" and ")
}

pub(super) fn of(set: u128, vocabulary: &[Feature]) -> impl Iterator<Item = &Feature> {
    vocabulary.iter().enumerate().filter(move |(bit, _)| set >> bit & 1 == 1).map(|(_, feature)| feature)
}

/// When a known mistake fails: in the calls in which all features of one of the terms hold.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct When(pub(super) Vec<u128>);

impl When {
    /// Whether it holds for a call.
    pub(super) fn holds(&self, call: u128) -> bool {
        self.0.iter().any(|&term| term & !call == 0)
    }

    /// Reads a condition as it stands in a file: `outer+twice|bridge`; `always` for a term without features, `never`
    /// without terms. `None` if a feature is unknown.
    pub(super) fn parse(text: &str, vocabulary: &[Feature]) -> Option<Self> {
        let bit = |id: &str| vocabulary.iter().position(|feature| feature.id == id).map(|bit| 1_u128 << bit);
        let term = |term: &str| match term {
            "always" => Some(0),
            ids => ids.split('+').try_fold(0, |set, id| Some(set | bit(id)?)),
        };
        if text == NEVER {
            return Some(Self(Vec::new()));
        }
        text.split('|').map(term).collect::<Option<Vec<u128>>>().map(Self)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(crate) static WORDS: &[Feature] = &[
        Feature { id: "a", clause: "it is a" },
        Feature { id: "b", clause: "it is b" },
        Feature { id: "c", clause: "it is c" },
    ];

    pub(crate) fn calls(failing: &[u128], passing: &[u128]) -> Calls {
        Calls { failing: failing.to_vec(), passing: passing.to_vec() }
    }

    #[test]
    fn one_feature_is_told_before_two_and_the_first_of_several() {
        let found = calls(&[0b011, 0b111], &[0b100, 0b100, 0b000]);
        assert_eq!(shortest(&found), Some(0b001));
        let told = sentence(0b001, &found, WORDS);
        assert_eq!(told, "It fails in all 2 calls where it is a, and in none of the 3 others.");
        let two = calls(&[0b011; 6], &[0b001, 0b010, 0b000, 0b001, 0b010, 0b001, 0b010, 0b100]);
        assert_eq!(shortest(&two), Some(0b011));
        assert!(sentence(0b011, &two, WORDS).contains("where it is a and it is b, and"));
    }

    #[test]
    fn nothing_is_told_without_evidence_or_against_it() {
        assert_eq!(shortest(&calls(&[0b1], &[0, 0, 0])), None, "one failing call");
        assert_eq!(shortest(&calls(&[0b1, 0b1], &[0, 0])), None, "two passing calls");
        assert_eq!(shortest(&calls(&[0b1; 9], &[0, 0, 0, 0b1])), None, "a passing call has it");
        assert_eq!(shortest(&calls(&[0b1, 0b1, 0b10], &[0, 0, 0, 0])), None, "a failing call lacks it");
        assert_eq!(shortest(&calls(&[0b11; 3], &[0b01, 0b10, 0, 0, 0, 0, 0, 0])), None, "two features ask for more");
    }

    #[test]
    fn a_feature_of_all_failing_calls_is_told_if_few_others_have_it() {
        // Feature `a` in all failing calls and in two others; `b` in all calls.
        let found = calls(&[0b011; 5], &[0b011, 0b011, 0b010, 0b010, 0b010, 0b010, 0b010, 0b010, 0b010, 0b010]);
        assert_eq!(shortest(&found), None);
        let told = necessary(&found).unwrap();
        assert_eq!(told, (0b001, 2));
        let words = necessary_sentence(told, &found, WORDS);
        assert_eq!(words, "It fails only where it is a: in 5 of those 7 calls, and in none of the 8 others.");
        let half = calls(&[0b011; 50], &[0b011, 0b011, 0b011, 0b011, 0b011, 0b010, 0b010, 0b010]);
        assert_eq!(necessary(&half), None, "more than half of the others have it");
        assert_eq!(necessary(&calls(&[0b001; 4], &[0; 8])), Some((0b001, 0)), "just enough calls");
        assert_eq!(necessary(&calls(&[0b001; 3], &[0; 99])), None, "three calls");
        assert_eq!(necessary(&calls(&[0b001; 9], &[0; 7])), None, "seven others");
        assert_eq!(necessary(&calls(&[0b001, 0b010, 0b011, 0b011], &[0; 99])), None, "a failing call lacks it");
    }

    #[test]
    fn a_told_condition_is_true_of_all_calls() {
        let mut random = crate::cases::random::Random::new(7, "conditions");
        let mut told = 0;
        for _ in 0..2000 {
            let call = |random: &mut crate::cases::random::Random| random.bits() as u128 & 0b1111;
            let target = call(&mut random) | 1;
            let all: Vec<u128> = (0..30).map(|_| call(&mut random)).collect();
            let (failing, passing) = all.iter().partition(|&&call| call & target == target);
            let calls = Calls { failing, passing };
            let Some(condition) = shortest(&calls) else { continue };
            told += 1;
            assert!(all.iter().all(|call| (call & condition == condition) == calls.failing.contains(call)));
            assert!(condition.count_ones() <= 2);
        }
        assert!(told > 200, "only {told} were told");
    }
}
