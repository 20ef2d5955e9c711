//! `dcel film`: an algorithm at work, event by event.
//!
//! ```text
//!   algorithm.rs  The algorithms, and which options each of them takes
//!   make.rs       Reads what an algorithm works on, and films it
//! ```

mod algorithm;
mod make;

use super::choice::{pair, whole, within};
use super::picture::{Target, title};
use super::save::{Files, put};
use super::{Answer, Crop, Failure, InputOptions, Output, Page};
use crate::solid::vector;
use algorithm::Algorithm;
use dcel_kit::figure::{Figure, FigureOptions, SketchFilm};
use dcel_kit::{FaceId, VertexId};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Draw an algorithm at work, event by event
#[derive(clap::Args, Debug)]
#[command(after_help = "\
A film is a strip of frames (.svg, .png), two in a row, or a page that plays them (.html): next and back, the arrow keys, \
Home and End, space to play, and a link to each frame. --frames DIR writes each frame as a file of its own.

An algorithm that refuses what it is given ends with an error; the film then has one frame that shows what is refused.

The sweep looks at all segments that its line cuts, at every event: if n of them lie over each other, n² in all. \
Catmull–Clark draws every frame as `dcel solid figure` does, and takes as long for each.

Edits have films, too: dcel script FILE --film OUT.

Examples:
  dcel film ears square.dcel -o ears.svg
  dcel film monotone square.dcel -o monotone.html
  dcel film flips square.obj -o flips.html
  dcel film hull sites.xy -o hull.svg --most 12
  dcel film hull sites.xy --frames hull
  dcel film voronoi sites.xy -o voronoi.html
  dcel film sweep roads.wkt -o sweep.html
  dcel film walk square.obj --face f1 -o walk.svg
  dcel film locate square.obj --start v0 --point 1,2 \\
    -o locate.svg
  dcel film funnel rooms.map --from 1,1 --to 22,12 \\
    -o funnel.html
  dcel film cones rooms.map --from 1,1 --to 22,12 \\
    -o cones.html
  dcel film climb cube.off --direction 1,2,3 \\
    -o climb.svg
  dcel film solid-hull cloud.obj -o hull.html
  dcel film catmull-clark cube.off --steps 2 \\
    -o round.svg")]
pub(crate) struct Args {
    /// The algorithm
    #[arg(value_name = "WHAT")]
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
    #[arg(long, value_name = "NUMBER", default_value_t = 40, value_parser = whole::<usize>)]
    most: usize,
    /// One frame at a time in the .svg too, with links and without a script
    #[arg(long, requires = "output")]
    stepper: bool,
    #[command(flatten)]
    about: About,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
    #[command(flatten)]
    input: InputOptions,
}

/// What some of the algorithms are asked.
#[derive(clap::Args, Debug, Default)]
#[command(next_help_heading = "What the algorithm is asked")]
struct About {
    /// walk: the face to walk round
    #[arg(long, value_name = "f1", conflicts_with = "vertex")]
    face: Option<FaceId>,
    /// walk: the vertex to walk round
    #[arg(long, value_name = "v0")]
    vertex: Option<VertexId>,
    /// locate, climb: the vertex to start from
    #[arg(long, value_name = "v0")]
    start: Option<VertexId>,
    /// locate: the point to be found
    #[arg(long, value_name = "X,Y", value_parser = pair, allow_hyphen_values = true)]
    point: Option<[f64; 2]>,
    /// funnel, cones: where the path starts
    #[arg(long, value_name = "X,Y", value_parser = pair, allow_hyphen_values = true)]
    from: Option<[f64; 2]>,
    /// funnel, cones: where it leads
    #[arg(long, value_name = "X,Y", value_parser = pair, allow_hyphen_values = true)]
    to: Option<[f64; 2]>,
    /// climb: the direction; it points up in the film
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    direction: Option<[f64; 3]>,
    /// catmull-clark: how often; 1 unless given
    #[arg(long, value_name = "N", value_parser = within(1u8..=5))]
    steps: Option<u8>,
}

/// Why there is no film of the algorithm; and what it refuses, drawn.
pub(crate) struct Refused {
    pub(crate) failure: Box<Failure>,
    pub(crate) film: Option<SketchFilm>,
}

impl From<Failure> for Refused {
    fn from(failure: Failure) -> Self {
        Self { failure: Box::new(failure), film: None }
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.page.files(Files::reading([&args.file]).writes("-o", args.output.as_deref())).check()?;
    let target = args.output.as_deref().map(|path| Target::of_film(path, &args.page)).transpose()?;
    args.what.check(&args.about)?;
    match make::film(args) {
        Ok(film) => {
            for (path, frames) in write(&film, args, target.as_ref(), out)? {
                writeln!(out, "{}: {frames} frame{}", path.display(), if frames == 1 { "" } else { "s" })?;
            }
            Ok(Answer::Yes)
        }
        // Standard output stays empty where a call fails.
        Err(Refused { failure, film: Some(film) }) if !args.is_to_stdout() => {
            let files = write(&film, args, target.as_ref(), out)?;
            Err((*failure)
                .with_notes(files.iter().map(|(path, _)| format!("{} shows what is refused", path.display()))))
        }
        Err(Refused { failure, .. }) => Err(*failure),
    }
}

impl Args {
    fn is_to_stdout(&self) -> bool {
        self.output.as_ref().is_some_and(|path| path.as_os_str() == "-")
    }
}

/// Writes the film. What was written, with the number of frames; nothing of standard output.
fn write<'a>(
    film: &SketchFilm,
    args: &'a Args,
    target: Option<&Target>,
    out: &mut Output,
) -> Result<Vec<(&'a Path, usize)>, Failure> {
    let title = title(&args.file, "film");
    let dressed = |target: &Target| args.crop.apply_here(target.options(FigureOptions::new(&title)));
    let mut written = Vec::new();
    if let Some(dir) = &args.frames {
        let singles = film.singles(&dressed(&Target::new(None, &args.page)?)).map_err(cannot)?;
        written.push((dir.as_path(), put_frames(&singles, dir)?));
    }
    if let (Some(path), Some(target)) = (&args.output, target) {
        let options = dressed(target);
        if target.is_page() {
            put(path, film.page(&options).map_err(cannot)?)?;
        } else {
            let figure = if args.stepper { film.stepper(&options) } else { film.strip(&options) };
            target.write(&figure.map_err(cannot)?, out)?;
        }
        if !args.is_to_stdout() {
            written.push((path, film.len()));
        }
    }
    Ok(written)
}

/// Each frame as a file of a new folder: `01.svg`, `02.svg` and so on. How many there are.
pub(crate) fn put_frames(singles: &[Figure], dir: &Path) -> Result<usize, Failure> {
    let width = singles.len().to_string().len().max(2);
    let file = |(i, figure): (usize, &Figure)| (format!("{:0width$}.svg", i + 1), figure.to_svg());
    let files: Vec<(String, String)> = singles.iter().enumerate().map(file).collect();
    super::save::put_folder(dir, files.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))?;
    Ok(files.len())
}

fn cannot(error: dcel_kit::figure::sketch::SketchError) -> Failure {
    Failure::input(error, "")
}
