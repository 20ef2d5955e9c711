//! The index of a map with long thin faces: a cell of equal size would see too many of them.
//!
//! ```text
//!   ●━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━●     A corridor with pillars in a row: the triangles between their tips and the
//!    ╲╲╲╲╲╲╲╲                    ╱ ╱╱       far corner run through all cells of a row. Listed cell by cell they would
//!     ▴  ▴  ▴  ▴  ▴  ▴  ▴  ▴  ▴  ▴          take O(n²) places; the trees of crowded cells take O(n log n).
//! ```
//!
//! It is the point index of the plane ([`Cells`]) over a copy of all edges, so that later changes of the map do not
//! reach it: what it says is tried first, not trusted.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::predicates::left_to_right;
use crate::plane::{Cells, Lines, Location, Point, Subdivision};

/// All edges of a map, with an index.
#[derive(Clone, Debug)]
pub(super) struct Slivers {
    edges: Edges,
    cells: Cells,
}

/// What lies at a point, as it was when the index was made.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Seen {
    /// A vertex.
    Vertex(VertexId),
    /// An edge, with the faces on both sides.
    Edge([FaceId; 2]),
    /// A face, or a hole.
    Face(FaceId),
}

/// Edges from left to right, vertical ones upwards. Half-edge 2i is edge i, half-edge 2i + 1 its twin; each has an
/// origin of its own, with its number, so that a vertex is where a half-edge starts.
#[derive(Clone, PartialEq, Debug)]
struct Edges {
    ends: Vec<[Point; 2]>,
    vertices: Vec<[VertexId; 2]>,
    /// On the left and on the right.
    faces: Vec<[FaceId; 2]>,
}

impl Lines for Edges {
    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(h.number())
    }
    #[inline]
    fn point(&self, v: VertexId) -> Point {
        self.ends[v.index() / 2][v.index() % 2]
    }
    #[inline]
    fn face(&self, h: HalfEdgeId) -> FaceId {
        self.faces[h.index() / 2][h.index() % 2]
    }
}

impl PartialEq for Slivers {
    /// The index follows from the edges.
    fn eq(&self, other: &Self) -> bool {
        self.edges == other.edges
    }
}

impl Slivers {
    /// The index of all edges of a map; `name` says what a face is called. O(n log² n), whatever their shape.
    pub(super) fn new(map: &Subdivision, name: impl Fn(FaceId) -> FaceId) -> Self {
        let halves = map.edges().map(|e| {
            let [h, t] = e.half_edges();
            let is_rightward = left_to_right(map.point(map.origin(h)), map.point(map.origin(t))).is_lt();
            if is_rightward { [h, t] } else { [t, h] }
        });
        let vertices: Vec<[VertexId; 2]> = halves.clone().map(|pair| pair.map(|h| map.origin(h))).collect();
        let ends = vertices.iter().map(|pair| pair.map(|v| map.point(v))).collect();
        let faces = halves.map(|pair| pair.map(|h| name(map.face(h)))).collect();
        let edges = Edges { ends, vertices, faces };
        let upper = (0..edges.ends.len() as u32).map(|i| HalfEdgeId::new(2 * i));
        let cells = Cells::new(&edges, upper, std::iter::empty(), map.outer_face(), 1.0);
        Self { edges, cells }
    }

    /// What lay at the point. O(log n), exact.
    pub(super) fn look(&self, p: Point) -> Seen {
        match self.cells.locate(&self.edges, p) {
            Location::Vertex(v) => Seen::Vertex(self.edges.vertices[v.index() / 2][v.index() % 2]),
            Location::Edge(h) => Seen::Edge([h, h.twin()].map(|h| self.edges.face(h))),
            Location::Face(f) => Seen::Face(f),
        }
    }

    /// Bytes of the arrays.
    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.edges.ends)
            + size_of_val(&*self.edges.vertices)
            + size_of_val(&*self.edges.faces)
            + self.cells.memory_bytes()
    }
}
