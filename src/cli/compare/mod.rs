//! `dcel compare`: is a drawing, or a structure, what it should be?
//!
//! ```text
//!   drawings.rs    Two drawings
//!   structures.rs  Two structures
//! ```

mod drawings;
mod structures;

use super::{Answer, Crop, Failure, Files, InputOptions, Output, Page, Target};
use dcel_kit::io::Format;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Compare a drawing or a structure with a reference, by what it means
///
/// Two drawings, as SVG: lines, circles and filled polygons are compared as edges, vertices and faces, wherever
/// they stand on the canvas and however large they are, in any order, colour and width; a drawing may be scaled
/// and shifted, but not mirrored, turned or stretched, and all of it must be seen. If both files declare their
/// structure in data-* attributes, as the kit's figures do, every pointer is compared, too, and the drawing must
/// show what is declared. Names count with --names only: drawings have to declare them then, and show those that
/// the reference shows where they belong, so that they can be read, and nowhere else.
///
/// Two structures, of any format: vertices, edges, faces and all pointers are compared at their places; ids may be
/// others.
///
/// Which of its half-edges a vertex or a face names is free, and never counts: not with --ids, and in drawings not in
/// data-he. It has to be one of its own.
///
/// Exit code 0: equal; 1: different; 2: a file cannot be read.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
What is read of drawings:
  edges     <line>, <polyline>, <polygon>, <rect>, and <path>,
            if they have a stroke that can be seen; a line
            through several vertices is several edges
  vertices  <circle>, or a small round <path>; a small square,
            triangle, polygon, star or cross at the end of a line
  faces     filled <polygon>, <path>, <rect>: the corners of a
            bounded face, counter-clockwise
  around    <g>, <use>, <symbol>, transform, clip-path, units,
            style attributes, simple style sheets
What hides an edge, a circle or a face is reported: draw faces first, \
then lines, then circles; what a mask or a filter may hide is \
refused. Texts and boxes round them, curves, backgrounds and frames, \
and what is called legend or axis are passed over; a legend whose box \
lies over the drawing is to be moved. y points down \
in SVG: draw y as height - y, with two decimals or more. An edge \
may be drawn twice. Drawings of matplotlib, TikZ, Inkscape, cairo, \
svgwrite and drawsvg are read as they come.

The least that a program has to write:
  <svg xmlns=\"http://www.w3.org/2000/svg\">
  <polygon points=\"62,338 538,338 538,62\" fill=\"pink\"/>
  <line x1=\"62\" y1=\"338\" x2=\"538\" y2=\"338\"
        stroke=\"black\"/>
  <circle cx=\"62\" cy=\"338\" r=\"4\"/>
  </svg>

Examples:
  dcel compare expected.svg mine.svg
  dcel compare expected.svg mine.svg --diff diff.svg
  dcel compare expected.svg mine.svg --json
  dcel figure square.obj -o kit.svg && \\
    dcel compare kit.svg kit.svg --names
  dcel compare square.dcel square.obj")]
pub(crate) struct Args {
    /// What is expected: a drawing or a structure
    #[arg(value_name = "REFERENCE")]
    reference: PathBuf,
    /// What was made, or - for standard input
    #[arg(value_name = "MINE")]
    student: PathBuf,
    /// Names must be the same, too; of structures those of the faces
    #[arg(long)]
    names: bool,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    drawn: Drawn,
    #[command(flatten)]
    built: Built,
    #[command(flatten)]
    input: InputOptions,
}

/// How to compare drawings.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Drawings")]
struct Drawn {
    /// Faces need not be filled
    #[arg(long)]
    no_faces: bool,
    /// How far a point may be from its place, in px of a drawing of 600 px [default: 0.05]
    #[arg(long, value_name = "PX", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Draw the differences beside your drawing: red and dashed what is missing, blue what is too much
    #[arg(long, value_name = "OUT.svg")]
    diff: Option<PathBuf>,
    #[command(flatten)]
    page: Page,
}

/// How to compare structures.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Structures")]
struct Built {
    /// Positions need not be the same: only what is joined to what
    #[arg(long, conflicts_with = "names")]
    no_positions: bool,
    /// Ids must be the same, too; not which half-edge a vertex or a face names
    #[arg(long)]
    ids: bool,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let px = text.parse().ok().filter(|px| *px > 0.0 && *px <= 100.0);
    px.ok_or_else(|| "write a length in px, for example 0.05".to_owned())
}

/// What a file holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Holds {
    Drawing,
    Structure,
}

impl Holds {
    /// Judged by its name, or by how it begins; nothing for standard input.
    fn of(path: &Path) -> Option<Self> {
        if path.as_os_str() == "-" {
            return None;
        }
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg")) {
            return Some(Self::Drawing);
        }
        if Format::from_path(path).is_some() {
            return Some(Self::Structure);
        }
        let mut start = Vec::new();
        // What cannot be read is told when it is read.
        let _ = File::open(path).map(|file| file.take(512).read_to_end(&mut start));
        let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start).trim_ascii_start();
        let is_structure = !text.starts_with(b"<") && Format::from_content(&start).is_some();
        Some(if is_structure { Self::Structure } else { Self::Drawing })
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let files = [&args.reference, &args.student];
    if files.iter().all(|file| file.as_os_str() == "-") {
        let what = "- -: standard input cannot be both the reference and what is compared with it";
        return Err(Failure::input(what, "save one of them as a file first"));
    }
    args.drawn.page.files(Files::reading(files).writes("--diff", args.drawn.diff.as_deref())).check()?;
    let target = Target::optional(args.drawn.diff.as_deref(), &args.drawn.page, Crop::default(), "--diff")?;
    let kinds: Vec<Holds> = files.iter().filter_map(|file| Holds::of(file)).collect();
    match kinds[..] {
        [Holds::Drawing, Holds::Structure] | [Holds::Structure, Holds::Drawing] => {
            let drawing = files[usize::from(kinds[1] == Holds::Drawing)].display();
            let structure = files[usize::from(kinds[1] == Holds::Structure)].display();
            let what = format!("{drawing} is a drawing and {structure} a structure");
            Err(Failure::input(what, format!("draw it first: dcel figure {structure} -o drawing.svg")))
        }
        [Holds::Structure, ..] => {
            let Drawn { no_faces, tolerance, diff, .. } = &args.drawn;
            let flags = [("--no-faces", *no_faces), ("--tolerance", tolerance.is_some()), ("--diff", diff.is_some())];
            refuse(&flags, "these are structures: it is for drawings")?;
            structures::run(args, out)
        }
        _ => {
            let Built { no_positions, ids } = args.built;
            let reading = args.input.given().map(|flag| (flag, true));
            let flags = [Some(("--no-positions", no_positions)), Some(("--ids", ids)), reading];
            let flags: Vec<_> = flags.into_iter().flatten().collect();
            refuse(&flags, "these are drawings: it is for structures")?;
            drawings::run(args, target.as_ref(), out)
        }
    }
}

/// A flag that cannot do anything here is an error, so that nobody believes it did.
fn refuse(flags: &[(&str, bool)], why: &str) -> Result<(), Failure> {
    match flags.iter().find(|(_, given)| *given) {
        Some((flag, _)) => Err(Failure::input(format!("{flag} cannot be used: {why}"), format!("leave {flag} out"))),
        None => Ok(()),
    }
}
