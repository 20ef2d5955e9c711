//! Splitting an edge by a new vertex.
//!
//! ```text
//!          h                                     h         c
//!   ● ───────────> ●                      ● ────────> ● ────────> ●
//!   u <─────────── w             ==>      u <──────── m <──────── w
//!        twin(h)                            twin(h)        d
//! ```
//!
//! `h` keeps its origin `u`; the origin of its twin becomes the new vertex `m`. The new half-edges are
//! `c = next(h)` and its twin `d`. Inverse: [`join_edges`](Dcel::join_edges) of `h`.

use crate::ids::{HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::pool::{IdError, TooMany};
use crate::topology::record::{NoRecorder, Recorder};

/// Why an edge cannot be split.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SplitEdgeError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Dcel {
    /// Whether [`split_edge`](Self::split_edge) would succeed, and if not, why. Changes nothing. O(1).
    #[inline]
    pub fn can_split_edge(&self, h: HalfEdgeId) -> Result<(), SplitEdgeError> {
        self.check(h)?;
        Ok(self.room_for(1, 1, 0)?)
    }

    /// Puts a new vertex on the edge of `h`. Returns the vertex and the half-edge that now follows `h`: from
    /// the new vertex to the old destination of `h`.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// See [`SplitEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{HalfEdgeId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let h = HalfEdgeId::new(0);
    /// let (u, w) = (square.origin(h), square.destination(h));
    /// let (m, c) = square.split_edge(h)?;
    /// assert_eq!((square.origin(h), square.destination(h)), (u, m));
    /// assert_eq!((square.next(h), square.destination(c)), (c, w));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_edge(&mut self, h: HalfEdgeId) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.split_edge_with(h, &mut NoRecorder)
    }

    /// [`split_edge`](Self::split_edge), watched by a recorder.
    pub fn split_edge_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.can_split_edge(h)?;
        Ok(self.split_edge_unchecked(h, rec))
    }

    /// The write phase. `h` must have passed [`can_split_edge`](Self::can_split_edge).
    #[inline]
    pub(crate) fn split_edge_unchecked(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> (VertexId, HalfEdgeId) {
        let (a, b) = (h, h.twin());
        let w = self.origin(b);
        let (after_a, before_b) = (self.next(a), self.prev(b));

        rec.step(1, "Create a vertex for the point on the edge.");
        let m = self.add_vertex_record(rec);

        rec.step(2, "Create two new half-edges.");
        let [c, d] = self.add_edge_record(rec).half_edges();

        rec.step(3, "Set the origin, next, prev and face pointers.");
        let mut pen = self.pen();
        pen.set_origin(c, m, rec);
        pen.set_origin(d, w, rec);
        pen.set_origin(b, m, rec);
        pen.set_next(a, c, rec);
        pen.set_next(d, b, rec);
        if after_a == b {
            pen.set_next(c, d, rec);
        } else {
            pen.set_next(c, after_a, rec);
            pen.set_next(before_b, d, rec);
        }
        let (left, right) = (pen.face(a), pen.face(b));
        pen.set_face(c, left, rec);
        pen.set_face(d, right, rec);
        pen.set_outgoing(m, Some(c), rec);
        if pen.has_outgoing(w, b) {
            pen.set_outgoing(w, Some(d), rec);
        }
        (m, c)
    }
}
