//! Removing an edge, or a vertex with its edges.
//!
//! ```text
//!   ┌─────┬─────┐       ┌───────────┐            between two faces: they are joined
//!   │  f  h  g  │  ==>  │           │
//!   └─────┴─────┘       └───────────┘
//!   ┌───────────┐       ┌───────────┐            the same face on both sides: its cycle falls into two, of which
//!   │   ┌─┐     │       │   ┌─┐     │            one may be a single vertex. If it was the outer boundary, the part
//!   ├─h─┤ │     │  ==>  │   │ │     │            that surrounds the other stays the boundary; the other is an inner component.
//!   │   └─┘     │       │   └─┘     │
//!   └───────────┘       └───────────┘
//! ```

use super::JoinFacesError;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::encloses;
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{IdError, InnerComponent, NoRecorder};

/// Why an edge cannot be removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RemoveEdgeError {
    /// The edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The faces on both sides cannot be joined.
    #[error("{edge}: {error}")]
    Faces {
        /// The edge.
        edge: EdgeId,
        /// Why not.
        error: JoinFacesError,
    },
}

/// Why a vertex cannot be removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RemoveVertexError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// One of its edges cannot be removed.
    #[error("{vertex} cannot go with its edges: {error}")]
    Edge {
        /// The vertex.
        vertex: VertexId,
        /// Which edge, and why.
        error: RemoveEdgeError,
    },
}

impl Subdivision {
    /// Whether [`remove_edge`](Self::remove_edge) would succeed, and if not, why. Changes nothing. O(log holes).
    pub fn can_remove_edge(&self, edge: EdgeId) -> Result<(), RemoveEdgeError> {
        self.dcel.check(edge)?;
        let [h, t] = edge.half_edges();
        if self.dcel.face(h) == self.dcel.face(t) {
            return Ok(());
        }
        self.can_join_faces(h).map_err(|error| RemoveEdgeError::Faces { edge, error })
    }

