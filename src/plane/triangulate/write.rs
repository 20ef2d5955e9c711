//! The write phase: all diagonals and faces at once.
//!
//! ```text
//!   1. an edge for each diagonal   2. the links that changed   3. a face for each piece, but the one at
//!                                                                 half_edge(f) keeps f
//! ```

use super::Triangulated;
use super::patch::Links;
use crate::ids::FaceId;
use crate::plane::{PlaneChange, PlaneRecorder, Subdivision};

impl Subdivision {
    /// Writes the links of a patch of `faces` and their pieces, each by its first half-edge. O(patch).
    pub(super) fn write_pieces(
        &mut self,
        faces: &[FaceId],
        mut links: Links,
        pieces: &[u32],
        rec: &mut impl PlaneRecorder,
    ) -> Triangulated {
        let (given, diagonals) = (links.given.len(), links.diagonals());
        let mut added =
            Triangulated { diagonals: Vec::with_capacity(diagonals), new_faces: Vec::with_capacity(pieces.len()) };
        let mut ids = std::mem::take(&mut links.given);
        ids.reserve(2 * diagonals);
        self.dcel.reserve(0, diagonals, pieces.len());

        rec.step(1, "Create two new half-edges for each diagonal.");
        for i in given..links.next.len() {
            if ids.len() == i {
                let edge = self.dcel.add_edge_record(rec);
                ids.extend_from_slice(&edge.half_edges());
                added.diagonals.push(edge);
            }
            let v = links.vertex[links.origin[i] as usize];
            self.dcel.set_origin(ids[i], v, rec);
            if self.dcel.outgoing(v).is_none() {
                self.dcel.set_outgoing(v, Some(ids[i]), rec);
            }
        }

        rec.step(2, "Insert them into the cyclic lists.");
        let mut pen = self.dcel.pen();
        for (i, (&h, &next)) in ids.iter().zip(&links.next).enumerate() {
            let next = ids[next as usize];
            if i >= given || pen.next(h) != next {
                pen.set_next(h, next, rec);
            }
        }

        rec.step(3, "Give each piece a face.");
        for &start in pieces {
            let old = links.face_of(start);
            let first = ids[start as usize];
            let keeps = self.dcel.half_edge(old) == Some(first);
            let face = if keeps { old } else { self.dcel.add_face_record(rec) };
            let mut pen = self.dcel.pen();
            if !keeps {
                pen.set_half_edge(face, Some(first), rec);
                if start as usize >= given {
                    // It has diagonals only: who follows the changes is to see which face it comes from.
                    pen.set_face(first, old, rec);
                }
                added.new_faces.push((face, old));
            }
            // All half-edges of the piece point to its face.
            let mut i = start;
            loop {
                let h = ids[i as usize];
                if i as usize >= given || pen.face(h) != face {
                    pen.set_face(h, face, rec);
                }
                i = links.next[i as usize];
                if i == start {
                    break;
                }
            }
        }
        for &f in faces {
            let given = self.inner_components.remove(&f);
            if let Some(old) = given {
                rec.plane(|| PlaneChange::InnerComponents { face: f, old });
            }
        }
        if !self.holes.is_empty() {
            let holes: Vec<FaceId> =
                added.new_faces.iter().filter(|(_, old)| self.holes.contains(old)).map(|&(new, _)| new).collect();
            for f in holes {
                self.mark_hole(f, true, rec);
            }
        }
        added
    }
}
