//! Bookkeeping of rings while faces are split and joined.

use super::cycle::surrounds;
use super::{Point, Subdivision};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::topology::{Recorder, Ring};

impl Subdivision {
    /// The positions of the origins along the cycle of `h`.
    pub(super) fn corner_points(&self, h: HalfEdgeId) -> impl Iterator<Item = Point> + Clone + '_ {
        self.dcel.cycle(h).map(|h| self.points[self.dcel.origin(h)])
    }

    /// All half-edges whose face is `f`, over all its cycles.
    pub(super) fn all_half_edges(&self, f: FaceId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        self.cycles(f).flat_map(|h| self.dcel.cycle(h))
    }

    /// The isolated vertices in `f`.
    pub(super) fn isolated_vertices(&self, f: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        self.rings(f).iter().filter_map(|ring| match ring {
            Ring::Isolated(v) => Some(*v),
            Ring::Cycle(_) => None,
        })
    }

    /// Takes the rings of `f` out of the map. The boundary of `f0` is one of them.
    pub(super) fn take_rings(&mut self, f: FaceId) -> Vec<Ring> {
        let rest = self.rings.remove(&f).unwrap_or_default();
        let first = if f == self.outer_face() { self.dcel.boundary(f) } else { None };
        first.map(Ring::Cycle).into_iter().chain(rest).collect()
    }

    /// Gives `f` the rings; the first cycle among those of `f0` becomes its boundary.
    pub(super) fn give_rings(&mut self, f: FaceId, mut rings: Vec<Ring>, rec: &mut impl Recorder) {
        if f == self.outer_face() {
            let first = rings.iter().position(|ring| matches!(ring, Ring::Cycle(_))).map(|i| rings.remove(i));
            let boundary = match first {
                Some(Ring::Cycle(h)) => Some(h),
                _ => None,
            };
            if self.dcel.boundary(f) != boundary {
                self.dcel.set_boundary(f, boundary, rec);
            }
        }
        if rings.is_empty() {
            self.rings.remove(&f);
        } else {
            self.rings.insert(f, rings);
        }
    }

    /// Makes all half-edges of a ring point to `f`.
    pub(super) fn relabel_ring(&mut self, ring: Ring, f: FaceId, rec: &mut impl Recorder) {
        if let Ring::Cycle(start) = ring {
            self.relabel_cycle(start, f, rec);
        }
    }

    /// Makes all half-edges of the cycle of `start` point to `f`.
    pub(super) fn relabel_cycle(&mut self, start: HalfEdgeId, f: FaceId, rec: &mut impl Recorder) {
        let mut h = start;
        loop {
            self.dcel.set_face(h, f, rec);
            h = self.dcel.next(h);
            if h == start {
                return;
            }
        }
    }

    /// Which of the rings is the cycle through `h`.
    pub(super) fn ring_index(&self, rings: &[Ring], h: HalfEdgeId) -> Option<usize> {
        let mut starts: Vec<(HalfEdgeId, usize)> = rings
            .iter()
            .enumerate()
            .filter_map(|(i, ring)| match ring {
                Ring::Cycle(start) => Some((*start, i)),
                Ring::Isolated(_) => None,
            })
            .collect();
        starts.sort_unstable();
        let find = |h: HalfEdgeId| starts.binary_search_by_key(&h, |&(start, _)| start).ok();
        self.dcel.cycle(h).find_map(find).map(|i| starts[i].1)
    }

    /// Whether the cycle through `h` is the outer boundary of its face (never so for `f0`).
    pub(super) fn is_on_outer_boundary(&self, h: HalfEdgeId) -> bool {
        let f = self.dcel.face(h);
        f != self.outer_face()
            && (self.rings(f).is_empty() || self.dcel.cycle(h).any(|g| Some(g) == self.dcel.boundary(f)))
    }

    /// Shares out `rings`, which lay in `old`, between `old` and the new bounded face `new` cut off from it:
    /// each goes to the face that it lies in. The ring with index `split` stays; it touches both faces.
    ///
    /// Cost: O(rings x length of the new boundary).
    pub(super) fn share_rings(
        &mut self,
        [old, new]: [FaceId; 2],
        rings: Vec<Ring>,
        split: Option<usize>,
        rec: &mut impl Recorder,
    ) {
        let (mut kept, mut moved) = (Vec::new(), Vec::new());
        for (i, ring) in rings.into_iter().enumerate() {
            let inside = Some(i) != split
                && self.dcel.boundary(new).is_some_and(|h| surrounds(self.corner_points(h), self.ring_point(ring)));
            if inside { moved.push(ring) } else { kept.push(ring) }
        }
        for &ring in &moved {
            self.relabel_ring(ring, new, rec);
        }
        self.give_rings(old, kept, rec);
        self.give_rings(new, moved, rec);
    }

    /// The position of a vertex of the ring.
    fn ring_point(&self, ring: Ring) -> Point {
        self.points[match ring {
            Ring::Cycle(h) => self.dcel.origin(h),
            Ring::Isolated(v) => v,
        }]
    }
}
