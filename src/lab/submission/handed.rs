//! Who handed in what: a name for each row of the class, and where the files are.
//!
//! ```text
//!   alice.rs   alice/src/lab.rs   alice.zip          alice
//!   fall/alice/lab.rs   spring/alice/lab.rs          fall/alice, spring/alice
//!   arndtanna_LATE_4711_90210_lab-1.rs               arndtanna        Canvas; all files of one person together
//!   Anna Arndt_4711_assignsubmission_file_/lab.rs    Anna Arndt       Moodle
//! ```
//!
//! Names are made longer until they differ: by the number of the person, by the ending of the file, by the folders
//! around it. What a name is made from does not depend on the other submissions' contents.

use super::archive::{self, Keep};
use super::parts::{self, Content, Kind, Part, Source};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The longest file and the longest archive that is taken out of the archive of a class, and all of them together.
const LONGEST: [u64; 2] = [1 << 20, 8 << 20];
const TOGETHER: u64 = 512 << 20;
/// What systems leave in folders by themselves.
const LEFT_BY_SYSTEMS: [&str; 3] = ["Thumbs.db", "desktop.ini", "__MACOSX"];
/// Names that tell nothing of who handed in, at the end of a path.
const TELLS_NOTHING: [&str; 2] = ["src", "lab.rs"];

/// What one person handed in.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Submission {
    name: String,
    /// Longer and longer names; the last is as telling as there is.
    names: Vec<String>,
    pub(super) notes: Vec<String>,
    /// Whether the course system marks it as late; `None` if it marks nothing.
    marked_late: Option<bool>,
    pub(super) from: Source,
}

/// Why there is no class.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ClassError {
    /// A file or folder is not there, or cannot be listed.
    #[error("{}: {error}", path.display())]
    Unreadable {
        /// What.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// Nothing is in it.
    #[error("{}: is empty", path.display())]
    Empty {
        /// The folder or archive.
        path: PathBuf,
    },
    /// The archive of a class cannot be looked into.
    #[error("{}: {what}", path.display())]
    Archive {
        /// The archive.
        path: PathBuf,
        /// Why.
        what: String,
    },
}

impl Submission {
    /// The submission at a path that somebody named: a file, a folder, an archive. A link is followed, and the
    /// report says so.
    #[must_use]
    pub fn at(path: &Path) -> Self {
        let names = names_of(path);
        let link = fs::read_link(path).ok().map(|to| format!("this is a link to {}", to.display()));
        let mut notes: Vec<String> = link.into_iter().collect();
        let file = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let lms = Lms::parse(&file);
        notes.extend(lms.and_then(Lms::note));
        let marked_late = lms.and_then(|lms| lms.late);
        Self { name: names[0].clone(), names, notes, marked_late, from: Source::Path(path.to_path_buf()) }
    }

    /// Every submission of a class: those named one by one, and those in a folder or an archive of them. All have
    /// different names.
    ///
    /// In the folder of a class links are not followed: who can lay files there could name anything with them.
    ///
    /// # Errors
    /// [`ClassError`], if a path is not there, or the folder or archive holds nothing.
    pub fn class(paths: &[PathBuf], all_in: Option<&Path>) -> Result<Vec<Self>, ClassError> {
        let mut found = Vec::new();
        for path in paths {
            fs::metadata(path).map_err(|error| ClassError::Unreadable { path: path.clone(), error })?;
            found.push(Self::at(path));
        }
        if let Some(all_in) = all_in {
            let inside = if all_in.is_dir() { in_folder(all_in)? } else { in_archive(all_in)? };
            if inside.is_empty() {
                return Err(ClassError::Empty { path: all_in.to_path_buf() });
            }
            found.extend(inside);
        }
        tell_apart(&mut found);
        Ok(found)
    }

    /// What it is called in reports.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the course system marks it as late; `None` if its names tell nothing of that.
    #[must_use]
    pub fn marked_late(&self) -> Option<bool> {
        self.marked_late
    }

