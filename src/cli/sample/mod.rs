//! `dcel sample`: small inputs to try the commands on. The examples of all help texts use them.

use super::output::table;
use super::save::put;
use super::{Answer, Failure, Output, tell};
use dcel_kit::io::closest;
use dcel_kit::sources;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Write small files to try the commands on
///
/// Without a name, lists them. The examples in the help of all commands use these files: after
/// `dcel sample --all .` they run as they stand. A file that is there already is never written over.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel sample
  dcel sample square.obj
  dcel sample cube.off -o -
  dcel sample --all samples")]
pub(crate) struct Args {
    /// Samples to write into this folder, by name
    #[arg(value_name = "NAME", conflicts_with = "all")]
    names: Vec<String>,
    /// Write all of them into a folder, which is made if it is not there
    #[arg(long, value_name = "DIR")]
    all: Option<PathBuf>,
    /// Write one sample under this name; - for standard output
    #[arg(short, long, value_name = "OUT", requires = "names", conflicts_with = "all")]
    output: Option<PathBuf>,
    /// Answer in JSON
    #[arg(long, conflicts_with = "output")]
    json: bool,
}

/// A file to try the commands on.
#[derive(Serialize)]
struct Sample {
    name: &'static str,
    about: &'static str,
    #[serde(skip)]
    bytes: &'static [u8],
}

#[rustfmt::skip]
const SAMPLES: &[Sample] = &[
    Sample { name: "square.obj", about: "a square of two triangles", bytes: include_bytes!("square.obj") },
    Sample { name: "square.dcel", about: "the same with all its pointers", bytes: include_bytes!("square.dcel") },
    Sample { name: "broken.dcel", about: "a triangle with a wrong pointer", bytes: include_bytes!("broken.dcel") },
    Sample { name: "garden.geojson", about: "polygons with names, one with a hole", bytes: include_bytes!("garden.geojson") },
    Sample { name: "fields.geojson", about: "two polygons that overlap: for --mend", bytes: include_bytes!("fields.geojson") },
    Sample { name: "parcels.geojson", about: "two neighbours, to lay a river over", bytes: include_bytes!("parcels.geojson") },
    Sample { name: "floods.geojson", about: "the river", bytes: include_bytes!("floods.geojson") },
    Sample { name: "states.json", about: "a map of the USA: y down, one ring without area", bytes: sources::STATES },
    Sample { name: "plan.poly", about: "a room with a column, as segments", bytes: include_bytes!("plan.poly") },
    Sample { name: "roads.wkt", about: "lines that cross", bytes: include_bytes!("roads.wkt") },
    Sample { name: "rings.segments", about: "rings in each other", bytes: include_bytes!("rings.segments") },
    Sample { name: "sites.xy", about: "points", bytes: include_bytes!("sites.xy") },
    Sample { name: "sites.csv", about: "points with a head line", bytes: include_bytes!("sites.csv") },
    Sample { name: "trees.xy", about: "points in and around the square", bytes: include_bytes!("trees.xy") },
    Sample { name: "colours.txt", about: "colours and labels for the faces of the square", bytes: include_bytes!("colours.txt") },
    Sample { name: "expected.svg", about: "a drawing of the square", bytes: include_bytes!("expected.svg") },
    Sample { name: "mine.svg", about: "a drawing of it without one edge", bytes: include_bytes!("mine.svg") },
    Sample { name: "lab.dcels", about: "a script: the lab's structure from a rectangle", bytes: sources::LAB.as_bytes() },
    Sample { name: "split-face.dcels", about: "a script: one split of a face", bytes: sources::SPLIT_FACE.as_bytes() },
    Sample { name: "torus.dcels", about: "a script without coordinates", bytes: include_bytes!("torus.dcels") },
    Sample { name: "rooms.map", about: "a grid map to find paths on", bytes: sources::ROOMS_MAP },
    Sample { name: "rooms.scen", about: "questions about it, with answers", bytes: sources::ROOMS_SCEN },
    Sample { name: "floor.obj", about: "a floor of two rooms in space, y up", bytes: include_bytes!("floor.obj") },
    Sample { name: "house.obj", about: "a hall, a ramp and a gallery over the hall, z up, with groups and materials", bytes: include_bytes!("house.obj") },
    Sample { name: "cube.off", about: "a solid", bytes: include_bytes!("cube.off") },
    Sample { name: "tetrahedron.off", about: "a solid of triangles", bytes: include_bytes!("tetrahedron.off") },
    Sample { name: "cloud.obj", about: "points in space", bytes: include_bytes!("cloud.obj") },
];

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if let Some(dir) = &args.all {
        std::fs::create_dir_all(dir).map_err(|error| Failure::writing(dir.display(), &error))?;
        let all: Vec<&Sample> = SAMPLES.iter().collect();
        write_into(dir, &all, args.json, out)?;
        return Ok(Answer::Yes);
    }
    if args.names.is_empty() {
        return tell(&SAMPLES, args.json, out, |out| {
            table(out, &SAMPLES.iter().map(|s| [s.name.to_owned(), s.about.to_owned()]).collect::<Vec<_>>())?;
            writeln!(out, "\n`dcel sample NAME` writes one of them, `dcel sample --all DIR` all.")
        });
    }
    let samples = args.names.iter().map(|name| named(name)).collect::<Result<Vec<_>, _>>()?;
    match (&args.output, &samples[..]) {
        (None, samples) => write_into(Path::new(""), samples, args.json, out)?,
        (Some(path), [sample]) if path.as_os_str() == "-" => out.write_all(sample.bytes)?,
        (Some(path), [sample]) => write_one(path, sample)?,
        (Some(_), more) => {
            let what = format!("-o names one file, and these are {} samples", more.len());
            return Err(Failure::input(what, "leave -o out, or write them one by one"));
        }
    }
    Ok(Answer::Yes)
}

