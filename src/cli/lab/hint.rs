//! `dcel lab hint`: help in three levels, one at a time.
//!
//! ```text
//!   dcel lab check ──▶ target/check/hints.json      the task at hand, and which hints were given
//!   dcel lab hint  ──▶ the next hint of that task
//! ```

use super::super::choice::{whole, within};
use super::super::{Answer, Failure, Output};
use super::folder;
use dcel_lab::{Lab, LabFiles, Report};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Get a hint: a nudge, then a pointer, then nearly the code
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Without a number it is the next hint of the task at hand: the first one that failed in the last `dcel lab check`, or \
else the first one that is still to be written. `dcel lab list 04` lists the tasks.

Examples:
  dcel lab hint
  dcel lab hint 5
  dcel lab hint 5 --level 2")]
pub(crate) struct Args {
    /// The number of a task; without it, the next hint of the task at hand
    #[arg(value_name = "TASK", value_parser = whole::<u32>)]
    task: Option<u32>,
    /// 1 a nudge, 2 a pointer, 3 nearly the code; without it, 1 for a task that is named
    #[arg(long, value_name = "LEVEL", value_parser = within(1u8..=3))]
    level: Option<u8>,
    /// The lab's folder; without it, the one you are in
    #[arg(long, value_name = "DIR")]
    dir: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let dir = folder::find(args.dir.as_deref())?;
    let mut book = Book::read(&dir);
    let (task, level) = match (args.task, args.level) {
        (Some(task), level) => (task, level.unwrap_or(1)),
        (None, Some(level)) => (book.task.unwrap_or(1), level),
        (None, None) => return next(&dir, args.dir.as_deref(), out),
    };
    let told = tell(&dir, task, level, args.dir.as_deref(), out)?;
    if told {
        book.give(task, level);
        book.write(&dir);
    }
    Ok(Answer::Yes)
}

/// The next hint of the task at hand. `named` is the folder as the user named it.
pub(super) fn next(dir: &Path, named: Option<&Path>, out: &mut Output) -> Result<Answer, Failure> {
    let mut book = Book::read(dir);
    if book.checked && book.task.is_none() {
        writeln!(out, "Everything passed in the last check. Name a task for its hints: dcel lab hint 5")?;
        return Ok(Answer::Yes);
    }
    let task = book.task.unwrap_or(1);
    if !book.checked {
        let check = typed("dcel lab check", named.map(|dir| ("", dir)));
        writeln!(out, "Nothing was checked yet, so this is for the first task. `{check}` finds the task at hand.\n")?;
    }
    let level = book.given.get(&task).map_or(1, |&level| level + 1);
    if tell(dir, task, level, named, out)? {
        book.give(task, level);
        book.write(dir);
    }
    Ok(Answer::Yes)
}

/// Writes one hint; whether there is one.
fn tell(dir: &Path, number: u32, level: u8, named: Option<&Path>, out: &mut Output) -> Result<bool, Failure> {
    let manifest = folder::manifest(dir)?;
    let Lab { manifest, files, .. } = super::lab(&manifest.name)?;
    let Some(task) = manifest.task(number) else {
        let what = format!("there is no task {number}");
        return Err(Failure::input(what, format!("the tasks are 1 to {}", manifest.tasks.len())));
    };
    writeln!(out, "Task {number}: {}\n", task.title)?;
    let levels = levels(&files, number);
    let command =
        |level: usize| typed(&format!("dcel lab hint {number} --level {level}"), named.map(|dir| ("--dir ", dir)));
    let Some((heading, text)) = levels.get(usize::from(level) - 1) else {
        writeln!(out, "There is no further hint: ask your instructor.")?;
        if !levels.is_empty() {
            writeln!(out, "The last one again: {}", command(levels.len()))?;
        }
        return Ok(false);
    };
    writeln!(out, "{heading}\n\n{}", text.trim())?;
    writeln!(out, "\nThis one again: {}", command(level.into()))?;
    if usize::from(level) < levels.len() {
        writeln!(out, "More:           {}", command(usize::from(level) + 1))?;
    }
    Ok(true)
}

/// A command as it is typed, with a folder if one was named.
fn typed(command: &str, dir: Option<(&str, &Path)>) -> String {
    dir.map_or_else(|| command.to_owned(), |(flag, dir)| format!("{command} {flag}{}", dcel_lab::typed(dir)))
}

/// The headings and texts of a task's hints.
fn levels(files: &LabFiles, task: u32) -> Vec<(&str, &str)> {
    let text = files.get(&format!("hints/task-{task}.md")).unwrap_or_default();
    text.split("\n## ").skip(1).map(|part| part.split_once('\n').unwrap_or((part, ""))).collect()
}

/// Where it is remembered.
const HINTS: &str = "hints.json";

/// What is remembered between two commands. If it is lost, hints begin anew.
#[derive(Serialize, Deserialize, Default, Debug)]
struct Book {
    /// Whether there was a check.
    checked: bool,
    /// The task at hand; none if everything passed.
    task: Option<u32>,
    /// The level of the last hint that was given for each task.
    #[serde(default)]
    given: BTreeMap<u32, u8>,
}

impl Book {
    fn read(dir: &Path) -> Self {
        folder::remembered(dir, HINTS).unwrap_or_default()
    }

    /// Nothing is lost with it but the place in the list of hints.
    fn write(&self, dir: &Path) {
        folder::remember(dir, HINTS, self);
    }

    fn give(&mut self, task: u32, level: u8) {
        let last = self.given.entry(task).or_default();
        *last = (*last).max(level);
    }
}

/// Remembers the task at hand after a check.
pub(super) fn remember(dir: &Path, report: &Report) {
    if report.message.is_none() {
        let book = Book { checked: true, task: report.next_test().map(|test| test.task), ..Book::read(dir) };
        book.write(dir);
    }
}
