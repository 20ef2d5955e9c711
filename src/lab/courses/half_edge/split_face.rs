//! `split_face(he1, he2)` in the six steps of the handout.
//!
//! ```text
//!   0 legal or refused     1 the new face     2 two half-edges, twins, origins
//!   3 next and prev        4 faces            5 a half-edge for each face and vertex
//! ```
//!
//! The outer face is a face like any other. Two corners of one face at the same vertex are joined by a loop.

use super::spec::{self, Legal};
use crate::checks::align::{Difference, Field, align};
use crate::checks::steps::{ELSEWHERE, Steps};
use crate::fault::{Exchange, Fault, FaultKind};
use crate::protocol::{CallEnd, Value};
use dcel_kit::topology::View;
use dcel_kit::{Element, HalfEdgeId};

/// The graded test of each step.
pub(super) const TESTS: [&str; 6] = [
    "split_face_0_legal",
    "split_face_1_new_face",
    "split_face_2_half_edges",
    "split_face_3_links",
    "split_face_4_faces",
    "split_face_5_representatives",
];

/// Whether a call is one that must be carried out; so is one of which nothing is known.
pub(super) fn is_legal(exchange: &Exchange) -> bool {
    match (exchange.before(), exchange.called) {
        (Some(before), Some((&[h1, h2], _))) => {
            let [h1, h2] = [h1, h2].map(HalfEdgeId::new);
            spec::may_split_face(before, h1, h2) == Legal::Yes
        }
        _ => true,
    }
}

/// Judges one call; the faults of each step go to the test at its place in `tests`.
pub(super) fn judge(exchange: &Exchange, tests: &[&'static str]) -> Vec<Fault> {
    let Some((steps, [h1, h2])) = Steps::of(exchange, tests) else { return Vec::new() };
    let mut steps = Steps { loops: Some(4), ..steps };
    match spec::may_split_face(steps.before, h1, h2) {
        Legal::Yes => legal(&mut steps, h1, h2),
        illegal => refused(&mut steps, illegal, h1, h2),
    }
    steps.faults
}

fn refused(steps: &mut Steps, reason: Legal, h1: HalfEdgeId, h2: HalfEdgeId) {
    let because = reason.because();
    let both = [h1.into(), h2.into()];
    let wrong = FaultKind::Wrong;
    match steps.end {
        end @ (CallEnd::Panicked { .. } | CallEnd::Stopped(_)) => {
            let kind = steps.kind(0, false);
            let words = format!("{}; it should return false, because {because}", end.words());
            steps.add(0, kind, "panic", &words, &both);
        }
        CallEnd::Returned(values) if values[..] != [Value::Truth(false)] => {
            let words = format!("returned true, but the call is illegal: {because}");
            steps.add(0, wrong, &format!("accepted {reason:?}"), &words, &both);
        }
        CallEnd::Returned(_) if steps.before != steps.after => {
            let words =
                format!("was refused ({because}), but it has changed the structure: check before you change anything");
            steps.add(0, wrong, &format!("not atomic {reason:?}"), &words, &both);
        }
        CallEnd::Returned(_) => {}
    }
}

fn legal(steps: &mut Steps, h1: HalfEdgeId, h2: HalfEdgeId) {
    let (before, after) = (steps.before, steps.after);
    if let CallEnd::Returned(values) = steps.end {
        if values[..] != [Value::Truth(true)] {
            let words = format!("returned false, but the call is legal: {}", Legal::Yes.because());
            steps.add(0, FaultKind::Wrong, "refused", &words, &[h1.into(), h2.into()]);
            return;
        }
    } else if before == after {
        // Nothing was done: of a legal call, that is not even step 0.
        let kind = steps.kind(0, false);
        if kind != FaultKind::Unattempted {
            let words = format!("{}, and nothing is done", steps.end.words());
            steps.add(0, kind, "panic", &words, &[h1.into(), h2.into()]);
        }
    }
    let Some((expected, new)) = spec::split_face(before, h1, h2) else { return };
    let faces = steps.count(1, "faces", [before.faces.len(), after.faces.len()], 1);
    let vertices = steps.count(1, "vertices", [before.vertices.len(), after.vertices.len()], 0);
    if !(faces && vertices) {
        return steps.unjudged(2..6);
    }
    if !steps.count(2, "half-edges", [before.half_edges.len(), after.half_edges.len()], 2) {
        return steps.unjudged(3..6);
    }
    let aligned = align(&expected, &new, after);
    let (there, back) = (aligned.new.half_edges[0], aligned.new.half_edges[1]);
    let new_face = new.faces[0];
    steps.differences(&aligned, step_of, |element| match element {
        Element::HalfEdge(h) if h == there => "the new half-edge from he1's origin to he2's",
        Element::HalfEdge(h) if h == back => "the new half-edge from he2's origin to he1's",
        Element::HalfEdge(h) if h == h1 => "he1",
        Element::HalfEdge(h) if h == h2 => "he2",
        Element::HalfEdge(h) if before.next(h) == Some(h1) => "the one before he1",
        Element::HalfEdge(h) if before.next(h) == Some(h2) => "the one before he2",
        Element::HalfEdge(h) if aligned.expected.face(h) == Some(new_face) => "on the loop of the new face",
        Element::HalfEdge(h) if before.face(h) == before.face(h1) => "on the loop of the old face",
        Element::Face(f) if f == new_face => "the new face",
        Element::Face(f) if before.face(h1) == Some(f) => "the old face",
        Element::Vertex(v) if before.origin(h1) == Some(v) => "the origin of he1",
        Element::Vertex(v) if before.origin(h2) == Some(v) => "the origin of he2",
        _ => ELSEWHERE,
    });
    steps.must_have_returned();
}

fn step_of(difference: &Difference) -> usize {
    match difference.field {
        Field::Origin | Field::Twin | Field::Position => 2,
        Field::Next | Field::Prev => 3,
        Field::Face => 4,
        Field::Boundary | Field::Outgoing | Field::OuterFace => 5,
    }
}
