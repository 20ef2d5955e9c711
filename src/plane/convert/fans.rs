//! Vertices where several fans of faces meet: links by angular order.
//!
//! ```text
//!        ╲ f1 ╱                Two fans touch at v. The matching of edges says nothing about what comes between
//!    g2   ╲  ╱   g1            them; the angles do: going counter-clockwise from one outgoing half-edge to the
//!    ──────● v─────            next, there is one corner, and it belongs to the face (or the border) on the
//!         ╱ ╲                  left of the first and on the right of the second.
//!        ╱ f2╲
//! ```

use super::ConvertError;
use crate::ids::{HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::plane::cycle::by_direction;
use crate::topology::{Dcel, NoRecorder};

/// Links all half-edges at the given vertices by angular order.
///
/// Cost: O(half-edges) to find those at the vertices, and O(d log d) for each vertex of degree d.
///
/// # Errors
/// [`ConvertError::OverlapAtVertex`] if faces overlap there. `face_number` translates a half-edge to the input
/// number of its face, `None` at the border.
pub(super) fn link_by_angle(
    dcel: &mut Dcel,
    points: &[Point],
    vertices: &[VertexId],
    face_number: impl Fn(&Dcel, HalfEdgeId) -> Option<u32>,
) -> Result<(), ConvertError> {
    if vertices.is_empty() {
        return Ok(());
    }
    let mut wanted = vec![false; dcel.vertex_bound()];
    vertices.iter().for_each(|v| wanted[v.index()] = true);
    let mut one_rings: Vec<(VertexId, HalfEdgeId)> =
        dcel.half_edges().map(|h| (dcel.origin(h), h)).filter(|(v, _)| wanted[v.index()]).collect();
    let to = |h: HalfEdgeId| points[dcel.destination(h).index()];
    one_rings.sort_unstable_by(|&(u, g), &(v, h)| {
        u.cmp(&v).then_with(|| by_direction(points[u.index()], to(g), to(h))).then(g.cmp(&h))
    });
    for one_ring in one_rings.chunk_by(|a, b| a.0 == b.0) {
        let v = one_ring[0].0;
        for (i, &(_, h)) in one_ring.iter().enumerate() {
            let after = one_ring[(i + 1) % one_ring.len()].1;
            let same_direction = one_ring.len() > 1
                && by_direction(
                    points[v.index()],
                    points[dcel.destination(h).index()],
                    points[dcel.destination(after).index()],
                )
                .is_eq();
            let (left, right) = (face_number(dcel, h), face_number(dcel, after.twin()));
            if same_direction || left != right {
                let others = [left, right, face_number(dcel, h.twin()), face_number(dcel, after)];
                let mut faces: Vec<u32> = others.into_iter().flatten().collect();
                faces.dedup();
                let (first, second) = (faces.first().copied().unwrap_or(0), faces.get(1).copied());
                return Err(ConvertError::OverlapAtVertex {
                    vertex: v.number(),
                    first,
                    second: second.unwrap_or(first),
                });
            }
            dcel.set_next(after.twin(), h, &mut NoRecorder);
        }
    }
    Ok(())
}
