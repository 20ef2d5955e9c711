//! A view read once into flat arrays, so that the invariants, the comparison and the counts walk plain numbers.
//!
//! ```text
//!   view.next(h14) = h3       next[14] = 3
//!   view.next(h15) = none     next[15] = NONE, and a fault:  h15.next = none
//!   view.next(h16) = h99      next[16] = NONE, and a fault:  h16.next = h99, but h99 does not exist
//! ```
//!
//! After reading, every number in the arrays is the number of a live element. Each getter of the view is asked
//! once for each element, whatever the view holds. The columns of a structure from which nothing was removed are taken as
//! they are, without a copy.

use super::view::{InnerComponent, View, Words};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use std::borrow::Cow;
use std::convert::Infallible;
use std::ops::ControlFlow;

/// No target.
pub(super) const NONE: u32 = u32::MAX;

/// A pointer that leads nowhere.
pub(super) struct Fault {
    /// Whose pointer it is; `None` for `outer_face`.
    pub(super) owner: Option<Element>,
    /// The name of the pointer.
    pub(super) pointer: &'static str,
    /// The element it names although there is no such element; `None` if the pointer is missing.
    pub(super) found: Option<Element>,
}

/// The pointers of a view in flat arrays; `NONE` where there is no live target.
#[derive(Default)]
pub(super) struct Flat<'a> {
    pub(super) origin: Cow<'a, [u32]>,
    /// Empty if the twin of h is h ^ 1, everywhere.
    twin: Vec<u32>,
    pub(super) next: Cow<'a, [u32]>,
    pub(super) prev: Cow<'a, [u32]>,
    pub(super) face: Cow<'a, [u32]>,
    pub(super) outgoing: Cow<'a, [u32]>,
    pub(super) boundary: Cow<'a, [u32]>,
    /// Face and inner component, in the order of the faces; only inner components that name a live element.
    pub(super) rings: Vec<(u32, InnerComponent)>,
    pub(super) outer: Option<u32>,
    pub(super) hole: Vec<bool>,
    /// Whether the vertex's `outgoing` leads nowhere, which is not the same as having none. Empty if none does.
    pub(super) lost_outgoing: Vec<bool>,
    /// Which elements exist; empty if all do.
    has_vertex: Vec<bool>,
    has_half_edge: Vec<bool>,
    has_face: Vec<bool>,
}

impl<'a> Flat<'a> {
    /// Reads a view and drops what leads nowhere.
    pub(super) fn read<V: View + ?Sized>(view: &'a V) -> Self {
        match Self::read_with::<V, Infallible>(view, |_| ControlFlow::Continue(())) {
            ControlFlow::Continue(flat) => flat,
            ControlFlow::Break(never) => match never {},
        }
    }

    /// Reads a view and reports every pointer that leads nowhere, in the order of the elements. A missing
    /// `outgoing` or `half_edge` is no fault here: it may be right.
    pub(super) fn read_with<V: View + ?Sized, B>(
        view: &'a V,
        mut fault: impl FnMut(Fault) -> ControlFlow<B>,
    ) -> ControlFlow<B, Self> {
        let whole = view.words().and_then(Self::whole);
        let is_copied = whole.is_none();
        let mut flat = match whole {
            Some(flat) => flat,
            None => Self::copied(view, &mut fault)?,
        };
        flat.hole = vec![false; flat.boundary.len()];
        for f in flat.faces().map(FaceId).collect::<Vec<_>>() {
            flat.hole[f.index()] = view.is_hole(f);
            if is_copied {
                let found = view.half_edge(f).map(Element::HalfEdge);
                flat.boundary.to_mut()[f.index()] = flat.live_number(found);
                if found.is_some() && flat.boundary[f.index()] == NONE {
                    fault(Fault { owner: Some(f.into()), pointer: "half_edge", found })?;
                }
            }
            for &ring in view.inner_components(f) {
                let found = Some(Element::from(ring));
                if flat.live_number(found) == NONE {
                    fault(Fault { owner: Some(f.into()), pointer: "inner_component", found })?;
                } else {
                    flat.rings.push((f.0, ring));
                }
            }
        }
        if let Some(f) = view.outer_face() {
            let found = Some(Element::Face(f));
            if flat.live_number(found) == NONE {
                fault(Fault { owner: None, pointer: "outer_face", found })?;
            } else {
                flat.outer = Some(f.0);
            }
        }
        ControlFlow::Continue(flat)
    }

    /// The columns as they are, if every pointer leads to a live element or, where it may, to none.
    fn whole(words: Words<'a>) -> Option<Self> {
        let Words { origin, next, prev, face, outgoing, boundary } = words;
        let (vs, hs, fs) = (outgoing.len() as u32, next.len() as u32, boundary.len() as u32);
        let below = |column: &[u32], bound: u32| column.iter().all(|&word| word < bound);
        // A removed record holds a word that is neither.
        let below_or_none = |column: &[u32]| column.iter().all(|&word| word < hs || word == NONE);
        let is_whole = below(origin, vs) && below(next, hs) && below(prev, hs) && below(face, fs);
        (is_whole && below_or_none(outgoing) && below_or_none(boundary)).then(|| Self {
            origin: origin.into(),
            next: next.into(),
            prev: prev.into(),
            face: face.into(),
            outgoing: outgoing.into(),
            boundary: boundary.into(),
            ..Self::default()
        })
    }

