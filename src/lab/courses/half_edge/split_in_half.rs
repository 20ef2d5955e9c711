//! `split_in_half(he)` in the three steps of the handout.
//!
//! ```text
//!   1 the vertex at the midpoint                            he keeps its origin; on the other side
//!   2 two half-edges more; origins and twins of all four    the old twin may be either of the two
//!   3 next, prev and face, and what the vertices refer to
//! ```

use super::spec::{self, TwinSide};
use crate::checks::align::{Aligned, Difference, Field, align};
use crate::checks::steps::{ELSEWHERE, Steps};
use crate::fault::{Exchange, Fault};
use dcel_kit::topology::{Table, View};
use dcel_kit::{Element, HalfEdgeId};

/// The graded test of each step; there is no step 0, because every call is legal.
pub(super) const TESTS: [&str; 4] =
    ["split_in_half_1_vertex", "split_in_half_1_vertex", "split_in_half_2_half_edges", "split_in_half_3_links"];

/// What should come of a call, in the convention and numbering that fits best.
pub(super) fn expected(before: &Table, he: HalfEdgeId, after: &Table) -> Option<Aligned> {
    let with = |side| {
        let (expected, new) = spec::split_in_half(before, he, side)?;
        Some(align(&expected, &new, after))
    };
    let moved = with(TwinSide::Moved)?;
    if moved.differences.is_empty() {
        return Some(moved);
    }
    [Some(moved), with(TwinSide::Kept)].into_iter().flatten().min_by_key(|aligned| aligned.differences.len())
}

/// Judges one call; the faults of each step go to the test at its place in `tests`.
pub(super) fn judge(exchange: &Exchange, tests: &[&'static str]) -> Vec<Fault> {
    let Some((mut steps, [he])) = Steps::of(exchange, tests) else { return Vec::new() };
    steps_of(&mut steps, he);
    steps.faults
}

fn steps_of(steps: &mut Steps, he: HalfEdgeId) {
    let (before, after) = (steps.before, steps.after);
    let vertices = steps.count(1, "vertices", [before.vertices.len(), after.vertices.len()], 1);
    let faces = steps.count(1, "faces", [before.faces.len(), after.faces.len()], 0);
    let half_edges = steps.count(2, "half-edges", [before.half_edges.len(), after.half_edges.len()], 2);
    let Some(aligned) = expected(before, he, after).filter(|_| vertices && faces) else {
        return steps.unjudged(2..4);
    };
    let old_twin = before.twin(he);
    let (there, back) = (aligned.new.half_edges[0], aligned.new.half_edges[1]);
    let end = old_twin.and_then(|twin| before.origin(twin));
    let role = |element| match element {
        Element::HalfEdge(h) if h == he => "he",
        Element::HalfEdge(h) if h == there => "the new half-edge after he",
        Element::HalfEdge(h) if h == back => "the new half-edge on the other side",
        Element::HalfEdge(h) if Some(h) == old_twin => "the old twin",
        Element::HalfEdge(h) if before.prev(h) == Some(he) => "the one after he",
        Element::HalfEdge(h) if before.next(h) == old_twin => "the one before the old twin",
        Element::HalfEdge(h) if before.prev(h) == old_twin => "the one after the old twin",
        Element::Vertex(v) if !before.has_vertex(v) => "the new vertex",
        Element::Vertex(v) if before.origin(he) == Some(v) => "the origin of he",
        Element::Vertex(v) if Some(v) == end => "the vertex at the end of he",
        Element::Face(f) if before.face(he) == Some(f) => "the face of he",
        Element::Face(f) if old_twin.is_some_and(|twin| before.face(twin) == Some(f)) => "the face of the old twin",
        _ => ELSEWHERE,
    };
    if half_edges {
        steps.differences(&aligned, step_of, role);
    } else {
        // The vertex can be judged without the half-edges; where it refers to needs them.
        let position = |d: &Difference| d.field == Field::Position;
        let differences = aligned.differences.iter().filter(|d| position(d)).cloned().collect();
        steps.differences(&Aligned { differences, ..aligned.clone() }, step_of, role);
        steps.unjudged(3..4);
    }
    steps.must_have_returned();
}

fn step_of(difference: &Difference) -> usize {
    match difference.field {
        Field::Position => 1,
        Field::Origin | Field::Twin => 2,
        _ => 3,
    }
}
