//! A view read once into flat arrays, so that the invariants, the comparison and the counts walk plain numbers.
//!
//! ```text
//!   view.next(h14) = h3       next[14] = 3
//!   view.next(h15) = none     next[15] = NONE, and a fault:  h15.next = none
//!   view.next(h16) = h99      next[16] = NONE, and a fault:  h16.next = h99, but h99 does not exist
//! ```
//!
//! After reading, every number in the arrays is the number of a live element. Each getter of the view is asked
//! once for each element, whatever the view holds.

use super::view::{InnerComponent, View};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
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
pub(super) struct Flat {
    pub(super) origin: Vec<u32>,
    pub(super) twin: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    pub(super) face: Vec<u32>,
    pub(super) outgoing: Vec<u32>,
    pub(super) boundary: Vec<u32>,
    /// Face and inner component, in the order of the faces; only inner components that name a live element.
    pub(super) rings: Vec<(u32, InnerComponent)>,
    pub(super) outer: Option<u32>,
    pub(super) hole: Vec<bool>,
    /// Whether the vertex's `outgoing` leads nowhere, which is not the same as having none.
    pub(super) lost_outgoing: Vec<bool>,
    has_vertex: Vec<bool>,
    has_half_edge: Vec<bool>,
    has_face: Vec<bool>,
}

impl Flat {
    /// Reads a view and drops what leads nowhere.
    pub(super) fn read<V: View + ?Sized>(view: &V) -> Self {
        match Self::read_with::<V, Infallible>(view, |_| ControlFlow::Continue(())) {
            ControlFlow::Continue(flat) => flat,
            ControlFlow::Break(never) => match never {},
        }
    }

    /// Reads a view and reports every pointer that leads nowhere, in the order of the elements. A missing
    /// `outgoing` or `half_edge` is no fault here: it may be right.
    pub(super) fn read_with<V: View + ?Sized, B>(
        view: &V,
        mut fault: impl FnMut(Fault) -> ControlFlow<B>,
    ) -> ControlFlow<B, Self> {
        let (vs, hs, fs) = (view.vertex_bound(), view.half_edge_bound(), view.face_bound());
        let mut flat = Self {
            has_vertex: (0..vs).map(|i| view.has_vertex(VertexId(i as u32))).collect(),
            has_half_edge: (0..hs).map(|i| view.has_half_edge(HalfEdgeId(i as u32))).collect(),
            has_face: (0..fs).map(|i| view.has_face(FaceId(i as u32))).collect(),
            origin: vec![NONE; hs],
            twin: vec![NONE; hs],
            next: vec![NONE; hs],
            prev: vec![NONE; hs],
            face: vec![NONE; hs],
            outgoing: vec![NONE; vs],
            boundary: vec![NONE; fs],
            hole: vec![false; fs],
            lost_outgoing: vec![false; vs],
            ..Self::default()
        };
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
            [flat.origin[i], flat.twin[i], flat.next[i], flat.prev[i], flat.face[i]] = numbers;
        }
        for v in flat.vertices().map(VertexId).collect::<Vec<_>>() {
            let found = view.outgoing(v).map(Element::HalfEdge);
            flat.outgoing[v.index()] = flat.live_number(found);
            flat.lost_outgoing[v.index()] = found.is_some() && flat.outgoing[v.index()] == NONE;
            if flat.lost_outgoing[v.index()] {
                fault(Fault { owner: Some(v.into()), pointer: "outgoing", found })?;
            }
        }
        for f in flat.faces().map(FaceId).collect::<Vec<_>>() {
            flat.hole[f.index()] = view.is_hole(f);
            let found = view.half_edge(f).map(Element::HalfEdge);
            flat.boundary[f.index()] = flat.live_number(found);
            if found.is_some() && flat.boundary[f.index()] == NONE {
                fault(Fault { owner: Some(f.into()), pointer: "half_edge", found })?;
            }
            for &ring in view.inner_components(f) {
                let found = match ring {
                    InnerComponent::Cycle(h) => Some(Element::HalfEdge(h)),
                    InnerComponent::Isolated(v) => Some(Element::Vertex(v)),
                };
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

    /// The number of an element that exists, else `NONE`.
    fn live_number(&self, element: Option<Element>) -> u32 {
        let (live, number) = match element {
            Some(Element::Vertex(v)) => (&self.has_vertex, v.0),
            Some(Element::HalfEdge(h)) => (&self.has_half_edge, h.0),
            Some(Element::Face(f)) => (&self.has_face, f.0),
            Some(Element::Edge(_)) | None => return NONE,
        };
        if live.get(number as usize).is_some_and(|&live| live) { number } else { NONE }
    }

    /// The live vertices.
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(&self.has_vertex)
    }

    /// The live half-edges.
    pub(super) fn half_edges(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(&self.has_half_edge)
    }

    /// The live faces.
    pub(super) fn faces(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        live(&self.has_face)
    }

    /// One half-edge for each listed cycle with the face that lists it: boundaries first, then inner components.
    pub(super) fn listed_cycles(&self) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
        let boundaries = self.faces().map(|f| (f, self.boundary[f as usize])).filter(|&(_, h)| h != NONE);
        boundaries.chain(self.rings.iter().filter_map(|&(f, ring)| match ring {
            InnerComponent::Cycle(h) => Some((f, h.0)),
            InnerComponent::Isolated(_) => None,
        }))
    }

    /// The vertices listed as isolated, with the face that lists each.
    pub(super) fn listed_vertices(&self) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
        self.rings.iter().filter_map(|&(f, ring)| match ring {
            InnerComponent::Isolated(v) => Some((f, v.0)),
            InnerComponent::Cycle(_) => None,
        })
    }
}

fn live(flags: &[bool]) -> impl Iterator<Item = u32> + Clone + '_ {
    flags.iter().enumerate().filter(|&(_, &live)| live).map(|(i, _)| i as u32)
}

/// The orbits of a map that sends no two half-edges to the same one and may be undefined (`None`) at some.
///
/// `visit` gets every *closed* orbit once, as a slice in walking order; chains that end somewhere are passed
/// over. Starts are tried in the given order. Linear, whatever the map.
pub(super) fn closed_orbits<B>(
    starts: impl Iterator<Item = u32>,
    seen: &mut [bool],
    step: impl Fn(u32) -> Option<u32>,
    mut visit: impl FnMut(&[u32]) -> ControlFlow<B>,
) -> ControlFlow<B> {
    let mut orbit = Vec::new();
    for start in starts {
        orbit.clear();
        let mut at = Some(start);
        while let Some(h) = at.filter(|&h| !std::mem::replace(&mut seen[h as usize], true)) {
            orbit.push(h);
            at = step(h);
        }
        if !orbit.is_empty() && at == Some(start) {
            visit(&orbit)?;
        }
    }
    ControlFlow::Continue(())
}
