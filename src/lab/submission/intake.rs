//! Finding the student's files in what was handed in.
//!
//! ```text
//!   lab.rs                    the file itself
//!   alice/src/lab.rs          a folder as `dcel lab start` makes it
//!   alice/lab.rs              the file in a folder
//!   alice/my-lab/src/lab.rs   a folder in a folder, as archives unpack; the only one of its kind
//!   alice/Lab (1).rs          nearly the name, the only one: taken, and noted
//!   alice.zip alice/lab.zip   an archive of any of these; an archive in it is not opened
//! ```

#[cfg(feature = "grade")]
use super::archive::{self, Keep};
#[cfg(feature = "grade")]
use super::handed::Submission;
use super::parts::{self, Content, Kind, Part, Source};
use super::scan::{Forbidden, ScanError, scan};
use crate::{Manifest, Verdict};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// What says of which lab a folder is.
const MANIFEST: &str = "lab.toml";
/// The most that is read of a file.
const LARGEST: u64 = 1 << 20;
/// The most that is kept of one archive.
#[cfg(feature = "grade")]
const TOGETHER: u64 = 16 << 20;

/// The student's files.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Intake {
    /// The graded files: path in the lab, and text.
    pub graded: Vec<(String, String)>,
    /// Those that are read by people, if they were handed in.
    pub optional: Vec<(String, String)>,
    /// What was odd about them: a file that is not called as it should be.
    pub notes: Vec<String>,
}

/// Why a submission is not taken.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IntakeError {
    /// There is nothing of that name, or it cannot be read. Not the student's fault.
    #[error("{}: {error}", path.display())]
    Unreadable {
        /// What.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// A graded file is not there.
    #[error("there is no {file} in what was handed in{instead}")]
    Missing {
        /// The file.
        file: String,
        /// What there is that may have been meant for it, with what to do; empty if nothing is.
        instead: String,
    },
    /// There are several, and no saying which is meant.
    #[error("there are several {file}: {one} and {other}; hand in one")]
    Several {
        /// The file.
        file: String,
        /// The first.
        one: String,
        /// Another.
        other: String,
    },
    /// What was handed in is a link.
    #[error("this is a link to {to}, and links are not followed; hand in the files themselves")]
    Link {
        /// What it names.
        to: String,
    },
    /// An archive that cannot be looked into.
    #[error("{archive}: {what}")]
    Archive {
        /// The archive.
        archive: String,
        /// Why, and what to do.
        what: String,
    },
    /// A link, a folder, a device.
    #[error("{file} is not an ordinary file but {kind}; hand in the file itself")]
    NotAFile {
        /// The file.
        file: String,
        /// What it is.
        kind: &'static str,
    },
    /// More than a megabyte.
    #[error("{file} has {bytes} bytes; more than {LARGEST} is no handwriting")]
    TooLarge {
        /// The file.
        file: String,
        /// Its length.
        bytes: u64,
    },
    /// Not UTF-8, or with zero bytes.
    #[error("{file}:{line}: byte {byte} of the file is not UTF-8 text; save it as UTF-8")]
    NotText {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The place, from 0.
        byte: usize,
    },
    /// A quote, a bracket or a character is out of place.
    #[error("{file}:{}:{}: {}", at.line, at.column, at.what)]
    NotRust {
        /// The file.
        file: String,
        /// Where and what.
        at: Forbidden,
    },
    /// It says what a lab's file may not say.
    #[error("{}", lines(file, found))]
    Forbidden {
        /// The file.
        file: String,
        /// What it says; never empty.
        found: Vec<Forbidden>,
    },
}

fn lines(file: &str, found: &[Forbidden]) -> String {
    let line = |f: &Forbidden| format!("{file}:{}:{}: {}", f.line, f.column, f.what);
    found.iter().map(line).collect::<Vec<_>>().join("\n")
}

impl IntakeError {
    /// The verdict on a submission that is not taken.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self {
            Self::Unreadable { .. } => Verdict::GraderFault,
            Self::NotRust { .. } => Verdict::DoesNotCompile,
            _ => Verdict::Refused,
        }
    }
}

/// Takes the files that a lab names out of what was handed in: a folder or a single file.
///
/// Everything is read once: what is looked at afterwards is what is graded.
///
/// Cost: linear in the length of the files; a few thousand folder entries at most.
///
/// # Errors
/// [`IntakeError`]: the file is not there, no text, or says what it may not say.
pub fn take_in(manifest: &Manifest, handed_in: &Path) -> Result<Intake, IntakeError> {
    // At home the folder is looked at before: its lab.toml says which lab is checked.
    let (intake, _) = take_from(manifest, &Source::Path(handed_in.to_path_buf()))?;
    scan_all(&intake)?;
    Ok(intake)
}

