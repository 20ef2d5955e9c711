//! `dcel navmesh`: maps to find ways on.
//!
//! ```text
//!   info ── locate ── neighbours      what the map is, where a point lies, what lies next to a face
//!   path ── scenario                  a path by any path algorithm; a file of questions and answers
//!   raycast ── distances ── random    the first wall on a line; how far everything is; points at random
//! ```
//!
//! Points are given and told as the file has them: of a grid map with y pointing down, of a flat floor in space by the
//! two axes that lie flat. Floors whose heights differ are surfaces (`space/`): their points are told by all three.
//!
//! ```text
//!   areas.rs      Areas of a map and what a unit of length costs in them
//!   drawing.rs    The figure of a command
//!   ends.rs       The start and the goal of a path
//!   film.rs       Films of paths, for `dcel film`
//!   extras.rs     Costs of faces and links between places, as the command line gives them
//!   linked.rs     `dcel navmesh path --link`
//!   numbers.rs    Numbers of the command line, and numbers that messages propose
//!   obstacles.rs  Walls and obstacles of the command line, put into a map before anything is asked of it
//!   reading.rs    From a file to a map with its navmesh
//!   routes.rs     Paths as they are told
//!   tell.rs       Words and JSON forms that several commands have in common
//! ```

mod areas;
mod distances;
mod drawing;
mod ends;
mod extras;
mod film;
mod info;
mod linked;
mod locate;
mod map;
mod neighbours;
mod numbers;
mod obstacles;
mod path;
mod random;
mod raycast;
mod reading;
mod routes;
mod scenario;
mod space;
mod tell;

pub(crate) use film::{PathFilm, path_film};

use super::choice::commands;
use super::{Answer, Failure, Output};

/// Find paths on a map: neighbours, corridors, the exact shortest path
///
/// MAP is a grid map (.map), a navigation mesh (.mesh), a floor (.obj, .off, .ply) or any other file
/// of convex faces. Points are given as the file has them; in a .map y points down.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh info rooms.map
  dcel navmesh path rooms.map 1 1 22 12 \\
    --algorithm all -o ladder.svg
  dcel navmesh scenario rooms.map \\
    rooms.scen")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

commands! {
    Info info,
    Locate locate,
    Neighbours neighbours,
    Path path,
    Distances distances,
    Random random,
    Raycast raycast,
    Scenario scenario,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.command.run(out)
}
