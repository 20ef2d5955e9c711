//! Rings are joined to the rest of their face by bridges, exactly.
//!
//! ```text
//!    ●───────── ceiling ────────●      From m, the leftmost vertex of a ring, look up and down to the edges of the
//!        q                             face straight above and below. Of the corners before m between these two,
//!       ● · · · · · · ● m              the last one, q, sees m: nothing of the face comes after it.
//!      ╱               ╲  ring
//!    ●───────── floor ──────────●      Rings are taken from left to right, so that q belongs to what is joined.
//! ```
//!
//! It is the helper of `monotone.rs`, found by a plain look at the whole face.

use super::TriangulateError;
use super::patch::{Part, Patch, PatchRing};
use crate::plane::Point;
use crate::plane::cycle::in_corner;
use crate::plane::predicates::orientation;
use crate::plane::sweep::is_above;

/// Joins all rings of the patch to the boundaries of their faces. O(n) for each ring of a face of n corners.
///
/// # Errors
/// [`TriangulateError::NotPlanar`] if a ring lies outside its face.
pub(super) fn join_rings(patch: &mut Patch) -> Result<(), TriangulateError> {
    for i in 0..patch.parts.len() {
        let Part { first, end, rings: [from, to] } = patch.parts[i];
        let mut rings: Vec<(u32, PatchRing)> =
            (from..to).map(|ring| (patch.place_of(ring), patch.rings[ring as usize])).collect();
        rings.sort_unstable_by_key(|&(place, _)| place);
        let bridges = patch.len();
        for (m, ring) in rings {
            // Corners at bridges joined before count, too.
            let corners = || (first..end).chain(bridges..patch.len());
            let helper = helper(patch, first..end, corners(), m);
            let helper = helper.ok_or_else(|| patch.fault_at(m, patch.face(first)))?;
            match ring {
                PatchRing::Isolated(..) => patch.join_isolated(m, helper),
                PatchRing::Cycle(start, last) => {
                    let corner = corner_towards(patch, start..last + 1, m, patch.point(helper));
                    patch.join(corner.ok_or_else(|| patch.fault(start))?, helper)
                }
            };
        }
    }
    Ok(())
}

/// The corner that a bridge from the place `m` leads to.
fn helper(
    patch: &Patch,
    given: impl Iterator<Item = u32>,
    corners: impl Iterator<Item = u32> + Clone,
    m: u32,
) -> Option<u32> {
    let p = patch.points[m as usize];
    let (mut floor, mut ceiling): (Option<[u32; 2]>, Option<[u32; 2]>) = (None, None);
    let at = |[a, b]: [u32; 2]| [a, b].map(|place| patch.points[place as usize]);
    for h in given {
        let (a, b) = (patch.origin(h), patch.origin(patch.next(h)));
        // The face lies above a half-edge that runs to the right, and below one that runs to the left.
        if a < m && m < b && orientation(at([a, b])[0], at([a, b])[1], p).is_gt() {
            if floor.is_none_or(|best| is_above(at([a, b]), at(best))) {
                floor = Some([a, b]);
            }
        } else if b < m
            && m < a
            && orientation(at([b, a])[0], at([b, a])[1], p).is_lt()
            && ceiling.is_none_or(|best| is_above(at(best), at([b, a])))
        {
            ceiling = Some([b, a]);
        }
    }
    let (floor, ceiling) = (floor?, ceiling?);
    let ([f, to_f], [c, to_c]) = (at(floor), at(ceiling));
    let first = floor[0].max(ceiling[0]);
    let between = |place: u32| {
        let q = patch.points[place as usize];
        first <= place
            && place < m
            && (place == floor[0] || orientation(f, to_f, q).is_gt())
            && (place == ceiling[0] || orientation(c, to_c, q).is_lt())
    };
    let last = corners.clone().map(|h| patch.origin(h)).filter(|&place| between(place)).max()?;
    corner_towards(patch, corners, last, p)
}

/// Of the corners, that at the given place which the direction to `p` leads into.
fn corner_towards(patch: &Patch, mut corners: impl Iterator<Item = u32>, place: u32, p: Point) -> Option<u32> {
    corners.find(|&h| {
        let around = [patch.prev(h), h, patch.next(h)].map(|h| patch.point(h));
        patch.origin(h) == place && in_corner(around, p)
    })
}