    /// What the getters say of half-edges and vertices.
    fn copied<V: View + ?Sized, B>(view: &V, fault: &mut impl FnMut(Fault) -> ControlFlow<B>) -> ControlFlow<B, Self> {
        let (vs, hs, fs) = (view.vertex_bound(), view.half_edge_bound(), view.face_bound());
        let mut flat = Self {
            has_vertex: (0..vs).map(|i| view.has_vertex(VertexId(i as u32))).collect(),
            has_half_edge: (0..hs).map(|i| view.has_half_edge(HalfEdgeId(i as u32))).collect(),
            has_face: (0..fs).map(|i| view.has_face(FaceId(i as u32))).collect(),
            lost_outgoing: vec![false; vs],
            ..Self::default()
        };
        let [mut origin, mut twin, mut next, mut prev, mut face] = [(); 5].map(|()| vec![NONE; hs]);
        let mut outgoing = vec![NONE; vs];
        for h in flat.half_edges().map(HalfEdgeId).collect::<Vec<_>>() {
            let targets: [(&'static str, Option<Element>); 5] = [
                ("origin", view.origin(h).map(Element::Vertex)),
                ("twin", view.twin(h).map(Element::HalfEdge)),
                ("next", view.next(h).map(Element::HalfEdge)),
                ("prev", view.prev(h).map(Element::HalfEdge)),
                ("face", view.face(h).map(Element::Face)),
            ];
            let mut numbers = [NONE; 5];
            for (number, (pointer, found)) in numbers.iter_mut().zip(targets) {
                *number = flat.live_number(found);
                if *number == NONE {
                    fault(Fault { owner: Some(h.into()), pointer, found })?;
                }
            }
            let i = h.index();
            [origin[i], twin[i], next[i], prev[i], face[i]] = numbers;
        }
        for v in flat.vertices().map(VertexId).collect::<Vec<_>>() {
            let found = view.outgoing(v).map(Element::HalfEdge);
            outgoing[v.index()] = flat.live_number(found);
            flat.lost_outgoing[v.index()] = found.is_some() && outgoing[v.index()] == NONE;
            if flat.lost_outgoing[v.index()] {
                fault(Fault { owner: Some(v.into()), pointer: "outgoing", found })?;
            }
        }
        let [origin, next, prev, face] = [origin, next, prev, face].map(Cow::Owned);
        let [outgoing, boundary] = [outgoing, vec![NONE; fs]].map(Cow::Owned);
        ControlFlow::Continue(Self { origin, twin, next, prev, face, outgoing, boundary, ..flat })
    }

    /// The other half of the edge of half-edge `h`.
    #[inline]
    pub(super) fn twin(&self, h: u32) -> u32 {
        self.twin.get(h as usize).copied().unwrap_or(h ^ 1)
    }

    /// The number of an element that exists, else `NONE`.
    fn live_number(&self, element: Option<Element>) -> u32 {
        let (count, flags, number) = match element {
            Some(Element::Vertex(v)) => (self.outgoing.len(), &self.has_vertex, v.0),
            Some(Element::HalfEdge(h)) => (self.next.len(), &self.has_half_edge, h.0),
            Some(Element::Face(f)) => (self.boundary.len(), &self.has_face, f.0),
            Some(Element::Edge(_)) | None => return NONE,
        };
        let i = number as usize;
        let is_live = if flags.is_empty() { i < count } else { flags.get(i).is_some_and(|&live| live) };
        if is_live { number } else { NONE }
    }

    /// The live vertices.
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(self.outgoing.len(), &self.has_vertex)
    }

    /// The live half-edges.
    pub(super) fn half_edges(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(self.next.len(), &self.has_half_edge)
    }

    /// The live faces.
    pub(super) fn faces(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(self.boundary.len(), &self.has_face)
    }

    /// One half-edge for each listed cycle with the face that lists it: boundaries first, then inner components.
    pub(super) fn listed_cycles(&self) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
        let boundaries = self.faces().map(|f| (f, self.boundary[f as usize])).filter(|&(_, h)| h != NONE);
        boundaries.chain(self.rings.iter().filter_map(|&(f, ring)| Some((f, ring.cycle()?.0))))
    }

    /// The vertices listed as isolated, with the face that lists each.
    pub(super) fn listed_vertices(&self) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
        self.rings.iter().filter_map(|&(f, ring)| Some((f, ring.isolated()?.0)))
    }
}

/// The numbers of those that exist: all below `count` if there are no flags.
fn live(count: usize, flags: &[bool]) -> impl Iterator<Item = u32> + Clone + '_ {
    (0..count.max(flags.len()) as u32).filter(|&i| flags.get(i as usize) != Some(&false))
}

/// The orbits of a map that sends no two half-edges to the same one and may be undefined (`None`) at some.
///
/// `visit` gets every *closed* orbit once, as a slice in walking order; chains that end somewhere are passed
/// over. Starts are tried in the given order. `is_new` is true when it is first asked of a half-edge. Linear, whatever
/// the map.
pub(super) fn closed_orbits<B>(
    starts: impl Iterator<Item = u32>,
    mut is_new: impl FnMut(u32) -> bool,
    step: impl Fn(u32) -> Option<u32>,
    mut visit: impl FnMut(&[u32]) -> ControlFlow<B>,
) -> ControlFlow<B> {
    let mut orbit = Vec::new();
    for start in starts {
        orbit.clear();
        let mut at = Some(start);
        while let Some(h) = at.filter(|&h| is_new(h)) {
            orbit.push(h);
            at = step(h);
        }
        if !orbit.is_empty() && at == Some(start) {
            visit(&orbit)?;
        }
    }
    ControlFlow::Continue(())
}
