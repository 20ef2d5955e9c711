//! Walks of lab 04 that this lab stands on, and the smallest uses of your two splits.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::{Dcel, HalfEdgeId};

impl Dcel {
    /// The half-edge that starts where `h` starts, next to it counter-clockwise.
    #[track_caller]
    pub fn ccw(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(self.prev(h))
    }

    /// The half-edges round the face of `first`, from it on.
    #[track_caller]
    pub fn cycle(&self, first: HalfEdgeId) -> Vec<HalfEdgeId> {
        let walk = std::iter::successors(Some(first), |&h| Some(self.next(h)).filter(|&h| h != first));
        walk.collect()
    }

    /// A spur: a new edge from the origin of `h` into its face, to a new vertex. It calls your `split_vertex`. Returns
    /// the half-edge that comes back from the new vertex.
    #[track_caller]
    pub fn spur(&mut self, h: HalfEdgeId) -> HalfEdgeId {
        let before = self.ccw(h);
        match self.split_vertex(before, before) {
            Some(out) => self.twin(out),
            None => panic!("split_vertex has refused a spur at half-edge {h}"),
        }
    }

    /// Cuts a triangle off the face of `h`: its sides are `h`, the half-edge after it, and a new one. It calls your
    /// `split_face`, and returns what that returns.
    #[track_caller]
    pub fn cut_corner(&mut self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.split_face(self.next(self.next(h)), h)
    }
}
