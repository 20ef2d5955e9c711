//! `dcel lab check`: how far the work is, and what to do next.

use super::super::choice::whole;
use super::super::{Answer, Failure, Output, failure};
use super::{folder, hint, own, progress};
use console::Style;
use dcel_kit::files::write_whole;
use dcel_lab::reports::Format;
use dcel_lab::{Lab, Plan, Report, TestResult, Verdict, Workbench, check_folder, test_text};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// So many lines of what the program printed are shown.
const PRINTED: usize = 10;

/// Build your code, run the graded tests, and say what to do next
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Shows a line for each test and, in full, the first one that fails: it is the next thing to do. Only the file that you \
hand in is taken, and built with the given ones: so the verdicts are those of `cargo test` and of your instructor's \
grader. --own runs cases of your own, with the answers that you expect (tests/own.txt). A note says what else you have changed. Pictures of what went wrong are in target/check/report.html.

Examples:
  dcel lab check
  dcel lab check my-lab --test split_face_3_links
  dcel lab check --all --seed 77
  dcel lab check my-lab --json")]
#[group(skip)]
pub(crate) struct Args {
    #[command(flatten)]
    what: What,
    /// Run your own cases, tests/own.txt, instead of the graded tests
    #[arg(long, conflicts_with_all = ["json", "test", "all", "seed"])]
    own: bool,
    /// The folder of the labs with their solutions: with --own, how many known mistakes your cases catch
    #[arg(long, value_name = "DIR", requires = "own")]
    labs: Option<PathBuf>,
    /// Answer in JSON: the report as `dcel grade --report json=FILE` writes it
    #[arg(long)]
    json: bool,
}

/// What is checked, and with which cases.
#[derive(clap::Args, Debug)]
#[group(skip)]
pub(super) struct What {
    /// The lab's folder; without it, the one you are in
    #[arg(value_name = "DIR")]
    dir: Option<PathBuf>,
    /// Only this test and those that it builds on
    #[arg(long, value_name = "NAME")]
    test: Option<String>,
    /// Tell every failing test in full, not just the first
    #[arg(long)]
    all: bool,
    /// The seed of the random cases, to see the same ones again; LAB_SEED does the same
    #[arg(long, value_name = "NUMBER", value_parser = whole::<u64>)]
    seed: Option<u64>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let mut bench = Bench::new(&args.what)?;
    if args.own {
        return own::check(&bench.lab, &bench.dir, args.labs.as_deref(), out);
    }
    if !args.json {
        return bench.check(out);
    }
    let (report, _) = bench.report(out)?;
    out.write_all(Format::Json.one(&report).as_bytes())?;
    Ok(answer(&report))
}

fn answer(report: &Report) -> Answer {
    if report.verdict.is_passed() { Answer::Yes } else { Answer::No }
}

/// A student's folder, ready to be checked again and again.
pub(super) struct Bench {
    pub(super) dir: PathBuf,
    /// The folder as the user named it.
    pub(super) named: Option<PathBuf>,
    lab: Lab,
    test: Option<String>,
    all: bool,
    seed: Option<u64>,
    /// Where it is built, if it is to be checked again.
    again: Option<Workbench>,
}

impl Bench {
    pub(super) fn new(args: &What) -> Result<Self, Failure> {
        let dir = folder::find(args.dir.as_deref())?;
        let toml = dir.join("lab.toml");
        let manifest = folder::manifest(&dir)?;
        let mut lab = super::lab(&manifest.name)?;
        if manifest.version != lab.manifest.version {
            let text = folder::read(&toml)?;
            let line = 1 + text.lines().position(|line| line.starts_with("version")).unwrap_or(0);
            let (there, here) = (&manifest.version, &lab.manifest.version);
            let what = format!(
                "{}:{line}: this folder is of version {there} of the lab, the program of {here}",
                toml.display()
            );
            failure::say("note", format_args!("{what}; `dcel lab start {} DIR` makes a new one", lab.name));
        }
        if let Some((_, course)) = progress::course_above(&dir)?
            && let Some(of_course) = course.lab(&lab.name)
        {
            lab = of_course.applied_to(lab);
            progress::note_needs(&lab.name, &dir);
        }
        if let Some(test) = &args.test
            && lab.manifest.test(test).is_none()
        {
            let names: Vec<&str> = lab.manifest.tests.iter().map(|test| test.name.as_str()).collect();
            let what = format!("{} has no test `{test}`", lab.name);
            return Err(Failure::input(what, format!("name one of {}", names.join(", "))));
        }
        let named = args.dir.clone();
        Ok(Self { dir, named, lab, test: args.test.clone(), all: args.all, seed: args.seed, again: None })
    }

    /// To be checked again and again.
    pub(super) fn kept(mut self) -> Self {
        self.again = Some(Workbench::new(&self.target()));
        self
    }

    /// The files that are worth watching.
    pub(super) fn watched(&self) -> Vec<PathBuf> {
        self.lab.manifest.graded.iter().map(|file| self.dir.join(file)).collect()
    }

