//! The invariants of a half-edge structure, checked on any view, right or wrong.
//!
//! ```text
//!         h ────> ●  D1: h.next starts where      every invariant is a path; a violation names the elements
//!   T2: h.twin    │      h.twin starts              on the path and what was found instead:
//!         <────── │  N2: h.next.prev = h
//!                 v  F1: h.next.face = h.face         N2: h14.next = h3, but h3.prev = h9 (expected h14)
//!              h.next
//! ```
//!
//! | id | invariant |
//! |----|-----|
//! | R1 | no pointer of a half-edge is missing |
//! | R2 | every pointer leads to an element that exists |
//! | T1 | h.twin != h |
//! | T2 | h.twin.twin = h |
//! | N1 | h.prev.next = h |
//! | N2 | h.next.prev = h |
//! | D1 | h.next.origin = h.twin.origin |
//! | F1 | h.next.face = h.face |
//! | B1 | f.half_edge.face = f |
//! | B2 | f.half_edge exists |
//! | O1 | v.outgoing.origin = v |
//! | O2 | v.outgoing exists if any half-edge starts at v |
//! | S1 | the half-edges that start at v form one round |
//! | C1 | every boundary cycle is listed by its face |
//! | C2 | no boundary cycle is listed twice |
//! | C3 | an inner component of f has face f |
//! | I1 | a vertex listed as isolated has no outgoing |
//! | I2 | an isolated vertex is listed once |
//! | I3 | an isolated vertex is listed if there is an outer face |
//! | H1 | the outer face is not a hole face |
//! | E1 | in the plane, V - E + cycles = 2 for every component |
//! | E2 | in the plane, every component is an inner component of exactly one face that encloses it |
//!
//! An invariant whose path runs over a pointer that was reported already is not judged there, so one mistake gives few
//! lines: a missing `next` is one R1, not also an incomplete cycle. Nothing is lost by that: an invariant is passed over
//! only where another violation stands in the report. The invariants of geometry (bounded faces counter-clockwise, no
//! crossings) need coordinates and are the plane's.
//!
//! Cost: O(V + E + F + inner components) time and memory on every view. Each getter is asked once for each element; walks
//! mark what they have seen, so that many chains into one long tail are not walked many times.
//!
//! ```text
//!   marks.rs   What has been found of each half-edge, a byte for each
//!   planar.rs  The invariants of the plane that need no coordinates
//!   rules.rs   The invariants as data
//! ```

mod invariants;
mod marks;
mod planar;
mod rules;

use super::flat::Flat;
use super::view::View;
use crate::ids::{Element, HalfEdgeId};
use crate::progress::Stage;
use invariants::Invariants;
pub use rules::Rule;
use std::fmt;
use std::ops::ControlFlow;

/// One broken invariant at one place. `Display` gives the sentence: `N2: h14.next = h3, but h3.prev = h9 (expected h14)`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The invariant.
    pub rule: &'static Rule,
    /// The elements concerned, the one whose pointer or state is at fault first.
    pub elements: Vec<Element>,
    /// The half-edges that were walked to see it, in order.
    pub chain: Vec<HalfEdgeId>,
    /// The element that was found; `None` if nothing was, or if the invariant is about numbers.
    pub found: Option<Element>,
    /// The element that should have been found, if the invariant names one.
    pub expected: Option<Element>,
    text: String,
}

impl Violation {
    fn new(rule: &'static Rule, elements: &[Element], chain: &[u32], text: String) -> Self {
        let chain = chain.iter().map(|&h| HalfEdgeId(h)).collect();
        Self { rule, elements: elements.to_vec(), chain, found: None, expected: None, text }
    }

    fn with(self, found: Option<Element>, expected: Option<Element>) -> Self {
        Self { found, expected, ..self }
    }

    /// The sentence without the rule's id.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.rule.id, self.text)
    }
}

