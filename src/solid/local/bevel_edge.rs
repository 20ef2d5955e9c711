//! A face takes the place of an edge.
//!
//! ```text
//!      ╲             ╱            ╲               ╱       The face has a corner on every other edge of both ends. If
//!       ╲     h     ╱              ●─────────────●        the ends have d and e edges: V + d + e - 4, and F + 1. It
//!        u ───────> w      ==>     │      f      │        is what joining the two ends and cutting off the corner
//!       ╱           ╲              u ─────h────> w        that is left would give, with `h` as one of the sides.
//!      ╱             ╲            ╱               ╲
//! ```

use super::hub::Spoke;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{IdError, NoRecorder, TooMany};

/// Why an edge cannot be cut off.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BevelEdgeError {
    /// The half-edge does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// An end without any other edge, or too few edges at both.
    #[error(
        "the ends of {h} have {others} other edges: each needs one, and both together three; split a face there first"
    )]
    TooFewEdges {
        /// The half-edge.
        h: HalfEdgeId,
        /// How many other edges both ends have.
        others: usize,
    },
    /// The edge lies on the border of the surface.
    #[error("{h} lies on the border {face}: there is no surface to cut off beyond it; bevel an edge between two faces")]
    OnBorder {
        /// The half-edge.
        h: HalfEdgeId,
        /// The boundary face beside it.
        face: FaceId,
    },
    /// Both ends lead to the same vertex, and no face lies between the two edges alone.
    #[error("another edge, {other}, joins the ends of {h}; bevel an edge whose ends have only one in common")]
    ParallelEdge {
        /// The half-edge.
        h: HalfEdgeId,
        /// The other one.
        other: HalfEdgeId,
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
    /// Whether [`bevel_edge`](Self::bevel_edge) would succeed, and if not, why. Changes nothing. O(degrees).
    pub fn can_bevel_edge(&self, h: HalfEdgeId, share: f64) -> Result<(), BevelEdgeError> {
        self.plan_bevel_edge(h, share).map(drop)
    }

    fn plan_bevel_edge(&self, h: HalfEdgeId, share: f64) -> Result<Vec<Spoke>, BevelEdgeError> {
        self.dcel.check(h)?;
        let t = h.twin();
        if let Some(side) = [h, t].into_iter().find(|&side| self.is_border(side)) {
            return Err(BevelEdgeError::OnBorder { h, face: self.dcel.face(side) });
        }
        let w: VertexId = self.dcel.destination(h);
        if let Some(other) = self.dcel.star(h).skip(1).find(|&g| self.dcel.destination(g) == w) {
            return Err(BevelEdgeError::ParallelEdge { h, other });
        }
        // Counter-clockwise round the edge, so that the origin of `h` stands on its last one, and its destination on
        // its first one: `h` is the side between them.
        let near: Vec<HalfEdgeId> = self.dcel.star(h).skip(1).collect();
        let far = self.dcel.star(t).skip(1);
        let others = near.len() + far.clone().count();
        let Some((&last, before)) = near.split_last().filter(|_| others > near.len() && others >= 3) else {
            return Err(BevelEdgeError::TooFewEdges { h, others });
        };
        if !(share > 0.0 && share < 1.0) {
            return Err(BevelEdgeError::Share { share });
        }
        self.dcel.room_for(others - 2, 2 * others, others)?;
        let corner = |(i, out)| {
            let place = self.along(out, share).map_err(|error| BevelEdgeError::Coordinate { spoke: out, error })?;
            Ok(Spoke { out, place, stays: i < 2 })
        };
        std::iter::once(last).chain(far).chain(before.iter().copied()).enumerate().map(corner).collect()
    }

    /// Cuts off the edge of `h`: a new face takes its place, with a corner on every other edge of both ends, after a
    /// `share` of its length. `h` becomes a side of it, the new face on its left. Returns `h` and the new face.
    ///
    /// Property: the new face has as many sides as both ends had other edges; on a closed surface whose vertices have three
    /// edges each it has four.
    ///
    /// Cost: O(degrees, and the sizes of the faces round both ends).
    ///
    /// # Errors
    /// See [`BevelEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// Source: Scotty3D, *bevel edge*.
    ///
    /// ```
    /// use dcel_kit::{HalfEdgeId, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// let (_, face) = cube.bevel_edge(HalfEdgeId::new(0), 0.25)?;
    /// assert_eq!(cube.incident_vertices(face).count(), 4);
    /// assert_eq!((cube.vertex_count(), cube.edge_count(), cube.face_count()), (10, 15, 7));
    /// # Ok::<(), dcel_kit::solid::BevelEdgeError>(())
    /// ```
    pub fn bevel_edge(&mut self, h: HalfEdgeId, share: f64) -> Result<(HalfEdgeId, FaceId), BevelEdgeError> {
        self.bevel_edge_with(h, share, &mut NoRecorder)
    }

    /// [`bevel_edge`](Self::bevel_edge), watched by a recorder.
    pub fn bevel_edge_with(
        &mut self,
        h: HalfEdgeId,
        share: f64,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(HalfEdgeId, FaceId), BevelEdgeError> {
        let spokes = self.plan_bevel_edge(h, share)?;
        self.open_hub(&spokes, rec);
        Ok((h, self.dcel.face(h)))
    }
}
