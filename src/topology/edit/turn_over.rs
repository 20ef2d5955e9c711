//! Turning everything over, as in a mirror.
//!
//! ```text
//!        next(h)                     prev(h)          Every half-edge runs the other way and keeps its face: origin and
//!       ●<─────── ●                 ●───────> ●       destination change places, and so do next and prev. What was
//!       │         ^                 ^         │       counter-clockwise is clockwise, so in the mirror everything is as
//!       v    f    │ h     ==>       │    f    │ h     it was. Twice is nothing.
//!       ●         ●                 ●         v
//! ```

use crate::ids::{HalfEdgeId, VertexId};
use crate::topology::Dcel;
use crate::topology::record::Recorder;

impl Dcel {
    /// Turns all half-edges round. All ids, and the faces of all half-edges, stay. O(V + E).
    pub(crate) fn turn_over(&mut self, rec: &mut impl Recorder) {
        let old: Vec<(HalfEdgeId, VertexId, HalfEdgeId)> =
            self.half_edges().map(|h| (h, self.destination(h), self.prev(h))).collect();
        rec.step(1, "Let every half-edge start where it ended.");
        for &(h, origin, _) in &old {
            self.set_origin(h, origin, rec);
        }
        rec.step(2, "Make every cyclic list run backwards.");
        for &(h, _, next) in &old {
            self.set_next(h, next, rec);
        }
        rec.step(3, "Make every vertex point to the other half of its edge.");
        let vertices: Vec<VertexId> = self.vertices().collect();
        for v in vertices {
            if let Some(h) = self.outgoing(v) {
                self.set_outgoing(v, Some(h.twin()), rec);
            }
        }
    }
}
