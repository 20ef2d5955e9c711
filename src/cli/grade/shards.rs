//! A class graded in parts, on several machines, and put together again.
//!
//! ```text
//!   dcel grade 04 --all-in class --seed 7 --shard 1/3 --results one ─┐
//!                                         --shard 2/3 --results two ─┼─▶ dcel grade 04 --merge one two three
//!                                         --shard 3/3 --results three┘
//! ```
//!
//! Every part sees the whole class: names, what looks alike, who is missing. Equal files are graded in one part. What is
//! put together is what one machine would have written, times aside.

use super::super::Failure;
use super::stored_file;
use super::targets::{REPORTS, put};
use dcel_lab::Report;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// What a part says of itself.
const NOTE: &str = "shard.json";

/// One of several parts: `2/3`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Shard {
    /// From 1.
    part: usize,
    parts: usize,
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(part, parts)| Some((part.parse().ok()?, parts.parse().ok()?)));
        match numbers {
            Some((part, parts)) if (1..=parts).contains(&part) => Ok(Self { part, parts }),
            _ => Err("write PART/PARTS, for example 1/4, 2/4, 3/4 and 4/4".to_owned()),
        }
    }
}

impl Shard {
    /// The part from 0, and how many there are.
    pub(super) fn of(self) -> (usize, usize) {
        (self.part - 1, self.parts)
    }

    /// Whether it is the part that tells of who handed in nothing.
    pub(super) fn is_first(self) -> bool {
        self.part == 1
    }

    /// Says in the folder of the results what they are a part of. `files` are the names of the files of the whole class.
    pub(super) fn note(self, results: &Path, seed: u64, files: &[String]) -> Result<(), Failure> {
        let note = Note { part: self.part, parts: self.parts, seed, class: files.to_vec() };
        put(&results.join(NOTE), &serde_json::to_string_pretty(&note)?)
    }
}

#[derive(Serialize, Deserialize, PartialEq, Debug)]
struct Note {
    part: usize,
    parts: usize,
    seed: u64,
    class: Vec<String>,
}

/// The reports of all parts, in the order of the class. That all are there, once, and belong together, is checked.
pub(super) fn merged(folders: &[PathBuf]) -> Result<Vec<Report>, Failure> {
    const HELP: &str = "name the folder that `dcel grade --shard PART/PARTS --results DIR` wrote, one for each part";
    let mut notes: Vec<(&PathBuf, Note)> = Vec::new();
    for folder in folders {
        let file = folder.join(NOTE);
        let wrong = |what: String| Failure::input(format!("{}: {what}", file.display()), HELP);
        let text = fs::read_to_string(&file).map_err(|error| wrong(error.to_string()))?;
        let note: Note = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
        if let Some((other, _)) = notes.iter().find(|(_, other)| other.part == note.part) {
            return Err(wrong(format!("this is part {}, as {} is", note.part, other.display())));
        }
        let differs = |other: &Note| (other.parts, other.seed, &other.class) != (note.parts, note.seed, &note.class);
        if let Some((other, _)) = notes.first().filter(|(_, other)| differs(other)) {
            let what =
                format!("a part of another grading than {}: class, seed or number of parts differ", other.display());
            return Err(wrong(what));
        }
        notes.push((folder, note));
    }
    let Some((_, first)) = notes.first() else { return Ok(Vec::new()) };
    let open: Vec<String> = (1..=first.parts)
        .filter(|part| notes.iter().all(|(_, note)| note.part != *part))
        .map(|part| format!("{part}/{}", first.parts))
        .collect();
    if !open.is_empty() {
        return Err(Failure::input(format!("part {} is missing", open.join(", ")), HELP));
    }
    let mut reports = Vec::new();
    for name in &first.class {
        let places = folders.iter().map(|folder| folder.join(REPORTS).join(format!("{name}.json")));
        match &places.filter(|place| place.is_file()).collect::<Vec<_>>()[..] {
            [place] => reports.extend(stored_file(place)?),
            [] => {
                let help = "a part was not finished: give its command again, it goes on where it stopped";
                return Err(Failure::input(format!("{name}: no part has a report of it"), help));
            }
            [one, other, ..] => {
                let what = format!("{} and {}: two reports of one submission", one.display(), other.display());
                return Err(Failure::input(what, "give each part a folder of its own"));
            }
        }
    }
    Ok(reports)
}
