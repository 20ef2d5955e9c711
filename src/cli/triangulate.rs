//! `dcel triangulate`: faces into triangles, or into monotone pieces.

use super::choice::{Choice, one_of};
use super::results::Results;
use super::subject::Kind;
use super::{Answer, Failure, InputOptions, Output, fields};
use dcel_kit::FaceId;
use dcel_kit::figure;
use dcel_kit::io::counted;
use dcel_kit::plane::{Subdivision, Triangulated, TriangulationMethod};
use std::io::Write;
use std::path::PathBuf;

/// Cut the faces of a subdivision into triangles
///
/// Diagonals join vertices that are there; none is added. Every bounded face is cut, with its inner components
/// and isolated vertices, into triangles of positive area; hole faces stay whole. A face with n
/// half-edges and r inner components gives n + 2r - 2 triangles.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel triangulate plan.poly -o plan.dcel
  dcel triangulate garden.geojson --method ears --figure garden.svg
  dcel triangulate square.dcel --face f1 --json
  dcel triangulate plan.poly --pieces --figure pieces.svg")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// How the triangles are found
    #[arg(long, value_name = "METHOD", default_value = "monotone", value_parser = one_of(METHODS))]
    method: TriangulationMethod,
    /// Cut into monotone pieces only: the first half of that method
    #[arg(long, conflicts_with = "method")]
    pieces: bool,
    /// Cut hole faces, too; their triangles are hole faces
    #[arg(long)]
    holes: bool,
    /// Cut this face only
    #[arg(long, value_name = "FACE", conflicts_with = "holes")]
    face: Option<FaceId>,
    #[command(flatten)]
    results: Results,
    #[command(flatten)]
    input: InputOptions,
}

/// How the triangles are found.
static METHODS: &[Choice<TriangulationMethod>] = &[
    ("ears", "Cut off one ear after another, O(n²) at worst", TriangulationMethod::Ears),
    ("monotone", "Cut into monotone pieces first, O(n log n)", TriangulationMethod::Monotone),
    (
        "delaunay",
        "Constrained Delaunay: no needless slivers, O(n log n) for most shapes, O(n² log n) for long walls side by side",
        TriangulationMethod::Delaunay,
    ),
];

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.results.check(&args.file)?;
    let mut subject = args.input.open_as(&args.file, false)?;
    let source = subject.source.clone();
    let Kind::Plane(subdivision) = &mut subject.kind else {
        let what = format!("{source}: a surface in space is not cut into triangles here");
        return Err(Failure::input(
            what,
            "--plane drops z: good for a terrain seen from above; dcel solid split cuts one face in two",
        ));
    };
    let before = subdivision.clone();
    let refused = |error| Failure::helped(format_args!("{source}: "), error);
    let (chosen, added) = cut(args, subdivision).map_err(refused)?;
    let after = subdivision.clone();
    for &(new, old) in &added.new_faces {
        if let Some(name) = subject.name(old).map(str::to_owned) {
            subject.names.set(new, Some(name), None);
        }
    }
    args.results.draw(&args.file, "Triangles", out, |options| {
        figure::triangulation(&before, &after, &added.diagonals, &options)
            .map_err(|error| Failure::about(&source, error))
    })?;
    let answer = fields! {
        source,
        format: subject.format.name(),
        method: match METHODS.iter().find(|(.., method)| !args.pieces && *method == args.method) {
            Some((word, ..)) => word,
            None => "monotone pieces",
        },
        faces_cut: chosen,
        pieces: chosen + added.new_faces.len(),
        diagonals: added.diagonals.len(),
        vertices: after.vertex_count(),
        edges: after.edge_count(),
        faces: after.face_count(),
        hole_faces: after.hole_faces().count(),
    };
    args.results.tell_left_out(&subject.left_out);
    args.results.finish(&subject.model(), &answer, out, |out| {
        writeln!(out, "{}: plane, {}, by {}", answer.source, answer.format, answer.method)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        let [one, many] = if args.pieces { ["monotone piece", "monotone pieces"] } else { ["triangle", "triangles"] };
        let faces = if chosen == 1 { "face" } else { "faces" };
        line("cut", format!("{chosen} {faces} into {}", counted(answer.pieces, one, many)))?;
        line("diagonals", answer.diagonals.to_string())?;
        line("vertices", answer.vertices.to_string())?;
        line("edges", answer.edges.to_string())?;
        line("faces", format!("{} (with the outer face)", answer.faces))?;
        if answer.hole_faces > 0 {
            line("hole faces", answer.hole_faces.to_string())?;
        }
        Ok(())
    })
}

/// Cuts what is asked for; returns the number of faces it was, too.
fn cut(args: &Args, s: &mut Subdivision) -> Result<(usize, Triangulated), dcel_kit::plane::TriangulateError> {
    let method = args.method;
    let bounded = s.faces().filter(|&f| f != s.outer_face() && (args.holes || !s.is_hole(f)));
    let faces: Vec<FaceId> = args.face.map_or_else(|| bounded.collect(), |f| vec![f]);
    if args.pieces {
        let mut all = Triangulated::default();
        for &f in &faces {
            let added = s.split_into_monotone(f)?;
            all.diagonals.extend(added.diagonals);
            all.new_faces.extend(added.new_faces);
        }
        return Ok((faces.len(), all));
    }
    let added = match args.face {
        Some(f) => s.triangulate_face(f, method)?,
        None if args.holes => s.triangulate_all(method)?,
        None => s.triangulate(method)?,
    };
    Ok((faces.len(), added))
}
