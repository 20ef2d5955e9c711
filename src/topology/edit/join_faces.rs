//! Joining two faces by taking away an edge between them.
//!
//! ```text
//!      p1 ──>── ● ──>── n2                p1 ──>── ● ──>── n2
//!             ^ │
//!    gone   h │ │ twin(h)   kept    ==>            kept
//!             │ v
//!      n1 ──<── ● ──<── p2                n1 ──<── ● ──<── p2
//! ```
//!
//! The face of `h` goes; the face of its twin stays and takes over the whole cycle.
//! Inverse of [`split_face`](Dcel::split_face): joining at the half-edge it returned undoes it.

use crate::ids::{FaceId, HalfEdgeId};
use crate::topology::Dcel;
use crate::topology::pool::IdError;
use crate::topology::record::{NoRecorder, Recorder};

/// Why the faces on both sides of a half-edge cannot be joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinFacesError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The same face lies on both sides: taking the edge away would cut the boundary apart.
    #[error("{face} lies on both sides of {h}: there are no two faces to join; choose an edge between two faces")]
    SameFace {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face on both sides.
        face: FaceId,
    },
    /// The edge is a loop on its own: without it the remaining face would have no boundary.
    #[error("{h} is a loop and the only edge of both faces: without it no boundary is left")]
    LastEdge {
        /// The half-edge.
        h: HalfEdgeId,
    },
}

impl Dcel {
    /// Whether [`join_faces`](Self::join_faces) would succeed, and if not, why. Changes nothing. O(1).
    pub fn can_join_faces(&self, h: HalfEdgeId) -> Result<(), JoinFacesError> {
        self.check(h)?;
        let t = h.twin();
        if self.face(h) == self.face(t) {
            return Err(JoinFacesError::SameFace { h, face: self.face(h) });
        }
        if self.next(h) == h && self.next(t) == t {
            return Err(JoinFacesError::LastEdge { h });
        }
        Ok(())
    }

    /// Takes away the edge of `h` and the face of `h`; the face of `twin(h)` takes its place. Returns the
    /// removed face.
    ///
    /// Cost: O(length of the removed face's cycle).
    ///
    /// # Errors
    /// See [`JoinFacesError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{FaceId, topology::Dcel};
    /// let mut square = Dcel::polygon(4)?;
    /// let h: Vec<_> = square.incident_half_edges(FaceId::new(1)).collect();
    /// let (a, new) = square.split_face(h[0], h[2])?;
    /// assert_eq!(square.join_faces(a)?, new);
    /// assert_eq!(square.incident_half_edges(FaceId::new(1)).count(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn join_faces(&mut self, h: HalfEdgeId) -> Result<FaceId, JoinFacesError> {
        self.join_faces_with(h, &mut NoRecorder)
    }

    /// [`join_faces`](Self::join_faces), watched by a recorder.
    pub fn join_faces_with(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> Result<FaceId, JoinFacesError> {
        self.can_join_faces(h)?;
        Ok(self.join_faces_unchecked(h, rec))
    }

    /// The write phase. `h` must have passed [`can_join_faces`](Self::can_join_faces).
    pub(crate) fn join_faces_unchecked(&mut self, h: HalfEdgeId, rec: &mut impl Recorder) -> FaceId {
        let (a, b) = (h, h.twin());
        let (gone, kept) = (self.face(a), self.face(b));

        rec.step(1, "Make all half-edges of the joined face point to the remaining face.");
        let mut at = self.next(a);
        while at != a {
            self.set_face(at, kept, rec);
            at = self.next(at);
        }
        self.lead_past_edge(a, kept, rec);

        rec.step(4, "Remove the edge and the face.");
        self.remove_edge_record(a.edge(), rec);
        self.remove_face_record(gone, rec);
        gone
    }

    /// Leads all links past the edge of `h`, so that it can be removed: those of the cycles on its two sides, which become
    /// one, of its ends, and of the face `kept`, which lies on the right of `h` as far as links show it. O(1).
    pub(crate) fn lead_past_edge(&mut self, h: HalfEdgeId, kept: FaceId, rec: &mut impl Recorder) {
        let (a, b) = (h, h.twin());
        let (p1, n1) = (self.prev(a), self.next(a));
        let (p2, n2) = (self.prev(b), self.next(b));
        // A loop that bounds a face alone leaves the other face's cycle as it is.
        let (after_a, after_b) = (if n1 == a { n2 } else { n1 }, if n2 == b { n1 } else { n2 });

        rec.step(2, "Let no vertex and no face point to the edge that goes.");
        if self.outgoing(self.origin(a)) == Some(a) {
            self.set_outgoing(self.origin(a), Some(after_b), rec);
        }
        if self.outgoing(self.origin(b)) == Some(b) {
            self.set_outgoing(self.origin(b), Some(after_a), rec);
        }
        if self.half_edge(kept) == Some(b) {
            self.set_half_edge(kept, Some(after_b), rec);
        }

        rec.step(3, "Take the two half-edges out of the cyclic lists.");
        if n1 == a {
            self.set_next(p2, n2, rec);
        } else if n2 == b {
            self.set_next(p1, n1, rec);
        } else {
            self.set_next(p1, n2, rec);
            self.set_next(p2, n1, rec);
        }
    }
}