/// Looks at what the graded files say.
pub(crate) fn scan_all(intake: &Intake) -> Result<(), IntakeError> {
    for (file, text) in &intake.graded {
        scan(text).map_err(|error| match error {
            ScanError::NotRust(at) => IntakeError::NotRust { file: file.clone(), at },
            ScanError::Forbidden(found) => IntakeError::Forbidden { file: file.clone(), found },
        })?;
    }
    Ok(())
}

/// Takes the files of a submission, archives included, without looking at what they say.
#[cfg(feature = "grade")]
pub(crate) fn take_in_unscanned(manifest: &Manifest, submission: &Submission) -> Result<Intake, IntakeError> {
    let (intake, other) = take_from(manifest, &submission.from)?;
    Ok(Intake { notes: [submission.notes(), &other, &intake.notes].concat(), ..intake })
}

/// The files, and a note if they are of another lab.
fn take_from(manifest: &Manifest, from: &Source) -> Result<(Intake, Vec<String>), IntakeError> {
    let files = manifest.graded.iter().chain(&manifest.optional);
    let wanted: Vec<&str> = files.map(|file| name_of(file)).chain([MANIFEST]).collect();
    let mut intake = Intake { graded: Vec::new(), optional: Vec::new(), notes: Vec::new() };
    let (mut parts, opened_before) = match parts_of(from, &wanted)? {
        Found::Parts(parts, opened) => (parts, opened),
        Found::File(path) => {
            for file in &manifest.graded {
                intake.graded.push((file.clone(), text(&Content::OnDisk(path.clone()), file)?));
            }
            return Ok((intake, Vec::new()));
        }
    };
    let has = |parts: &[Part], file: &String| !matches!(find(parts, file), Ok(None));
    if !opened_before
        && !manifest.graded.iter().any(|file| has(&parts, file))
        && let Some(archive) = the_archive(&parts)
    {
        parts = opened(&parts[archive], &wanted)?;
    }
    let other = of_another_lab(&parts, manifest);
    for file in &manifest.graded {
        let found = find(&parts, file)?.or_else(|| the_only_one(&parts, file));
        let (part, note) =
            found.ok_or_else(|| IntakeError::Missing { file: file.clone(), instead: instead(&parts, file) })?;
        intake.notes.extend(note);
        intake.graded.push((file.clone(), text(&part.content, file)?));
    }
    for file in &manifest.optional {
        // What is optional is never a reason not to grade the rest.
        if let Ok(Some((part, _))) = find(&parts, file)
            && let Ok(text) = text(&part.content, file)
        {
            intake.optional.push((file.clone(), text));
        }
    }
    Ok((intake, other.into_iter().collect()))
}

/// A note if what was handed in says that it is of another lab, or of another version of it.
fn of_another_lab(parts: &[Part], manifest: &Manifest) -> Option<String> {
    let (part, _) = find(parts, MANIFEST).ok()??;
    let text = text(&part.content, MANIFEST).ok()?;
    let own = Manifest::parse(&text, &part.path).ok()?;
    let place = |key: &str| {
        let line = 1 + text.lines().position(|line| line.starts_with(key)).unwrap_or(0);
        format!("{}:{line}", part.path)
    };
    let (name, other) = (&manifest.name, &own.name);
    if name != other {
        let at = place("name");
        return Some(format!("{at}: this folder is of {other}, not of {name}; `dcel grade {other}` grades it"));
    }
    (own.version != manifest.version).then(|| {
        let (at, there, here) = (place("version"), &own.version, &manifest.version);
        format!("{at}: this folder is of version {there} of {name}; it is graded by version {here}")
    })
}

/// What a submission is made of.
enum Found {
    /// A single file, whatever it is called.
    File(PathBuf),
    /// And whether they are those of an archive: another one in it is not opened.
    Parts(Vec<Part>, bool),
}

