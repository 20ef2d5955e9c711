//! What a grid is made of: edges, isolated vertices, and the faces beside them.

use super::Location;
use super::order::Ends;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;

/// The edges that a grid is made for.
pub(crate) trait Lines: Sync {
    /// Where the half-edge starts.
    fn origin(&self, h: HalfEdgeId) -> VertexId;
    /// Where the vertex is.
    fn point(&self, v: VertexId) -> Point;
    /// The face on the left of the half-edge.
    fn face(&self, h: HalfEdgeId) -> FaceId;

    /// The ends of the half-edge, its origin first.
    #[inline]
    fn ends(&self, h: HalfEdgeId) -> Ends {
        [h, h.twin()].map(|h| self.point(self.origin(h)))
    }
}

/// Marks a word that is no half-edge: an isolated vertex in a list, a crowded cell in a face word.
pub(super) const TAG: u32 = 1 << 31;
/// The location of a point of the edge that is not its right end.
#[inline]
pub(super) fn on_edge(lines: &impl Lines, h: HalfEdgeId, p: Point) -> Location {
    let v = lines.origin(h);
    if lines.point(v) == p { Location::Vertex(v) } else { Location::Edge(h) }
}

/// The face right of an edge that crosses a level.
pub(super) fn face_right_of(lines: &impl Lines, h: HalfEdgeId, [a, b]: Ends) -> FaceId {
    lines.face(if a.y < b.y { h.twin() } else { h })
}
