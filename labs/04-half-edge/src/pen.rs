//! A pen that can make two moves: the two splits that you have written. The drawing is made with it.
//!
//! It holds the structure and lets you read it, but not write to it: what you draw, you draw with the splits.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::{Dcel, FaceId, HalfEdgeId, Point, VertexId};
use crate::harness::Meter;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// A half-edge structure that is changed by splits only.
pub struct Pen {
    dcel: Dcel,
    meter: Meter,
}

/// The two moves. Each has as many reads as a call by itself, and so has what you read between two moves.
impl Pen {
    /// Your `Dcel::split_face`.
    #[track_caller]
    pub fn split_face(&mut self, he1: HalfEdgeId, he2: HalfEdgeId) -> bool {
        self.meter.next_move(self.records());
        let done = self.dcel.split_face(he1, he2);
        self.meter.next_move(self.records());
        done
    }

    /// Your `Dcel::split_in_half`.
    #[track_caller]
    pub fn split_in_half(&mut self, he: HalfEdgeId) {
        self.meter.next_move(self.records());
        self.dcel.split_in_half(he);
        self.meter.next_move(self.records());
    }
}

impl Pen {
    fn records(&self) -> usize {
        self.dcel.vertices.len() + self.dcel.half_edges.len() + self.dcel.faces.len()
    }
}

/// Reading; see the functions of the same names in `dcel.rs`.
impl Pen {
    /// The half-edge after `h` along its face.
    #[track_caller]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.dcel.next(h)
    }

    /// The half-edge before `h` along its face.
    #[track_caller]
    pub fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.dcel.prev(h)
    }

    /// The other side of the edge of `h`.
    #[track_caller]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.dcel.twin(h)
    }

    /// The vertex that `h` starts at.
    #[track_caller]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.dcel.origin(h)
    }

    /// The face on the left of `h`.
    #[track_caller]
    pub fn face(&self, h: HalfEdgeId) -> FaceId {
        self.dcel.face(h)
    }

    /// The stored half-edge of the vertex `v`.
    #[track_caller]
    pub fn outgoing_half_edge(&self, v: VertexId) -> HalfEdgeId {
        self.dcel.outgoing_half_edge(v)
    }

    /// The stored half-edge of the face `f`.
    #[track_caller]
    pub fn incident_half_edge(&self, f: FaceId) -> HalfEdgeId {
        self.dcel.incident_half_edge(f)
    }

    /// Where the vertex `v` is.
    #[track_caller]
    pub fn position(&self, v: VertexId) -> Point {
        self.dcel.position(v)
    }

    /// The face around everything.
    pub fn outer_face(&self) -> FaceId {
        self.dcel.outer_face
    }
}

/// Puts a pen to `dcel` and lets `drawing` draw. If that panics, what was drawn until then stays.
pub fn draw(dcel: &mut Dcel, meter: Meter, drawing: fn(&mut Pen)) {
    let mut pen = Pen { dcel: std::mem::take(dcel), meter };
    let outcome = catch_unwind(AssertUnwindSafe(|| drawing(&mut pen)));
    *dcel = pen.dcel;
    if let Err(panic) = outcome {
        resume_unwind(panic);
    }
}
