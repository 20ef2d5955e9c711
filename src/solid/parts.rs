//! A surface and its parts: the structure, the points, the boundary faces.

use super::Polyhedron;
use crate::geometry::space::check_place;
use crate::ids::{FaceId, VertexId, VertexMap};
use crate::plane::CoordinateError;
use crate::topology::{Dcel, Renumbering, Violation, violations};
use std::collections::BTreeSet;

/// Why parts make no surface.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartsError {
    /// Invariants of the structure are broken.
    #[error("{}", violations.first().map_or_else(String::new, ToString::to_string))]
    Invariants {
        /// All of them; at least one.
        violations: Vec<Violation>,
    },
    /// A vertex has no point.
    #[error("{vertex} has no point; give one for every vertex number below {bound}")]
    NoPoint {
        /// The first such vertex.
        vertex: VertexId,
        /// How many points are needed.
        bound: usize,
    },
    /// A vertex whose coordinates cannot be used.
    #[error("{vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: VertexId,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// A boundary face that the structure does not have.
    #[error("{face} was named as a boundary face, but the structure has no such face")]
    NoFace {
        /// The face.
        face: FaceId,
    },
}

impl Polyhedron {
    /// A surface from its parts: a structure, a point for each of its vertices, and the faces that stand for borders.
    ///
    /// Cost: O(n); all invariants are checked.
    ///
    /// # Errors
    /// [`PartsError`] names what does not fit.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let cube = Polyhedron::platonic(Platonic::Cube);
    /// let (dcel, points, borders) = cube.clone().into_parts();
    /// assert_eq!(Polyhedron::from_parts(dcel, points, borders)?, cube);
    /// # Ok::<(), dcel_kit::solid::PartsError>(())
    /// ```
    pub fn from_parts(
        dcel: Dcel,
        points: VertexMap<[f64; 3]>,
        boundary_faces: impl IntoIterator<Item = FaceId>,
    ) -> Result<Self, PartsError> {
        let violations = violations(&dcel);
        if !violations.is_empty() {
            return Err(PartsError::Invariants { violations });
        }
        for vertex in dcel.vertices() {
            let bound = dcel.vertex_bound();
            let place = points.get(vertex).ok_or(PartsError::NoPoint { vertex, bound })?;
            check_place(*place).map_err(|error| PartsError::Coordinate { vertex, error })?;
        }
        let boundary_faces: BTreeSet<FaceId> = boundary_faces.into_iter().collect();
        match boundary_faces.iter().find(|&&f| !dcel.has_face(f)) {
            Some(&face) => Err(PartsError::NoFace { face }),
            None => Ok(Self { dcel, points, boundary_faces }),
        }
    }

    /// The structure, the points by vertex, and the boundary faces in the order of their numbers. O(1), and O(boundary
    /// faces).
    #[must_use]
    pub fn into_parts(self) -> (Dcel, VertexMap<[f64; 3]>, Vec<FaceId>) {
        (self.dcel, self.points, self.boundary_faces.into_iter().collect())
    }

    /// Drops the dead records and renumbers the rest along a walk, see [`Dcel::compact`]. Points and boundary faces
    /// follow.
    #[must_use = "every id held outside must be translated by the renumbering"]
    pub fn compact(&mut self) -> Renumbering {
        let map = self.dcel.compact();
        self.points = std::mem::take(&mut self.points).renumbered(&map);
        let old = std::mem::take(&mut self.boundary_faces);
        self.boundary_faces = old.into_iter().filter_map(|f| map.faces[f]).collect();
        map
    }
}
