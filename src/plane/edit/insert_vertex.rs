//! Inserting a vertex: into an edge, which it splits, or into a face, where it stands alone.
//!
//! ```text
//!   ●───── p ─────●  ==>  ●──────●──────●         ┌─────────┐       ┌─────────┐
//!                                                 │    p    │  ==>  │    ●    │   an inner component of the face
//!                                                 └─────────┘       └─────────┘
//! ```

use super::Obstacle;
use super::insert_edge::End;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::{CoordinateError, Location, PlaneRecorder, Point, Subdivision};
use crate::topology::{IdError, InnerComponent, NoRecorder, TooMany};

/// Why a point cannot become a vertex.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InsertVertexError {
    /// The face does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// The point is no place for a vertex.
    #[error("the new vertex: {0}")]
    Coordinate(#[from] CoordinateError),
    /// A vertex is there already.
    #[error("{vertex} is at {point} already")]
    Occupied {
        /// The vertex.
        vertex: VertexId,
        /// The point.
        point: Point,
    },
    /// The point does not lie inside the face.
    #[error("{point} does not lie inside {face}{}", at.map_or_else(String::new, |at| format!(", but on {at}")))]
    NotInFace {
        /// The face.
        face: FaceId,
        /// The point.
        point: Point,
        /// The vertex or half-edge of the face that it lies on, if any.
        at: Option<Element>,
    },
}

/// Why an edge with a free end cannot be inserted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InsertDanglingEdgeError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// The point is no place for a vertex.
    #[error("the free end of the dangling edge: {0}")]
    Coordinate(#[from] CoordinateError),
    /// The dangling edge would run into something, or end on it.
    #[error("a dangling edge from {vertex} to {point} would run into {obstacle}: insert it as a segment to split that")]
    InTheWay {
        /// The vertex it starts from.
        vertex: VertexId,
        /// Its free end.
        point: Point,
        /// The vertex or half-edge in the way.
        obstacle: Element,
    },
}

impl Subdivision {
    /// Puts a vertex at `point`: on an edge it splits the edge, which keeps its id up to there; in a face it stands
    /// alone, as the last inner component of the face. Returns the vertex.
    ///
    /// Cost: that of [`locate`](Self::locate), to find the place. [`insert_vertex_in`](Self::insert_vertex_in) is quicker where the face is
    /// known.
    ///
    /// # Errors
    /// See [`InsertVertexError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{FaceId, plane::{Point, Subdivision}};
    /// let mut s = Subdivision::lab_rectangle();
    /// let alone = s.insert_vertex(Point::new(10.0, 20.0))?;
    /// assert_eq!((s.outgoing(alone), s.inner_components(FaceId::new(1)).len()), (None, 1));
    /// let on_edge = s.insert_vertex(Point::new(100.0, 150.0))?;
    /// assert_eq!(s.degree(on_edge), 2);
    /// # Ok::<(), dcel_kit::plane::InsertVertexError>(())
    /// ```
    pub fn insert_vertex(&mut self, point: Point) -> Result<VertexId, InsertVertexError> {
        self.insert_vertex_with(point, &mut NoRecorder)
    }

    /// [`insert_vertex`](Self::insert_vertex), watched by a recorder.
    pub fn insert_vertex_with(
        &mut self,
        point: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<VertexId, InsertVertexError> {
        point.check()?;
        self.dcel.room_for(1, 1, 0)?;
        match self.locate(point) {
            Location::Vertex(vertex) => Err(InsertVertexError::Occupied { vertex, point }),
            Location::Edge(h) => {
                let (v, _) = self.dcel.split_edge_unchecked(h, rec);
                self.place(v, point, rec);
                Ok(v)
            }
            Location::Face(f) => Ok(self.add_isolated(f, point, rec)),
        }
    }

    /// Puts a vertex at `point`, which must lie inside the face `f`. It stands alone, as the last inner component of the face.
    ///
    /// Cost: O(size of the face).
    ///
    /// # Errors
    /// See [`InsertVertexError`]; a refused call leaves everything bit for bit as it was.
    pub fn insert_vertex_in(&mut self, f: FaceId, point: Point) -> Result<VertexId, InsertVertexError> {
        self.insert_vertex_in_with(f, point, &mut NoRecorder)
    }

    /// [`insert_vertex_in`](Self::insert_vertex_in), watched by a recorder.
    pub fn insert_vertex_in_with(
        &mut self,
        f: FaceId,
        point: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<VertexId, InsertVertexError> {
        self.dcel.check(f)?;
        point.check()?;
        self.dcel.room_for(1, 0, 0)?;
        self.lies_in(f, point).map_err(|at| InsertVertexError::NotInFace { face: f, point, at })?;
        Ok(self.add_isolated(f, point, rec))
    }

    /// Where a point lies if not inside the face: see [`InsertVertexError::NotInFace`]. O(size of the face).
    #[cfg(feature = "navmesh")]
    pub(crate) fn find_in_face(&self, f: FaceId, point: Point) -> Result<(), Option<Element>> {
        self.lies_in(f, point)
    }

    fn add_isolated(&mut self, f: FaceId, point: Point, rec: &mut impl PlaneRecorder) -> VertexId {
        let v = self.dcel.add_vertex_record(rec);
        self.place(v, point, rec);
        let mut rings = self.take_inner_components(f, rec);
        rings.push(InnerComponent::Isolated(v));
        self.give_inner_components(f, rings, rec);
        v
    }

    /// Puts a dangling edge into a face: a new vertex at `point`, joined to `vertex` by a straight edge that meets nothing.
    /// Returns the new vertex and the half-edge that leads to it.
    ///
    /// Cost: O(size of the face, degree of the vertex); for an isolated vertex also O(number of inner components).
    ///
    /// # Errors
    /// See [`InsertDanglingEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let mut s = Subdivision::lab_rectangle();
    /// let (tip, h) = s.insert_dangling_edge(VertexId::new(0), Point::new(0.0, 0.0))?;
    /// assert_eq!((s.destination(h), s.degree(tip), s.face_count()), (tip, 1, 2));
    /// # Ok::<(), dcel_kit::plane::InsertDanglingEdgeError>(())
    /// ```
    pub fn insert_dangling_edge(
        &mut self,
        vertex: VertexId,
        point: Point,
    ) -> Result<(VertexId, HalfEdgeId), InsertDanglingEdgeError> {
        self.insert_dangling_edge_with(vertex, point, &mut NoRecorder)
    }

    /// [`insert_dangling_edge`](Self::insert_dangling_edge), watched by a recorder.
    pub fn insert_dangling_edge_with(
        &mut self,
        vertex: VertexId,
        point: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<(VertexId, HalfEdgeId), InsertDanglingEdgeError> {
        self.dcel.check(vertex)?;
        point.check()?;
        self.dcel.room_for(1, 1, 0)?;
        let in_the_way = |obstacle: Element| InsertDanglingEdgeError::InTheWay { vertex, point, obstacle };
        if self.points[vertex] == point {
            return Err(in_the_way(vertex.into()));
        }
        let (f, end) = self.open_way(vertex, point).map_err(|obstacle| match obstacle {
            Obstacle::Vertex(v) => in_the_way(v.into()),
            Obstacle::Edge(h) => in_the_way(h.into()),
        })?;
        // Nothing is crossed on the way; so the point is in the face or on the rim of it.
        self.lies_in(f, point).map_err(|at| in_the_way(at.unwrap_or(Element::Face(f))))?;
        let tip = self.add_isolated(f, point, rec);
        Ok((tip, self.join_by_edge(f, [vertex, tip], [end, End::Isolated(tip)], rec)))
    }
}
