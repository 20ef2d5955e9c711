//! `dcel navmesh random`: points at random.

use super::super::answer::fields;
use super::super::choice::whole;
use super::super::{Answer, Failure, Output};
use super::reading::{Input, MapArgs};
use super::space;
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
    let draft = match args.map.read_as(!args.map.has_obstacles())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => return space::random::run(&ground, (args.seed, args.count), args.json, out),
    };
    let map = args.map.open_draft(draft, &[])?;
    let mut places = map.mesh.random_places(args.seed).take(args.count).peekable();
    if args.count > 0 && places.peek().is_none() {
        return Err(nothing_walkable(&map.source));
    }
    if args.json {
        let found = places.map(|place| fields! { point: map.in_file(place.point), face: place.face.to_string() });
        return out.json(&found.collect::<Vec<_>>());
    }
    for place in places {
        let [x, y] = map.in_file(place.point);
        writeln!(out, "{x} {y}")?;
    }
    Ok(Answer::Yes)
}

/// Why there is no point at random.
pub(super) fn nothing_walkable(source: &str) -> Failure {
    let what = format!("{source}: nothing is walkable, so there is no point to give");
    Failure::input(what, "dcel navmesh info tells what is blocked: leave out what blocks it")
}
