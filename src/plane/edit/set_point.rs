//! Moving a vertex; its edges go along.
//!
//! ```text
//!   ●─────────●        ●─────────●     Without the edges at v, the faces round it are one region. In the new place, too,
//!   │ ╲     ╱ │        │ ╲ e   ╱ │     each edge must leave its neighbour into the same corner of that region and run
//!   │   ╲ ╱   │        │   ╲ ╱   │     through it without meeting anything. If the edges then follow each other round v
//!   │    v    │  ==>   │   │v    │     as before, each cycle runs the same way round, and what lay in a face still lies
//!   │   ╱ ╲   │        │   ╱ ╲   │     there, all faces are the same faces.
//!   ●─────────●        ●─────────●
//! ```

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::by_direction;
use crate::plane::cycle::{encloses, in_corner, on_segment, surrounds};
use crate::plane::predicates::orientation;
use crate::plane::sweep::cross;
use crate::plane::{CoordinateError, PlaneRecorder, Point, Subdivision};
use crate::topology::{IdError, InnerComponent, NoRecorder};

/// Why a vertex cannot be moved to a place.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SetPointError {
    /// The vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// A coordinate that cannot be used.
    #[error("the new place: {0}")]
    Coordinate(#[from] CoordinateError),
    /// Another vertex is there.
    #[error("{vertex} cannot move to {point}: {other} is there; choose another place, or join the two")]
    Occupied {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// Who is there.
        other: VertexId,
    },
    /// The place lies on an edge.
    #[error("{vertex} cannot move to {point}: the place lies on {edge}; choose a place beside it")]
    OnEdge {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// A half-edge of the edge.
        edge: HalfEdgeId,
    },
    /// An edge of the vertex would cross another edge, or come to lie on its other side.
    #[error("with {vertex} at {point}, {moved} would cross {crossed}; choose a place on this side of it")]
    Crosses {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// The half-edge from the vertex that goes along.
        moved: HalfEdgeId,
        /// A half-edge of the edge that it would cross.
        crossed: HalfEdgeId,
    },
    /// An edge of the vertex would pass through another vertex.
    #[error("with {vertex} at {point}, {moved} would pass through {through}; choose another place")]
    ThroughVertex {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// The half-edge from the vertex that goes along.
        moved: HalfEdgeId,
        /// The vertex on the way.
        through: VertexId,
    },
    /// A face at the vertex would be turned inside out.
    #[error("with {vertex} at {point}, {face} would be turned over; choose a place on this side of its other corners")]
    TurnsOver {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// The face.
        face: FaceId,
    },
    /// The vertex, or something that lies in a face beside it, would come to lie in another face.
    #[error("with {vertex} at {point}, {inner} would no longer lie in {face}; move it there by removing and inserting")]
    LeavesFace {
        /// The vertex that moves.
        vertex: VertexId,
        /// The place.
        point: Point,
        /// A vertex of what would lie elsewhere: an inner component, or the moved vertex itself.
        inner: VertexId,
        /// The face that it lies in now.
        face: FaceId,
    },
}

impl Subdivision {
    /// Whether [`set_point`](Self::set_point) would succeed, and if not, why. Changes nothing.
    pub fn can_set_point(&self, vertex: VertexId, point: Point) -> Result<(), SetPointError> {
        self.dcel.check(vertex)?;
        point.check()?;
        if self.points[vertex] == point {
            return Ok(());
        }
        let one_ring: Vec<HalfEdgeId> = self.dcel.outgoing_half_edges(vertex).collect();
        if one_ring.is_empty() {
            return self.can_move_alone(vertex, point);
        }
        let mut faces: Vec<(FaceId, HalfEdgeId)> = one_ring.iter().map(|&h| (self.dcel.face(h), h)).collect();
        faces.sort_unstable();
        faces.dedup_by_key(|(f, _)| *f);
        for &(f, _) in &faces {
            self.nothing_in_the_way(vertex, point, f, &one_ring)?;
        }
        one_ring.iter().try_for_each(|&moved| self.same_corner(vertex, point, moved))?;
        let end = |h: HalfEdgeId| self.points[self.dcel.destination(h)];
        let back = |&h: &HalfEdgeId| by_direction(point, end(h), end(self.dcel.ccw(h))).is_ge();
        if one_ring.len() > 2 && one_ring.iter().filter(|&h| back(h)).count() > 1 {
            return Err(SetPointError::TurnsOver { vertex, point, face: self.dcel.face(one_ring[0]) });
        }
        faces.iter().try_for_each(|&(face, start)| self.same_face(vertex, point, face, start))
    }

