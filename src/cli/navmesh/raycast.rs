//! `dcel navmesh raycast`: the first wall on a straight line.

use super::super::output::names;
use super::super::{Answer, Failure, Output, fields, tell};
use super::drawing::{Drawing, save};
use super::ends::{End, Snap, Wish};
use super::numbers::number;
use super::reading::{Input, MapArgs};
use super::routes::{ON_SIDES, furthest};
use super::space;
use super::tell::{faces, point};
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::navmesh::Raycast;
use std::io::Write;

/// Tell what a straight line runs against first
///
/// Whether and which wall is hit is decided exactly. Running along a wall, or past a corner that the
/// line touches, is allowed, as it is for a path. A start where holes touch, or on a wall, is on several
/// sides: the line that gets furthest counts.
///
/// On a floor in space whose heights differ (--up) the line is straight in the plan and follows the
/// surface from face to face, up and down ramps; its length is that along the surface. It never leaps
/// to another storey. With --wall or --obstacle the plan decides.
#[derive(clap::Args, Debug)]
#[command(override_usage = "dcel navmesh raycast [OPTIONS] <MAP> <X> <Y> <X> <Y>")]
#[command(after_help = "\
Examples:
  dcel navmesh raycast rooms.map 1 1 22 12
  dcel navmesh raycast rooms.map 1 1 9 1 \\
    --wall 5,0,5,1.5 --json -o ray.svg
  dcel navmesh raycast house.obj --up z 1 1 0 3 3 0")]
pub(super) struct Args {
    #[command(flatten)]
    pub(super) map: MapArgs,
    /// Where the line starts, and where it is to end: x y x y, as the file has them; on a floor in space
    /// (--up) x y z x y z, too
    #[arg(value_names = ["X", "Y", "X", "Y"], num_args = 4..=6, required = true, allow_negative_numbers = true, value_parser = number)]
    pub(super) ends: Vec<f64>,
    /// The face to start from, where holes touch in the start
    #[arg(long, value_name = "f3")]
    pub(super) start_face: Option<dcel_kit::FaceId>,
    /// The layer of the start, where storeys lie over each other; dcel navmesh info tells the layers
    #[arg(long, value_name = "N")]
    pub(super) start_layer: Option<usize>,
    #[command(flatten)]
    pub(super) snap: Snap,
    /// Answer in JSON
    #[arg(long)]
    pub(super) json: bool,
    #[command(flatten)]
    drawing: Drawing,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.snap.check()?;
    let target = args.drawing.target(&args.map.file)?;
    let draft = match args.map.read_as(!args.map.obstacles.are_given())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => return space::raycast::run(&ground, args, target.as_ref(), out),
    };
    let map = args.map.open_draft(draft, &[])?;
    let help = "give x y of the start and x y of the end";
    let [from, to] = map.points(&args.ends, "a line has two ends", help)?;
    let wish = Wish { what: "start", coordinates: from, face: args.start_face };
    let End { asked, places, moved } = args.snap.wished(&map, &wish)?;
    let end = map.point(to);
    let mut casts = Vec::new();
    for place in places {
        let cast = map.mesh.raycast_from(&place, end).map_err(|error| Failure::about(&map.source, error))?;
        casts.push((place, cast));
    }
    let reach = |cast: &Raycast| cast.hit.map_or(f64::INFINITY, |hit| hit.distance);
    let best = furthest((&point(&map, asked), ON_SIDES), casts, |place| place.face, reach);
    let (place, cast) = best.ok_or_else(|| Failure::kit("a start has a place"))?;
    let start = place.point;
    if let Some(target) = &target {
        let options = target.options(&map, &format!("A ray through {}", args.map.title()));
        save(target, Floor::new(&map.subdivision, &map.mesh).ray([start, end], &cast, &options), out)?;
    }
    let answer = fields! {
        source: &map.source,
        start: map.in_file(start),
        start_moved: moved,
        end: map.in_file(end),
        clear: cast.hit.is_none(),
        hit: cast.hit.map(|hit| fields! {
            point: map.in_file(hit.point),
            distance: hit.distance,
            half_edge: hit.half_edge.to_string(),
            face: hit.face.to_string(),
            vertex: hit.vertex.map(|v| v.to_string()),
        }),
        faces: names(&cast.faces),
    };
    tell(&answer, args.json, out, |out| {
        let through = faces(cast.faces.len());
        let Some(hit) = cast.hit else {
            let length = (end.x - start.x).hypot(end.y - start.y);
            let [start, end] = [start, end].map(|p| point(&map, p));
            return writeln!(out, "clear: {end} is in sight of {start}, {length} away, through {through}");
        };
        let vertex = hit.vertex.map(|v| format!(" at its end {v}")).unwrap_or_default();
        let (at, half_edge, face) = (point(&map, hit.point), hit.half_edge, hit.face);
        writeln!(out, "hit: {half_edge} of {face}{vertex}, at {at}, {} away, through {through}", hit.distance)
    })
}
