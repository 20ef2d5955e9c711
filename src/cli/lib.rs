//! The `dcel` command: parse, run one command, exit code.
//!
//! A library, so that an instructor's own lab can be the same program with one lab more: [`with_own_lab`].
//!
//! ```text
//!   file ──> input.rs ──> subject.rs ──> one file per command ──> output.rs ──> stdout   the answer
//!                                               │
//!                                               └─> failure.rs ───────────────> stderr   errors, notes
//!
//!   exit code   0  fine         1  the answer is no         2  usage or input         3  the machine
//! ```
//!
//! With `--json` errors go to stdout as JSON, too. Every file is written by save.rs: whole or not at all, and never over
//! what is read; signals.rs removes what is half written. What takes long shows on a terminal how far it is: waiting.rs.

mod answer;
mod build;
mod choice;
mod compare;
mod completions;
mod convert;
mod delaunay;
mod failure;
mod figure;
mod figure_kind;
mod figures;
mod film;
mod gallery;
mod grade;
mod gradebook;
mod info;
mod input;
mod lab;
mod locate;
mod looks;
mod man;
mod navmesh;
mod old_words;
mod output;
mod overlay;
mod picture;
mod play;
mod results;
mod sample;
mod save;
mod saved;
mod script;
mod signals;
mod solid;
mod subject;
mod tour;
mod triangulate;
mod validate;
mod voronoi;
mod waiting;
mod walk;

pub use lab::program_sources;

use answer::Answer;
use clap::{Parser, Subcommand};
use dcel_lab::judge::Judge;
use failure::Failure;
use output::Output;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// Half-edge structures: look at them, check them, draw them
#[derive(Parser, Debug)]
#[command(
    name = "dcel",
    version,
    propagate_version = false,
    max_term_width = 100,
    after_help = "\
Exit codes: 0 fine, 1 the answer is no (invalid, differs), 2 usage or bad input, 3 the machine failed.

Polygons that overlap, touch or cross are refused by name and place; --mend cuts them where they meet,
on every command that reads polygons or segments. --trust skips the check; then nothing is called valid.

Files are written whole or not at all; a failed command leaves the old file as it was. The input is only
written over with --in-place.

With --json an error is JSON on standard output, too: {\"error\": {\"kind\", \"message\", \"place\": {\"file\",
\"line\", \"column\"} or null, \"notes\", \"help\", \"exit_code\"}}; kind is usage, input, machine or signal.

`dcel sample --all .` writes the files that the examples of all commands use.

Examples:
  dcel sample square.obj
  dcel info square.obj
  dcel help info"
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand, Debug)]
enum Command {
    Info(info::Args),
    Validate(validate::Args),
    Walk(walk::Args),
    Compare(compare::Args),
    Convert(convert::Args),
    Build(build::Args),
    Locate(locate::Args),
    Overlay(overlay::Args),
    Triangulate(Box<triangulate::Args>),
    Navmesh(navmesh::Args),
    Delaunay(Box<delaunay::Args>),
    Voronoi(Box<voronoi::Args>),
    Figure(Box<figure::Args>),
    Film(Box<film::Args>),
    Script(script::Args),
    Solid(solid::Args),
    Lab(lab::Args),
    Grade(Box<grade::Args>),
    Gradebook(gradebook::Args),
    Play(play::Args),
    Sample(sample::Args),
    Tour(tour::Args),
    Figures(figures::Args),
    Completions(completions::Args),
    Man(man::Args),
}

impl Command {
    /// Whether it waits for signals itself, to stop in order.
    fn ends_in_order(&self) -> bool {
        matches!(self, Self::Grade(args) if args.runs_programs())
    }

    /// Whether it is one that works on a structure; others tell themselves how far they are.
    fn computes(&self) -> bool {
        !matches!(
            self,
            Self::Lab(_) | Self::Grade(_) | Self::Gradebook(_) | Self::Tour(_) | Self::Completions(_) | Self::Man(_)
        )
    }

