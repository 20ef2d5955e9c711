//! A set of numbers below n that tells the next one after a given one, round and round.
//!
//! ```text
//!   level 1   1 . 1 1        a bit for each word below that is not empty
//!   level 0   0110 0000 0001 1000 ...      a bit for each number
//! ```
//!
//! Source: the trees of van Emde Boas, Kaas and Zijlstra, 1977, with words of 64 bits for the recursion.

/// Numbers in a ring.
#[derive(Default)]
pub(super) struct Candidates {
    /// From the bits of the numbers up to a single word.
    levels: Vec<Vec<u64>>,
}

const WORD: usize = 64;

impl Candidates {
    /// Begins with all numbers below `n`. O(n).
    pub(super) fn begin(&mut self, n: usize) {
        self.levels.clear();
        let mut bits = n;
        loop {
            let mut words = vec![u64::MAX; bits.div_ceil(WORD).max(1)];
            // In the last word only the bits of numbers below n.
            if let Some(last) = words.last_mut().filter(|_| !bits.is_multiple_of(WORD) || bits == 0) {
                *last = (1 << (bits % WORD)) - 1;
            }
            bits = words.len();
            self.levels.push(words);
            if bits == 1 {
                return;
            }
        }
    }

    /// Puts a number in. O(log n), to the base of 64; so are the following.
    pub(super) fn insert(&mut self, mut i: usize) {
        for words in &mut self.levels {
            words[i / WORD] |= 1 << (i % WORD);
            i /= WORD;
        }
    }

    /// Takes a number out.
    pub(super) fn remove(&mut self, mut i: usize) {
        for words in &mut self.levels {
            let word = &mut words[i / WORD];
            *word &= !(1 << (i % WORD));
            if *word != 0 {
                return;
            }
            i /= WORD;
        }
    }

    /// The first number from `i` on; after the last one comes the first of all. None if there is none.
    pub(super) fn next(&self, i: usize) -> Option<usize> {
        self.from(i).or_else(|| self.from(0))
    }

    fn from(&self, mut i: usize) -> Option<usize> {
        for level in 0..self.levels.len() {
            let words = &self.levels[level];
            let rest = words.get(i / WORD).map_or(0, |word| word & (u64::MAX << (i % WORD)));
            if rest != 0 {
                let mut found = i / WORD * WORD + rest.trailing_zeros() as usize;
                for below in self.levels[..level].iter().rev() {
                    found = found * WORD + below[found].trailing_zeros() as usize;
                }
                return Some(found);
            }
            i = i / WORD + 1;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn numbers_follow_each_other_as_in_an_ordered_set() {
        for n in [1, 2, 63, 64, 65, 200, 4096, 4097, 9000] {
            let (mut ring, mut set) = (Candidates::default(), BTreeSet::new());
            ring.begin(n);
            set.extend(0..n);
            let mut state = n;
            for _ in 0..3 * n {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let (i, word) = ((state >> 33) % n, state >> 20 & 7);
                if word == 0 {
                    ring.insert(i);
                    set.insert(i);
                } else {
                    ring.remove(i);
                    set.remove(&i);
                }
                let j = (state >> 13) % (n + 1);
                let expected = set.range(j..).next().or_else(|| set.first()).copied();
                assert_eq!(ring.next(j), expected, "{n}, {j}");
            }
        }
    }
}
