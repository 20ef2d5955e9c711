//! `dcel solid subdivide`: finer and rounder.

use super::common::{Target, check_finer, open};
use crate::choice::{number, within};
use crate::{Answer, Failure, InputOptions, Output};
use dcel_kit::EdgeId;
use dcel_kit::solid::{Polyhedron, Selection};
use std::path::PathBuf;

/// Make a surface finer and rounder
///
/// Catmull and Clark: each face becomes a ring of quads. Loop, for triangles: each triangle becomes
/// four. Borders stay borders; --sharper keeps edges sharp whose faces meet at a smaller angle.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid subdivide cube.off -o round.off
  dcel solid subdivide tetrahedron.off --loop --steps 3 -o ball.stl
  dcel solid subdivide cube.off --sharper 100 -o cut.off")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The rule of Loop, for triangles
    #[arg(long = "loop")]
    by_loop: bool,
    /// How often
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = within(1u8..=8))]
    steps: u8,
    /// Keep edges sharp whose angle inside the solid is less than so many degrees
    #[arg(long, value_name = "DEGREES", value_parser = number)]
    sharper: Option<f64>,
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.target.check(Some(&args.file))?;
    let mut solid = open(&args.file, &args.input)?;
    check_finer(&solid, args.steps)?;
    let mut creases = sharp_edges(&solid, args.sharper);
    for _ in 0..args.steps {
        let finer = if args.by_loop { solid.loop_subdivision(&creases) } else { solid.catmull_clark(&creases) };
        let finer = finer.map_err(|error| {
            let help =
                "cut its faces into triangles with dcel solid split, or leave --loop out: Catmull–Clark takes them all";
            Failure::refused(args.file.display(), error).helped_by(help)
        })?;
        (solid, creases) = (finer.polyhedron, finer.creases);
    }
    args.target.put("subdivided", &solid, None, out)
}

fn sharp_edges(solid: &Polyhedron, degrees: Option<f64>) -> Selection<EdgeId> {
    let mut creases = Selection::new();
    let Some(degrees) = degrees else { return creases };
    // Asked of the solid, each edge would look at all corners of both its faces.
    let measures = solid.measures();
    for e in solid.edges() {
        if measures.dihedral_angle(e).is_some_and(|angle| angle.to_degrees() < degrees) {
            creases.add(e, 1);
        }
    }
    creases
}
