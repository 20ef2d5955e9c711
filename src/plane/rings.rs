//! Bookkeeping of inner components while faces are split and joined.

use super::cycle::surrounds;
use super::{PlaneChange, PlaneRecorder, Point, Subdivision};
use crate::geometry::places::from_left_to_right;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::topology::{InnerComponent, NoRecorder};

/// An inner component while its face is being looked for.
pub(super) struct Loose {
    /// The inner component. The half-edges of a cycle point to `f0` for the time being, or to the owner.
    pub(super) ring: InnerComponent,
    /// Its leftmost vertex.
    pub(super) leftmost: VertexId,
    /// The face that it is known to belong to.
    pub(super) owner: Option<FaceId>,
}

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
        self.inner_components(f).iter().filter_map(|ring| ring.isolated())
    }

    /// The cycle of `start` as an inner component whose face is being looked for. O(length).
    pub(super) fn loose_cycle(&self, start: HalfEdgeId, owner: Option<FaceId>) -> Loose {
        Loose { ring: InnerComponent::Cycle(start), leftmost: self.leftmost(start), owner }
    }

    /// Hangs every inner component into the face straight below its leftmost vertex, that is, above the edge `edge_below`
    /// it. Inner components are taken from left to right, so that the cycle below has its face already. `check` is asked
    /// with the leftmost vertex, the owner and the face; cycles without owner then point to the face.
    ///
    /// In every face the cycles come in the order of their half-edges, then the isolated vertices.
    ///
    /// Cost: O(r log r) for r inner components, and O(length) for each cycle that is not one of `f0`.
    pub(super) fn place_inner_components<E>(
        &mut self,
        loose: &[Loose],
        edge_below: impl Fn(VertexId) -> Option<EdgeId>,
        mut check: impl FnMut(&Self, VertexId, Option<FaceId>, FaceId) -> Result<(), E>,
    ) -> Result<(), E> {
        let places = (0..).zip(loose).map(|(i, loose)| (loose.leftmost.number(), i));
        let order = from_left_to_right(places, |v| self.points[VertexId::new(v)]);
        let mut is_outer = vec![false; loose.len()];
        for (_, i) in order {
            let Loose { ring, leftmost, owner } = loose[i];
            let below = edge_below(leftmost);
            let face = below.map_or(self.outer_face(), |edge| self.dcel.face(self.upper_half(edge)));
            check(self, leftmost, owner, face)?;
            is_outer[i] = face == self.outer_face();
            if is_outer[i] {
                continue;
            }
            if owner.is_none() {
                self.hang_inner_component(ring, face);
            } else {
                self.inner_components.entry(face).or_default().push(ring);
            }
        }
        let outer = loose.iter().zip(is_outer).filter(|&(_, is_outer)| is_outer).map(|(loose, _)| loose.ring);
        self.order_inner_components(outer.collect());
        Ok(())
    }

    /// Hangs an inner component into a bounded face, behind the others there.
    pub(super) fn hang_inner_component(&mut self, ring: InnerComponent, face: FaceId) {
        self.relabel_inner_component(ring, face, &mut NoRecorder);
        self.inner_components.entry(face).or_default().push(ring);
    }

    /// Puts the inner components of every face in order: the cycles in that of their half-edges, then the isolated
    /// vertices. Those of `f0` are given, the others hang in their faces already.
    pub(super) fn order_inner_components(&mut self, mut outer: Vec<InnerComponent>) {
        let order = |ring: &InnerComponent| match *ring {
            InnerComponent::Cycle(h) => (0, h.number()),
            InnerComponent::Isolated(v) => (1, v.number()),
        };
        outer.sort_unstable_by_key(order);
        self.inner_components.values_mut().for_each(|rings| rings.sort_unstable_by_key(order));
        self.give_inner_components(self.outer_face(), outer, &mut NoRecorder);
    }

    /// Takes the inner components of `f` out of the map. The boundary of `f0` is one of them.
    pub(super) fn take_inner_components(&mut self, f: FaceId, rec: &mut impl PlaneRecorder) -> Vec<InnerComponent> {
        let rest = self.inner_components.remove(&f).unwrap_or_default();
        if !rest.is_empty() {
            rec.plane(|| PlaneChange::InnerComponents { face: f, old: rest.clone() });
        }
        let first = if f == self.outer_face() { self.dcel.half_edge(f) } else { None };
        first.map(InnerComponent::Cycle).into_iter().chain(rest).collect()
    }

    /// Gives `f` the inner components; the first cycle among those of `f0` becomes its boundary.
    pub(super) fn give_inner_components(
        &mut self,
        f: FaceId,
        mut rings: Vec<InnerComponent>,
        rec: &mut impl PlaneRecorder,
    ) {
        if f == self.outer_face() {
            let first = rings.iter().position(|ring| ring.cycle().is_some()).map(|i| rings.remove(i));
            let boundary = first.and_then(InnerComponent::cycle);
            if self.dcel.half_edge(f) != boundary {
                self.dcel.set_half_edge(f, boundary, rec);
            }
        }
        let old =
            if rings.is_empty() { self.inner_components.remove(&f) } else { self.inner_components.insert(f, rings) };
        if old.is_some() || self.inner_components.contains_key(&f) {
            rec.plane(|| PlaneChange::InnerComponents { face: f, old: old.unwrap_or_default() });
        }
    }

    /// Replaces a cycle in the list of `f` by another half-edge of the same cycle.
    pub(super) fn rename_inner_component(
        &mut self,
        f: FaceId,
        [gone, stays]: [HalfEdgeId; 2],
        rec: &mut impl PlaneRecorder,
    ) {
        let Some(rings) = self.inner_components.get_mut(&f) else { return };
        if let Some(i) = rings.iter().position(|&ring| ring == InnerComponent::Cycle(gone)) {
            rec.plane(|| PlaneChange::InnerComponents { face: f, old: rings.clone() });
            rings[i] = InnerComponent::Cycle(stays);
        }
    }

    /// Makes all half-edges of an inner component point to `f`.
    pub(super) fn relabel_inner_component(&mut self, ring: InnerComponent, f: FaceId, rec: &mut impl PlaneRecorder) {
        if let InnerComponent::Cycle(start) = ring {
            self.relabel_cycle(start, f, rec);
        }
    }

    /// Makes all half-edges of the cycle of `start` point to `f`.
    pub(super) fn relabel_cycle(&mut self, start: HalfEdgeId, f: FaceId, rec: &mut impl PlaneRecorder) {
        let mut h = start;
        loop {
            self.dcel.set_face(h, f, rec);
            h = self.dcel.next(h);
            if h == start {
                return;
            }
        }
    }

    /// Which of the inner components is the cycle through `h`.
    pub(super) fn inner_component_index(&self, rings: &[InnerComponent], h: HalfEdgeId) -> Option<usize> {
        let cycles = rings.iter().enumerate().filter_map(|(i, ring)| Some((ring.cycle()?, i)));
        let mut starts: Vec<(HalfEdgeId, usize)> = cycles.collect();
        starts.sort_unstable();
        let find = |h: HalfEdgeId| starts.binary_search_by_key(&h, |&(start, _)| start).ok();
        self.dcel.cycle(h).find_map(find).map(|i| starts[i].1)
    }

    /// Whether the cycle through `h` is the outer boundary of its face (never so for `f0`).
    pub(super) fn is_on_outer_boundary(&self, h: HalfEdgeId) -> bool {
        let f = self.dcel.face(h);
        f != self.outer_face()
            && (self.inner_components(f).is_empty() || self.dcel.cycle(h).any(|g| Some(g) == self.dcel.half_edge(f)))
    }

    /// Shares out `inner components`, which lay in `old`, between `old` and the new bounded face `new` cut off from it:
    /// each goes to the face that it lies in. The inner component with index `split` stays; it touches both faces.
    ///
    /// Cost: O(inner components x length of the new boundary).
    pub(super) fn share_inner_components(
        &mut self,
        [old, new]: [FaceId; 2],
        rings: Vec<InnerComponent>,
        split: Option<usize>,
        rec: &mut impl PlaneRecorder,
    ) {
        let (mut kept, mut moved) = (Vec::new(), Vec::new());
        for (i, ring) in rings.into_iter().enumerate() {
            let inside = Some(i) != split
                && self
                    .dcel
                    .half_edge(new)
                    .is_some_and(|h| surrounds(self.corner_points(h), self.points[self.inner_component_vertex(ring)]));
            if inside { moved.push(ring) } else { kept.push(ring) }
        }
        for &ring in &moved {
            self.relabel_inner_component(ring, new, rec);
        }
        self.give_inner_components(old, kept, rec);
        self.give_inner_components(new, moved, rec);
    }

    /// A vertex of the inner component.
    pub(super) fn inner_component_vertex(&self, ring: InnerComponent) -> VertexId {
        match ring {
            InnerComponent::Cycle(h) => self.dcel.origin(h),
            InnerComponent::Isolated(v) => v,
        }
    }
}
