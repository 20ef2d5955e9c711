//! Did you mean ...?

/// The word that needs the fewest changes to become `word`, if that are not too many: at most half its letters.
/// Capitals do not matter; of equals the first in the alphabet.
///
/// Cost: for each word, the product of the two lengths.
///
/// ```
/// use dcel_kit::io::closest;
/// assert_eq!(closest("tenessee", ["Texas", "Tennessee"]), Some("Tennessee"));
/// assert_eq!(closest("xyz", ["Texas", "Tennessee"]), None);
/// ```
pub fn closest<'a>(word: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let distances = words.into_iter().map(|known| (edits(&word, &known.to_lowercase()), known));
    let (distance, close) = distances.min()?;
    (distance <= close.chars().count().max(word.chars().count()) / 2).then_some(close)
}

/// How many letters must be added, removed or replaced to turn one word into the other (Levenshtein, 1965).
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, &y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
