//! Collapsing an edge of a simplicial surface, so that it stays one.
//!
//! ```text
//!            x                              x
//!          ╱ │ ╲                            │            the edge and its destination w go, and with them
//!        ╱   │   ╲                          │            the triangles beside it;
//!      ╱   ──h──>  ╲                        │            of the two edges to a tip, that of u stays
//!    u ●────────────● w        ==>        u ●
//!      ╲   <──────  ╱                       │
//!        ╲   │   ╱                          │
//!          ╲ │ ╱                            │
//!            y                              y
//! ```
//!
//! The link condition decides whether it may be done. In words: u and w have no neighbour in common but the tips
//! of the triangles beside `h`, and no face but the two beside `h` touches both; and the surface is more than a
//! tetrahedron. Then no loop, no parallel edge, no two-sided face and no face that passes a vertex twice comes to be.
//! A face with more than three sides loses one. A boundary face counts as a face like any other: two vertices of one
//! border are never pinched together, but a hole of three edges closes, and two holes may come to touch. A surface
//! that knows its borders refuses both (`Polyhedron::collapse_edge`).
//!
//! [`join_vertices`](Dcel::join_vertices) is the plain contraction without conditions.
//!
//! Source: Dey, Edelsbrunner, Guha and Nekhayev, *Topology preserving edge contraction*, 1999.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::pool::IdError;
use crate::topology::record::{NoRecorder, Quiet, Recorder};

/// Why an edge cannot be collapsed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CollapseEdgeError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The edge starts and ends at the same vertex.
    #[error("{h} is a loop at {vertex}: there are no two vertices to join; choose an edge with two ends")]
    Loop {
        /// The half-edge.
        h: HalfEdgeId,
        /// Its origin and destination.
        vertex: VertexId,
    },
    /// The same face lies on both sides.
    #[error("{face} lies on both sides of {h}: no simplicial surface has such an edge; try join_vertices({h})")]
    SameFace {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face on both sides.
        face: FaceId,
    },
    /// Another edge joins the same two vertices: it would become a loop.
    #[error("{other} joins the ends of {h} as well and would become a loop; collapse another edge")]
    ParallelEdge {
        /// The half-edge.
        h: HalfEdgeId,
        /// The other one.
        other: HalfEdgeId,
    },
    /// Nothing but a double-sided triangle or less would be left.
    #[error("the surface of {h} has only {vertices} vertices: none of its edges can be collapsed")]
    TooSmall {
        /// The half-edge.
        h: HalfEdgeId,
        /// The vertices of its component.
        vertices: usize,
    },
    /// Both ends have a common neighbour that is not the tip of a triangle beside the edge: two parallel edges
    /// would come to be.
    #[error("{vertex} is a neighbour of both ends of {h}: two parallel edges would lead there; collapse another edge")]
    CommonNeighbour {
        /// The half-edge.
        h: HalfEdgeId,
        /// The neighbour.
        vertex: VertexId,
    },
    /// A face touches both ends, but does not lie beside the edge: it would pass the joined vertex twice.
    #[error("{face} touches both ends of {h} without lying beside it, and would be pinched; collapse another edge")]
    CommonFace {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face.
        face: FaceId,
    },
}

impl Dcel {
    /// Whether [`collapse_edge`](Self::collapse_edge) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O((d + e) log d) for the degrees d <= e of the two ends.
    pub fn can_collapse_edge(&self, h: HalfEdgeId) -> Result<(), CollapseEdgeError> {
        self.check(h)?;
        let (t, u, w) = (h.twin(), self.origin(h), self.destination(h));
        if u == w {
            return Err(CollapseEdgeError::Loop { h, vertex: u });
        }
        if self.face(h) == self.face(t) {
            return Err(CollapseEdgeError::SameFace { h, face: self.face(h) });
        }
        if let Some(other) = self.star(h).find(|&g| g != h && self.destination(g) == w) {
            return Err(CollapseEdgeError::ParallelEdge { h, other });
        }
        if self.is_all_triangles_of(h) {
            let vertices = if self.next(t) == self.prev(h).twin() { 3 } else { 4 };
            return Err(CollapseEdgeError::TooSmall { h, vertices });
        }
        // A tip is a common neighbour by the two edges of its triangle, and by no others.
        let tip = |g: HalfEdgeId| self.is_triangle(g).then(|| self.origin(self.prev(g)));
        let beside = [
            (tip(h), self.prev(h).twin(), self.next(h)),
            (tip(t).filter(|&y| tip(h) != Some(y)), self.next(t), self.prev(t).twin()),
        ];
        let mut near: Vec<(VertexId, HalfEdgeId)> = self.star(h).skip(1).map(|g| (self.destination(g), g)).collect();
        near.sort_unstable();
        for to_w in self.star(t).skip(1) {
            let vertex = self.destination(to_w);
            let from = near.partition_point(|&(x, _)| x < vertex);
            for &(_, to_u) in near[from..].iter().take_while(|&&(x, _)| x == vertex) {
                if !beside.contains(&(Some(vertex), to_u, to_w)) {
                    return Err(CollapseEdgeError::CommonNeighbour { h, vertex });
                }
            }
        }
        // The corner of u in the face of h is that of h, in the face of t that of next(t); and so for w.
        let mut faces: Vec<FaceId> =
            self.star(h).filter(|&g| g != h && g != self.next(t)).map(|g| self.face(g)).collect();
        faces.sort_unstable();
        let beyond = |g: &HalfEdgeId| *g != t && *g != self.next(h);
        match self.star(t).filter(beyond).map(|g| self.face(g)).find(|face| faces.binary_search(face).is_ok()) {
            Some(face) => Err(CollapseEdgeError::CommonFace { h, face }),
            None => Ok(()),
        }
    }

