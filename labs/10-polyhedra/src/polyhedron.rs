//! The records of the surface of a polyhedron, with the small functions that every part of the lab uses.
//!
//! ```text
//!                 twin
//!        <──────────────────────
//!      ●                          ●        the face of a half-edge lies on its LEFT, seen from outside
//!    origin ────── half-edge ───▶  destination
//!         ▲        (face)       │
//!    prev │                     ▼ next
//! ```
//!
//! They are the records of lab 04, with two differences: a point has three coordinates, and no face is the outer one.
//! A record that was removed stays in its list, with nothing set, so that all others keep their numbers.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::harness::{Record, Records};

/// The number of a vertex: its place in `Polyhedron::vertices`.
pub type VertexId = usize;

/// The number of a half-edge: its place in `Polyhedron::half_edges`.
pub type HalfEdgeId = usize;

/// The number of a face: its place in `Polyhedron::faces`.
pub type FaceId = usize;

/// A point of space, or the vector from (0, 0, 0) to it.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// To the back.
    pub y: f64,
    /// Upwards.
    pub z: f64,
}

impl Point {
    /// The vector from `other` to this point.
    pub fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }

    /// The dot product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The cross product: at right angles to both, on the side from which the turn from this one to the other is
    /// counter-clockwise.
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The length of the vector.
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }
}

/// A corner of the solid.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Vertex {
    /// Any one half-edge that has this vertex as its origin.
    pub outgoing_half_edge: Option<HalfEdgeId>,
    /// Where it is.
    pub pos: Point,
}

/// One side of an edge.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct HalfEdge {
    /// The vertex it starts at.
    pub origin: Option<VertexId>,
    /// The face on its left.
    pub face: Option<FaceId>,
    /// The half-edge before it, counter-clockwise along its face.
    pub prev: Option<HalfEdgeId>,
    /// The half-edge after it, counter-clockwise along its face.
    pub next: Option<HalfEdgeId>,
    /// The other side of the same edge; it runs the other way.
    pub twin: Option<HalfEdgeId>,
}

/// A face of the solid.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Face {
    /// Any one half-edge that has this face on its left.
    pub incident_half_edge: Option<HalfEdgeId>,
}

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

/// A row of the winged-edge table. An edge has the number of that one of its two half-edges which is the smaller.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WingedEdge {
    /// The edge.
    pub edge: HalfEdgeId,
    /// The vertex where the half-edge with this number starts.
    pub start: VertexId,
    /// The vertex where it ends.
    pub end: VertexId,
    /// The face on its left.
    pub left: FaceId,
    /// The face on its right.
    pub right: FaceId,
    /// The edge before this one, counter-clockwise along the left face.
    pub left_before: HalfEdgeId,
    /// The edge after it along the left face.
    pub left_after: HalfEdgeId,
    /// The edge before it, counter-clockwise along the right face.
    pub right_before: HalfEdgeId,
    /// The edge after it along the right face.
    pub right_after: HalfEdgeId,
}

/// The surface of a polyhedron.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Polyhedron {
    /// All vertices.
    pub vertices: Records<Vertex>,
    /// All half-edges, the removed ones, too.
    pub half_edges: Records<HalfEdge>,
    /// All faces, the removed ones, too.
    pub faces: Records<Face>,
}

/// What there is. A record that was removed is not listed.
impl Polyhedron {
    /// The numbers of the vertices. (No function of this lab removes a vertex.)
    #[track_caller]
    pub fn vertex_ids(&self) -> Vec<VertexId> {
        (0..self.vertices.len()).collect()
    }

    /// The numbers of the half-edges that are there.
    #[track_caller]
    pub fn half_edge_ids(&self) -> Vec<HalfEdgeId> {
        (0..self.half_edges.len()).filter(|&h| self.half_edges[h].twin.is_some()).collect()
    }

    /// The numbers of the faces that are there.
    #[track_caller]
    pub fn face_ids(&self) -> Vec<FaceId> {
        (0..self.faces.len()).filter(|&f| self.faces[f].incident_half_edge.is_some()).collect()
    }
}

/// Making and removing records.
impl Polyhedron {
    /// Appends a vertex and returns its number. Its outgoing half-edge is not set yet.
    #[track_caller]
    pub fn new_vertex(&mut self, pos: Point) -> VertexId {
        self.vertices.push(Vertex { outgoing_half_edge: None, pos });
        self.vertices.len() - 1
    }

    /// Appends a half-edge and returns its number. Nothing is set yet.
    #[track_caller]
    pub fn new_half_edge(&mut self) -> HalfEdgeId {
        self.half_edges.push(HalfEdge::default());
        self.half_edges.len() - 1
    }

    /// Appends a face and returns its number. Its incident half-edge is not set yet.
    #[track_caller]
    pub fn new_face(&mut self) -> FaceId {
        self.faces.push(Face::default());
        self.faces.len() - 1
    }

    /// Removes `h` and its twin: nothing of the two is set any more. What refers to them is left as it is.
    #[track_caller]
    pub fn remove_edge(&mut self, h: HalfEdgeId) {
        let twin = self.twin(h);
        self.half_edges[h] = HalfEdge::default();
        self.half_edges[twin] = HalfEdge::default();
    }

    /// Removes `f`: its incident half-edge is not set any more. What refers to it is left as it is.
    #[track_caller]
    pub fn remove_face(&mut self, f: FaceId) {
        self.faces[f] = Face::default();
    }

    /// Makes `after` follow `before`: sets `before.next` and `after.prev`.
    #[track_caller]
    pub fn make_next(&mut self, before: HalfEdgeId, after: HalfEdgeId) {
        self.half_edges[before].next = Some(after);
        self.half_edges[after].prev = Some(before);
    }

    /// Makes `a` and `b` the two sides of one edge: sets `a.twin` and `b.twin`.
    #[track_caller]
    pub fn make_twin(&mut self, a: HalfEdgeId, b: HalfEdgeId) {
        self.half_edges[a].twin = Some(b);
        self.half_edges[b].twin = Some(a);
    }
}

/// Reading. Each function panics with a sentence that names the half-edge, vertex or face if the reference is not set;
/// the line that is reported is the one that called it.
impl Polyhedron {
    /// The half-edge after `h` along its face.
    #[track_caller]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        set(self.half_edges[h].next, "next", "half-edge", h)
    }

    /// The half-edge before `h` along its face.
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

    /// The vertex that `h` ends at.
    #[track_caller]
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        self.origin(self.twin(h))
    }

    /// The face on the left of `h`.
    #[track_caller]
    pub fn face(&self, h: HalfEdgeId) -> FaceId {
        set(self.half_edges[h].face, "face", "half-edge", h)
    }

    /// The stored half-edge of `v`: one that starts there.
    #[track_caller]
    pub fn outgoing_half_edge(&self, v: VertexId) -> HalfEdgeId {
        set(self.vertices[v].outgoing_half_edge, "outgoing half-edge", "vertex", v)
    }

    /// The stored half-edge of `f`: one that has `f` on its left.
    #[track_caller]
    pub fn incident_half_edge(&self, f: FaceId) -> HalfEdgeId {
        set(self.faces[f].incident_half_edge, "incident half-edge", "face", f)
    }

    /// Where `v` is.
    #[track_caller]
    pub fn position(&self, v: VertexId) -> Point {
        self.vertices[v].pos
    }
}

#[track_caller]
fn set(reference: Option<usize>, name: &str, kind: &str, number: usize) -> usize {
    match reference {
        Some(to) => to,
        None => panic!("the {name} of {kind} {number} is not set"),
    }
}
