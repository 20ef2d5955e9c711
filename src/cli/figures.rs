//! `dcel figures`: the reference figures of the project, made anew or compared.

use super::gallery::{draw_all, write_all};
use super::input::files_ending;
use super::{Answer, Failure, Output, failure};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Draw the reference figures anew, or compare them
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel figures
  dcel figures --check")]
pub(crate) struct Args {
    /// Compare instead of writing: exit code 1 if a file differs from what would be drawn
    #[arg(long)]
    check: bool,
    /// The folder of the figures
    #[arg(long, value_name = "DIR", default_value = "figures")]
    dir: PathBuf,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let figures = draw_all()?;
    if !args.check {
        write_all(&args.dir, &figures)?;
        for figure in &figures {
            writeln!(out, "{}: {}", args.dir.join(figure.file).display(), figure.about)?;
        }
        return Ok(Answer::Yes);
    }
    let mut wrong = 0;
    for figure in &figures {
        let path = args.dir.join(figure.file);
        let verdict = compare(&path, &figure.text);
        wrong += usize::from(verdict.is_err());
        writeln!(out, "{}: {}", path.display(), verdict.err().unwrap_or_else(|| "same".to_owned()))?;
    }
    let known: BTreeSet<PathBuf> = figures.iter().map(|figure| args.dir.join(figure.file)).collect();
    for path in svg_files(&args.dir)?.difference(&known) {
        wrong += 1;
        writeln!(out, "{}: no command draws it", path.display())?;
    }
    if wrong == 0 {
        return Ok(Answer::Yes);
    }
    failure::say("help", format_args!("{wrong} not as drawn: run `dcel figures`, then look at what has changed"));
    Ok(Answer::No)
}

fn compare(path: &Path, svg: &str) -> Result<(), String> {
    match std::fs::read_to_string(path) {
        Ok(text) if text == svg => Ok(()),
        Ok(text) => {
            let same = text.lines().zip(svg.lines()).take_while(|(a, b)| a == b).count();
            Err(format!("differs from line {} on", same + 1))
        }
        Err(error) => Err(format!("cannot be read: {error}")),
    }
}

fn svg_files(dir: &Path) -> Result<BTreeSet<PathBuf>, Failure> {
    files_ending(dir, "svg").map_err(|error| {
        Failure::input(format_args!("{}: {error}", dir.display()), "name the folder of the figures with --dir")
    })
}
