//! The result of a round as a word to hand in: `predict-2-1234-4of5-8c1f`.
//!
//! It says itself what it means. The last part only tells slips of the pen; it is no signature, and the result is
//! practice, not a grade.

use crate::play::dice::Dice;

/// The code.
pub(super) fn write(what: &str, level: u32, seed: u64, right: usize, count: usize) -> String {
    let said = format!("{what}-{level}-{seed}-{right}of{count}");
    format!("{said}-{:04x}", check(&said))
}

/// What a code says, as a sentence.
pub(in crate::play) fn read(code: &str) -> Result<String, String> {
    let code = code.trim();
    let strange =
        || format!("`{code}` is no result code, or was copied with a mistake; one looks like predict-2-1234-4of5-8c1f");
    let (said, sum) = code.rsplit_once('-').ok_or_else(strange)?;
    let parts: Vec<&str> = said.split('-').collect();
    let [what, level, seed, score] = parts[..] else { return Err(strange()) };
    let (right, count) = score.split_once("of").ok_or_else(strange)?;
    let &(_, title, _) = super::Kind::ALL.iter().find(|(word, ..)| *word == what).ok_or_else(strange)?;
    if sum != format!("{:04x}", check(said)) {
        return Err(strange());
    }
    Ok(format!("{title} Level {level}, seed {seed}: {right} of {count} right."))
}

fn check(said: &str) -> usize {
    let sum = said.bytes().fold(7_u64, |sum, byte| sum.wrapping_mul(31).wrapping_add(u64::from(byte)));
    Dice::new(sum, 0).below(1 << 16)
}
