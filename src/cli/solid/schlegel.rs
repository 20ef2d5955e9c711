//! `dcel solid schlegel`: a convex solid seen through a face, as a structure of the plane.

use super::common::open;
use crate::save::{Files, InPlace, save};
use crate::{Answer, Crop, Failure, InputOptions, Output, Page, Target};
use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::ids::FaceId;
use dcel_kit::io::Model;
use std::path::PathBuf;

/// Look at a convex solid through one of its faces
///
/// The answer is a structure of the plane whose outer face, f0, is that face: the Schlegel diagram.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid schlegel cube.off -o cube.dcel
  dcel solid schlegel cube.off --through f3 --figure cube.svg")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The face to look through; the first one without it
    #[arg(long, value_name = "FACE")]
    through: Option<FaceId>,
    /// Write the structure, for example as .dcel; - for dcel text, which is also the answer without a figure
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    in_place: InPlace,
    /// Draw it, as .svg or .png
    #[arg(long, value_name = "OUT.svg")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let target = Target::optional(args.figure.as_deref(), &args.page, args.crop, "--figure")?;
    let files = Files::reading([&args.file])
        .writes_or_replaces("-o", args.output.as_deref(), args.in_place)
        .writes("--figure", target.as_ref().and_then(Target::path));
    args.page.files(files).check()?;
    let solid = open(&args.file, &args.input)?;
    let face = args.through.or_else(|| solid.polygon_faces().next()).unwrap_or(FaceId::new(0));
    let seen = solid.schlegel(face).map_err(|error| Failure::refused(args.file.display(), error))?;
    if let Some(target) = &target {
        let names = seen.faces.iter().map(|(f, of)| (f, format!("{f} = {of}")));
        let options =
            args.crop.apply_here(target.options(FigureOptions::new(format!("Seen through {face}")).face_names(names)));
        let drawn =
            figure::structure(&seen.diagram, &options).map_err(|error| Failure::about(args.file.display(), error))?;
        target.write(&drawn, out)?;
    }
    let model = Model::planar(&seen.diagram);
    if args.output.is_some() || target.is_none() {
        save(args.output.as_deref().unwrap_or("-".as_ref()), &model, out)?;
    }
    Ok(Answer::Yes)
}
