//! `dcel grade`: submissions in, reports out.
//!
//! ```text
//!   folders and files ─▶ Grader (barriers, one room each) ─▶ Report ─┐
//!   stored reports    ──────────────────────────────────▶ Report ─┼─▶ names, adjustments ─▶ formats
//!   names without a submission ─▶ "nothing was handed in" ────────┘
//! ```
//!
//! Lists, targets and folders are checked before the first submission is graded, reports are written as they come.
//!
//! ```text
//!   class.rs    The reports of a class on their way into files
//!   lists.rs    Lists of the class
//!   shards.rs   A class in parts, on several machines
//!   signals.rs  Ctrl-C and the like, as a wish to stop
//!   targets.rs  Where reports go
//!   terms.rs    What a course says of the lab, and when each submission was handed in
//! ```

mod class;
mod lists;
mod shards;
mod signals;
mod targets;
mod terms;

use super::choice::{number, positive, whole, within};
use super::input::{files_ending, text_of};
use super::{Answer, Failure, Output, failure};
use class::{Class, KEPT};
use dcel_kit::files::ScratchFolder;
use dcel_lab::{
    ClassError, GradeOptions, Grader, Hidden, Lab, OWN_CASES, Outcome, Plan, Report, Secret, Stop, Submission, Verdict,
};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lists::Lists;
use shards::Shard;
use signals::Signals;
use std::fs;
use std::io::{IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use targets::Target;
use terms::Terms;

pub(super) use terms::course;

/// Grade one submission, or a whole class
#[derive(clap::Args, Debug)]
#[command(after_help = "\
A submission is a folder that `dcel lab start` made, the student's file alone, or a .zip or .tar.gz of either. It is \
built and run in the sandbox; the report names those that stood and those that could not be had. A submission that does \
its worst gets a report that says so, and the next one is graded. Submissions with equal files are graded once.

A class is a folder, or the .zip that a course system lets you download: names as Canvas and Moodle make them are \
understood. Rows are called by person, folder or file, with as much of the path as tells them apart.

--results DIR writes, while it goes on:
  DIR/class.html class.csv   the tables
  DIR/statistics.csv         what the class makes of each test
  DIR/students/NAME.html     a page to hand back, for each
  DIR/reports/NAME.json      all there is to know, for --from-report DIR
Ctrl-C leaves what is done there, and the same command goes on where it stopped: only what is new or has changed \
is graded (a submission, the lab, a limit, the seed, this program or rustc).

--own DIR runs the own tests that were handed in against the solution and the known mistakes of the lab: DIR is the \
folder `labs` of a checkout. The report says how many mistakes they catch, and never which.

--shard PART/PARTS grades one part of a class, for a matrix of machines: each is given the whole class, the same seed \
and a folder of its own for --results; --merge puts these folders together.

Submissions that look alike are named in the reports of a class, names and comments aside, and never in those that \
a student gets. Compare them yourself: honest answers to small tasks are similar.

--course FILE takes points, needs, limits, visibility, bounds, hidden cases, the due date and the late rule from a \
course.toml (labs/README.md has a whole one). When something was handed in is taken from --times, else from --metadata, \
else from the LATE in a name of Canvas, and for want of a better one from the time of the file; the report says which. \
With --from-report a changed course is applied to what was graded before.

Formats: text html markdown json junit csv bugs statistics hold a class; gradescope classroom50 exercism hold one submission: \
with several, write {submission} where its name shall stand in the file's.

Exit code 0 once all reports are written, whatever the grades; --fail-under changes that. 3 if the grader itself \
fails whatever it is given: then no report tells of it. 130 after Ctrl-C, 143 after SIGTERM.

Examples:
  dcel grade 04 my-lab
  dcel grade 04 --all-in submissions --results graded
  dcel grade 04 --all-in submissions.zip --report html=class.html --report csv=class.csv
  dcel grade 04 lab.rs --report gradescope=results.json
  dcel grade 04 --all-in submissions --seed 7 --shard 1/1 --results part1
  dcel grade 04 --merge part1 --results together
  dcel grade 04 --all-in submissions --course course.toml --results graded
  dcel grade 04 --from-report class.json --adjust late.csv --report csv=final.csv")]
pub(crate) struct Args {
    /// The lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: String,
    /// Submissions: folders or files
    #[arg(value_name = "SUBMISSION", required_unless_present_any = ["all_in", "from_report", "merge"])]
    submissions: Vec<PathBuf>,
    /// Every file and folder in this folder or .zip is a submission, but for hidden ones
    #[arg(long, value_name = "DIR")]
    all_in: Option<PathBuf>,
    /// Reports stored as json, or a folder of --results, instead of submissions: nothing is run
    #[arg(long, value_name = "FILE", conflicts_with_all = ["submissions", "all_in", "results", "cache", "again"])]
    from_report: Option<PathBuf>,
    /// Grade one part of the class, for example 2/4: the others are graded elsewhere, with the same seed
    #[arg(long, value_name = "PART/PARTS", requires = "results", conflicts_with_all = ["from_report", "merge"])]
    shard: Option<Shard>,
    /// Put the --results of all parts together: nothing is run
    #[arg(long, value_name = "DIR", num_args = 1.., conflicts_with_all = ["submissions", "all_in", "from_report", "cache", "again"])]
    merge: Vec<PathBuf>,
    /// Write a report: a format and a file, `-` for standard output; may be given several times
    #[arg(long = "report", value_name = "FORMAT=FILE")]
    reports: Vec<Target>,
    /// A folder for the tables, a page and a report for each submission; a second call goes on where the first stopped
    #[arg(long, value_name = "DIR")]
    results: Option<PathBuf>,
    /// Grade again what --results or --cache has kept
    #[arg(long)]
    again: bool,
    /// Name pairs of submissions of which so much is the same, in percent, names and comments aside
    #[arg(long, value_name = "PERCENT", default_value_t = 80, value_parser = within(1u8..=100))]
    similar: u8,
    /// The seed of the random cases; without it, one is drawn for the batch
    #[arg(long, value_name = "NUMBER", value_parser = whole::<u64>)]
    seed: Option<u64>,
    /// Hidden cases: a file with your own seed and weights, kept away from students
    #[arg(long, value_name = "FILE")]
    secret: Option<PathBuf>,
    /// A class list, CSV with the columns submission,name; who is not there gets a report that says so
    #[arg(long, value_name = "FILE")]
    names: Option<PathBuf>,
    /// Points for answers or lateness, CSV with the columns submission,points,reason
    #[arg(long, value_name = "FILE")]
    adjust: Option<PathBuf>,
    /// A course: points, limits, due date and late rule of this lab
    #[arg(long, value_name = "FILE")]
    course: Option<PathBuf>,
    /// When the one submission was handed in: the submission_metadata.json of Gradescope
    #[arg(long, value_name = "FILE", requires = "course", conflicts_with = "times")]
    metadata: Option<PathBuf>,
    /// When each was handed in, CSV with the columns submission,handed_in and, for who has an own date, due
    #[arg(long, value_name = "FILE", requires = "course")]
    times: Option<PathBuf>,
    /// Judge own tests (tests/own.txt): the folder of the labs with their solutions
    #[arg(long, value_name = "DIR", conflicts_with_all = ["from_report", "merge"])]
    own: Option<PathBuf>,
    /// Exit code 1 if a submission has less than this share of the points, in percent
    #[arg(long, value_name = "PERCENT", value_parser = number)]
    fail_under: Option<f64>,
    /// A folder that keeps reports, and the seed if none is given: equal files are not graded again
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// How many are graded at the same time; without it, one for each core
    #[arg(long, value_name = "NUMBER", value_parser = positive)]
    workers: Option<NonZeroUsize>,
}

impl Args {
    /// Whether submissions are built and run, so that Ctrl-C is a wish to stop.
    pub(crate) fn runs_programs(&self) -> bool {
        self.from_report.is_none() && self.merge.is_empty()
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = super::lab::lab(&args.lab)?;
    let terms = Terms::read(args, &lab)?;
    let lab = terms.applied_to(lab);
    let lists = terms.lists(Lists::read(args.names.as_deref(), args.adjust.as_deref())?, args.times.as_deref())?;
    let (reports, end) = match &args.from_report {
        None if !args.merge.is_empty() => (again(args, &lab, &terms, &lists, shards::merged(&args.merge)?, out)?, None),
        Some(place) => (again(args, &lab, &terms, &lists, stored(place)?, out)?, None),
        None => graded(args, &lab, &terms, &lists, out)?,
    };
    if let Some(failure) = end {
        out.flush()?;
        return Err(failure);
    }
    let share = |report: &Report| report.points().as_f64() * 100.0 / report.max_points().as_f64().max(1e-9);
    let too_low = args.fail_under.is_some_and(|least| reports.iter().any(|report| share(report) < least));
    Ok(if too_low { Answer::No } else { Answer::Yes })
}

/// Reports that were stored, written again.
fn again(
    args: &Args,
    lab: &Lab,
    terms: &Terms,
    lists: &Lists,
    mut reports: Vec<Report>,
    out: &mut Output,
) -> Result<Vec<Report>, Failure> {
    let own: Vec<&str> = reports.iter().map(|report| report.submission.as_deref().unwrap_or_default()).collect();
    if let Some(other) = reports.iter().find(|report| report.lab != lab.name) {
        let what = format!("a stored report is of {}, not of {}", other.lab, lab.name);
        return Err(Failure::input(what, format!("write `dcel grade {}`", other.lab)));
    }
    terms.check_count(reports.len())?;
    let lists = lists.resolve(&own, |_, _| false)?;
    for (i, report) in reports.iter_mut().enumerate() {
        lists.apply(i, report);
        terms.settle(report, lists.time(i));
    }
    let mut class = Class::new(args, lab, &lists, reports.len())?;
    for (i, report) in reports.into_iter().enumerate() {
        class.take(i, report, out)?;
    }
    class.finish(out)
}

/// Grades the submissions, and writes the reports as they come; a bar shows how far it is where somebody watches.
/// What is there is written, also if it is not all: then with the reason.
fn graded(
    args: &Args,
    lab: &Lab,
    terms: &Terms,
    lists: &Lists,
    out: &mut Output,
) -> Result<(Vec<Report>, Option<Failure>), Failure> {
    let submissions = Submission::class(&args.submissions, args.all_in.as_deref()).map_err(|error| no_class(&error))?;
    terms.check_count(submissions.len())?;
    let room = ScratchFolder::new("dcel-own").map_err(|error| Failure::writing("a temporary folder", &error))?;
    let known = match &args.own {
        Some(labs) => Some(super::lab::known_mistakes(lab, labs, room.path())?),
        None => terms.check_own_tests().map(|()| None)?,
    };
    let own: Vec<&str> = submissions.iter().map(Submission::name).collect();
    let lists = lists.resolve(&own, |i, name| submissions[i].is_called(name))?;
    let mut class = Class::new(args, lab, &lists, submissions.len())?;
    let kept = args.cache.clone().or_else(|| args.results.as_ref().map(|results| results.join(KEPT)));
    let secret = args.secret.as_deref().map(|file| secret(file, lab)).transpose()?;
    let secret = secret.or_else(|| terms.secret().map(|(_, secret)| secret.clone()));
    let plan = Plan { secret, ..plan(args, kept.as_deref())? };
    class.note_shard(plan.seed)?;
    let stop = Stop::new();
    let signals = Signals::wish(&stop).map_err(|error| Failure::machine(format!("signals: {error}"), ""))?;
    let options = GradeOptions {
        workers: args.workers,
        hidden: hidden(args, terms),
        cache: kept,
        keep_deadlines: args.results.is_some(),
        again: args.again,
        similar_from: args.similar,
        shard: args.shard.map(Shard::of),
        stop: stop.clone(),
        ..GradeOptions::default()
    };
    let grader = Grader::new(with_own_tests(lab, known.is_some()), &options)
        .map_err(|error| Failure::writing("a folder for the work", &error))?;
    let bar = bar(submissions.len());
    let mut failed = None;
    let outcome = grader.grade_all(&submissions, &plan, |i, mut report| {
        if report.verdict == Verdict::GraderFault {
            let message = report.message.as_deref().unwrap_or("see its report");
            bar.suspend(|| failure::say("grader fault", format_args!("{}: {message}", submissions[i].name())));
        }
        lists.apply(i, &mut report);
        if let Some(known) = known.as_ref().filter(|_| report.verdict != Verdict::GraderFault) {
            let text = report.attachments.iter().find(|(path, _)| path == OWN_CASES).map(|(_, text)| text.as_str());
            report.terms.own_tests = Some(known.caught_by_text(text));
        }
        terms.settle(&mut report, terms.when(&lists, i, &submissions[i]));
        if let Err(error) = class.take(i, report, out)
            && failed.is_none()
        {
            // Nothing can be written any more: to go on would be for nothing.
            stop.stop();
            failed = Some(error);
        }
        bar.inc(1);
    });
    bar.finish_and_clear();
    let complaints = grader.complaints();
    // The folders of the work go before anything else can fail.
    drop(grader);
    complaints.iter().for_each(|complaint| failure::say("note", complaint));
    if let Some(failure) = failed {
        return Err(failure);
    }
    if let Outcome::Fault(why) = &outcome {
        let what = format!("the grader fails whatever it is given: {why}");
        let help = "no report says anything of this; mend the cause and give the same command again";
        class.finish_if_any(out)?;
        return Err(Failure::machine(what, help));
    }
    let reports = class.finish(out)?;
    let end = match outcome {
        Outcome::Stopped { left } => {
            let what = format!("stopped: {} of {} graded", submissions.len() - left, submissions.len());
            let help = if options.cache.is_some() {
                "the same command goes on where it stopped"
            } else {
                "with --results DIR the same command would go on where it stopped"
            };
            Some(Failure::signal(signals.came().unwrap_or(2), what, help))
        }
        _ if !reports.is_empty() && reports.iter().all(|report| report.verdict == Verdict::GraderFault) => {
            Some(Failure::machine("not one submission could be graded", "see what is said of each above"))
        }
        _ => None,
    };
    Ok((reports, end))
}

/// The lab, of which own tests are taken in, too.
fn with_own_tests(lab: &Lab, are_taken: bool) -> Lab {
    let mut lab = lab.clone();
    if are_taken && !lab.manifest.optional.iter().any(|path| path == OWN_CASES) {
        lab.manifest.optional.push(OWN_CASES.to_owned());
    }
    lab
}

fn no_class(error: &ClassError) -> Failure {
    let help = match error {
        ClassError::Unreadable { .. } => "name a folder or a file",
        ClassError::Empty { .. } => "put a file or folder there for each",
        _ => "name the folder that holds the submissions, or a .zip of it",
    };
    let what = match error {
        ClassError::Unreadable { path, error } if error.kind() == std::io::ErrorKind::NotFound => {
            format!("{}: is not there", path.display())
        }
        other => other.to_string(),
    };
    Failure::input(what, help)
}

/// The seed that was asked for, or the one that belongs to the kept reports, or a fresh one.
fn plan(args: &Args, kept: Option<&Path>) -> Result<Plan, Failure> {
    let drawn = Plan::from_environment();
    if args.shard.is_some() && args.seed.is_none() && std::env::var_os("LAB_SEED").is_none() {
        let what = "the parts of one class need one seed, and each would draw its own";
        return Err(Failure::input(what, "give all of them the same --seed NUMBER"));
    }
    Ok(match (args.seed, kept) {
        (Some(seed), _) => Plan::with_seed(seed),
        (None, Some(folder)) if std::env::var_os("LAB_SEED").is_none() => {
            let seed = Grader::kept_seed(folder, drawn.seed);
            Plan::with_seed(seed.map_err(|error| Failure::writing(folder.display(), &error))?)
        }
        _ => drawn,
    })
}

/// What no submission may see. The labs are those of the checkout that this program was built from.
fn hidden(args: &Args, terms: &Terms) -> Vec<Hidden> {
    let labs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../labs");
    let lists =
        args.names.iter().chain(&args.adjust).chain(&args.times).chain(&args.cache).chain(&args.results).cloned();
    let things = [
        ("the labs with their solutions", vec![labs]),
        ("what was handed in", args.submissions.iter().chain(&args.all_in).cloned().collect()),
        ("the instructor's secret", args.secret.iter().chain(terms.secret().map(|(file, _)| file)).cloned().collect()),
        ("the course", args.course.iter().chain(&args.metadata).cloned().collect()),
        ("the class lists", lists.collect::<Vec<_>>()),
    ];
    let there = |paths: &[PathBuf]| paths.iter().any(|path| path.exists());
    things.into_iter().filter(|(_, paths)| there(paths)).map(|(name, paths)| Hidden::new(name, paths)).collect()
}

fn secret(file: &Path, lab: &Lab) -> Result<Secret, Failure> {
    let text = text_of(file, "name a file with `seed = NUMBER`")?;
    let weighted = lab.judge().map_or(&[][..], |judge| judge.weighted());
    Secret::parse(&text, &file.display().to_string(), weighted)
        .map_err(|error| Failure::input(error, "see `dcel help grade`; a line `seed = NUMBER` is enough"))
}

/// Reports that were written with `--report json=FILE`, one or many, or with `--results DIR`.
pub(super) fn stored(place: &Path) -> Result<Vec<Report>, Failure> {
    let reports = place.join(targets::REPORTS);
    if !reports.is_dir() {
        return stored_file(place);
    }
    let cannot = |error: std::io::Error| Failure::input(format!("{}: {error}", reports.display()), STORED);
    let mut found = Vec::new();
    for file in files_ending(&reports, "json").map_err(cannot)? {
        found.extend(stored_file(&file)?);
    }
    Ok(found)
}

const STORED: &str = "name a file that `--report json=FILE` wrote, or a folder that `--results DIR` wrote";

fn stored_file(file: &Path) -> Result<Vec<Report>, Failure> {
    let text = text_of(file, STORED)?;
    let one = |text: &str| serde_json::from_str::<Report>(text).map(|report| vec![report]);
    let reports = if text.trim_start().starts_with('[') { serde_json::from_str(&text) } else { one(&text) };
    reports.map_err(|error| Failure::input(format!("{}: {error}", file.display()), STORED))
}

fn bar(submissions: usize) -> ProgressBar {
    let shown = submissions > 1 && std::io::stderr().is_terminal();
    let target = if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(submissions as u64), target);
    if let Ok(style) = ProgressStyle::with_template("{pos} of {len} {wide_bar} {eta} to go") {
        bar.set_style(style);
    }
    bar
}
