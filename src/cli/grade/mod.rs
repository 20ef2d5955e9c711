//! `dcel grade`: submissions in, reports out.
//!
//! ```text
//!   folders and files ─▶ Grader (walls, one room each) ─▶ Report ─┐
//!   stored reports    ──────────────────────────────────▶ Report ─┼─▶ names, adjustments ─▶ formats
//!   names without a submission ─▶ "nothing was handed in" ────────┘
//! ```

mod lists;
mod targets;

use super::{Answer, Failure, Output, failure};
use dcel_kit::lab::reports::Format;
use dcel_kit::lab::{GradeOptions, Grader, Hidden, Lab, Plan, Report, Secret, Verdict};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lists::Lists;
use std::fs;
use std::io::{IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use targets::Target;

/// Grade one submission, or a whole class
#[derive(clap::Args, Debug)]
#[command(after_help = "\
A submission is a folder that `dcel lab start` made, or the student's file alone. It is built and run behind walls;
the report names those that stood and those that could not be had. A submission that does its worst gets a report
that says so, and the next one is graded. Submissions with equal files are graded once.

Formats: text html markdown json junit csv bugs hold a class; gradescope classroom50 exercism hold one submission:
with several, write {submission} where its name shall stand in the file's.

Exit code 0 once all reports are written, whatever the grades; --fail-under changes that.

Examples:
  dcel grade 04 my-lab
  dcel grade 04 --all-in submissions --report html=class.html --report csv=class.csv
  dcel grade 04 lab.rs --report gradescope=results.json
  dcel grade 04 --from-report class.json --adjust late.csv --report csv=final.csv")]
pub(crate) struct Args {
    /// The lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: String,
    /// Submissions: folders or files
    #[arg(value_name = "SUBMISSION", required_unless_present_any = ["all_in", "from_report"])]
    submissions: Vec<PathBuf>,
    /// Every file and folder in this one is a submission, but for hidden ones
    #[arg(long, value_name = "DIR")]
    all_in: Option<PathBuf>,
    /// Reports stored as json instead of submissions: nothing is run
    #[arg(long, value_name = "FILE", conflicts_with_all = ["submissions", "all_in"])]
    from_report: Option<PathBuf>,
    /// Write a report: a format and a file, `-` for standard output; may be given several times
    #[arg(long = "report", value_name = "FORMAT=FILE")]
    reports: Vec<Target>,
    /// The seed of the random cases; without it, one is drawn for the batch
    #[arg(long, value_name = "NUMBER")]
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
    /// Exit code 1 if a submission has less than this share of the points, in percent
    #[arg(long, value_name = "PERCENT")]
    fail_under: Option<f64>,
    /// A folder that keeps reports: equal files under an equal seed are not graded again
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// How many are graded at the same time; without it, one for each core
    #[arg(long, value_name = "NUMBER")]
    workers: Option<NonZeroUsize>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let lab = super::lab::lab(&args.lab)?;
    let lists = Lists::read(args.names.as_deref(), args.adjust.as_deref())?;
    let mut reports = match &args.from_report {
        Some(file) => stored(file)?,
        None => graded(args, &lab)?,
    };
    lists.apply(&lab, &mut reports)?;
    for target in &args.reports {
        target.write(&reports, out)?;
    }
    if !args.reports.iter().any(Target::is_standard_output) {
        let text = Format::Text.class(&reports).map_err(Failure::kit)?;
        write!(out, "{text}")?;
    }
    let share = |report: &Report| f64::from(report.points()) * 100.0 / f64::from(report.max_points().max(1));
    let too_low = args.fail_under.is_some_and(|least| reports.iter().any(|report| share(report) < least));
    Ok(if too_low { Answer::No } else { Answer::Yes })
}

/// Grades the submissions; a bar shows how far it is where somebody watches.
fn graded(args: &Args, lab: &Lab) -> Result<Vec<Report>, Failure> {
    let submissions = submissions(args)?;
    let mut plan = args.seed.map_or_else(Plan::from_environment, Plan::with_seed);
    plan.secret = args.secret.as_deref().map(secret).transpose()?;
    let options = GradeOptions {
        workers: args.workers,
        hidden: hidden(args, &submissions),
        cache: args.cache.clone(),
        ..GradeOptions::default()
    };
    let grader = Grader::new(lab.clone(), &options).map_err(|error| Failure::writing("a temporary folder", &error))?;
    let bar = bar(submissions.len());
    let mut reports: Vec<Option<Report>> = vec![None; submissions.len()];
    grader.grade_all(&submissions, &plan, |i, report| {
        if report.verdict == Verdict::GraderFault {
            let message = report.message.as_deref().unwrap_or("see its report");
            bar.suspend(|| failure::say("grader fault", format_args!("{}: {message}", submissions[i].display())));
        }
        reports[i] = Some(report);
        bar.inc(1);
    });
    bar.finish_and_clear();
    Ok(reports.into_iter().flatten().collect())
}

/// The paths of the submissions, each of which exists.
fn submissions(args: &Args) -> Result<Vec<PathBuf>, Failure> {
    let mut found = args.submissions.clone();
    if let Some(dir) = &args.all_in {
        let cannot = |error: std::io::Error| {
            Failure::input(format!("{}: {error}", dir.display()), "name the folder that holds the submissions")
        };
        let mut inside = Vec::new();
        for entry in fs::read_dir(dir).map_err(cannot)? {
            let entry = entry.map_err(cannot)?;
            if !entry.file_name().to_string_lossy().starts_with('.') {
                inside.push(entry.path());
            }
        }
        inside.sort();
        if inside.is_empty() {
            return Err(Failure::input(format!("{}: is empty", dir.display()), "put a file or folder there for each"));
        }
        found.extend(inside);
    }
    match found.iter().find(|path| !path.exists()) {
        Some(missing) => Err(Failure::input(format!("{}: is not there", missing.display()), "name a folder or a file")),
        None => Ok(found),
    }
}

/// What no submission may see. The labs are those of the checkout that this program was built from.
fn hidden(args: &Args, submissions: &[PathBuf]) -> Vec<Hidden> {
    let labs = Path::new(env!("CARGO_MANIFEST_DIR")).join("labs");
    let lists = args.names.iter().chain(&args.adjust).chain(&args.cache).cloned();
    let things = [
        ("the labs with their solutions", vec![labs]),
        ("what was handed in", submissions.to_vec()),
        ("the instructor's secret", args.secret.iter().cloned().collect()),
        ("the class lists", lists.collect::<Vec<_>>()),
    ];
    let there = |paths: &[PathBuf]| paths.iter().any(|path| path.exists());
    things.into_iter().filter(|(_, paths)| there(paths)).map(|(name, paths)| Hidden::new(name, paths)).collect()
}

fn secret(file: &Path) -> Result<Secret, Failure> {
    let text = fs::read_to_string(file)
        .map_err(|error| Failure::input(format!("{}: {error}", file.display()), "name a file with `seed = NUMBER`"))?;
    Secret::parse(&text, &file.display().to_string())
        .map_err(|error| Failure::input(error, "see `dcel help grade`; a line `seed = NUMBER` is enough"))
}

/// Reports that were written with `--report json=FILE`, one or many.
fn stored(file: &Path) -> Result<Vec<Report>, Failure> {
    const HELP: &str = "name a file that `dcel grade … --report json=FILE` wrote";
    let text =
        fs::read_to_string(file).map_err(|error| Failure::input(format!("{}: {error}", file.display()), HELP))?;
    let one = |text: &str| serde_json::from_str::<Report>(text).map(|report| vec![report]);
    let reports = if text.trim_start().starts_with('[') { serde_json::from_str(&text) } else { one(&text) };
    reports.map_err(|error| Failure::input(format!("{}: {error}", file.display()), HELP))
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
