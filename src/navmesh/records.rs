//! The records of the faces, with next to no room for what is no face of the mesh.
//!
//! ```text
//!   number     f0  f1  f2  f3  f4  f5  f6  f7      Maps that list blocked polygons, too, have as many numbers of holes
//!   of mesh     0   1   1   0   0   1   0   1      as of faces. A bit says which is which; how many bits are set before
//!   slot            0   1           2       3      a face is its slot. The holes are counted in the same way.
//! ```
//!
//! A map with few holes has a record for each number, and its slot is its number.
//!
//! Memory: 12 bytes a face, and a bit and a half a number; or 12 bytes a number.

use super::marks::FaceRecord;
use std::ops::{Index, IndexMut};

/// The records of the faces by their numbers.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct FaceTable {
    records: Vec<FaceRecord>,
    /// Which numbers have a record, if not all have one.
    ranks: Option<Ranks>,
}

/// A set of numbers in which those before any number are counted in O(1).
#[derive(Clone, PartialEq, Debug)]
struct Ranks {
    bound: usize,
    /// A bit for each number.
    words: Vec<u64>,
    /// How many bits are set before each word.
    before: Vec<u32>,
}

impl Ranks {
    fn new(bound: usize, has: impl Fn(usize) -> bool) -> Self {
        let word = |i: usize| (64 * i..bound.min(64 * i + 64)).fold(0, |word, f| word | u64::from(has(f)) << (f % 64));
        let words: Vec<u64> = (0..bound.div_ceil(64)).map(word).collect();
        let before = words.iter().scan(0, |count, word| {
            *count += word.count_ones();
            Some(*count - word.count_ones())
        });
        let before = before.collect();
        Self { bound, words, before }
    }

    /// How many numbers of the set are smaller than `f`, and whether `f` is one of the set.
    #[inline]
    fn rank(&self, f: usize) -> (usize, bool) {
        let (word, bit) = (self.words[f / 64], 1 << (f % 64));
        // Faces and holes often come in long runs, and not every processor is told to count bits at once.
        let below = if word == u64::MAX { f % 64 } else { (word & (bit - 1)).count_ones() as usize };
        (self.before[f / 64] as usize + below, word & bit != 0)
    }
}

impl FaceTable {
    /// No face, and this many numbers; `has` tells which are going to have a record. O(n).
    pub(super) fn new(bound: usize, has: impl Fn(usize) -> bool) -> Self {
        let count = (0..bound).filter(|&f| has(f)).count();
        if bound - count <= 64 + bound / 16 {
            return Self { records: vec![FaceRecord::ABSENT; bound], ranks: None };
        }
        Self { records: vec![FaceRecord::ABSENT; count], ranks: Some(Ranks::new(bound, has)) }
    }

    /// One more than the greatest number.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.ranks.as_ref().map_or(self.records.len(), |ranks| ranks.bound)
    }

    /// Where the record of a number is, if it has one.
    #[inline]
    pub(super) fn slot(&self, f: usize) -> Option<usize> {
        match &self.ranks {
            None => Some(f),
            Some(ranks) => {
                let (slot, has) = ranks.rank(f);
                has.then_some(slot)
            }
        }
    }

    /// Which of the numbers without a record this is, from 0; `None` if all have one.
    pub(super) fn hole_slot(&self, f: usize) -> Option<usize> {
        self.ranks.as_ref().map(|ranks| f - ranks.rank(f).0)
    }

    #[inline]
    pub(super) fn get(&self, f: usize) -> Option<&FaceRecord> {
        (f < self.len()).then(|| &self[f])
    }

    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut FaceRecord> {
        self.records.iter_mut()
    }

    /// Gives every number below `bound` a record. O(n) the first time where not all have one.
    pub(super) fn resize(&mut self, bound: usize) {
        if self.ranks.is_some() {
            self.records = (0..self.len()).map(|f| self[f]).collect();
            self.ranks = None;
        }
        self.records.resize(bound.max(self.records.len()), FaceRecord::ABSENT);
    }

    pub(super) fn memory(&self) -> usize {
        let ranks = self.ranks.as_ref();
        size_of_val(&*self.records) + ranks.map_or(0, |r| size_of_val(&*r.words) + size_of_val(&*r.before))
    }
}

impl Index<usize> for FaceTable {
    type Output = FaceRecord;

    #[inline]
    fn index(&self, f: usize) -> &FaceRecord {
        self.slot(f).map_or(&FaceRecord::ABSENT, |slot| &self.records[slot])
    }
}

impl IndexMut<usize> for FaceTable {
    /// # Panics
    /// If the number has no record.
    #[inline]
    fn index_mut(&mut self, f: usize) -> &mut FaceRecord {
        let slot = self.slot(f).expect("a face of the mesh has a record");
        &mut self.records[slot]
    }
}

#[cfg(test)]
mod tests {
    use super::{FaceRecord, FaceTable};

    #[test]
    fn slots_are_counted_through_long_runs_of_faces_and_of_holes() {
        for (holes, faces) in [(100, 200), (64, 128), (1, 400), (300, 65)] {
            let has = |f: usize| f % (holes + faces) >= holes;
            let table = FaceTable::new(2000, has);
            let ranks = table.ranks.is_some();
            let slots = (0..2000).scan(0, |slot, f| {
                *slot += usize::from(has(f));
                Some(has(f).then(|| *slot - 1))
            });
            for (f, slot) in slots.enumerate() {
                assert_eq!(table.slot(f), if ranks { slot } else { Some(f) }, "{f}, {holes} holes, {faces} faces");
            }
            assert_eq!(ranks, holes > 1, "many holes, or few");
        }
    }

    #[test]
    fn slots_are_counted_among_faces_and_among_holes() {
        for (bound, every) in [(1, 2), (64, 2), (65, 2), (1000, 3), (1000, 64), (5000, 7)] {
            let has = |f: usize| f % every == 1;
            let mut table = FaceTable::new(bound, has);
            let (mut slots, mut holes) = (0, 0);
            for f in 0..bound {
                if has(f) {
                    table[f] = FaceRecord::new(f, f + 3);
                }
                if table.ranks.is_some() {
                    assert_eq!(table.slot(f), has(f).then_some(slots), "{f} of {bound}, every {every}");
                    assert!(has(f) || table.hole_slot(f) == Some(holes), "{f} of {bound}, every {every}");
                }
                *if has(f) { &mut slots } else { &mut holes } += 1;
            }
            let check = |table: &FaceTable| {
                for f in 0..bound {
                    let range = if has(f) { f..f + 3 } else { 0..0 };
                    assert_eq!(table[f].range(), range, "{f} of {bound}, every {every}");
                }
            };
            check(&table);
            // 12 bytes a face, and a bit and a half a number; or 12 bytes a number.
            let few_holes = table.ranks.is_none();
            let bytes = if few_holes { 12 * bound } else { 12 * slots + 12 * bound.div_ceil(64) };
            assert_eq!(table.memory(), bytes, "{bound}, every {every}");
            assert_eq!((table.len(), table.get(bound)), (bound, None));
            table.resize(bound + 3);
            check(&table);
            assert_eq!((table.len(), table[bound + 2]), (bound + 3, FaceRecord::ABSENT));
        }
    }
}
