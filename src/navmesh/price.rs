//! What a way costs where a unit of length costs more in some faces than in others.
//!
//! ```text
//!          dear           The way is taken apart where it passes from face to face. Along an open side it may be walked on
//!   s ━━━━━━━━━━━━━ t     either hand, so the cheaper of the two faces counts there. A closed side, a wall, counts for the
//!          cheap          face that it is walked in.
//! ```

use super::funnel::Endpoint;
use super::marks::{CLOSED, ID};
use super::nearest::distance;
use super::steps::{End, steps};
use super::{NavMesh, Route};
use crate::ids::{FaceId, FaceMap};
use crate::plane::Point;
use crate::plane::predicates::orientation;

impl NavMesh {
    /// What a route costs if a unit of length in a face costs as much as `costs` says: the path is taken apart where it
    /// passes from face to face. Along an open edge the cheaper of its two faces counts, whichever the route names; along a
    /// closed one the face that the route is in. Whether a piece runs along an edge is exact.
    ///
    /// Cost: O(sides of its faces).
    ///
    /// # Panics
    /// If `costs` has no entry for a face of the route, or for one beside it.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
    /// use dcel_kit::{FaceId, FaceMap, plane::{Point, Subdivision}};
    /// // Mud below, grass above.
    /// let points = [(0., 0.), (2., 0.), (2., 1.), (0., 1.), (2., 2.), (0., 2.)].map(Point::from);
    /// let mut fields = dcel_kit::topology::PolygonList::new();
    /// [[0, 1, 2, 3], [3, 2, 4, 5]].iter().for_each(|field| fields.push_face(field));
    /// let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &fields)?)?;
    /// let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
    /// costs[FaceId::new(1)] = 5.0;
    /// let [start, goal] = [mesh.place(Point::new(0.5, 1.0))?, mesh.place(Point::new(1.5, 1.0))?];
    /// let route = Planner::new().weighted_route(&mesh, PathAlgorithm::Closest, &costs, &start, &goal)?;
    /// assert_eq!((route.length, mesh.cost_along(&route, &costs)), (1.0, 1.0), "on the grass");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn cost_along(&self, route: &Route, costs: &FaceMap<f64>) -> f64 {
        let [Some(&start), Some(&goal)] = [route.points.first(), route.points.last()] else { return 0.0 };
        let endpoint = |&v: &crate::ids::VertexId| Endpoint::at(self, v);
        let portals: Vec<[Endpoint; 2]> =
            route.portal_ends(self).map(|portal| [portal.left, portal.right].map(|v| endpoint(&v))).collect();
        let ends = [start, goal].map(Endpoint::free);
        let path: Vec<Endpoint> =
            std::iter::once(ends[0]).chain(route.corners.iter().map(endpoint)).chain([ends[1]]).collect();
        let (mut cost, mut last) = (0.0, start);
        // Which straight piece of the path is being walked.
        let mut piece = 0;
        for step in steps(&portals, &path) {
            let line = [path[piece], path[piece + 1]].map(|endpoint| endpoint.point);
            let at = match step.end {
                End::Portal(d, share) => {
                    let [left, right] = portals[d].map(|endpoint| endpoint.point);
                    Point::new(right.x + (left.x - right.x) * share, right.y + (left.y - right.y) * share)
                }
                End::Endpoint(k) => {
                    piece = k;
                    path[k].point
                }
            };
            cost += self.cost_of_stretch(route.faces[step.face], line, [last, at], costs);
            last = at;
        }
        cost
    }

    /// What a stretch of a line costs that lies in a face.
    fn cost_of_stretch(&self, f: FaceId, [p, q]: [Point; 2], ends: [Point; 2], costs: &FaceMap<f64>) -> f64 {
        let cost = |f: FaceId| costs[f].max(0.0);
        let (own, length) = (cost(f), distance(ends[0], ends[1]));
        if p == q || length <= 0.0 {
            return length * own;
        }
        // How far along the line a point of it is.
        let along = |r: Point| ((r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y)) / distance(p, q);
        let [from, to] = ends.map(along);
        let (mut rest, mut sum) = (length, 0.0);
        for s in self.range(f) {
            let across = self.sides[s].across;
            if across & CLOSED != 0 {
                continue;
            }
            let other = cost(FaceId::new(across & ID));
            let side = self.ends(f, s).map(|v| self.point(v));
            if other >= own || side.iter().any(|&end| orientation(p, q, end).is_ne()) {
                continue;
            }
            let [low, high] = side.map(along);
            let (low, high) = (low.min(high), low.max(high));
            // All of the stretch, to the last digit, where the side has all of it.
            let part = if low <= from && to <= high { rest } else { (to.min(high) - from.max(low)).clamp(0.0, rest) };
            sum += part * other;
            rest -= part;
        }
        sum + rest * own
    }
}
