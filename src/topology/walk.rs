//! Circulators: round a face by `next`, round a vertex by `prev.twin`.
//!
//! ```text
//!        h2                       twin(prev(h)) = the next one counter-clockwise
//!   ●<────────●                       ● ^
//!   │    f    ^                        \ \  prev(h)
//!   │         │ h1                      \ \
//!   v         │                     f    \ \
//!   ●────────>●                           ● ────── h ─────> ●
//!        h0                               v
//!   h0, next(h0), ...               h, twin(prev(h)), ...
//! ```
//!
//! All of them visit each half-edge once, from either end, O(1) a step, without allocation.

use super::Dcel;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use std::iter::FusedIterator;

/// The half-edges of one boundary cycle, along `next` (from the back: along `prev`).
#[derive(Clone, Debug)]
pub struct Cycle<'a> {
    dcel: &'a Dcel,
    rest: Rest,
}

/// The half-edges that start at one vertex, counter-clockwise (from the back: clockwise).
#[derive(Clone, Debug)]
pub struct OutgoingHalfEdges<'a> {
    dcel: &'a Dcel,
    rest: Rest,
}

/// What is left of a round: from the first half-edge up to, not including, the second. If they are the same, the
/// whole round is left; if nothing is left, it is `None`. So a walk reads only the links of its own direction.
type Rest = Option<(HalfEdgeId, HalfEdgeId)>;

#[inline]
fn step_forward(rest: &mut Rest, after: impl Fn(HalfEdgeId) -> HalfEdgeId) -> Option<HalfEdgeId> {
    let (front, end) = (*rest)?;
    let next = after(front);
    *rest = (next != end).then_some((next, end));
    Some(front)
}

#[inline]
fn step_back(rest: &mut Rest, before: impl Fn(HalfEdgeId) -> HalfEdgeId) -> Option<HalfEdgeId> {
    let (front, end) = (*rest)?;
    let last = before(end);
    *rest = (last != front).then_some((front, last));
    Some(last)
}

/// What is left in one tight loop, for walks that are not asked step by step.
#[inline]
fn fold_forward<B>(
    rest: Rest,
    init: B,
    mut fold: impl FnMut(B, HalfEdgeId) -> B,
    after: impl Fn(HalfEdgeId) -> HalfEdgeId,
) -> B {
    let Some((mut at, end)) = rest else { return init };
    let mut so_far = init;
    loop {
        so_far = fold(so_far, at);
        at = after(at);
        if at == end {
            return so_far;
        }
    }
}

/// A walk that goes on by one function and back by another.
macro_rules! walk {
    ($walk:ident, $forward:ident, $back:ident) => {
        impl Iterator for $walk<'_> {
            type Item = HalfEdgeId;

            #[inline]
            fn next(&mut self) -> Option<HalfEdgeId> {
                step_forward(&mut self.rest, |h| self.dcel.$forward(h))
            }

            #[inline]
            fn fold<B, F: FnMut(B, HalfEdgeId) -> B>(self, init: B, fold: F) -> B {
                fold_forward(self.rest, init, fold, |h| self.dcel.$forward(h))
            }
        }

        impl DoubleEndedIterator for $walk<'_> {
            #[inline]
            fn next_back(&mut self) -> Option<HalfEdgeId> {
                step_back(&mut self.rest, |h| self.dcel.$back(h))
            }
        }

        impl FusedIterator for $walk<'_> {}
    };
}

walk!(Cycle, next, prev);
walk!(OutgoingHalfEdges, ccw, cw);