    /// A vertex without edges stays in its face.
    fn can_move_alone(&self, vertex: VertexId, point: Point) -> Result<(), SetPointError> {
        let face = self.face_around(vertex);
        self.lies_in(face, point).map_err(|at| match at {
            Some(crate::Element::Vertex(other)) => SetPointError::Occupied { vertex, point, other },
            Some(crate::Element::HalfEdge(edge)) => SetPointError::OnEdge { vertex, point, edge },
            _ => SetPointError::LeavesFace { vertex, point, inner: vertex, face },
        })
    }

    /// No vertex or edge of `f` meets the place or an edge of the `one_ring` there. O(size of the face x degree).
    fn nothing_in_the_way(
        &self,
        vertex: VertexId,
        point: Point,
        f: FaceId,
        one_ring: &[HalfEdgeId],
    ) -> Result<(), SetPointError> {
        let passed = |other: VertexId| {
            let at = self.points[other];
            if other == vertex {
                return Ok(());
            }
            if at == point {
                return Err(SetPointError::Occupied { vertex, point, other });
            }
            let along = |&&h: &&HalfEdgeId| {
                let end = self.dcel.destination(h);
                end != other && on_segment(point, self.points[end], at)
            };
            match one_ring.iter().find(along) {
                Some(&moved) => Err(SetPointError::ThroughVertex { vertex, point, moved, through: other }),
                None => Ok(()),
            }
        };
        self.isolated_vertices(f).try_for_each(passed)?;
        for g in self.all_half_edges(f) {
            let ends = [self.dcel.origin(g), self.dcel.destination(g)];
            passed(ends[0])?;
            if ends.contains(&vertex) {
                continue;
            }
            let [a, b] = ends.map(|v| self.points[v]);
            if b != point && on_segment(a, b, point) {
                return Err(SetPointError::OnEdge { vertex, point, edge: g });
            }
            let crosses = |&&h: &&HalfEdgeId| cross(point, self.points[self.dcel.destination(h)], a, b);
            if let Some(&moved) = one_ring.iter().find(crosses) {
                return Err(SetPointError::Crosses { vertex, point, moved, crossed: g });
            }
        }
        Ok(())
    }

    /// The edge of `moved` leaves its other end between the same neighbours as before.
    fn same_corner(&self, vertex: VertexId, point: Point, moved: HalfEdgeId) -> Result<(), SetPointError> {
        let back = moved.twin();
        let (before, after) = (self.dcel.cw(back), self.dcel.ccw(back));
        if after == back {
            return Ok(());
        }
        let at = self.points[self.dcel.origin(back)];
        let [from, to] = [before, after].map(|g| self.points[self.dcel.destination(g)]);
        if in_corner([to, at, from], point) {
            return Ok(());
        }
        let crossed = if orientation(at, self.points[vertex], point).is_gt() { after } else { before };
        Err(SetPointError::Crosses { vertex, point, moved, crossed })
    }