    fn run(self, out: &mut Output) -> Result<Answer, Failure> {
        match self {
            Self::Info(args) => info::run(&args, out),
            Self::Validate(args) => validate::run(&args, out),
            Self::Walk(args) => walk::run(&args, out),
            Self::Compare(args) => compare::run(&args, out),
            Self::Convert(args) => convert::run(&args, out),
            Self::Build(args) => build::run(&args, out),
            Self::Locate(args) => locate::run(&args, out),
            Self::Overlay(args) => overlay::run(&args, out),
            Self::Triangulate(args) => triangulate::run(&args, out),
            Self::Navmesh(args) => navmesh::run(&args, out),
            Self::Delaunay(args) => delaunay::run(&args, out),
            Self::Voronoi(args) => voronoi::run(&args, out),
            Self::Figure(args) => figure::run(&args, out),
            Self::Film(args) => film::run(&args, out),
            Self::Script(args) => script::run(&args, out),
            Self::Solid(args) => solid::run(&args, out),
            Self::Lab(args) => lab::run(&args, out),
            Self::Grade(args) => grade::run(&args, out),
            Self::Gradebook(args) => gradebook::run(&args, out),
            Self::Play(args) => play::run(&args, out),
            Self::Sample(args) => sample::run(&args, out),
            Self::Tour(args) => tour::run(&args, out),
            Self::Figures(args) => figures::run(&args, out),
            Self::Completions(args) => completions::run(&args, out),
            Self::Man(args) => man::run(&args, out),
        }
    }
}

/// The program `dcel`.
pub fn main() -> ExitCode {
    completions::answer_a_shell();
    // For the sandbox the command starts itself again, to put it up.
    dcel_lab::launched().unwrap_or_else(answered)
}

/// The program `dcel` with one lab more, that of an instructor: `lab check`, `lab verify`, `lab export`, `grade` and all
/// others know it by its name and number. `folder` is the folder of the lab, where its `lab.toml` lies.
///
/// ```no_run
/// use dcel_lab::judge::Judge;
/// # fn judge() -> &'static dyn Judge { todo!() }
/// fn main() -> std::process::ExitCode {
///     dcel_cli::with_own_lab(concat!(env!("CARGO_MANIFEST_DIR"), "/.."), judge())
/// }
/// ```
pub fn with_own_lab(folder: impl AsRef<Path>, judge: &'static dyn Judge) -> ExitCode {
    dcel_lab::courses::add_own(folder.as_ref(), judge);
    main()
}

/// Runs a command; one that computes shows how far it is.
fn run(command: Command, out: &mut Output) -> Result<Answer, Failure> {
    if command.computes() { waiting::shown(|| command.run(out)) } else { command.run(out) }
}

/// Runs the command that the arguments ask for.
fn answered() -> ExitCode {
    let mut out = Output::new();
    let json = failure::is_json_wanted();
    let (arguments, old) = old_words::current(std::env::args_os());
    let command = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli.command,
        Err(error) if error.use_stderr() => {
            if json {
                Failure::usage(&error).report_json(&mut out);
            }
            error.exit()
        }
        // Help and version are answers, too, and a full disk is told.
        Err(asked) => {
            let printed = asked.print().and_then(|()| io::stdout().flush());
            return ended(printed.map(|()| Answer::Yes).map_err(Failure::from), json, &mut out);
        }
    };
    old.iter().for_each(|word| failure::say("note", word));
    let ready = if command.ends_in_order() { Ok(()) } else { signals::clean_up() };
    let ready = ready.map_err(|error| Failure::machine(format!("signals: {error}"), ""));
    let answer = ready.and_then(|()| run(command, &mut out)).and_then(|answer| {
        out.flush()?;
        Ok(answer)
    });
    ended(answer, json, &mut out)
}

/// Tells why there is no answer, if there is none.
fn ended(answer: Result<Answer, Failure>, json: bool, out: &mut Output) -> ExitCode {
    match answer {
        Ok(answer) => answer.exit_code(),
        Err(failure) => {
            failure.report();
            if json {
                failure.report_json(out);
            }
            failure.exit_code()
        }
    }
}
