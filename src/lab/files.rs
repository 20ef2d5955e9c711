//! The files of a lab, in memory: read from its folder, or from the archive that is compiled into the kit.
//!
//! ```text
//!   labs/04-half-edge/README.md ─┐                       ┌─ dcel lab start, export
//!                     src/lab.rs ┼─ LabFiles ─ archive ──┼─ dcel lab hint, verify
//!     figures/ that it shows    ─┘                       └─ the graded tests of a student's folder
//! ```
//!
//! What is compiled in is what students may have: no solution, and of the known mistakes their names and how they
//! fail, but not their texts. Proving that a lab grades rightly needs the lab's folder.
//!
//! An archive is a text: a line `lab NAME`, then for each file `file PATH LINES` and its lines. Published packages
//! leave out folders that are packages themselves, and so the labs; the archive is how the program has them
//! wherever it runs. Every file is UTF-8 text and ends with a line break; lines end as they do on unix.

use super::courses;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where the solution is.
const SOLUTION: &str = "solution/";
/// Where the known mistakes are, and the line of such a file from which on it says how to make the mistake.
const BUGS: &str = "bugs/";
const EDIT: &str = "[[edit]]";
/// Where a handout in the repository finds the figures of the kit.
const FIGURES: &str = "../../figures/";
/// Where a lab in the repository finds the program that all labs share.
const HARNESS: &str = "../harness";
/// How the sources of a lab name a module that stands in another folder of the labs, up to that folder's name.
const SHARED: &str = "#[path = \"../../";

/// The files of a lab by their paths, which have `/` between their parts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LabFiles {
    name: String,
    files: BTreeMap<String, String>,
}

/// Why the files of a lab cannot be had.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LabFilesError {
    /// No lab has that name, or several have names that begin so.
    #[error("there is no lab `{name}`; choose one of {}", known.join(", "))]
    Unknown {
        /// What was asked for.
        name: String,
        /// The labs that there are.
        known: Vec<String>,
    },
    /// A file or folder cannot be read.
    #[error("{}: {error}", path.display())]
    Unreadable {
        /// Which.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// A figure that the handout shows is not among those of the kit.
    #[error(
        "{}:{line}: the handout shows figures/{figure}, which is not there: {error}; draw it with `dcel figures`, or take \
         the link out", handout.display()
    )]
    NoFigure {
        /// The handout.
        handout: PathBuf,
        /// The line of the link, from 1.
        line: usize,
        /// The name of the figure.
        figure: String,
        /// Why it cannot be read.
        error: std::io::Error,
    },
    /// An archive that was changed by hand.
    #[error("the archive of a lab is broken at line {line}; write it anew with `dcel lab bundle`")]
    BrokenArchive {
        /// The line, from 1.
        line: usize,
    },
}

impl LabFiles {
    /// The names of the labs that are compiled in, in the order of their numbers.
    #[must_use]
    pub fn bundled_names() -> Vec<String> {
        courses::BUNDLE
            .iter()
            .filter_map(|archive| archive.lines().next()?.strip_prefix("lab ").map(str::to_owned))
            .collect()
    }

    /// The names of the labs that are compiled in, then of those that were added to this program, see
    /// [`add_own`](crate::courses::add_own).
    #[must_use]
    pub fn known_names() -> Vec<String> {
        let own = courses::own();
        Self::bundled_names().into_iter().chain(own.iter().map(courses::OwnLab::name)).collect()
    }

    /// The folder of a lab that was added to this program, if it is one: the lab with its solution.
    #[must_use]
    pub fn own_folder(name: &str) -> Option<PathBuf> {
        courses::own().into_iter().find(|own| own.name() == name).map(|own| own.folder)
    }

    /// A lab that is compiled in, by its name, its number, or its name without the number: `04-half-edge`, `04`,
    /// `4`, `half-edge`.
    ///
    /// # Errors
    /// [`LabFilesError::Unknown`] with the names that there are.
    pub fn bundled(name: &str) -> Result<Self, LabFilesError> {
        let known = Self::known_names();
        let Some(place) = known.iter().position(|lab| is_called(lab, name)) else {
            return Err(LabFilesError::Unknown { name: name.to_owned(), known });
        };
        match courses::BUNDLE.get(place) {
            Some(archive) => Self::from_archive(archive),
            None => {
                let files = Self::read(&Self::own_folder(&known[place]).unwrap_or_default())?.handed_out();
                Ok(Self { name: known[place].clone(), ..files })
            }
        }
    }

