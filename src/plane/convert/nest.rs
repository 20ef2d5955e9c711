//! Which face every border cycle and every inner component belongs to.
//!
//! ```text
//!   ┌───────────────┐   f0        Border cycles that surround a bounded region: that region is a hole face.
//!   │ domain        │             All others are inner components: of f0, or of the hole face they lie in (islands).
//!   │  ┌─────────┐  │             An inner component's face is found straight below its leftmost vertex: it is the face
//!   │  │ hole ┌─┐│  │             above the next edge down. Inner components are asked from left to right, so that the
//!   │  │      └─┘│  │             cycle below has its face already.
//!   │  └─────────┘  │
//!   └───────────────┘
//! ```

use super::ConvertError;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::Subdivision;
use crate::plane::cycle::encloses;
use crate::plane::rings::Loose;
use crate::plane::sweep::{NOTHING, sweep};
use crate::topology::{InnerComponent, NoRecorder, PolygonList, TooMany};

impl Subdivision {
    /// Gives every border half-edge its face and every face its cycles. `border` are the half-edges without a
    /// face; `polygons` is given if some faces have several cycles. Returns the number of inner components.
    pub(super) fn nest(&mut self, border: &[u32], polygons: Option<&PolygonList>) -> Result<usize, ConvertError> {
        let mut edges: Vec<EdgeId> = border.iter().map(|&h| HalfEdgeId::new(h).edge()).collect();
        let mut loose = self.border_cycles(border)?;
        if let Some(polygons) = polygons {
            self.cycles_of_polygons(polygons, &mut loose, &mut edges)?;
        }
        if let [Loose { ring: InnerComponent::Cycle(start), owner: None, .. }] = *loose {
            self.dcel.set_half_edge(self.outer_face(), Some(start), &mut NoRecorder);
            return Ok(1);
        }
        let count = loose.len();
        edges.sort_unstable();
        edges.dedup();
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| self.edge_ends(e).map(VertexId::number)).collect();
        let below = sweep(self.points.as_slice(), &ends, &[], false).below;

        let edge_below = |v: VertexId| match below[v.index()] {
            NOTHING => None,
            edge => Some(edges[edge as usize]),
        };
        self.place_inner_components(&loose, edge_below, |s, leftmost, owner, face| {
            let vertex = leftmost.number();
            match owner {
                Some(owner) if owner != face => Err(ConvertError::HoleOutside { face: owner.number() - 1, vertex }),
                None if face != s.outer_face() && !s.is_hole(face) => {
                    Err(ConvertError::InsideFace { face: face.number() - 1, vertex })
                }
                _ => Ok(()),
            }
        })?;
        Ok(count)
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
                self.dcel.set_half_edge(hole, Some(start), &mut NoRecorder);
                self.relabel_cycle(start, hole, &mut NoRecorder);
                self.holes.insert(hole);
            } else {
                loose.push(self.loose_cycle(start, None));
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
            let mut common_edge = None;
            let (mut corner_count, mut walked) = (0, 0);
            for corners in polygons.cycles(number) {
                corner_count += corners.len();
                let ends = [corners[0], corners[1]].map(VertexId::new);
                let Some(start) = self.half_edge_of(face, ends) else { return Err(in_pieces) };
                if seen[start.index()] {
                    continue;
                }
                for h in self.dcel.cycle(start) {
                    seen[h.index()] = true;
                    walked += 1;
                    edges.push(h.edge());
                    if self.dcel.face(h.twin()) == face {
                        common_edge = Some(h);
                    }
                }
                if !encloses(self.corner_points(start)) {
                    loose.push(self.loose_cycle(start, Some(face)));
                } else if boundary.replace(start).is_some() {
                    return Err(in_pieces);
                }
            }
            // Holes that touch may also have made more cycles than there are inner components.
            if boundary.is_none() || walked != corner_count {
                return Err(in_pieces);
            }
            if let Some(h) = common_edge {
                let [u, v] = [self.dcel.origin(h), self.dcel.destination(h)].map(VertexId::number);
                return Err(ConvertError::CommonEdge { face: number as u32, u, v });
            }
            self.dcel.set_half_edge(face, boundary, &mut NoRecorder);
        }
        Ok(())
    }

    /// The half-edge of `face` with these ends.
    fn half_edge_of(&self, face: FaceId, [from, to]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let fits = |&h: &HalfEdgeId| self.dcel.destination(h) == to && self.dcel.face(h) == face;
        self.dcel.outgoing_half_edges(from).find(fits)
    }
}
