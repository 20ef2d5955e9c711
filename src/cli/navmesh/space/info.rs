//! `dcel navmesh info` on a floor whose heights differ.

use super::super::super::{Answer, Failure, Output, fields};
use super::super::drawing::{Canvas, save};
use super::super::tell::{Told, sizes};
use super::Ground;
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::io::{Number, counted};
use std::io::Write;

pub(in super::super) fn run(
    ground: &Ground,
    json: bool,
    target: Option<&Canvas>,
    title: &str,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let surface = &ground.surface;
    if let Some(target) = target {
        save(target, Storeys::new(surface).map(&ground.options(target, title)), out)?;
    }
    let layer = |layer: usize| {
        let faces: Vec<_> = surface.faces().filter(|&f| surface.layer(f) == Some(layer)).collect();
        let heights = faces.iter().flat_map(|&f| surface.triangles(f)).flatten().map(|p| p[2]);
        let heights = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
        fields! { faces: faces.len(), heights }
    };
    let mut components = vec![0; surface.component_count()];
    surface.faces().filter_map(|f| surface.component(f)).for_each(|c| components[c as usize] += 1);
    components.sort_unstable_by(|a, b| b.cmp(a));
    let steepest = surface.steepest();
    let faces = surface.faces().count();
    let info = fields! {
        source: &ground.source,
        format: ground.format.name(),
        valid: true,
        faces,
        triangles: surface.triangle_count(),
        // Those that are too steep, or face down.
        left_out: surface.face_bound() - 1 - faces,
        layers: (0..surface.layer_count()).map(layer).collect::<Vec<_>>(),
        components,
        // Along the surface.
        area: surface.area(),
        heights: surface.heights(),
        // In degrees, and a face that has it.
        steepest: steepest.map_or(0.0, |(slope, _)| slope),
        steepest_face: steepest.map(|(_, face)| face.to_string()),
        // What nearly meets.
        faults: ground.faults.iter().map(|(place, fault)| Told::at(place.clone(), fault)).collect::<Vec<_>>(),
    };
    if json {
        return out.json(&info);
    }
    writeln!(out, "{}: {}, a surface to walk on", info.source, info.format)?;
    let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
    let left_out = match info.left_out {
        0 => String::new(),
        count => format!("; {} left out: too steep, or facing down", counted(count, "is", "are")),
    };
    line("faces", format!("{faces}, cut into {}{left_out}", counted(info.triangles, "triangle", "triangles")))?;
    let between = |[low, high]: [f64; 2]| format!("{} to {}", Number(low), Number(high));
    line("heights", between(info.heights))?;
    if let Some(face) = &info.steepest_face {
        line("steepest slope", format!("{:.4} degrees, in {face}", info.steepest))?;
    }
    line("layers", info.layers.len().to_string())?;
    for (i, layer) in info.layers.iter().enumerate().filter(|_| info.layers.len() > 1) {
        line(
            &format!("  layer {i}"),
            format!("{}, heights {}", counted(layer.faces, "face", "faces"), between(layer.heights)),
        )?;
    }
    line("components", sizes(&info.components))?;
    line("area", format!("{} along the surface", Number(info.area)))?;
    info.faults.iter().try_for_each(|fault| fault.print(out))?;
    Ok(Answer::Yes)
}
