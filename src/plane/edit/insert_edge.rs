//! Inserting a straight edge between two vertices.
//!
//! ```text
//!   ┌────── u ─┬──────┐       ┌──────── u ──────┐       ┌─────────────────┐
//!   │   f      │ new  │       │   f      ╲      │       │  f              │
//!   │          │      │       │         ┌─v─┐   │       │   u ───── v     │
//!   │          │      │       │         └───┘   │       │                 │
//!   └───────── v ─────┘       └─────────────────┘       └─────────────────┘
//!   two corners of a cycle:   corners of two cycles:    isolated vertices: a dangling edge,
//!   the face is split         an inner component joins another      or a component of its own
//! ```

use super::Obstacle;
use super::spot::Towards;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::on_segment;
use crate::plane::{PlaneRecorder, Point, Subdivision};
use crate::topology::{IdError, InnerComponent, NoRecorder, TooMany};

/// Why two vertices cannot be joined by a straight edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InsertEdgeError {
    /// A vertex does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
    /// Both ends are the same vertex.
    #[error("both ends are {vertex}: the new edge would have no length")]
    SameVertex {
        /// The vertex.
        vertex: VertexId,
    },
    /// The two vertices are joined by an edge already.
    #[error("{from} and {to} are joined by {existing} already")]
    EdgeExists {
        /// One vertex.
        from: VertexId,
        /// The other vertex.
        to: VertexId,
        /// A half-edge of the edge between them.
        existing: HalfEdgeId,
    },
    /// The segment passes through a vertex.
    #[error("the segment from {from} to {to} passes through {vertex}: insert it in two steps, or as a segment")]
    ThroughVertex {
        /// One end.
        from: VertexId,
        /// The other end.
        to: VertexId,
        /// A vertex on the way.
        vertex: VertexId,
    },
    /// The segment crosses an edge.
    #[error("the segment from {from} to {to} crosses {crossed}: insert it as a segment to split what it crosses")]
    Crosses {
        /// One end.
        from: VertexId,
        /// The other end.
        to: VertexId,
        /// A half-edge it crosses.
        crossed: HalfEdgeId,
    },
}

/// A new edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InsertedEdge {
    /// The half-edge from the first vertex to the second.
    pub half_edge: HalfEdgeId,
    /// The face that was cut off, if the edge split one.
    pub new_face: Option<FaceId>,
}

/// Where a new edge leaves a vertex.
#[derive(Clone, Copy)]
pub(super) enum End {
    /// In the corner at the origin of the half-edge, on its left.
    Corner(HalfEdgeId),
    /// The vertex has no other edge.
    Isolated(VertexId),
}

impl Subdivision {
    /// Whether [`insert_edge`](Self::insert_edge) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(size of the face between the two vertices, and degree of both); for an isolated vertex also
    /// O(number of inner components) to find its face.
    pub fn can_insert_edge(&self, from: VertexId, to: VertexId) -> Result<(), InsertEdgeError> {
        self.plan_edge(from, to).map(drop)
    }

    pub(super) fn plan_edge(&self, from: VertexId, to: VertexId) -> Result<(FaceId, [End; 2]), InsertEdgeError> {
        self.dcel.check(from)?;
        self.dcel.check(to)?;
        self.dcel.room_for(0, 1, 1)?;
        if from == to {
            return Err(InsertEdgeError::SameVertex { vertex: from });
        }
        let (f, one) = self.end_at(from, to)?;
        let way = [from, to].map(|v| self.points[v]);
        let meet = |obstacle| match obstacle {
            Obstacle::Vertex(vertex) => Some(InsertEdgeError::ThroughVertex { from, to, vertex }),
            Obstacle::Edge(crossed) => Some(InsertEdgeError::Crosses { from, to, crossed }),
        };
        if let Some(refusal) = self.find_on_way(f, way, meet) {
            return Err(refusal);
        }
        let (_, other) = self.end_at(to, from)?;
        Ok((f, [one, other]))
    }

    /// How an edge leaves `v` towards the vertex `to`, and the face it runs into.
    fn end_at(&self, v: VertexId, to: VertexId) -> Result<(FaceId, End), InsertEdgeError> {
        match self.towards(v, self.points[to]) {
            Towards::Corner(h) => Ok((self.dcel.face(h), End::Corner(h))),
            Towards::Open(f) => Ok((f, End::Isolated(v))),
            Towards::Along(existing) if self.dcel.destination(existing) == to => {
                Err(InsertEdgeError::EdgeExists { from: v, to, existing })
            }
            Towards::Along(h) => Err(InsertEdgeError::ThroughVertex { from: v, to, vertex: self.dcel.destination(h) }),
        }
    }

