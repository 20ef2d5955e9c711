//! Splitting a face along a new edge.
//!
//! ```text
//!            h1 ┌──>──●                       h1 ┌──>──●
//!               │                                │
//!      p1 ──>── ●  origin(h1)           p1 ──>── ●                a = origin(h1) -> origin(h2)
//!                                            a │ ^ │ old face     b = its twin
//!        one face f           ==>     new face │ │ │ f
//!                                              v │ b
//!               ●  origin(h2)                    ● ──<── p2
//!    h2 ──<──┘  │                      h2 ──<──┘
//!               └──<── p2
//! ```
//!
//! The cycle through `h1` keeps the face; the cycle through `h2` gets the new one, which lies on the LEFT of
//! the returned half-edge `a`. Inverse: [`join_faces`](Dcel::join_faces) of `a`.

use crate::ids::{FaceId, HalfEdgeId};
use crate::topology::Dcel;
use crate::topology::pool::{IdError, TooMany};
use crate::topology::record::{NoRecorder, Recorder};

/// Why a face cannot be split between the origins of two half-edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SplitFaceError {
    /// One of the half-edges does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The two half-edges bound different faces.
    #[error("{h1} bounds {f1}, but {h2} bounds {f2}: choose two half-edges of the same face")]
    DifferentFaces {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// Its face.
        f1: FaceId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// Its face.
        f2: FaceId,
    },
    /// Both arguments are the same half-edge: the new edge would start and end at the same corner.
    #[error("{h} was given twice: the new edge needs two different corners of the face")]
    SameHalfEdge {
        /// The half-edge.
        h: HalfEdgeId,
    },
    /// The second follows the first: their origins are joined by an edge already.
    #[error("{h2} is next of {h1}: their origins are the two ends of {h1}; choose corners further apart")]
    NextOf {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The one after it.
        h2: HalfEdgeId,
    },
    /// The second comes just before the first: their origins are joined by an edge already.
    #[error("{h2} is prev of {h1}: their origins are the two ends of {h2}; choose corners further apart")]
    PrevOf {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The one before it.
        h2: HalfEdgeId,
    },
    /// The two half-edges bound the same face, but on different cycles: an edge between them would join the
    /// cycles and split nothing.
    #[error("{h1} and {h2} lie on different boundary cycles of {face}: an edge between them splits no face")]
    DifferentCycles {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// Their common face.
        face: FaceId,
    },
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Dcel {
    /// Whether [`split_face`](Self::split_face) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(length of the part of the cycle from `h2` to `h1`).
    #[inline]
    pub fn can_split_face(&self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(), SplitFaceError> {
        self.check(h1)?;
        self.check(h2)?;
        let (f1, f2) = (self.face(h1), self.face(h2));
        if f1 != f2 {
            return Err(SplitFaceError::DifferentFaces { h1, f1, h2, f2 });
        }
        if h1 == h2 {
            return Err(SplitFaceError::SameHalfEdge { h: h1 });
        }
        if self.next(h1) == h2 {
            return Err(SplitFaceError::NextOf { h1, h2 });
        }
        if self.prev(h1) == h2 {
            return Err(SplitFaceError::PrevOf { h1, h2 });
        }
        if !self.cycle(h2).any(|h| h == h1) {
            return Err(SplitFaceError::DifferentCycles { h1, h2, face: f1 });
        }
        Ok(self.room_for(0, 1, 1)?)
    }

    /// The lab's `splitFace`: joins the origins of `h1` and `h2`, which bound the same face, by a new edge.
    ///
    /// Returns the new half-edge from `origin(h1)` to `origin(h2)` and the new face, which lies on its left.
    /// The cycle through `h1` keeps the old face. Each of the two faces gets one of the two new half-edges as
    /// its `half_edge`. A half-edge, not a vertex, names each corner, because a face may pass a vertex twice.
    ///
    /// Cost: O(length of the new face's cycle): choose the order of the arguments so that it is the short one.
    ///
    /// # Errors
    /// See [`SplitFaceError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::topology::{Dcel, SplitFaceError};
    /// let mut square = Dcel::polygon(4)?;
    /// let h: Vec<_> = square.incident_half_edges(dcel_kit::FaceId::new(1)).collect();
    /// let (a, new) = square.split_face(h[0], h[2])?;
    /// assert_eq!((square.origin(a), square.destination(a)), (square.origin(h[0]), square.origin(h[2])));
    /// assert_eq!((square.face(a), square.face(h[2])), (new, new));
    /// assert_eq!(square.split_face(a, h[0]), Err(SplitFaceError::DifferentFaces { h1: a, f1: new, h2: h[0], f2: dcel_kit::FaceId::new(1) }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        self.split_face_with(h1, h2, &mut NoRecorder)
    }

    /// [`split_face`](Self::split_face), watched by a recorder. The steps are those of the lab's handout.
    pub fn split_face_with(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        self.can_split_face(h1, h2)?;
        Ok(self.split_face_unchecked(h1, h2, rec))
    }

    /// The write phase. `h1` and `h2` must have passed [`can_split_face`](Self::can_split_face).
    #[inline]
    pub(crate) fn split_face_unchecked(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl Recorder,
    ) -> (HalfEdgeId, FaceId) {
        let (v1, v2) = (self.origin(h1), self.origin(h2));
        let (p1, p2) = (self.prev(h1), self.prev(h2));
        let old = self.face(h1);

        rec.step(1, "Create a new face for the second half of the split.");
        let new = self.add_face_record(rec);

        rec.step(2, "Create two new half-edges for the splitting edge.");
        let [a, b] = self.add_edge_record(rec).half_edges();
        let mut pen = self.pen();
        pen.set_origin(a, v1, rec);
        pen.set_origin(b, v2, rec);

        rec.step(3, "Insert the new half-edges into the cyclic lists.");
        pen.set_next(p1, a, rec);
        pen.set_next(a, h2, rec);
        pen.set_next(p2, b, rec);
        pen.set_next(b, h1, rec);

        rec.step(4, "Make all half-edges point to the right face.");
        pen.set_face(b, old, rec);
        pen.set_face(a, new, rec);
        let mut h = h2;
        while h != a {
            pen.set_face(h, new, rec);
            h = pen.next(h);
        }

        rec.step(5, "Make both faces point to one of their half-edges.");
        pen.set_half_edge(new, Some(a), rec);
        pen.set_half_edge(old, Some(b), rec);
        (a, new)
    }
}