    /// Takes away an edge; its ends stay, isolated if they have no other edge.
    ///
    /// Between two faces, the face of its odd half takes the place of both, or `f0` if that is one of them; returns
    /// the face that is gone. With the same face on both sides no face goes: what hung together by the edge falls
    /// apart into two inner components of the face, or into its boundary and an inner component.
    ///
    /// Cost: O(length of the cycles on both sides, and number of inner components of both faces).
    ///
    /// # Errors
    /// See [`RemoveEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{EdgeId, FaceId, VertexId, plane::{Point, Subdivision}};
    /// let mut s = Subdivision::lab_rectangle();
    /// let (tip, h) = s.insert_dangling_edge(VertexId::new(0), Point::new(0.0, 0.0))?;
    /// assert_eq!(s.remove_edge(h.edge())?, None);
    /// assert_eq!(s.outgoing(tip), None);
    /// assert_eq!(s.remove_edge(EdgeId::new(0))?, Some(FaceId::new(1)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove_edge(&mut self, edge: EdgeId) -> Result<Option<FaceId>, RemoveEdgeError> {
        self.remove_edge_with(edge, &mut NoRecorder)
    }

    /// [`remove_edge`](Self::remove_edge), watched by a recorder.
    pub fn remove_edge_with(
        &mut self,
        edge: EdgeId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<Option<FaceId>, RemoveEdgeError> {
        self.can_remove_edge(edge)?;
        let [h, t] = edge.half_edges();
        if self.dcel.face(h) != self.dcel.face(t) {
            let gone = self.join_faces_with(h, rec).map_err(|error| RemoveEdgeError::Faces { edge, error })?;
            return Ok(Some(gone));
        }
        self.cut_apart(edge, rec);
        Ok(None)
    }

    /// Takes away an edge with the same face on both sides.
    fn cut_apart(&mut self, edge: EdgeId, rec: &mut impl PlaneRecorder) {
        let [a, b] = edge.half_edges();
        let f = self.dcel.face(a);
        let was_boundary = self.is_on_outer_boundary(a);
        let mut rings = self.take_inner_components(f, rec);
        let index = if was_boundary { None } else { self.inner_component_index(&rings, a) };

        rec.step(1, "Take the two half-edges out of the cyclic lists.");
        let parts = [a, b].map(|out| self.take_out(out, rec));
        rec.step(2, "Remove the edge.");
        let ends = [a, b].map(|h| self.dcel.origin(h));
        if was_boundary && self.dcel.half_edge(f).is_some_and(|h| h.edge() == edge) {
            self.dcel.set_half_edge(f, parts[0].or(parts[1]), rec);
        }
        self.dcel.remove_edge_record(edge, rec);

        let ring =
            |part: Option<HalfEdgeId>, v: VertexId| part.map_or(InnerComponent::Isolated(v), InnerComponent::Cycle);
        let [one, other] = [ring(parts[0], ends[0]), ring(parts[1], ends[1])];
        match index {
            Some(i) => {
                rings[i] = one;
                rings.push(other);
            }
            None => {
                let outer = parts.map(|part| part.is_some_and(|h| encloses(self.corner_points(h))));
                let (boundary, inner) = if outer[0] { (parts[0], other) } else { (parts[1], one) };
                if self.dcel.half_edge(f).is_none_or(|h| boundary.is_none_or(|g| !self.dcel.cycle(g).any(|k| k == h))) {
                    self.dcel.set_half_edge(f, boundary, rec);
                }
                rings.push(inner);
            }
        }
        self.give_inner_components(f, rings, rec);
    }

    /// Leads the links at the origin of `out` past it. Returns a half-edge that starts there now, if any does.
    fn take_out(&mut self, out: HalfEdgeId, rec: &mut impl PlaneRecorder) -> Option<HalfEdgeId> {
        let v = self.dcel.origin(out);
        let (before, after) = (self.dcel.prev(out), self.dcel.next(out.twin()));
        if after == out {
            self.dcel.set_outgoing(v, None, rec);
            return None;
        }
        self.dcel.set_next(before, after, rec);
        if self.dcel.outgoing(v) == Some(out) {
            self.dcel.set_outgoing(v, Some(after), rec);
        }
        Some(after)
    }

    /// Takes away a vertex, first all its edges, in the order round it from `outgoing(v)` on. Returns the faces that
    /// are gone.
    ///
    /// Cost: that of removing the edges one by one; O(number of all inner components) for the vertex.
    ///
    /// # Errors
    /// See [`RemoveVertexError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let corners = [(0., 0.), (4., 0.), (2., 1.), (0., 4.)].map(Point::from);
    /// let mut s = Subdivision::from_graph(&corners, &[[0, 1], [1, 3], [3, 0], [2, 0], [2, 1], [2, 3]])?;
    /// assert_eq!(s.remove_vertex(VertexId::new(2))?.len(), 2);
    /// assert_eq!((s.edge_count(), s.face_count()), (3, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove_vertex(&mut self, v: VertexId) -> Result<Vec<FaceId>, RemoveVertexError> {
        self.remove_vertex_with(v, &mut NoRecorder)
    }

    /// [`remove_vertex`](Self::remove_vertex), watched by a recorder.
    pub fn remove_vertex_with(
        &mut self,
        v: VertexId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<Vec<FaceId>, RemoveVertexError> {
        self.dcel.check(v)?;
        if self.dcel.outgoing(v).is_none() {
            self.remove_isolated(v, rec);
            return Ok(Vec::new());
        }
        self.all_or_nothing(rec, |s, rec| {
            let edges: Vec<EdgeId> = s.dcel.outgoing_half_edges(v).map(HalfEdgeId::edge).collect();
            let mut gone = Vec::new();
            for edge in edges {
                let face =
                    s.remove_edge_with(edge, rec).map_err(|error| RemoveVertexError::Edge { vertex: v, error })?;
                gone.extend(face);
            }
            s.remove_isolated(v, rec);
            Ok(gone)
        })
    }

    fn remove_isolated(&mut self, v: VertexId, rec: &mut impl PlaneRecorder) {
        let f = self.face_around(v);
        let mut rings = self.take_inner_components(f, rec);
        rings.retain(|&ring| ring != InnerComponent::Isolated(v));
        self.give_inner_components(f, rings, rec);
        self.dcel.remove_vertex_record(v, rec);
    }
}
