//! The reports of a class on their way into files.
//!
//! ```text
//!   report ─▶ DIR/students/NAME.html  DIR/reports/NAME.json  {submission}-targets     at once
//!          ─▶ DIR/class.html  DIR/class.csv  targets of the class                     now and then, and at the end
//! ```
//!
//! Tables are written again when the last writing is long enough ago to cost little. Every file is replaced whole.
//! Without a target that tells everything of everybody, only what the tables need stays in memory.

use super::super::{Failure, Output, failure};
use super::lists::Resolved;
use super::shards::Shard;
use super::targets::{REPORTS, Target, file_names, put, try_folder};
use super::{Args, fs};
use dcel_lab::reports::{Format, index};
use dcel_lab::{Lab, Report};
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Where in the folder of results the pages of students are, and what was kept to go on with.
const STUDENTS: &str = "students";
pub(super) const KEPT: &str = ".kept";
/// How often tables are written, at most; and how many times longer than a writing the pause to the next one is.
const PAUSE: Duration = Duration::from_secs(1);
const RATIO: u32 = 10;

/// A class whose reports come one after the other.
#[derive(Debug)]
pub(super) struct Class<'a> {
    targets: &'a [Target],
    results: Option<PathBuf>,
    shard: Option<Shard>,
    /// The names of files, by submission, then those of who handed in nothing.
    files: Vec<String>,
    reports: Vec<Option<Report>>,
    missing: Vec<Report>,
    /// Whether a target tells everything of everybody.
    whole: bool,
    written: Instant,
    pause: Duration,
}

impl<'a> Class<'a> {
    /// A class of `count` submissions. All places are tried.
    pub(super) fn new(args: &'a Args, lab: &Lab, lists: &Resolved, count: usize) -> Result<Self, Failure> {
        let mut missing = lists.missing(lab);
        let inputs: Vec<&PathBuf> =
            [&args.names, &args.adjust, &args.secret, &args.from_report, &args.course, &args.metadata, &args.times]
                .into_iter()
                .flatten()
                .collect();
        let class = args.all_in.as_deref();
        Target::check_all(&args.reports, count + missing.len(), &inputs, class)?;
        let mut names = lists.names.clone();
        names.extend(missing.iter().filter_map(|report| report.submission.clone()));
        let files = file_names(&names);
        if args.shard.is_some_and(|shard| !shard.is_first()) {
            missing.clear();
        }
        if let Some(results) = &args.results {
            for folder in [results.clone(), results.join(STUDENTS), results.join(REPORTS)] {
                try_folder(&folder, class)?;
            }
            note_strangers(&results.join(REPORTS), &files);
        }
        if let Some(cache) = &args.cache {
            try_folder(cache, class)?;
        }
        Ok(Self {
            targets: &args.reports,
            results: args.results.clone(),
            shard: args.shard,
            files,
            reports: vec![None; count],
            missing,
            whole: args.results.is_none() || args.reports.iter().any(|target| !target.is_one_each()),
            written: Instant::now(),
            pause: PAUSE,
        })
    }

    /// Says in the folder of the results what part of a class it is, if it is one.
    pub(super) fn note_shard(&self, seed: u64) -> Result<(), Failure> {
        match (self.shard, &self.results) {
            (Some(shard), Some(results)) => shard.note(results, seed, &self.files),
            _ => Ok(()),
        }
    }

    /// Takes the report of submission `i`, and writes what is of this one alone.
    pub(super) fn take(&mut self, i: usize, report: Report, out: &mut Output) -> Result<(), Failure> {
        self.write_one(&report, i, out)?;
        self.reports[i] = Some(if self.whole { report } else { report.without_details() });
        if self.written.elapsed() >= self.pause {
            let begin = Instant::now();
            self.write_tables(&self.so_far(), false, out)?;
            self.written = Instant::now();
            self.pause = PAUSE.max(begin.elapsed() * RATIO);
        }
        Ok(())
    }

    /// Writes all that there is, and gives it back.
    pub(super) fn finish(self, out: &mut Output) -> Result<Vec<Report>, Failure> {
        for (i, report) in self.missing.iter().enumerate() {
            self.write_one(report, self.reports.len() + i, out)?;
        }
        let reports: Vec<Report> = self.so_far();
        self.write_tables(&reports, true, out)?;
        if !self.targets.iter().any(Target::is_standard_output) {
            let text = match reports.as_slice() {
                [report] => Format::Text.one(report),
                several => Format::Text.class(several).map_err(Failure::kit)?,
            };
            write!(out, "{text}")?;
        }
        Ok(reports)
    }

    /// The same if a report came; else files stay as they are.
    pub(super) fn finish_if_any(self, out: &mut Output) -> Result<(), Failure> {
        if self.reports.iter().any(Option::is_some) { self.finish(out).map(drop) } else { Ok(()) }
    }

    fn so_far(&self) -> Vec<Report> {
        self.reports.iter().flatten().chain(&self.missing).cloned().collect()
    }

    fn write_one(&self, report: &Report, i: usize, out: &mut Output) -> Result<(), Failure> {
        let name = &self.files[i];
        if let Some(results) = &self.results {
            put(&results.join(STUDENTS).join(format!("{name}.html")), &Format::Html.one(&report.for_its_author()))?;
            put(&results.join(REPORTS).join(format!("{name}.json")), &Format::Json.one(report))?;
        }
        self.targets.iter().filter(|target| target.is_one_each()).try_for_each(|t| t.write_one(report, name, out))
    }

    /// Writes the tables; what goes to standard output only when it is the last time.
    fn write_tables(&self, reports: &[Report], last: bool, out: &mut Output) -> Result<(), Failure> {
        let of_class = self.targets.iter().filter(|target| !target.is_one_each());
        for target in of_class.filter(|target| last || !target.is_standard_output()) {
            target.write(reports, out)?;
        }
        if let Some(results) = &self.results {
            put(&results.join("statistics.csv"), &Format::Statistics.class(reports).map_err(Failure::kit)?)?;
            let there = self.reports.iter().map(Option::is_some).chain(self.missing.iter().map(|_| true));
            let names = self.files.iter().zip(there).filter(|(_, there)| *there);
            let pages: Vec<String> = names.map(|(name, _)| format!("{STUDENTS}/{name}.html")).collect();
            put(&results.join("class.html"), &index(reports, &pages, self.files.len()))?;
            put(&results.join("class.csv"), &Format::Csv.class(reports).map_err(Failure::kit)?)?;
        }
        Ok(())
    }
}

/// Names reports that lie in the folder and are of nobody in the class.
fn note_strangers(folder: &std::path::Path, files: &[String]) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let known = |name: &str| name.strip_suffix(".json").is_none_or(|name| files.iter().any(|file| file == name));
    let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    for name in names.filter(|name| !known(name)) {
        let file = folder.join(name);
        failure::say("note", format_args!("{}: of a submission that is not there any more", file.display()));
    }
}