    /// Reads a lab's folder in the repository, with the figures that its handout shows; these become
    /// `figures/NAME` of the lab, and with the modules that it shares with others: `../../harness/mod.rs` and all that
    /// is in its folder become `src/harness/…`, a single file `../../04-half-edge/src/dcel.rs` becomes `src/dcel.rs`.
    /// Hidden files and `target` are left out.
    ///
    /// # Errors
    /// [`LabFilesError::Unreadable`] for what cannot be read or is no text.
    pub fn read(folder: &Path) -> Result<Self, LabFilesError> {
        // `..` is a folder with a name, too.
        let there = folder.canonicalize().map_err(|error| LabFilesError::Unreadable { path: folder.into(), error })?;
        let name = there.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let mut files = BTreeMap::new();
        collect(folder, "", &mut files)?;
        let handout = files.get("README.md").map_or("", String::as_str);
        let shown: Vec<String> = linked_figures(handout).map(str::to_owned).collect();
        for figure in shown {
            match text_of(&folder.join(FIGURES).join(&figure)) {
                Ok(text) => drop(files.insert(format!("figures/{figure}"), text)),
                Err(LabFilesError::Unreadable { error, .. }) => {
                    let text = files.get("README.md").map_or("", String::as_str);
                    let line = 1 + text.lines().position(|line| line.contains(&figure)).unwrap_or(0);
                    return Err(LabFilesError::NoFigure { handout: folder.join("README.md"), line, figure, error });
                }
                Err(error) => return Err(error),
            }
        }
        for shared in take_in_shared(&mut files) {
            let there = folder.join("..").join(&shared);
            match shared.strip_suffix("/mod.rs") {
                Some(name) => collect(&folder.join("..").join(name), &format!("src/{name}/"), &mut files)?,
                None => drop(files.insert(format!("src/{}", file_of(&shared)), text_of(&there)?)),
            }
        }
        Ok(Self { name, files })
    }

    /// The lab in this folder, if the folder is one of the repository: it finds the shared program beside itself.
    pub(super) fn of_repository(folder: &Path) -> Option<Self> {
        let shared = folder.join(HARNESS).is_dir() && !folder.join("src/harness").exists();
        shared.then(|| Self::read(folder).ok()).flatten()
    }

    /// The name of the lab's folder.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text of a file.
    #[must_use]
    pub fn get(&self, path: &str) -> Option<&str> {
        self.files.get(path).map(String::as_str)
    }

    /// The files with their texts, by path.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().map(|(path, text)| (path.as_str(), text.as_str()))
    }

    /// The handout with links to figures as they are in a folder of its own.
    #[must_use]
    pub fn handout(&self) -> String {
        self.get("README.md").unwrap_or_default().replace(FIGURES, "figures/")
    }

    /// The lab as students may have it: without the solution and without the texts of known mistakes.
    ///
    /// ```
    /// # use dcel_lab::LabFiles;
    /// let lab = LabFiles::bundled("04")?;
    /// assert_eq!(lab.handed_out(), lab);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn handed_out(&self) -> Self {
        let kept = self.files.iter().filter(|(path, _)| !path.starts_with(SOLUTION));
        let files = kept.map(|(path, text)| {
            let text = if path.starts_with(BUGS) { without_edits(text) } else { text.clone() };
            (path.clone(), text)
        });
        Self { name: self.name.clone(), files: files.collect() }
    }

    /// The lab as one text.
    #[must_use]
    pub fn to_archive(&self) -> String {
        let mut out = format!("lab {}\n", self.name);
        for (path, text) in &self.files {
            let _ = writeln!(out, "file {path} {}", text.lines().count());
            for line in text.lines() {
                out.push_str(line);
                out.push('\n');
            }
        }
        out
    }

    /// The lab of an archive.
    ///
    /// # Errors
    /// [`LabFilesError::BrokenArchive`] with the line.
    pub fn from_archive(archive: &str) -> Result<Self, LabFilesError> {
        // With the line ends of other systems it is the same archive.
        let mut lines = archive.lines().map(|line| line.trim_end_matches('\r')).enumerate();
        let broken = |line| LabFilesError::BrokenArchive { line };
        let (_, first) = lines.next().ok_or_else(|| broken(1))?;
        let name = first.strip_prefix("lab ").ok_or_else(|| broken(1))?.to_owned();
        let mut files = BTreeMap::new();
        while let Some((i, head)) = lines.next() {
            let (path, count) = head
                .strip_prefix("file ")
                .and_then(|rest| rest.rsplit_once(' '))
                .and_then(|(path, count)| Some((path, count.parse::<usize>().ok()?)))
                .ok_or_else(|| broken(i + 1))?;
            let mut text = String::new();
            for _ in 0..count {
                let (_, line) = lines.next().ok_or_else(|| broken(i + 1))?;
                text.push_str(line);
                text.push('\n');
            }
            files.insert(path.to_owned(), text);
        }
        Ok(Self { name, files })
    }
}

