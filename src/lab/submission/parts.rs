//! The files of what was handed in that can matter: found in folders and archives, read later or already in memory.
//!
//! ```text
//!   folder   ─ walk, nearest first ─┐
//!   archive  ─ nothing is unpacked ─┼─▶ parts: path and content ─▶ intake takes the lab's files
//!   several files of one person ────┘
//! ```
//!
//! A part is a file that ends as a wanted file does, an archive, or a link. Links are never followed: they
//! are parts so that it can be said that they are there.

use std::collections::VecDeque;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How deep in folders, and among how many entries, a file is looked for.
const DEEPEST: usize = 6;
const MOST_ENTRIES: usize = 5000;
/// Folders in which nobody keeps what they hand in.
const PASSED_OVER: [&str; 4] = ["target", "node_modules", "__MACOSX", "solution"];

/// A file, or what stands in the place of one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Part {
    /// Where it is in what was handed in, with `/`.
    pub(super) path: String,
    pub(super) content: Content,
}

/// What a part holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Content {
    /// A file, or a folder or device in the place of one, still to be read.
    OnDisk(PathBuf),
    /// A file out of an archive.
    #[cfg(feature = "grade")]
    Bytes(Vec<u8>),
    /// A file out of an archive that is too long to be kept.
    #[cfg(feature = "grade")]
    TooLarge(u64),
    /// A link, with what it names.
    Link(String),
}

impl Part {
    pub(super) fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or(&self.path)
    }
}

/// The parts of a folder: those in fewer folders first, then in the order of names, so that two runs say the same.
pub(super) fn of_folder(folder: &Path, wanted: &[&str]) -> io::Result<Vec<Part>> {
    let mut parts = Vec::new();
    let mut entries = 0;
    let mut open = VecDeque::from([(folder.to_path_buf(), String::new(), 0)]);
    while let Some((folder, prefix, depth)) = open.pop_front() {
        // Only the folder itself has to be readable.
        let listed = fs::read_dir(&folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
        let mut inside = match listed {
            Err(error) if depth == 0 => return Err(error),
            listed => listed.unwrap_or_default(),
        };
        inside.sort_by_key(fs::DirEntry::file_name);
        for entry in inside {
            entries += 1;
            let name = entry.file_name().to_string_lossy().into_owned();
            let kind = entry.file_type()?;
            if entries > MOST_ENTRIES || name.starts_with('.') {
                continue;
            }
            let path = format!("{prefix}{name}");
            if kind.is_symlink() {
                let to = fs::read_link(entry.path()).map_or_else(|_| String::new(), |to| to.display().to_string());
                parts.push(Part { path, content: Content::Link(to) });
            } else if matters(&name, wanted) {
                parts.push(Part { path, content: Content::OnDisk(entry.path()) });
            } else if kind.is_dir() && depth < DEEPEST && !is_passed_over(&name) {
                open.push_back((entry.path(), format!("{path}/"), depth + 1));
            }
        }
    }
    Ok(parts)
}

/// Where what was handed in is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Source {
    /// A file or a folder.
    Path(PathBuf),
    /// Several files or folders of one person, with their original names.
    #[cfg(feature = "grade")]
    Paths(Vec<(String, PathBuf)>),
    /// Files out of the archive of a class.
    #[cfg(feature = "grade")]
    Packed(Vec<Part>),
    /// A link, with what it names: it is not followed.
    #[cfg(feature = "grade")]
    Link(String),
}

pub(super) fn is_passed_over(folder: &str) -> bool {
    folder.starts_with('.') || PASSED_OVER.contains(&folder)
}

/// Whether a file of this name may be what is looked for, or hold it: it has the ending of a wanted one, or is an
/// archive.
pub(super) fn matters(name: &str, wanted: &[&str]) -> bool {
    kind(name) != Kind::None || wanted.iter().any(|wanted| is_like(name, wanted) || ends_alike(name, wanted))
}

fn ends_alike(name: &str, wanted: &str) -> bool {
    let end = |name: &str| name.rsplit_once('.').map(|(_, end)| end.to_lowercase());
    end(name).is_some() && end(name) == end(wanted)
}

/// Whether a file is called as wanted, but for upper and lower case and the mark of a copy: `Lab.rs`, `lab-1.rs`,
/// `lab (2).rs`.
pub(super) fn is_like(name: &str, wanted: &str) -> bool {
    let (name, wanted) = (name.to_lowercase(), wanted.to_lowercase());
    let split = |text: &str| text.rsplit_once('.').map(|(stem, end)| (stem.to_owned(), end.to_owned()));
    let (Some((stem, end)), Some((wanted_stem, wanted_end))) = (split(&name), split(&wanted)) else {
        return name == wanted;
    };
    let rest = stem.strip_prefix(&wanted_stem).map(|rest| rest.trim_matches([' ', '-', '_', '(', ')']));
    end == wanted_end && rest.is_some_and(|rest| rest == "copy" || rest.chars().all(|c| c.is_ascii_digit()))
}

/// What the name of a file says of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Zip,
    Tar,
    TarGz,
    /// An archive of a kind that is not opened here.
    Foreign,
    /// No archive.
    None,
}

/// The kind of an archive of this name.
pub(super) fn kind(name: &str) -> Kind {
    const FOREIGN: &[&str] = &[".rar", ".7z", ".tar.xz", ".txz", ".tar.bz2", ".tbz2", ".tar.zst", ".gz", ".xz", ".bz2"];
    let known = [(&[".zip"][..], Kind::Zip), (&[".tar.gz", ".tgz"], Kind::TarGz), (&[".tar"], Kind::Tar)];
    let name = name.to_lowercase();
    let is_end = |end: &&str| name.len() > end.len() && name.ends_with(end);
    let mut all = known.into_iter().chain([(FOREIGN, Kind::Foreign)]);
    all.find(|(ends, _)| ends.iter().any(is_end)).map_or(Kind::None, |(_, kind)| kind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_of_a_file_are_like_it_and_others_are_not() {
        for name in ["lab.rs", "Lab.RS", "lab-1.rs", "lab (2).rs", "lab_copy.rs", "lab - Copy.rs"] {
            assert!(is_like(name, "lab.rs"), "{name}");
        }
        for name in ["notes.rs", "lab.txt", "lab-1.txt", "label.rs", "my_lab.rs", "lab", "1.rs"] {
            assert!(!is_like(name, "lab.rs"), "{name}");
        }
        assert!(is_like("Makefile", "makefile") && !is_like("Makefile", "lab.rs"));
    }

    #[test]
    fn a_folder_that_cannot_be_read_is_not_an_empty_one() {
        let room = tempfile::tempdir().unwrap();
        assert_eq!(of_folder(room.path(), &["lab.rs"]).unwrap(), []);
        assert!(of_folder(&room.path().join("gone"), &["lab.rs"]).is_err());
        fs::write(room.path().join("lab.rs"), "").unwrap();
        assert!(of_folder(&room.path().join("lab.rs"), &["lab.rs"]).is_err(), "a file is no folder");
        assert_eq!(of_folder(room.path(), &["lab.rs"]).unwrap().len(), 1);
    }

    #[test]
    fn endings_are_alike_if_there_are_any() {
        assert!(ends_alike("other.RS", "lab.rs"));
        assert!(!ends_alike("other.txt", "lab.rs") && !ends_alike("other", "lab.rs") && !ends_alike("other", "lab"));
    }
}