    fn is_triangle(&self, h: HalfEdgeId) -> bool {
        let second = self.next(h);
        second != h && second != self.prev(h) && self.next(second) == self.prev(h)
    }

    /// Whether the edge of `h` belongs to a double-sided triangle or a tetrahedron.
    fn is_all_triangles_of(&self, h: HalfEdgeId) -> bool {
        let t = h.twin();
        let double = self.next(t) == self.prev(h).twin() && self.prev(t) == self.next(h).twin();
        // At both ends: an edge to each tip, a triangle between these two, and nothing else.
        let three = |g| self.ccw(self.ccw(g)) == self.cw(g) && self.is_triangle(self.ccw(g));
        self.is_triangle(h) && self.is_triangle(t) && (double || (three(h) && three(t)))
    }

    /// Takes away the edge of `h`, its destination, and the triangles beside it, if the link condition holds.
    /// Returns the removed vertex.
    ///
    /// The origin of `h` stays, with all its edges; a triangle beside `h` goes together with the edge from the
    /// removed vertex to its tip. A face beside `h` with more than three sides loses one side and stays.
    ///
    /// Cost: O((d + e) log d) for the degrees d <= e of the two ends.
    ///
    /// # Errors
    /// See [`CollapseEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::topology::{CollapseEdgeError, Dcel};
    /// // Two pyramids over one triangle, tips v3 and v4.
    /// let triangles = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    /// let mut d = Dcel::from_triangles(5, &triangles)?.dcel;
    /// let v = dcel_kit::VertexId::new;
    /// let waist = d.find_half_edge(v(0), v(1)).unwrap();
    /// // v2 is a neighbour of both ends, too.
    /// assert_eq!(d.collapse_edge(waist), Err(CollapseEdgeError::CommonNeighbour { h: waist, vertex: v(2) }));
    /// let side = d.find_half_edge(v(0), v(3)).unwrap();
    /// assert_eq!(d.collapse_edge(side), Ok(v(3)));
    /// assert_eq!((d.vertex_count(), d.edge_count(), d.face_count()), (4, 6, 4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn collapse_edge(&mut self, h: HalfEdgeId) -> Result<VertexId, CollapseEdgeError> {
        self.collapse_edge_with(h, &mut NoRecorder)
    }

    /// [`collapse_edge`](Self::collapse_edge), watched by a recorder.
    pub fn collapse_edge_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> Result<VertexId, CollapseEdgeError> {
        self.can_collapse_edge(h)?;
        let t = h.twin();
        let far_edges = [(self.is_triangle(h), self.next(h)), (self.is_triangle(t), self.prev(t))];
        rec.step(1, "Join the two vertices: the triangles beside the edge become two-sided.");
        let gone = self.join_vertices_unchecked(h, &mut Quiet(rec));
        rec.step(2, "Take the two-sided faces away, each with the edge of the vertex that went.");
        for (_, far) in far_edges.into_iter().filter(|&(triangle, _)| triangle) {
            self.join_faces_unchecked(far, &mut Quiet(rec));
        }
        Ok(gone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_beside_the_edge_may_pass_one_end_twice() {
        let h = HalfEdgeId(0);
        for corner in [h, HalfEdgeId(2)] {
            let mut square = Dcel::polygon(4).unwrap();
            square.split_vertex(corner, corner).unwrap();
            assert_eq!(square.can_collapse_edge(h), Ok(()), "a twig at the origin of {corner}");
        }
    }
}