    /// The cycle of `start` runs the same way round as before, and everything else in its face stays in it. O(size of
    /// the cycle x inner components of the face).
    fn same_face(&self, vertex: VertexId, point: Point, face: FaceId, start: HalfEdgeId) -> Result<(), SetPointError> {
        let place = |h: HalfEdgeId| match self.dcel.origin(h) {
            v if v == vertex => point,
            v => self.points[v],
        };
        let cycle = self.dcel.cycle(start).map(place);
        let outer = self.is_on_outer_boundary(start);
        if encloses(cycle.clone()) != outer {
            return Err(SetPointError::TurnsOver { vertex, point, face });
        }
        if self.inner_components(face).is_empty() {
            return Ok(());
        }
        let mut own: Vec<HalfEdgeId> = self.dcel.cycle(start).collect();
        own.sort_unstable();
        let first = self.dcel.half_edge(face).filter(|_| face == self.outer_face()).map(InnerComponent::Cycle);
        for ring in first.into_iter().chain(self.inner_components(face).iter().copied()) {
            if ring.cycle().is_some_and(|h| own.binary_search(&h).is_ok()) {
                continue;
            }
            let inner = self.inner_component_vertex(ring);
            if surrounds(cycle.clone(), self.points[inner]) != outer {
                return Err(SetPointError::LeavesFace { vertex, point, inner, face });
            }
        }
        Ok(())
    }

    /// Moves a vertex to a place, with its edges. Everything hangs together as before: every edge, face and inner
    /// component is the one that it was, and no id changes. Only the two places matter, not the way between them.
    ///
    /// Cost: O(size of the faces at the vertex x its degree), and O(inner components of all faces) for a vertex without edges.
    /// All decisions are exact.
    ///
    /// # Errors
    /// See [`SetPointError`], which names the edge that would be crossed; a refused call leaves everything bit for bit
    /// as it was.
    ///
    /// ```
    /// use dcel_kit::{VertexId, plane::{Point, SetPointError, Subdivision}};
    /// let mut lab = Subdivision::lab_rectangle();
    /// let v1 = VertexId::new(1);
    /// lab.set_point(v1, Point::new(0.0, 100.0))?;
    /// assert_eq!(lab.point(v1), Point::new(0.0, 100.0));
    /// let beyond = Point::new(0.0, 151.0);
    /// assert!(matches!(lab.set_point(v1, beyond), Err(SetPointError::ThroughVertex { .. } | SetPointError::Crosses { .. })));
    /// # Ok::<(), SetPointError>(())
    /// ```
    pub fn set_point(&mut self, vertex: VertexId, point: Point) -> Result<(), SetPointError> {
        self.set_point_with(vertex, point, &mut NoRecorder)
    }

    /// Moves a vertex by a way: [`set_point`](Self::set_point) with its place and the way added up, each coordinate rounded
    /// once.
    ///
    /// # Errors
    /// Those of [`set_point`](Self::set_point).
    ///
    /// ```
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let mut lab = Subdivision::lab_rectangle();
    /// lab.move_vertex(VertexId::new(0), [10.0, -5.0])?;
    /// assert_eq!(lab.point(VertexId::new(0)), Point::new(-240.0, -155.0));
    /// # Ok::<(), dcel_kit::plane::SetPointError>(())
    /// ```
    pub fn move_vertex(&mut self, vertex: VertexId, by: [f64; 2]) -> Result<(), SetPointError> {
        self.move_vertex_with(vertex, by, &mut NoRecorder)
    }

    /// [`move_vertex`](Self::move_vertex), watched by a recorder.
    pub fn move_vertex_with(
        &mut self,
        vertex: VertexId,
        by: [f64; 2],
        rec: &mut impl PlaneRecorder,
    ) -> Result<(), SetPointError> {
        self.dcel.check(vertex)?;
        let Point { x, y } = self.points[vertex];
        self.set_point_with(vertex, Point::new(x + by[0], y + by[1]), rec)
    }

    /// [`set_point`](Self::set_point), watched by a recorder.
    pub fn set_point_with(
        &mut self,
        vertex: VertexId,
        point: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<(), SetPointError> {
        self.can_set_point(vertex, point)?;
        self.place(vertex, point, rec);
        Ok(())
    }
}
