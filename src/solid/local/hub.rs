//! The common part of the two bevels: the inside of a hub is cut out.
//!
//! ```text
//!         o2 ╲       ╱ o1              o2 ╲       ╱ o1        hub: a vertex, or the two ends of an edge.
//!             ╲     ╱                      ●─────●            o0, o1, ...: the half-edges that leave it,
//!              ╲   ╱                      ╱       ╲           counter-clockwise. Each gets a corner of the
//!        o3 ──── hub ──── o0  ==>  o3 ───●         ● ─── o0   new face. A vertex of the hub is a corner itself,
//!              ╱   ╲                      ╲       ╱           on one of its half-edges; the others are new.
//!             ╱     ╲                      ●─────●
//! ```
//!
//! Phases, each made of edits of the kernel: split the half-edges that get new corners; join neighbouring corners by
//! an edge, where the face between them is split; remove the spokes that are left inside.

use crate::ids::{HalfEdgeId, VertexId};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::Quiet;

/// A half-edge that leaves the hub.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Spoke {
    /// The half-edge.
    pub(super) out: HalfEdgeId,
    /// Where its corner is going to be.
    pub(super) place: [f64; 3],
    /// Whether its origin is the corner.
    pub(super) stays: bool,
}

impl Polyhedron {
    /// Cuts out a hub with these spokes, at least three. If two stay, they are the first two, and the edge between their
    /// origins is a side of the new face. The spoke of the first corner that does not stay becomes one, too.
    ///
    /// Cost: O(spokes, and the sizes of the faces between them).
    pub(super) fn open_hub(&mut self, spokes: &[Spoke], rec: &mut impl SurfaceRecorder) {
        let n = spokes.len();
        let hub: Vec<VertexId> = spokes.iter().map(|spoke| self.dcel.origin(spoke.out)).collect();

        rec.step(1, "Give every edge that leaves a corner of its own.");
        // The half-edge that goes on from each corner, away from the hub.
        let mut onward = Vec::with_capacity(n);
        for spoke in spokes {
            if spoke.stays {
                onward.push(spoke.out);
                self.place(self.dcel.origin(spoke.out), spoke.place, rec);
            } else {
                let (corner, rest) = self.dcel.split_edge_unchecked(spoke.out, &mut Quiet(&mut *rec));
                onward.push(rest);
                self.place(corner, spoke.place, rec);
            }
        }

        rec.step(2, "Join neighbouring corners by edges; inside of them a part of each face is cut off.");
        let is_side = |i: usize, j: usize| match (spokes[i].stays, spokes[j].stays) {
            (false, false) => false,
            (true, true) => (i, j) == (0, 1),
            // A spoke leads from the corner that stays to the new one.
            _ => hub[i] == hub[j],
        };
        let mut kept = vec![false; n];
        for i in 0..n {
            let j = (i + 1) % n;
            if is_side(i, j) {
                kept[i] |= !spokes[i].stays;
                kept[j] |= !spokes[j].stays;
                continue;
            }
            let into = self.dcel.next(onward[j].twin());
            self.dcel.split_face_unchecked(onward[i], into, &mut Quiet(&mut *rec));
        }

        rec.step(3, "Take away the edges that are left inside.");
        for (i, spoke) in spokes.iter().enumerate() {
            if !spoke.stays && !kept[i] {
                self.dcel.join_faces_unchecked(spoke.out, &mut Quiet(&mut *rec));
            }
        }
    }
}