fn parts_of(from: &Source, wanted: &[&str]) -> Result<Found, IntakeError> {
    let listed = |path: &Path| {
        let data = fs::metadata(path).map_err(|error| unreadable(path, error))?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(if data.is_dir() {
            Found::Parts(parts::of_folder(path, wanted).map_err(|error| unreadable(path, error))?, false)
        } else if parts::kind(&name) != Kind::None {
            Found::Parts(opened(&Part { path: name, content: Content::OnDisk(path.to_path_buf()) }, wanted)?, true)
        } else {
            // Somebody named it: if it is a link, that one is followed.
            Found::File(path.canonicalize().map_err(|error| unreadable(path, error))?)
        })
    };
    match from {
        Source::Path(path) => listed(path),
        #[cfg(feature = "grade")]
        Source::Paths(paths) => match paths.as_slice() {
            [(_, path)] => listed(path),
            several => {
                let mut parts = Vec::new();
                for (name, path) in several {
                    if path.is_dir() {
                        parts.extend(parts::of_folder(path, wanted).map_err(|error| unreadable(path, error))?);
                    } else if parts::matters(name, wanted) {
                        parts.push(Part { path: name.clone(), content: Content::OnDisk(path.clone()) });
                    }
                }
                Ok(Found::Parts(parts, false))
            }
        },
        #[cfg(feature = "grade")]
        Source::Packed(parts) => Ok(Found::Parts(parts.clone(), false)),
        #[cfg(feature = "grade")]
        Source::Link(to) => Err(IntakeError::Link { to: to.clone() }),
    }
}

fn unreadable(path: &Path, error: io::Error) -> IntakeError {
    IntakeError::Unreadable { path: path.to_path_buf(), error }
}

fn name_of(file: &str) -> &str {
    file.rsplit('/').next().unwrap_or(file)
}

/// The only archive among the parts.
fn the_archive(parts: &[Part]) -> Option<usize> {
    let mut archives = parts.iter().enumerate().filter(|(_, part)| parts::kind(part.name()) != Kind::None);
    let first = archives.next()?.0;
    archives.next().is_none().then_some(first)
}

/// The parts of an archive that was handed in.
#[cfg(feature = "grade")]
fn opened(part: &Part, wanted: &[&str]) -> Result<Vec<Part>, IntakeError> {
    let longest = |name: &str| parts::matters(name, wanted).then_some(LARGEST);
    let keep = Keep { longest: &longest, together: TOGETHER };
    let parts = match &part.content {
        Content::OnDisk(path) => archive::of_file(path, &keep).map_err(|error| unreadable(path, error))?,
        Content::Bytes(bytes) => archive::of_bytes(bytes, part.name(), &keep),
        Content::TooLarge(bytes) => return Err(IntakeError::TooLarge { file: part.path.clone(), bytes: *bytes }),
        Content::Link(_) => return Err(IntakeError::NotAFile { file: part.path.clone(), kind: "a link" }),
    };
    parts.map_err(|what| IntakeError::Archive { archive: part.name().to_owned(), what })
}

/// Only the grader opens archives: at home there is the folder that was packed.
#[cfg(not(feature = "grade"))]
fn opened(part: &Part, _: &[&str]) -> Result<Vec<Part>, IntakeError> {
    let what = "it is opened when it is graded; check the folder itself".to_owned();
    Err(IntakeError::Archive { archive: part.name().to_owned(), what })
}

/// Where a file is: at its own path, by its name at the top, or once somewhere below; at last, once by nearly its
/// name, with a note.
fn find<'a>(parts: &'a [Part], file: &str) -> Result<Option<(&'a Part, Option<String>)>, IntakeError> {
    let name = name_of(file);
    for place in [file, name] {
        if let Some(part) = parts.iter().find(|part| part.path == place) {
            return Ok(Some((part, None)));
        }
    }
    let below = |end: &str| {
        let end = format!("/{end}");
        the_only(file, parts.iter().filter(move |part| part.path.ends_with(&end)))
    };
    for place in [file, name] {
        if let Some(part) = below(place)? {
            return Ok(Some((part, None)));
        }
    }
    let nearly = the_only(file, parts.iter().filter(|part| parts::is_like(part.name(), name)))?;
    Ok(nearly.map(|part| (part, Some(format!("there is no {file}; `{}` was taken for it", part.path)))))
}

/// At the very last: the only file with the ending of the wanted one, with a note.
fn the_only_one<'a>(parts: &'a [Part], file: &str) -> Option<(&'a Part, Option<String>)> {
    let end = |name: &str| name.rsplit_once('.').map(|(_, end)| end.to_lowercase());
    let mut found = parts.iter().filter(|part| end(part.name()) == end(name_of(file)));
    let part = found.next().filter(|_| found.next().is_none())?;
    Some((part, Some(format!("there is no {file}; `{}` was taken for it", part.path))))
}

