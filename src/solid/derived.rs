//! Solids from solids: corners cut off, edges halved.
//!
//! ```text
//!    ●─────────●          ●──●───●──●           ●────●────●
//!    │         │   trun-    ╱     ╲     recti-     ╱   ╲          each vertex becomes a face, too, with as
//!    │    f    │   cated   ●       ●    fied      ●  f  ●         many corners as it had edges
//!    │         │           │   f   │               ╲   ╱
//!    ●─────────●            ╲     ╱                 ●
//! ```

use super::vector::{plus, times};
use super::{Polyhedron, SolidError};
use crate::ids::{EdgeMap, HalfEdgeId, VertexId};
use crate::topology::PolygonList;

/// Why the corners of a surface cannot be cut off.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TruncateError {
    /// The surface has a border.
    #[error("{vertex} lies on the border of the surface: only closed surfaces have corners to cut off")]
    OnBorder {
        /// A vertex on the border.
        vertex: VertexId,
    },
    /// A vertex with fewer than three edges.
    #[error("{vertex} has {degree} edge{}, and a face needs three corners: take such vertices out first", if *.degree == 1 { "" } else { "s" })]
    TooFewEdges {
        /// The vertex.
        vertex: VertexId,
        /// How many edges it has.
        degree: usize,
    },
    /// Points of the cut lie outside the edges.
    #[error("a ratio of {ratio}: it must lie above 0 and below 0.5, where the cuts meet")]
    Ratio {
        /// What was asked for.
        ratio: f64,
    },
    /// Points outside the flags, or at their corners.
    #[error(
        "weights of {weights:?}: those of the corner and of the face must be positive, that of the edge not negative"
    )]
    Weights {
        /// What was asked for.
        weights: [f64; 3],
    },
    /// The pieces do not fit together: edges are loops, or a face passes a vertex twice.
    #[error(transparent)]
    Solid(#[from] SolidError),
}

impl Polyhedron {
    /// The same surface with every vertex moved to where `place` says.
    ///
    /// Points are not checked: use this for positions that are known to be in range.
    pub(super) fn moved(&self, place: impl Fn(VertexId, [f64; 3]) -> [f64; 3]) -> Self {
        let mut moved = self.clone();
        for v in self.vertices() {
            moved.points[v] = place(v, self.point(v));
        }
        moved
    }

    /// The surface with its corners cut off: each edge keeps its middle part, from `ratio` of its length on at both
    /// ends. Faces come first, in their old order, with twice the corners, then a face for each vertex.
    ///
    /// # Errors
    /// [`TruncateError`]
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let cut = Polyhedron::platonic(Platonic::Tetrahedron).truncated(1.0 / 3.0)?;
    /// assert_eq!((cut.vertex_count(), cut.edge_count(), cut.face_count()), (12, 18, 8));
    /// # Ok::<(), dcel_kit::solid::TruncateError>(())
    /// ```
    pub fn truncated(&self, ratio: f64) -> Result<Self, TruncateError> {
        if !(ratio > 0.0 && ratio < 0.5) {
            return Err(TruncateError::Ratio { ratio });
        }
        self.check_corners()?;
        let cut = |h| plus(self.point(self.topology().origin(h)), times(self.edge_vector(h), ratio));
        let (points, number) = self.points_in_flags(cut);
        let both = |h: HalfEdgeId| [number[h], number[h.twin()]];
        let faces = self.faces_and_stars(|h, corners| corners.extend(both(h)), |h, corners| corners.push(number[h]));
        Ok(Self::from_polygons(points, &faces)?)
    }

    /// The surface whose vertices are the middles of the edges. Faces come first, in their old order, then a face
    /// for each vertex.
    ///
    /// # Errors
    /// [`TruncateError`]
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let cuboctahedron = Polyhedron::platonic(Platonic::Cube).rectified()?;
    /// assert_eq!((cuboctahedron.vertex_count(), cuboctahedron.face_count()), (12, 14));
    /// # Ok::<(), dcel_kit::solid::TruncateError>(())
    /// ```
    pub fn rectified(&self) -> Result<Self, TruncateError> {
        self.check_corners()?;
        let mut points = Vec::with_capacity(self.edge_count());
        let mut number = EdgeMap::filled(self.edge_bound(), 0);
        for e in self.edges() {
            let [a, b] = e.half_edges().map(|h| self.point(self.topology().origin(h)));
            number[e] = points.len() as u32;
            points.push(times(plus(a, b), 0.5));
        }
        let corner = |h: HalfEdgeId, corners: &mut Vec<u32>| corners.push(number[h.edge()]);
        Ok(Self::from_polygons(points, &self.faces_and_stars(corner, corner))?)
    }

    /// A face for each face, from its half-edges, and one for each vertex, from those that start there.
    pub(super) fn faces_and_stars(
        &self,
        of_face: impl Fn(HalfEdgeId, &mut Vec<u32>),
        of_vertex: impl Fn(HalfEdgeId, &mut Vec<u32>),
    ) -> PolygonList {
        let mut faces = PolygonList::new();
        let mut corners = Vec::new();
        for f in self.faces() {
            corners.clear();
            self.incident_half_edges(f).for_each(|h| of_face(h, &mut corners));
            faces.push_face(&corners);
        }
        for v in self.vertices() {
            corners.clear();
            self.outgoing_half_edges(v).for_each(|h| of_vertex(h, &mut corners));
            faces.push_face(&corners);
        }
        faces
    }

    /// Whether the surface is closed and has three edges or more at each vertex.
    pub(super) fn check_corners(&self) -> Result<(), TruncateError> {
        if let Some(f) = self.boundary_faces().next() {
            let vertex = self.incident_vertices(f).next().expect("a boundary face has a cycle");
            return Err(TruncateError::OnBorder { vertex });
        }
        let degrees = self.vertices().map(|v| (v, self.degree(v)));
        match degrees.into_iter().find(|&(_, degree)| degree < 3) {
            Some((vertex, degree)) => Err(TruncateError::TooFewEdges { vertex, degree }),
            None => Ok(()),
        }
    }
}
