//! Numbers that look random and are the same on every machine: a seed is enough to ask the same cases again.

/// A generator of numbers from a seed.
///
/// Source: SplitMix64, Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator of a seed. `stream` tells the users of one seed apart.
    #[must_use]
    pub fn new(seed: u64, stream: &str) -> Self {
        Self(stream.bytes().fold(seed, |state, byte| mix(state ^ u64::from(byte))))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mix(self.0)
    }

    /// A number below `bound`, which is above 0.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound.max(1) as u64) as usize
    }

    /// One of some things; `None` if there are none.
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> Option<&'a T> {
        from.get(self.below(from.len()))
    }

    /// So many different points with whole coordinates from 0 up to `size`.
    pub fn places(&mut self, count: usize, size: usize) -> Vec<[f64; 2]> {
        let mut all: Vec<[f64; 2]> = Vec::new();
        while all.len() < count {
            let p = [self.below(size) as f64, self.below(size) as f64];
            if !all.contains(&p) {
                all.push(p);
            }
        }
        all
    }

    /// The numbers below `count` in some order (Fisher and Yates).
    pub fn order(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A seed that nobody knows beforehand.
#[must_use]
pub fn fresh_seed() -> u64 {
    use std::hash::{BuildHasher, Hasher};
    // The standard library seeds its hashers from the system. A short number is typed more easily.
    std::hash::RandomState::new().build_hasher().finish() % 1_000_000_000
}
