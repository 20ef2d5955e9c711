//! Joining two faces of a subdivision by taking away an edge between them.
//!
//! ```text
//!   ┌───────────┬───────┐          ┌───────────────────┐
//!   │  kept    h│ gone  │          │  kept             │      The inner components of both faces end up in the one that
//!   │   ┌─┐     │  ┌─┐  │    ==>   │   ┌─┐        ┌─┐  │      stays. f0 always stays.
//!   │   └─┘     │  └─┘  │          │   └─┘        └─┘  │
//!   └───────────┴───────┘          └───────────────────┘
//! ```

use crate::ids::{FaceId, HalfEdgeId};
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{self, InnerComponent, NoRecorder};

/// Why the faces on both sides of a half-edge cannot be joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinFacesError {
    /// The half-edge does not separate two faces.
    #[error(transparent)]
    Topology(#[from] topology::JoinFacesError),
    /// One of the faces is a hole of the domain, the other a bounded part of the domain.
    #[error("{hole} is a hole and {face} is not: say first with set_hole which of the two the joined face is to be")]
    HoleAndDomain {
        /// The hole face.
        hole: FaceId,
        /// The face of the domain.
        face: FaceId,
    },
}

impl Subdivision {
    /// Whether [`join_faces`](Self::join_faces) would succeed, and if not, why. Changes nothing. O(log holes).
    pub fn can_join_faces(&self, h: HalfEdgeId) -> Result<(), JoinFacesError> {
        self.dcel.can_join_faces(h)?;
        let [f, g] = [self.dcel.face(h), self.dcel.face(h.twin())];
        match (self.is_hole(f), self.is_hole(g)) {
            (true, false) if g != self.outer_face() => Err(JoinFacesError::HoleAndDomain { hole: f, face: g }),
            (false, true) if f != self.outer_face() => Err(JoinFacesError::HoleAndDomain { hole: g, face: f }),
            _ => Ok(()),
        }
    }

    /// Takes away the edge of `h` and the face of `h`; the face of `twin(h)` takes its place. If the face of
    /// `h` is `f0`, it stays and the other one goes. Returns the face that is gone.
    ///
    /// Cost: O(number of half-edges of the face that goes, and of the cycles of `h` and its twin).
    ///
    /// # Errors
    /// See [`JoinFacesError`]; a refused call leaves everything bit for bit as it was.
    pub fn join_faces(&mut self, h: HalfEdgeId) -> Result<FaceId, JoinFacesError> {
        self.join_faces_with(h, &mut NoRecorder)
    }

    /// [`join_faces`](Self::join_faces), watched by a recorder.
    pub fn join_faces_with(&mut self, h: HalfEdgeId, rec: &mut impl PlaneRecorder) -> Result<FaceId, JoinFacesError> {
        self.can_join_faces(h)?;
        let h = if self.dcel.face(h) == self.outer_face() { h.twin() } else { h };
        let (gone, kept) = (self.dcel.face(h), self.dcel.face(h.twin()));
        let gone_around = !self.is_on_outer_boundary(h);
        let kept_around = !self.is_on_outer_boundary(h.twin());
        let gone_boundary = self.dcel.half_edge(gone);

        let mut gone_rings = self.take_inner_components(gone, rec);
        let mut kept_rings = self.take_inner_components(kept, rec);
        let in_gone = if gone_around { self.inner_component_index(&gone_rings, h) } else { None };
        let in_kept = if kept_around { self.inner_component_index(&kept_rings, h.twin()) } else { None };
        let rest = self.dcel.next(h.twin());

        self.dcel.join_faces_unchecked(h, rec);
        if let Some(i) = in_kept {
            kept_rings[i] = InnerComponent::Cycle(rest);
        }
        if let Some(i) = in_gone {
            // The face that goes surrounds the one that stays: its outer boundary becomes the common one.
            gone_rings[i] = InnerComponent::Cycle(rest);
            self.dcel.set_half_edge(kept, gone_boundary, rec);
            if let Some(start) = gone_boundary {
                self.relabel_cycle(start, kept, rec);
            }
        }
        for (i, &ring) in gone_rings.iter().enumerate() {
            if Some(i) != in_gone {
                self.relabel_inner_component(ring, kept, rec);
            }
        }
        kept_rings.append(&mut gone_rings);
        self.give_inner_components(kept, kept_rings, rec);
        self.mark_hole(gone, false, rec);
        Ok(gone)
    }

    /// Says whether a bounded face is a hole, that is, not part of the domain. Returns what it was before; for
    /// `f0` and for faces that do not exist nothing changes and the answer is `None`.
    pub fn set_hole(&mut self, f: FaceId, hole: bool) -> Option<bool> {
        self.set_hole_with(f, hole, &mut NoRecorder)
    }

    /// [`set_hole`](Self::set_hole), watched by a recorder.
    pub fn set_hole_with(&mut self, f: FaceId, hole: bool, rec: &mut impl PlaneRecorder) -> Option<bool> {
        (f != self.outer_face() && self.dcel.has_face(f)).then(|| self.mark_hole(f, hole, rec))
    }
}
