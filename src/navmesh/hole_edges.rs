//! Edges with a hole on both sides, which no face of the mesh has.
//!
//! ```text
//!   ┌──────┐  f0        Such an edge tells two holes apart just as the side of a face does: a ray from a point in a hole
//!   │ hole ├────        has to know of it.
//!   └──────┘
//! ```

use super::NavMesh;
use crate::ids::{EdgeId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};

/// An edge between two holes: between a hole and the outer face.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct HoleEdge {
    /// The ends, the lower one first.
    pub(super) ends: [VertexId; 2],
    /// The names of the holes on the left and on the right.
    pub(super) holes: [u32; 2],
}

impl HoleEdge {
    /// All edges of the map between two different holes. O(n).
    pub(super) fn all(map: &Subdivision, mesh: &NavMesh) -> Vec<Self> {
        let halves = map.edges().flat_map(EdgeId::half_edges);
        let is_up = |h: &HalfEdgeId| map.point(map.origin(*h)).y <= map.point(map.destination(*h)).y;
        let between = |h: &HalfEdgeId| {
            let holes = [map.face(*h), map.face(h.twin())];
            holes[0] != holes[1] && !holes.into_iter().any(|f| mesh.has_face(f))
        };
        let edge = |h: HalfEdgeId| Self {
            ends: [map.origin(h), map.destination(h)],
            holes: [map.face(h), map.face(h.twin())].map(|f| mesh.hole_name(f.number())),
        };
        halves.filter(is_up).filter(between).map(edge).filter(|edge| edge.holes[0] != edge.holes[1]).collect()
    }

    pub(super) fn points(&self, mesh: &NavMesh) -> [Point; 2] {
        self.ends.map(|v| mesh.point(v))
    }
}
