//! `dcel completions`: what the shell needs to complete commands and options.

use super::{Answer, Failure, Output};
use clap::CommandFactory;
use std::io::Write;

/// Print the completions for a shell
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel completions bash
  dcel completions fish")]
pub(crate) struct Args {
    /// The shell
    shell: clap_complete::Shell,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    // Into memory first: the generator would panic on a closed pipe.
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut super::Cli::command(), "dcel", &mut script);
    out.write_all(&script)?;
    Ok(Answer::Yes)
}
