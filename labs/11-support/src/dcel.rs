//! The records of a mesh of triangles in space that changes: vertices and faces come and go.
//!
//! ```text
//!   half_edges   h0     h1     h2     h3         free_half_edges   3, 1      the last one is taken first
//!                live   free   live   free
//!   edges        (0, 1) ─▶ h0, (1, 0) ─▶ h2      from the two ends of a half-edge to its number
//! ```
//!
//! A record that is free keeps its place in the list until it is used again: `live` is false.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::edge_map::EdgeMap;
use crate::harness::{Record, Records};

/// The number of a vertex.
pub type VertexId = usize;

/// The number of a half-edge.
pub type HalfEdgeId = usize;

/// The number of a face.
pub type FaceId = usize;

/// A point of a picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Upwards.
    pub y: f64,
}

/// A point of space, or a direction: x, y, z.
pub type Place = [f64; 3];

/// A corner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex {
    /// Any one half-edge that starts here and has a face; `None` if there is none.
    pub outgoing_half_edge: Option<HalfEdgeId>,
    /// Where it is.
    pub pos: Place,
    /// Whether it exists.
    pub live: bool,
}

/// One side of an edge.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HalfEdge {
    /// The vertex it starts at.
    pub origin: Option<VertexId>,
    /// The triangle on its left; `None` at a border.
    pub face: Option<FaceId>,
    /// The half-edge before it along its triangle; `None` at a border.
    pub prev: Option<HalfEdgeId>,
    /// The half-edge after it along its triangle; `None` at a border.
    pub next: Option<HalfEdgeId>,
    /// The other side of the same edge.
    pub twin: Option<HalfEdgeId>,
    /// Whether it exists.
    pub live: bool,
}

/// A triangle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Face {
    /// Any one of its half-edges.
    pub incident_half_edge: Option<HalfEdgeId>,
    /// Whether it exists.
    pub live: bool,
}

/// A half-edge that refers to nothing: what a new one begins with, and what a free one is left as.
pub const NO_HALF_EDGE: HalfEdge =
    HalfEdge { origin: None, face: None, prev: None, next: None, twin: None, live: false };

impl Record for Vertex {
    const KIND: &'static str = "vertex";
    const LETTER: char = 'v';
}

impl Record for HalfEdge {
    const KIND: &'static str = "half-edge";
    const LETTER: char = 'h';
}

impl Record for Face {
    const KIND: &'static str = "face";
    const LETTER: char = 'f';
}

/// A mesh of triangles in space.
#[derive(Clone, Default)]
pub struct Mesh {
    /// All vertices, those that are free among them.
    pub vertices: Records<Vertex>,
    /// All half-edges.
    pub half_edges: Records<HalfEdge>,
    /// All faces.
    pub faces: Records<Face>,
    /// The vertices that are free.
    pub free_vertices: Vec<VertexId>,
    /// The half-edges that are free.
    pub free_half_edges: Vec<HalfEdgeId>,
    /// The faces that are free.
    pub free_faces: Vec<FaceId>,
    /// Each half-edge by its origin and its destination.
    pub edges: EdgeMap,
}

/// Reading. Each function panics with a sentence that names the element if the reference is not set.
impl Mesh {
    /// The half-edge after `h` along its triangle.
    #[track_caller]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        set(self.half_edges[h].next, "next", "half-edge", h)
    }

    /// The half-edge before `h` along its triangle.
    #[track_caller]
    pub fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        set(self.half_edges[h].prev, "prev", "half-edge", h)
    }

    /// The other side of the edge of `h`.
    #[track_caller]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        set(self.half_edges[h].twin, "twin", "half-edge", h)
    }

    /// The vertex that `h` starts at.
    #[track_caller]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        set(self.half_edges[h].origin, "origin", "half-edge", h)
    }

    /// The triangle on the left of `h`; `None` at a border.
    #[track_caller]
    pub fn face(&self, h: HalfEdgeId) -> Option<FaceId> {
        self.half_edges[h].face
    }

    /// The stored half-edge of `f`.
    #[track_caller]
    pub fn incident_half_edge(&self, f: FaceId) -> HalfEdgeId {
        set(self.faces[f].incident_half_edge, "incident half-edge", "face", f)
    }

    /// Where `v` is.
    #[track_caller]
    pub fn position(&self, v: VertexId) -> Place {
        self.vertices[v].pos
    }

    /// The half-edge from `a` to `b`, if there is one: the answer of the edge map, in O(log n).
    pub fn half_edge_between(&self, a: VertexId, b: VertexId) -> Option<HalfEdgeId> {
        self.edges.get(&(a, b)).copied()
    }

    /// All half-edges that start at `v`, those at a border, too, with the vertices where they end, in the order of these:
    /// the answer of the edge map, in O(log n + k) for k of them.
    pub fn half_edges_from(&self, v: VertexId) -> Vec<(VertexId, HalfEdgeId)> {
        self.edges.from(v).collect()
    }
}

#[track_caller]
fn set(reference: Option<usize>, name: &str, kind: &str, number: usize) -> usize {
    match reference {
        Some(to) => to,
        None => panic!("the {name} of {kind} {number} is not set"),
    }
}
