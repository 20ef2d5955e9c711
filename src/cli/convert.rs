//! `dcel convert`: from one format to another.

use super::failure::say;
use super::input::InputOptions;
use super::save::{Files, InPlace};
use super::subject::{Kind, Subject};
use super::{Answer, Failure, Output};
use dcel_kit::FaceMap;
use dcel_kit::io::{Format, counted, write, write_path};
use std::path::PathBuf;

/// Write a structure in another format
///
/// Formats: obj, off, ply, ply-binary, stl, stl-binary, triangle, geojson, mesh, dcel, tables. Polygon
/// formats hold no structure: ids are numbered anew when such a file is read, and what they cannot hold is refused
/// by name. What is lost without harm is told.
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
    /// The format to write, if the name does not tell
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
    if args.compact {
        compact(&mut subject);
    }
    let model = subject.model();
    if args.to_file.as_os_str() == "-" {
        write(out, &model, format)
    } else {
        write_path(&args.to_file, &model, format)
    }
    .map_err(|error| Failure::of_writing(&args.to_file, error))?;
    tell_losses(&subject, format);
    Ok(Answer::Yes)
}

fn target_format(args: &Args) -> Result<Format, Failure> {
    let stdout = args.to_file.as_os_str() == "-";
    let by_name = || Format::from_path(&args.to_file).filter(|_| !stdout);
    args.to.or_else(by_name).ok_or_else(|| {
        let writable: Vec<_> = Format::ALL.into_iter().filter(|f| f.can_write()).map(Format::name).collect();
        let what = match stdout {
            true => "<stdout>: the format to write is not known".to_owned(),
            false => format!("{}: the name does not tell the format to write", args.to_file.display()),
        };
        Failure::input(what, format!("say it with --to: {}", writable.join(", ")))
    })
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

fn tell_losses(subject: &Subject, format: Format) {
    let named = subject.faces().filter(|&f| subject.name(f).is_some()).count();
    let keeps_names = matches!(format, Format::GeoJson | Format::Dcel | Format::Tables);
    if named > 0 && !keeps_names {
        let lost = counted(named, "name of a face is lost", "names of faces are lost");
        say("note", format!("{lost}: {format} has none; geojson and dcel keep them"));
    }
    let view = subject.view();
    let holes = subject.faces().filter(|&f| view.is_hole(f)).count();
    let keeps_holes = matches!(format, Format::Dcel | Format::Tables);
    if holes > 0 && !keeps_holes {
        let faces =
            counted(holes, "hole face is not written: it is a gap", "hole faces are not written: they are the gaps");
        say("note", format!("{faces} between the polygons"));
    }
}
