//! Taking away many edges: as one after another, but the half-edges of the faces that grow are written once.
//!
//! ```text
//!   ┌───┬───┬───┬───┐      ┌───────────────┐      One by one, the face that goes may be the one that has grown so far,
//!   │ f1│ f2│ f3│ f4│ ==>  │ f4            │      and all its half-edges are written again each time. Here it is only
//!   └───┴───┴───┴───┘      └───────────────┘      noted which face stands for which; the half-edges come last.
//! ```

use crate::ids::{EdgeId, FaceId};
use crate::plane::{PlaneRecorder, Subdivision};
use std::collections::{BTreeMap, BTreeSet};

/// Faces that have gone, and whose half-edges do not know it yet.
#[derive(Default)]
struct Joined {
    /// The face that has taken the place of another; it may have gone itself.
    by: BTreeMap<FaceId, FaceId>,
    /// Those that have gone, in order.
    gone: Vec<FaceId>,
}

impl Joined {
    /// The face that stands in the place of a face. O(log n), over many calls.
    fn find(&mut self, f: FaceId) -> FaceId {
        let mut end = f;
        while let Some(&by) = self.by.get(&end) {
            end = by;
        }
        let mut at = f;
        while let Some(by) = self.by.get_mut(&at).filter(|by| **by != end) {
            at = std::mem::replace(by, end);
        }
        end
    }
}

impl Subdivision {
    /// Takes away edges in their order. Of the two faces beside each the face of its first half stays if `stays` says so,
    /// else the other one. Returns the faces that stayed, some of which a later edge may have taken.
    ///
    /// Cost: O(k log k) for k half-edges of the faces beside the edges, and O(k) for each edge that by then has the same
    /// face, a hole, or a face with inner components on a side.
    ///
    /// # Errors
    /// The face at an edge that cannot be taken away. The caller goes back.
    pub(crate) fn remove_edges_with(
        &mut self,
        edges: impl IntoIterator<Item = EdgeId>,
        stays: impl Fn(FaceId) -> bool,
        rec: &mut impl PlaneRecorder,
    ) -> Result<BTreeSet<FaceId>, FaceId> {
        let (mut joined, mut kept) = (Joined::default(), BTreeSet::new());
        for e in edges {
            let halves = e.half_edges();
            let [f, g] = halves.map(|h| joined.find(self.dcel.face(h)));
            let (h, gone, stayed) = if stays(f) { (halves[1], g, f) } else { (halves[0], f, g) };
            kept.insert(stayed);
            let is_plain =
                |f: FaceId| f != self.outer_face() && !self.is_hole(f) && self.inner_components(f).is_empty();
            if f != g && is_plain(f) && is_plain(g) {
                self.dcel.lead_past_edge(h, stayed, rec);
                self.dcel.remove_edge_record(e, rec);
                joined.by.insert(gone, stayed);
                joined.gone.push(gone);
                continue;
            }
            self.name_joined(&mut joined, rec);
            let done = match f == g {
                true => self.remove_edge_with(e, rec).is_ok(),
                false => self.join_faces_with(h, rec).is_ok(),
            };
            if !done {
                return Err(stayed);
            }
        }
        self.name_joined(&mut joined, rec);
        Ok(kept)
    }

    /// Makes the half-edges of faces that have gone point to those that have taken their place. Each of these has one cycle.
    fn name_joined(&mut self, joined: &mut Joined, rec: &mut impl PlaneRecorder) {
        let gone = std::mem::take(&mut joined.gone);
        let grown: BTreeSet<FaceId> = gone.iter().map(|&f| joined.find(f)).collect();
        joined.by.clear();
        for f in grown {
            let start = self.dcel.half_edge(f).expect("a bounded face has a boundary");
            let mut h = start;
            loop {
                if self.dcel.face(h) != f {
                    self.dcel.set_face(h, f, rec);
                }
                h = self.dcel.next(h);
                if h == start {
                    break;
                }
            }
        }
        for f in gone {
            self.dcel.remove_face_record(f, rec);
        }
    }
}
