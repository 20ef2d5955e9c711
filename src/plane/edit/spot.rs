//! Where a point lies, and what lies on the way between two points: plain looks at everything in question.
//!
//! ```text
//!        ╱ h1
//!       ●────── h0        From a vertex, a direction leads along an edge or into exactly one corner.
//!        · · · >
//! ```

use super::Obstacle;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::{in_corner, on_segment, same_direction, surrounds};
use crate::plane::sweep::cross;
use crate::plane::{Point, Subdivision};
use crate::topology::InnerComponent;

/// Where a direction leads from a vertex.
pub(in crate::plane) enum Towards {
    /// Along the half-edge.
    Along(HalfEdgeId),
    /// Into the corner at the origin of the half-edge, on its left.
    Corner(HalfEdgeId),
    /// Into the face around a vertex without edges.
    Open(FaceId),
}

impl Subdivision {
    /// Where the point lies if not inside `f`: on a vertex or edge of it, or somewhere else.
    ///
    /// Cost: O(size of the face); exact.
    pub(super) fn lies_in(&self, f: FaceId, p: Point) -> Result<(), Option<Element>> {
        if let Some(v) = self.isolated_vertices(f).find(|&v| self.points[v] == p) {
            return Err(Some(v.into()));
        }
        for g in self.all_half_edges(f) {
            let (v, to) = (self.dcel.origin(g), self.points[self.dcel.destination(g)]);
            if self.points[v] == p {
                return Err(Some(v.into()));
            }
            if to != p && on_segment(self.points[v], to, p) {
                return Err(Some(g.into()));
            }
        }
        // An even number of crossings over all cycles is the outside; for f0 that is the inside.
        let odd = self.cycles(f).filter(|&h| surrounds(self.corner_points(h), p)).count() % 2 == 1;
        if odd == (f != self.outer_face()) { Ok(()) } else { Err(None) }
    }

    /// Where the direction from `v` to `to` leads. O(degree), or O(inner components of all faces) for an isolated vertex.
    pub(in crate::plane) fn towards(&self, v: VertexId, to: Point) -> Towards {
        let at = self.points[v];
        for h in self.dcel.outgoing_half_edges(v) {
            let after = self.points[self.dcel.destination(h)];
            if same_direction(at, after, to) {
                return Towards::Along(h);
            }
        }
        for h in self.dcel.outgoing_half_edges(v) {
            let after = self.points[self.dcel.destination(h)];
            let before = self.points[self.dcel.origin(self.dcel.prev(h))];
            if in_corner([before, at, after], to) {
                return Towards::Corner(h);
            }
        }
        Towards::Open(self.face_around(v))
    }

    /// The face in which a vertex without edges lies. O(inner components of all faces).
    pub(super) fn face_around(&self, v: VertexId) -> FaceId {
        let lists = |(_, rings): &(&FaceId, &Vec<InnerComponent>)| rings.contains(&InnerComponent::Isolated(v));
        self.inner_components.iter().find(lists).map_or(self.outer_face(), |(&f, _)| f)
    }

    /// Calls `meet` for everything of the face `f` on the way from `a` to `b`, ends excluded: vertices on it, edges
    /// across it. Ends when `meet` gives an answer. O(size of the face).
    pub(super) fn find_on_way<T>(
        &self,
        f: FaceId,
        [a, b]: [Point; 2],
        mut meet: impl FnMut(Obstacle) -> Option<T>,
    ) -> Option<T> {
        let between = |p: Point| p != a && p != b && on_segment(a, b, p);
        for v in self.isolated_vertices(f).filter(|&v| between(self.points[v])) {
            if let Some(found) = meet(Obstacle::Vertex(v)) {
                return Some(found);
            }
        }
        for g in self.all_half_edges(f) {
            let (v, to) = (self.dcel.origin(g), self.points[self.dcel.destination(g)]);
            let found = if between(self.points[v]) {
                meet(Obstacle::Vertex(v))
            } else if cross(a, b, self.points[v], to) {
                meet(Obstacle::Edge(g))
            } else {
                None
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }
}
