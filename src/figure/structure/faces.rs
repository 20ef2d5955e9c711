//! Faces as regions of the canvas: outlines with their rings, what the groups say.
//!
//! ```text
//!   ┌───────────────┐     A face is the inside of all its cycles together by the even-odd rule. A dangling edge is
//!   │ f1   ┌────┐   │     walked there and back and so encloses nothing; an island's cycle takes the island
//!   │      │ f2 │   │     out of f1, and f2 fills it.
//!   │      └────┘   │
//!   └───────────────┘     f0 is the frame minus its cycles.
//! ```

use crate::figure::FigureOptions;
use crate::figure::canvas::crop::cut;
use crate::figure::canvas::scene::Attributes;
use crate::figure::canvas::text::counted;
use crate::figure::canvas::vector::{Bounds, Xy};
use crate::figure::structure::skeleton::{Cycles, Skeleton};
use crate::ids::{Element, FaceId, HalfEdgeId};
use crate::plane::PlanarView;
use crate::topology::bounded_cycle;

/// A face that can be filled.
pub(crate) struct Region {
    pub(crate) face: FaceId,
    pub(crate) rings: Vec<Vec<Xy>>,
    pub(crate) half_edges: usize,
    /// A half-edge of each cycle.
    starts: Vec<HalfEdgeId>,
}

impl Region {
    /// The half-edges of all cycles of the face.
    pub(crate) fn walk<'a, V: PlanarView + ?Sized>(&'a self, view: &'a V) -> impl Iterator<Item = HalfEdgeId> + 'a {
        self.starts.iter().flat_map(|&start| bounded_cycle(view, start))
    }

    /// The same region with steps below `step` px left out of its rings.
    pub(crate) fn coarse(&self, step: f64) -> Self {
        let thin = |ring: &Vec<Xy>| {
            let mut kept: Vec<Xy> = Vec::new();
            for &p in ring {
                if kept.last().is_none_or(|&last| (p - last).length() >= step) {
                    kept.push(p);
                }
            }
            kept
        };
        Self { rings: self.rings.iter().map(thin).collect(), starts: self.starts.clone(), ..*self }
    }

    /// Whether a point lies inside by the even-odd rule.
    pub(crate) fn contains(&self, p: Xy) -> bool {
        let mut inside = false;
        for ring in &self.rings {
            let mut a = ring.last().copied().unwrap_or_default();
            for &b in ring {
                inside ^= (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
                a = b;
            }
        }
        inside
    }

    /// Whether a box meets no ring.
    pub(crate) fn is_clear(&self, bounds: &Bounds) -> bool {
        let crosses = |ring: &Vec<Xy>| {
            let mut a = ring.last().copied().unwrap_or_default();
            ring.iter().any(|&b| bounds.meets_segment(std::mem::replace(&mut a, b), b))
        };
        !self.rings.iter().any(crosses)
    }
}

/// The regions of the faces whose cycles were walked. O(half-edges).
pub(crate) fn regions<V: PlanarView + ?Sized>(view: &V, skeleton: &Skeleton, cycles: &Cycles) -> Vec<Region> {
    let mut out: Vec<Region> = Vec::new();
    for (face, half_edges) in cycles.iter() {
        if out.last().is_none_or(|region| region.face != face) {
            out.push(Region { face, rings: Vec::new(), half_edges: 0, starts: Vec::new() });
        }
        let Some(region) = out.last_mut() else { continue };
        let points = half_edges.iter().filter_map(|&h| view.origin(h).and_then(|v| skeleton.place(v)));
        let ring: Vec<Xy> = points.collect();
        let ring = if let Some(window) = &skeleton.window { cut(ring, window) } else { ring };
        if !ring.is_empty() {
            region.rings.push(ring);
        }
        region.half_edges += half_edges.len();
        region.starts.extend(half_edges.first());
    }
    out
}

/// The attributes of a face: its pointers as the view has them.
pub(crate) fn attributes<V: PlanarView + ?Sized>(view: &V, face: FaceId, options: &FigureOptions) -> Attributes {
    let rings: Vec<String> = view.inner_components(face).iter().map(|&ring| Element::from(ring).to_string()).collect();
    let is_so = |is_so: bool| is_so.then(|| "true".to_owned());
    let all = [
        ("data-he", view.half_edge(face).map(|h| h.to_string())),
        ("data-rings", (!rings.is_empty()).then(|| rings.join(" "))),
        ("data-outer", is_so(view.outer_face() == Some(face))),
        ("data-hole", is_so(view.is_hole(face))),
        ("data-name", options.name(face).map(str::to_owned)),
    ];
    all.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
}

/// The tooltip of a face.
pub(crate) fn title<V: PlanarView + ?Sized>(
    view: &V,
    face: FaceId,
    half_edges: usize,
    options: &FigureOptions,
) -> String {
    let name = options.name(face).map(|name| format!(" ({name})")).unwrap_or_default();
    let kind = if view.outer_face() == Some(face) {
        "outer (unbounded) face, "
    } else if view.is_hole(face) {
        "hole, "
    } else {
        ""
    };
    format!("{face}{name}: {kind}{}", counted(half_edges, "half-edge", "half-edges"))
}
