//! Splitting a vertex in two, with a new edge between the halves.
//!
//! ```text
//!      last                                     last
//!       ^      ^ moves                           ^                 ^ moves
//!       │     ╱                                  │      a         ╱
//!       │    ╱                                   │  ──────────>  ╱
//!     v ●──────> moves          ==>            v ●──────────────● m ───> moves
//!       │    ╲                                   │  <──────────  ╲
//!       │     ╲                                  │      b         ╲
//!       v      v first                           v                 v first
//! ```
//!
//! The half-edges from `first` counter-clockwise up to, not including, `last` move to the new vertex `m`; the
//! others stay at `v`. The two faces at the ends of the range get one more side each.
//!
//! ```text
//!   how many move    what it is             how to ask for it
//!   some             a vertex split         split_vertex(first, last)
//!   one              an edge is split       split_vertex(h, ccw(h))       (degree 2 and more)
//!   none             a spur in a corner     split_vertex(h, h)            it stands clockwise beside h
//!   none, no edge    a spur on a point      split_isolated_vertex(v)
//! ```
//!
//! Inverse: [`join_vertices`](Dcel::join_vertices) of the returned half-edge.
//!
//! Source: the vertex split of the GenMesh article, with the half-open range of its last comment.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::pool::{IdError, TooMany};
use crate::topology::record::{NoRecorder, Recorder};

