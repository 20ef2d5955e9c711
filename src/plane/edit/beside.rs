//! What of a face lies next to a point, and how near that is.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};

/// How near things are that may be apart by rounding only: the 2^-47th part of the greatest coordinate, some last places.
///
/// ```
/// use dcel_kit::plane::{Point, rounding_room};
/// assert_eq!(rounding_room([Point::new(1.0, -4.0), Point::new(3.0, 2.0)]), 2f64.powi(-45));
/// ```
#[must_use]
pub fn rounding_room(points: impl IntoIterator<Item = Point>) -> f64 {
    points.into_iter().map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max) * 2f64.powi(-47)
}

impl Subdivision {
    /// The vertices in a face and on its cycles, as often as they are passed. O(size of the face).
    pub(super) fn vertices_of_face(&self, f: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        self.isolated_vertices(f).chain(self.all_half_edges(f).map(|h| self.dcel.origin(h)))
    }

    /// The vertex of a face that is nearest to a point, if it is not farther off than `near`.
    pub(crate) fn nearest_vertex(&self, f: FaceId, p: Point, near: f64) -> Option<VertexId> {
        let off = |v: VertexId| (self.points[v].x - p.x).hypot(self.points[v].y - p.y);
        let beside = self.vertices_of_face(f).map(|v| (off(v), v)).filter(|&(off, _)| off <= near);
        beside.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, v)| v)
    }

    /// The half-edge of a face that is nearest to a point, of those that are not farther off than `near` and `wanted`.
    pub(crate) fn nearest_half_edge(
        &self,
        f: FaceId,
        p: Point,
        near: f64,
        wanted: impl Fn(HalfEdgeId) -> bool,
    ) -> Option<HalfEdgeId> {
        let off = |h: HalfEdgeId| {
            let [a, b] = [self.dcel.origin(h), self.dcel.destination(h)].map(|v| self.points[v]);
            let [x, y] = [b.x - a.x, b.y - a.y];
            let along = (((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y)).clamp(0.0, 1.0);
            (p.x - a.x - along * x).hypot(p.y - a.y - along * y)
        };
        let beside = self.all_half_edges(f).map(|h| (off(h), h)).filter(|&(off, h)| off <= near && wanted(h));
        beside.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, h)| h)
    }
}
