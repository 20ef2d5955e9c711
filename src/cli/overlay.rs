//! `dcel overlay`: two subdivisions on each other.

use super::choice::number;
use super::picture::title;
use super::results::Moved;
use super::save::{Files, InPlace, save};
use super::subject::Subject;
use super::{Answer, Crop, Failure, InputOptions, Output, Page, Target, fields, say, tell};
use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::io::{Format, Model, Number, counted, on_grid};
use dcel_kit::plane::{Operation, Overlay, Parts};
use dcel_kit::{FaceId, FaceMap};
use std::io::Write;
use std::path::PathBuf;

/// Lay two subdivisions of the plane over each other
///
/// The edges of both cut the plane into faces; each of them lies in one face of A and one of B.
/// With --operation the bounded faces of A and of B, hole faces excepted, are taken as two regions,
/// and the answer is a region.
///
/// What crosses is decided exactly; crossings become vertices at the nearest doubles, and a note says
/// which of them moved. Lines too close to settle so are rounded to a grid, and a note says what
/// moved: no input is refused for being close. The area of a region is that of the given shapes, with
/// crossings that are not rounded; with --grid that of the answer.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel overlay parcels.geojson floods.geojson --json
  dcel overlay parcels.geojson floods.geojson -o both.svg
  dcel overlay parcels.geojson floods.geojson \\
    --operation difference -o rest.dcel
  dcel overlay parcels.geojson floods.geojson \\
    --operation union --join -o union.svg")]
pub(crate) struct Args {
    /// The first file, or - for standard input
    a: PathBuf,
    /// The second file
    b: PathBuf,
    /// Make a region: union, intersection, difference (A without B) or xor
    #[arg(long, value_name = "WHAT")]
    operation: Option<Operation>,
    /// Take edges with the region on both sides away
    #[arg(long, requires = "operation")]
    join: bool,
    /// Round all points to multiples of this, or rather of the largest power of two not above it
    #[arg(long, value_name = "SIZE", value_parser = number)]
    grid: Option<f64>,
    /// Draw it (.svg), or write the structure (.dcel, .geojson, ...); - for dcel text
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    in_place: InPlace,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
    #[command(flatten)]
    input: InputOptions,
}

/// Where the answer goes.
enum Goal {
    Report,
    Picture(Box<Target>),
    Structure(PathBuf),
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if [&args.a, &args.b].into_iter().all(|file| file.as_os_str() == "-") {
        let help = "save one of them as a file first";
        return Err(Failure::input("- -: standard input cannot be both A and B", help));
    }
    let files = Files::reading([&args.a, &args.b]).writes_or_replaces("-o", args.output.as_deref(), args.in_place);
    args.page.files(files).check()?;
    let goal = args.goal()?;
    let [a, b] = [&args.a, &args.b].map(|file| args.input.open_one_of(file, false));
    let (a, b) = (a?, b?);
    let (source_a, source_b) = (a.plane()?, b.plane()?);
    let fails = |error| Failure::input(format!("{} and {}: {error}", a.source, b.source), "");
    let both = match args.grid {
        None => source_a.overlay(source_b),
        grid => source_a.overlay_on_grid(source_b, grid),
    };
    let both = both.map_err(fails)?;
    let parts = if args.join { Parts::Joined } else { Parts::Kept };
    let region = args.operation.map(|operation| both.region(operation, parts).map(|region| (operation, region)));
    let region = region.transpose().map_err(fails)?;
    let made = region.as_ref().map_or(&both.subdivision, |(_, region)| region);
    let names = if region.is_none() { names(&a, &b, &both) } else { FaceMap::default() };
    let model = || Model::planar(made).with_names(|f| names.get(f)?.as_deref());
    match &goal {
        Goal::Report => {}
        Goal::Picture(target) => {
            let figure = match &region {
                None => figure::overlay(source_a, source_b, &both, &options(args, target, "Overlay of")),
                Some((operation, region)) => {
                    let options = options(args, target, &format!("{operation} of"));
                    figure::region([source_a, source_b], *operation, region, &options)
                }
            };
            target.write(&figure.map_err(|error| Failure::input(error, ""))?, out)?;
        }
        Goal::Structure(path) => save(path, &model(), out)?,
    }
    tell_rounding(&both);
    if matches!(&goal, Goal::Structure(path) if path.as_os_str() == "-") {
        return Ok(Answer::Yes);
    }
    let s = &both.subdivision;
    let label =
        |f: FaceId| fields! { face: f.to_string(), a: both.face_of_a[f].to_string(), b: both.face_of_b[f].to_string() };
    let labels = s.faces().filter(|&f| f != s.outer_face()).map(label);
    let answer = fields! {
        a: &a.source,
        b: &b.source,
        vertices: s.vertex_count(),
        edges: s.edge_count(),
        faces: s.face_count(),
        crossings: both.crossings.iter().map(ToString::to_string).collect::<Vec<_>>(),
        moved: Moved::all(&both.moved),
        // The distance of neighbours of the grid, if points were rounded to one.
        grid: both.grid,
        // Vertices of a and b that the grid moved.
        displaced: Moved::all(&both.displaced),
        // How many vertices of a and b moved; some fell together.
        displaced_points: both.displaced_points,
        // No point of an edge is further from what it became.
        farthest: both.farthest,
        rounds: both.rounds,
        unsettled: both.unsettled.iter().map(ToString::to_string).collect::<Vec<_>>(),
        // The bounded faces.
        labels: labels.collect::<Vec<_>>(),
        region: region.as_ref().map(|(operation, region)| fields! {
            operation: operation.name(),
            vertices: region.vertex_count(),
            edges: region.edge_count(),
            // Those of the region: neither the outer face nor hole faces.
            faces: region.face_count() - 1 - region.hole_faces().count(),
            hole_faces: region.hole_faces().count(),
            // Before its corners were rounded, if nobody asked for a grid.
            area: match args.grid {
                None => both.area([source_a, source_b], *operation),
                Some(_) => region.domain_area(),
            },
        }),
    };
    tell(&answer, args.json, out, |out| {
        writeln!(out, "{} over {}", answer.a, answer.b)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        line("vertices", format!("{} ({} where edges cross)", answer.vertices, answer.crossings.len()))?;
        line("edges", answer.edges.to_string())?;
        line("faces", format!("{} (with the outer face)", answer.faces))?;
        if let Some(region) = &answer.region {
            let faces = counted(region.faces, "face", "faces");
            line(region.operation, format!("{faces}, area {}", Number(region.area)))?;
            if region.hole_faces > 0 {
                line("hole faces", region.hole_faces.to_string())?;
            }
            return Ok(());
        }
        answer.labels.iter().try_for_each(|of| line(&of.face, format!("{} of a, {} of b", of.a, of.b)))
    })
}

