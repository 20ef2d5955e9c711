//! Half-edge structures in space: a surface of polygons with positions.
//!
//! ```text
//!        ●───────●        every polygon is a face, counter-clockwise as seen from outside;
//!       ╱ f1    ╱│        where the surface ends, each border cycle has a *boundary face*, which is
//!      ●───────● │        no part of the surface but lets every half-edge have a face
//!      │  f0   │f2
//!      │       │ ●
//!      ●───────●╱
//! ```
//!
//! The base on which solids are built. Nothing is decided by coordinates here: a surface may pass through
//! itself, and its faces need not be flat.

mod dynamic;
pub mod grow;
mod selection;
mod subdivide;

use crate::ids::{FaceId, VertexId, VertexMap};
use crate::plane::{CoordinateError, check_coordinate};
use crate::topology::{BuildError, Dcel, NoRecorder, PolygonList, View};
use std::collections::BTreeSet;
use std::ops::Deref;

pub use dynamic::{AddFaceError, AddVertexError, RemoveFaceError, RemoveVertexError};
pub use selection::Selection;
pub use subdivide::{SubdivideError, Subdivided};

/// Why points and polygons are no surface. Faces and vertices are numbered from 0 in the order of the input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolidError {
    /// The polygons do not fit together.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A vertex whose coordinates cannot be used.
    #[error("vertex {vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
}

impl SolidError {
    /// The faces the message speaks of, for callers who know where in a file they stand.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::Build(error) => error.faces(),
            Self::Coordinate { .. } => Vec::new(),
        }
    }

    /// The vertices the message speaks of.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match self {
            Self::Build(error) => error.vertices(),
            Self::Coordinate { vertex, .. } => vec![*vertex],
        }
    }
}

/// A surface in space, closed or with borders. It dereferences to its [`Dcel`] for all walks and counts.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Polyhedron {
    dcel: Dcel,
    points: VertexMap<[f64; 3]>,
    boundary_faces: BTreeSet<FaceId>,
}

impl Deref for Polyhedron {
    type Target = Dcel;

    fn deref(&self) -> &Dcel {
        &self.dcel
    }
}

impl Polyhedron {
    /// A surface without any element, to be grown with [`add_vertex`](Self::add_vertex) and
    /// [`add_face`](Self::add_face).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The surface of a list of polygons.
    ///
    /// Vertex i is v(i), polygon i is f(i), boundary faces follow; see [`Dcel::from_polygons`]. Points that no
    /// polygon uses get no vertex: their ids are left free.
    ///
    /// Cost: O(points + corners).
    ///
    /// # Errors
    /// [`SolidError`] names the faces and vertices that do not fit.
    ///
    /// ```
    /// use dcel_kit::{solid::Polyhedron, topology::{PolygonList, measure}};
    /// let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    /// let faces = PolygonList::from_triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = Polyhedron::from_polygons(corners, &faces)?;
    /// assert_eq!((tetrahedron.edge_count(), measure(&tetrahedron).closed_euler()), (6, 2));
    /// # Ok::<(), dcel_kit::solid::SolidError>(())
    /// ```
    pub fn from_polygons(points: Vec<[f64; 3]>, polygons: &PolygonList) -> Result<Self, SolidError> {
        for (vertex, point) in points.iter().enumerate() {
            for (axis, &value) in ['x', 'y', 'z'].into_iter().zip(point) {
                check_coordinate(axis, value)
                    .map_err(|error| SolidError::Coordinate { vertex: vertex as u32, error })?;
            }
        }
        let built = Dcel::from_polygons(points.len(), polygons)?;
        let mut dcel = built.dcel;
        // From the last one on, so that the lowest free id is given out first.
        let unused: Vec<VertexId> = dcel.vertices().rev().filter(|&v| dcel.outgoing(v).is_none()).collect();
        for v in unused {
            dcel.remove_vertex_record(v, &mut NoRecorder);
        }
        Ok(Self { dcel, points: points.into(), boundary_faces: built.boundary_faces.into_iter().collect() })
    }

    /// A surface from its parts, which must fit together: a position for each vertex up to the bound.
    fn from_parts(dcel: Dcel, points: VertexMap<[f64; 3]>, boundary_faces: BTreeSet<FaceId>) -> Self {
        Self { dcel, points, boundary_faces }
    }

    /// The structure without its positions.
    #[must_use]
    pub fn topology(&self) -> &Dcel {
        &self.dcel
    }

    /// Where `v` is. O(1).
    #[must_use]
    pub fn point(&self, v: VertexId) -> [f64; 3] {
        self.points[v]
    }

    /// Whether `f` stands for a border of the surface and is no polygon of it.
    #[must_use]
    pub fn is_boundary_face(&self, f: FaceId) -> bool {
        self.boundary_faces.contains(&f)
    }

    /// The boundary faces in the order of their numbers.
    pub fn boundary_faces(&self) -> impl ExactSizeIterator<Item = FaceId> + '_ {
        self.boundary_faces.iter().copied()
    }
}

impl View for Polyhedron {
    crate::topology::pointers_of_dcel!(dcel);
}
