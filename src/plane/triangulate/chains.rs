//! Monotone pieces into triangles, each in one pass from left to right.
//!
//! ```text
//!        ●───────●              The vertices seen so far and not yet cut off are a chain that bends away from the
//!       ╱         ╲             inside, on one side of the piece:
//!      ●   stack   v            - v on the other side sees all of it: cut off everything;
//!       ╲                       - v on the same side sees some of it: cut off while the corner before v is convex.
//!        ●──●──●─ ─ ─
//! ```
//!
//! The chain needs no stack: it hangs together by the links, and its length is enough. A straight corner stays, so no
//! triangle is flat.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 3.3.

use super::MonotoneEvent;
use super::patch::Patch;
use crate::topology::Observer;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Lower,
    Upper,
}

/// Cuts the monotone pieces of the patch into triangles. O(n).
pub(super) fn triangulate(patch: &mut Patch, observer: &mut impl Observer<MonotoneEvent>) {
    let begins = |&h: &u32| {
        let here = patch.origin(h);
        here < patch.origin(patch.next(h)) && here < patch.origin(patch.prev(h))
    };
    let starts: Vec<u32> = (0..patch.len()).filter(begins).collect();
    starts.into_iter().for_each(|start| piece(patch, start, observer));
}

/// Cuts up the piece whose leftmost corner is that of `start`.
fn piece(patch: &mut Patch, start: u32, observer: &mut impl Observer<MonotoneEvent>) {
    // The next corners to come, along the lower side and along the upper one.
    let (mut lower, mut upper) = (patch.next(start), patch.prev(start));
    let (mut chain, mut side) = (1_u32, Side::Lower);
    while lower != upper {
        let from = if patch.origin(lower) < patch.origin(upper) { Side::Lower } else { Side::Upper };
        let h = if from == Side::Lower { lower } else { upper };
        match from {
            Side::Lower => lower = patch.next(h),
            Side::Upper => upper = patch.prev(h),
        }
        if chain > 1 && from != side {
            cut_all(patch, h, side, chain - 1, observer);
            chain = 2;
        } else {
            chain = cut_while_convex(patch, h, side, chain, observer) + 1;
        }
        side = from;
    }
    cut_all(patch, lower, side, chain.saturating_sub(2), observer);
}

/// Cuts off so many corners of the chain, from its left end on, as seen from the corner of `h`.
fn cut_all(patch: &mut Patch, mut h: u32, side: Side, corners: u32, observer: &mut impl Observer<MonotoneEvent>) {
    for _ in 0..corners {
        match side {
            Side::Lower => h = cut(patch, patch.next(h), observer),
            Side::Upper => drop(cut(patch, patch.prev(h), observer)),
        }
    }
}

/// Cuts off corners from the right end of the chain while they are convex, as seen from the corner of `h`, which is on
/// the same side. Returns the length of the chain left.
fn cut_while_convex(
    patch: &mut Patch,
    mut h: u32,
    side: Side,
    mut chain: u32,
    observer: &mut impl Observer<MonotoneEvent>,
) -> u32 {
    while chain > 1 {
        let corner = if side == Side::Lower { patch.prev(h) } else { patch.next(h) };
        if !patch.turn(corner).is_gt() {
            break;
        }
        let rest = cut(patch, corner, observer);
        if side == Side::Upper {
            h = rest;
        }
        chain -= 1;
    }
    chain
}

/// Cuts off the corner of `h`; returns the half-edge of the diagonal in what is left.
fn cut(patch: &mut Patch, h: u32, observer: &mut impl Observer<MonotoneEvent>) -> u32 {
    observer.observe(|| MonotoneEvent::Cut([patch.prev(h), h, patch.next(h)].map(|h| patch.vertex(patch.origin(h)))));
    patch.cut(h)
}