impl Args {
    fn goal(&self) -> Result<Goal, Failure> {
        let path = self.output.as_ref();
        let is_picture = |path: &&PathBuf| Format::from_path(path).is_none() && path.as_os_str() != "-";
        // What is said of a figure is refused where there is none.
        let target = Target::optional(path.filter(is_picture).map(PathBuf::as_path), &self.page, self.crop, "-o");
        let Some(path) = path else { return target.map(|_| Goal::Report) };
        if !is_picture(&path) {
            return target.map(|_| Goal::Structure(path.clone()));
        }
        if !Target::is_named(path) {
            let what = format!("{}: the file name does not say what to write", path.display());
            return Err(Failure::input(what, "end it in .svg for a picture, in .dcel for the structure"));
        }
        Ok(target?.map_or(Goal::Report, |target| Goal::Picture(Box::new(target))))
    }
}

/// `Garden & f2`: the names of the faces of both, ids where there is none; nothing outside of both.
fn names(a: &Subject, b: &Subject, both: &Overlay) -> FaceMap<Option<String>> {
    let mut names = FaceMap::default();
    let name = |subject: &Subject, f: FaceId| subject.name(f).map_or_else(|| f.to_string(), str::to_owned);
    for f in both.subdivision.faces().filter(|&f| f != both.subdivision.outer_face()) {
        let words = format!("{} & {}", name(a, both.face_of_a[f]), name(b, both.face_of_b[f]));
        names.set(f, Some(words), None);
    }
    names
}

fn tell_rounding(both: &Overlay) {
    let furthest = both.moved.iter().map(|&(_, by)| by).fold(0.0, f64::max);
    if !both.moved.is_empty() {
        let crossings = counted(both.moved.len(), "crossing was", "crossings were");
        let onto = if both.grid.is_some() { "the grid" } else { "doubles" };
        say("note", format_args!("{crossings} rounded to {onto}, by {} at most", Number(furthest)));
    }
    if let Some(grid) = both.grid {
        say("note", on_grid(grid, both.displaced_points, &both.displaced, both.farthest));
    }
}

fn options(args: &Args, target: &Target, what: &str) -> FigureOptions {
    let [a, b] = [&args.a, &args.b].map(|path| title(path, "standard input"));
    args.crop.apply_here(target.options(FigureOptions::new(format!("{what} {a} and {b}"))))
}
