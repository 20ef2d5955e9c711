//! The input of a command: a file and how to read it.

use super::failure::{Failure, say};
use super::subject::{Kind, Subject};
use dcel_kit::FaceMap;
use dcel_kit::io::{
    Document, Format, LoadError, LoadOptions, Read, ReadOptions, Structure, assemble, read_path, source_name,
};
use dcel_kit::topology::Mode;
use std::path::Path;

/// How to read a file.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Reading")]
pub(crate) struct InputOptions {
    /// The format, if the name does not tell
    #[arg(long, value_name = "FORMAT")]
    format: Option<Format>,
    /// y points down in the file, as on screens
    #[arg(long)]
    y_down: bool,
    /// Leave out rings that enclose nothing
    #[arg(long)]
    drop_degenerate_rings: bool,
    /// Turn round faces that run clockwise, or against the rest of a surface
    #[arg(long)]
    orient: bool,
    /// The object of a TopoJSON file to read
    #[arg(long, value_name = "NAME")]
    object: Option<String>,
    /// Read as a surface in space, even if it is flat
    #[arg(long, conflicts_with = "plane")]
    surface: bool,
    /// Read as a subdivision of the plane: drop z
    #[arg(long)]
    plane: bool,
    /// Split segments where they cross, touch or overlap
    #[arg(long)]
    split_crossings: bool,
    /// Check all edges of a plane against each other
    #[arg(long)]
    full_check: bool,
}

/// What comes out of a file.
pub(crate) enum Opened {
    /// Something to work with.
    Subject(Box<Subject>),
    /// A file that could be read, and whose polygons do not fit together.
    Misfit(LoadError),
}

impl InputOptions {
    /// The same without the full check, for those who make it themselves.
    pub(crate) fn without_full_check(&self) -> Self {
        Self { full_check: false, ..self.clone() }
    }

    /// The same for those who work on surfaces in space only.
    pub(crate) fn as_surface(&self) -> Self {
        Self { surface: true, plane: false, ..self.clone() }
    }

    /// Reads a file. Tables stay tables, with the ids of the file, right or wrong. Tells the notes on stderr.
    pub(crate) fn open(&self, file: &Path) -> Result<Subject, Failure> {
        self.open_as(file, true)
    }

    /// The same; unless `keep_tables`, a table must be a subdivision of the plane and becomes one.
    pub(crate) fn open_as(&self, file: &Path, keep_tables: bool) -> Result<Subject, Failure> {
        match self.try_open(file, keep_tables)? {
            Opened::Subject(subject) => Ok(*subject),
            Opened::Misfit(error) => Err(error.into()),
        }
    }

    /// The same, for those who want to say more about a misfit.
    pub(crate) fn try_open(&self, file: &Path, keep_tables: bool) -> Result<Opened, Failure> {
        let options = self.load_options();
        let read = read_path(file, &options.read)?;
        let source = source_name(file);
        if matches!(read.document, Document::Table(_)) && (self.surface || self.plane || self.orient) {
            say("note", "--surface, --plane and --orient are for polygons; a table says itself what it is");
        }
        let loaded = match read {
            Read { document: Document::Table(table), notes, format } if keep_tables => {
                notes.iter().for_each(|note| say("note", note));
                let (names, places) = (FaceMap::default(), None);
                return Ok(Opened::Subject(Box::new(Subject {
                    kind: Kind::Table(table),
                    names,
                    source,
                    format,
                    places,
                })));
            }
            read => match assemble(read, &source, &options) {
                Ok(loaded) => loaded,
                Err(error) => return Ok(Opened::Misfit(error)),
            },
        };
        loaded.notes.iter().for_each(|note| say("note", note));
        let kind = match loaded.structure {
            Structure::Plane(subdivision) => Kind::Plane(subdivision),
            Structure::Surface(polyhedron) => Kind::Surface(polyhedron),
            other => return Err(Failure::input(format!("{source}: {other:?} is not known"), "")),
        };
        let (names, format, places) = (loaded.names, loaded.format, loaded.places);
        Ok(Opened::Subject(Box::new(Subject { kind, names, source, format, places })))
    }

    /// Whether y points down in the file.
    pub(crate) fn y_down(&self) -> bool {
        self.y_down
    }

    /// How the file itself is read.
    pub(crate) fn read_options(&self) -> ReadOptions {
        self.load_options().read
    }

    fn load_options(&self) -> LoadOptions {
        let mode = match (self.plane, self.surface) {
            (true, _) => Some(Mode::Plane),
            (_, true) => Some(Mode::Surface),
            _ => None,
        };
        let read = ReadOptions {
            y_down: self.y_down,
            drop_degenerate_rings: self.drop_degenerate_rings,
            object: self.object.clone(),
            outlines: false,
            format: self.format,
        };
        let split_crossings = self.split_crossings;
        LoadOptions { read, orient: self.orient, split_crossings, full_check: self.full_check, mode }
    }
}
