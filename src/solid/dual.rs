//! The dual solid: a vertex for each face, a face for each vertex, an edge across each edge.
//!
//! ```text
//!     ●───────●             ●───────●
//!     │       │             │   ○───┼───○        the corners of the face for v, counter-clockwise, are the faces
//!     │   f   │             │   │ f │            round v, counter-clockwise
//!     ●───────● v    ==>    ●───┼───●   │
//!     │       │             │   │   │v  │
//!                               ○───────○
//! ```
//!
//! The dual of the dual is the same structure again.

use super::vector::{dot, minus};
use super::{Polyhedron, SolidError};
use crate::ids::{FaceId, FaceMap, HalfEdgeId, VertexId};
use crate::topology::PolygonList;

/// Neighbouring faces with poles so close, as a part of their distance from the origin, lie in one plane.
const ONE_PLANE: f64 = 1e-9;

/// Why a surface has no dual.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DualError {
    /// The surface has a border, so that the faces round a vertex there do not close.
    #[error("the surface has a border at {boundary_face}: fill it with faces first")]
    Open {
        /// A boundary face.
        boundary_face: FaceId,
    },
    /// A vertex with fewer than three edges gives no face.
    #[error("{vertex} has {degree} edge{}, and a face needs three corners: take such vertices out first", if *.degree == 1 { "" } else { "s" })]
    TooFewEdges {
        /// The vertex.
        vertex: VertexId,
        /// How many edges it has.
        degree: usize,
    },
    /// Two edges join the same two faces, so that the dual would have an edge twice.
    #[error("in the dual {error}")]
    Solid {
        /// What is wrong there; its vertices are faces here, and its faces are vertices.
        error: SolidError,
    },
}

/// Where the vertices of a dual are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum DualPositions {
    /// Of a convex solid with the origin inside, of which no two neighbouring faces lie in one plane: a face in the plane
    /// n·x = 1 has its vertex at n. The dual of the dual is then the solid itself.
    Polar,
    /// The mean of the corners of each face.
    Means,
}

/// A dual solid.
#[derive(Clone, PartialEq, Debug)]
pub struct Dual {
    /// It. Vertices are numbered as the faces were, and faces as the vertices were, without gaps.
    pub solid: Polyhedron,
    /// Where its vertices are.
    pub positions: DualPositions,
}

impl Polyhedron {
    /// The dual of a closed surface: polar if it bounds a convex solid with the origin inside and no two neighbouring
    /// faces in one plane, else with a vertex in the middle of each face.
    ///
    /// Cost: that of [`check_convex`](Self::check_convex).
    ///
    /// # Errors
    /// [`DualError`] names a border, a vertex with fewer than three edges, or an edge that the dual would have
    /// twice.
    ///
    /// ```
    /// use dcel_kit::solid::{DualPositions, Platonic, Polyhedron};
    /// let dual = Polyhedron::platonic(Platonic::Cube).dual()?;
    /// assert_eq!((dual.solid.vertex_count(), dual.solid.face_count()), (6, 8));
    /// assert_eq!(dual.positions, DualPositions::Polar);
    /// # Ok::<(), dcel_kit::solid::DualError>(())
    /// ```
    pub fn dual(&self) -> Result<Dual, DualError> {
        if let Some(boundary_face) = self.boundary_faces().next() {
            return Err(DualError::Open { boundary_face });
        }
        let mut number = FaceMap::filled(self.face_bound(), 0);
        self.faces().zip(0..).for_each(|(f, i)| number[f] = i);
        let mut faces = PolygonList::new();
        let mut corners = Vec::new();
        for vertex in self.vertices() {
            corners.clear();
            corners.extend(self.incident_faces(vertex).map(|f| number[f]));
            if corners.len() < 3 {
                return Err(DualError::TooFewEdges { vertex, degree: corners.len() });
            }
            faces.push_face(&corners);
        }
        let (points, positions) = match self.poles(&number) {
            Some(points) => (points, DualPositions::Polar),
            None => (self.faces().map(|f| self.face_mean(f)).collect(), DualPositions::Means),
        };
        let solid = Self::from_polygons(points, &faces).map_err(|error| DualError::Solid { error })?;
        Ok(Dual { solid, positions })
    }

    /// The poles of all faces of a convex solid, by the numbers of the faces; none if one has no pole, or two neighbours
    /// have the same, but for rounding: their planes are one.
    fn poles(&self, number: &FaceMap<u32>) -> Option<Vec<[f64; 3]>> {
        self.check_convex().ok()?;
        let poles: Vec<[f64; 3]> = self.faces().map(|f| self.pole(f)).collect::<Option<_>>()?;
        let of = |h| poles[number[self.face(h)] as usize];
        let is_one = |h: HalfEdgeId| {
            let (p, q) = (of(h), of(self.twin(h)));
            let apart = minus(p, q);
            dot(apart, apart) <= ONE_PLANE * ONE_PLANE * dot(p, p)
        };
        (!self.half_edges().any(is_one)).then_some(poles)
    }

    /// The n of the plane n·x = 1 of a face; none if the origin is not clearly on the inner side, or so far away
    /// or close that the point would be out of range.
    fn pole(&self, f: FaceId) -> Option<[f64; 3]> {
        let normal = self.normal(f)?;
        let distance = dot(normal, self.face_mean(f));
        // A coordinate of the normal this small is rounding.
        let point = normal.map(|x| if x.abs() < f64::EPSILON { 0.0 } else { x / distance });
        (1e-30..1e30).contains(&distance).then_some(point)
    }
}
