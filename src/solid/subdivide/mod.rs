//! Subdivision: each step refines every face and smooths the positions; creases and borders stay sharp.
//!
//! ```text
//!      ●───────────●                ●─────●─────●                ●                    ●
//!      │           │                │     │     │               ╱ ╲                  ╱ ╲
//!      │           │   Catmull–     │     │     │              ╱   ╲     Loop       ●───●
//!      │           │   Clark  ==>   ●─────●─────●             ╱     ╲    ==>       ╱ ╲ ╱ ╲
//!      │           │                │     │     │            ●───────●            ●───●───●
//!      ●───────────●                ●─────●─────●
//!      any faces become quads                                 triangles become four each
//! ```
//!
//! The new structure is written down at once, by formulas (see `refine.rs`), in time and memory linear in its size.
//! Positions are one flat array.
//!
//! Borders behave as creases. An edge is a crease if any bit of its mask is set. Where two creases meet, the
//! vertex moves on their curve, a cubic B-spline; where three and more meet it stays; one crease that ends there
//! does not hold the vertex.
//!
//! Sources: Catmull and Clark, *Recursively generated B-spline surfaces on arbitrary topological meshes*, 1978; Loop,
//! *Smooth subdivision surfaces based on triangles*, 1987; creases after Hoppe et al., *Piecewise smooth surface
//! reconstruction*, 1994, and DeRose, Kass and Truong, *Subdivision surfaces in character animation*, 1998.
//!
//! ```text
//!   catmull_clark.rs  Catmull–Clark
//!   loops.rs          Loop
//! ```

mod catmull_clark;
mod loops;
mod refine;
mod sharp;

use super::{Polyhedron, Selection};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::topology::{NoObserver, Observer, TooMany};

/// Why a surface cannot be subdivided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivideError {
    /// Loop's scheme is for triangles.
    #[error("{face} has {sides} sides, but Loop's scheme takes triangles only: triangulate it, or use Catmull–Clark")]
    NotATriangle {
        /// The face.
        face: FaceId,
        /// Its number of sides.
        sides: usize,
    },
    /// The finer surface would have more elements than there are ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// What a step of Catmull–Clark does: it finds a place for each vertex of the finer surface. Faces and edges are those of
/// the coarse one, compacted; vertices keep their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SubdivideEvent {
    /// A new vertex in a face.
    Face {
        /// The face.
        face: FaceId,
        /// The new vertex.
        vertex: VertexId,
    },
    /// A new vertex for an edge.
    Edge {
        /// The edge.
        edge: EdgeId,
        /// The new vertex.
        vertex: VertexId,
    },
    /// A vertex that was there finds its new place.
    Vertex(VertexId),
}

/// A finer surface and the creases on it.
#[derive(Clone, PartialEq, Debug)]
pub struct Subdivided {
    /// The surface.
    pub polyhedron: Polyhedron,
    /// Both parts of each crease of the coarse surface, with its mask.
    pub creases: Selection<EdgeId>,
}

impl Polyhedron {
    /// One step of Catmull–Clark subdivision: every face with n sides becomes n quads.
    ///
    /// With S the sum of the sides of all faces but boundary faces: V' = V + E + F, E' = 2E + S, F' = S; boundary
    /// faces stay, with twice their sides. On a closed surface E' = 4E and F' = 2E.
    ///
    /// Vertices keep their numbers and are followed by one on each edge and one in each face. A structure with
    /// removed elements is [compacted](crate::topology::Dcel::compact) first, and the numbers are those after it.
    /// Creases become creases; a closed surface without creases is smooth but where degrees are not 4.
    ///
    /// Cost: linear.
    ///
    /// # Errors
    /// [`SubdivideError::TooMany`].
    ///
    /// ```
    /// use dcel_kit::solid::{Selection, grow::Shape};
    /// let cube = Shape::CUBE.build()?;
    /// let round = cube.polyhedron.catmull_clark(&Selection::new())?.polyhedron;
    /// assert_eq!((round.vertex_count(), round.edge_count(), round.face_count()), (26, 48, 24));
    /// let hard = cube.polyhedron.catmull_clark(&cube.creases)?;
    /// assert_eq!(hard.polyhedron.point(dcel_kit::VertexId::new(0)), cube.polyhedron.point(dcel_kit::VertexId::new(0)));
    /// assert_eq!(hard.creases.ids(1).count(), 24);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn catmull_clark(&self, creases: &Selection<EdgeId>) -> Result<Subdivided, SubdivideError> {
        self.catmull_clark_observed(creases, &mut NoObserver)
    }

    /// [`catmull_clark`](Self::catmull_clark), watched: vertices in faces, those of edges, those that were there.
    ///
    /// # Errors
    /// [`SubdivideError::TooMany`].
    pub fn catmull_clark_observed(
        &self,
        creases: &Selection<EdgeId>,
        observer: &mut impl Observer<SubdivideEvent>,
    ) -> Result<Subdivided, SubdivideError> {
        catmull_clark::step(self, creases, observer)
    }

    /// One step of Loop subdivision: every triangle becomes four.
    ///
    /// V' = V + E, E' = 2E + 3F, F' = 4F, boundary faces not counted; they stay, with twice their sides. On a closed
    /// surface E' = 4E. Numbers as in [`catmull_clark`](Self::catmull_clark), without vertices in faces.
    ///
    /// Cost: linear.
    ///
    /// # Errors
    /// [`SubdivideError`]: a face is no triangle, or the structure would be too large.
    ///
    /// ```
    /// use dcel_kit::{solid::{Polyhedron, Selection}, topology::PolygonList};
    /// let corners = vec![[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]];
    /// let faces = PolygonList::from_triangles(&[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);
    /// let fine = Polyhedron::from_polygons(corners, &faces)?.loop_subdivision(&Selection::new())?.polyhedron;
    /// assert_eq!((fine.vertex_count(), fine.edge_count(), fine.face_count()), (10, 24, 16));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn loop_subdivision(&self, creases: &Selection<EdgeId>) -> Result<Subdivided, SubdivideError> {
        loops::step(self, creases)
    }
}