    /// When the youngest of these files was changed last, by the clock of this machine; `None` where that is not known.
    /// Archives count as one file.
    #[must_use]
    pub fn changed(&self, files: &[String]) -> Option<SystemTime> {
        let time = |path: &Path| fs::symlink_metadata(path).ok()?.modified().ok();
        let wanted: Vec<&str> = files.iter().map(|file| file.rsplit('/').next().unwrap_or(file)).collect();
        match &self.from {
            Source::Path(path) if path.is_dir() => {
                let parts = parts::of_folder(path, &wanted).unwrap_or_default();
                let on_disk = |part: Part| match part.content {
                    Content::OnDisk(path) => time(&path),
                    _ => None,
                };
                parts.into_iter().filter_map(on_disk).max()
            }
            Source::Path(path) => time(path),
            Source::Paths(paths) => paths.iter().filter_map(|(_, path)| time(path)).max(),
            _ => None,
        }
    }

    /// What is odd about how it was handed in.
    pub(crate) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Whether a list of the class means this one: by its name in reports, by the name of its file or folder, or by
    /// the number that the course system gave.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.names.iter().any(|own| own == name)
    }
}

/// The names of a path, the shortest first.
fn names_of(path: &Path) -> Vec<String> {
    // The path itself may be a link, whose name counts, in a folder whose own name may be `.`.
    let named = path.file_name().is_some();
    let full = match (path.parent(), path.file_name()) {
        (Some(parent), Some(name)) if named => {
            let parent = if parent.as_os_str().is_empty() { Path::new(".") } else { parent };
            parent.canonicalize().map(|parent| parent.join(name))
        }
        _ => path.canonicalize(),
    };
    let full = full.unwrap_or_else(|_| path.to_path_buf());
    let mut parts: Vec<String> = full.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    while parts.len() > 1 && TELLS_NOTHING.iter().any(|nothing| parts[parts.len() - 1].eq_ignore_ascii_case(nothing)) {
        parts.pop();
    }
    let name = parts.pop().unwrap_or_default();
    let mut names = short_names(&name);
    let mut long = name;
    for folder in parts.into_iter().rev().filter(|part| part != "/") {
        long = format!("{folder}/{long}");
        names.push(long.clone());
    }
    names
}

/// The names that a file or folder gives by itself.
fn short_names(name: &str) -> Vec<String> {
    if let Some(lms) = Lms::parse(name) {
        let full = name.to_owned();
        return vec![lms.name.to_owned(), format!("{} {}", lms.name, lms.id), lms.id.to_owned(), full];
    }
    let kind = parts::kind(name);
    let without = |end: &str| name.get(..name.len().saturating_sub(end.len())).unwrap_or(name).to_owned();
    let stem = match kind {
        Kind::None if name.ends_with(".rs") => without(".rs"),
        Kind::None => name.to_owned(),
        _ if name.to_lowercase().ends_with(".tar.gz") => without(".tar.gz"),
        _ => name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned(),
    };
    if stem == name || stem.is_empty() { vec![name.to_owned()] } else { vec![stem, name.to_owned()] }
}

/// A name as a course system makes it of what was handed in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Lms<'a> {
    name: &'a str,
    /// The number of the person.
    id: &'a str,
    /// What the file was called; empty for a folder.
    file: &'a str,
    /// Whether it is marked as late; Moodle marks nothing.
    late: Option<bool>,
    /// A text typed into a form, not a file.
    typed: bool,
}

impl<'a> Lms<'a> {
    fn parse(text: &'a str) -> Option<Self> {
        Self::moodle(text).or_else(|| Self::canvas(text))
    }

    /// `Anna Arndt_4711_assignsubmission_file_`, with the name of the file behind it where there are no folders.
    fn moodle(text: &'a str) -> Option<Self> {
        let (who, what) = text.split_once("_assignsubmission_")?;
        let (name, id) = who.rsplit_once('_').filter(|(name, id)| !name.is_empty() && is_number(id))?;
        let (kind, file) = what.split_once('_').unwrap_or((what, ""));
        Some(Self { name, id, file, late: None, typed: kind != "file" })
    }