/// Why a vertex cannot be split.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SplitVertexError {
    /// The half-edge or the vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The two half-edges start at different vertices.
    #[error("{first} starts at {v1}, but {last} starts at {v2}: choose two half-edges that start at one vertex")]
    DifferentOrigins {
        /// The first half-edge that is to move.
        first: HalfEdgeId,
        /// Its origin.
        v1: VertexId,
        /// The first one that is to stay.
        last: HalfEdgeId,
        /// Its origin.
        v2: VertexId,
    },
    /// The vertex was said to be isolated, but has edges.
    #[error("{vertex} is not isolated, {outgoing} starts there: name the corner, split_vertex({outgoing}, {outgoing})")]
    NotIsolated {
        /// The vertex.
        vertex: VertexId,
        /// Its stored half-edge.
        outgoing: HalfEdgeId,
    },
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Dcel {
    /// Whether [`split_vertex`](Self::split_vertex) would succeed, and if not, why. Changes nothing. O(1).
    #[inline]
    pub fn can_split_vertex(&self, first: HalfEdgeId, last: HalfEdgeId) -> Result<(), SplitVertexError> {
        self.check(first)?;
        self.check(last)?;
        let (v1, v2) = (self.origin(first), self.origin(last));
        if v1 != v2 {
            return Err(SplitVertexError::DifferentOrigins { first, v1, last, v2 });
        }
        Ok(self.room_for(1, 1, 0)?)
    }

    /// Splits the common origin of `first` and `last`: the half-edges from `first` counter-clockwise up to, not
    /// including, `last` move to a new vertex, which a new edge joins to the old one.
    ///
    /// Returns the new half-edge from the old vertex to the new one, and the new vertex. If `first` and `last` are
    /// the same, none moves: the new edge is a spur in the corner clockwise beside `first`, that is in the face
    /// of its twin.
    ///
    /// Cost: O(half-edges that move).
    ///
    /// # Errors
    /// See [`SplitVertexError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{FaceId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let h = square.half_edge(FaceId::new(1)).unwrap();
    /// let v = square.origin(h);
    /// // One half-edge moves: a new vertex stands on its edge.
    /// let (a, m) = square.split_vertex(h, square.ccw(h))?;
    /// assert_eq!((square.origin(a), square.destination(a), square.origin(h)), (v, m, m));
    /// // None moves: a spur.
    /// let (_, tip) = square.split_vertex(h, h)?;
    /// assert_eq!((square.degree(m), square.degree(tip)), (3, 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_vertex(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
    ) -> Result<(HalfEdgeId, VertexId), SplitVertexError> {
        self.split_vertex_with(first, last, &mut NoRecorder)
    }

    /// [`split_vertex`](Self::split_vertex), watched by a recorder.
    pub fn split_vertex_with(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> Result<(HalfEdgeId, VertexId), SplitVertexError> {
        self.can_split_vertex(first, last)?;
        Ok(self.split_vertex_unchecked(first, last, rec))
    }

    /// The write phase. `first` and `last` must have passed [`can_split_vertex`](Self::can_split_vertex).
    #[inline]
    pub(crate) fn split_vertex_unchecked(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> (HalfEdgeId, VertexId) {
        let v = self.origin(first);
        let (into_a, into_b) = (last.twin(), first.twin());
        let (after_a, after_b) = (self.next(into_a), self.next(into_b));

        rec.step(1, "Create a new vertex.");
        let m = self.add_vertex_record(rec);

        rec.step(2, "Create two new half-edges between the old vertex and the new one.");
        let [a, b] = self.add_edge_record(rec).half_edges();
        self.set_origin(a, v, rec);
        self.set_origin(b, m, rec);

        rec.step(3, "Let the half-edges of the range start at the new vertex.");
        let mut stored_moves = false;
        let mut h = first;
        while h != last {
            stored_moves |= self.outgoing(v) == Some(h);
            self.set_origin(h, m, rec);
            h = self.ccw(h);
        }

        rec.step(4, "Insert the new half-edges into the cyclic lists.");
        self.set_next(into_a, a, rec);
        if first == last {
            self.set_next(a, b, rec);
        } else {
            self.set_next(a, after_a, rec);
            self.set_next(into_b, b, rec);
        }
        self.set_next(b, after_b, rec);

        rec.step(5, "Make both half-edges point to the right face.");
        self.set_face(a, self.face(into_a), rec);
        self.set_face(b, self.face(into_b), rec);

        rec.step(6, "Make both vertices point to one of their half-edges.");
        self.set_outgoing(m, Some(b), rec);
        if stored_moves {
            self.set_outgoing(v, Some(a), rec);
        }
        (a, m)
    }

    /// Whether [`split_isolated_vertex`](Self::split_isolated_vertex) would succeed, and if not, why. Changes
    /// nothing. O(1).
    pub fn can_split_isolated_vertex(&self, v: VertexId) -> Result<(), SplitVertexError> {
        self.check(v)?;
        if let Some(outgoing) = self.outgoing(v) {
            return Err(SplitVertexError::NotIsolated { vertex: v, outgoing });
        }
        Ok(self.room_for(1, 1, 1)?)
    }

    /// Splits a vertex without any edge: a spur on a point. Both sides of the new edge get one new face, because
    /// a point of the kernel lies in no face.
    ///
    /// ```text
    ///                                  a
    ///      ● v        ==>      v ● ────────> ● m        one face round both sides
    ///                             <────────
    /// ```
    ///
    /// Returns the new half-edge from `v` to the new vertex, and the new face. Inverse:
    /// [`join_vertices`](Self::join_vertices) of that half-edge. Cost: O(1).
    ///
    /// # Errors
    /// See [`SplitVertexError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{VertexId, topology::{Dcel, measure}};
    /// let mut point = Dcel::from_triangles(1, &[])?.dcel;
    /// let (a, face) = point.split_isolated_vertex(VertexId::new(0))?;
    /// assert_eq!((point.next(a), point.face(a)), (a.twin(), face));
    /// assert_eq!(measure(&point).closed_euler(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_isolated_vertex(&mut self, v: VertexId) -> Result<(HalfEdgeId, FaceId), SplitVertexError> {
        self.split_isolated_vertex_with(v, &mut NoRecorder)
    }

    /// [`split_isolated_vertex`](Self::split_isolated_vertex), watched by a recorder.
    pub fn split_isolated_vertex_with(
        &mut self,
        v: VertexId,
        rec: &mut impl Recorder,
    ) -> Result<(HalfEdgeId, FaceId), SplitVertexError> {
        self.can_split_isolated_vertex(v)?;
        rec.step(1, "Create a new vertex.");
        let m = self.add_vertex_record(rec);

        rec.step(2, "Create two new half-edges and a face around them.");
        let [a, b] = self.add_edge_record(rec).half_edges();
        let face = self.add_face_record(rec);

        rec.step(3, "Set the origin, next, prev and face pointers.");
        self.set_origin(a, v, rec);
        self.set_origin(b, m, rec);
        self.set_next(a, b, rec);
        self.set_next(b, a, rec);
        self.set_face(a, face, rec);
        self.set_face(b, face, rec);

        rec.step(4, "Make the vertices and the face point to one of their half-edges.");
        self.set_outgoing(v, Some(a), rec);
        self.set_outgoing(m, Some(b), rec);
        self.set_half_edge(face, Some(a), rec);
        Ok((a, face))
    }
}
