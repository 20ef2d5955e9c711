//! The walks as text.

use super::Output;
use super::rounds::{Cycle, FaceName, FaceWalk, Links, Star};
use crate::output::{point, table};
use dcel_kit::io::counted;
use std::io::{self, Write};

fn or_none(name: &Option<String>) -> &str {
    name.as_deref().unwrap_or("none")
}

fn at(position: &Option<Vec<f64>>) -> String {
    position.as_deref().map_or_else(String::new, point)
}

/// `f3 "Ohio"`.
fn called(face: &str, name: &Option<String>) -> String {
    match name {
        Some(name) => format!("{face} {name:?}"),
        None => face.to_owned(),
    }
}

fn listed(faces: &[FaceName]) -> String {
    let all: Vec<String> = faces.iter().map(|f| called(&f.face, &f.name)).collect();
    if all.is_empty() { "none".to_owned() } else { all.join(", ") }
}

pub(super) fn faces(out: &mut Output, walk: &FaceWalk) -> io::Result<()> {
    for face in &walk.faces {
        let kind = match (face.outer, face.hole) {
            (true, _) => ", the outer face",
            (_, true) => ", a hole",
            _ => "",
        };
        let sides: usize = face.cycles.iter().map(|cycle| cycle.half_edges.len()).sum();
        let cycles = face.cycles.len();
        let (sides, cycles) = (counted(sides, "half-edge", "half-edges"), counted(cycles, "cycle", "cycles"));
        writeln!(out, "{}{kind}: {sides}, {cycles}", called(&face.face, &face.name))?;
    }
    writeln!(out, "adjacent faces ({}): {}", walk.adjacent_faces.len(), listed(&walk.adjacent_faces))?;
    if !walk.adjacent_names.is_empty() {
        writeln!(out, "adjacent names ({}): {}", walk.adjacent_names.len(), walk.adjacent_names.join(", "))?;
    }
    for face in &walk.faces {
        for cycle in &face.cycles {
            writeln!(out, "\n{} {}", if cycle.inner { "inner component of" } else { "boundary of" }, face.face)?;
            steps(out, cycle)?;
        }
        if !face.isolated_vertices.is_empty() {
            writeln!(out, "\nisolated in {}", face.face)?;
        }
        for corner in &face.isolated_vertices {
            writeln!(out, "  {} {}", corner.vertex, at(&corner.position))?;
        }
    }
    Ok(())
}

fn steps(out: &mut Output, cycle: &Cycle) -> io::Result<()> {
    let rows = cycle.half_edges.iter().map(|step| {
        let across = step.across.as_ref().map_or_else(|| "none".to_owned(), |f| called(f, &step.across_name));
        let from = format!("{} {}", or_none(&step.origin), at(&step.position));
        let to = format!("-> {}", or_none(&step.destination));
        [step.half_edge.clone(), from, to, format!("twin {}", or_none(&step.twin)), format!("across {across}")]
    });
    table(out, &rows.collect::<Vec<_>>())?;
    if cycle.closed { Ok(()) } else { writeln!(out, "  the cycle does not close here") }
}

pub(super) fn star(out: &mut Output, star: &Star) -> io::Result<()> {
    writeln!(out, "{} {}: {} outgoing half-edges", star.vertex, at(&star.position), star.degree)?;
    if let Some(face) = &star.lies_in {
        writeln!(out, "isolated in {}", called(&face.face, &face.name))?;
    }
    let rows = star.outgoing.iter().map(|spoke| {
        let to = format!("-> {} {}", or_none(&spoke.destination), at(&spoke.position));
        let face = spoke.face.as_ref().map_or_else(|| "none".to_owned(), |f| called(f, &spoke.face_name));
        [spoke.half_edge.clone(), to, format!("twin {}", or_none(&spoke.twin)), format!("face {face}")]
    });
    table(out, &rows.collect::<Vec<_>>())?;
    if star.closed { Ok(()) } else { writeln!(out, "  the walk round {} does not close here", star.vertex) }
}

pub(super) fn links(out: &mut Output, links: &Links) -> io::Result<()> {
    let face = links.face.as_ref().map_or_else(|| "none".to_owned(), |f| called(f, &links.face_name));
    writeln!(out, "{}", links.half_edge)?;
    for (what, value) in [
        ("origin", format!("{} {}", or_none(&links.origin), at(&links.origin_position))),
        ("destination", format!("{} {}", or_none(&links.destination), at(&links.destination_position))),
        ("twin", or_none(&links.twin).to_owned()),
        ("next", or_none(&links.next).to_owned()),
        ("prev", or_none(&links.prev).to_owned()),
        ("face", face),
        ("edge", or_none(&links.edge).to_owned()),
    ] {
        writeln!(out, "  {what:<12}{}", value.trim_end())?;
    }
    Ok(())
}
