//! Joining two vertices by taking away the edge between them.
//!
//! ```text
//!          p1 ↓      h      ^ n1                      p1 ↓     ^ n1
//!              ╲ ────────> ╱                              ╲   ╱
//!      kept   u ●─────────● m   gone       ==>           u ●
//!              ╱ <──────── ╲                              ╱   ╲
//!          n2 v  twin(h)    ^ p2                      n2 v     ^ p2
//! ```
//!
//! The origin of `h` stays and takes over all edges of its destination, in their order; the two faces beside `h`
//! lose one side each. Inverse of [`split_vertex`](Dcel::split_vertex): joining at the half-edge it returned
//! undoes it.
//!
//! Whatever is combinatorially legal is done here: an edge of a two-sided face becomes a loop, parallel edges
//! may come to be. [`collapse_edge`](Dcel::collapse_edge) is the one that keeps a simplicial surface simplicial.

use crate::ids::{HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::pool::IdError;
use crate::topology::record::{NoRecorder, Recorder};

/// Why the two ends of an edge cannot be joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinVerticesError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The edge starts and ends at the same vertex.
    #[error("{h} is a loop at {vertex}: there are no two vertices to join; join_faces({h}) takes a loop away")]
    Loop {
        /// The half-edge.
        h: HalfEdgeId,
        /// Its origin and destination.
        vertex: VertexId,
    },
}

impl Dcel {
    /// Whether [`join_vertices`](Self::join_vertices) would succeed, and if not, why. Changes nothing. O(1).
    pub fn can_join_vertices(&self, h: HalfEdgeId) -> Result<(), JoinVerticesError> {
        self.check(h)?;
        if self.origin(h) == self.destination(h) {
            return Err(JoinVerticesError::Loop { h, vertex: self.origin(h) });
        }
        Ok(())
    }

    /// Takes away the edge of `h` and its destination; the origin of `h` takes the place of both ends. Returns the
    /// removed vertex.
    ///
    /// If the edge was the only one of its component, its face has no boundary left and goes as well; the origin
    /// is isolated then.
    ///
    /// Cost: O(degree of the destination).
    ///
    /// # Errors
    /// See [`JoinVerticesError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{HalfEdgeId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let h = HalfEdgeId::new(0);
    /// let (a, m) = square.split_vertex(h, square.ccw(h))?;
    /// assert_eq!(square.join_vertices(a)?, m);
    /// assert_eq!((square.origin(h), square.vertex_count()), (dcel_kit::VertexId::new(0), 4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn join_vertices(&mut self, h: HalfEdgeId) -> Result<VertexId, JoinVerticesError> {
        self.join_vertices_with(h, &mut NoRecorder)
    }

    /// [`join_vertices`](Self::join_vertices), watched by a recorder.
    pub fn join_vertices_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> Result<VertexId, JoinVerticesError> {
        self.can_join_vertices(h)?;
        Ok(self.join_vertices_unchecked(h, rec))
    }

    /// The write phase. `h` must have passed [`can_join_vertices`](Self::can_join_vertices).
    pub(crate) fn join_vertices_unchecked(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> VertexId {
        let (a, b) = (h, h.twin());
        let (u, m) = (self.origin(a), self.origin(b));
        let (p1, n1) = (self.prev(a), self.next(a));
        let (p2, n2) = (self.prev(b), self.next(b));
        let only_edge = n1 == b && n2 == a;
        // At the tip of a spur the other half comes next; then the one after that follows.
        let (after_a, after_b) = (if n1 == b { n2 } else { n1 }, if n2 == a { n1 } else { n2 });

        rec.step(1, "Let the half-edges of the vertex that goes start at the one that stays.");
        let mut moving = self.ccw(b);
        while moving != b {
            self.set_origin(moving, u, rec);
            moving = self.ccw(moving);
        }

        rec.step(2, "Let no vertex and no face point to the edge that goes.");
        if self.outgoing(u) == Some(a) {
            self.set_outgoing(u, (!only_edge).then_some(after_a), rec);
        }
        if !only_edge {
            for (gone, after) in [(a, after_a), (b, after_b)] {
                if self.half_edge(self.face(gone)) == Some(gone) {
                    self.set_half_edge(self.face(gone), Some(after), rec);
                }
            }
        }

        rec.step(3, "Take the two half-edges out of the cyclic lists.");
        if !only_edge {
            if n2 != a {
                self.set_next(p1, after_a, rec);
            }
            if n1 != b {
                self.set_next(p2, after_b, rec);
            }
        }

        rec.step(4, "Remove the edge and the vertex.");
        let face = self.face(a);
        self.remove_edge_record(a.edge(), rec);
        self.remove_vertex_record(m, rec);
        if only_edge {
            self.remove_face_record(face, rec);
        }
        m
    }
}
