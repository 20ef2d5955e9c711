//! The input of a command: a file and how to read it.

use super::failure::{Failure, say};
use super::subject::{Kind, Subject};
use dcel_kit::io::{
    Document, Format, LoadError, LoadOptions, PointList, Read, ReadError, ReadOptions, ReadProblem, Structure,
    assemble, points_from_text, read_path, read_points, read_whole, source_name,
};
use dcel_kit::topology::Mode;
use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

/// How to read a file.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Reading")]
pub(crate) struct InputOptions {
    /// The format, if the file name does not say
    #[arg(long, value_name = "FORMAT")]
    format: Option<Format>,
    /// y points down in the file, as on screens
    #[arg(long)]
    pub(crate) y_down: bool,
    /// Leave out rings that enclose nothing: without three distinct points, or on one line; an outer ring takes its
    /// polygon with it
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
    /// Split polygons and segments where they cross, touch or overlap; reports what was done. Each face is named after
    /// all polygons that cover it. Rings that enclose nothing are left out; where the outer one is, the others are outlines
    #[arg(long)]
    mend: bool,
    /// The same as --mend
    #[arg(long)]
    split_crossings: bool,
    /// Believe that polygons do not overlap: check only those that meet
    #[arg(long, conflicts_with_all = ["mend", "split_crossings"])]
    pub(crate) trust: bool,
    /// What is done anyway, unless --trust is given
    #[arg(long, conflicts_with = "trust")]
    full_check: bool,
    /// Whether the command itself asks for a surface, and whether --plane was given to it all the same.
    #[arg(skip)]
    only_surfaces: bool,
    #[arg(skip)]
    plane_in_vain: bool,
}

/// A structure; or what the file holds is none, for this reason.
pub(crate) type Opened = Result<Subject, LoadError>;

impl InputOptions {
    /// Whether polygons and segments are split where they meet.
    fn mends(&self) -> bool {
        self.mend || self.split_crossings
    }

    /// Splits polygons and segments where they meet, and asks for nothing else.
    pub(crate) fn mending() -> Self {
        Self { mend: true, ..Self::default() }
    }

    /// The same for those who work on surfaces in space only.
    pub(crate) fn as_surface(&self) -> Self {
        let (only_surfaces, plane_in_vain) = (!self.surface, self.plane);
        Self { surface: true, plane: false, only_surfaces, plane_in_vain, ..self.clone() }
    }

    /// Reads a file. Tables stay tables, with the ids of the file, right or wrong. Prints the notes on stderr.
    pub(crate) fn open(&self, file: &Path) -> Result<Subject, Failure> {
        self.open_as(file, true)
    }

    /// The same; unless `keep_tables`, a table must be a subdivision of the plane and becomes one.
    pub(crate) fn open_as(&self, file: &Path, keep_tables: bool) -> Result<Subject, Failure> {
        Ok(self.try_open(file, keep_tables)??)
    }

    /// The same for one of several files: each note says which it is about.
    pub(crate) fn open_one_of(&self, file: &Path, keep_tables: bool) -> Result<Subject, Failure> {
        let source = source_name(file);
        Ok(self.load(file, keep_tables, &|note| say("note", format_args!("{source}: {note}")))??)
    }

    /// The same, for those who want to say more about a misfit.
    pub(crate) fn try_open(&self, file: &Path, keep_tables: bool) -> Result<Opened, Failure> {
        self.load(file, keep_tables, &|note| say("note", note))
    }

    fn load(&self, file: &Path, keep_tables: bool, tell: &dyn Fn(&str)) -> Result<Opened, Failure> {
        let options = self.load_options();
        let columns = ReadOptions { columns: true, ..options.read.clone() };
        let read = read_path(file, &columns).map_err(|error| unread(file, error))?;
        let source = source_name(file);
        self.refuse_useless(&read, &source)?;
        if self.full_check {
            say("note", "--full-check is not needed: planes are always fully checked, unless --trust is given");
        }
        let loaded = match read {
            Read { document: Document::Columns(table), notes, format } if keep_tables => {
                notes.iter().for_each(|note| tell(note));
                return Ok(Ok(Subject::of_table(table, source, format)));
            }
            read => {
                let notes = read.notes.clone();
                match assemble(read, &source, &options) {
                    Ok(loaded) => loaded,
                    Err(LoadError::Read(error)) => return Err(error.into()),
                    Err(error) => {
                        // That the file was cut off may be the very reason.
                        notes.iter().for_each(|note| tell(note));
                        return Ok(Err(error));
                    }
                }
            }
        };
        loaded.notes.iter().for_each(|note| tell(note));
        let kind = match loaded.structure {
            Structure::Plane(subdivision) => Kind::Plane(subdivision),
            Structure::Surface(polyhedron) => Kind::Surface(polyhedron),
            other => return Err(Failure::input(format!("{source}: {other:?} is not known"), "")),
        };
        let (names, covering, format, places) = (loaded.names, loaded.covering, loaded.format, loaded.places);
        let (trusted, left_out) = (self.trust, loaded.left_out);
        Ok(Ok(Subject { kind, names, covering, trusted, source, format, places, left_out }))
    }

