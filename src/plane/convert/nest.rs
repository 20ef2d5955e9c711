//! Which face every border cycle and every ring belongs to.
//!
//! ```text
//!   ┌───────────────┐   f0        Border cycles that surround a bounded region: that region is a hole face.
//!   │ domain        │             All others are rings: of f0, or of the hole face they lie in (islands).
//!   │  ┌─────────┐  │             A ring's face is found straight below its leftmost vertex: it is the face
//!   │  │ hole ┌─┐│  │             above the next edge down. Rings are asked from left to right, so that the
//!   │  │      └─┘│  │             cycle below has its face already.
//!   │  └─────────┘  │
//!   └───────────────┘
//! ```

use super::ConvertError;
use crate::ids::{EdgeId, FaceId, HalfEdgeId};
use crate::plane::Subdivision;
use crate::plane::cycle::encloses;
use crate::plane::predicates::left_to_right;
use crate::plane::sweep::{NOTHING, sweep};
use crate::topology::{NoRecorder, PolygonList, Ring, TooMany};

/// A cycle that is not the outer boundary of a bounded face, and the face that it is known to belong to.
struct Loose {
    start: HalfEdgeId,
    owner: Option<FaceId>,
}

impl Subdivision {
    /// Gives every border half-edge its face and every face its cycles. `border` are the half-edges without a
    /// face; `polygons` is given if some faces have several cycles.
    pub(super) fn nest(&mut self, border: &[u32], polygons: Option<&PolygonList>) -> Result<(), ConvertError> {
        let mut edges: Vec<EdgeId> = border.iter().map(|&h| HalfEdgeId::new(h).edge()).collect();
        let mut loose = self.border_cycles(border)?;
        if let Some(polygons) = polygons {
            self.cycles_of_polygons(polygons, &mut loose, &mut edges)?;
        }
        if let [Loose { start, owner: None }] = *loose {
            self.dcel.set_boundary(self.outer_face(), Some(start), &mut NoRecorder);
            return Ok(());
        }
        edges.sort_unstable();
        edges.dedup();
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| self.edge_ends(e).map(crate::VertexId::number)).collect();
        let below = sweep(self.points.as_slice(), &ends, &[], false).below;

        let mut by_place: Vec<_> = loose.into_iter().map(|cycle| (self.leftmost(cycle.start), cycle)).collect();
        by_place.sort_by(|(u, _), (v, _)| left_to_right(self.points[*u], self.points[*v]));
        let mut outer = Vec::new();
        for (leftmost, Loose { start, owner }) in by_place {
            let vertex = leftmost.number();
            let face = match below[leftmost.index()] {
                NOTHING => self.outer_face(),
                edge => self.dcel.face(self.upper_half(edges[edge as usize])),
            };
            match owner {
                Some(owner) if owner != face => {
                    return Err(ConvertError::HoleOutside { face: owner.number() - 1, vertex });
                }
                None if face != self.outer_face() && !self.is_hole(face) => {
                    return Err(ConvertError::InsideFace { face: face.number() - 1, vertex });
                }
                None if face != self.outer_face() => self.relabel_cycle(start, face, &mut NoRecorder),
                _ => {}
            }
            if face == self.outer_face() {
                outer.push(start);
            } else {
                self.rings.entry(face).or_default().push(Ring::Cycle(start));
            }
        }
        outer.sort_unstable();
        self.rings.values_mut().for_each(|rings| rings.sort_unstable_by_key(first_half_edge));
        self.give_rings(self.outer_face(), outer.into_iter().map(Ring::Cycle).collect(), &mut NoRecorder);
        Ok(())
    }

    /// Traces the border. Cycles round a bounded region become hole faces; all others are labelled f0 for the
    /// time being and returned.
    fn border_cycles(&mut self, border: &[u32]) -> Result<Vec<Loose>, ConvertError> {
        let mut loose = Vec::new();
        for start in border.iter().map(|&h| HalfEdgeId::new(h)) {
            if !self.dcel.lacks_face(start) {
                continue;
            }
            self.relabel_cycle(start, self.outer_face(), &mut NoRecorder);
            if encloses(self.corner_points(start)) {
                self.dcel.room_for(0, 0, 1).map_err(|TooMany| crate::topology::BuildError::from(TooMany))?;
                let hole = self.dcel.add_face_record(&mut NoRecorder);
                self.dcel.set_boundary(hole, Some(start), &mut NoRecorder);
                self.relabel_cycle(start, hole, &mut NoRecorder);
                self.holes.insert(hole);
            } else {
                loose.push(Loose { start, owner: None });
            }
        }
        Ok(loose)
    }

    /// Finds the cycles of faces that were given with holes; where a hole touches the outer cycle or another
    /// hole, the angular links have made one cycle of several.
    fn cycles_of_polygons(
        &mut self,
        polygons: &PolygonList,
        loose: &mut Vec<Loose>,
        edges: &mut Vec<EdgeId>,
    ) -> Result<(), ConvertError> {
        let mut seen = vec![false; self.dcel.half_edge_bound()];
        for number in 0..polygons.face_count() {
            if polygons.cycle_range(number).len() == 1 {
                continue;
            }
            let face = FaceId::new(number as u32 + 1);
            let in_pieces = ConvertError::InPieces { face: number as u32 };
            let mut boundary = None;
            for corners in polygons.cycles(number) {
                let ends = [corners[0], corners[1]].map(crate::VertexId::new);
                let Some(start) = self.half_edge_of(face, ends) else { return Err(in_pieces) };
                if seen[start.index()] {
                    continue;
                }
                for h in self.dcel.cycle(start) {
                    seen[h.index()] = true;
                    edges.push(h.edge());
                }
                if !encloses(self.corner_points(start)) {
                    loose.push(Loose { start, owner: Some(face) });
                } else if boundary.replace(start).is_some() {
                    return Err(in_pieces);
                }
            }
            if boundary.is_none() {
                return Err(in_pieces);
            }
            self.dcel.set_boundary(face, boundary, &mut NoRecorder);
        }
        Ok(())
    }

    /// The half-edge of `face` with these ends.
    fn half_edge_of(&self, face: FaceId, [from, to]: [crate::VertexId; 2]) -> Option<HalfEdgeId> {
        let fits = |&h: &HalfEdgeId| self.dcel.destination(h) == to && self.dcel.face(h) == face;
        self.dcel.outgoing_half_edges(from).find(fits)
    }
}

fn first_half_edge(ring: &Ring) -> HalfEdgeId {
    match *ring {
        Ring::Cycle(h) => h,
        Ring::Isolated(_) => HalfEdgeId::new(u32::MAX),
    }
}
