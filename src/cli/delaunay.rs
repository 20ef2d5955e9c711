//! `dcel delaunay`: of points, of a graph whose edges stay, or of a triangulation by flips.

use super::results::Results;
use super::subject::Kind;
use super::{Answer, Failure, InputOptions, Output, fields, say};
use dcel_kit::figure::{self, Figure, FigureOptions};
use dcel_kit::io::{Model, counted, source_name};
use dcel_kit::plane::Subdivision;
use dcel_kit::{EdgeId, EdgeMap};
use std::io::Write;
use std::path::PathBuf;

/// Circles are drawn round so many triangles at most.
const MOST_CIRCLES: usize = 60;

/// Make the Delaunay triangulation of points
///
/// Reads points as lines `x y`, or the points of any other format: of maps the points, and the corners
/// of lines and polygons. No point lies inside the circle
/// round a triangle; that is decided exactly. Points at one place become one vertex. Points on one
/// line become a path.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel delaunay sites.xy --figure sites.svg --circles
  dcel delaunay sites.csv -o triangles.dcel
  dcel delaunay plan.poly --constrained --json
  dcel delaunay square.obj --flips -o better.obj")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// Keep the edges of the file: triangles outside its bounded faces are hole faces
    ///
    /// O(n log n) for most shapes; where very many long edges stand side by side with points between
    /// them, time grows with their square, and more.
    #[arg(long, conflicts_with = "flips")]
    constrained: bool,
    /// Flip the edges of the triangulation in the file, and count the flips
    #[arg(long)]
    flips: bool,
    #[command(flatten)]
    results: Results,
    /// Draw the circles round the triangles, too
    #[arg(long, requires = "figure")]
    circles: bool,
    #[command(flatten)]
    input: InputOptions,
}

/// What was made.
#[derive(Default)]
struct Made {
    subdivision: Subdivision,
    points: usize,
    repeated: Vec<(u32, u32)>,
    constrained: EdgeMap<bool>,
    flips: Option<usize>,
}

impl Made {
    fn stays(&self, e: EdgeId) -> bool {
        self.constrained.get(e).copied().unwrap_or_default()
    }
}

/// What a triangulation takes at its making for each point: measured on 10^5 of them.
const BYTES_PER_POINT: usize = 320;

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.results.check(&args.file)?;
    let made = if args.constrained || args.flips { of_graph(args)? } else { of_points(args)? };
    let s = &made.subdivision;
    args.results.draw(&args.file, "Delaunay", out, |options| draw(&made, args.circles, &options))?;
    let answer = fields! {
        source: source_name(&args.file),
        // In the file; of a graph its vertices.
        points: made.points,
        // Points by number, from 0.
        repeated: made.repeated.iter().map(|(point, repeats)| fields! { point, repeats }).collect::<Vec<_>>(),
        vertices: s.vertex_count(),
        edges: s.edge_count(),
        triangles: s.face_count() - 1,
        // Half-edges of the outer face.
        outline: s.cycles(s.outer_face()).map(|h| s.cycle(h).count()).sum(),
        hole_faces: s.hole_faces().count(),
        constrained: made.constrained.as_slice().iter().filter(|&&stays| stays).count(),
        // Edges that are not locally Delaunay because they have to stay.
        not_delaunay: s.non_delaunay_edges(|_| false).count(),
        #[serde(flatten)]
        flips: made.flips.map(|flips| fields! { flips }),
    };
    say_notes(&made);
    args.results.finish(&Model::planar(s), &answer, out, |out| {
        writeln!(out, "{}: {}", answer.source, counted(answer.points, "point", "points"))?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        line("vertices", answer.vertices.to_string())?;
        line("edges", answer.edges.to_string())?;
        line("triangles", answer.triangles.to_string())?;
        line("outline", format!("{} of f0", counted(answer.outline, "half-edge", "half-edges")))?;
        if let Some(flips) = made.flips {
            line("flips", flips.to_string())?;
        }
        if answer.constrained > 0 {
            let constrained = counted(answer.constrained, "edge", "edges");
            line("constrained", format!("{constrained}, {} of them not Delaunay", answer.not_delaunay))?;
        }
        if answer.hole_faces > 0 {
            line("hole faces", answer.hole_faces.to_string())?;
        }
        Ok(())
    })
}

fn of_points(args: &Args) -> Result<Made, Failure> {
    let list = args.input.points(&args.file)?;
    list.check_room(BYTES_PER_POINT)?;
    let built = Subdivision::delaunay(&list.points).map_err(|error| Failure::about(&list.source, error))?;
    Ok(Made { subdivision: built.subdivision, points: list.points.len(), repeated: built.repeated, ..Made::default() })
}

/// The structure in the file, its edges kept or flipped.
fn of_graph(args: &Args) -> Result<Made, Failure> {
    let subject = args.input.open_as(&args.file, false)?;
    let source = subject.source;
    let Kind::Plane(mut subdivision) = subject.kind else {
        let what = format!("{source}: a surface in space has no Delaunay triangulation here");
        return Err(Failure::input(what, "--plane drops z: good for a terrain seen from above"));
    };
    let points = subdivision.vertex_count();
    if args.flips {
        let flips = Some(subdivision.make_delaunay(|_| false));
        return Ok(Made { subdivision, points, flips, ..Made::default() });
    }
    let made = subdivision.constrained_delaunay().map_err(|error| Failure::about(source, error))?;
    Ok(Made { subdivision: made.subdivision, points, constrained: made.constrained, ..Made::default() })
}

fn draw(made: &Made, circles: bool, options: &FigureOptions) -> Result<Figure, Failure> {
    let s = &made.subdivision;
    let too_many = s.face_count() > MOST_CIRCLES + 1;
    if circles && too_many {
        say("note", format_args!("{} circles would hide the picture: none is drawn", s.face_count() - 1));
    }
    let drawn = figure::delaunay(s, circles && !too_many, |e| made.stays(e), options);
    drawn.map_err(|error| Failure::input(error, ""))
}

fn say_notes(made: &Made) {
    let (repeated, s) = (&made.repeated, &made.subdivision);
    tell_repeated(repeated);
    if s.face_count() == 1 && s.vertex_count() > 2 {
        say("note", "all points lie on one line: this is a path");
    }
}

/// Says which points stand where earlier ones do.
pub(super) fn tell_repeated(repeated: &[(u32, u32)]) {
    if !repeated.is_empty() {
        let first: Vec<String> =
            repeated.iter().take(5).map(|(point, earlier)| format!("{point} = {earlier}")).collect();
        let (count, rest) = (repeated.len(), if repeated.len() > 5 { ", ..." } else { "" });
        say("note", format_args!("points that repeat earlier ones, {count}: {}{rest}", first.join(", ")));
    }
}
