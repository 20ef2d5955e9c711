//! Joining two edges by taking away the vertex between them.
//!
//! ```text
//!        h         c                             h
//!   ● ────────> ● ────────> ●             ● ───────────> ●
//!   u <──────── m <──────── w      ==>    u <─────────── w
//!     twin(h)        d                         twin(h)
//! ```
//!
//! The edge of `h` stays and grows; `m` and the edge of `c = next(h)` go.
//! Inverse of [`split_edge`](Dcel::split_edge): joining at the half-edge that was split undoes it.

use crate::ids::{HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::pool::IdError;
use crate::topology::record::{NoRecorder, Recorder};

/// Why the vertex at the end of a half-edge cannot be taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinEdgesError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The vertex does not have exactly two edges.
    #[error("{vertex}, the destination of {h}, has degree {degree}: only a vertex of degree 2 joins two edges")]
    NotDegreeTwo {
        /// The half-edge.
        h: HalfEdgeId,
        /// Its destination.
        vertex: VertexId,
        /// The number of half-edges that start there.
        degree: usize,
    },
    /// The only edge at the vertex is a loop.
    #[error("{h} is a loop and the only edge at {vertex}: there is no second edge to join it with")]
    Loop {
        /// The half-edge.
        h: HalfEdgeId,
        /// Its origin and destination.
        vertex: VertexId,
    },
}

impl Dcel {
    /// Whether [`join_edges`](Self::join_edges) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(1), when refused O(degree).
    pub fn can_join_edges(&self, h: HalfEdgeId) -> Result<(), JoinEdgesError> {
        self.check(h)?;
        let c = self.next(h);
        if c == h {
            if self.cw(h) == h.twin() {
                return Err(JoinEdgesError::Loop { h, vertex: self.origin(h) });
            }
        } else if c != h.twin() && self.cw(c) == h.twin() && c.edge() != h.edge() {
            return Ok(());
        }
        let vertex = self.destination(h);
        Err(JoinEdgesError::NotDegreeTwo { h, vertex, degree: self.star(c).count() })
    }

    /// Takes away the destination of `h`, which must have degree 2: `h` then leads on to where `next(h)` led.
    /// Returns the removed vertex.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// See [`JoinEdgesError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{HalfEdgeId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let before = square.destination(HalfEdgeId::new(0));
    /// let (m, _) = square.split_edge(HalfEdgeId::new(0))?;
    /// assert_eq!(square.join_edges(HalfEdgeId::new(0))?, m);
    /// assert_eq!(square.destination(HalfEdgeId::new(0)), before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn join_edges(&mut self, h: HalfEdgeId) -> Result<VertexId, JoinEdgesError> {
        self.join_edges_with(h, &mut NoRecorder)
    }

    /// [`join_edges`](Self::join_edges), watched by a recorder.
    pub fn join_edges_with(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> Result<VertexId, JoinEdgesError> {
        self.can_join_edges(h)?;
        Ok(self.join_edges_unchecked(h, rec))
    }

    /// The write phase. `h` must have passed [`can_join_edges`](Self::can_join_edges).
    pub(crate) fn join_edges_unchecked(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> VertexId {
        let (a, b) = (h, h.twin());
        let c = self.next(a);
        let d = c.twin();
        let (m, w) = (self.origin(c), self.origin(d));
        let (after_c, before_d) = (self.next(c), self.prev(d));

        rec.step(1, "Let no vertex and no face point to the edge that goes.");
        if self.outgoing(w) == Some(d) {
            self.set_outgoing(w, Some(b), rec);
        }
        if self.half_edge(self.face(a)) == Some(c) {
            self.set_half_edge(self.face(a), Some(a), rec);
        }
        if self.half_edge(self.face(b)) == Some(d) {
            self.set_half_edge(self.face(b), Some(b), rec);
        }

        rec.step(2, "Lead the remaining half-edges past the vertex.");
        self.set_origin(b, w, rec);
        if after_c == d {
            self.set_next(a, b, rec);
        } else {
            self.set_next(a, after_c, rec);
            self.set_next(before_d, b, rec);
        }

        rec.step(3, "Remove the edge and the vertex.");
        self.remove_edge_record(c.edge(), rec);
        self.remove_vertex_record(m, rec);
        m
    }
}
