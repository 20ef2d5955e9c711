//! `dcel film`: an algorithm at work, event by event.

use super::choice::{Choice, one_of};
use super::input::InputOptions;
use super::picture::{Pixels, Target, is_page};
use super::save::{Files, put};
use super::subject::Kind;
use super::{Answer, Failure, Output};
use dcel_kit::figure::{FigureOptions, SketchFilm, algorithms};
use dcel_kit::io::read_points;
use dcel_kit::plane::Subdivision;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Draw an algorithm at work, event by event
#[derive(clap::Args, Debug)]
#[command(after_help = "\
A film is a strip of frames (.svg, .png), two in a row, or a page that plays them (.html): next and back, the arrow keys,
Home and End, space to play, and a link to each frame. --frames DIR writes each frame as a file of its own.

Edits have films, too: dcel script FILE --film OUT.

Examples:
  dcel film ears square.dcel -o ears.svg
  dcel film flips square.obj -o flips.html
  dcel film hull sites.xy -o hull.svg --most 12
  dcel film hull sites.xy --frames hull")]
pub(crate) struct Args {
    /// The algorithm
    #[arg(value_name = "WHAT", value_parser = one_of(ALGORITHMS))]
    what: Algorithm,
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// The film: a strip (.svg, .png), or a page that plays it (.html)
    #[arg(short, long, value_name = "OUT", required_unless_present = "frames")]
    output: Option<PathBuf>,
    /// A new folder with each frame as a file
    #[arg(long, value_name = "DIR")]
    frames: Option<PathBuf>,
    /// The greatest number of events that are shown; of more, some are left out evenly
    #[arg(long, value_name = "NUMBER", default_value_t = 40)]
    most: usize,
    /// One frame at a time in the .svg too, with links and without a script
    #[arg(long, requires = "output")]
    stepper: bool,
    #[command(flatten)]
    pixels: Pixels,
    #[command(flatten)]
    input: InputOptions,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Algorithm {
    Ears,
    Flips,
    Hull,
}

static ALGORITHMS: &[Choice<Algorithm>] = &[
    ("ears", "Ear clipping of all faces, corner by corner", Algorithm::Ears),
    ("flips", "Lawson's flips of a triangulation, until it is Delaunay", Algorithm::Flips),
    ("hull", "The convex hull of points, from left to right and back", Algorithm::Hull),
];

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    Files::reading([&args.file]).writes("-o", args.output.as_deref()).check()?;
    let film = film(args)?;
    let title = args
        .file
        .file_stem()
        .filter(|stem| *stem != "-")
        .map_or_else(|| "film".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let options = FigureOptions::new(title);
    if let Some(dir) = &args.frames {
        frames(&film, dir, &options, out)?;
    }
    if let Some(path) = &args.output {
        if is_page(path) {
            put(path, film.page(&options).map_err(cannot)?)?;
        } else {
            let target = Target::new(Some(path), args.pixels)?;
            let figure = if args.stepper { film.stepper(&options) } else { film.strip(&options) };
            target.write(&figure.map_err(cannot)?, out)?;
        }
        if path.as_os_str() != "-" {
            writeln!(out, "{}: {} frames", path.display(), film.len())?;
        }
    }
    Ok(Answer::Yes)
}

fn film(args: &Args) -> Result<SketchFilm, Failure> {
    if args.what == Algorithm::Hull {
        let list = read_points(&args.file, &args.input.for_points()?)?;
        return algorithms::convex_hull(&list.points, args.most).map_err(|error| Failure::about(&list.source, error));
    }
    let subject = args.input.open_as(&args.file, false)?;
    let source = subject.source;
    let Kind::Plane(given) = subject.kind else {
        let what = format!("{source}: this film is of the plane, and the file is a surface in space");
        return Err(Failure::input(what, "--plane drops z: good for a terrain seen from above"));
    };
    match args.what {
        Algorithm::Flips => Ok(flips(&given, args.most)),
        _ => algorithms::ear_clipping(&given, args.most).map_err(|error| Failure::about(&source, error)),
    }
}

fn flips(given: &Subdivision, most: usize) -> SketchFilm {
    algorithms::lawson_flips(given, |_| false, most)
}

/// Each frame as a file of a new folder: `01.svg`, `02.svg` and so on.
fn frames(film: &SketchFilm, dir: &Path, options: &FigureOptions, out: &mut Output) -> Result<(), Failure> {
    let singles = film.singles(options).map_err(cannot)?;
    let width = singles.len().to_string().len().max(2);
    let file = |(i, figure): (usize, &dcel_kit::figure::Figure)| (format!("{:0width$}.svg", i + 1), figure.to_svg());
    let files: Vec<(String, String)> = singles.iter().enumerate().map(file).collect();
    super::save::put_folder(dir, files.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))?;
    Ok(writeln!(out, "{}: {} frames", dir.display(), files.len())?)
}

fn cannot(error: dcel_kit::figure::sketch::SketchError) -> Failure {
    Failure::input(error, "")
}
