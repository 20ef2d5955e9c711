//! Turning the diagonal of a convex quadrilateral.
//!
//! ```text
//!        c                   c          Two triangles beside an edge are a quadrilateral a, d, b, c. The other
//!      ╱   ╲               ╱ │ ╲        diagonal lies inside it exactly if the quadrilateral turns left at a and b,
//!    a ──h── b     ==>   a   h   b      the ends of the first one.
//!      ╲   ╱               ╲ │ ╱
//!        d                   d
//! ```

use crate::geometry::predicates::orientation;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{self, NoRecorder};

/// Why an edge of a subdivision cannot be flipped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FlipEdgeError {
    /// The half-edge does not separate two faces.
    #[error(transparent)]
    Topology(#[from] topology::FlipEdgeError),
    /// One of the two faces is no triangle: another number of sides, the outer face, or something inside it.
    #[error("{face} beside {h} is no triangle: an edge is flipped between two triangles; see split_face")]
    NotTriangle {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face that is none.
        face: FaceId,
    },
    /// One of the faces is a hole of the domain, the other is not.
    #[error("{hole} is a hole and {face} is not: the edge between them is a border of the domain")]
    HoleAndDomain {
        /// The hole face.
        hole: FaceId,
        /// The face of the domain.
        face: FaceId,
    },
    /// The two triangles form no convex quadrilateral: the other diagonal would leave it or run along its sides.
    #[error("the two triangles at {h} do not turn left at {vertex}: only a diagonal of a convex quadrilateral flips")]
    NotConvex {
        /// The half-edge.
        h: HalfEdgeId,
        /// The end of the edge at which the quadrilateral is straight or turns right.
        vertex: VertexId,
    },
}

impl Subdivision {
    /// Whether [`flip_edge`](Self::flip_edge) would succeed, and if not, why. Changes nothing. O(log of the number of
    /// faces with inner components and of holes).
    pub fn can_flip_edge(&self, h: HalfEdgeId) -> Result<(), FlipEdgeError> {
        self.dcel.can_flip_edge(h)?;
        let t = h.twin();
        for g in [h, t] {
            let face = self.dcel.face(g);
            let sides_fit =
                self.dcel.next(self.dcel.next(g)) == self.dcel.prev(g) && self.dcel.next(g) != self.dcel.prev(g);
            if face == self.outer_face() || !sides_fit || !self.inner_components(face).is_empty() {
                return Err(FlipEdgeError::NotTriangle { h, face });
            }
        }
        let [f, g] = [h, t].map(|h| self.dcel.face(h));
        match (self.is_hole(f), self.is_hole(g)) {
            (true, false) => return Err(FlipEdgeError::HoleAndDomain { hole: f, face: g }),
            (false, true) => return Err(FlipEdgeError::HoleAndDomain { hole: g, face: f }),
            _ => {}
        }
        let [c, d] = [h, t].map(|h| self.points[self.dcel.origin(self.dcel.prev(h))]);
        for (g, [before, after]) in [(h, [c, d]), (t, [d, c])] {
            let vertex = self.dcel.origin(g);
            if !orientation(before, self.points[vertex], after).is_gt() {
                return Err(FlipEdgeError::NotConvex { h, vertex });
            }
        }
        Ok(())
    }

    /// Replaces the edge of `h`, a diagonal of two triangles, by the other diagonal: both its ends move one corner
    /// on, counter-clockwise. All ids stay; see [`Dcel::flip_edge`](topology::Dcel::flip_edge). Two flips turn the
    /// edge round, four change nothing.
    ///
    /// Cost: O(log of the number of faces with inner components and of holes).
    ///
    /// # Errors
    /// See [`FlipEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::plane::{FlipEdgeError, Point, Subdivision};
    /// let points = [(0., 0.), (4., 0.), (4., 3.), (2., 1.)].map(Point::from).to_vec();
    /// let mut arrow = Subdivision::from_triangles(points, &[[0, 1, 3], [1, 2, 3]])?;
    /// let [v1, v3] = [1, 3].map(dcel_kit::VertexId::new);
    /// let h = arrow.find_half_edge(v1, v3).unwrap();
    /// assert_eq!(arrow.flip_edge(h), Err(FlipEdgeError::NotConvex { h, vertex: v3 }));
    /// # Ok::<(), dcel_kit::plane::ConvertError>(())
    /// ```
    pub fn flip_edge(&mut self, h: HalfEdgeId) -> Result<(), FlipEdgeError> {
        self.flip_edge_with(h, &mut NoRecorder)
    }

    /// [`flip_edge`](Self::flip_edge), watched by a recorder.
    pub fn flip_edge_with(&mut self, h: HalfEdgeId, rec: &mut impl PlaneRecorder) -> Result<(), FlipEdgeError> {
        self.can_flip_edge(h)?;
        self.dcel.flip_edge_unchecked(h, rec);
        Ok(())
    }
}
