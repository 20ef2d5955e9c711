//! Why a command could not do its work.
//!
//! ```text
//!   error: mesh.obj:17: faces 3 and 5 both run from vertex 2 to vertex 4: reverse face 5
//!   note: counted from 0; face 5: line 19
//!   help: ...
//! ```

use dcel_kit::io::{LoadError, ReadError, WriteError};
use dcel_kit::plane::{ConvertError, SegmentsError};
use dcel_kit::solid::SolidError;
use dcel_kit::topology::BuildError;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// A failure with its exit code.
#[derive(Debug)]
pub(crate) struct Failure {
    kind: Kind,
    what: String,
    notes: Vec<String>,
    help: String,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// The reader of the answer has gone: nobody is left to tell.
    NobodyListens,
    /// Usage or input.
    Input,
    /// The machine.
    Machine,
    /// A signal ended the work in order.
    Signal(u8),
}

impl Failure {
    /// A wrong call or a wrong input: exit code 2.
    pub(crate) fn input(what: impl Display, help: impl Into<String>) -> Self {
        Self { kind: Kind::Input, what: what.to_string(), notes: Vec::new(), help: help.into() }
    }

    /// The machine refused to write: exit code 3, or 0 if the reader of the answer has gone.
    pub(crate) fn writing(target: impl Display, error: &io::Error) -> Self {
        let kind = if error.kind() == io::ErrorKind::BrokenPipe { Kind::NobodyListens } else { Kind::Machine };
        let help = match error.kind() {
            io::ErrorKind::NotFound => "make the directory first",
            io::ErrorKind::IsADirectory => "give the name of a file in it",
            io::ErrorKind::PermissionDenied => "choose a place that you may write to",
            io::ErrorKind::StorageFull => "make room, or write elsewhere",
            _ => "",
        };
        Self { kind, what: format!("{target}: cannot be written: {error}"), notes: Vec::new(), help: help.to_owned() }
    }

    /// The machine lacks something that the work needs: exit code 3.
    pub(crate) fn machine(what: impl Display, help: impl Into<String>) -> Self {
        Self { kind: Kind::Machine, what: what.to_string(), notes: Vec::new(), help: help.into() }
    }

    /// The kit failed at its own work, whatever the input: exit code 3.
    pub(crate) fn kit(error: impl Display) -> Self {
        Self::machine(error, "this should not happen: please report it with the command you gave")
    }

    /// A signal asked for an end before all was done: exit code 128 and the number of the signal, as shells have it.
    pub(crate) fn signal(signal: u8, what: impl Display, help: impl Into<String>) -> Self {
        Self { kind: Kind::Signal(signal), what: what.to_string(), notes: Vec::new(), help: help.into() }
    }

    /// The same with more to tell, before the help.
    pub(crate) fn with_notes(mut self, notes: impl IntoIterator<Item = String>) -> Self {
        self.notes.extend(notes);
        self
    }

    /// Tells it on stderr.
    pub(crate) fn report(&self) -> ExitCode {
        if self.kind != Kind::NobodyListens {
            say("error", &self.what);
            self.notes.iter().for_each(|note| say("note", note));
            if !self.help.is_empty() {
                say("help", &self.help);
            }
        }
        match self.kind {
            Kind::NobodyListens => ExitCode::SUCCESS,
            Kind::Input => ExitCode::from(2),
            Kind::Machine => ExitCode::from(3),
            Kind::Signal(signal) => ExitCode::from(128 + signal),
        }
    }
}

/// One line of talk on stderr. Nobody has to listen.
pub(crate) fn say(what: &str, text: impl Display) {
    let _ = writeln!(io::stderr().lock(), "{what}: {text}");
}

/// Writing to standard output.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::writing("<stdout>", &error)
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        io::Error::from(error).into()
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let help = error.help.to_string();
        let place = ReadError { help: "".into(), ..error };
        Self::input(place, help)
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        let (place, notes) = match &error {
            LoadError::Read(error) => return error.clone().into(),
            LoadError::Table { source_name, .. } => (source_name.clone(), Vec::new()),
            LoadError::Holes { place, .. } => (place.clone(), Vec::new()),
            other => other.whereabouts().map_or_else(Default::default, |at| {
                let others: Vec<_> = at.others.iter().map(|(element, place)| format!("{element}: {place}")).collect();
                let counted = format!("counted from 0; {}", others.join(", "));
                (at.first.clone(), if others.is_empty() { Vec::new() } else { vec![counted] })
            }),
        };
        let what = error.what();
        let (what, own_help) = what.split_once("; ").unwrap_or((&what, ""));
        let help = flags(&error).map_or_else(|| own_help.to_owned(), str::to_owned);
        Self { notes, ..Self::input(format!("{place}: {what}"), help) }
    }
}

/// The options that help with an input.
fn flags(error: &LoadError) -> Option<&'static str> {
    match error {
        LoadError::Segments { error: SegmentsError::Faults { .. }, .. } => {
            Some("split segments where they meet with --mend")
        }
        LoadError::Surface { error: SolidError::Winding { .. }, .. } => {
            Some("list its corners the other way round, or turn all faces that need it with --orient")
        }
        LoadError::Plane { error: ConvertError::Clockwise { .. }, .. } => Some(
            "list its corners the other way round, or try --orient, or --y-down if y points down in the file, \
             or --surface if it is a surface in space",
        ),
        LoadError::Plane { error, .. } => match error {
            ConvertError::Geometry(_)
            | ConvertError::SelfCrossing { .. }
            | ConvertError::SelfTouching { .. }
            | ConvertError::OverlapAtEdge { .. }
            | ConvertError::OverlapAtVertex { .. }
            | ConvertError::HoleOutside { .. }
            | ConvertError::InPieces { .. }
            | ConvertError::InsideFace { .. } => Some(MEND),
            ConvertError::ZeroArea { .. } => Some("remove it, or leave out all that has no area with --mend"),
            ConvertError::Build(
                BuildError::RepeatedVertex { .. } | BuildError::SameFaceTwice { .. } | BuildError::ThreeFaces { .. },
            ) => Some(MEND),
            _ => None,
        },
        _ => None,
    }
}

/// What helps polygons that do not fit together.
const MEND: &str = "correct the data, or cut the polygons where they meet with --mend";

impl Failure {
    /// A structure that a format cannot hold, or a file that cannot be written.
    pub(crate) fn of_writing(target: &Path, error: WriteError) -> Self {
        let name = if target.as_os_str() == "-" { "<stdout>".into() } else { target.display().to_string() };
        match error {
            WriteError::Io(error) => Self::writing(name, &error),
            other => {
                let what = other.to_string();
                let (what, help) = what.split_once("; ").unwrap_or((&what, ""));
                Self::input(format!("{name}: {what}"), help)
            }
        }
    }
}
