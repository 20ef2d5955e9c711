//! Finding the student's files in what was handed in.
//!
//! ```text
//!   lab.rs                    the file itself
//!   alice/src/lab.rs          a folder as `dcel lab start` makes it
//!   alice/lab.rs              the file in a folder
//!   alice/my-lab/src/lab.rs   a folder in a folder, as archives unpack; the only one of its kind
//! ```

use super::scan::{Forbidden, ScanError, scan};
use crate::lab::{Manifest, Verdict};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// The most that is read of a file.
const LARGEST: u64 = 1 << 20;
/// How deep in folders, and among how many entries, a file is looked for.
const DEEPEST: usize = 5;
const MOST_ENTRIES: usize = 5000;
/// Folders in which nobody keeps what they hand in.
const PASSED_OVER: [&str; 4] = ["target", "node_modules", "__MACOSX", "solution"];

/// The student's files.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Intake {
    /// The graded files: path in the lab, and text.
    pub graded: Vec<(String, String)>,
    /// Those that are read by people, if they were handed in.
    pub optional: Vec<(String, String)>,
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
    #[error("there is no {file} in what was handed in")]
    Missing {
        /// The file.
        file: String,
    },
    /// There are several, and no saying which is meant.
    #[error("there are several {file}: {} and {}; hand in one", one.display(), other.display())]
    Several {
        /// The file.
        file: String,
        /// The first.
        one: PathBuf,
        /// Another.
        other: PathBuf,
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

/// Takes the files that a lab names out of a submission: a folder, or a single file.
///
/// Cost: linear in the length of the files; a few thousand folder entries at most.
///
/// # Errors
/// [`IntakeError`]: the file is not there, no text, or says what it may not say.
pub fn take_in(manifest: &Manifest, submission: &Path) -> Result<Intake, IntakeError> {
    let intake = take_in_unscanned(manifest, submission)?;
    for (file, text) in &intake.graded {
        scan(text).map_err(|error| match error {
            ScanError::NotRust(at) => IntakeError::NotRust { file: file.clone(), at },
            ScanError::Forbidden(found) => IntakeError::Forbidden { file: file.clone(), found },
        })?;
    }
    Ok(intake)
}

/// The same without looking at what the text says. For tests of the walls behind the scan.
pub(crate) fn take_in_unscanned(manifest: &Manifest, submission: &Path) -> Result<Intake, IntakeError> {
    let data = fs::metadata(submission).map_err(|error| unreadable(submission, error))?;
    let mut graded = Vec::new();
    for file in &manifest.graded {
        let path = if data.is_dir() { find(submission, file)? } else { Some(submission.to_path_buf()) };
        let path = path.ok_or_else(|| IntakeError::Missing { file: file.clone() })?;
        graded.push((file.clone(), text(&path, file)?));
    }
    let mut optional = Vec::new();
    if data.is_dir() {
        for file in &manifest.optional {
            // What is optional is never a reason not to grade the rest.
            if let Ok(Some(path)) = find(submission, file)
                && let Ok(text) = text(&path, file)
            {
                optional.push((file.clone(), text));
            }
        }
    }
    Ok(Intake { graded, optional })
}

fn unreadable(path: &Path, error: io::Error) -> IntakeError {
    IntakeError::Unreadable { path: path.to_path_buf(), error }
}

/// Where a file is in a folder: at its own path, by its name at the top, or once somewhere below.
fn find(folder: &Path, file: &str) -> Result<Option<PathBuf>, IntakeError> {
    let name = file.rsplit('/').next().unwrap_or(file);
    for place in [file, name] {
        // No part of the way may be a link out of the folder.
        let mut path = folder.to_path_buf();
        let parts: Vec<&str> = place.split('/').collect();
        let on_the_way = parts[..parts.len() - 1].iter().all(|part| {
            path.push(part);
            path.symlink_metadata().is_ok_and(|data| data.is_dir())
        });
        path.push(parts[parts.len() - 1]);
        if on_the_way && path.symlink_metadata().is_ok() {
            return Ok(Some(path));
        }
    }
    let mut search = Search { file, found: Vec::new(), entries: 0 };
    search.below(folder, 0).map_err(|error| unreadable(folder, error))?;
    let mut found = search.found.into_iter();
    match (found.next(), found.next()) {
        (Some(one), Some(other)) => {
            let inside = |path: PathBuf| path.strip_prefix(folder).map_or_else(|_| path.clone(), Path::to_path_buf);
            Err(IntakeError::Several { file: file.to_owned(), one: inside(one), other: inside(other) })
        }
        (found, _) => Ok(found),
    }
}

struct Search<'a> {
    file: &'a str,
    found: Vec<PathBuf>,
    entries: usize,
}

impl Search<'_> {
    /// In the order of names, so that two runs say the same.
    fn below(&mut self, folder: &Path, depth: usize) -> io::Result<()> {
        let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            self.entries += 1;
            let name = entry.file_name();
            let hidden = name.as_encoded_bytes().first() == Some(&b'.');
            let passed_over = hidden || PASSED_OVER.iter().any(|over| name == *over);
            if self.entries > MOST_ENTRIES || passed_over || !entry.file_type()?.is_dir() {
                continue;
            }
            let place = entry.path().join(self.file);
            let in_a_folder = place.parent().is_some_and(|p| p.symlink_metadata().is_ok_and(|data| data.is_dir()));
            if in_a_folder && place.symlink_metadata().is_ok() {
                self.found.push(place);
            } else if depth < DEEPEST {
                self.below(&entry.path(), depth + 1)?;
            }
        }
        Ok(())
    }
}

/// The text of an ordinary file.
fn text(path: &Path, file: &str) -> Result<String, IntakeError> {
    let file = file.to_owned();
    let data = path.symlink_metadata().map_err(|error| unreadable(path, error))?;
    if !data.is_file() {
        let kind = match data.file_type() {
            kind if kind.is_symlink() => "a link",
            kind if kind.is_dir() => "a folder",
            _ => "a device",
        };
        return Err(IntakeError::NotAFile { file, kind });
    }
    if data.len() > LARGEST {
        return Err(IntakeError::TooLarge { file, bytes: data.len() });
    }
    let mut bytes = Vec::new();
    let opened = fs::File::open(path).map_err(|error| unreadable(path, error))?;
    opened.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|error| unreadable(path, error))?;
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
