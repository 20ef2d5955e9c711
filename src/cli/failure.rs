//! Why a command could not do its work.
//!
//! ```text
//!   error: mesh.obj:17: faces 3 and 5 both run from vertex 2 to vertex 4: reverse face 5
//!   note: counted from 0; face 5: line 19
//!   help: ...
//! ```
//!
//! With `--json` the same goes to standard output as well, in place of the answer: see [`Failure::report_json`].

use super::Output;
use super::answer::fields;
use dcel_kit::io::{LoadError, ReadError, ReadProblem, WriteError};
use dcel_kit::plane::{ConvertError, SegmentsError};
use dcel_kit::solid::SolidError;
use dcel_kit::topology::BuildError;
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// A failure with its exit code.
#[derive(Debug)]
pub(crate) struct Failure {
    kind: Kind,
    what: String,
    /// The file that the message begins with, if it is not one that the call names.
    file: Option<String>,
    notes: Vec<String>,
    help: String,
}

/// Where in which file. Lines and columns count from 1.
#[derive(Serialize, PartialEq, Debug)]
struct Place<'a> {
    file: &'a str,
    line: Option<u32>,
    column: Option<u32>,
}

impl<'a> Place<'a> {
    /// The place with which a message begins, and the rest: `plan.obj:3:7: what`. The file is one of `files`.
    fn split(what: &'a str, files: &'a [String]) -> Option<(Self, &'a str)> {
        let begins = |file: &&String| what.strip_prefix(file.as_str()).is_some_and(|rest| rest.starts_with(':'));
        let file = files.iter().filter(begins).max_by_key(|file| file.len())?;
        let mut rest = &what[file.len() + 1..];
        let mut number = || {
            let (digits, after) = rest.split_once(':')?;
            let number = digits.parse().ok()?;
            rest = after;
            Some(number)
        };
        let line = number();
        let column = line.and_then(|_| number());
        Some((Self { file, line, column }, rest.trim_start()))
    }
}

/// Whether the call asks for JSON, so that errors are JSON, too, even where the call is wrong.
pub(crate) fn is_json_wanted() -> bool {
    std::env::args_os().skip(1).take_while(|word| word != "--").any(|word| word == "--json")
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// The reader of the answer has gone: nobody is left to tell.
    NobodyListens,
    /// A call that cannot be understood.
    Usage,
    /// What cannot be done with this input.
    Input,
    /// The machine.
    Machine,
    /// A signal ended the work in order.
    Signal(u8),
}

impl Failure {
    /// What cannot be done with this input: exit code 2.
    pub(crate) fn input(what: impl Display, help: impl Into<String>) -> Self {
        Self::new(Kind::Input, what, help)
    }

    /// A call whose parts do not fit together: exit code 2.
    pub(crate) fn call(what: impl Display, help: impl Into<String>) -> Self {
        Self::new(Kind::Usage, what, help)
    }

    /// What is wrong with this file, or at this place in it: exit code 2.
    pub(crate) fn about(place: impl Display, error: impl Display) -> Self {
        Self::input(format!("{place}: {error}"), "")
    }

    /// An error whose words say what helps, behind a semicolon; the place stands before them.
    pub(crate) fn helped(place: impl Display, error: impl Display) -> Self {
        Self::cut(place, &error.to_string(), "; ")
    }

    /// What the kit refuses to do with this file, in words that say what helps behind a colon.
    pub(crate) fn refused(place: impl Display, error: impl Display) -> Self {
        Self::cut(format!("{place}: "), &error.to_string(), ": ")
    }

    /// What helps stands behind the mark.
    fn cut(place: impl Display, text: &str, mark: &str) -> Self {
        let (what, help) = text.split_once(mark).unwrap_or((text, ""));
        Self::input(format!("{place}{what}"), help)
    }

    fn new(kind: Kind, what: impl Display, help: impl Into<String>) -> Self {
        Self { kind, what: what.to_string(), file: None, notes: Vec::new(), help: help.into() }
    }

