//! Edges with a gap on both sides, which no face of the mesh has.
//!
//! ```text
//!   ┌──────┐  f0        Such an edge tells two gaps apart just as the side of a face does: a ray from a point in a gap
//!   │ hole ├────        has to know of it.
//!   └──────┘
//! ```

use super::NavMesh;
use crate::ids::{EdgeId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};

/// An edge between two gaps: between a hole and the outer face.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct GapEdge {
    /// The ends, the lower one first.
    pub(super) ends: [VertexId; 2],
    /// The names of the gaps on the left and on the right.
    pub(super) gaps: [u32; 2],
}

impl GapEdge {
    /// All edges of the map between two different gaps. O(n).
    pub(super) fn all(map: &Subdivision, mesh: &NavMesh) -> Vec<Self> {
        let halves = map.edges().flat_map(EdgeId::half_edges);
        let is_up = |h: &HalfEdgeId| map.point(map.origin(*h)).y <= map.point(map.destination(*h)).y;
        let between = |h: &HalfEdgeId| {
            let gaps = [map.face(*h), map.face(h.twin())];
            gaps[0] != gaps[1] && !gaps.into_iter().any(|f| mesh.has_face(f))
        };
        let edge = |h: HalfEdgeId| Self {
            ends: [map.origin(h), map.destination(h)],
            gaps: [map.face(h), map.face(h.twin())].map(|f| mesh.gap_name(f.number())),
        };
        halves.filter(is_up).filter(between).map(edge).filter(|edge| edge.gaps[0] != edge.gaps[1]).collect()
    }

    pub(super) fn points(&self, mesh: &NavMesh) -> [Point; 2] {
        self.ends.map(|v| mesh.point(v))
    }
}
