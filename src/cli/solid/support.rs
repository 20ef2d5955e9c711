//! `dcel solid support`: the vertex furthest in a direction, and the way there.

use super::common::{direction, open, vector};
use crate::output::point;
use crate::{Answer, Failure, InputOptions, Output, fields, tell};
use dcel_kit::ids::VertexId;
use std::io::Write;
use std::path::PathBuf;

/// Find the vertex of a convex solid that lies furthest in a direction
///
/// Climbs from neighbour to neighbour and tells the way. Of equally far vertices the one with the
/// greatest x, then y, then z is meant, so that flat places do not stop the climb. A solid that is
/// not convex is refused by the edge or corner in the way.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid support cube.off 1,2,3
  dcel solid support cube.off 0,0,1 --from v7 --json")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The direction: three numbers with commas between
    #[arg(value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    direction: [f64; 3],
    /// The vertex to start from, for example the last answer
    #[arg(long, value_name = "VERTEX")]
    from: Option<VertexId>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let direction = direction(args.direction)?;
    let solid = open(&args.file, &args.input)?;
    let start = match args.from {
        Some(v) => {
            solid.check(v).map_err(|error| Failure::input(format!("--from: {error}"), ""))?;
            v
        }
        None => solid.vertices().next().unwrap_or(VertexId::new(0)),
    };
    let convex = solid.check_convex().map_err(|error| Failure::refused(args.file.display(), error))?;
    let path = convex.climb(direction, start);
    let last = path.last().copied().unwrap_or(start);
    let names: Vec<String> = path.iter().map(ToString::to_string).collect();
    let (vertex, position) = (last.to_string(), solid.point(last));
    // The path has every vertex on the way, the first and the last included.
    let answer = fields! { vertex, position, path: names, vertices: solid.vertex_count() };
    tell(&answer, args.json, out, |out| {
        writeln!(out, "{last} at {}", point(&position))?;
        writeln!(out, "  {} of {} vertices met: {}", answer.path.len(), answer.vertices, answer.path.join(" "))
    })
}
