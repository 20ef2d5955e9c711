//! Moving everything at once.
//!
//! ```text
//!    3 ─── 2                1 ─── 0        A map that keeps the orientation moves the points and nothing else. A
//!    │  f  │       ==>      │  f  │        reflection also turns every half-edge round: f stays on its left.
//!    0 ──> 1                2 <── 3
//! ```

use crate::ids::VertexId;
use crate::plane::{Affine, CoordinateError, GeometryViolation, PlaneRecorder, Point, Subdivision};
use crate::topology::NoRecorder;

/// Why a subdivision cannot be transformed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TransformError {
    /// A number of the map that cannot be used.
    #[error("the map: {0}")]
    Map(CoordinateError),
    /// The map makes everything flat.
    #[error("the map has determinant 0: everything would fall on one line; use a matrix that can be inverted")]
    Flat,
    /// A vertex would lie where coordinates cannot be used.
    #[error("{vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: VertexId,
        /// What is wrong with the new place.
        error: CoordinateError,
    },
    /// The new places had to be rounded, and then do not fit together.
    #[error("rounding the new places breaks the drawing: {0}; use a map whose results are exact, or a larger scale")]
    Rounding(GeometryViolation),
}

impl Subdivision {
    /// Transforms everything by an affine map: all vertices move at once. A reflection turns all half-edges round, so
    /// that every face stays on the left of its half-edges; all ids stay.
    ///
    /// Every new coordinate is the exact value, rounded once. If none had to be rounded, the drawing is sound because
    /// affine maps keep straight lines and their intersections; otherwise all invariants of the plane are checked.
    ///
    /// Cost: O(n), and O(n log n) if a coordinate was rounded.
    ///
    /// # Errors
    /// See [`TransformError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::plane::{Affine, Point, Subdivision};
    /// use dcel_kit::VertexId;
    /// let mut lab = Subdivision::lab_rectangle();
    /// lab.transform(&Affine::reflection(0))?;
    /// assert_eq!(lab.point(VertexId::new(0)), Point::new(250.0, -150.0));
    /// assert!(lab.geometry_violations().is_empty());
    /// # Ok::<(), dcel_kit::plane::TransformError>(())
    /// ```
    pub fn transform(&mut self, map: &Affine<2>) -> Result<(), TransformError> {
        self.transform_with(map, &mut NoRecorder)
    }

    /// [`transform`](Self::transform), watched by a recorder.
    pub fn transform_with(&mut self, map: &Affine<2>, rec: &mut impl PlaneRecorder) -> Result<(), TransformError> {
        map.check().map_err(TransformError::Map)?;
        let turn = map.orientation();
        if turn.is_eq() {
            return Err(TransformError::Flat);
        }
        let mut all_exact = true;
        let mut places: Vec<(VertexId, Point)> = Vec::with_capacity(self.dcel.vertex_count());
        for vertex in self.dcel.vertices() {
            let Point { x, y } = self.points[vertex];
            let ([x, y], exact) = map.apply([x, y]);
            let point = Point::new(x, y);
            point.check().map_err(|error| TransformError::Coordinate { vertex, error })?;
            all_exact &= exact;
            places.push((vertex, point));
        }
        self.all_or_nothing(rec, |s, rec| {
            for (vertex, point) in places {
                s.place(vertex, point, rec);
            }
            if turn.is_lt() {
                s.dcel.turn_over(rec);
            }
            let broken = if all_exact { None } else { s.geometry_violations().first().copied() };
            broken.map_or(Ok(()), |violation| Err(TransformError::Rounding(violation)))
        })
    }
}
