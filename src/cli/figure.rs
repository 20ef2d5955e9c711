//! `dcel figure`: the structure as a drawing.

use super::choice::{Choice, one_of};
use super::figure_kind::Kind;
use super::looks::{Crop, Looks, Page};
use super::picture::{Target, is_page, title};
use super::save::{Files, put};
use super::saved::Saved;
use super::subject::{self, Subject};
use super::{Answer, Failure, InputOptions, Output, say};
use dcel_kit::figure::{self, Detail, FaceLabels, Figure, FigureOptions};
use dcel_kit::plane::Subdivision;
use std::path::{Path, PathBuf};

/// Draw a structure: as SVG, TeX, PNG or PDF, or as a page to click through
///
/// Arrows run on the left of their edge, bounded faces are tinted, the outer face is hatched. A
/// broken .dcel file is drawn as far as possible.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
  .png, .pdf  out of a dcel that was built with --features png
  .tex        a document for LaTeX
  .tikz       the picture alone

Examples:
  dcel figure square.obj -o square.svg
  dcel figure square.dcel --pointers next,twin -o pointers.svg
  dcel figure square.dcel --tables --highlight h5 > row.svg
  dcel figure square.obj --dual -o dual.svg
  dcel figure square.obj --inset 0,0,1,1 -o corner.svg
  dcel figure --records > records.svg
  dcel figure square.dcel --title \"Two rooms\" > two.svg
  dcel figure square.obj --interactive -o hover.svg
  dcel figure square.obj --html square.html
  dcel figure states.json \\
    --y-down --drop-degenerate-rings --width 960 \\
    -o states.svg
  dcel figure square.obj --width 12cm --plain -o slide.svg
  dcel figure square.obj --faces f1 --colours colours.txt \\
    --theme light -o room.svg
  dcel figure square.obj -o square.png --scale 3")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN", required_unless_present = "records")]
    file: Option<PathBuf>,
    /// The type diagram of the records; needs no file
    #[arg(long, conflicts_with_all = [
        "file", "kind", "html", "max_height", "detail", "no_labels", "no_vertex_labels", "no_half_edge_labels",
        "face_labels", "width", "columns", "colours", "faces", "crop",
    ])]
    records: bool,
    /// The file to write: .svg, .tex, .tikz, .png or .pdf [default: SVG on standard output, nothing with --html]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Write a self-contained page: the picture, its tables, buttons to walk
    #[arg(long, value_name = "OUT.html", conflicts_with_all = ["records", "kind"])]
    html: Option<PathBuf>,
    /// Draw again whenever a file that is read is saved, until Ctrl-C
    #[arg(long, conflicts_with = "records")]
    watch: bool,
    #[command(flatten)]
    kind: Kind,
    #[command(flatten)]
    drawing: Drawing,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
    #[command(flatten)]
    looks: Looks,
    #[command(flatten)]
    input: InputOptions,
}

/// How to draw.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Drawing")]
struct Drawing {
    /// The title, which screen readers read [default: the name of the file]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// What ids in the SVG begin with [default: from the title]
    #[arg(long, value_name = "WORD")]
    id_prefix: Option<String>,
    /// Greatest height in px, 100 to 20000 [default: 5/4 of the width]
    #[arg(long, value_name = "PX", value_parser = px)]
    max_height: Option<f64>,
    /// How much to draw [default: as much as there is room for]
    ///
    /// Where far more arrows or names are asked for than there is room for, time grows with the square of
    /// the edges that crowd. All that is asked for is held in memory: about 6 KB for each edge.
    #[arg(long, value_name = "LEVEL", value_parser = one_of(LEVELS))]
    detail: Option<Detail>,
    /// Half-edges show their pointers under the mouse, with the keyboard's focus, and by #id
    #[arg(long, conflicts_with_all = ["records", "kind"])]
    interactive: bool,
    /// No names at all
    #[arg(long)]
    no_labels: bool,
    /// No names of vertices
    #[arg(long)]
    no_vertex_labels: bool,
    /// No names of half-edges
    #[arg(long)]
    no_half_edge_labels: bool,
    /// What is written into faces
    #[arg(long, value_name = "WHAT", default_value = "names", value_parser = one_of(FACE_LABELS))]
    face_labels: FaceLabels,
}

/// How much is drawn.
static LEVELS: &[Choice<Detail>] = &[
    ("tiles", "Outlines and areas", Detail::Tiles),
    ("edges", "Every edge, vertex and face", Detail::Edges),
    ("arrows", "Half-edges too", Detail::Arrows),
    ("full", "Everything, with names", Detail::Full),
];

/// What the faces show.
static FACE_LABELS: &[Choice<FaceLabels>] = &[
    ("off", "Nothing", FaceLabels::Off),
    ("ids", "Their ids", FaceLabels::Ids),
    ("names", "Their names, ids where there is none", FaceLabels::Names),
];

