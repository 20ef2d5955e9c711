//! Colours: hashes of the surroundings that tell half-edges apart before any walk.
//!
//! ```text
//!   round 0: label and face of h      round r: the colours of h, next, prev, twin in round r - 1
//! ```
//!
//! Partners always have equal colours. Different half-edges may have equal colours, too, by symmetry or by
//! chance; nothing is concluded from that.

use super::world::World;

/// The rounds after which the colours are looked at.
const CHECKS: [u32; 4] = [4, 8, 16, 32];
/// Enough if the rarest colour is no more frequent than this (a turn of the whole structure often leaves two of
/// every kind), or if no new colours came up.
const RARE: usize = 2;

/// Mixes a value into a hash: multiply and fold, twice, with odd constants.
pub(super) fn mix(hash: u64, value: u64) -> u64 {
    let x = (hash ^ value.wrapping_mul(0x9e37_79b9_7f4a_7c15)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    let x = (x ^ (x >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    x ^ (x >> 29)
}

/// What the colours of a component tell about it.
pub(super) struct Look {
    /// Equal for equal components.
    pub(super) hash: u64,
    /// A half-edge of the rarest colour.
    pub(super) root: u32,
}

/// Colours the half-edges of one component, of which there must be one, and picks the root for walks.
pub(super) fn refine(world: &World, members: &[u32], face_class: &[u32], colour: &mut [u64]) -> Look {
    for &h in members {
        let i = h as usize;
        colour[i] = mix(u64::from(world.label[i]), u64::from(face_class[world.face[i] as usize]));
    }
    let mut fresh = vec![0; members.len()];
    let mut sorted = Vec::with_capacity(members.len());
    let (mut rounds, mut kinds) = (0, 0);
    let mut look = Look { hash: 0, root: members[0] };
    for check in CHECKS {
        for _ in rounds..check {
            for (fresh, &h) in fresh.iter_mut().zip(members) {
                let i = h as usize;
                let around = [world.next[i], world.prev[i], world.twin[i]];
                *fresh = around.iter().fold(colour[i], |hash, &g| mix(hash, colour[g as usize]));
            }
            members.iter().zip(&fresh).for_each(|(&h, &new)| colour[h as usize] = new);
        }
        rounds = check;
        sorted.clear();
        sorted.extend(members.iter().map(|&h| (colour[h as usize], h)));
        sorted.sort_unstable();
        look.hash = sorted.iter().fold(members.len() as u64, |hash, &(colour, _)| mix(hash, colour));
        let now = sorted.chunk_by(|a, b| a.0 == b.0).count();
        let rarest = sorted.chunk_by(|a, b| a.0 == b.0).min_by_key(|alike| alike.len());
        let rarity = rarest.map_or(0, <[_]>::len);
        look.root = rarest.map_or(members[0], |alike| alike[0].1);
        if rarity <= RARE || now == kinds {
            break;
        }
        kinds = now;
    }
    look
}
