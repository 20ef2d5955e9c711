//! `dcel compare`: is a drawing what it should be?

use super::failure::say;
use super::{Answer, Failure, Output};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::compare::{self, CompareError, Comparison, Options, Side};
use dcel_kit::io::source_name;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Longest file that is read at all; what is compared is far smaller.
const LONGEST: u64 = 64 << 20;

/// Compare a drawing with a reference, by what it means
///
/// Both files are SVG. Lines, circles and filled polygons are compared as edges, vertices and faces, wherever
/// they stand on the canvas and however large they are, in any order, colour and width; a drawing may be scaled
/// and shifted, but not mirrored, turned or stretched, and all of it must be seen. If both files declare their
/// structure in data-* attributes, as the kit's figures do, every pointer is compared, too, and the drawing must
/// show what is declared. Names count with --names only.
///
/// Exit code 0: equal; 1: different; 2: a file cannot be read.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
What is read:
  edges     <line>, <polyline>, <polygon>, <rect>, and <path>,
            if they have a stroke that can be seen; a line
            through several vertices is several edges
  vertices  <circle>, or a small round <path>
  faces     filled <polygon>, <path>, <rect>: the corners of a
            bounded face, counter-clockwise
  around    <g>, <use>, <symbol>, transform, clip-path, units,
            style attributes, simple style sheets
What hides an edge, a circle or a face is told: draw faces first,
then lines, then circles. Texts, curves, backgrounds and frames,
and what is called legend or axis are passed over. y points down
in SVG: draw y as height - y, with two decimals or more. An edge
may be drawn twice. Drawings of matplotlib, TikZ, Inkscape, cairo,
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
  dcel compare expected.svg mine.svg --names --json")]
pub(crate) struct Args {
    /// What is expected
    #[arg(value_name = "REFERENCE.svg")]
    reference: PathBuf,
    /// What was drawn, or - for standard input
    #[arg(value_name = "MINE.svg")]
    student: PathBuf,
    /// Names must be the same, too
    #[arg(long)]
    names: bool,
    /// Faces need not be filled
    #[arg(long)]
    no_faces: bool,
    /// How far a point may be from its place, in px of a drawing of 600 px
    #[arg(long, value_name = "PX", default_value = "0.05", value_parser = tolerance)]
    tolerance: f64,
    /// Draw the differences beside your drawing: red and dashed what is missing, blue what is too much
    #[arg(long, value_name = "OUT.svg")]
    diff: Option<PathBuf>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let px = text.parse().ok().filter(|px| *px > 0.0 && *px <= 100.0);
    px.ok_or_else(|| "write a length in px, for example 0.05".to_owned())
}

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Report<'a> {
    reference: String,
    student: String,
    equal: bool,
    /// Which layer decided: bytes, declared, drawn, shape.
    layer: &'static str,
    agreed: &'a str,
    differences: Vec<Line<'a>>,
    notes: &'a [String],
}

#[derive(Serialize)]
struct Line<'a> {
    kind: &'static str,
    layer: &'static str,
    text: &'a str,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if let Some(path) = &args.diff {
        if path.extension().is_some_and(|extension| !extension.eq_ignore_ascii_case("svg")) {
            let what = format!("{}: this would be SVG", path.display());
            return Err(Failure::input(what, "give a name that ends in .svg"));
        }
        for input in [&args.reference, &args.student] {
            if super::output::is_same_file(input, path) {
                let what = format!("{}: this is one of the drawings", path.display());
                return Err(Failure::input(what, "choose another name"));
            }
        }
    }
    let files = [(Side::Reference, &args.reference), (Side::Student, &args.student)];
    let refused = |error: &CompareError| {
        let (_, file) = files[usize::from(error.side == Side::Student)];
        Failure::input(error.named(&source_name(file)), "dcel compare --help says what is read")
    };
    let [reference, student] = files.map(|(_, file)| read(file));
    let (reference, student) = (reference?, student?);
    let text = |bytes, side| compare::text(bytes, side).map_err(|error| refused(&error));
    let options = Options::new().names(args.names).faces(!args.no_faces).tolerance(args.tolerance);
    let (reference, student) = (text(&reference, Side::Reference)?, text(&student, Side::Student)?);
    let answer = compare::compare(reference, student, &options).map_err(|error| refused(&error))?;
    if args.json {
        out.json(&report(args, &answer))?;
    } else {
        write!(out, "{}", answer.text())?;
    }
    if let Some(path) = &args.diff {
        draw(path, &answer)?;
    }
    Ok(if answer.is_equal() { Answer::Yes } else { Answer::No })
}

/// The bytes of a file.
fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    use std::io::Read;
    let unreadable =
        |error: std::io::Error| Failure::input(format!("{}: cannot be read: {error}", source_name(file)), "");
    let mut bytes = Vec::new();
    let length = if file.as_os_str() == "-" {
        std::io::stdin().lock().take(LONGEST).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(file).and_then(|file| file.take(LONGEST).read_to_end(&mut bytes))
    };
    length.map_err(unreadable)?;
    Ok(bytes)
}

fn report<'a>(args: &Args, answer: &'a Comparison) -> Report<'a> {
    let line = |d: &'a compare::Difference| Line { kind: d.kind.word(), layer: d.layer.word(), text: &d.text };
    Report {
        reference: source_name(&args.reference),
        student: source_name(&args.student),
        equal: answer.is_equal(),
        layer: answer.layer().word(),
        agreed: answer.agreed(),
        differences: answer.differences().iter().map(line).collect(),
        notes: answer.notes(),
    }
}

fn draw(path: &Path, answer: &Comparison) -> Result<(), Failure> {
    let options = FigureOptions::new("What differs").id_prefix("diff");
    let figure = answer.figure(&options).map_err(|error| Failure::input(error, ""))?;
    figure.notes().iter().for_each(|note| say("note", note));
    std::fs::write(path, figure.to_svg()).map_err(|error| Failure::writing(path.display(), &error))
}
