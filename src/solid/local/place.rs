//! Points of a surface move.
//!
//! ```text
//!   set_point(v, p)   one vertex        transform(map)   all of them; a reflection also turns every half-edge round,
//!                                                        so that faces still run counter-clockwise as seen from outside
//! ```

use crate::geometry::space::check_place;
use crate::ids::VertexId;
use crate::plane::{Affine, CoordinateError};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::{SurfaceChange, SurfaceRecorder};
use crate::topology::{IdError, NoRecorder};

/// Why a vertex cannot be moved.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlaceError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// A coordinate that cannot be used.
    #[error("the new place: {0}")]
    Coordinate(#[from] CoordinateError),
}

/// Why a surface cannot be transformed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpaceTransformError {
    /// A number of the map that cannot be used.
    #[error("the map: {0}")]
    Map(CoordinateError),
    /// The map makes everything flat.
    #[error("the map has determinant 0: everything would fall into one plane; use a matrix that can be inverted")]
    Flat,
    /// A vertex would lie where coordinates cannot be used.
    #[error("{vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: VertexId,
        /// What is wrong with the new place.
        error: CoordinateError,
    },
}

impl Polyhedron {
    /// Puts a vertex to a place; a new one gets its slot.
    pub(in crate::solid) fn place(&mut self, vertex: VertexId, new: [f64; 3], rec: &mut impl SurfaceRecorder) {
        let old = self.points.get(vertex).copied();
        self.points.set(vertex, new, [0.0; 3]);
        rec.surface(SurfaceChange::Placed { vertex, old, new });
    }

    /// Moves a vertex to a place. A surface in space may pass through itself, so every place will do. O(1).
    ///
    /// # Errors
    /// [`PlaceError`]; then nothing has changed.
    ///
    /// ```
    /// use dcel_kit::{VertexId, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// cube.set_point(VertexId::new(0), [0.0, 0.0, 0.0])?;
    /// assert_eq!(cube.point(VertexId::new(0)), [0.0; 3]);
    /// # Ok::<(), dcel_kit::solid::PlaceError>(())
    /// ```
    pub fn set_point(&mut self, vertex: VertexId, place: [f64; 3]) -> Result<(), PlaceError> {
        self.set_point_with(vertex, place, &mut NoRecorder)
    }

    /// [`set_point`](Self::set_point), watched by a recorder.
    pub fn set_point_with(
        &mut self,
        vertex: VertexId,
        place: [f64; 3],
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(), PlaceError> {
        self.dcel.check(vertex)?;
        check_place(place)?;
        self.place(vertex, place, rec);
        Ok(())
    }

    /// Moves a vertex by a way: [`set_point`](Self::set_point) with its place and the way added up. O(1).
    ///
    /// # Errors
    /// [`PlaceError`]; then nothing has changed.
    pub fn move_vertex(&mut self, vertex: VertexId, by: [f64; 3]) -> Result<(), PlaceError> {
        self.move_vertex_with(vertex, by, &mut NoRecorder)
    }

    /// [`move_vertex`](Self::move_vertex), watched by a recorder.
    pub fn move_vertex_with(
        &mut self,
        vertex: VertexId,
        by: [f64; 3],
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(), PlaceError> {
        self.dcel.check(vertex)?;
        let old = self.points[vertex];
        self.set_point_with(vertex, [0, 1, 2].map(|i| old[i] + by[i]), rec)
    }

    /// Transforms everything by an affine map. A reflection turns all half-edges round, so that faces run
    /// counter-clockwise as seen from outside again; all ids stay. Every new coordinate is the exact value, rounded once.
    ///
    /// Cost: O(n).
    ///
    /// # Errors
    /// See [`SpaceTransformError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{plane::Affine, solid::{Platonic, Polyhedron}};
    /// let mut cube = Polyhedron::platonic(Platonic::Cube);
    /// let volume = cube.signed_volume();
    /// cube.transform(&Affine::reflection(2))?;
    /// assert_eq!(cube.signed_volume(), volume);
    /// # Ok::<(), dcel_kit::solid::SpaceTransformError>(())
    /// ```
    pub fn transform(&mut self, map: &Affine<3>) -> Result<(), SpaceTransformError> {
        self.transform_with(map, &mut NoRecorder)
    }

    /// [`transform`](Self::transform), watched by a recorder.
    pub fn transform_with(
        &mut self,
        map: &Affine<3>,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<(), SpaceTransformError> {
        map.check().map_err(SpaceTransformError::Map)?;
        let turn = map.orientation();
        if turn.is_eq() {
            return Err(SpaceTransformError::Flat);
        }
        let image = |vertex| {
            let (place, _) = map.apply(self.points[vertex]);
            let checked = check_place(place).map_err(|error| SpaceTransformError::Coordinate { vertex, error });
            checked.map(|()| (vertex, place))
        };
        let places = self.dcel.vertices().map(image).collect::<Result<Vec<_>, _>>()?;
        for (vertex, place) in places {
            self.place(vertex, place, rec);
        }
        if turn.is_lt() {
            self.dcel.turn_over(rec);
        }
        Ok(())
    }
}
