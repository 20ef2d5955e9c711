//! A smaller face stands inside a face, or above it, with a rim of quadrilaterals between.
//!
//! ```text
//!      v3 ─────────── v2             v3 ─────────── v2       V + k, E + 2k, F + k for a face with k sides. The face
//!       │             │               │ ╲  f3     ╱ │        keeps its number and is the inner one; its corners are
//!       │      f      │               │  w3 ─── w2  │        new. Each of its old sides has a quadrilateral.
//!       │             │      ==>      │   │  f  │   │
//!       │             │               │  w0 ─── w1  │
//!       │             │               │ ╱         ╲ │
//!      v0 ─────────── v1             v0 ─────────── v1
//! ```
//!
//! Three words for where the new corners stand: **inset** moves them towards the mean of the corners by a share of the
//! way; **extrude** moves them along the normal of the face by a distance, 0 being *in place*; **bevel** does both.
//!
//! Phases: an edge with a free end at each corner, into the face; sides between the free ends.

use crate::geometry::space::check_place;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::solid::vector::{minus, plus, times};
use crate::topology::{IdError, NoRecorder, Quiet, TooMany};

/// Why a face cannot get a rim.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RimError {
    /// The face does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// It is a boundary face.
    #[error("{face} is no face of the surface but stands for a border; choose a face")]
    BoundaryFace {
        /// The face.
        face: FaceId,
    },
    /// Not a share of the way to the middle.
    #[error("{share} is no share of the way to the middle: use a number from 0 on, below 1")]
    Share {
        /// The number.
        share: f64,
    },
    /// Not a distance.
    #[error("{distance} is no distance: use a finite number, negative to go inwards")]
    Distance {
        /// The number.
        distance: f64,
    },
    /// The face has no area, so that nobody knows where outwards is.
    #[error("{face} has no area, so it has no normal to go along: use the distance 0, or move its corners apart")]
    NoNormal {
        /// The face.
        face: FaceId,
    },
    /// A corner would lie where coordinates cannot be used.
    #[error("the new corner at {vertex}: {error}")]
    Coordinate {
        /// The old corner.
        vertex: VertexId,
        /// What is wrong with the new one.
        error: CoordinateError,
    },
}

impl Polyhedron {
    /// The corners of a rim inside `f`: the sides of `f`, and for each the place of the new corner at its origin.
    fn plan_rim(&self, f: FaceId, share: f64, distance: f64) -> Result<Vec<(HalfEdgeId, [f64; 3])>, RimError> {
        self.dcel.check(f)?;
        if self.is_boundary_face(f) {
            return Err(RimError::BoundaryFace { face: f });
        }
        if !(0.0..1.0).contains(&share) {
            return Err(RimError::Share { share });
        }
        if !distance.is_finite() {
            return Err(RimError::Distance { distance });
        }
        let rise = match self.normal(f) {
            _ if distance == 0.0 => [0.0; 3],
            Some(normal) => times(normal, distance),
            None => return Err(RimError::NoNormal { face: f }),
        };
        let middle = self.face_mean(f);
        let sides = self.dcel.incident_half_edges(f);
        let count = sides.clone().count();
        self.dcel.room_for(count, 2 * count, count)?;
        let corner = |h: HalfEdgeId| {
            let vertex = self.dcel.origin(h);
            let at = self.points[vertex];
            let place = plus(plus(at, times(minus(middle, at), share)), rise);
            check_place(place).map_err(|error| RimError::Coordinate { vertex, error })?;
            Ok((h, place))
        };
        sides.map(corner).collect()
    }

