//! `dcel solid figure`: a solid with its hidden lines.

use super::common::{open, vector};
use crate::choice::number;
use crate::picture::title;
use crate::{Answer, Failure, Files, InputOptions, Output, Page, Target};
use dcel_kit::figure::{self, Camera, FigureOptions, HiddenLines};
use std::path::PathBuf;

/// Draw a solid
///
/// Faces that are seen whole are drawn with their half-edges; hidden edges, and hidden parts of
/// edges, are dashed. z points up.
///
/// Walls that stand behind each other in great numbers, as in a comb, take time with the square of
/// their number, and more; convex solids take time with their number.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel solid figure cube.off -o cube.svg
  dcel solid figure cube.off --towards 1,-1,2 --distance 4 --no-hidden -o near.svg")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The figure to write, .svg or .png; standard output without it
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
    /// From the solid towards the eye: three numbers with commas between
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    towards: Option<[f64; 3]>,
    /// How far away the eye is, in sizes of the solid, at least 1.1; infinitely far without it
    #[arg(long, value_name = "N", value_parser = number)]
    distance: Option<f64>,
    /// Leave hidden lines out
    #[arg(long)]
    no_hidden: bool,
    /// The title; the name of the file without it
    #[arg(long)]
    title: Option<String>,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let target = Target::new(args.output.as_deref(), &args.page)?;
    args.page.files(Files::reading([&args.file]).writes("-o", target.path())).check()?;
    if let Some(distance) = args.distance.filter(|d| !(1.1..=1e6).contains(d)) {
        let what = format!("--distance {distance}: the eye would be in the solid, or out of the world");
        return Err(Failure::input(what, "give a number from 1.1 to 1000000"));
    }
    let usual = Camera::default();
    let towards = args.towards.unwrap_or(usual.towards);
    if towards.iter().all(|&x| x == 0.0) {
        return Err(Failure::input("--towards 0,0,0 is no direction", "for example: --towards 1,-2,1"));
    }
    let solid = open(&args.file, &args.input)?;
    let title = args.title.clone().unwrap_or_else(|| title(&args.file, "Solid"));
    let options = target.options(FigureOptions::new(title));
    let lines = if args.no_hidden { HiddenLines::LeftOut } else { HiddenLines::Dashed };
    let camera = Camera { towards, distance: args.distance };
    let drawn =
        figure::solid(&solid, &camera, lines, &options).map_err(|error| Failure::about(args.file.display(), error))?;
    target.write(&drawn, out)?;
    Ok(Answer::Yes)
}
