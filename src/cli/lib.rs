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

use answer::{Answer, fields, tell};
use choice::commands;
use clap::{CommandFactory, FromArgMatches, Parser};
use dcel_lab::judge::Judge;
use failure::{Failure, say};
use input::InputOptions;
use looks::{Crop, Page};
use output::Output;
use picture::Target;
use save::Files;
use std::ffi::OsString;
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

Polygons that overlap, touch or cross are refused by name and place; --mend cuts them where they meet, \
on every command that reads polygons or segments. --trust skips the check; then nothing is called valid.

Files are written whole or not at all; a failed command leaves the old file as it was. The input is only \
written over with --in-place.

With --json an error is JSON on standard output, too: {\"error\": {\"kind\", \"message\", \"place\": {\"file\", \
\"line\", \"column\"} or null, \"notes\", \"help\", \"exit_code\"}}; kind is usage, input or machine. A signal \
ends the program without an answer.

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

commands! {
    Info info,
    Validate validate,
    Walk walk,
    Compare compare,
    Convert convert,
    Build build,
    Locate locate,
    Overlay overlay,
    Triangulate triangulate,
    Navmesh navmesh,
    Delaunay delaunay,
    Voronoi voronoi,
    Figure figure,
    Film film,
    Script script,
    Solid solid,
    Lab lab,
    Grade grade,
    Gradebook gradebook,
    Play play,
    Sample sample,
    Tour tour,
    Figures figures,
    Completions completions,
    Man man,
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
fn run(command: &Command, out: &mut Output) -> Result<Answer, Failure> {
    if command.computes() { waiting::shown(|| command.run(out)) } else { command.run(out) }
}

/// Runs the command that the arguments ask for.
fn answered() -> ExitCode {
    let mut out = Output::new();
    let json = failure::is_json_wanted();
    let (arguments, old) = old_words::current(std::env::args_os());
    let command = match parsed(arguments) {
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
    old.iter().for_each(|word| say("note", word));
    let ready = if command.ends_in_order() { Ok(()) } else { signals::clean_up() };
    let ready = ready.map_err(|error| Failure::machine(format!("signals: {error}"), ""));
    let answer = ready.and_then(|()| run(&command, &mut out)).and_then(|answer| {
        out.flush()?;
        Ok(answer)
    });
    ended(answer, json, &mut out)
}

/// The command and those below it. Of the flags for reading, those of the plane are refused by commands on solids, with
/// the reason; their helps do not offer them.
fn command() -> clap::Command {
    const OF_THE_PLANE: [&str; 5] = ["plane", "mend", "split_crossings", "trust", "full_check"];
    let unoffered = |arg: clap::Arg| if OF_THE_PLANE.contains(&arg.get_id().as_str()) { arg.hide(true) } else { arg };
    let below_solid = |command: clap::Command| command.mut_args(unoffered);
    Cli::command().mut_subcommand("solid", |solid| solid.mut_subcommands(below_solid))
}

/// What the arguments ask for. No option is called by a digit: -1 is a number, also where it will be refused.
fn parsed(arguments: impl IntoIterator<Item = OsString>) -> Result<Cli, clap::Error> {
    fn with_numbers(command: clap::Command) -> clap::Command {
        let numbers = |arg: clap::Arg| {
            let takes = !arg.is_positional() && arg.get_action().takes_values();
            if takes { arg.allow_negative_numbers(true) } else { arg }
        };
        command.mut_args(numbers).mut_subcommands(with_numbers)
    }
    let mut command = with_numbers(command());
    let mut arguments: Vec<OsString> = arguments.into_iter().map(plain_number).collect();
    // Help about help: `dcel help --help` is `dcel help`.
    if let [_, first, second] = &arguments[..]
        && first == "help"
        && (second == "--help" || second == "-h")
    {
        arguments.truncate(2);
    }
    let matches = command.try_get_matches_from_mut(arguments)?;
    Cli::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
}

/// A number below zero as the reader of the command line knows them: `-0.00001` for `-1e-05`, `-0.5` for `-.5`; the same
/// double. What else there is stays as it is.
fn plain_number(argument: OsString) -> OsString {
    let is_strange = |text: &&str| {
        let rest = text.strip_prefix('-').unwrap_or_default();
        rest.starts_with('.') || (rest.starts_with(|c: char| c.is_ascii_digit()) && rest.contains(['e', 'E']))
    };
    let number = argument.to_str().filter(is_strange).and_then(|text| text.parse::<f64>().ok());
    number.filter(|number| number.is_finite()).map_or(argument, |number| number.to_string().into())
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