    fn make_rim(&mut self, corners: &[(HalfEdgeId, [f64; 3])], rec: &mut impl SurfaceRecorder) -> HalfEdgeId {
        rec.step(1, "Let an edge with a free end run into the face from each corner.");
        let mut tips = Vec::with_capacity(corners.len());
        for &(side, place) in corners {
            // The empty range before the side before: an edge into the corner between the two.
            let at = self.dcel.prev(side).twin();
            let (spoke, tip) = self.dcel.split_vertex_unchecked(at, at, &mut Quiet(&mut *rec));
            self.place(tip, place, rec);
            tips.push(spoke.twin());
        }
        rec.step(2, "Join the free ends; each new side cuts a quadrilateral off the face.");
        let mut first = None;
        for (i, &tip) in tips.iter().enumerate() {
            // The last one meets the first side that was made.
            let next = first.filter(|_| i + 1 == tips.len()).unwrap_or(tips[(i + 1) % tips.len()]);
            let (outside, _) = self.dcel.split_face_unchecked(next, tip, &mut Quiet(&mut *rec));
            first = first.or(Some(outside.twin()));
        }
        first.unwrap_or(tips[0])
    }

    /// Puts a smaller face into `f`, its corners moved by a `share` of the way to the mean of the corners. `f` keeps its
    /// number and is the smaller face; a quadrilateral is new at each old side. Returns a side of the smaller face.
    ///
    /// Property: V + k, E + 2k, F + k for k sides. Inverse: joining all new faces into one, and removing what dangles.
    ///
    /// Cost: O(sides).
    ///
    /// # Errors
    /// See [`RimError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{FaceId, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// let side = cube.inset_face(FaceId::new(0), 0.5)?;
    /// assert_eq!(cube.face(side), FaceId::new(0));
    /// assert_eq!((cube.vertex_count(), cube.edge_count(), cube.face_count()), (12, 20, 10));
    /// # Ok::<(), dcel_kit::solid::RimError>(())
    /// ```
    pub fn inset_face(&mut self, f: FaceId, share: f64) -> Result<HalfEdgeId, RimError> {
        self.inset_face_with(f, share, &mut NoRecorder)
    }

    /// [`inset_face`](Self::inset_face), watched by a recorder.
    pub fn inset_face_with(
        &mut self,
        f: FaceId,
        share: f64,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<HalfEdgeId, RimError> {
        self.bevel_face_with(f, share, 0.0, rec)
    }

    /// Pulls `f` out along its normal by a `distance`, negative to push it in: walls are new at each of its sides. With
    /// 0 the new corners stand where the old ones are (*in place*), to be moved afterwards. Otherwise as
    /// [`inset_face`](Self::inset_face).
    ///
    /// # Errors
    /// See [`RimError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{FaceId, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// let (volume, area) = (cube.signed_volume(), cube.area() / 6.0);
    /// cube.extrude_face(FaceId::new(0), 2.0)?;
    /// assert!((cube.signed_volume() - volume - 2.0 * area).abs() < 1e-12);
    /// # Ok::<(), dcel_kit::solid::RimError>(())
    /// ```
    pub fn extrude_face(&mut self, f: FaceId, distance: f64) -> Result<HalfEdgeId, RimError> {
        self.extrude_face_with(f, distance, &mut NoRecorder)
    }

    /// [`extrude_face`](Self::extrude_face), watched by a recorder.
    pub fn extrude_face_with(
        &mut self,
        f: FaceId,
        distance: f64,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<HalfEdgeId, RimError> {
        self.bevel_face_with(f, 0.0, distance, rec)
    }

    /// Cuts off the edges round `f`: [`inset_face`](Self::inset_face) and [`extrude_face`](Self::extrude_face) in one.
    ///
    /// Source: Scotty3D, *bevel face*.
    ///
    /// # Errors
    /// See [`RimError`]; a refused call leaves everything bit for bit as it was.
    pub fn bevel_face(&mut self, f: FaceId, share: f64, distance: f64) -> Result<HalfEdgeId, RimError> {
        self.bevel_face_with(f, share, distance, &mut NoRecorder)
    }

    /// [`bevel_face`](Self::bevel_face), watched by a recorder.
    pub fn bevel_face_with(
        &mut self,
        f: FaceId,
        share: f64,
        distance: f64,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<HalfEdgeId, RimError> {
        let corners = self.plan_rim(f, share, distance)?;
        Ok(self.make_rim(&corners, rec))
    }
}
