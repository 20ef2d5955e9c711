//! The edits of a subdivision: those of the kernel after an exact look at the geometry, and those that make and
//! break components.
//!
//! ```text
//!   split_face join_faces split_edge join_edges flip_edge     by half-edges, as the lab does
//!   insert_vertex insert_edge insert_dangling_edge        by points and vertices, wherever the faces and inner components are
//!   insert_segment                                  through everything
//!   set_point transform                             a vertex, or everything, moves
//!   remove_edge remove_vertex                       spot.rs  where is it     whole.rs  all steps or none
//!                                                   beside.rs  what is next to it
//!                                                   kept_ids.rs  what was removed comes back under its id
//!   join_many.rs  many edges go at once              convex.rs  a face falls into convex ones
//! ```
//!
//! The kernel takes whatever is combinatorially legal; here an edit must also keep edges straight, disjoint and
//! in their faces. `f0` is always the unbounded face, and inner components go where they lie. A refused edit changes
//! nothing.

mod beside;
#[cfg(feature = "navmesh")]
mod convex;
mod flip_edge;
mod insert_edge;
mod insert_segment;
mod insert_vertex;
mod join_edges;
mod join_faces;
#[cfg(feature = "navmesh")]
mod join_many;
#[cfg(any(feature = "navmesh", test))]
mod kept_ids;
mod remove_edge;
mod set_point;
mod split_edge;
mod split_face;
mod spot;
mod transform;
mod whole;

pub use beside::rounding_room;
#[cfg(feature = "navmesh")]
pub(crate) use convex::most_looked_at;
pub use flip_edge::FlipEdgeError;
pub use insert_edge::{InsertEdgeError, InsertedEdge};
pub use insert_segment::{InsertSegmentError, InsertedSegment};
pub use insert_vertex::{InsertDanglingEdgeError, InsertVertexError};
pub use join_edges::JoinEdgesError;
pub use join_faces::JoinFacesError;
pub use remove_edge::{RemoveEdgeError, RemoveVertexError};
pub use set_point::SetPointError;
pub use split_edge::SplitEdgeError;
pub use split_face::SplitFaceError;
pub(in crate::plane) use spot::Towards;
pub use transform::TransformError;

use super::cycle::on_segment;
use super::sweep::cross;
use super::{Point, Subdivision};
use crate::geometry::predicates::orientation;
use crate::ids::{HalfEdgeId, VertexId};

/// What stands in the way of an edge that moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Obstacle {
    Vertex(VertexId),
    Edge(HalfEdgeId),
}

impl Subdivision {
    /// What stands in the way when the straight edge or edges between `u` and `w` along the half-edge `h` move
    /// to the other side of the triangle u, m, w: any vertex in the closed triangle, any edge across its legs.
    ///
    /// Cost: O(size of the two faces at `h`).
    fn obstacle_in_triangle(&self, h: HalfEdgeId, [u, m, w]: [Point; 3]) -> Option<Obstacle> {
        let turn = orientation(u, m, w);
        let inside = |q: Point| {
            let along = |a: Point, b: Point| orientation(a, b, q) != turn.reverse();
            ![u, m, w].contains(&q) && along(u, m) && along(m, w) && along(w, u)
        };
        let bars = |a: Point, b: Point| {
            cross(u, m, a, b) || cross(m, w, a, b) || cross(w, u, a, b) || (m != a && m != b && on_segment(a, b, m))
        };
        let (left, right) = (self.dcel.face(h), self.dcel.face(h.twin()));
        for f in std::iter::once(left).chain((right != left).then_some(right)) {
            if let Some(v) = self.isolated_vertices(f).find(|&v| inside(self.points[v])) {
                return Some(Obstacle::Vertex(v));
            }
            for g in self.all_half_edges(f) {
                let (v, to) = (self.dcel.origin(g), self.points[self.dcel.destination(g)]);
                if inside(self.points[v]) {
                    return Some(Obstacle::Vertex(v));
                }
                if bars(self.points[v], to) {
                    return Some(Obstacle::Edge(g));
                }
            }
        }
        None
    }
    /// The vertex at the point, if one of the two faces at `h` has one there. O(size of the two faces).
    fn vertex_beside(&self, h: HalfEdgeId, p: Point) -> Option<VertexId> {
        [h, h.twin()]
            .into_iter()
            .map(|h| self.dcel.face(h))
            .find_map(|f| self.vertices_of_face(f).find(|&v| self.points[v] == p))
    }
}
