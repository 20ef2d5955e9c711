//! `dcel solid`: solids made, measured, turned into their duals, and drawn.
//!
//! ```text
//!   common.rs     What the commands on solids share
//!   dual.rs       `dcel solid dual`
//!   figure.rs     `dcel solid figure`
//!   info.rs       `dcel solid info`
//!   make.rs       `dcel solid make`
//!   schlegel.rs   `dcel solid schlegel`
//!   split.rs      `dcel solid split`
//!   subdivide.rs  `dcel solid subdivide`
//!   support.rs    `dcel solid support`
//! ```

mod common;
mod dual;
mod figure;
mod info;
mod make;
mod schlegel;
mod split;
mod subdivide;
mod support;

pub(crate) use common::{check_finer, direction, open as open_solid, points_in_space, vector};

use super::choice::commands;
use super::{Answer, Failure, Output};

/// Make solids, measure them, draw them
///
/// Solids are read from obj, off, ply and stl, and written to these. Faces run counter-clockwise as
/// seen from outside.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid make dodecahedron -o d.off
  dcel solid info cube.off
  dcel solid figure cube.off -o cube.svg")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

commands! {
    Make make,
    Info info,
    Dual dual,
    Subdivide subdivide,
    Split split,
    Support support,
    Figure figure,
    Schlegel schlegel,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.command.run(out)
}
