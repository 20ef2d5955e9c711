//! Which boundary face each border cycle has, after links of the border have changed.
//!
//! ```text
//!        start                    an arc runs from a half-edge whose prev is new to the next such half-edge.
//!   ──> ●──────>●──────>●         Its inner links are old, so all of it has the same boundary face, or none.
//!                       │ start
//!        arc            v         arcs that follow each other in a round are one cycle: one boundary face
//! ```
//!
//! All arcs are walked in step, until one is left: that one is the longest, and it is never walked to its end.

use crate::geometry::grouping::sorted;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::{SurfaceChange, SurfaceRecorder};
use std::collections::BTreeSet;

impl Polyhedron {
    /// Whether the face of `h` is a boundary face. A half-edge that has no face yet is no border.
    pub(in crate::solid) fn is_border(&self, h: HalfEdgeId) -> bool {
        self.boundary_faces.contains(&self.dcel.face(h))
    }

    /// The first border half-edge from `outgoing(v)` on, counter-clockwise: a gap in the faces round `v`.
    /// O(degree), O(1) if `outgoing` is one.
    pub(super) fn gap_at(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.dcel.outgoing_half_edges(v).find(|&h| self.is_border(h))
    }

    /// Gives each border cycle that was changed one boundary face. `starts` are the border half-edges whose `prev`
    /// or whose face is new, those that are still there; `touched` are the boundary faces that half-edges have lost. Boundary faces without a
    /// cycle are removed.
    ///
    /// Cost: O(k log k) for k starts, and k times the second longest arc.
    pub(super) fn renew_borders(
        &mut self,
        mut starts: Vec<HalfEdgeId>,
        mut touched: Vec<FaceId>,
        rec: &mut impl SurfaceRecorder,
    ) {
        starts.retain(|&h| self.dcel.has_half_edge(h));
        let starts = sorted(starts);
        let label = |this: &Self, h| this.dcel.linked_face(h).filter(|f| this.boundary_faces.contains(f));
        let labels: Vec<Option<FaceId>> = starts.iter().map(|&h| label(self, h)).collect();
        touched.extend(labels.iter().flatten());
        let touched = sorted(touched);

        let (follow, longest) = self.arcs(&starts);
        let mut seen = vec![false; starts.len()];
        let mut taken = BTreeSet::new();
        for first in longest.into_iter().chain(0..starts.len()) {
            if seen[first] {
                continue;
            }
            let mut cycle = Vec::new();
            let mut arc = first;
            while !std::mem::replace(&mut seen[arc], true) {
                cycle.push(arc);
                arc = follow[arc];
            }
            let old = cycle.iter().filter_map(|&arc| labels[arc]).find(|f| !taken.contains(f));
            let face = old.unwrap_or_else(|| {
                let new = self.dcel.add_face_record(rec);
                self.boundary_faces.insert(new);
                rec.surface(SurfaceChange::Border { face: new, is_border: true });
                new
            });
            taken.insert(face);
            self.dcel.set_half_edge(face, Some(starts[first]), rec);
            for &arc in cycle.iter().filter(|&&arc| labels[arc] != Some(face)) {
                let (mut h, end) = (starts[arc], starts[follow[arc]]);
                loop {
                    self.dcel.set_face(h, face, rec);
                    h = self.dcel.next(h);
                    if h == end {
                        break;
                    }
                }
            }
        }
        for gone in touched.into_iter().filter(|f| !taken.contains(f)) {
            self.boundary_faces.remove(&gone);
            self.dcel.remove_face_record(gone, rec);
            rec.surface(SurfaceChange::Border { face: gone, is_border: false });
        }
    }

    /// For each arc the one that follows it, and which is the longest.
    fn arcs(&self, starts: &[HalfEdgeId]) -> (Vec<usize>, Option<usize>) {
        let mut follow = vec![usize::MAX; starts.len()];
        let mut followed = vec![false; starts.len()];
        let mut at = starts.to_vec();
        let mut going: Vec<usize> = (0..starts.len()).collect();
        let mut longest = None;
        while let Some(&last) = going.last() {
            longest = Some(last);
            if going.len() == 1 {
                break;
            }
            going.retain(|&arc| {
                at[arc] = self.dcel.next(at[arc]);
                let reached = starts.binary_search(&at[arc]);
                if let Ok(next) = reached {
                    follow[arc] = next;
                    followed[next] = true;
                }
                reached.is_err()
            });
        }
        // Each arc is followed by one and follows one: what is left for the last one is clear.
        if let (Some(&last), Some(next)) = (going.first(), followed.iter().position(|&is| !is)) {
            follow[last] = next;
        }
        (follow, longest)
    }
}