    /// The machine refused to write: exit code 3, or 0 if the reader of the answer has gone.
    pub(crate) fn writing(target: impl Display, error: &io::Error) -> Self {
        let kind = if error.kind() == io::ErrorKind::BrokenPipe { Kind::NobodyListens } else { Kind::Machine };
        let help = match error.kind() {
            io::ErrorKind::NotFound => "make the directory first",
            io::ErrorKind::IsADirectory => "give the name of a file in it",
            io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
                "choose a place that you may write to"
            }
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "make room, or write elsewhere",
            io::ErrorKind::FileTooLarge => "raise the limit (ulimit -f), or write less",
            _ => "",
        };
        Self::new(kind, format!("{target}: cannot be written: {error}"), help)
    }

    /// The machine lacks something that the work needs: exit code 3.
    pub(crate) fn machine(what: impl Display, help: impl Into<String>) -> Self {
        Self::new(Kind::Machine, what, help)
    }

    /// The kit failed at its own work, whatever the input: exit code 3.
    pub(crate) fn kit(error: impl Display) -> Self {
        Self::machine(error, "this should not happen: please report it with the command you gave")
    }

    /// A signal asked for an end before all was done: exit code 128 and the number of the signal, as shells have it.
    pub(crate) fn signal(signal: u8, what: impl Display, help: impl Into<String>) -> Self {
        Self::new(Kind::Signal(signal), what, help)
    }

    /// What helps, if anything is known to.
    pub(crate) fn help(&self) -> &str {
        &self.help
    }

    /// The same with other help.
    pub(crate) fn helped_by(self, help: &str) -> Self {
        Self { help: help.to_owned(), ..self }
    }

    /// The same without a part of its help that does not help here.
    pub(crate) fn without_advice(self, advice: &str) -> Self {
        Self { help: self.help.replace(advice, ""), ..self }
    }

    /// What is wrong.
    pub(crate) fn what(&self) -> &str {
        &self.what
    }

    /// The same with more to tell, before the help.
    pub(crate) fn with_notes(mut self, notes: impl IntoIterator<Item = String>) -> Self {
        self.notes.extend(notes);
        self
    }

    /// A call that the parser of the command line refuses.
    pub(crate) fn usage(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        let (what, help) = text.split_once("\n\n").unwrap_or((&text, ""));
        let what = what.strip_prefix("error: ").unwrap_or(what);
        Self::new(Kind::Usage, what.trim(), help.trim())
    }

    /// Tells it on standard output as JSON. Standard output that cannot be written to is told on stderr alone.
    pub(crate) fn report_json(&self, out: &mut Output) {
        if self.kind == Kind::NobodyListens || self.what.starts_with(STDOUT) {
            return;
        }
        let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
        let files: Vec<String> = words.chain(self.file.clone()).chain(["<stdin>".to_owned()]).collect();
        let (place, message) = match Place::split(&self.what, &files) {
            Some((place, message)) => (Some(place), message),
            None => (None, self.what.as_str()),
        };
        let (notes, help) = (self.notes.as_slice(), Some(self.help.as_str()).filter(|help| !help.is_empty()));
        let (kind, exit_code) = (self.kind.name(), self.kind.exit_code());
        // `dcel --help` and the README tell of it.
        let error = fields! { kind, message, place, notes, help, exit_code };
        let _ = out.json(&fields! { error }).map(|_| out.flush());
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        self.kind.exit_code().into()
    }

    /// Tells it on stderr.
    pub(crate) fn report(&self) {
        if self.kind != Kind::NobodyListens {
            say("error", &self.what);
            self.notes.iter().for_each(|note| say("note", note));
            if !self.help.is_empty() {
                say("help", &self.help);
            }
        }
    }
}

impl Kind {
    fn exit_code(self) -> u8 {
        match self {
            Self::NobodyListens => 0,
            Self::Usage | Self::Input => 2,
            Self::Machine => 3,
            Self::Signal(signal) => 128 + signal,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::NobodyListens => "closed",
            Self::Usage => "usage",
            Self::Input => "input",
            Self::Machine => "machine",
            Self::Signal(_) => "signal",
        }
    }
}

/// What messages call standard output.
const STDOUT: &str = "<stdout>";

/// One line of talk on stderr. Nobody has to listen.
pub(crate) fn say(what: &str, text: impl Display) {
    super::waiting::aside(|| drop(writeln!(io::stderr().lock(), "{what}: {text}")));
}

/// Writing to standard output.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::writing(STDOUT, &error)
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
        let file = Some(error.source.clone());
        let is_lack = matches!(*error.what, ReadProblem::OutOfMemory { .. });
        let place = ReadError { help: "".into(), ..error };
        Self { file, ..Self::new(if is_lack { Kind::Machine } else { Kind::Input }, place, help) }
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
        let help = match &error {
            LoadError::Table { source_name, .. } if own_help.is_empty() => {
                let file = if source_name == "<stdin>" { "-" } else { source_name };
                format!("all that is broken in it is named by: dcel validate {file}")
            }
            error => flags(error).map_or_else(|| own_help.to_owned(), str::to_owned),
        };
        // Where a line follows, or a path inside the file, it is what stands before.
        let file = place.split_once(": ").map_or(place.as_str(), |(file, _)| file);
        let file = Some(file.trim_end_matches(|c: char| c == ':' || c.is_ascii_digit()).to_owned());
        Self { notes, file, ..Self::input(format!("{place}: {what}"), help) }
    }
}

/// The options that help with an input.
fn flags(error: &LoadError) -> Option<&'static str> {
    match error {
        LoadError::Holes { .. } => {
            Some("a point of a hole lies inside a ring, and not on it: move it there, or leave it out")
        }
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
        LoadError::Plane { error, what, .. } => match error {
            ConvertError::Geometry(_)
            | ConvertError::SelfCrossing { .. }
            | ConvertError::SelfTouching { .. }
            | ConvertError::OverlapAtEdge { .. }
            | ConvertError::OverlapAtVertex { .. }
            | ConvertError::HoleOutside { .. }
            | ConvertError::InPieces { .. }
            | ConvertError::CommonEdge { .. }
            | ConvertError::InsideFace { .. } => Some(MEND),
            ConvertError::ZeroArea { .. } if what.contains(" ring ") => {
                Some("correct the data, or leave out rings that enclose nothing with --drop-degenerate-rings or --mend")
            }
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
        let name = if target.as_os_str() == "-" { STDOUT.into() } else { target.display().to_string() };
        match error {
            WriteError::Io(error) => Self::writing(name, &error),
            other => Self::helped(format_args!("{name}: "), other),
        }
    }
}
