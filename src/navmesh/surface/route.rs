//! What is found: routes, and fields of distances.

use super::super::Work;
use super::NavSurface;
use crate::ids::{FaceId, VertexId, VertexMap};

/// A path along a surface.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct SurfaceRoute {
    /// The faces in order.
    pub faces: Vec<FaceId>,
    /// The start; where the path passes an edge between faces of different slope or layer, or bends; the goal. From point
    /// to point the path is straight in space, and on the surface.
    pub points: Vec<[f64; 3]>,
    /// The layer of each piece from point to point.
    pub layers: Vec<usize>,
    /// The vertices that it bends round.
    pub corners: Vec<VertexId>,
    /// The length along the surface.
    pub length: f64,
    /// The same with the costs of the faces, if there are any.
    pub cost: f64,
    /// What it took to find.
    pub work: Work,
}

/// Why there is no path.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceRouteError {
    /// The surface does not lead from one place to the other.
    #[error("there is no path: {from} is in component {start}, {to} is in component {goal}")]
    Unreachable {
        /// A face at the start.
        from: FaceId,
        /// A face at the goal.
        to: FaceId,
        /// The component of the start.
        start: u32,
        /// The component of the goal.
        goal: u32,
    },
}

/// How far the vertices of a surface are from a place.
#[derive(Clone, PartialEq, Debug)]
pub struct SurfaceField {
    pub(super) lengths: VertexMap<f64>,
    /// What it took.
    pub work: Work,
}

impl SurfaceField {
    /// The least of the lengths at the nodes of each vertex.
    pub(super) fn over(surface: &NavSurface, work: Work, length: impl Fn(usize) -> f64) -> Self {
        let bound = surface.vertices.iter().max().map_or(0, |&v| v as usize + 1);
        let mut lengths = vec![f64::INFINITY; bound];
        for (node, &v) in surface.vertices.iter().enumerate() {
            lengths[v as usize] = lengths[v as usize].min(length(node));
        }
        Self { lengths: lengths.into(), work }
    }

    /// The length of the shortest path to `v`, along the surface; `None` if there is no vertex, no path, or none within
    /// the limit.
    #[must_use]
    pub fn distance(&self, v: VertexId) -> Option<f64> {
        self.lengths.get(v).copied().filter(|length| length.is_finite())
    }

    /// Makes it the lesser of its distances and of those of another field of the surface that begins at a distance of
    /// `before`: from the nearer one of two starts, if that is 0.
    pub fn join(&mut self, other: &Self, before: f64) {
        for (v, length) in other.lengths.iter() {
            self.lengths[v] = self.lengths[v].min(before + length);
        }
        self.work += other.work;
    }
}