/// A sample by its name, with or without the ending.
fn named(name: &str) -> Result<&'static Sample, Failure> {
    let by_stem = || SAMPLES.iter().find(|sample| Path::new(sample.name).file_stem().is_some_and(|stem| stem == name));
    SAMPLES.iter().find(|sample| sample.name == name).or_else(by_stem).ok_or_else(|| {
        let close = closest(name, SAMPLES.iter().map(|sample| sample.name));
        let close = close.map_or_else(String::new, |close| format!("did you mean {close}? "));
        Failure::input(format!("there is no sample `{name}`"), format!("{close}`dcel sample` lists them"))
    })
}

fn write_into(dir: &Path, samples: &[&Sample], json: bool, out: &mut Output) -> Result<(), Failure> {
    let paths: Vec<PathBuf> = samples.iter().map(|sample| dir.join(sample.name)).collect();
    for (sample, path) in samples.iter().zip(&paths) {
        is_free(path, sample)?;
    }
    for (sample, path) in samples.iter().zip(&paths) {
        write_one(path, sample)?;
    }
    if json {
        let paths: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        return out.json(&paths).map(drop);
    }
    for (sample, path) in samples.iter().zip(&paths) {
        writeln!(out, "{}: {}", path.display(), sample.about)?;
    }
    Ok(())
}

fn write_one(path: &Path, sample: &Sample) -> Result<(), Failure> {
    if is_free(path, sample)? { put(path, sample.bytes) } else { Ok(()) }
}

/// Whether there is no file of that name. One that holds something else is never lost: an error.
fn is_free(path: &Path, sample: &Sample) -> Result<bool, Failure> {
    if !std::fs::metadata(path).is_ok_and(|there| there.is_file()) {
        return Ok(true);
    }
    if std::fs::read(path).is_ok_and(|bytes| bytes == sample.bytes) {
        return Ok(false);
    }
    let what = format!("{}: is there already, and holds something else", path.display());
    Err(Failure::input(
        what,
        "move it away, or write under another name, with -o NAME, or into another folder, with --all DIR",
    ))
}
