//! The half-edges that start at a vertex, and the links of one.

use super::names::{FaceName, at, name, or_none};
use super::{Answer, Failure, Output, Subject};
use crate::answer::{fields, tell};
use crate::output::table;
use dcel_kit::topology::InnerComponent;
use dcel_kit::{HalfEdgeId, VertexId};
use std::io::Write;

/// Tells which half-edges start at a vertex, counter-clockwise: O(degree), for isolated vertices O(inner components).
pub(super) fn star(subject: &Subject, v: VertexId, json: bool, out: &mut Output) -> Result<Answer, Failure> {
    let view = subject.view();
    let start = view.outgoing(v).filter(|&h| view.has_half_edge(h));
    let ccw = |h: HalfEdgeId| view.prev(h).and_then(|p| view.twin(p)).filter(|&g| view.has_half_edge(g));
    let spoke = |h: HalfEdgeId| {
        let (twin, face) = (view.twin(h), view.face(h));
        let destination = twin.and_then(|t| view.origin(t));
        fields! {
            half_edge: h.to_string(),
            destination: name(destination),
            position: destination.and_then(|v| subject.position(v)),
            twin: name(twin),
            // The face on the left, between this half-edge and the next one.
            face: name(face),
            face_name: face.and_then(|f| subject.name(f)).map(str::to_owned),
        }
    };
    let mut outgoing = Vec::new();
    let mut closed = start.is_none();
    let mut here = start;
    while let Some(h) = here.filter(|_| outgoing.len() < view.half_edge_bound()) {
        outgoing.push(spoke(h));
        here = ccw(h);
        if here == start {
            closed = true;
            break;
        }
    }
    let isolated = InnerComponent::Isolated(v);
    let lies_in = subject.faces().find(|&f| start.is_none() && view.inner_components(f).contains(&isolated));
    let answer = fields! {
        vertex: v.to_string(),
        position: subject.position(v),
        degree: outgoing.len(),
        // Whether the walk round the vertex comes back to its start.
        closed,
        // The face that an isolated vertex lies in.
        lies_in: lies_in.map(|f| FaceName::of(subject, f)),
        outgoing,
    };
    tell(&answer, json, out, |out| {
        writeln!(out, "{v} {}: {} outgoing half-edges", at(&answer.position), answer.degree)?;
        if let Some(face) = &answer.lies_in {
            writeln!(out, "isolated in {face}")?;
        }
        let rows = answer.outgoing.iter().map(|spoke| {
            let to = format!("-> {} {}", or_none(&spoke.destination), at(&spoke.position));
            let face = format!("face {}", FaceName::or_none(&spoke.face, &spoke.face_name));
            [spoke.half_edge.clone(), to, format!("twin {}", or_none(&spoke.twin)), face]
        });
        table(out, &rows.collect::<Vec<_>>())?;
        if closed { Ok(()) } else { writeln!(out, "  the walk round {v} does not close here") }
    })
}

/// Tells the links of a half-edge.
pub(super) fn links(subject: &Subject, h: HalfEdgeId, json: bool, out: &mut Output) -> Result<Answer, Failure> {
    let view = subject.view();
    let (origin, twin, face) = (view.origin(h), view.twin(h), view.face(h));
    let destination = twin.and_then(|t| view.origin(t));
    let answer = fields! {
        half_edge: h.to_string(),
        origin: name(origin),
        origin_position: origin.and_then(|v| subject.position(v)),
        destination: name(destination),
        destination_position: destination.and_then(|v| subject.position(v)),
        twin: name(twin),
        next: name(view.next(h)),
        prev: name(view.prev(h)),
        face: name(face),
        face_name: face.and_then(|f| subject.name(f)).map(str::to_owned),
        // The pair; nothing if the table pairs its half-edges in another way than h6 with h7.
        edge: name(Some(h.edge()).filter(|_| twin == Some(h.twin()))),
    };
    tell(&answer, json, out, |out| {
        writeln!(out, "{h}")?;
        for (what, value) in [
            ("origin", format!("{} {}", or_none(&answer.origin), at(&answer.origin_position))),
            ("destination", format!("{} {}", or_none(&answer.destination), at(&answer.destination_position))),
            ("twin", or_none(&answer.twin).to_owned()),
            ("next", or_none(&answer.next).to_owned()),
            ("prev", or_none(&answer.prev).to_owned()),
            ("face", FaceName::or_none(&answer.face, &answer.face_name)),
            ("edge", or_none(&answer.edge).to_owned()),
        ] {
            writeln!(out, "  {what:<12}{}", value.trim_end())?;
        }
        Ok(())
    })
}
