//! `dcel locate`: where points lie.

use super::choice::coordinate;
use super::output::point;
use super::picture::title;
use super::subject::Subject;
use super::{Answer, Crop, Failure, Files, InputOptions, Output, Page, Target, fields, say, tell};
use dcel_kit::figure::{self, Figure, FigureOptions};
use dcel_kit::io::{ReadOptions, counted, read_points};
use dcel_kit::plane::{Location, Point, Subdivision, Walk};
use dcel_kit::{FaceId, VertexId};
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;

/// Find where points lie: on a vertex, on an edge, in a face
///
/// Decided exactly, for any subdivision of the plane. Points are given as X Y X Y ..., or one on
/// each line of a file, in the coordinates of the structure's file. An edge is named by its half from
/// left to right, so that the first face is the one above it.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel locate square.obj 1 1
  dcel locate garden.geojson 3 3 -2 5.5 --json
  dcel locate square.obj --points trees.xy -o trees.svg
  dcel locate square.obj 1 2 --walk v0 -o walk.svg")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// The points: x and y of each
    #[arg(value_name = "X Y", allow_negative_numbers = true, value_parser = coordinate, required_unless_present = "points")]
    coordinates: Vec<f64>,
    /// A file of points, one on each line
    #[arg(long, value_name = "FILE", conflicts_with = "coordinates")]
    points: Option<PathBuf>,
    /// Walk there from a vertex, and print the walk
    #[arg(long, value_name = "v0")]
    walk: Option<VertexId>,
    /// Draw the points and what they lie on
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
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

/// The answer for one point. The names are those of the JSON form.
#[derive(Serialize)]
struct Found {
    x: f64,
    y: f64,
    /// `vertex`, `edge`, `face`, `hole` or `outer`.
    kind: &'static str,
    element: String,
    name: Option<String>,
    /// The names of the polygons that cover the face, if polygons were mended.
    #[serde(skip_serializing_if = "Option::is_none")]
    polygons: Option<Vec<String>>,
    /// The faces on both sides of an edge, that on the left of its half first.
    between: Option<[String; 2]>,
    walk: Option<Way>,
}

#[derive(Serialize)]
struct Way {
    faces: Vec<String>,
    half_edges: usize,
}

/// Points with more than this are drawn without badges.
const BADGES: usize = 30;
/// Fewer points than this are not worth an index.
const FEW: usize = 16;

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if args.file.as_os_str() == "-" && args.points.as_ref().is_some_and(|points| points.as_os_str() == "-") {
        let what = "- --points -: standard input cannot be both the structure and the points";
        return Err(Failure::input(what, "save one of them as a file first"));
    }
    let files =
        Files::reading([&args.file]).reads("--points", args.points.as_ref()).writes("-o", args.output.as_deref());
    args.page.files(files).check()?;
    let target = Target::optional(args.output.as_deref(), &args.page, args.crop, "-o")?;
    let given = args.given()?;
    let subject = args.input.open_as(&args.file, false)?;
    let s = subject.plane()?;
    // The file says where y points; the points are given in its coordinates.
    let asked: Vec<Point> =
        given.iter().map(|&p| if args.input.y_down { Point::new(p.x, 0.0 - p.y) } else { p }).collect();
    let walks = args.walk.map(|start| walks(s, start, &asked)).transpose()?;
    let found = match &walks {
        Some(walks) => walks.iter().map(|walk| walk.location).collect(),
        None if asked.len() < FEW => asked.iter().map(|&p| s.locate(p)).collect(),
        None => s.locate_all(&asked),
    };
    if let Some(target) = &target {
        target.write(&draw(args, target, &subject, (&given, &asked), &found)?, out)?;
        if target.path().is_none() {
            return Ok(Answer::Yes);
        }
    }
    let line = |i: usize| Found::new(&subject, s, given[i], found[i], walks.as_ref().map(|walks| &walks[i]));
    let answer = fields! { source: &subject.source, points: (0..given.len()).map(line).collect::<Vec<_>>() };
    tell(&answer, args.json, out, |out| {
        for found in &answer.points {
            writeln!(out, "{}  {}", point(&[found.x, found.y]), found.words())?;
            if let Some(way) = &found.walk {
                let faces = if way.faces.is_empty() { "along edges".to_owned() } else { way.faces.join(" ") };
                writeln!(out, "  way: {faces}; {} looked at", counted(way.half_edges, "half-edge", "half-edges"))?;
            }
        }
        Ok(())
    })
}

