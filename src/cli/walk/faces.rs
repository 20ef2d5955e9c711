//! Walks round faces.

use super::names::{FaceName, at, name, or_none};
use super::{Answer, Failure, Output, Subject};
use crate::answer::{fields, tell};
use crate::output::table;
use dcel_kit::io::counted;
use dcel_kit::topology::{InnerComponent, bounded_cycle};
use dcel_kit::{FaceId, HalfEdgeId};
use std::collections::BTreeSet;
use std::io::Write;

/// Tells of some faces, mostly one, cycle by cycle, and what is adjacent to them: O(half-edges of the faces), times a
/// logarithm for the sorting of the neighbours.
pub(super) fn run(subject: &Subject, faces: &[FaceId], json: bool, out: &mut Output) -> Result<Answer, Failure> {
    let view = subject.view();
    let mut adjacent = BTreeSet::new();
    let mut step = |h: HalfEdgeId| {
        let (twin, origin) = (view.twin(h), view.origin(h));
        let across = twin.and_then(|t| view.face(t));
        adjacent.extend(across.filter(|&f| view.has_face(f)));
        fields! {
            half_edge: h.to_string(),
            origin: name(origin),
            position: origin.and_then(|v| subject.position(v)),
            destination: name(twin.and_then(|t| view.origin(t))),
            twin: name(twin),
            // The face of the twin.
            across: name(across),
            across_name: across.and_then(|f| subject.name(f)).map(str::to_owned),
        }
    };
    let mut cycle = |start, inner| {
        let mut last = None;
        let half_edges: Vec<_> = bounded_cycle(view, start).inspect(|&h| last = Some(h)).map(&mut step).collect();
        let closed = last.and_then(|h| view.next(h)) == Some(start);
        // It is inner as a further cycle of its face, or any cycle of the outer face.
        fields! { inner, closed, half_edges }
    };
    let mut face = |&f: &FaceId| {
        let outer = view.outer_face() == Some(f);
        let mut cycles: Vec<_> = view.half_edge(f).map(|h| cycle(h, outer)).into_iter().collect();
        let mut isolated_vertices = Vec::new();
        for component in view.inner_components(f) {
            match *component {
                InnerComponent::Cycle(h) => cycles.push(cycle(h, true)),
                InnerComponent::Isolated(v) => {
                    isolated_vertices.push(fields! { vertex: v.to_string(), position: subject.position(v) });
                }
            }
        }
        let FaceName { face, name } = FaceName::of(subject, f);
        fields! { face, name, outer, hole: view.is_hole(f), cycles, isolated_vertices }
    };
    let walked: Vec<_> = faces.iter().map(&mut face).collect();
    let own: BTreeSet<FaceId> = faces.iter().copied().collect();
    let own_names: BTreeSet<Option<&str>> = own.iter().map(|&f| subject.name(f)).collect();
    let foreign = || adjacent.difference(&own).copied();
    let names: BTreeSet<Option<&str>> = foreign().map(|f| subject.name(f)).collect();
    let answer = fields! {
        faces: walked,
        // Across the edges of the given ones, without these.
        adjacent_faces: foreign().map(|f| FaceName::of(subject, f)).collect::<Vec<_>>(),
        // Without the names of the given ones.
        adjacent_names: names.difference(&own_names).copied().flatten().collect::<Vec<_>>(),
    };
    tell(&answer, json, out, |out| {
        for face in &answer.faces {
            let kind = match (face.outer, face.hole) {
                (true, _) => ", the outer face",
                (_, true) => ", a hole",
                _ => "",
            };
            let sides: usize = face.cycles.iter().map(|cycle| cycle.half_edges.len()).sum();
            let cycles = counted(face.cycles.len(), "cycle", "cycles");
            let called = FaceName::called(&face.face, &face.name);
            writeln!(out, "{called}{kind}: {}, {cycles}", counted(sides, "half-edge", "half-edges"))?;
        }
        let adjacent: Vec<String> = answer.adjacent_faces.iter().map(ToString::to_string).collect();
        let listed = if adjacent.is_empty() { "none".to_owned() } else { adjacent.join(", ") };
        writeln!(out, "adjacent faces ({}): {listed}", adjacent.len())?;
        if !answer.adjacent_names.is_empty() {
            writeln!(out, "adjacent names ({}): {}", answer.adjacent_names.len(), answer.adjacent_names.join(", "))?;
        }
        for face in &answer.faces {
            for cycle in &face.cycles {
                writeln!(out, "\n{} {}", if cycle.inner { "inner component of" } else { "boundary of" }, face.face)?;
                let rows = cycle.half_edges.iter().map(|step| {
                    let across = format!("across {}", FaceName::or_none(&step.across, &step.across_name));
                    let from = format!("{} {}", or_none(&step.origin), at(&step.position));
                    let (to, twin) = (or_none(&step.destination), or_none(&step.twin));
                    [step.half_edge.clone(), from, format!("-> {to}"), format!("twin {twin}"), across]
                });
                table(out, &rows.collect::<Vec<_>>())?;
                if !cycle.closed {
                    writeln!(out, "  the cycle does not close here")?;
                }
            }
            if !face.isolated_vertices.is_empty() {
                writeln!(out, "\nisolated in {}", face.face)?;
            }
            for corner in &face.isolated_vertices {
                writeln!(out, "  {} {}", corner.vertex, at(&corner.position))?;
            }
        }
        Ok(())
    })
}
