//! A face takes the place of a vertex.
//!
//! ```text
//!            │                       │           V + d - 1, E + d, F + 1 for d edges at v. The face has a corner on
//!            │                       ●           each of them, as far from v as a share t of the edge; v is the
//!            │                     ╱   ╲         corner on one of them. Where the surface ends at v, the border
//!        ─── v ───      ==>    ───●─────v───     runs along a side of the new face.
//! ```

use super::hub::Spoke;
use crate::geometry::space::check_place;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::solid::vector::{minus, plus, times};
use crate::topology::{IdError, NoRecorder, TooMany};

/// Why a vertex cannot be cut off.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BevelVertexError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// Fewer than three edges.
    #[error("{vertex} has {degree} edge{}: the face in its place needs three; split a face there first", if *.degree == 1 { "" } else { "s" })]
    TooFewEdges {
        /// The vertex.
        vertex: VertexId,
        /// How many edges it has.
        degree: usize,
    },
    /// Not a share of an edge.
    #[error("{share} is no share of an edge: use a number between 0 and 1, both excluded")]
    Share {
        /// The number.
        share: f64,
    },
    /// A corner would lie where coordinates cannot be used.
    #[error("the corner on {spoke}: {error}")]
    Coordinate {
        /// The half-edge that it would lie on.
        spoke: HalfEdgeId,
        /// What is wrong with it.
        error: CoordinateError,
    },
}

impl Polyhedron {
    /// Whether [`bevel_vertex`](Self::bevel_vertex) would succeed, and if not, why. Changes nothing. O(degree).
    pub fn can_bevel_vertex(&self, v: VertexId, share: f64) -> Result<(), BevelVertexError> {
        self.plan_bevel_vertex(v, share).map(drop)
    }

    fn plan_bevel_vertex(&self, v: VertexId, share: f64) -> Result<Vec<Spoke>, BevelVertexError> {
        self.dcel.check(v)?;
        let degree = self.dcel.degree(v);
        if degree < 3 {
            return Err(BevelVertexError::TooFewEdges { vertex: v, degree });
        }
        if !(share > 0.0 && share < 1.0) {
            return Err(BevelVertexError::Share { share });
        }
        self.dcel.room_for(degree - 1, 2 * degree, degree)?;
        let corner = |(i, out)| {
            let place = self.along(out, share).map_err(|error| BevelVertexError::Coordinate { spoke: out, error })?;
            Ok(Spoke { out, place, stays: i == 0 })
        };
        self.dcel.outgoing_half_edges(v).enumerate().map(corner).collect()
    }

    /// The place on a half-edge after a share of its length.
    pub(super) fn along(&self, h: HalfEdgeId, share: f64) -> Result<[f64; 3], CoordinateError> {
        let [from, to] = [self.dcel.origin(h), self.dcel.destination(h)].map(|v| self.points[v]);
        let place = plus(from, times(minus(to, from), share));
        check_place(place)?;
        Ok(place)
    }

    /// Cuts off the corner of the surface at `v`: a new face gets a corner on every edge of `v`, after a `share` of its
    /// length, and `v` becomes the corner on `outgoing(v)`. The faces round `v` get one side more, and keep their
    /// numbers. Returns the side of the new face that starts at `v`, and the new face.
    ///
    /// Property: the new face has as many sides as `v` had edges. Inverse: joining the corners of the new face, one side
    /// after the other, and then the two faces at the loop that is left.
    ///
    /// Cost: O(degree, and the sizes of the faces round `v`).
    ///
    /// # Errors
    /// See [`BevelVertexError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// Source: Scotty3D, *bevel vertex*; the solid with all vertices cut off is the truncated one.
    ///
    /// ```
    /// use dcel_kit::{VertexId, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// let (side, face) = cube.bevel_vertex(VertexId::new(0), 0.25)?;
    /// assert_eq!((cube.incident_vertices(face).count(), cube.face(side)), (3, face));
    /// assert_eq!((cube.vertex_count(), cube.edge_count(), cube.face_count()), (10, 15, 7));
    /// # Ok::<(), dcel_kit::solid::BevelVertexError>(())
    /// ```
    pub fn bevel_vertex(&mut self, v: VertexId, share: f64) -> Result<(HalfEdgeId, FaceId), BevelVertexError> {
        self.bevel_vertex_with(v, share, &mut NoRecorder)
    }

    /// [`bevel_vertex`](Self::bevel_vertex), watched by a recorder.
    pub fn bevel_vertex_with(
        &mut self,
        v: VertexId,
        share: f64,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(HalfEdgeId, FaceId), BevelVertexError> {
        let spokes = self.plan_bevel_vertex(v, share)?;
        self.open_hub(&spokes, rec);
        let side = spokes[1].out;
        Ok((side, self.dcel.face(side)))
    }
}
