//! `dcel navmesh random`: points at random.

use super::super::choice::whole;
use super::super::output::names;
use super::super::{Answer, Failure, Output, fields};
use super::reading::{Input, MapArgs};
use dcel_kit::navmesh::QueryPoint;
use serde::Serialize;
use std::io::Write;

/// Give points at random where one can stand, every part of the map as often as its area says
///
/// One point a line, x and y as the file has them. On a floor in space whose heights differ (--up) all
/// three coordinates, and areas are measured along the surface; with --wall or --obstacle in the plan.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh random rooms.map --count 5
  dcel navmesh random rooms.map --seed 7 --json
  dcel navmesh random house.obj --up z --count 3")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// How many
    #[arg(long, value_name = "N", value_parser = whole::<usize>, default_value_t = 10)]
    count: usize,
    /// The same seed gives the same points
    #[arg(long, value_name = "SEED", value_parser = whole::<u64>, default_value_t = 1)]
    seed: u64,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let draft = match args.map.read_as(!args.map.obstacles.are_given())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => {
            let places = ground.surface.random_places(args.seed).map(|place| ground.spot(&place));
            return tell(args, &ground.source, places, |spot| spot.point.to_vec(), out);
        }
    };
    let map = args.map.open_draft(draft, &[])?;
    let place = |place: QueryPoint| fields! { point: map.in_file(place.point), face: place.face.to_string() };
    tell(args, &map.source, map.mesh.random_places(args.seed).map(place), |place| place.point.to_vec(), out)
}

/// Tells the first of these places.
fn tell<S: Serialize>(
    args: &Args,
    source: &str,
    places: impl Iterator<Item = S>,
    point: impl Fn(&S) -> Vec<f64>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let mut places = places.take(args.count).peekable();
    if args.count > 0 && places.peek().is_none() {
        let what = format!("{source}: nothing is walkable, so there is no point to give");
        return Err(Failure::input(what, "dcel navmesh info tells what is blocked: leave out what blocks it"));
    }
    if args.json {
        return out.json(&places.collect::<Vec<_>>());
    }
    for place in places {
        writeln!(out, "{}", names(point(&place)).join(" "))?;
    }
    Ok(Answer::Yes)
}
