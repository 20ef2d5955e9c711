//! `dcel voronoi`: the cells of nearest sites.

use super::choice::number;
use super::delaunay::tell_repeated;
use super::results::Results;
use super::{Answer, Failure, InputOptions, Output, fields, say};
use dcel_kit::figure;
use dcel_kit::io::{Model, PointList, counted};
use dcel_kit::plane::{DelaunayBuilt, Point, Subdivision, VoronoiError, Window};
use std::io::Write;
use std::path::PathBuf;

/// Make the Voronoi diagram of points
///
/// Reads points as lines `x y`, or the points of any other format. The cells of a box are the faces
/// of the result, one for each site; which cells meet is decided exactly, corners are rounded.
/// If none is given, the box holds all points with a margin of a quarter of its longer side.
///
/// Sites that are only a few last digits apart are refused where doubles cannot hold the edge between
/// them, even if only counts are asked for; delaunay takes them. Moving the sites near 0 helps, if that
/// is not where they are.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel voronoi sites.xy --figure cells.svg --delaunay
  dcel voronoi sites.xy --box 0 0 100 50 -o cells.dcel
  dcel voronoi sites.csv --rays --figure diagram.svg")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// The box: left, bottom, right and top; all points must lie inside
    #[arg(long = "box", value_names = ["LEFT", "BOTTOM", "RIGHT", "TOP"], num_args = 4, allow_negative_numbers = true, value_parser = number)]
    window: Option<Vec<f64>>,
    #[command(flatten)]
    results: Results,
    /// Draw the Delaunay triangulation over it
    #[arg(long, requires = "figure")]
    delaunay: bool,
    /// Draw the edges alone, cut off at the box
    #[arg(long, requires = "figure")]
    rays: bool,
    #[command(flatten)]
    input: InputOptions,
}

/// What the cells of a diagram take at their making for each site: measured on 10^5 of them.
const BYTES_PER_SITE: usize = 1_300;

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.results.check(&args.file)?;
    let list = args.input.points(&args.file)?;
    list.check_room(BYTES_PER_SITE)?;
    let built = Subdivision::delaunay(&list.points).map_err(|error| Failure::about(&list.source, error))?;
    tell_repeated(&built.repeated);
    let window = match args.window.as_deref() {
        Some(&[left, bottom, right, top]) => Window { low: Point::new(left, bottom), high: Point::new(right, top) },
        _ => Window::around(&list.points),
    };
    let voronoi = built.subdivision.voronoi().map_err(|error| refused(&list, &built, &error))?;
    let cells = voronoi.cells(window).map_err(|error| refused(&list, &built, &error))?;
    args.results.draw(&args.file, "Voronoi", out, |options| {
        let drawn = if args.rays {
            figure::voronoi_edges(&voronoi, &window, args.delaunay, &options)
        } else {
            figure::voronoi_cells(&voronoi, &cells, args.delaunay, &options)
        };
        drawn.map_err(|error| Failure::about(&list.source, error))
    })?;
    let (sites, made) = (&built.subdivision, &cells.subdivision);
    let cell = |v| {
        let Point { x, y } = sites.point(v);
        fields! { site: v.to_string(), x, y, face: cells.cells[v].map_or_else(String::new, |f| f.to_string()) }
    };
    let [left, bottom, right, top] = [window.low.x, window.low.y, window.high.x, window.high.y];
    let answer = fields! {
        source: list.source.clone(),
        points: list.points.len(),
        // Points by number, from 0.
        repeated: built.repeated.iter().map(|(point, repeats)| fields! { point, repeats }).collect::<Vec<_>>(),
        sites: sites.vertex_count(),
        corners: voronoi.corners().len(),
        edges: voronoi.edges().len(),
        unbounded_edges: voronoi.edges().iter().filter(|edge| edge.ends.contains(&None)).count(),
        #[serde(rename = "box")]
        window: [left, bottom, right, top],
        vertices_in_box: made.vertex_count(),
        edges_in_box: made.edge_count(),
        // Faces that rounding had made, joined to cells.
        slivers: cells.slivers,
        cells: sites.vertices().map(cell).collect::<Vec<_>>(),
    };
    if cells.slivers > 0 {
        say("note", format_args!("faces that rounding had made and that were joined to cells: {}", cells.slivers));
    }
    args.results.finish(&Model::planar(made), &answer, out, |out| {
        writeln!(out, "{}: {}", answer.source, counted(answer.points, "point", "points"))?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        line("sites", answer.sites.to_string())?;
        line("corners", answer.corners.to_string())?;
        line("edges", format!("{}, {} of them unbounded", answer.edges, answer.unbounded_edges))?;
        line("box", format!("({left}, {bottom}) to ({right}, {top})"))?;
        let vertices = counted(answer.vertices_in_box, "vertex", "vertices");
        line("in the box", format!("{vertices}, {}", counted(answer.edges_in_box, "edge", "edges")))?;
        line("cells", answer.cells.len().to_string())
    })
}

/// The failure with the line of the site it speaks of.
fn refused(list: &PointList, built: &DelaunayBuilt, error: &VoronoiError) -> Failure {
    let (VoronoiError::SiteOutside { site, .. } | VoronoiError::TooClose { site, .. }) = error else {
        return Failure::about(&list.source, error);
    };
    let point = built.vertices.iter().position(|v| v == site);
    let failure = Failure::about(list.place(point.unwrap_or(usize::MAX)), error);
    match error {
        VoronoiError::SiteOutside { .. } => failure.helped_by("give a larger --box, or leave it out"),
        _ => failure,
    }
}
