//! `dcel convert`: from one format to another.

use super::save::{Files, InPlace, save_as};
use super::subject::{Kind, Subject};
use super::{Answer, Failure, InputOptions, Output, say};
use dcel_kit::FaceMap;
use dcel_kit::io::{Format, LoadError, counted, losses};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use std::path::PathBuf;

/// Write a structure in another format
///
/// Formats: obj, off, ply, ply-binary, stl, stl-binary, triangle, geojson, mesh, dcel, tables. Polygon
/// formats hold no structure: ids are numbered anew when such a file is read, and what they cannot hold is refused
/// by name. What is lost without harm is noted. A broken .dcel is written as dcel only; validate names
/// what is broken. A grid map (.map) has y pointing down: a .mesh made of
/// it, too, so that the queries of the map fit both; in all other formats y is negated.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel convert square.obj square.dcel
  dcel convert square.obj - --to tables
  dcel convert square.dcel small.dcel --compact")]
pub(crate) struct Args {
    /// The file to read, or - for standard input
    #[arg(value_name = "IN")]
    file: PathBuf,
    /// The file to write, or - for standard output
    #[arg(value_name = "OUT")]
    to_file: PathBuf,
    /// The format to write, if the file name does not say
    #[arg(long, value_name = "FORMAT")]
    to: Option<Format>,
    /// Number all elements anew, without gaps, along a walk
    #[arg(long)]
    compact: bool,
    #[command(flatten)]
    in_place: InPlace,
    #[command(flatten)]
    input: InputOptions,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let format = target_format(args)?;
    let node = (format == Format::Triangle).then(|| args.to_file.with_extension("node"));
    Files::reading([&args.file])
        .writes_or_replaces("OUT", Some(node.as_deref().unwrap_or(&args.to_file)), args.in_place)
        .check()?;
    let mut subject = args.input.open_as(&args.file, !args.compact)?;
    if format != Format::Dcel {
        refuse_broken(&subject)?;
    }
    if args.compact {
        compact(&mut subject);
    }
    let is_map = matches!(subject.format, Format::Map | Format::Mesh);
    if format == Format::Mesh && is_map {
        let lost = subject.left_out.notes(false).into_iter().chain(losses(&subject.model(), format));
        lost.for_each(|note| say("note", note));
        keep_polygons(&mut subject)?;
    }
    // The format is known: no name is asked for.
    save_as(&args.to_file, Some(format), format, "", &subject.model(), out)?;
    if format != Format::Mesh || !is_map {
        subject.left_out.notes(format == Format::GeoJson).iter().for_each(|note| say("note", note));
    }
    if subject.format == Format::Map {
        tell_direction(args, format == Format::Mesh);
    }
    Ok(Answer::Yes)
}

fn target_format(args: &Args) -> Result<Format, Failure> {
    let stdout = args.to_file.as_os_str() == "-";
    let by_name = || Format::from_path(&args.to_file).filter(|_| !stdout);
    args.to.or_else(by_name).ok_or_else(|| {
        let writable: Vec<_> = Format::ALL.into_iter().filter(|f| f.can_write()).map(Format::name).collect();
        let what = match stdout {
            true => "<stdout>: the format to write is not known".to_owned(),
            false => format!("{}: the file name does not say which format to write", args.to_file.display()),
        };
        Failure::input(what, format!("say it with --to: {}", writable.join(", ")))
    })
}

/// Only dcel text may hold a broken structure. The ids stay those of the file, so the table itself is written.
fn refuse_broken(subject: &Subject) -> Result<(), Failure> {
    let Kind::Table(table) = &subject.kind else { return Ok(()) };
    let made = Subdivision::from_columns(&mut table.clone());
    made.map(drop).map_err(|error| LoadError::Table { source_name: subject.source.clone(), error }.into())
}

/// Makes of a map what a navigation mesh of version 2 holds: its polygons to walk on, and nothing but them. Of a grid
/// map, whose y points down, it keeps the points: so the queries of a scenario fit both.
fn keep_polygons(subject: &mut Subject) -> Result<(), Failure> {
    let Kind::Plane(map) = &subject.kind else { return Ok(()) };
    let down = subject.format == Format::Map;
    let (mut points, mut faces, mut corners) = (Vec::new(), PolygonList::new(), Vec::new());
    let domain = || map.faces().filter(|&f| f != map.outer_face() && !map.is_hole(f));
    let mut used = vec![false; map.vertex_bound()];
    domain().flat_map(|f| map.incident_vertices(f)).for_each(|v| used[v.index()] = true);
    let mut numbers = vec![0; map.vertex_bound()];
    for v in map.vertices().filter(|v| used[v.index()]) {
        numbers[v.index()] = points.len() as u32;
        let p = map.point(v);
        points.push(Point::new(p.x, if down { 0.0 - p.y } else { p.y }));
    }
    let lost = map.vertex_count() - points.len();
    if lost > 0 {
        let lost = counted(lost, "point is not written: no polygon", "points are not written: no polygon");
        say("note", format!("{lost} to walk on has a corner there"));
    }
    for f in domain().filter(|&f| map.inner_components(f).is_empty()) {
        corners.clear();
        corners.extend(map.incident_vertices(f).map(|v| numbers[v.index()]));
        if down {
            corners.reverse();
        }
        faces.push_face(&corners);
    }
    if faces.face_count() < domain().count() {
        // The writer says what is in the way.
        return Ok(());
    }
    let kept = Subdivision::from_polygons(points, &faces);
    subject.kind = Kind::Plane(kept.map_err(|error| Failure::kit(format!("{}: {error}", subject.source)))?);
    subject.names = FaceMap::default();
    Ok(())
}

/// Says which way y points.
fn tell_direction(args: &Args, is_kept: bool) {
    let (from, to) = (args.file.display(), args.to_file.display());
    if is_kept {
        say(
            "note",
            format!("y points down in {to} as it does in {from}: the points, and the queries of a .scen, are the same"),
        );
    } else {
        say("note", format!("y is negated: the point (x, y) of {from} is (x, -y) in {to}, where y points up"));
    }
}

fn compact(subject: &mut Subject) {
    match &mut subject.kind {
        Kind::Plane(subdivision) => {
            let map = subdivision.compact();
            let mut names = FaceMap::default();
            for (face, name) in subject.names.iter().filter(|(_, name)| name.is_some()) {
                if let Some(&Some(new)) = map.faces.get(face) {
                    names.set(new, name.clone(), None);
                }
            }
            subject.names = names;
        }
        Kind::Surface(_) | Kind::Table(_) => say("note", "surfaces are always written without gaps, in their order"),
    }
}
