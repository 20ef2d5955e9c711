//! `dcel navmesh locate`: where points lie.

use super::super::output::{names, table};
use super::super::{Answer, Failure, Output, fields, tell};
use super::map::Map;
use super::numbers::number;
use super::reading::{Input, MapArgs};
use super::space;
use super::tell::{Spot, in_map, point};
use dcel_kit::io::counted;
use dcel_kit::navmesh::Location;
use serde::Serialize;
use std::io::Write;

/// Find where points lie: on a vertex, on an edge, in a face, in a hole, outside
///
/// The answer is exact: nothing is moved to what is near. For points off the mesh the nearest place
/// on it is told, too.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh locate rooms.map 1.5 1.5
  dcel navmesh locate rooms.map \\
    1 1 0 0 99 3 --json
  dcel navmesh locate house.obj --up z \\
    --xyz 1 1 2")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// The points: x y, as the file has them, as many as you like
    #[arg(value_name = "X Y", required = true, allow_negative_numbers = true, value_parser = number)]
    coordinates: Vec<f64>,
    /// The points have all three coordinates, as the file has them: of storeys over each other the one at that
    /// height or below it is told, and not all
    #[arg(long, requires = "up")]
    xyz: bool,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if args.xyz && !args.coordinates.len().is_multiple_of(3) {
        let what = format!("{} are no points", counted(args.coordinates.len(), "number", "numbers"));
        return Err(Failure::input(what, "give all three coordinates of each point, or leave --xyz out"));
    }
    if !args.xyz && !args.coordinates.len().is_multiple_of(2) {
        let what = match args.coordinates.len() {
            1 => "1 number is no point".to_owned(),
            count => format!("{count} numbers are no points"),
        };
        return Err(Failure::input(what, "give x and y of each point"));
    }
    let draft = match args.map.read_as(!args.map.obstacles.are_given())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => {
            let points: Vec<&[f64]> = args.coordinates.chunks_exact(if args.xyz { 3 } else { 2 }).collect();
            return space::locate::run(&ground, &points, args.json, out);
        }
    };
    let map = args.map.open_draft(draft, &[])?;
    if args.xyz && map.level.is_none() {
        let what = format!("{}: --xyz is for floors in space that are measured along the surface", map.source);
        return Err(Failure::input(what, "give x and y of each point, and leave --xyz out"));
    }
    let points = args.coordinates.chunks_exact(if args.xyz { 3 } else { 2 }).map(|p| map.flat::<1>(p));
    let points = points.collect::<Result<Vec<_>, Failure>>()?;
    let found = points.into_iter().flatten().flatten().map(|p| locate(&map, p));
    let (found, rows): (Vec<_>, Vec<_>) = found.unzip();
    tell(&found, args.json, out, |out| {
        writeln!(out, "{}:", map.source)?;
        table(out, &rows)
    })
}

/// The answer for one point, and the point with the words for it.
fn locate(map: &Map, coordinates: [f64; 2]) -> (impl Serialize + use<>, [String; 2]) {
    let p = map.point(coordinates);
    let mesh = &map.mesh;
    let location = mesh.locate(p);
    let faces = match location {
        Location::Vertex(v) => mesh.faces_around(v),
        Location::Edge(h) => {
            let both = [h, h.twin()].map(|h| map.subdivision.face(h));
            both.into_iter().filter(|&f| mesh.has_face(f)).collect()
        }
        Location::Face(f) => vec![f],
        Location::Hole(_) | Location::Outer => vec![],
    };
    let walkable = faces.iter().copied().find(|&f| mesh.is_walkable(f));
    let nearest = if walkable.is_none() { mesh.nearest_point(p) } else { None };
    let component = walkable.and_then(|f| mesh.component(f));
    let dead_end = !faces.is_empty() && faces.iter().all(|&f| mesh.is_dead_end(f));
    let mut words = in_map(map, p, location).to_string();
    if !matches!(location, Location::Face(_)) && !faces.is_empty() {
        words += &format!(", of {}", names(&faces).join(" "));
    }
    let blocked = walkable.is_none() && !faces.is_empty();
    if blocked {
        words += ", blocked";
    }
    if let Some(component) = component {
        words += &format!(", {component}");
    }
    if dead_end {
        words += ", a dead end";
    }
    if let Some(nearest) = &nearest {
        words += &format!("; the nearest place is {} in {}", point(map, nearest.place.point), nearest.place.face);
    }
    let spot = Spot::of(map, p, location);
    let row = [super::super::output::point(&spot.point), words];
    let found = fields! {
        #[serde(flatten)]
        spot,
        // The faces that have the point.
        faces: faces.iter().map(ToString::to_string).collect::<Vec<_>>(),
        component: component.map(|c| c.0),
        dead_end,
        // Whether it is on the mesh, and nobody may stand there.
        blocked,
        // Where one can stand instead, if not there.
        nearest: nearest.map(|n| map.in_file(n.place.point)),
        distance: nearest.map(|n| n.distance),
    };
    (found, row)
}