fn px(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "write a number of px, for example 800".to_owned())?;
    if (100.0..=20_000.0).contains(&number) { Ok(number) } else { Err("choose 100 to 20000 px".to_owned()) }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if args.watch { keep(args, out) } else { draw(args, out) }
}

/// Draws now, and whenever a file is saved. What is wrong with a file is told, and the drawing stays as it was.
fn keep(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let Some(target) = args.output.as_ref().or(args.html.as_ref()) else {
        return Err(Failure::input("--watch: there is no file to draw into", "add -o OUT.svg or --html OUT.html"));
    };
    if args.file.as_ref().is_some_and(|file| file.as_os_str() == "-") {
        return Err(Failure::input("--watch: standard input cannot be watched", "give the name of a file"));
    }
    let sources = args.page.files(args.looks.files(Files::reading(&args.file))).sources();
    if !sources.iter().all(|file| file.exists()) {
        // A name that is mistyped is told at once, and not waited for.
        return draw(args, out);
    }
    let saved = Saved::watch(sources)?;
    loop {
        match draw(args, out) {
            Ok(_) => say("drawn", format_args!("{}; again when a file is saved, Ctrl-C ends it", target.display())),
            Err(failed) => failed.report(),
        }
        if !saved.again() {
            return Ok(Answer::Yes);
        }
    }
}

fn draw(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let target = Target::new(args.output.as_deref(), &args.page)?;
    let files = Files::reading(&args.file).writes("-o", target.path()).writes("--html", args.html.as_deref());
    args.page.files(args.looks.files(files)).check()?;
    let Some(file) = &args.file else {
        if let Some(flag) = args.input.given() {
            let what = format!("{flag} cannot be used with --records: no file is read");
            return Err(Failure::call(what, format!("leave {flag} out")));
        }
        let options = target.options(args.drawing.options(Path::new("The records of a half-edge structure")));
        target.write(&figure::records(&options), out)?;
        return Ok(Answer::Yes);
    };
    if let Some(path) = args.html.as_ref().filter(|path| path.extension().is_some() && !is_page(path)) {
        let what = format!("{}: this would be HTML", path.display());
        return Err(Failure::input(what, "give a name that ends in .html"));
    }
    let subject = args.input.open(file)?;
    let Some(view) = subject.planar() else {
        let what = format!("{}: a surface in space has no drawing in the plane", subject.source);
        return Err(Failure::input(
            what,
            "--plane drops z: good for a terrain seen from above, not for a closed surface",
        ));
    };
    let names = subject.faces().filter_map(|f| Some((f, subject.name(f)?)));
    let options = args.looks.apply(args.drawing.options(file).face_names(names), &subject)?;
    let options = args.crop.apply_here(target.options(options));
    let refused = |error| Failure::about(&subject.source, error);
    if let Some(path) = &args.html {
        let page = figure::page(view, &options).map_err(refused)?;
        put(path, page.to_html())?;
        if args.output.is_none() {
            page.figure().notes().iter().for_each(|note| say("note", note));
            return Ok(Answer::Yes);
        }
    }
    let figure =
        if args.kind.dual { dual(&subject, &options)? } else { args.kind.draw(view, &options).map_err(refused)? };
    figure.notes().iter().for_each(|note| say("note", note));
    target.write(&figure, out)?;
    Ok(Answer::Yes)
}

/// The dual graph. It is that of a sound subdivision only.
fn dual(subject: &Subject, options: &FigureOptions) -> Result<Figure, Failure> {
    let refused = |error: String| Failure::input(format!("{}: {error}", subject.source), "dcel validate says more");
    let drawn = match &subject.kind {
        subject::Kind::Plane(subdivision) => figure::dual(subdivision, options),
        subject::Kind::Table(table) => {
            let subdivision =
                Subdivision::from_columns(&mut table.clone()).map_err(|error| refused(error.to_string()))?;
            figure::dual(&subdivision, options)
        }
        subject::Kind::Surface(_) => return Err(refused("a surface in space has no drawing in the plane".to_owned())),
    };
    drawn.map_err(|error| refused(error.to_string()))
}

impl Drawing {
    fn options(&self, file: &Path) -> FigureOptions {
        let title = self.title.clone().unwrap_or_else(|| title(file, "Half-edge structure"));
        let mut options = FigureOptions::new(title)
            .vertex_labels(!self.no_labels && !self.no_vertex_labels)
            .interactive(self.interactive)
            .half_edge_labels(!self.no_labels && !self.no_half_edge_labels)
            .face_labels(if self.no_labels { FaceLabels::Off } else { self.face_labels });
        if let Some(prefix) = &self.id_prefix {
            options = options.id_prefix(prefix);
        }
        if let Some(height) = self.max_height {
            options = options.max_height(height);
        }
        match self.detail {
            None => options,
            Some(detail) => options.detail(detail),
        }
    }
}
