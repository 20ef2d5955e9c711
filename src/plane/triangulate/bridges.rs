//! Inner components are joined to the rest of their face by bridges, exactly.
//!
//! ```text
//!    ●───────── ceiling ────────●      From m, the leftmost vertex of an inner component, look up and down to the edges of the
//!        q                             face straight above and below. Of the corners before m between these two,
//!       ● · · · · · · ● m              the last one, q, sees m: nothing of the face comes after it.
//!      ╱               ╲  inner component
//!    ●───────── floor ──────────●      Inner components are taken from left to right, so that q belongs to what is joined.
//! ```
//!
//! It is the helper of `monotone.rs`, found by a plain look at the whole face.

use super::TriangulateError;
use super::patch::{Part, Patch, PatchComponent};
use crate::geometry::predicates::orientation;
use crate::plane::Point;
use crate::plane::cycle::in_corner;
use crate::plane::sweep::is_above;

/// Joins all inner components of the patch to the boundaries of their faces. O(n) for each inner component of a face of n corners.
///
/// # Errors
/// [`TriangulateError::NotPlanar`] if an inner component lies outside its face.
pub(super) fn join_inner_components(patch: &mut Patch) -> Result<(), TriangulateError> {
    for i in 0..patch.parts.len() {
        let Part { first, end, rings: [from, to] } = patch.parts[i];
        let mut rings: Vec<(u32, PatchComponent)> =
            (from..to).map(|ring| (patch.place_of(ring), patch.rings[ring as usize])).collect();
        rings.sort_unstable_by_key(|&(place, _)| place);
        let bridges = patch.len();
        for (m, ring) in rings {
            // Corners at bridges joined before count, too.
            let corners = || (first..end).chain(bridges..patch.len());
            let helper = helper(patch, first..end, corners(), m);
            let helper = helper.ok_or_else(|| patch.fault_at(m, patch.face(first)))?;
            match ring {
                PatchComponent::Isolated(..) => patch.join_isolated(m, helper),
                PatchComponent::Cycle(start, last) => {
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
        let edge = [a.min(b), a.max(b)];
        if m <= edge[0] || edge[1] <= m {
            continue;
        }
        // The face lies above a half-edge that runs to the right, and below one that runs to the left.
        let [from, to] = at(edge);
        let side = orientation(from, to, p);
        if a < b && side.is_gt() && floor.is_none_or(|best| is_above([from, to], at(best))) {
            floor = Some(edge);
        }
        if b < a && side.is_lt() && ceiling.is_none_or(|best| is_above(at(best), [from, to])) {
            ceiling = Some(edge);
        }
    }
    let (floor, ceiling) = (floor?, ceiling?);
    let ([f, to_f], [c, to_c]) = (at(floor), at(ceiling));
    let first = floor[0].max(ceiling[0]);
    let between = |place: u32| {
        let q = patch.points[place as usize];
        first <= place && place < m && orientation(f, to_f, q).is_ge() && orientation(c, to_c, q).is_le()
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
