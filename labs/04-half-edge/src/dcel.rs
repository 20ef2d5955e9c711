//! The records of a half-edge structure, with the small functions that every part of the lab uses.
//!
//! ```text
//!                 twin
//!        <──────────────────────
//!      ●                          ●        the face of a half-edge lies on its LEFT
//!    origin ────── half-edge ───▶  destination
//!         ▲        (face)       │
//!    prev │                     ▼ next
//! ```
//!
//! Records refer to each other by number: the vertex 3 is `dcel.vertices[3]`, the half-edge 7 is
//! `dcel.half_edges[7]`, the face 0 is `dcel.faces[0]`. A reference that is not set yet is `None`.
//!
//! The lists are [`Records`]: they are used like a `Vec`, and count how often your code looks at a record.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::harness::{Record, Records};

/// The number of a vertex: its place in `Dcel::vertices`.
pub type VertexId = usize;

/// The number of a half-edge: its place in `Dcel::half_edges`.
pub type HalfEdgeId = usize;

/// The number of a face: its place in `Dcel::faces`.
pub type FaceId = usize;

/// A point of the plane. y points up.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Upwards.
    pub y: f64,
}

/// A corner of the drawing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex {
    /// Any one half-edge that has this vertex as its origin.
    pub outgoing_half_edge: Option<HalfEdgeId>,
    /// Where it is. The only geometry in the whole structure.
    pub pos: Point,
}

/// One side of an edge.
#[derive(Clone, Copy, PartialEq, Debug)]
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

/// A region of the drawing. The outer face is one, too.
#[derive(Clone, Copy, PartialEq, Debug)]
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

/// A subdivision of the plane into faces.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Dcel {
    /// All vertices.
    pub vertices: Records<Vertex>,
    /// All half-edges.
    pub half_edges: Records<HalfEdge>,
    /// All faces.
    pub faces: Records<Face>,
    /// The face around everything.
    pub outer_face: FaceId,
}

/// Making records. Each function appends one record and returns its number.
impl Dcel {
    /// Appends a vertex at (x, y). Its outgoing half-edge is not set yet.
    #[track_caller]
    pub fn new_vertex(&mut self, x: f64, y: f64) -> VertexId {
        self.vertices.push(Vertex { outgoing_half_edge: None, pos: Point { x, y } });
        self.vertices.len() - 1
    }

    /// Appends a half-edge that starts at `origin`. Its other four references are not set yet.
    #[track_caller]
    pub fn new_half_edge(&mut self, origin: VertexId) -> HalfEdgeId {
        self.half_edges.push(HalfEdge { origin: Some(origin), face: None, prev: None, next: None, twin: None });
        self.half_edges.len() - 1
    }

    /// Appends a face. Its incident half-edge is not set yet.
    #[track_caller]
    pub fn new_face(&mut self) -> FaceId {
        self.faces.push(Face { incident_half_edge: None });
        self.faces.len() - 1
    }
}

/// Writing two references at once, so that they always agree.
impl Dcel {
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

/// Reading. Each function panics with a sentence that names the half-edge, vertex or face if the reference has not
/// been set; the line that is reported is the one that called it.
impl Dcel {
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
