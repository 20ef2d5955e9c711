//! Taking a face away; its place becomes border.
//!
//! ```text
//!      ●─────●─────●            ●─────●
//!      │  f  │ gone│    ==>     │  f  │          edges that have no face left go with it,
//!      ●─────●─────●            ●─────●          vertices stay, without edges if need be
//! ```
//!
//! Inverse: [`add_face`](Polyhedron::add_face) with the same corners.

use crate::ids::{FaceId, HalfEdgeId};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{IdError, NoRecorder, TooMany};

/// Why a face cannot be removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RemoveFaceError {
    /// The face does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// It is a boundary face.
    #[error("{face} is no face of the surface but stands for a border: it goes when the border is filled by faces")]
    BoundaryFace {
        /// The face.
        face: FaceId,
    },
    /// No id is left for the boundary faces that would take its place.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Polyhedron {
    /// Takes away the face `f` and the edges that have no other face. Vertices stay.
    ///
    /// Cost: O(k log k) for k corners; if border cycles are cut or joined, the length of the second longest
    /// stretch.
    ///
    /// # Errors
    /// [`RemoveFaceError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// # use dcel_kit::{solid::Polyhedron, topology::PolygonList, FaceId};
    /// # let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    /// # let faces = PolygonList::from_triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let mut tetrahedron = Polyhedron::from_polygons(corners, &faces)?;
    /// tetrahedron.remove_face(FaceId::new(2))?;
    /// assert_eq!((tetrahedron.edge_count(), tetrahedron.boundary_faces().len()), (6, 1));
    /// tetrahedron.remove_face(FaceId::new(3))?;
    /// assert_eq!((tetrahedron.edge_count(), tetrahedron.boundary_faces().len()), (5, 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove_face(&mut self, f: FaceId) -> Result<(), RemoveFaceError> {
        self.remove_face_with(f, &mut NoRecorder)
    }

    /// [`remove_face`](Self::remove_face), watched by a recorder.
    pub fn remove_face_with(&mut self, f: FaceId, rec: &mut impl SurfaceRecorder) -> Result<(), RemoveFaceError> {
        self.dcel.check(f)?;
        if self.is_boundary_face(f) {
            return Err(RemoveFaceError::BoundaryFace { face: f });
        }
        let sides: Vec<HalfEdgeId> = self.dcel.incident_half_edges(f).collect();
        self.dcel.room_for(0, 0, sides.len())?;
        self.remove_face_unchecked(f, &sides, rec);
        Ok(())
    }

    /// The write phase: `sides` are the half-edges of `f`.
    pub(super) fn remove_face_unchecked(&mut self, f: FaceId, sides: &[HalfEdgeId], rec: &mut impl SurfaceRecorder) {
        let mut starts = Vec::with_capacity(2 * sides.len());
        let mut touched = Vec::with_capacity(sides.len());
        for &h in sides {
            // The other half of an edge with `f` on both sides has taken it away already.
            if !self.dcel.has_half_edge(h) {
                continue;
            }
            let behind = self.dcel.face(h.twin());
            if behind == f || self.boundary_faces.contains(&behind) {
                touched.extend(Some(behind).filter(|&behind| behind != f));
                self.splice_out(h, &mut starts, rec);
            } else {
                starts.push(h);
                self.dcel.set_outgoing(self.dcel.origin(h), Some(h), rec);
            }
        }
        self.renew_borders(starts, touched, rec);
        self.dcel.remove_face_record(f, rec);
    }

    /// Takes an edge out that has no face any more on either side. What follows it on the border is added to
    /// `starts`. O(1).
    pub(super) fn splice_out(&mut self, h: HalfEdgeId, starts: &mut Vec<HalfEdgeId>, rec: &mut impl SurfaceRecorder) {
        for half in [h, h.twin()] {
            let v = self.dcel.origin(half);
            let (before, after) = (self.dcel.prev(half), self.dcel.next(half.twin()));
            if before == half.twin() {
                self.dcel.set_outgoing(v, None, rec);
            } else {
                self.dcel.set_next(before, after, rec);
                starts.push(after);
                if self.dcel.outgoing(v) == Some(half) {
                    self.dcel.set_outgoing(v, Some(after), rec);
                }
            }
        }
        self.dcel.remove_edge_record(h.edge(), rec);
    }
}
