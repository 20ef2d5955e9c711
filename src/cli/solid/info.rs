//! `dcel solid info`: counts, angles, curvature, volume, shape.

use super::common::open;
use crate::output::counts;
use crate::{Answer, Failure, InputOptions, Output, fields, tell};
use dcel_kit::io::{counted, source_name};
use dcel_kit::solid::PartCounts;
use std::fmt::Display;
use std::io::Write;
use std::path::PathBuf;

/// Measure a solid
///
/// Told are the counts and handles of each piece, the angles between faces, the deficit angles of the
/// vertices (their sum is 360 degrees for each unit of V - E + F, if faces are flat), the curvatures of
/// vertices off the border (Gauss: deficit for each unit of area; mean: half the bend of the edges for
/// each unit of area), each from the least to the greatest with a place where it is so, area and volume,
/// and whether the solid is convex: if not, the first edge or corner in the way is named. Whether it is
/// convex is decided exactly; faces that are flat only up to rounding count as bent. Handles are counted
/// by V - E + F = 2 - 2 handles - borders, piece by piece.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid info cube.off
  dcel solid info cube.off --json
  dcel solid info cube.off --winged")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    /// Print the winged-edge tables of the slides instead
    #[arg(long, conflicts_with = "json")]
    winged: bool,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let solid = open(&args.file, &args.input)?;
    if args.winged {
        write!(out, "{}", solid.winged_edges())?;
        return Ok(Answer::Yes);
    }
    let piece = |part: PartCounts| {
        fields! {
            first_vertex: part.first_vertex.to_string(),
            vertices: part.vertices,
            edges: part.edges,
            faces: part.faces,
            borders: part.borders,
            euler: part.euler(),
            genus: part.genus(),
            within_edge_bound: part.is_within_edge_bound(),
        }
    };
    let pieces: Vec<_> = solid.parts().into_iter().map(piece).collect();
    let closed = solid.boundary_faces().len() == 0;
    let not_convex = solid.check_convex().err().map(|error| error.to_string());
    let measures = solid.measures();
    let degrees = |angle: f64| angle.to_degrees();
    let inner = || solid.vertices().filter(|&v| solid.incident_faces(v).all(|f| !solid.is_boundary_face(f)));
    let dihedral = spread(solid.edges().filter_map(|e| Some((e, measures.dihedral_angle(e).map(degrees)?))));
    let deficit = spread(solid.vertices().map(|v| (v, degrees(measures.deficit_angle(v)))));
    let gauss = spread(inner().filter_map(|v| Some((v, measures.gauss_curvature(v)?))));
    let mean = spread(inner().filter_map(|v| Some((v, measures.mean_curvature(v)?))));
    let bends = solid.polygon_faces().map(|f| solid.bend_of_face(f));
    // Angles are in degrees; curvatures those of vertices off the border, for each unit of length, or for each square of one.
    let answer = fields! {
        source: source_name(&args.file),
        vertices: solid.vertex_count(),
        edges: solid.edge_count(),
        faces: solid.polygon_faces().count(),
        euler: pieces.iter().map(|piece| piece.euler).sum::<i64>(),
        pieces,
        closed,
        convex: not_convex.is_none(),
        not_convex,
        faces_not_flat: solid.polygon_faces().filter(|&f| !solid.is_flat(f)).count(),
        greatest_bend: bends.fold(0.0, f64::max),
        dihedral_angles: dihedral.as_ref().map(|(range, _)| range),
        dihedral_angles_at: dihedral.as_ref().map(|(_, at)| at),
        deficit_angles: deficit.as_ref().map(|(range, _)| range),
        deficit_angles_at: deficit.as_ref().map(|(_, at)| at),
        deficit_sum: measures.total_deficit().to_degrees() + 0.0,
        gauss_curvature: gauss.as_ref().map(|(range, _)| range),
        gauss_curvature_at: gauss.as_ref().map(|(_, at)| at),
        mean_curvature: mean.as_ref().map(|(range, _)| range),
        mean_curvature_at: mean.as_ref().map(|(_, at)| at),
        area: solid.area(),
        volume: closed.then(|| solid.signed_volume() + 0.0),
    };
    tell(&answer, args.json, out, |out| {
        let counts = counts([answer.vertices, answer.edges, answer.faces]);
        writeln!(out, "{}: {counts}; V - E + F = {}", answer.source, answer.euler)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<17}{value}");
        for part in &answer.pieces {
            let (counts, euler) = (format!("{} - {} + {}", part.vertices, part.edges, part.faces), part.euler);
            let (genus, borders) = (part.genus, counted(part.borders, "border", "borders"));
            let handles = format!("2 - 2 x {genus} {} - {borders}", if genus == 1 { "handle" } else { "handles" });
            line("piece", format!("of {}: {counts} = {euler} = {handles}", part.first_vertex))?;
        }
        if let Some(angles) = &dihedral {
            line("dihedral", from_to(angles, " degrees"))?;
        }
        if let Some(angles) = &deficit {
            line("deficit", from_to(angles, " degrees"))?;
            let (sum, flat) = (fixed(answer.deficit_sum, 4), fixed(360.0 * answer.euler as f64, 4));
            let rest = if sum == flat { String::new() } else { format!(" = {flat}, if all faces were flat") };
            line("deficit sum", format!("{sum} degrees; 360 x (V - E + F){rest}"))?;
        }
        for (what, curvature) in [("Gauss curvature", &gauss), ("mean curvature", &mean)] {
            curvature.iter().try_for_each(|curvature| line(what, from_to(curvature, "")))?;
        }
        line("area", measure(answer.area))?;
        if let Some(volume) = answer.volume {
            let text = measure(volume);
            let inside_out = if text.starts_with('-') { " (inside out)" } else { "" };
            line("volume", format!("{text}{inside_out}"))?;
        }
        if answer.faces_not_flat > 0 {
            let faces = counted(answer.faces_not_flat, "face", "faces");
            line("not flat", format!("{faces}, by at most {:e}", answer.greatest_bend))?;
        }
        line("convex", answer.not_convex.as_ref().map_or("yes".to_owned(), |why| format!("no: {why}")))
    })
}