    /// Joins two vertices by a straight edge, wherever they lie in the same face.
    ///
    /// Two corners of one cycle: the face is split, as by [`split_face`](Self::split_face); inner components go to the side they
    /// lie on. Corners of two cycles: the cycles become one, and no face is new. A vertex without edges becomes the
    /// free end of a dangling edge, two of them a component of its own. The kind of the face (hole or not) is kept.
    ///
    /// Cost: that of [`can_insert_edge`](Self::can_insert_edge) and, if the face is split, of `split_face`.
    ///
    /// # Errors
    /// See [`InsertEdgeError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let points = [(0., 0.), (4., 0.), (0., 4.), (1., 1.), (2., 1.)].map(Point::from);
    /// let mut s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0]])?;
    /// let v = VertexId::new;
    /// s.insert_edge(v(3), v(4))?; // a component of its own inside the triangle
    /// s.insert_edge(v(0), v(3))?; // hangs on the triangle now
    /// let cut = s.insert_edge(v(4), v(1))?;
    /// assert!(cut.new_face.is_some());
    /// assert_eq!((s.edge_count(), s.face_count()), (6, 3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn insert_edge(&mut self, from: VertexId, to: VertexId) -> Result<InsertedEdge, InsertEdgeError> {
        self.insert_edge_with(from, to, &mut NoRecorder)
    }

    /// [`insert_edge`](Self::insert_edge), watched by a recorder.
    pub fn insert_edge_with(
        &mut self,
        from: VertexId,
        to: VertexId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<InsertedEdge, InsertEdgeError> {
        let plan = self.plan_edge(from, to)?;
        Ok(self.put_edge(plan, [from, to], rec))
    }

    /// The write phase: the plan is what [`plan_edge`](Self::plan_edge) has found.
    pub(super) fn put_edge(
        &mut self,
        (f, ends): (FaceId, [End; 2]),
        vertices: [VertexId; 2],
        rec: &mut impl PlaneRecorder,
    ) -> InsertedEdge {
        if let [End::Corner(h1), End::Corner(h2)] = ends
            && self.dcel.cycle(h1).any(|h| h == h2)
        {
            let (half_edge, new) = self.split_face_unchecked(h1, h2, rec);
            return InsertedEdge { half_edge, new_face: Some(new) };
        }
        InsertedEdge { half_edge: self.join_by_edge(f, vertices, ends, rec), new_face: None }
    }

    /// Puts an edge between two cycles, or isolated vertices, of the face `f`.
    pub(super) fn join_by_edge(
        &mut self,
        f: FaceId,
        vertices: [VertexId; 2],
        ends: [End; 2],
        rec: &mut impl PlaneRecorder,
    ) -> HalfEdgeId {
        let on_boundary = ends.map(|end| matches!(end, End::Corner(h) if self.is_on_outer_boundary(h)));
        let mut rings = self.take_inner_components(f, rec);
        let indices = ends.map(|end| match end {
            End::Corner(h) => self.inner_component_index(&rings, h),
            End::Isolated(v) => rings.iter().position(|&ring| ring == InnerComponent::Isolated(v)),
        });

        rec.step(1, "Create two new half-edges.");
        let [a, b] = self.dcel.add_edge_record(rec).half_edges();
        rec.step(2, "Set their origins and faces.");
        for (h, v) in [(a, vertices[0]), (b, vertices[1])] {
            self.dcel.set_origin(h, v, rec);
            self.dcel.set_face(h, f, rec);
        }
        rec.step(3, "Insert them into the cyclic lists.");
        for (out, end) in [(a, ends[0]), (b, ends[1])] {
            match end {
                End::Corner(h) => {
                    let before = self.dcel.prev(h);
                    self.dcel.set_next(before, out, rec);
                    self.dcel.set_next(out.twin(), h, rec);
                }
                End::Isolated(v) => {
                    self.dcel.set_next(out.twin(), out, rec);
                    self.dcel.set_outgoing(v, Some(out), rec);
                }
            }
        }

        // Of the two inner components one is left, or none if the boundary takes them in.
        let mut found: Vec<usize> = indices.into_iter().flatten().collect();
        found.sort_unstable();
        if let (Some(&kept), [false, false]) = (found.first(), on_boundary) {
            let cycle = found.iter().find_map(|&i| rings[i].cycle());
            rings[kept] = InnerComponent::Cycle(cycle.unwrap_or(a));
            found.remove(0);
        }
        for &i in found.iter().rev() {
            rings.remove(i);
        }
        self.give_inner_components(f, rings, rec);
        a
    }

    /// How an edge leaves the vertex `v` towards a point that is no vertex, and the face it runs through; or what is
    /// in its way, short of the point itself.
    pub(super) fn open_way(&self, v: VertexId, to: Point) -> Result<(FaceId, End), Obstacle> {
        let (f, end) = match self.towards(v, to) {
            Towards::Corner(h) => (self.dcel.face(h), End::Corner(h)),
            Towards::Open(f) => (f, End::Isolated(v)),
            Towards::Along(h) => {
                let next = self.dcel.destination(h);
                let passed = on_segment(self.points[v], to, self.points[next]);
                return Err(if passed { Obstacle::Vertex(next) } else { Obstacle::Edge(h) });
            }
        };
        match self.find_on_way(f, [self.points[v], to], Some) {
            Some(obstacle) => Err(obstacle),
            None => Ok((f, end)),
        }
    }
}
