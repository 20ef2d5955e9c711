//! `dcel solid split`: a face cut in two.

use super::common::{Target, open};
use crate::output::names;
use crate::{Answer, Failure, InputOptions, Output};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::solid::Polyhedron;
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::path::PathBuf;

/// Cut a face of a surface in two along a diagonal
///
/// The diagonal joins two corners of the face and lies inside it. Faces that are not convex can be cut
/// so into convex ones, which stl can hold. The face keeps its number; the new one gets the next free.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid split cube.off f0 v0 v2 -o split.off
  dcel solid split cube.off f0 v0 v2 --json")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The face
    #[arg(value_name = "FACE")]
    face: FaceId,
    /// One corner
    #[arg(value_name = "FROM")]
    one: VertexId,
    /// The other corner
    #[arg(value_name = "TO")]
    other: VertexId,
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.target.check(Some(&args.file))?;
    let mut solid = open(&args.file, &args.input)?;
    let [from, to] = [corner(args, &solid, args.one)?, corner(args, &solid, args.other)?];
    let before = solid.clone();
    let (diagonal, _) = solid.split_face(from, to).map_err(|error| Failure::refused(args.file.display(), error))?;
    if !lies_inside(&before, args.face, &solid, diagonal) {
        let what = format!(
            "{}: the line from {} to {} does not lie inside {}",
            args.file.display(),
            args.one,
            args.other,
            args.face
        );
        return Err(Failure::input(what, "choose two corners that see each other inside the face"));
    }
    args.target.put("split", &solid, None, out)
}

/// The half-edge of the face that starts at a vertex.
fn corner(args: &Args, solid: &Polyhedron, v: VertexId) -> Result<HalfEdgeId, Failure> {
    let (file, face) = (args.file.display(), args.face);
    if !solid.polygon_faces().any(|f| f == face) {
        let help = format!("the faces are f0 to f{}", solid.polygon_faces().count().saturating_sub(1));
        return Err(Failure::input(format!("{file}: there is no face {face}"), help));
    }
    let corners: Vec<HalfEdgeId> = solid.incident_half_edges(face).collect();
    corners.iter().copied().find(|&h| solid.origin(h) == v).ok_or_else(|| {
        let all = names(corners.iter().map(|&h| solid.origin(h))).join(" ");
        Failure::input(format!("{file}: {v} is no corner of {face}"), format!("its corners are {all}"))
    })
}

/// Whether the two parts of a face fill it, as it is seen along the axis that its normal is closest to.
fn lies_inside(before: &Polyhedron, face: FaceId, after: &Polyhedron, diagonal: HalfEdgeId) -> bool {
    let normal = before.area_vector(face);
    let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(2);
    let (right, up) = ((axis + 1) % 3, (axis + 2) % 3);
    let corners: Vec<VertexId> = before.incident_half_edges(face).map(|h| before.origin(h)).collect();
    let flat = corners.iter().map(|&v| before.point(v)).map(|p| Point::new(p[right], p[up])).collect();
    let mut parts = PolygonList::new();
    for side in [diagonal, diagonal.twin()] {
        let part = after.incident_half_edges(after.face(side)).map(|h| after.origin(h));
        let mut part: Vec<u32> =
            part.filter_map(|v| corners.iter().position(|&corner| corner == v)).map(|i| i as u32).collect();
        if normal[axis] < 0.0 {
            part.reverse();
        }
        parts.push_face(&part);
    }
    Subdivision::from_polygons(flat, &parts).is_ok()
}