/// A known mistake without what makes it of the solution, which stands at the end.
fn without_edits(text: &str) -> String {
    let kept: String = text.lines().take_while(|line| line.trim() != EDIT).flat_map(|line| [line, "\n"]).collect();
    kept.trim_end().to_owned() + "\n"
}

/// Whether `lab` is meant by `name`.
fn is_called(lab: &str, name: &str) -> bool {
    let (number, words) = lab.split_once('-').unwrap_or((lab, ""));
    let numbers_agree = || matches!((name.parse::<u32>(), number.parse::<u32>()), (Ok(a), Ok(b)) if a == b);
    lab == name || words == name || numbers_agree()
}

/// The names of the figures that a handout links to, each once.
fn linked_figures(handout: &str) -> impl Iterator<Item = &str> {
    let mut seen = BTreeSet::new();
    handout
        .split(FIGURES)
        .skip(1)
        .map(|rest| &rest[..rest.find([')', '"', '#', ' ', '`', '\n']).unwrap_or(rest.len())])
        .filter(move |figure| !figure.is_empty() && seen.insert(*figure))
}

/// Lets the sources of a lab find the modules that it shares inside the lab. Returns these, by their paths in the folder
/// of the labs: `harness/mod.rs`, `04-half-edge/src/dcel.rs`.
fn take_in_shared(files: &mut BTreeMap<String, String>) -> BTreeSet<String> {
    let mut shared = BTreeSet::new();
    for (path, text) in files {
        // A module is looked for where its parent's file is.
        let Some(here) = [("src/", None), ("tests/", Some("../src/"))].into_iter().find(|(of, _)| path.starts_with(of))
        else {
            continue;
        };
        let mut out = String::with_capacity(text.len());
        for line in text.split_inclusive('\n') {
            let there = line.trim().strip_prefix(SHARED).and_then(|rest| rest.strip_suffix("\"]"));
            let Some(there) = there else {
                out.push_str(line);
                continue;
            };
            shared.insert(there.to_owned());
            if let (_, Some(up)) = here {
                let inside = if there.ends_with("/mod.rs") { there } else { file_of(there) };
                let _ = writeln!(out, "#[path = \"{up}{inside}\"]");
            }
        }
        *text = out;
    }
    shared
}

/// The last part of a path.
fn file_of(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

fn collect(folder: &Path, prefix: &str, files: &mut BTreeMap<String, String>) -> Result<(), LabFilesError> {
    let unreadable = |error| LabFilesError::Unreadable { path: folder.to_owned(), error };
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') || name == "target" || name == "Cargo.lock" {
            continue;
        }
        let path = format!("{prefix}{name}");
        if entry.file_type().map_err(unreadable)?.is_dir() {
            collect(&entry.path(), &format!("{path}/"), files)?;
        } else {
            files.insert(path, text_of(&entry.path())?);
        }
    }
    Ok(())
}