    /// A flag that cannot do anything with this kind of input is an error, so that nobody believes it did.
    fn refuse_useless(&self, read: &Read, source: &str) -> Result<(), Failure> {
        let format = read.format;
        let (polygons, plane) = match &read.document {
            Document::Polygons(soup) => (true, !self.surface && (self.plane || !soup.has_z)),
            Document::Segments(_) => (false, true),
            Document::Table(_) | Document::Columns(_) => (false, false),
        };
        let segments = matches!(read.document, Document::Segments(_));
        let has_rings = matches!(format, Format::GeoJson | Format::TopoJson) || (format == Format::Wkt && polygons);
        let table = "a table of half-edges says itself what it is";
        let lines = "segments have no faces yet";
        let why = if segments { lines } else { table };
        let flags = [
            ("--surface", self.surface && !self.only_surfaces && !polygons, why),
            ("--plane", self.plane_in_vain, "this command takes surfaces in space"),
            ("--plane", self.plane && !polygons, why),
            ("--orient", self.orient && !polygons, why),
            (
                "--trust",
                self.trust && !(polygons && plane),
                match (segments, polygons) {
                    (true, _) => "there are no polygons in it, and segments are always checked",
                    (_, true) => "it is for polygons in the plane",
                    _ => "a table is checked while it becomes a structure",
                },
            ),
            (
                if self.mend { "--mend" } else { "--split-crossings" },
                self.mends() && !plane,
                match polygons {
                    true if self.only_surfaces => "it is for polygons in the plane",
                    true => "it is for polygons in the plane; drop z with --plane",
                    false => "it is for polygons and segments; for a table, dcel validate names what is broken",
                },
            ),
            (
                "--drop-degenerate-rings",
                self.drop_degenerate_rings && !has_rings,
                "it is for polygons of GeoJSON, TopoJSON and WKT",
            ),
        ];
        match flags.into_iter().find(|&(_, useless, _)| useless) {
            Some((flag, _, why)) => Err(Failure::input(
                format!("{source}: {flag} cannot be used on {format}: {why}"),
                format!("leave {flag} out"),
            )),
            None => refuse_object(self.object.as_deref(), Some(format), source),
        }
    }

    /// Reads the points of a file, of which nothing else is wanted. Prints the notes on stderr.
    pub(crate) fn points(&self, file: &Path) -> Result<PointList, Failure> {
        let list = read_points(file, &self.for_raw("only the points of the file are read")?)?;
        refuse_object(self.object.as_deref(), list.format, &list.source)?;
        list.notes.iter().for_each(|note| say("note", note));
        Ok(list)
    }

    /// How to read a file of which no structure is made; `why` says so.
    pub(crate) fn for_raw(&self, why: &str) -> Result<ReadOptions, Failure> {
        let flags = [
            ("--drop-degenerate-rings", self.drop_degenerate_rings),
            ("--full-check", self.full_check),
            ("--plane", self.plane),
            ("--mend", self.mend),
            ("--split-crossings", self.split_crossings),
            ("--trust", self.trust),
            ("--orient", self.orient),
            ("--surface", self.surface),
        ];
        match flags.into_iter().find(|flag| flag.1) {
            Some((flag, _)) => {
                let what = format!("{flag} cannot be used here: {why}");
                Err(Failure::input(what, format!("leave {flag} out")))
            }
            None => Ok(self.load_options().read),
        }
    }

    /// The first flag that is given, if any.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let flags = [
            ("--format", self.format.is_some()),
            ("--y-down", self.y_down),
            ("--drop-degenerate-rings", self.drop_degenerate_rings),
            ("--orient", self.orient),
            ("--object", self.object.is_some()),
            ("--surface", self.surface),
            ("--plane", self.plane),
            ("--mend", self.mend),
            ("--split-crossings", self.split_crossings),
            ("--trust", self.trust),
            ("--full-check", self.full_check),
        ];
        flags.into_iter().find(|(_, given)| *given).map(|(flag, _)| flag)
    }

    fn load_options(&self) -> LoadOptions {
        let mode = match (self.plane, self.surface) {
            (true, _) => Some(Mode::Plane),
            (_, true) => Some(Mode::Surface),
            _ => None,
        };
        let read = ReadOptions {
            y_down: self.y_down,
            drop_degenerate_rings: self.drop_degenerate_rings || self.mends(),
            keep_inner_rings: self.mends(),
            close_rings: self.mends(),
            object: self.object.clone(),
            outlines: false,
            columns: false,
            format: self.format,
        };
        LoadOptions { read, orient: self.orient, mend: self.mends(), trust: self.trust, mode }
    }
}

/// The failure of a file that was not read. Points alone are in no format of structures, but they are known.
fn unread(file: &Path, error: ReadError) -> Failure {
    let has_points = || points_from_text(&read_whole(file).ok()?, "").ok().filter(|list| !list.points.is_empty());
    if matches!(*error.what, ReadProblem::UnknownFormat) && file != Path::new("-") && has_points().is_some() {
        return Failure::from(error).helped_by(
            "points alone have no faces: dcel delaunay joins them to triangles, dcel voronoi makes their cells",
        );
    }
    error.into()
}

/// The text of a file that belongs to the command, and not to what it computes.
pub(crate) fn text_of(file: &Path, help: &str) -> Result<String, Failure> {
    std::fs::read_to_string(file).map_err(|error| Failure::input(format!("{}: {error}", file.display()), help))
}

/// Refuses the name of an object where the file has none.
pub(crate) fn refuse_object(object: Option<&str>, format: Option<Format>, source: &str) -> Result<(), Failure> {
    if object.is_none() || format == Some(Format::TopoJson) {
        return Ok(());
    }
    let format = format.map_or("plain points", Format::name);
    let what = format!("{source}: --object cannot be used on {format}: only TopoJSON files have objects");
    Err(Failure::input(what, "leave --object out"))
}

/// The files of a folder whose names end so, in order.
pub(crate) fn files_ending(dir: &Path, end: &str) -> io::Result<BTreeSet<PathBuf>> {
    let paths = std::fs::read_dir(dir)?.map(|entry| entry.map(|entry| entry.path())).collect::<io::Result<Vec<_>>>()?;
    Ok(paths.into_iter().filter(|path| path.extension().is_some_and(|other| other == end)).collect())
}
