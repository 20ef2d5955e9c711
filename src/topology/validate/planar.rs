//! The invariants of the plane that need no coordinates: every component can be drawn without crossings, and the
//! components nest.
//!
//! ```text
//!   f0 ── inner component ──> component ── boundary ──> f1 ── inner component ──> component ── boundary ──> f2
//!     └── inner component ──> component     └── boundary ──> f3
//! ```
//!
//! Counting the arrows gives Euler's relation: with K cycles and isolated vertices, C of them inner components of the face
//! around their component and one for each bounded face, K = C + (F - 1); and V - E + K = 2C, if no component
//! has a handle; together V - E + F = 1 + C.

use super::super::flat::{Flat, NONE};
use super::super::measure::{count, parts};
use super::Violation;
use super::rules::{E1, E2};
use crate::geometry::grouping::Groups;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::topology::InnerComponent;
use std::ops::ControlFlow;

/// E1 and E2. The view must have an outer face and break no other invariant.
pub(super) fn check(flat: &Flat<'_>, visit: &mut dyn FnMut(&Violation) -> ControlFlow<()>) -> ControlFlow<()> {
    let components = count(flat, &|_| false).components;
    for c in components.iter().filter(|c| c.euler() != 2) {
        let text = format!(
            "the component of {} has V - E + cycles = {} - {} + {} = {} (expected 2: genus {} does not fit in the plane)",
            c.first_vertex,
            c.vertices,
            c.edges,
            c.cycles,
            c.euler(),
            c.genus()
        );
        visit(&Violation::new(&E1, &[c.first_vertex.into()], &[], text))?;
    }
    let firsts: Vec<VertexId> = components.iter().map(|c| c.first_vertex).collect();
    nesting(flat, &firsts, visit)
}

/// E2: walks inwards from the outer face. A component is entered through inner components, a bounded face through its
/// boundary; each component must be entered once.
fn nesting(
    flat: &Flat<'_>,
    firsts: &[VertexId],
    visit: &mut dyn FnMut(&Violation) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let parts = parts(flat);
    let part = |v: u32| parts.of(VertexId(v)).unwrap_or(NONE) as usize;
    let part_of_cycle = |h: u32| part(flat.origin[h as usize]);
    let outer = flat.outer.unwrap_or(NONE);
    let inner_by_face = Groups::new(
        flat.boundary.len(),
        flat.rings.iter().map(|&(f, inner)| match inner {
            InnerComponent::Cycle(h) => (f as usize, (Element::HalfEdge(h), part_of_cycle(h.0))),
            InnerComponent::Isolated(v) => (f as usize, (Element::Vertex(v), part(v.0))),
        }),
    );
    let bounded = flat.faces().filter(|&f| f != outer);
    let faces_by_part = Groups::new(firsts.len(), bounded.map(|f| (part_of_cycle(flat.boundary[f as usize]), f)));

    let mut entered = vec![false; firsts.len()];
    let mut faces = vec![outer];
    while let Some(f) = faces.pop() {
        // All cycles of the outer face are inner components of the plane; its `half_edge` is merely the first of them.
        let first = flat.boundary[f as usize];
        let first = (f == outer && first != NONE).then(|| (HalfEdgeId(first).into(), part_of_cycle(first)));
        for &(inner, c) in first.iter().chain(inner_by_face.of(f as usize)) {
            if std::mem::replace(&mut entered[c], true) {
                let f = FaceId(f);
                let text = format!(
                    "the inner component {inner} of {f} belongs to the component of {}, which is listed already (expected one inner component for each component)",
                    firsts[c]
                );
                visit(&Violation::new(&E2, &[inner, f.into(), firsts[c].into()], &[], text).with(Some(inner), None))?;
                continue;
            }
            faces.extend(faces_by_part.of(c));
        }
    }
    for (c, _) in entered.iter().enumerate().filter(|&(_, &entered)| !entered) {
        let v = firsts[c];
        let text = format!(
            "the component of {v} is not reached from the outer face inwards (expected to be an inner component of the face around it)"
        );
        visit(&Violation::new(&E2, &[v.into()], &[], text))?;
    }
    ControlFlow::Continue(())
}
