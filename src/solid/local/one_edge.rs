//! Edits of one edge on a surface: those of the kernel, with places, and with an eye on borders.
//!
//! ```text
//!   split_edge   ●────●  ==>  ●──●──●      split_face   ┌──┐  ==>  ┌──┐      flip_edge   ┌──┐  ==>  ┌──┐
//!   join_edges        <==                  join_faces   └──┘  <==  └─╱┘                  │╱ │       │ ╲│
//! ```
//!
//! The surface stays simple: no edit here makes a second edge between two vertices, and none touches a border from the
//! side where there is no surface.

use crate::geometry::space::check_place;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{FlipEdgeError, JoinEdgesError, JoinFacesError, NoRecorder, SplitEdgeError, SplitFaceError};

/// Why an edge or a face of a surface cannot be edited.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceEditError {
    /// The structure forbids to split the edge.
    #[error(transparent)]
    SplitEdge(#[from] SplitEdgeError),
    /// The structure forbids to join the edges.
    #[error(transparent)]
    JoinEdges(#[from] JoinEdgesError),
    /// The structure forbids to split the face.
    #[error(transparent)]
    SplitFace(#[from] SplitFaceError),
    /// The structure forbids to join the faces.
    #[error(transparent)]
    JoinFaces(#[from] JoinFacesError),
    /// The structure forbids to flip the edge.
    #[error(transparent)]
    FlipEdge(#[from] FlipEdgeError),
    /// The place of the new vertex.
    #[error("the point on {h}: {error}")]
    Coordinate {
        /// The half-edge.
        h: HalfEdgeId,
        /// What is wrong with the point.
        error: CoordinateError,
    },
    /// The face stands for a border.
    #[error("{face} beside {h} stands for a border of the surface; choose a half-edge between two faces of it")]
    OnBorder {
        /// The half-edge.
        h: HalfEdgeId,
        /// The boundary face.
        face: FaceId,
    },
    /// There would be two edges between two vertices.
    #[error("{from} and {to} are joined by {existing} already, and a second edge there would close nothing in between")]
    EdgeExists {
        /// One vertex.
        from: VertexId,
        /// The other vertex.
        to: VertexId,
        /// A half-edge of the edge between them.
        existing: HalfEdgeId,
    },
    /// A face would have two corners only.
    #[error("without {vertex}, {face} would have two sides; join the faces beside it instead")]
    TwoSided {
        /// The vertex that would go.
        vertex: VertexId,
        /// The face.
        face: FaceId,
    },
    /// An end of the edge would lose its second last edge.
    #[error("without {h}, {vertex} would be the end of a dangling edge; remove a face instead")]
    Dangling {
        /// The half-edge.
        h: HalfEdgeId,
        /// The vertex.
        vertex: VertexId,
    },
    /// The two faces have more than the one edge in common.
    #[error("{} and {} have more than {h} in common; join the edges between them first", faces[0], faces[1])]
    TouchTwice {
        /// The half-edge.
        h: HalfEdgeId,
        /// The two faces.
        faces: [FaceId; 2],
    },
}

impl Polyhedron {
    fn no_border(&self, h: HalfEdgeId) -> Result<(), SurfaceEditError> {
        match [h, h.twin()].into_iter().find(|&side| self.is_border(side)) {
            Some(side) => Err(SurfaceEditError::OnBorder { h, face: self.dcel.face(side) }),
            None => Ok(()),
        }
    }

    /// Fails if an end of the edge has but one other edge.
    fn no_dangling(&self, h: HalfEdgeId) -> Result<(), SurfaceEditError> {
        let thin = |&side: &HalfEdgeId| self.dcel.ccw(side) == self.dcel.cw(side);
        match [h, h.twin()].into_iter().find(thin) {
            Some(side) => Err(SurfaceEditError::Dangling { h, vertex: self.dcel.origin(side) }),
            None => Ok(()),
        }
    }

    fn no_edge(&self, from: VertexId, to: VertexId) -> Result<(), SurfaceEditError> {
        match self.dcel.find_half_edge(from, to) {
            Some(existing) => Err(SurfaceEditError::EdgeExists { from, to, existing }),
            None => Ok(()),
        }
    }

    /// Splits an edge by a new vertex at a place; see [`Dcel::split_edge`](crate::topology::Dcel::split_edge). Returns
    /// the new vertex and the half-edge that now follows `h`. On a border, too. Inverse:
    /// [`join_edges`](Self::join_edges) of `h`. O(1).
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn split_edge(&mut self, h: HalfEdgeId, place: [f64; 3]) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.split_edge_with(h, place, &mut NoRecorder)
    }

    /// [`split_edge`](Self::split_edge), watched by a recorder.
    pub fn split_edge_with(
        &mut self,
        h: HalfEdgeId,
        place: [f64; 3],
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.dcel.can_split_edge(h)?;
        check_place(place).map_err(|error| SurfaceEditError::Coordinate { h, error })?;
        let (v, rest) = self.dcel.split_edge_unchecked(h, rec);
        self.place(v, place, rec);
        Ok((v, rest))
    }

    /// [`split_edge`](Self::split_edge) in the middle between the two ends. O(1).
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn split_in_half(&mut self, h: HalfEdgeId) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.split_in_half_with(h, &mut NoRecorder)
    }

    /// [`split_in_half`](Self::split_in_half), watched by a recorder.
    pub fn split_in_half_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.dcel.can_split_edge(h)?;
        let place = self.along(h, 0.5).map_err(|error| SurfaceEditError::Coordinate { h, error })?;
        self.split_edge_with(h, place, rec)
    }

    /// Splits an edge in its middle and joins the new vertex to the third corner of each triangle beside it, which is
    /// split, too. On a border one triangle is. Returns the new vertex and the half-edge that now follows `h`.
    ///
    /// ```text
    ///        c                      c          V + 1, and for each triangle E + 1 and F + 1 more than
    ///      ╱   ╲                  ╱ │ ╲        split_edge. A face with more sides is not split.
    ///    a ──h─> b     ==>      a ─ m ─ b
    ///      ╲   ╱                  ╲ │ ╱
    ///        d                      d
    /// ```
    ///
    /// Inverse: joining the triangles again, then [`join_edges`](Self::join_edges). O(1).
    ///
    /// Source: Scotty3D, *split edge*.
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn bisect_edge(&mut self, h: HalfEdgeId) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.bisect_edge_with(h, &mut NoRecorder)
    }

    /// [`bisect_edge`](Self::bisect_edge), watched by a recorder.
    pub fn bisect_edge_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(VertexId, HalfEdgeId), SurfaceEditError> {
        self.dcel.can_split_edge(h)?;
        self.dcel.room_for(1, 3, 2).map_err(SplitEdgeError::from)?;
        let is_triangle = |side: HalfEdgeId| !self.is_border(side) && self.dcel.cycle(side).take(4).count() == 3;
        let [left, right] = [h, h.twin()].map(|side| is_triangle(side).then(|| self.dcel.prev(side)));
        let (v, rest) = self.split_in_half_with(h, rec)?;
        // The half-edges that start at the new vertex, on the left of the edge and on its right.
        for (third, start) in [(left, rest), (right, h.twin())] {
            if let Some(third) = third {
                self.dcel.split_face_unchecked(start, third, rec);
            }
        }
        Ok((v, rest))
    }

    /// Joins `h` with the half-edge after it; the vertex between them, which must have no other edge, goes. Returns it.
    /// O(1), and O(degree) to see that no second edge comes to be.
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn join_edges(&mut self, h: HalfEdgeId) -> Result<VertexId, SurfaceEditError> {
        self.join_edges_with(h, &mut NoRecorder)
    }

    /// [`join_edges`](Self::join_edges), watched by a recorder.
    pub fn join_edges_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<VertexId, SurfaceEditError> {
        self.dcel.can_join_edges(h)?;
        let vertex = self.dcel.destination(h);
        if let Some(side) = [h, h.twin()].into_iter().find(|&side| self.dcel.cycle(side).take(4).count() < 4) {
            return Err(SurfaceEditError::TwoSided { vertex, face: self.dcel.face(side) });
        }
        self.no_edge(self.dcel.origin(h), self.dcel.destination(self.dcel.next(h)))?;
        Ok(self.dcel.join_edges_unchecked(h, rec))
    }

    /// Splits a face by an edge between two of its corners; see
    /// [`Dcel::split_face`](crate::topology::Dcel::split_face). Inverse: [`join_faces`](Self::join_faces) of the
    /// half-edge it returns. Cost: O(length of the face, degree).
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SurfaceEditError> {
        self.split_face_with(h1, h2, &mut NoRecorder)
    }

    /// [`split_face`](Self::split_face), watched by a recorder.
    pub fn split_face_with(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(HalfEdgeId, FaceId), SurfaceEditError> {
        self.dcel.can_split_face(h1, h2)?;
        if self.is_border(h1) {
            return Err(SurfaceEditError::OnBorder { h: h1, face: self.dcel.face(h1) });
        }
        self.no_edge(self.dcel.origin(h1), self.dcel.origin(h2))?;
        Ok(self.dcel.split_face_unchecked(h1, h2, rec))
    }

    /// Joins the two faces at `h`; the edge goes, and so does the face of `h`, which is returned. The edge must be all
    /// that the two faces have in common, corners included. Cost: O(length of both faces and degrees of their corners).
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn join_faces(&mut self, h: HalfEdgeId) -> Result<FaceId, SurfaceEditError> {
        self.join_faces_with(h, &mut NoRecorder)
    }

    /// [`join_faces`](Self::join_faces), watched by a recorder.
    pub fn join_faces_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<FaceId, SurfaceEditError> {
        self.dcel.can_join_faces(h)?;
        self.no_border(h)?;
        let t = h.twin();
        self.no_dangling(h)?;
        let mut near: Vec<VertexId> = self.dcel.cycle(h).map(|g| self.dcel.origin(g)).collect();
        near.sort_unstable();
        let both = self.dcel.cycle(t).filter(|&g| near.binary_search(&self.dcel.origin(g)).is_ok()).count();
        if both > 2 {
            return Err(SurfaceEditError::TouchTwice { h, faces: [self.dcel.face(h), self.dcel.face(t)] });
        }
        Ok(self.dcel.join_faces_unchecked(h, rec))
    }

    /// Turns the edge of `h` inside the two faces beside it: both its ends move one corner on, counter-clockwise. All
    /// ids stay. Between triangles, two flips turn the edge round, and four change nothing. O(degree).
    ///
    /// # Errors
    /// [`SurfaceEditError`]; a refused call leaves everything bit for bit as it was.
    pub fn flip_edge(&mut self, h: HalfEdgeId) -> Result<(), SurfaceEditError> {
        self.flip_edge_with(h, &mut NoRecorder)
    }

    /// [`flip_edge`](Self::flip_edge), watched by a recorder.
    pub fn flip_edge_with(&mut self, h: HalfEdgeId, rec: &mut impl SurfaceRecorder) -> Result<(), SurfaceEditError> {
        self.dcel.can_flip_edge(h)?;
        self.no_border(h)?;
        let t = h.twin();
        self.no_dangling(h)?;
        let ends = [t, h].map(|side| self.dcel.destination(self.dcel.next(side)));
        self.no_edge(ends[0], ends[1])?;
        self.dcel.flip_edge_unchecked(h, rec);
        Ok(())
    }
}