impl Args {
    /// The points as they are given, all of them within the exact range.
    fn given(&self) -> Result<Vec<Point>, Failure> {
        if let Some(path) = &self.points {
            let list = read_points(path, &ReadOptions::default())?;
            list.notes.iter().for_each(|note| say("note", note));
            return Ok(list.points);
        }
        let pairs = self.coordinates.chunks(2).map(|pair| match *pair {
            [x, y] => {
                let p = Point::new(x, y);
                let refused = |error| format!("the point {} cannot be looked for: {error}", point(&[x, y]));
                p.check().map_err(|error| Failure::input(refused(error), "")).map(|()| p)
            }
            _ => {
                let what = format!(
                    "{}: the last one has no y",
                    counted(self.coordinates.len(), "coordinate is no point", "coordinates are no points")
                );
                Err(Failure::input(what, "give x and y of each point: dcel locate FILE X Y X Y"))
            }
        });
        pairs.collect()
    }
}

fn walks(s: &Subdivision, start: VertexId, asked: &[Point]) -> Result<Vec<Walk>, Failure> {
    let walk = |&p: &Point| s.walk_from(start, p);
    let walks: Result<_, _> = asked.iter().map(walk).collect();
    walks.map_err(|error| Failure::input(format!("--walk: {error}"), ""))
}

impl Found {
    fn new(subject: &Subject, s: &Subdivision, p: Point, at: Location, walk: Option<&Walk>) -> Self {
        let kind = match at {
            Location::Vertex(_) => "vertex",
            Location::Edge(_) => "edge",
            Location::Face(f) if f == s.outer_face() => "outer",
            Location::Face(f) if s.is_hole(f) => "hole",
            Location::Face(_) => "face",
        };
        let name = |f: FaceId| subject.name(f).map(str::to_owned);
        let (name, between) = match at {
            Location::Vertex(_) => (None, None),
            Location::Edge(h) => (None, Some([h, h.twin()].map(|h| s.face(h).to_string()))),
            Location::Face(f) => (name(f), None),
        };
        let walk = walk.map(|walk| Way {
            faces: walk.faces.iter().map(ToString::to_string).collect(),
            half_edges: walk.half_edges,
        });
        let covering = |f: FaceId| Some(subject.covering.as_ref()?.names(f).map(str::to_owned).collect());
        let polygons = if let Location::Face(f) = at { covering(f) } else { None };
        Self { x: p.x, y: p.y, kind, element: at.to_string(), name, polygons, between, walk }
    }

    /// `face f3 "Garden"`, `hole face f4`, `edge h7 between f1 and f0`.
    fn words(&self) -> String {
        let element = &self.element;
        match (self.kind, &self.name, &self.between) {
            ("edge", _, Some([left, right])) => format!("edge {element} between {left} and {right}"),
            ("outer", ..) => format!("outer face {element}"),
            ("hole", ..) => format!("hole face {element}"),
            (kind, Some(name), _) => format!("{kind} {element} \"{name}\""),
            (kind, ..) => format!("{kind} {element}"),
        }
    }
}

/// The points over the structure, what they lie on in blue.
fn draw(
    args: &Args,
    target: &Target,
    subject: &Subject,
    (given, asked): (&[Point], &[Point]),
    found: &[Location],
) -> Result<Figure, Failure> {
    let s = subject.plane()?;
    if given.len() > BADGES {
        say("note", format_args!("more than {BADGES} points are drawn without numbers"));
    }
    let words = |p: Point, at| {
        let words = Found::new(subject, s, p, at, None).words();
        (given.len() <= BADGES).then(|| format!("{}: {words}", point(&[p.x, p.y])))
    };
    let all = given.iter().zip(asked).zip(found);
    let found: Vec<_> = all.map(|((&p, &q), &at)| (q, at, words(p, at))).collect();
    let title = title(&args.file, "standard input");
    let names = subject.faces().filter_map(|f| Some((f, subject.name(f)?)));
    let options = FigureOptions::new(format!("Points in {title}")).face_names(names);
    let options = args.crop.apply_here(target.options(options));
    figure::located(s, &found, args.walk, &options).map_err(|error| Failure::about(&subject.source, error))
}
