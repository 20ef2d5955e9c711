//! What the commands on solids share: reading, writing, and the short answer.

use crate::choice::numbers;
use crate::output::counts;
use crate::save::{Files, InPlace, save_as};
use crate::subject::Kind;
use crate::{Answer, Failure, InputOptions, Output, fields, tell};
use dcel_kit::io::{Document, Format, Model, ReadOptions, ReadProblem, read_path, source_name};
use dcel_kit::solid::{Direction, PartCounts, Polyhedron};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Reads a surface in space.
pub(crate) fn open(file: &Path, input: &InputOptions) -> Result<Polyhedron, Failure> {
    // What mends polygons of the plane mends no surface.
    let opened = input.as_surface().open_as(file, false).map_err(|failure| failure.without_advice(" or --mend"));
    let subject = opened?;
    match subject.kind {
        Kind::Surface(polyhedron) => Ok(polyhedron),
        Kind::Plane(_) | Kind::Table(_) => {
            let what = format!("{}: {} holds a structure of the plane", subject.source, subject.format);
            Err(Failure::input(what, "solids are read from obj, off, ply and stl"))
        }
    }
}

/// Reads the points of a file of a surface in space.
pub(crate) fn points_in_space(file: &Path) -> Result<Vec<[f64; 3]>, Failure> {
    const HELP: &str = "hulls are made of the points of obj, off, ply and stl, told by the end of the name";
    let read = read_path(file, &ReadOptions::default()).map_err(|error| match *error.what {
        ReadProblem::UnknownFormat => Failure::from(error).helped_by(HELP),
        _ => error.into(),
    })?;
    match read.document {
        Document::Polygons(soup) => Ok(soup.points),
        Document::Segments(_) | Document::Table(_) | Document::Columns(_) => {
            let what = format!("{}: this holds points of the plane", source_name(file));
            Err(Failure::input(what, HELP))
        }
    }
}

/// Refuses so many steps of subdivision that the surface would be too large: each makes four edges of one.
pub(crate) fn check_finer(solid: &Polyhedron, steps: u8) -> Result<(), Failure> {
    check_size("the finer surface", solid.edge_count().saturating_mul(1 << (2 * steps)), "take fewer steps")
}

/// Where a solid goes.
#[derive(clap::Args, Clone, Debug)]
pub(super) struct Target {
    /// The file to write, for example .off; - for OFF on standard output instead of the report
    #[arg(short, long, value_name = "OUT")]
    pub(super) output: Option<PathBuf>,
    /// The format to write, if the file name does not say, for example stl-binary
    #[arg(long, value_name = "FORMAT", requires = "output")]
    to: Option<Format>,
    #[command(flatten)]
    in_place: InPlace,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

impl Target {
    /// Refuses to write over the input, if there is one, unless that is said.
    pub(super) fn check(&self, input: Option<&Path>) -> Result<(), Failure> {
        Files::reading(input).writes_or_replaces("-o", self.output.as_deref(), self.in_place).check()
    }

    /// Writes the solid, if asked to, and tells what it is.
    pub(super) fn put(
        &self,
        name: &str,
        solid: &Polyhedron,
        note: Option<&str>,
        out: &mut Output,
    ) -> Result<Answer, Failure> {
        if let Some(path) = &self.output {
            save(path, self.to, solid, out)?;
            if path.as_os_str() == "-" {
                return Ok(Answer::Yes);
            }
        }
        let parts = solid.parts();
        let sum = |of: fn(&PartCounts) -> i64| parts.iter().map(of).sum::<i64>();
        let answer = fields! {
            vertices: solid.vertex_count(),
            edges: solid.edge_count(),
            faces: solid.polygon_faces().count(),
            euler: sum(PartCounts::euler),
            genus: sum(PartCounts::genus),
            borders: solid.boundary_faces().len(),
            #[serde(flatten)]
            note: note.map(|note| fields! { note }),
            #[serde(flatten)]
            output: self.output.as_ref().map(|path| fields! { output: path.display().to_string() }),
        };
        tell(&answer, self.json, out, |out| {
            let counts = counts([answer.vertices, answer.edges, answer.faces]);
            writeln!(out, "{name}: {counts}; V - E + F = {}, genus {}", answer.euler, answer.genus)?;
            note.iter().try_for_each(|note| writeln!(out, "  {note}"))?;
            self.output.iter().try_for_each(|path| writeln!(out, "  written to {}", path.display()))
        })
    }
}

fn save(path: &Path, to: Option<Format>, solid: &Polyhedron, out: &mut Output) -> Result<(), Failure> {
    let model = Model::surface(solid, |v| Some(solid.point(v)), |f| solid.is_boundary_face(f));
    let help = "end it in .off, .obj, .ply or .stl, or say it with --to";
    save_as(path, to, Format::Off, help, &model, out)
}

/// Refuses what would fill the memory of a small machine.
pub(super) fn check_size(name: &str, elements: usize, help: &str) -> Result<(), Failure> {
    /// A solid with so many edges takes about two gigabytes on its way.
    const MOST: usize = 20_000_000;
    if elements <= MOST {
        return Ok(());
    }
    let many = if elements < usize::MAX / 2 {
        format!("{elements} edges")
    } else {
        "more edges than there are ids".to_owned()
    };
    Err(Failure::input(format!("{name} would have {many}, and this command makes at most {MOST}"), help))
}

/// A vector from the command line: `1,-2,0.5`.
pub(crate) fn vector(text: &str) -> Result<[f64; 3], String> {
    numbers(text).ok_or_else(|| "write three numbers with commas between, for example 1,-2,0.5".to_owned())
}

/// A direction in which some vertices can lie further than others.
pub(crate) fn direction(numbers: [f64; 3]) -> Result<Direction, Failure> {
    if numbers.iter().all(|&x| x == 0.0) {
        return Err(Failure::input("0,0,0 is no direction: all vertices lie equally far in it", "for example: 0,0,1"));
    }
    Direction::try_from(numbers)
        .map_err(|error| Failure::input(format!("the direction: {error}"), "only its way counts, not its length"))
}
