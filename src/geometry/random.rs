//! Numbers that look random and are the same on every machine.

/// The numbers of a seed, for the tests alone.
///
/// Source: Marsaglia, *Xorshift RNGs*, 2003.
#[cfg(test)]
pub(crate) fn xorshift(mut state: u64) -> impl FnMut() -> u64 {
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    }
}

/// The next 64 bits.
///
/// Source: SplitMix64, Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014.
#[cfg(any(feature = "navmesh", feature = "play", feature = "solid"))]
pub(crate) fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
