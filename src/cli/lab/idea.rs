//! `dcel lab idea`: the idea of the solution, for who has one of their own.

use super::super::{Answer, Failure, Output};
use super::{check, folder, progress};
use std::io::Write;

/// Read how others think of the solution, once everything passes
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The lab is checked first, as `dcel lab check` does it: the idea is for those who have found one of their own. An \
instructor can switch it off, by `idea = false` below the lab in course.toml.

Examples:
  dcel lab idea
  dcel lab idea my-lab")]
pub(crate) struct Args {
    #[command(flatten)]
    what: check::What,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let mut bench = check::Bench::new(&args.what)?;
    let course = progress::course_above(&folder::find(Some(&bench.dir))?)?;
    let of_course = course.as_ref().and_then(|(_, course)| course.lab(bench.name()));
    if of_course.is_some_and(|lab| !lab.idea) {
        let file = course.as_ref().map_or_else(String::new, |(file, _)| file.display().to_string());
        return Err(Failure::input(format!("{file}: the course does not tell it"), "ask your instructor"));
    }
    let idea = super::bundled(bench.name())?.get(IDEA).map(str::to_owned);
    let Some(idea) = idea else {
        return Err(Failure::input(
            format!("{} has no {IDEA}", bench.name()),
            "compare with others, or ask your instructor",
        ));
    };
    if bench.passes(out)? {
        writeln!(out, "{}", idea.trim())?;
        return Ok(Answer::Yes);
    }
    writeln!(out, "Not yet: the idea is told when everything passes. `dcel lab check` says what is next.")?;
    Ok(Answer::No)
}

/// The file of a lab that holds it.
const IDEA: &str = "idea.md";
