//! Splitting an edge of a subdivision at a point.
//!
//! ```text
//!                                             m
//!   u ● ─────────── h ────────> ● w     u ●──h──>●── c ──> ● w
//!
//!   The midpoint of the ends as doubles can lie a hair beside the edge. Then the edge bends, and nothing may
//!   lie in the thin triangle u, m, w.
//! ```

use super::Obstacle;
use crate::geometry::predicates::orientation;
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::cycle::on_segment;
use crate::plane::{CoordinateError, PlaneRecorder, Point, Subdivision};
use crate::topology::{self, NoRecorder};

/// Why an edge of a subdivision cannot be split at a point.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SplitEdgeError {
    /// The half-edge does not exist, or the structure is full.
    #[error(transparent)]
    Topology(#[from] topology::SplitEdgeError),
    /// The point is no place for a vertex.
    #[error("the point on {h}: {error}")]
    Coordinate {
        /// The half-edge.
        h: HalfEdgeId,
        /// What is wrong with the point.
        error: CoordinateError,
    },
    /// The ends are neighbouring numbers: the midpoint, rounded, is one of them.
    #[error("{h} is too short to be split: between {from} and {to} there is no further point to be had")]
    NoRoomForMidpoint {
        /// The half-edge.
        h: HalfEdgeId,
        /// Its origin.
        from: Point,
        /// Its destination.
        to: Point,
    },
    /// The point lies on the line of the edge, but not between its ends.
    #[error("{point} lies on the line of {h}, but not between its ends")]
    NotBetween {
        /// The half-edge.
        h: HalfEdgeId,
        /// The point.
        point: Point,
    },
    /// Bent over the point, the edge would meet another element.
    #[error("bent over {point}, {h} would run into {obstacle}")]
    WouldCross {
        /// The half-edge.
        h: HalfEdgeId,
        /// The point.
        point: Point,
        /// The vertex or half-edge in the way.
        obstacle: Element,
    },
}

impl Subdivision {
    /// The midpoint of the edge of `h`, rounded to doubles.
    #[must_use]
    pub fn midpoint(&self, h: HalfEdgeId) -> Point {
        let (p, q) = (self.points[self.dcel.origin(h)], self.points[self.dcel.destination(h)]);
        Point::new((p.x + q.x) / 2.0, (p.y + q.y) / 2.0)
    }

    /// Whether [`split_edge`](Self::split_edge) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(1) if the point lies exactly on the edge, else O(size of the two faces beside it).
    pub fn can_split_edge(&self, h: HalfEdgeId, point: Point) -> Result<(), SplitEdgeError> {
        self.dcel.can_split_edge(h)?;
        point.check().map_err(|error| SplitEdgeError::Coordinate { h, error })?;
        let (from, to) = (self.points[self.dcel.origin(h)], self.points[self.dcel.destination(h)]);
        if point == from || point == to {
            return Err(SplitEdgeError::NoRoomForMidpoint { h, from, to });
        }
        if orientation(from, point, to).is_eq() {
            return if on_segment(from, to, point) { Ok(()) } else { Err(SplitEdgeError::NotBetween { h, point }) };
        }
        if let Some(v) = self.vertex_beside(h, point) {
            return Err(SplitEdgeError::WouldCross { h, point, obstacle: v.into() });
        }
        match self.obstacle_in_triangle(h, [from, point, to]) {
            None => Ok(()),
            Some(Obstacle::Vertex(v)) => Err(SplitEdgeError::WouldCross { h, point, obstacle: v.into() }),
            Some(Obstacle::Edge(g)) => Err(SplitEdgeError::WouldCross { h, point, obstacle: g.into() }),
        }
    }

    /// Puts a new vertex at `point` on the edge of `h`. A point beside the edge bends it, provided that nothing
    /// lies in the way. `h` keeps its origin. Returns the vertex and the half-edge that now follows `h`.
    ///
    /// Cost: as [`can_split_edge`](Self::can_split_edge).
    ///
    /// # Errors
    /// See [`SplitEdgeError`]; a refused call leaves everything bit for bit as it was.
    pub fn split_edge(&mut self, h: HalfEdgeId, point: Point) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.split_edge_with(h, point, &mut NoRecorder)
    }

    /// [`split_edge`](Self::split_edge), watched by a recorder.
    pub fn split_edge_with(
        &mut self,
        h: HalfEdgeId,
        point: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.can_split_edge(h, point)?;
        let (m, c) = self.dcel.split_edge_unchecked(h, rec);
        self.place(m, point, rec);
        Ok((m, c))
    }

    /// The lab's `splitInHalf`: puts a new vertex at the midpoint of the edge of `h`. `h` keeps its origin.
    /// Returns the vertex and the half-edge that now follows `h`.
    ///
    /// Cost: O(1) if the midpoint is exact, else O(size of the two faces beside the edge).
    ///
    /// # Errors
    /// See [`SplitEdgeError`]: an edge between neighbouring doubles has no midpoint, and a rounded midpoint
    /// may not bend the edge over anything. A refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{HalfEdgeId, plane::{Point, Subdivision}};
    /// let mut lab = Subdivision::lab_rectangle();
    /// let (m, c) = lab.split_in_half(HalfEdgeId::new(0))?;
    /// assert_eq!(lab.point(m), Point::new(-125.0, -150.0));
    /// assert_eq!(lab.next(HalfEdgeId::new(0)), c);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_in_half(&mut self, h: HalfEdgeId) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.split_in_half_with(h, &mut NoRecorder)
    }

    /// [`split_in_half`](Self::split_in_half), watched by a recorder.
    pub fn split_in_half_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<(VertexId, HalfEdgeId), SplitEdgeError> {
        self.dcel.can_split_edge(h)?;
        self.split_edge_with(h, self.midpoint(h), rec)
    }
}