    /// Builds, grades, tells.
    pub(super) fn check(&mut self, out: &mut Output) -> Result<Answer, Failure> {
        let (report, page) = self.report(out)?;
        self.tell(out, &report, page.as_deref())?;
        Ok(answer(&report))
    }

    /// The name of the lab.
    pub(super) fn name(&self) -> &str {
        &self.lab.name
    }

    /// Builds and grades; whether everything passes.
    pub(super) fn passes(&mut self, out: &mut Output) -> Result<bool, Failure> {
        Ok(self.report(out)?.0.verdict.is_passed())
    }

    /// Builds and grades; gives the report, and where its page is.
    fn report(&mut self, out: &mut Output) -> Result<(Report, Option<PathBuf>), Failure> {
        // What was said before must stand before what the compiler says.
        out.flush()?;
        let mut plan = self.seed.map_or_else(Plan::from_environment, Plan::with_seed);
        plan.only.clone_from(&self.test);
        let check = match &mut self.again {
            Some(bench) => bench.check(&self.lab, &self.dir, &plan),
            None => check_folder(&self.lab, &self.dir, &self.target(), &plan),
        };
        for note in &check.notes {
            failure::say("note", note);
        }
        if let Some(why) = check.set_up_fault() {
            let help = "your file is not to blame: a Rust toolchain must be installed and work; see rustup.rs";
            return Err(Failure::machine(why, help));
        }
        let mut report = check.report;
        for test in &mut report.tests {
            test.replay = self.case(test);
        }
        // A check of one test says nothing of the others.
        if self.test.is_none() {
            hint::remember(&self.dir, &report);
            progress::remember(&self.dir, &report);
        }
        let page = self.target().join("report.html");
        let written = write_whole(&page, Format::Html.one(&report)).is_ok();
        Ok((report, written.then_some(page)))
    }

    /// The tasks with their tests and points.
    pub(super) fn list(&self, out: &mut Output) -> Result<(), Failure> {
        super::list::tasks(&self.lab, out)
    }

    /// The list of tests, then the next thing to do.
    fn tell(&self, out: &mut Output, report: &Report, page: Option<&Path>) -> io::Result<()> {
        writeln!(out, "{}: {} of {} points", report.lab, report.points(), report.max_points())?;
        if let Some(message) = &report.message {
            // Nothing could be run: there is one thing to do, and nothing to say of any test.
            return writeln!(out, "\n{}: {message}\n\n{}", report.verdict, report.verdict.next_action());
        }
        for test in &report.tests {
            let (sign, style) = sign(test.verdict);
            let line = format!("{sign} {:<30} {}", test.name, test.verdict);
            writeln!(out, "  {}", style.apply_to(line))?;
            // Why a test counts although others failed, or does not although nothing is wrong.
            if matches!(test.verdict, Verdict::Passed | Verdict::Skipped) && !test.message.is_empty() {
                writeln!(out, "      {}", test.message)?;
            }
        }
        // What was written comes before what is still to be written: tasks may be done in any order.
        let told = |test: &&TestResult| !matches!(test.verdict, Verdict::Passed | Verdict::Skipped);
        let tests: Vec<&TestResult> = if self.all {
            report.tests.iter().filter(told).collect()
        } else {
            report.next_test().into_iter().collect()
        };
        for test in tests.into_iter().filter(told) {
            writeln!(out, "\n{}", test_text(report, test, None).trim_end())?;
        }
        let open = report.tests.iter().filter(|test| !test.verdict.is_passed()).count();
        if open == 0 {
            writeln!(out, "\nEverything passes. Hand it in.")?;
        } else if let Some(page) = page {
            let drawn = report.tests.iter().any(|test| test.picture.is_some());
            let what = if drawn { "With pictures" } else { "As a page" };
            writeln!(out, "\n{what}: {}", dcel_lab::typed(page))?;
        }
        let lines = report.printed.lines().count();
        if lines > 0 {
            writeln!(out, "\nYour program printed:")?;
            for line in report.printed.lines().take(PRINTED) {
                writeln!(out, "  {}", line.replace(|c: char| c.is_control() && c != '\t', "\u{fffd}"))?;
            }
            if lines > PRINTED {
                let more = dcel_kit::io::counted(lines - PRINTED, "line", "lines");
                writeln!(out, "  … and {more} more; to see what one case prints, replay it")?;
            }
        }
        Ok(())
    }

    /// Writes the failing case to a file; gives the command that replays it.
    fn case(&self, test: &TestResult) -> Option<String> {
        let name = format!("{}.case", test.name);
        write_whole(&self.target().join(&name), test.script.as_ref()?).ok()?;
        Some(format!("cargo run -q -- target/check/{name}"))
    }

    /// A target folder of its own: an editor that builds at the same time is never in the way.
    fn target(&self) -> PathBuf {
        folder::checked(&self.dir)
    }
}

/// How the line of a test begins, and how it looks.
fn sign(verdict: Verdict) -> (char, Style) {
    match verdict {
        Verdict::Passed => ('+', Style::new().green()),
        Verdict::Unattempted | Verdict::Skipped => (' ', Style::new().dim()),
        _ => ('-', Style::new().red()),
    }
}
