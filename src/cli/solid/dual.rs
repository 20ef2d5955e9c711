//! `dcel solid dual`: faces become vertices.

use super::common::{Target, open};
use crate::{Answer, Failure, InputOptions, Output};
use dcel_kit::solid::DualPositions;
use std::path::PathBuf;

/// Make the dual of a closed solid
///
/// A vertex for each face, a face for each vertex. Polar if the solid is convex, the origin lies inside
/// and no two neighbouring faces lie in one plane: then the dual of the dual is the solid itself. Else each
/// vertex is the mean of the corners of its face.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid dual cube.off -o octahedron.off
  dcel solid dual cube.off --json")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.target.check(Some(&args.file))?;
    let solid = open(&args.file, &args.input)?;
    let dual = solid.dual().map_err(|error| Failure::refused(args.file.display(), error))?;
    let note = match dual.positions {
        DualPositions::Polar => "polar: the plane n x = 1 of a face has its vertex at n",
        DualPositions::Means => "each vertex is the mean of the corners of its face",
    };
    args.target.put("dual", &dual.solid, Some(note), out)
}
