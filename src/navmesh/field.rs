//! How far everything is from one place.
//!
//! ```text
//!        3.6 ●──────● 5.1       The shortest paths to all vertices, and so what can be reached within a length.
//!           ╱ ╲   ╱
//!      s · ●───● 2.2            At a double corner the nearer of its wedges counts.
//! ```

use super::{NavMesh, QueryPoint, Work};
use crate::ids::{FaceId, VertexId, VertexMap};

/// The lengths of the shortest paths from a place to the vertices of the mesh.
#[derive(Clone, PartialEq, Debug)]
pub struct DistanceField {
    /// The length to each vertex; infinite if it is further than the limit.
    lengths: VertexMap<f64>,
    limit: f64,
    start: QueryPoint,
    /// What it took.
    pub work: Work,
}

impl DistanceField {
    pub(super) fn new(mesh: &NavMesh, start: &QueryPoint, limit: f64) -> Self {
        let lengths = VertexMap::filled(mesh.vertex_bound(), f64::INFINITY);
        Self { lengths, limit, start: *start, work: Work::default() }
    }

    pub(super) fn see(&mut self, v: u32, length: f64) {
        let least = &mut self.lengths[VertexId::new(v)];
        if length < *least && length <= self.limit {
            *least = length;
        }
    }

    /// Makes it the lesser of its distances and of those of another field of the mesh that begins at a distance of `before`:
    /// from the nearer one of two starts, if that is 0. The limit and the start stay.
    pub fn join(&mut self, other: &Self, before: f64) {
        for (v, length) in other.lengths.iter().filter(|(_, length)| length.is_finite()) {
            self.see(v.number(), before + length);
        }
        self.work += other.work;
    }

    /// Where the ways start.
    #[must_use]
    pub fn start(&self) -> &QueryPoint {
        &self.start
    }

    /// The length of the shortest path to `v`; `None` if there is no vertex, no way, or none within the limit.
    #[must_use]
    pub fn distance(&self, v: VertexId) -> Option<f64> {
        self.lengths.get(v).copied().filter(|length| length.is_finite())
    }

    /// The faces of which every corner can be reached within the limit, in the order of their numbers.
    pub fn faces_within<'a>(&'a self, mesh: &'a NavMesh) -> impl Iterator<Item = FaceId> + 'a {
        let reached = move |f: &FaceId| mesh.is_walkable(*f) && mesh.corners(*f).all(|v| self.distance(v).is_some());
        mesh.faces().filter(reached)
    }
}