/// The least and the greatest of some values, and the first elements that have them.
type Spread = ([f64; 2], [String; 2]);

/// `60.0000 degrees at e0 to 90.0000 degrees at e5`.
fn from_to((range, [low_at, high_at]): &Spread, unit: &str) -> String {
    let [low, high] = range.map(|x| fixed(x, 4));
    if low == high {
        format!("{low}{unit} everywhere")
    } else {
        format!("{low}{unit} at {low_at} to {high}{unit} at {high_at}")
    }
}

/// The spread of the values of some elements.
fn spread<T: Display + Copy>(values: impl Iterator<Item = (T, f64)>) -> Option<Spread> {
    let mut ends: Option<[(T, f64); 2]> = None;
    for (at, value) in values {
        ends = Some(match ends {
            None => [(at, value); 2],
            Some([low, high]) if value < low.1 => [(at, value), high],
            Some([low, high]) if value > high.1 => [low, (at, value)],
            Some(same) => same,
        });
    }
    // A zero without a sign.
    ends.map(|[(p, low), (q, high)]| ([low + 0.0, high + 0.0], [p.to_string(), q.to_string()]))
}

/// A number with so many digits after the point; what rounds to zero has no sign.
fn fixed(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|c| b"0.".contains(&c)) => zero.to_owned(),
        _ => text,
    }
}

/// An area or a volume: with six digits behind the point, or in all if these would tell next to nothing.
fn measure(value: f64) -> String {
    let is_tiny = value.abs() > 0.0 && value.abs() < 1e-3;
    if is_tiny { format!("{value:.6e}") } else { fixed(value, 6) }
}
