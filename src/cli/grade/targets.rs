//! `FORMAT=FILE`: where a report goes.

use super::super::{Failure, Output, save};
use dcel_kit::files::{WholeFile, is_same_file};
use dcel_lab::Report;
use dcel_lab::reports::{Format, OneAtATime};
use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// What stands for the name of a submission in the name of a file.
const PLACE: &str = "{submission}";

/// Where in the folder of results the reports are.
pub(super) const REPORTS: &str = "reports";

/// A format and a file.
#[derive(Clone, Debug)]
pub(super) struct Target {
    format: Format,
    file: String,
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = || Format::ALL.map(Format::name).join(", ");
        let (name, file) = text.split_once('=').ok_or("write FORMAT=FILE, for example html=class.html")?;
        let format =
            Format::by_name(name).ok_or_else(|| format!("there is no format `{name}`; there is {}", known()))?;
        if file.is_empty() {
            return Err("after the `=` comes the name of a file, or `-`".to_owned());
        }
        Ok(Self { format, file: file.to_owned() })
    }
}

impl Target {
    pub(super) fn is_standard_output(&self) -> bool {
        self.file == "-"
    }

    /// Whether it is a file for each submission.
    pub(super) fn is_one_each(&self) -> bool {
        self.file.contains(PLACE)
    }

    /// Makes sure that all targets can be written, before there is anything to write: the folders are made, and a
    /// file is tried in each. `inputs` are files that are read; `class` is the folder of the submissions.
    pub(super) fn check_all(
        targets: &[Self],
        reports: usize,
        inputs: &[&PathBuf],
        class: Option<&Path>,
    ) -> Result<(), Failure> {
        for (i, target) in targets.iter().enumerate() {
            if targets[..i].iter().any(|earlier| earlier.file == target.file) {
                return Err(Failure::input(format!("{}: two reports go there", target.file), "name two files"));
            }
            if reports != 1 && !target.is_one_each() && !target.format.holds_a_class() {
                return Err(Failure::helped("", OneAtATime(target.format)));
            }
            if target.is_standard_output() {
                continue;
            }
            let file = Path::new(&target.file);
            if inputs.iter().any(|input| is_same_file(input, file)) {
                return Err(Failure::input(format!("{}: this is an input", target.file), "choose another name"));
            }
            if file.is_dir() {
                let help = "give the name of a file in it";
                return Err(Failure::input(format!("{}: is a directory", target.file), help));
            }
            if file.exists() && !file.is_file() {
                // A pipe or a device is written to as it is.
                continue;
            }
            // With a place for names in a folder's name, only what is before it is known.
            let known = target.file.split(PLACE).next().unwrap_or_default();
            let known = if target.is_one_each() { Path::new(known).parent() } else { file.parent() };
            try_folder(known.unwrap_or(Path::new("")), class)?;
        }
        Ok(())
    }

    /// Writes a class into one file.
    pub(super) fn write(&self, reports: &[Report], out: &mut Output) -> Result<(), Failure> {
        let text = match reports {
            [report] => self.format.one(report),
            _ => self.format.class(reports).map_err(|error| Failure::helped("", error))?,
        };
        self.put(&self.file, &text, out)
    }

    /// Writes one submission into a file of its own.
    pub(super) fn write_one(&self, report: &Report, name: &str, out: &mut Output) -> Result<(), Failure> {
        self.put(&self.file.replace(PLACE, name), &self.format.one(report), out)
    }

    fn put(&self, file: &str, text: &str, out: &mut Output) -> Result<(), Failure> {
        if self.is_standard_output() {
            return Ok(out.write_all(text.as_bytes())?);
        }
        put(Path::new(file), text)
    }
}

/// Writes a file whole, and makes its folder if it is not there.
pub(super) fn put(file: &Path, text: &str) -> Result<(), Failure> {
    if let Some(parent) = file.parent() {
        fs::create_dir_all(parent).map_err(|error| Failure::writing(parent.display(), &error))?;
    }
    save::put(file, text)
}

/// Makes a folder and tries to write there. What is written among the submissions would be taken for one.
pub(super) fn try_folder(folder: &Path, class: Option<&Path>) -> Result<(), Failure> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let cannot = |error: std::io::Error| Failure::writing(folder.display(), &error);
    let inside = |folder: &Path| {
        let there = folder.ancestors().find_map(|part| part.canonicalize().ok()).unwrap_or_default();
        class.and_then(|class| class.canonicalize().ok()).is_some_and(|class| there.starts_with(class))
    };
    if inside(folder) {
        let what = format!("{}: lies among the submissions, and would be taken for one", folder.display());
        return Err(Failure::input(what, "name a place outside of the folder given with --all-in"));
    }
    fs::create_dir_all(folder).map_err(cannot)?;
    // It goes again without ever having had its name.
    WholeFile::create(&folder.join("trial")).map(drop).map_err(cannot)
}

/// Names as parts of files' names, a different one for each, also where upper and lower case are one.
pub(super) fn file_names(names: &[String]) -> Vec<String> {
    let mut taken = BTreeSet::new();
    names.iter().map(|name| free_name(name, &mut taken)).collect()
}

fn free_name(name: &str, taken: &mut BTreeSet<String>) -> String {
    let plain: String =
        name.chars().map(|c| if c.is_alphanumeric() || "-_.@+ ()".contains(c) { c } else { '_' }).take(100).collect();
    let plain = plain.trim_matches(['.', ' ']).to_owned();
    let plain = if plain.is_empty() { "submission".to_owned() } else { plain };
    let numbered = |i: u32| if i == 1 { plain.clone() } else { format!("{plain}-{i}") };
    let name = (1..).map(numbered).find(|name| !taken.contains(&name.to_lowercase())).unwrap_or_else(|| numbered(0));
    taken.insert(name.to_lowercase());
    name
}
