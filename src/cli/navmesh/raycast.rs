//! `dcel navmesh raycast`: the first wall on a straight line.

use super::super::failure::Failure;
use super::super::{Answer, Output};
use super::drawing::{Drawing, save};
use super::map::Map;
use super::numbers::number;
use super::reading::{Input, MapArgs};
use super::space;
use super::tell::{faces, point, refusal};
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::navmesh::{Raycast, RaycastError};
use serde::Serialize;
use std::io::Write;

/// Tell what a straight line runs against first
///
/// Whether and which wall is hit is decided exactly. Running along a wall, or past a corner that the
/// line touches, is allowed, as it is for a path.
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
    map: MapArgs,
    /// Where the line starts, and where it is to end: x y x y, as the file has them; on a floor whose heights
    /// differ x y z x y z, too
    #[arg(value_names = ["X", "Y", "X", "Y"], num_args = 4..=6, required = true, allow_negative_numbers = true, value_parser = number)]
    ends: Vec<f64>,
    /// The face to start from, where holes touch in the start
    #[arg(long, value_name = "f3")]
    start_face: Option<dcel_kit::FaceId>,
    /// The layer of the start, where storeys lie over each other; dcel navmesh info tells the layers
    #[arg(long, value_name = "N")]
    start_layer: Option<usize>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    drawing: Drawing,
}

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Answered {
    source: String,
    start: [f64; 2],
    end: [f64; 2],
    clear: bool,
    hit: Option<Hit>,
    faces: Vec<String>,
}

#[derive(Serialize)]
struct Hit {
    point: [f64; 2],
    distance: f64,
    half_edge: String,
    face: String,
    vertex: Option<String>,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let target = args.drawing.target(args.map.file())?;
    let draft = match args.map.read_as(!args.map.has_obstacles())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => {
            let points = space::points_of(&args.ends, 2, true)?;
            let (layer, face) = (args.start_layer, args.start_face);
            let question = space::raycast::Question {
                wish: space::Wish { what: "start", numbers: points[0], layer, face },
                to: points[1],
                json: args.json,
                target: target.as_ref(),
                title: args.map.title(),
            };
            return space::raycast::run(&ground, &question, out);
        }
    };
    let [x0, y0, x1, y1] = args.ends[..] else {
        return Err(Failure::input("a line has two ends", "give x y of the start and x y of the end"));
    };
    let map = args.map.open_draft(draft, &[])?;
    let [start, end] = [map.point([x0, y0]), map.point([x1, y1])];
    let place = args.start_face.map_or_else(|| map.mesh.place(start), |face| map.mesh.place_in(face, start));
    let cast = place.map_err(RaycastError::Start).and_then(|place| map.mesh.raycast_from(&place, end));
    let cast = cast.map_err(|error| match &error {
        RaycastError::Start(error) => {
            let nearest = map.mesh.nearest_point(start);
            let help = nearest.map(|nearest| format!("the nearest place is {}", point(&map, nearest.place.point)));
            Failure::input(format!("{}: the start {}", map.source, refusal(&map, error)), help.unwrap_or_default())
        }
        error => Failure::input(format!("{}: {error}", map.source), ""),
    })?;
    if let Some(target) = &target {
        let options = target.options(&map, &format!("A ray through {}", args.map.title()));
        save(target, Floor::new(&map.subdivision, &map.mesh).ray([start, end], &cast, &options), out)?;
    }
    if args.json {
        out.json(&answered(&map, [start, end].map(|p| map.in_file(p)), &cast))?;
    } else {
        tell(&map, [start, end], &cast, out)?;
    }
    Ok(Answer::Yes)
}

fn answered(map: &Map, [start, end]: [[f64; 2]; 2], cast: &Raycast) -> Answered {
    let hit = cast.hit.map(|hit| Hit {
        point: map.in_file(hit.point),
        distance: hit.distance,
        half_edge: hit.half_edge.to_string(),
        face: hit.face.to_string(),
        vertex: hit.vertex.map(|v| v.to_string()),
    });
    let faces = cast.faces.iter().map(ToString::to_string).collect();
    Answered { source: map.source.clone(), start, end, clear: hit.is_none(), hit, faces }
}

fn tell(map: &Map, [start, end]: [dcel_kit::plane::Point; 2], cast: &Raycast, out: &mut Output) -> Result<(), Failure> {
    let through = faces(cast.faces.len());
    match cast.hit {
        None => {
            let length = (end.x - start.x).hypot(end.y - start.y);
            writeln!(
                out,
                "clear: {} is in sight of {}, {length} away, through {through}",
                point(map, end),
                point(map, start)
            )?;
        }
        Some(hit) => {
            let vertex = hit.vertex.map(|v| format!(" at its end {v}")).unwrap_or_default();
            let (at, half_edge, face) = (point(map, hit.point), hit.half_edge, hit.face);
            writeln!(out, "hit: {half_edge} of {face}{vertex}, at {at}, {} away, through {through}", hit.distance)?;
        }
    }
    Ok(())
}