    /// `arndtanna_LATE_4711_90210_lab.rs`: name, perhaps late, person, upload, file.
    fn canvas(text: &'a str) -> Option<Self> {
        let (name, rest) = text.split_once('_').filter(|(name, _)| !name.is_empty())?;
        let late = rest.strip_prefix("LATE_");
        let (id, rest) = late.unwrap_or(rest).split_once('_')?;
        let (upload, file) = rest.split_once('_')?;
        let numbers = [id, upload].iter().all(|number| number.len() >= 3 && is_number(number));
        let late = Some(late.is_some());
        (numbers && !file.is_empty()).then_some(Self { name, id, file, late, typed: false })
    }

    fn note(self) -> Option<String> {
        (self.late == Some(true)).then(|| "the course system marks it as late".to_owned())
    }
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Everything in a folder but what is hidden.
fn in_folder(folder: &Path) -> Result<Vec<Submission>, ClassError> {
    let cannot = |error: io::Error| ClassError::Unreadable { path: folder.to_path_buf(), error };
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if path.file_name().is_some_and(|name| !is_left_by_systems(&name.to_string_lossy())) {
            paths.push(path);
        }
    }
    paths.sort();
    let mut people: BTreeMap<(String, String), usize> = BTreeMap::new();
    let mut found: Vec<Submission> = Vec::new();
    for path in paths {
        let file = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut submission = Submission::at(&path);
        if path.is_symlink() {
            let to = fs::read_link(&path).map_or_else(|_| String::new(), |to| to.display().to_string());
            submission.from = Source::Link(to);
        }
        let Some(lms) = Lms::parse(&file).filter(|_| !path.is_symlink()) else {
            found.push(submission);
            continue;
        };
        let original = |lms: Lms, file: &str| if lms.file.is_empty() { file.to_owned() } else { lms.file.to_owned() };
        let one = (original(lms, &file), path.clone());
        let place = *people.entry((lms.name.to_owned(), lms.id.to_owned())).or_insert(found.len());
        match found.get_mut(place) {
            None => found.push(Submission { from: Source::Paths(vec![one]), ..submission }),
            Some(known) => {
                let new: Vec<String> =
                    submission.notes.into_iter().filter(|note| !known.notes.contains(note)).collect();
                known.notes.extend(new);
                known.marked_late = known.marked_late.max(submission.marked_late);
                if let Source::Paths(paths) = &mut known.from {
                    // What was typed into a form beside the files is none of them.
                    if !lms.typed {
                        paths.push(one);
                    }
                }
            }
        }
    }
    Ok(found)
}

fn is_left_by_systems(name: &str) -> bool {
    name.starts_with('.') || LEFT_BY_SYSTEMS.contains(&name)
}

/// Everything in the archive of a class, as course systems let it be downloaded.
fn in_archive(path: &Path) -> Result<Vec<Submission>, ClassError> {
    let unreadable = |error: io::Error| ClassError::Unreadable { path: path.to_path_buf(), error };
    fs::metadata(path).map_err(unreadable)?;
    let longest = |name: &str| Some(LONGEST[usize::from(parts::kind(name) != Kind::None)]);
    let keep = Keep { longest: &longest, together: TOGETHER };
    let parts = archive::of_file(path, &keep).map_err(unreadable)?;
    let parts = parts.map_err(|what| ClassError::Archive { path: path.to_path_buf(), what })?;
    let mut groups: BTreeMap<String, Submission> = BTreeMap::new();
    for part in without_the_folder_around(parts) {
        let (top, rest) = part.path.split_once('/').unwrap_or((&part.path, ""));
        if is_left_by_systems(top) {
            continue;
        }
        let lms = Lms::parse(top);
        let key = lms.map_or_else(|| top.to_owned(), |lms| format!("{}_{}", lms.name, lms.id));
        let inside = match (rest.is_empty(), lms) {
            (true, Some(lms)) => lms.file.to_owned(),
            (true, None) => top.to_owned(),
            (false, _) => rest.to_owned(),
        };
        let group = groups.entry(key).or_insert_with(|| {
            let names = short_names(top);
            let (notes, marked_late) = (Vec::new(), lms.and_then(|lms| lms.late));
            Submission { name: names[0].clone(), names, notes, marked_late, from: Source::Packed(Vec::new()) }
        });
        group.marked_late = group.marked_late.max(lms.and_then(|lms| lms.late));
        if let Some(note) = lms.and_then(Lms::note).filter(|note| !group.notes.contains(note)) {
            group.notes.push(note);
        }
        match (&mut group.from, part.content) {
            (from, Content::Link(to)) if rest.is_empty() => *from = Source::Link(to),
            (Source::Packed(parts), content) => parts.push(Part { path: inside, content }),
            _ => {}
        }
    }
    Ok(groups.into_values().collect())
}

