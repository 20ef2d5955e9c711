//! `dcel completions`: what the shell needs to complete commands, options, and names of files by what they hold.
//!
//! ```text
//!   dcel completions bash ──> a few lines for the shell      on Tab it runs   DCEL_COMPLETE=bash dcel -- dcel info sq
//!                                                            and gets         square.obj
//! ```

use super::{Answer, Failure, Output};
use clap::builder::ValueHint;
use clap::{Arg, Command};
use clap_complete::CompleteEnv;
use clap_complete::engine::{ArgValueCompleter, PathCompleter};
use clap_complete::env::Shells;
use dcel_kit::io::Format;
use std::io::Write;
use std::path::Path;

/// The variable by which a shell asks.
const VARIABLE: &str = "DCEL_COMPLETE";

/// Print what makes a shell complete commands, options and file names
///
/// File names are completed by their ends: those that the command reads or writes.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Write it where your shell looks for it:
  dcel completions bash > ~/.local/share/bash-completion/completions/dcel
  dcel completions zsh > ~/.zfunc/_dcel           # with `fpath+=~/.zfunc` before compinit
  dcel completions fish > ~/.config/fish/completions/dcel.fish

Examples:
  dcel completions bash
  dcel completions fish")]
pub(crate) struct Args {
    /// The shell
    shell: clap_complete::Shell,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let name = args.shell.to_string();
    let shells = Shells::builtins();
    let shell = shells.completer(&name).ok_or_else(|| {
        Failure::input(
            format!("there are no completions for {name}"),
            "bash, elvish, fish, powershell and zsh have some",
        )
    })?;
    // Into memory first: a closed pipe is nobody's fault.
    let mut script = Vec::new();
    shell.write_registration(VARIABLE, "dcel", "dcel", "dcel", &mut script)?;
    out.write_all(&script)?;
    Ok(Answer::Yes)
}

/// Answers a shell that asks what may come next, and ends the program; returns if no shell asks.
pub(crate) fn answer_a_shell() {
    CompleteEnv::with_factory(|| with_files(super::command())).var(VARIABLE).bin("dcel").completer("dcel").complete();
}

/// The command and those below it, with names of files for every argument that is one.
fn with_files(command: Command) -> Command {
    let name = command.get_name().to_owned();
    let command = command.mut_args(|arg| match files(&name, &arg) {
        Some(completer) => arg.add(ArgValueCompleter::new(completer)),
        None => arg,
    });
    command.mut_subcommands(with_files)
}

/// Which files an argument wants; `None` if it is no file.
fn files(command: &str, arg: &Arg) -> Option<PathCompleter> {
    if !matches!(arg.get_value_hint(), ValueHint::AnyPath | ValueHint::FilePath | ValueHint::DirPath) {
        return None;
    }
    let name = arg.get_value_names().and_then(|names| names.first()).map_or("", |name| name.as_str());
    let read = || Format::ALL.into_iter().filter(|format| format.can_read()).flat_map(Format::extensions);
    let ends: Vec<&'static str> = match name {
        "DIR" => return Some(PathCompleter::dir()),
        "SCEN" => vec!["scen"],
        "REFERENCE" | "MINE" => read().copied().chain(["svg"]).collect(),
        _ if name.ends_with(".svg") => vec!["svg", "png"],
        _ if name.ends_with(".html") => vec!["html"],
        _ if command == "script" && arg.is_positional() => vec!["dcels", "txt"],
        _ if command == "grade" || !arg.is_positional() || name == "OUT" => return Some(PathCompleter::any()),
        _ => read().copied().chain(["xy", "csv", "txt"]).collect(),
    };
    let ends_so = move |path: &Path| {
        let end = path.extension().and_then(|end| end.to_str()).map(str::to_ascii_lowercase);
        end.is_some_and(|end| ends.contains(&end.as_str()))
    };
    let stdin = arg.is_positional() && arg.get_help().is_some_and(|help| help.to_string().contains("- for standard"));
    let completer = PathCompleter::file().filter(ends_so);
    Some(if stdin { completer.stdio() } else { completer })
}
