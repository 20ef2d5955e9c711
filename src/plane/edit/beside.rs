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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_of_what_is_near_enough_is_found() {
        let at = |x: f64, y: f64| Point::new(x, y);
        // A square round a loose point.
        let points = [at(0., 0.), at(8., 0.), at(8., 8.), at(0., 8.), at(3., 4.)];
        let s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]]).expect("a square");
        let f = FaceId::new(1);
        let vertex = |p: Point, near: f64| s.nearest_vertex(f, p, near).map(VertexId::number);
        assert_eq!(vertex(at(0., 0.), 0.0), Some(0));
        // 3, 4 and 5 off.
        assert_eq!((vertex(at(6., 8.), 5.0), vertex(at(6., 8.), 1.9)), (Some(2), None));
        assert_eq!((vertex(at(3., 8.), 4.0), vertex(at(3., 8.), 2.9)), (Some(3), None));
        assert_eq!((vertex(at(0., 0.5), 9.0), vertex(at(3., 0.), 3.0)), (Some(0), Some(0)));
        assert_eq!((vertex(at(6., 4.), 3.0), vertex(at(6., 4.), 2.9)), (Some(4), None));
        assert_eq!((vertex(at(3., 1.), 3.0), vertex(at(3., 7.), 3.0)), (Some(4), Some(4)));

        let upper = |h: HalfEdgeId| s.point(s.origin(h)).y > 7.0;
        let side = |p: Point, near: f64| {
            s.nearest_half_edge(f, p, near, |h| !upper(h))
                .map(|h| [s.origin(h), s.destination(h)].map(VertexId::number))
        };
        assert_eq!((side(at(4., 1.), 1.0), side(at(4., 1.), 0.9)), (Some([0, 1]), None));
        assert_eq!(side(at(7.5, 6.), 2.0), Some([1, 2]));
        // Behind the end of a side, and nearest to one that is not wanted.
        assert_eq!((side(at(-3., -4.), 5.0), side(at(-3., -4.), 4.9)), (Some([0, 1]), None));
        assert_eq!(side(at(4., 7.), 9.0), Some([1, 2]));
    }
}
