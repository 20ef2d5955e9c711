//! `dcel build`: from segments to a subdivision, and what became of them.

use super::choice::{number, pair};
use super::input::refuse_object;
use super::output::names;
use super::results::{Moved, Results};
use super::{Answer, Failure, Output, fields, say};
use dcel_kit::figure;
use dcel_kit::io::{
    Document, Format, LoadError, Model, NOTHING_TO_MEND, ReadOptions, SegmentSoup, arrange_with, counted, describe,
    faults_with_places, is_as_given, read_path, source_name,
};
use dcel_kit::plane::{ArrangeOptions, Point, SegmentsError};
use dcel_kit::topology::components;
use std::io::Write;
use std::path::PathBuf;

/// Build the subdivision that segments cut the plane into
///
/// Reads wkt, poly, segments, geojson and topojson; polygons count by their outlines here, and as
/// polygons with holes in all other commands. Ends with equal
/// coordinates become one vertex. Segments that meet elsewhere are refused, each by name, or split
/// with --mend. Edges that bound no face are listed: dangles hang free, cut edges hold parts together.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel build plan.poly
  dcel build plan.poly --figure plan.svg --json
  dcel build roads.wkt --mend -o roads.dcel
  dcel build roads.wkt --mend --grid 0.001 -o roads.dcel
  dcel build rings.segments --nested-holes -o rings.dcel")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// The format, if the file name does not say: wkt, poly, segments, geojson or topojson
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// Split segments where they cross, touch or overlap, and report what was done
    #[arg(long)]
    mend: bool,
    /// The same as --mend
    #[arg(long)]
    split_crossings: bool,
    /// Round all points to multiples of this, or rather of the largest power of two not above it.
    /// Without it, points are only rounded to a grid where lines are too close to settle in place,
    /// and then as finely as doubles allow
    #[arg(long, value_name = "SIZE", value_parser = number)]
    grid: Option<f64>,
    /// Make hole faces of rings that lie inside others, but not of what lies in these again, and so on
    #[arg(long)]
    nested_holes: bool,
    /// Make a hole face of the face around this point; may be given several times
    #[arg(long = "hole", value_name = "X,Y", value_parser = hole, allow_hyphen_values = true)]
    holes: Vec<Point>,
    /// The object of a TopoJSON file to read
    #[arg(long, value_name = "NAME")]
    object: Option<String>,
    /// y points down in the file, as on screens
    #[arg(long)]
    y_down: bool,
    #[command(flatten)]
    results: Results,
}

fn hole(text: &str) -> Result<Point, String> {
    pair(text).map(Point::from)
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.results.check(&args.file)?;
    let mend = args.mend || args.split_crossings;
    let options = ReadOptions {
        y_down: args.y_down,
        outlines: true,
        object: args.object.clone(),
        close_rings: mend,
        format: args.from,
        ..ReadOptions::default()
    };
    let source = source_name(&args.file);
    let mut read = read_path(&args.file, &options)?;
    let had_rings_mended = read.mended_rings() > 0;
    let Document::Segments(soup) = &mut read.document else {
        let what = format!("{source}: {} holds no segments", read.format);
        return Err(Failure::input(
            what,
            "build takes wkt, poly, segments, geojson and topojson; for others see dcel convert",
        ));
    };
    refuse_object(args.object.as_deref(), Some(read.format), &source)?;
    read.notes.iter().for_each(|note| say("note", note));
    if args.grid.is_some() && !mend {
        return Err(Failure::input("--grid is for segments that are split", "give --mend, too"));
    }
    let how = ArrangeOptions { split: mend, grid: args.grid, ..ArrangeOptions::default() };
    // Points of the call are given as the file has its points.
    let holes = args.holes.iter().map(|&p| if args.y_down { Point::new(p.x, 0.0 - p.y) } else { p });
    soup.hole_points.extend(holes);
    let soup = &*soup;
    let mut arranged = arrange_with(soup, &how).map_err(|error| refused(soup, error))?;
    if args.nested_holes && arranged.subdivision.mark_nested_holes().is_empty() {
        say("note", "no ring lies inside another: --nested-holes marks nothing");
    }
    if mend && is_as_given(&arranged) && !had_rings_mended {
        say("note", NOTHING_TO_MEND);
    }
    args.results.draw(&args.file, "Segments", out, |options| {
        figure::structure(&arranged.subdivision, &options).map_err(|error| Failure::about(&source, error))
    })?;
    let s = &arranged.subdivision;
    let lone = s.dangles_and_cut_edges();
    let answer = fields! {
        source,
        format: read.format.name(),
        segments: soup.segments.len(),
        vertices: s.vertex_count(),
        edges: s.edge_count(),
        faces: s.face_count(),
        components: components(s).count(),
        euler: s.vertex_count() as i64 - s.edge_count() as i64 + s.face_count() as i64,
        hole_faces: names(s.hole_faces()),
        isolated_vertices: names(s.vertices().filter(|&v| s.outgoing(v).is_none())),
        // Segments by input number, from 0.
        zero_length: &arranged.zero_length,
        repeated: arranged.repeated.iter().map(|(segment, repeats)| fields! { segment, repeats }).collect::<Vec<_>>(),
        crossings: names(arranged.crossings.iter()),
        moved: Moved::all(&arranged.moved),
        // The distance of neighbours of the grid, if points were rounded to one.
        grid: arranged.grid,
        // Vertices of the input that the grid moved.
        displaced: Moved::all(&arranged.displaced),
        // How many points of the input moved; some fell together.
        displaced_points: arranged.displaced_points,
        // Segments that became a point on the grid, by input number.
        collapsed: &arranged.collapsed,
        // No point of a segment is further from what it became.
        farthest: arranged.farthest,
        rounds: arranged.rounds,
        dangles: names(lone.dangles.iter()),
        cut_edges: names(lone.cut_edges.iter()),
    };
    let say_notes = || describe(&arranged).iter().for_each(|note| say("note", note));
    if args.results.is_text() {
        say_notes();
    }
    args.results.finish(&Model::planar(s), &answer, out, |out| {
        let segments = counted(answer.segments, "segment", "segments");
        writeln!(out, "{}: plane, {}, {segments}", answer.source, answer.format)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        line("vertices", answer.vertices.to_string())?;
        line("edges", answer.edges.to_string())?;
        line("faces", format!("{} (with the outer face)", answer.faces))?;
        line("components", answer.components.to_string())?;
        line("euler", format!("V - E + F = {}", answer.euler))?;
        for (what, list) in [
            ("hole faces", &answer.hole_faces),
            ("isolated", &answer.isolated_vertices),
            ("dangles", &answer.dangles),
            ("cut edges", &answer.cut_edges),
        ] {
            if !list.is_empty() {
                line(what, listed(list))?;
            }
        }
        say_notes();
        Ok(())
    })
}

/// The error, and the faults after the first one with their places.
fn refused(soup: &SegmentSoup, error: LoadError) -> Failure {
    let rest: Vec<String> = match &error {
        LoadError::Segments { error: SegmentsError::Faults { faults, .. }, .. } => {
            faults_with_places(soup, &faults[1..]).collect()
        }
        _ => Vec::new(),
    };
    Failure::from(error).with_notes(rest)
}

/// `3: e4 e7 e9`, of a long list the first ones.
fn listed(names: &[String]) -> String {
    const SHOWN: usize = 10;
    let first = names[..names.len().min(SHOWN)].join(" ");
    let rest = if names.len() > SHOWN { " ..." } else { "" };
    format!("{}: {first}{rest}", names.len())
}
