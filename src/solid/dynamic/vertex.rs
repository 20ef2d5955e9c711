//! Vertices come alone and go with their faces.
//!
//! ```text
//!      ●───●───●              ●       ●
//!      │ ╲ │ ╱ │              │ ╲   ╱ │       remove_vertex(v) takes the faces round v, then v. Vertices that
//!      │   v   │     ==>      │       │       lose their last face stay.
//!      │ ╱   ╲ │              │ ╱   ╲ │
//!      ●───────●              ●───────●
//! ```

use crate::geometry::space::check_place;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{IdError, NoRecorder, TooMany};
use std::collections::BTreeSet;

/// Why a vertex cannot be added.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AddVertexError {
    /// A coordinate that cannot be used.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// Why a vertex cannot be removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RemoveVertexError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// No id is left for the boundary faces that would take the place of its faces.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Polyhedron {
    /// Adds a vertex without edges. Removed ids are given out again, the last one first. O(1).
    ///
    /// # Errors
    /// [`AddVertexError`]; then nothing has changed.
    pub fn add_vertex(&mut self, point: [f64; 3]) -> Result<VertexId, AddVertexError> {
        self.add_vertex_with(point, &mut NoRecorder)
    }

    /// [`add_vertex`](Self::add_vertex), watched by a recorder.
    pub fn add_vertex_with(
        &mut self,
        point: [f64; 3],
        rec: &mut impl SurfaceRecorder,
    ) -> Result<VertexId, AddVertexError> {
        check_place(point)?;
        self.dcel.room_for(1, 0, 0)?;
        let v = self.dcel.add_vertex_record(rec);
        self.place(v, point, rec);
        Ok(v)
    }

    /// Removes a vertex and the faces it is a corner of, which are returned in the order round the vertex.
    ///
    /// Cost: that of removing the faces one by one.
    ///
    /// # Errors
    /// [`RemoveVertexError`]; a refused call leaves everything bit for bit as it was.
    pub fn remove_vertex(&mut self, v: VertexId) -> Result<Vec<FaceId>, RemoveVertexError> {
        self.remove_vertex_with(v, &mut NoRecorder)
    }

    /// [`remove_vertex`](Self::remove_vertex), watched by a recorder.
    pub fn remove_vertex_with(
        &mut self,
        v: VertexId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<Vec<FaceId>, RemoveVertexError> {
        self.dcel.check(v)?;
        // A face that passes the vertex twice is met twice.
        let mut met = BTreeSet::new();
        let round = self.dcel.incident_faces(v).filter(|&f| !self.is_boundary_face(f) && met.insert(f));
        let faces: Vec<FaceId> = round.collect();
        let corners = faces.iter().map(|&f| self.dcel.incident_half_edges(f).count()).sum();
        self.dcel.room_for(0, 0, corners)?;
        for &f in &faces {
            let sides: Vec<HalfEdgeId> = self.dcel.incident_half_edges(f).collect();
            self.remove_face_unchecked(f, &sides, rec);
        }
        // Edges with a border on both sides belong to no face.
        while let Some(h) = self.dcel.outgoing(v) {
            let touched = h.edge().half_edges().map(|h| self.dcel.face(h)).to_vec();
            let mut starts = Vec::new();
            self.splice_out(h, &mut starts, rec);
            self.renew_borders(starts, touched, rec);
        }
        self.dcel.remove_vertex_record(v, rec);
        Ok(faces)
    }
}
