//! `dcel man`: manual pages, made of the same words as the help.

use super::{Answer, Failure, Output, save};
use clap::Command;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Write manual pages into a folder, one for each command
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel man pages
  man -l pages/dcel-info.1
  dcel man ~/.local/share/man/man1                # then `man dcel-info`")]
pub(crate) struct Args {
    /// The folder, which is made if it is not there
    #[arg(value_name = "DIR")]
    dir: PathBuf,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    std::fs::create_dir_all(&args.dir).map_err(|error| Failure::writing(args.dir.display(), &error))?;
    let mut command = super::command().disable_help_subcommand(true);
    command.build();
    let mut pages = 0;
    write_page(&command, "dcel", &args.dir, &mut pages)?;
    writeln!(out, "{}: {pages} pages", args.dir.display())?;
    Ok(Answer::Yes)
}

/// The page of a command, and those of the commands below it: `dcel-navmesh-path.1`.
fn write_page(command: &Command, name: &str, dir: &Path, pages: &mut usize) -> Result<(), Failure> {
    let mut page = Vec::new();
    let man = clap_mangen::Man::new(command.clone().display_name(name.to_owned()));
    man.source(concat!("dcel ", env!("CARGO_PKG_VERSION"))).render(&mut page)?;
    save::put(&dir.join(format!("{name}.1")), page)?;
    *pages += 1;
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        write_page(below, &format!("{name}-{}", below.get_name()), dir, pages)?;
    }
    Ok(())
}
