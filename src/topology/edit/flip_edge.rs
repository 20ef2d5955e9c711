//! Turning an edge inside the two faces beside it.
//!
//! ```text
//!            c                              c
//!            ●                              ●              h ran from a to b, with f on its left and g on its right.
//!       p1 ╱ f ╲ n1                    p1 ╱ ^ ╲ n1         Each of its ends moves one corner on, counter-clockwise:
//!        v       ╲                      v   │   ╲          now it runs from d to c.
//!     a ●─── h ──>● b       ==>      a ●  f h g  ● b
//!        ╲       ^                      ╲   │   ^          n2 bounds f now, and n1 bounds g.
//!       n2 ╲ g ╱ p2                    n2 ╲ │ ╱ p2
//!            ●                              ●
//!            d                              d
//! ```
//!
//! Two flips of an edge between triangles turn it round, four change nothing: three undo one. In general the edge is
//! a chord of the outline of both faces: between faces of k and l sides, k + l - 2 flips change nothing.

use crate::ids::{FaceId, HalfEdgeId};
use crate::topology::Dcel;
use crate::topology::pool::IdError;
use crate::topology::record::{NoRecorder, Recorder};

/// Why an edge cannot be flipped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FlipEdgeError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The same face lies on both sides: the edge is no chord of an outline.
    #[error("{face} lies on both sides of {h}: only an edge between two faces can be flipped")]
    SameFace {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face on both sides.
        face: FaceId,
    },
    /// A loop bounds a face alone: there is no next corner to which its end could move.
    #[error("{loop_edge} is the whole boundary of {face}: an edge with a face of one side cannot be flipped")]
    OneSidedFace {
        /// The half-edge of the loop on the side of the face.
        loop_edge: HalfEdgeId,
        /// The face it bounds alone.
        face: FaceId,
    },
}

impl Dcel {
    /// Whether [`flip_edge`](Self::flip_edge) would succeed, and if not, why. Changes nothing. O(1).
    pub fn can_flip_edge(&self, h: HalfEdgeId) -> Result<(), FlipEdgeError> {
        self.check(h)?;
        if self.face(h) == self.face(h.twin()) {
            return Err(FlipEdgeError::SameFace { h, face: self.face(h) });
        }
        match [h, h.twin()].into_iter().find(|&g| self.next(g) == g) {
            Some(loop_edge) => Err(FlipEdgeError::OneSidedFace { loop_edge, face: self.face(loop_edge) }),
            None => Ok(()),
        }
    }

    /// Flips the edge of `h`: both its ends move one corner on, counter-clockwise round the outline of its two faces.
    ///
    /// All ids stay. `h` starts where `next(twin(h))` ended and ends where `next(h)` ended. Both faces keep their
    /// number of sides: `next(h)` goes over to the face of the twin, `next(twin(h))` to the face of `h`. No position
    /// is asked for: the kernel also makes loops and parallel edges. Between two triangles the edge is a diagonal of
    /// their quadrilateral and becomes the other one; two flips exchange its halves, four change nothing, so that
    /// three undo one.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// See [`FlipEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{FaceId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let corner: Vec<_> = square.incident_half_edges(FaceId::new(1)).collect();
    /// let ends = |d: &Dcel, h| (d.origin(h).to_string(), d.destination(h).to_string());
    /// let (h, _) = square.split_face(corner[0], corner[2])?;
    /// assert_eq!(ends(&square, h), ("v0".into(), "v2".into()));
    /// square.flip_edge(h)?;
    /// assert_eq!(ends(&square, h), ("v1".into(), "v3".into()));
    /// square.flip_edge(h)?;
    /// assert_eq!(ends(&square, h), ("v2".into(), "v0".into()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn flip_edge(&mut self, h: HalfEdgeId) -> Result<(), FlipEdgeError> {
        self.flip_edge_with(h, &mut NoRecorder)
    }

    /// [`flip_edge`](Self::flip_edge), watched by a recorder.
    pub fn flip_edge_with(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> Result<(), FlipEdgeError> {
        self.can_flip_edge(h)?;
        self.flip_edge_unchecked(h, rec);
        Ok(())
    }

    /// The write phase. `h` must have passed [`can_flip_edge`](Self::can_flip_edge).
    #[inline]
    pub(crate) fn flip_edge_unchecked(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) {
        let t = h.twin();
        let mut pen = self.pen();
        let (n1, p1) = (pen.next(h), pen.prev(h));
        let (n2, p2) = (pen.next(t), pen.prev(t));
        let (after1, after2) = (pen.next(n1), pen.next(n2));
        let (f, g) = (pen.face(h), pen.face(t));
        let (a, b) = (pen.origin(h), pen.origin(t));
        let (c, d) = (pen.origin(n1.twin()), pen.origin(n2.twin()));

        rec.step(1, "Let no vertex and no face point to a half-edge that leaves it.");
        if pen.has_outgoing(a, h) {
            pen.set_outgoing(a, Some(n2), rec);
        }
        if pen.has_outgoing(b, t) {
            pen.set_outgoing(b, Some(n1), rec);
        }
        if pen.has_half_edge(f, n1) {
            pen.set_half_edge(f, Some(h), rec);
        }
        if pen.has_half_edge(g, n2) {
            pen.set_half_edge(g, Some(t), rec);
        }

        rec.step(2, "Move both ends of the edge to the next corner.");
        pen.set_origin(h, d, rec);
        pen.set_origin(t, c, rec);

        rec.step(3, "Make the cyclic lists run along the new places.");
        for (edge, after, last, gained) in [(h, after1, p1, n2), (t, after2, p2, n1)] {
            if after == edge {
                // A face of two sides has nothing between the edge and what it gains.
                pen.set_next(edge, gained, rec);
            } else {
                pen.set_next(edge, after, rec);
                pen.set_next(last, gained, rec);
            }
            pen.set_next(gained, edge, rec);
        }

        rec.step(4, "Make the two half-edges that changed sides point to the right face.");
        pen.set_face(n1, g, rec);
        pen.set_face(n2, f, rec);
    }
}