fn the_only<'a>(file: &str, mut found: impl Iterator<Item = &'a Part>) -> Result<Option<&'a Part>, IntakeError> {
    match (found.next(), found.next()) {
        (Some(one), Some(other)) => {
            Err(IntakeError::Several { file: file.to_owned(), one: one.path.clone(), other: other.path.clone() })
        }
        (found, _) => Ok(found),
    }
}

/// What there is in place of a file that is missing.
fn instead(parts: &[Part], file: &str) -> String {
    let archive = parts.iter().find(|part| parts::kind(part.name()) != Kind::None);
    let link = parts.iter().find_map(|part| match &part.content {
        Content::Link(to) => Some((&part.path, to)),
        _ => None,
    });
    match (link, archive) {
        (Some((path, to)), _) => format!("; `{path}` is a link to {to}, and links are not followed"),
        (None, Some(part)) => {
            format!("; `{}` is not opened: hand in one archive, with your files and no archive in it", part.path)
        }
        (None, None) => {
            let name = name_of(file);
            let end = Path::new(name).extension();
            let meant: Vec<&str> =
                parts.iter().map(|part| &*part.path).filter(|path| Path::new(path).extension() == end).collect();
            match meant[..] {
                [one, other, ..] => format!(
                    "; there are `{one}`, `{other}`{}: the one that counts must be called {name} (a class is graded with \
                     --all-in)",
                    if meant.len() > 2 { " and more" } else { "" }
                ),
                _ => String::new(),
            }
        }
    }
}

/// The text of an ordinary file.
fn text(content: &Content, file: &str) -> Result<String, IntakeError> {
    let file = file.to_owned();
    let bytes = match content {
        Content::OnDisk(path) => read(path, &file)?,
        #[cfg(feature = "grade")]
        Content::Bytes(bytes) => bytes.clone(),
        #[cfg(feature = "grade")]
        Content::TooLarge(bytes) => return Err(IntakeError::TooLarge { file, bytes: *bytes }),
        Content::Link(_) => return Err(IntakeError::NotAFile { file, kind: "a link" }),
    };
    let bad = match std::str::from_utf8(&bytes) {
        Ok(_) => bytes.iter().position(|&b| b == 0),
        Err(error) => Some(error.valid_up_to()),
    };
    if let Some(byte) = bad {
        let line = 1 + bytes[..byte].iter().filter(|&&b| b == b'\n').count();
        return Err(IntakeError::NotText { file, line, byte });
    }
    Ok(String::from_utf8(bytes).unwrap_or_default().trim_start_matches('\u{feff}').to_owned())
}

/// The bytes of a file, which is looked at after it is opened: it cannot become another one in between.
fn read(path: &Path, file: &str) -> Result<Vec<u8>, IntakeError> {
    let odd = |kind| IntakeError::NotAFile { file: file.to_owned(), kind };
    let data = fs::symlink_metadata(path).map_err(|error| unreadable(path, error))?;
    if data.is_dir() {
        return Err(odd("a folder"));
    } else if !data.is_file() {
        return Err(odd("a device"));
    }
    let opened = fs::File::open(path).map_err(|error| unreadable(path, error))?;
    let length = opened.metadata().map_err(|error| unreadable(path, error))?.len();
    let mut bytes = Vec::new();
    opened.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|error| unreadable(path, error))?;
    if bytes.len() as u64 > LARGEST {
        return Err(IntakeError::TooLarge { file: file.to_owned(), bytes: length });
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_files_that_may_be_meant_two_are_named() {
        let parts = |paths: &[&str]| -> Vec<Part> {
            let part = |path: &&str| Part { path: (*path).to_owned(), content: Content::OnDisk((*path).into()) };
            paths.iter().map(part).collect()
        };
        let said = |paths: &[&str]| instead(&parts(paths), "src/lab.rs");
        assert!(said(&["a.rs", "notes.txt", "b.rs"]).starts_with("; there are `a.rs`, `b.rs`: the one that counts"));
        assert!(said(&["a.rs", "b.rs", "c.rs"]).starts_with("; there are `a.rs`, `b.rs` and more: "));
        assert_eq!([said(&["a.rs"]), said(&["a.txt", "b.txt"]), said(&[])], ["", "", ""]);
    }
}
