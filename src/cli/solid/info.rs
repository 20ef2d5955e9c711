//! `dcel solid info`: counts, angles, curvature, volume, shape.

use super::common::open;
use crate::answer::{InWords, tell};
use crate::input::InputOptions;
use crate::{Answer, Failure, Output};
use dcel_kit::io::counted;
use dcel_kit::solid::{PartCounts, Polyhedron};
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};
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

/// The answer. The names are those of the JSON form. Angles are in degrees.
#[derive(Serialize)]
struct Info {
    source: String,
    vertices: usize,
    edges: usize,
    faces: usize,
    euler: i64,
    pieces: Vec<Piece>,
    closed: bool,
    convex: bool,
    /// Why not.
    not_convex: Option<String>,
    faces_not_flat: usize,
    greatest_bend: f64,
    dihedral_angles: Option<[f64; 2]>,
    dihedral_angles_at: Option<[String; 2]>,
    deficit_angles: Option<[f64; 2]>,
    deficit_angles_at: Option<[String; 2]>,
    deficit_sum: f64,
    /// Of vertices off the border, for each square of a unit of length.
    gauss_curvature: Option<[f64; 2]>,
    gauss_curvature_at: Option<[String; 2]>,
    /// Of vertices off the border, for each unit of length.
    mean_curvature: Option<[f64; 2]>,
    mean_curvature_at: Option<[String; 2]>,
    area: f64,
    /// Of closed surfaces.
    volume: Option<f64>,
}

#[derive(Serialize)]
struct Piece {
    first_vertex: String,
    vertices: usize,
    edges: usize,
    faces: usize,
    borders: usize,
    euler: i64,
    genus: i64,
    within_edge_bound: bool,
}

impl From<PartCounts> for Piece {
    fn from(part: PartCounts) -> Self {
        Self {
            first_vertex: part.first_vertex.to_string(),
            vertices: part.vertices,
            edges: part.edges,
            faces: part.faces,
            borders: part.borders,
            euler: part.euler(),
            genus: part.genus(),
            within_edge_bound: part.is_within_edge_bound(),
        }
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let solid = open(&args.file, &args.input)?;
    if args.winged {
        write!(out, "{}", solid.winged_edges())?;
        return Ok(Answer::Yes);
    }
    let info = Info::of(dcel_kit::io::source_name(&args.file), &solid);
    tell(&info, args.json, out)
}

/// The least and the greatest of some values, each with the first element that has it.
fn spread<T: Display + Copy>(values: impl Iterator<Item = (T, f64)>) -> Option<([f64; 2], [String; 2])> {
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

impl Info {
    fn of(source: String, solid: &Polyhedron) -> Self {
        let pieces: Vec<Piece> = solid.parts().into_iter().map(Piece::from).collect();
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
        Self {
            source,
            vertices: solid.vertex_count(),
            edges: solid.edge_count(),
            faces: solid.polygon_faces().count(),
            euler: pieces.iter().map(|piece| piece.euler).sum(),
            pieces,
            closed,
            convex: not_convex.is_none(),
            not_convex,
            faces_not_flat: solid.polygon_faces().filter(|&f| !solid.is_flat(f)).count(),
            greatest_bend: bends.fold(0.0, f64::max),
            dihedral_angles: dihedral.as_ref().map(|(range, _)| *range),
            dihedral_angles_at: dihedral.map(|(_, at)| at),
            deficit_angles: deficit.as_ref().map(|(range, _)| *range),
            deficit_angles_at: deficit.map(|(_, at)| at),
            deficit_sum: measures.total_deficit().to_degrees() + 0.0,
            gauss_curvature: gauss.as_ref().map(|(range, _)| *range),
            gauss_curvature_at: gauss.map(|(_, at)| at),
            mean_curvature: mean.as_ref().map(|(range, _)| *range),
            mean_curvature_at: mean.map(|(_, at)| at),
            area: solid.area(),
            volume: closed.then(|| solid.signed_volume() + 0.0),
        }
    }
}

impl InWords for Info {
    fn print(&self, out: &mut Output) -> io::Result<()> {
        let Self { vertices, edges, faces, euler, .. } = self;
        let counts = [
            counted(*vertices, "vertex", "vertices"),
            counted(*edges, "edge", "edges"),
            counted(*faces, "face", "faces"),
        ]
        .join(", ");
        writeln!(out, "{}: {counts}; V - E + F = {euler}", self.source)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<17}{value}");
        for piece in &self.pieces {
            let Piece { first_vertex, vertices: v, edges: e, faces: f, euler, genus, borders, .. } = piece;
            line(
                "piece",
                format!("of {first_vertex}: {v} - {e} + {f} = {euler} = 2 - 2 x {genus} handles - {borders} borders"),
            )?;
        }
        let from_to = |range: &Option<[f64; 2]>, at: &Option<[String; 2]>, unit: &str| {
            let (values, [low_at, high_at]) = (range.as_ref()?.map(|x| fixed(x, 4)), at.as_ref()?);
            Some(match &values {
                [low, high] if low == high => format!("{low}{unit} everywhere"),
                [low, high] => format!("{low}{unit} at {low_at} to {high}{unit} at {high_at}"),
            })
        };
        if let Some(text) = from_to(&self.dihedral_angles, &self.dihedral_angles_at, " degrees") {
            line("dihedral", text)?;
        }
        if let Some(text) = from_to(&self.deficit_angles, &self.deficit_angles_at, " degrees") {
            line("deficit", text)?;
            let (sum, flat) = (fixed(self.deficit_sum, 4), fixed(360.0 * *euler as f64, 4));
            let rest = if sum == flat { String::new() } else { format!(" = {flat}, if all faces were flat") };
            line("deficit sum", format!("{sum} degrees; 360 x (V - E + F){rest}"))?;
        }
        if let Some(text) = from_to(&self.gauss_curvature, &self.gauss_curvature_at, "") {
            line("Gauss curvature", text)?;
        }
        if let Some(text) = from_to(&self.mean_curvature, &self.mean_curvature_at, "") {
            line("mean curvature", text)?;
        }
        line("area", measure(self.area))?;
        if let Some(volume) = self.volume {
            let text = measure(volume);
            let inside_out = if text.starts_with('-') { " (inside out)" } else { "" };
            line("volume", format!("{text}{inside_out}"))?;
        }
        if self.faces_not_flat > 0 {
            line(
                "not flat",
                format!("{}, by at most {:e}", counted(self.faces_not_flat, "face", "faces"), self.greatest_bend),
            )?;
        }
        line("convex", self.not_convex.as_ref().map_or("yes".to_owned(), |why| format!("no: {why}")))
    }
}
