//! `dcel navmesh neighbours`: what lies next to a face.

use super::super::output::table;
use super::super::{Answer, Failure, Output, fields, tell};
use super::reading::MapArgs;
use super::tell::point;
use dcel_kit::FaceId;
use std::io::Write;

/// List the sides of a face and what lies behind each: one step each, without a search
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh neighbours rooms.map f2
  dcel navmesh neighbours rooms.map f2 --json")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// The face
    #[arg(value_name = "f3")]
    face: FaceId,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let map = args.map.open()?;
    let mesh = &map.mesh;
    let f = args.face;
    if !mesh.has_face(f) {
        let first_and_last = mesh.faces().next().zip(mesh.faces().next_back());
        let help = first_and_last.map_or_else(String::new, |(a, b)| format!("they are among {a} to {b}"));
        return Err(Failure::input(format!("{}: {f} is no face of the mesh", map.source), help));
    }
    let mut sides = Vec::new();
    let mut rows = Vec::new();
    for side in mesh.sides(f) {
        let [a, b] = [side.from, side.to].map(|v| mesh.point(v));
        let length = ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)).sqrt();
        let kind = match side.across {
            _ if side.open => "face",
            g if g == map.subdivision.outer_face() => "outer",
            g if map.subdivision.is_hole(g) => "hole",
            _ => "blocked",
        };
        let ends = format!("{} -> {}", point(&map, a), point(&map, b));
        rows.push([side.half_edge.to_string(), ends, kind.to_owned(), side.across.to_string()]);
        sides.push(fields! {
            half_edge: side.half_edge.to_string(),
            from: map.in_file(a),
            to: map.in_file(b),
            length,
            // What lies behind it, and whether one may go there.
            across: side.across.to_string(),
            open: side.open,
            kind,
        });
    }
    let answer = fields! {
        face: f.to_string(),
        component: mesh.component(f).map(|c| c.0),
        dead_end: mesh.is_dead_end(f),
        // The face by which a dead end is left.
        portal: mesh.portal(f).map(|portal| portal.to_string()),
        sides,
    };
    tell(&answer, args.json, out, |out| {
        let open = answer.sides.iter().filter(|side| side.open).count();
        write!(out, "{f}: {} sides, {open} of them portals", answer.sides.len())?;
        if let Some(component) = mesh.component(f) {
            write!(out, "; {component}")?;
        }
        match &answer.portal {
            Some(portal) => writeln!(out, "; a dead end, left by {portal}")?,
            None => writeln!(out)?,
        }
        table(out, &rows)
    })
}