/// All violations, in the order of the rules' families and of the elements. Empty if every invariant holds.
///
/// ```
/// use dcel_kit::{HalfEdgeId, topology::{Dcel, Table, violations}};
/// let mut table = Table::from_view(&Dcel::polygon(3)?);
/// assert!(violations(&table).is_empty());
/// table.half_edges[2].as_mut().unwrap().prev = Some(HalfEdgeId::new(4));
/// let lines: Vec<String> = violations(&table).iter().map(|v| v.to_string()).collect();
/// assert_eq!(lines, [
///     "N2: h0.next = h2, but h2.prev = h4 (expected h0)",
///     "N1: h2.prev = h4, but h4.next = h0 (expected h2)",
/// ]);
/// # Ok::<(), dcel_kit::topology::PolygonError>(())
/// ```
#[must_use]
pub fn violations<V: View + ?Sized>(view: &V) -> Vec<Violation> {
    let mut all = Vec::new();
    let _ = visit_violations(view, &mut |violation: &Violation| {
        all.push(violation.clone());
        ControlFlow::Continue(())
    });
    all
}

/// The first violation that [`violations`] would list.
#[must_use]
pub fn first_violation<V: View + ?Sized>(view: &V) -> Option<Violation> {
    let mut first = None;
    let _ = visit_violations(view, &mut |violation: &Violation| {
        first = Some(violation.clone());
        ControlFlow::Break(())
    });
    first
}

/// The parts of a check that take about as long as each other.
const PARTS: usize = 9;

/// Gives the violations to `visit` one by one until it breaks off. Returns whether it did.
pub fn visit_violations<V: View + ?Sized>(
    view: &V,
    visit: &mut impl FnMut(&Violation) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let stage = Stage::new("checking", PARTS * view.half_edge_bound());
    let mut lost = Lost { lists: vec![false; view.face_bound()], any: false, outer: false };
    let flat = Flat::read_with(view, |fault| {
        lost.any = true;
        match fault.owner {
            Some(Element::Face(f)) => lost.lists[f.index()] = true,
            None => lost.outer = true,
            _ => {}
        }
        visit(&invariants::lost_pointer(&fault))
    })?;
    judge(&flat, lost, &stage, visit)
}

/// Which pointers lead nowhere.
struct Lost {
    /// Faces with a fault in what they list: an unlisted cycle of theirs is no news.
    lists: Vec<bool>,
    /// That to the outer face.
    outer: bool,
    /// Any.
    any: bool,
}

/// All that is left to be judged when the pointers are read.
fn judge(
    flat: &Flat<'_>,
    lost: Lost,
    stage: &Stage,
    visit: &mut dyn FnMut(&Violation) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let part_done = || stage.add(flat.next.len());
    part_done();
    let mut any = lost.any;
    let mut report = |violation: Violation| {
        any = true;
        visit(&violation)
    };
    let mut invariants = Invariants::new(flat, lost.lists, &mut report);
    invariants.twins()?;
    part_done();
    invariants.links()?;
    part_done();
    invariants.boundaries(lost.outer)?;
    part_done();
    invariants.origins()?;
    part_done();
    invariants.stars()?;
    part_done();
    invariants.cycles()?;
    part_done();
    invariants.isolated_vertices()?;
    part_done();
    invariants.outer_face()?;
    drop(invariants);
    if !any && flat.outer.is_some() {
        planar::check(flat, visit)?;
    }
    ControlFlow::Continue(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::FaceId;
    use crate::topology::{FaceRow, Table};

    /// The face without a boundary may be the outer one.
    #[test]
    fn a_lost_pointer_to_the_outer_face_is_all_that_is_told_of_a_face_without_boundary() {
        let face = Some(FaceRow::default());
        let table = Table { faces: vec![face], outer_face: Some(FaceId(1)), ..Table::default() };
        let told: Vec<String> = violations(&table).iter().map(ToString::to_string).collect();
        assert_eq!(told, ["R2: outer_face = f1, but f1 does not exist"]);
    }
}