/// The text with unix line ends and a line break at its end.
fn text_of(path: &Path) -> Result<String, LabFilesError> {
    let text =
        std::fs::read_to_string(path).map_err(|error| LabFilesError::Unreadable { path: path.to_owned(), error })?;
    Ok(text.lines().flat_map(|line| [line, "\n"]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> LabFiles {
        let files =
            [("README.md", "See ![a](../../figures/a.svg) and\n[b](../../figures/b.svg#x).\n"), ("src/lab.rs", "")];
        LabFiles {
            name: "04-half-edge".to_owned(),
            files: files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect(),
        }
    }

    #[test]
    fn an_archive_gives_the_files_back() {
        let archive = small().to_archive();
        assert_eq!(LabFiles::from_archive(&archive).unwrap(), small());
        assert_eq!(LabFiles::from_archive(&archive.replace('\n', "\r\n")).unwrap(), small());
        assert_eq!(LabFiles::from_archive("lab 05-x\r").unwrap().to_archive(), "lab 05-x\n");
    }

    #[test]
    fn what_is_handed_out_holds_names_and_no_texts() {
        let bug = "number = 1\ntitle = \"it is wrong\"\n\n[[edit]]\nfind = \"right();\"\nreplace = \"\"\"\nwrong();\n\"\"\"\n";
        let mut lab = small();
        for (path, text) in
            [("solution/lab.rs", "right();\n"), ("bugs/01-wrong.toml", bug), ("bugs/signatures.toml", "[1]\n")]
        {
            lab.files.insert(path.to_owned(), text.to_owned());
        }
        let out = lab.handed_out();
        assert_eq!(out.get("bugs/01-wrong.toml"), Some("number = 1\ntitle = \"it is wrong\"\n"));
        assert_eq!(out.get("bugs/signatures.toml"), Some("[1]\n"));
        assert_eq!((out.get("solution/lab.rs"), out.files.len()), (None, 4));
    }

    #[test]
    fn a_broken_archive_is_refused_at_its_line() {
        for (archive, line) in
            [("", 1), ("lib x\n", 1), ("lab x\nfile a\n", 2), ("lab x\nfile a 1\nb\nfile c 2\nd\n", 4)]
        {
            let error = LabFiles::from_archive(archive).unwrap_err();
            assert!(matches!(error, LabFilesError::BrokenArchive { line: at } if at == line), "{archive:?}: {error}");
        }
    }

    #[test]
    fn the_figures_of_a_handout_are_found_and_linked_anew() {
        assert_eq!(linked_figures(small().get("README.md").unwrap()).collect::<Vec<_>>(), ["a.svg", "b.svg"]);
        assert_eq!(small().handout(), "See ![a](figures/a.svg) and\n[b](figures/b.svg#x).\n");
    }

    #[test]
    fn a_missing_figure_is_named_with_its_line() {
        let folder = tempfile::tempdir().unwrap();
        let lab = folder.path().join("labs/12-own");
        std::fs::create_dir_all(lab.join("src")).unwrap();
        std::fs::write(lab.join("README.md"), "# Own\n\nSee\n![b](../../figures/b.svg).\n").unwrap();
        match LabFiles::read(&lab).unwrap_err() {
            LabFilesError::NoFigure { line, figure, .. } => assert_eq!((line, figure.as_str()), (4, "b.svg")),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn a_lab_of_the_repository_finds_the_shared_program_beside_itself_and_none_of_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let lab = folder.path().join("labs/12-own");
        std::fs::create_dir_all(lab.join("src")).unwrap();
        std::fs::write(lab.join("src/main.rs"), "fn main() {}\n").unwrap();
        assert_eq!(LabFiles::of_repository(&lab), None, "there is no shared program");
        std::fs::create_dir_all(lab.join(HARNESS)).unwrap();
        assert_eq!(LabFiles::of_repository(&lab).unwrap().name(), "12-own");
        std::fs::create_dir_all(lab.join("src/harness")).unwrap();
        assert_eq!(LabFiles::of_repository(&lab), None, "an exported one has its own");
    }

    #[test]
    fn shared_modules_are_taken_into_the_lab() {
        let text = "mod a;\n#[path = \"../../harness/mod.rs\"]\nmod harness;\n#[path = \"../../04-x/src/dcel.rs\"]\n\
                    mod dcel;\n#[path = \"../src/own.rs\"]\nmod own;\n";
        let mut files: BTreeMap<String, String> =
            ["src/main.rs", "tests/own.rs", "README.md"].map(|path| (path.to_owned(), text.to_owned())).into();
        let shared = ["04-x/src/dcel.rs", "harness/mod.rs"].map(str::to_owned);
        assert_eq!(take_in_shared(&mut files), shared.into());
        assert_eq!(files["src/main.rs"], "mod a;\nmod harness;\nmod dcel;\n#[path = \"../src/own.rs\"]\nmod own;\n");
        let [own, dcel] = ["harness/mod.rs", "dcel.rs"].map(|file| format!("#[path = \"../src/{file}\"]\n"));
        let expected = format!("mod a;\n{own}mod harness;\n{dcel}mod dcel;\n#[path = \"../src/own.rs\"]\nmod own;\n");
        assert_eq!(files["tests/own.rs"], expected);
        assert_eq!(files["README.md"], text);
        assert!(take_in_shared(&mut files).is_empty());
    }

    #[test]
    fn a_lab_is_known_by_its_name_its_number_and_its_words() {
        for name in ["04-half-edge", "04", "4", "half-edge"] {
            assert!(is_called("04-half-edge", name), "{name}");
        }
        for name in ["", "05", "half", "0x4", "-4", "edge"] {
            assert!(!is_called("04-half-edge", name), "{name}");
        }
    }
}
