//! Constrained Delaunay triangles: the whole subdivision is triangulated so, and the faces take over what lies in them.
//!
//! ```text
//!    the triangulation of all vertices            the patch
//!    ●━━━━━━━●┄┄┄┄┄┄●                             ●━━━━━━━●
//!    ┃╲      ┃ ╲    ┊    ━ edges that stay        ┃╲      ┃    each half-edge has the same next one
//!    ┃  ╲    ┃   ╲  ┊    ─ diagonals              ┃  ╲    ┃    in both
//!    ┃    ╲  ┃     ╲┊    ┄ outside: left out      ┃    ╲  ┃
//!    ●━━━━━━━●┄┄┄┄┄┄●                             ●━━━━━━━●
//! ```

use super::TriangulateError;
use super::patch::Patch;
use crate::ids::{FaceMap, HalfEdgeMap, VertexMap};
use crate::plane::Subdivision;

/// The number of a half-edge that is not in the patch.
const NONE: u32 = u32::MAX;

/// Cuts the faces of the patch into triangles. O(n log n) for all n vertices of the subdivision, besides the edges that
/// have to be made by flips.
pub(super) fn triangulate(patch: &mut Patch, s: &Subdivision) -> Result<(), TriangulateError> {
    if patch.parts.is_empty() {
        return Ok(());
    }
    let (made, marked) = s.constrained_halves()?;
    let dcel = &made.subdivision.dcel;
    let mut own = HalfEdgeMap::filled(s.dcel.half_edge_bound(), NONE);
    let mut place = VertexMap::filled(s.dcel.vertex_bound(), NONE);
    let mut is_cut = FaceMap::filled(s.dcel.face_bound(), false);
    for (i, h) in patch.given_half_edges().iter().enumerate() {
        own[*h] = i as u32;
        is_cut[s.dcel.face(*h)] = true;
    }
    patch.vertices().iter().enumerate().for_each(|(i, &v)| place[v] = i as u32);

    let mut number = HalfEdgeMap::filled(dcel.half_edge_bound(), NONE);
    for (h, g) in marked {
        let is_same = [(h, g), (h.twin(), g.twin())].iter().all(|&(h, g)| dcel.origin(h) == s.dcel.origin(g));
        if let (false, Some(&i)) = (is_same, [own[g], own[g.twin()]].iter().find(|&&i| i != NONE)) {
            // Another edge crosses it.
            return Err(patch.fault(i));
        }
        (number[h], number[h.twin()]) = (own[g], own[g.twin()]);
    }
    for e in dcel.edges().filter(|&e| !made.constrained[e]) {
        let [h, t] = e.half_edges();
        let face = made.faces[dcel.face(h)];
        if is_cut[face] {
            let ends = [h, t].map(|h| place[dcel.origin(h)]);
            number[h] = patch.add(ends[0], ends[1], face);
            number[t] = number[h] + 1;
        }
    }
    for h in dcel.half_edges().filter(|&h| number[h] != NONE) {
        let next = number[dcel.next(h)];
        if next == NONE {
            return Err(patch.fault(number[h]));
        }
        patch.follow(number[h], next);
    }
    Ok(())
}