impl Dcel {
    /// The next half-edge counter-clockwise round the origin of `h`: `twin(prev(h))`. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn ccw(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.prev(h).twin()
    }

    /// The next half-edge clockwise round the origin of `h`: `next(twin(h))`. O(1).
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn cw(&self, h: HalfEdgeId) -> HalfEdgeId {
        if h.index() >= self.half_edge_bound() {
            self.no_such(h);
        }
        self.next(h.twin())
    }

    /// The half-edges of the boundary cycle through `h`, starting with `h`.
    #[must_use]
    #[inline]
    pub fn cycle(&self, h: HalfEdgeId) -> Cycle<'_> {
        Cycle { dcel: self, rest: Some((h, h)) }
    }

    /// The half-edges that start where `h` starts, counter-clockwise from `h`.
    #[must_use]
    #[inline]
    pub fn star(&self, h: HalfEdgeId) -> OutgoingHalfEdges<'_> {
        OutgoingHalfEdges { dcel: self, rest: Some((h, h)) }
    }

    /// The lab's `incidentHalfEdges`: the boundary of `f` in order, from `half_edge(f)` on. A bounded face is
    /// walked counter-clockwise, the outer face clockwise; empty if `f` has no boundary.
    #[inline]
    pub fn incident_half_edges(&self, f: FaceId) -> Cycle<'_> {
        Cycle { dcel: self, rest: self.half_edge(f).map(|h| (h, h)) }
    }

    /// The lab's `incidentVertices`: the origins along the boundary of `f`. A vertex that the boundary
    /// passes twice is listed twice.
    pub fn incident_vertices(&self, f: FaceId) -> impl DoubleEndedIterator<Item = VertexId> + Clone + '_ {
        self.incident_half_edges(f).map(|h| self.origin(h))
    }

    /// The edges along the boundary of `f`. An edge with `f` on both sides is listed twice.
    pub fn incident_edges(&self, f: FaceId) -> impl DoubleEndedIterator<Item = EdgeId> + Clone + '_ {
        self.incident_half_edges(f).map(HalfEdgeId::edge)
    }

    /// The faces across the edges along the boundary of `f`, one for each half-edge, repetitions kept.
    pub fn adjacent_faces(&self, f: FaceId) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        self.incident_half_edges(f).map(|h| self.face(h.twin()))
    }

    /// The half-edges that start at `v`, counter-clockwise from `outgoing(v)`; empty if `v` is isolated.
    #[inline]
    pub fn outgoing_half_edges(&self, v: VertexId) -> OutgoingHalfEdges<'_> {
        OutgoingHalfEdges { dcel: self, rest: self.outgoing(v).map(|h| (h, h)) }
    }

    /// The half-edges that end at `v`, counter-clockwise.
    pub fn incoming_half_edges(&self, v: VertexId) -> impl DoubleEndedIterator<Item = HalfEdgeId> + Clone + '_ {
        self.outgoing_half_edges(v).map(HalfEdgeId::twin)
    }

    /// The other ends of the edges at `v`, counter-clockwise, repetitions kept.
    pub fn adjacent_vertices(&self, v: VertexId) -> impl DoubleEndedIterator<Item = VertexId> + Clone + '_ {
        self.outgoing_half_edges(v).map(|h| self.destination(h))
    }

    /// The faces at the corners of `v`, counter-clockwise, repetitions kept: the i-th lies between the i-th
    /// outgoing half-edge and the next.
    pub fn incident_faces(&self, v: VertexId) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        self.outgoing_half_edges(v).map(|h| self.face(h))
    }

    /// The number of half-edges that start at `v`; a loop counts twice. O(degree).
    #[must_use]
    pub fn degree(&self, v: VertexId) -> usize {
        self.outgoing_half_edges(v).count()
    }

    /// A half-edge from `u` to `v`, the first one counter-clockwise from `outgoing(u)`. O(degree of u).
    #[must_use]
    pub fn find_half_edge(&self, u: VertexId, v: VertexId) -> Option<HalfEdgeId> {
        self.outgoing_half_edges(u).find(|&h| self.destination(h) == v)
    }

    /// All live vertices in the order of their numbers.
    pub fn vertices(&self) -> impl DoubleEndedIterator<Item = VertexId> + Clone + '_ {
        (0..self.vertex_bound() as u32).map(VertexId).filter(|&v| self.has_vertex(v))
    }

    /// All live half-edges in the order of their numbers.
    pub fn half_edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + Clone + '_ {
        (0..self.half_edge_bound() as u32).map(HalfEdgeId).filter(|&h| self.has_half_edge(h))
    }

    /// All live edges in the order of their numbers.
    pub fn edges(&self) -> impl DoubleEndedIterator<Item = EdgeId> + Clone + '_ {
        (0..self.edge_bound() as u32).map(EdgeId).filter(|&e| self.has_edge(e))
    }

    /// All live faces in the order of their numbers.
    pub fn faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        (0..self.face_bound() as u32).map(FaceId).filter(|&f| self.has_face(f))
    }
}