/// Archives often have one folder around all of it; it is no submission itself if it holds several things none of
/// which is a lab's file.
fn without_the_folder_around(parts: Vec<Part>) -> Vec<Part> {
    let top = |part: &Part| part.path.split_once('/').map(|(top, _)| top.to_owned());
    let Some(around) = parts.first().and_then(top) else { return parts };
    let is_around = parts.iter().all(|part| top(part).as_ref() == Some(&around));
    let inside = |part: &Part| part.path[around.len() + 1..].to_owned();
    let is_one = || parts.iter().any(|part| ["lab.rs", "src/lab.rs"].contains(&inside(part).as_str()));
    if !is_around || Lms::parse(&around).is_some() || is_one() {
        return parts;
    }
    parts.iter().map(|part| Part { path: inside(part), content: part.content.clone() }).collect()
}

/// Makes names longer until they differ, and numbers those that have no longer ones.
fn tell_apart(submissions: &mut [Submission]) {
    let mut length = vec![0; submissions.len()];
    loop {
        let mut same: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (i, submission) in submissions.iter().enumerate() {
            same.entry(submission.name.to_lowercase()).or_default().push(i);
        }
        let mut changed = false;
        for i in same.into_values().filter(|group| group.len() > 1).flatten() {
            if let Some(longer) = submissions[i].names.get(length[i] + 1) {
                submissions[i].name.clone_from(longer);
                length[i] += 1;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for submission in submissions {
        let times = seen.entry(submission.name.to_lowercase()).or_default();
        *times += 1;
        if *times > 1 {
            submission.name = format!("{} ({times})", submission.name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_systems_leave_behind_and_what_is_hidden_is_no_submission() {
        for name in [".DS_Store", ".git", "Thumbs.db", "desktop.ini", "__MACOSX"] {
            assert!(is_left_by_systems(name), "{name}");
        }
        assert!(!is_left_by_systems("anna") && !is_left_by_systems("thumbs"));
    }

    #[test]
    fn a_number_of_a_person_is_all_digits() {
        assert!(is_number("4711"));
        assert!(!is_number("") && !is_number("47x") && !is_number("-1"));
        assert!(Lms::parse("Anna Arndt__assignsubmission_file_").is_none(), "there is no number");
    }

    #[test]
    fn only_a_folder_around_several_things_is_left_out() {
        let parts = |paths: &[&str]| -> Vec<Part> {
            let part = |path: &&str| Part { path: (*path).to_owned(), content: Content::Bytes(Vec::new()) };
            paths.iter().map(part).collect()
        };
        let left = |paths: &[&str]| -> Vec<String> {
            without_the_folder_around(parts(paths)).into_iter().map(|part| part.path).collect()
        };
        assert_eq!(left(&["class/anna/lab.rs", "class/bob/lab.rs"]), ["anna/lab.rs", "bob/lab.rs"]);
        for kept in [
            // Of two folders, of a person by the name that a course system gives, of one submission.
            &["anna/a/lab.rs", "bob/b/lab.rs"][..],
            &["Anna Arndt_4711_assignsubmission_file_/one.rs", "Anna Arndt_4711_assignsubmission_file_/two.rs"],
            &["anna/src/lab.rs", "anna/answers.md"],
            &["lab.rs"],
        ] {
            assert_eq!(left(kept), kept);
        }
    }
}
