//! `dcel solid info`: counts, angles, curvature, volume, shape.

use super::common::open;
use crate::cli::input::InputOptions;
use crate::cli::{Answer, Failure, Output};
use dcel_kit::solid::{PartCounts, Polyhedron};
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;

/// Measure a solid
///
/// Told are the counts and handles of each piece, angles between faces, deficit angles (their sum is
/// 2 pi for each unit of V - E + F, if faces are flat), area and volume, and whether the solid is
/// convex: if not, the first edge or corner in the way is named. Whether it is convex is decided
/// exactly; faces that are flat only up to rounding count as bent.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid info cube.off
  dcel solid info bunny.stl --json
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
    deficit_angles: Option<[f64; 2]>,
    deficit_sum: f64,
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
    if args.json {
        out.json(&info)?;
    } else {
        info.print(out)?;
    }
    Ok(Answer::Yes)
}

/// The least and the greatest of some angles, in degrees.
fn spread(angles: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    angles.map(f64::to_degrees).fold(None, |range, angle| {
        let [low, high] = range.unwrap_or([angle; 2]);
        Some([angle.min(low), angle.max(high)])
    })
}

impl Info {
    fn of(source: String, solid: &Polyhedron) -> Self {
        let pieces: Vec<Piece> = solid.parts().into_iter().map(Piece::from).collect();
        let closed = solid.boundary_faces().len() == 0;
        let not_convex = solid.check_convex().err().map(|error| error.to_string());
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
            dihedral_angles: spread(solid.edges().filter_map(|e| solid.dihedral_angle(e))),
            deficit_angles: spread(solid.vertices().map(|v| solid.deficit_angle(v))),
            deficit_sum: solid.total_deficit().to_degrees(),
            area: solid.area(),
            volume: closed.then(|| solid.signed_volume()),
        }
    }

    fn print(&self, out: &mut Output) -> io::Result<()> {
        let Self { vertices, edges, faces, euler, .. } = self;
        writeln!(out, "{}: {vertices} vertices, {edges} edges, {faces} faces; V - E + F = {euler}", self.source)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        for piece in &self.pieces {
            let Piece { first_vertex, vertices: v, edges: e, faces: f, euler, genus, borders, .. } = piece;
            line(
                "piece",
                format!("of {first_vertex}: {v} - {e} + {f} = {euler} = 2 - 2 x {genus} handles - {borders} borders"),
            )?;
        }
        if let Some([low, high]) = self.dihedral_angles {
            line("dihedral", format!("{low:.4} to {high:.4} degrees"))?;
        }
        if let Some([low, high]) = self.deficit_angles {
            line("deficit", format!("{low:.4} to {high:.4} degrees, {:.4} in all", self.deficit_sum))?;
        }
        line("area", format!("{:.6}", self.area))?;
        if let Some(volume) = self.volume {
            let inside_out = if volume < 0.0 { " (inside out)" } else { "" };
            line("volume", format!("{volume:.6}{inside_out}"))?;
        }
        if self.faces_not_flat > 0 {
            line("not flat", format!("{} faces, by at most {:e}", self.faces_not_flat, self.greatest_bend))?;
        }
        line("convex", self.not_convex.as_ref().map_or("yes".to_owned(), |why| format!("no: {why}")))
    }
}
