//! `dcel gradebook`: the grades of all labs of a course together.

use super::grade::{course, stored};
use super::{Answer, Failure, Output, save};
use dcel_lab::course::Gradebook;
use std::io::Write;
use std::path::PathBuf;

/// Put the grades of all labs of a course together
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Each RESULTS is what `dcel grade` wrote for a lab of the course: a folder of --results, or a file of --report json=FILE. \
They are settled by the course as it is now, so nothing is graded again when it was changed. Students are told apart by \
what the reports call them; give `dcel grade` the same --names for all labs.

A lab counts by its weight in the course file. Labs without results do not count yet; a student without a report in a lab \
that was graded has no points there. Where the grader failed, there is no grade.

Examples:
  dcel gradebook --course course.toml graded
  dcel gradebook --course course.toml class.json --csv grades.csv")]
pub(crate) struct Args {
    /// The results of the labs
    #[arg(value_name = "RESULTS", required = true)]
    results: Vec<PathBuf>,
    /// The course
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// Write the table for a spreadsheet
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let course = course(&args.course)?;
    let mut reports = Vec::new();
    for place in &args.results {
        reports.extend(stored(place)?);
    }
    let book = Gradebook::new(&course, &reports).map_err(|error| {
        Failure::input(error, "name the results of each lab of the course once, and each student by one name in each")
    })?;
    write!(out, "{}", book.to_text())?;
    let open: Vec<&str> = course.labs.iter().map(|lab| lab.name.as_str()).collect();
    let open: Vec<&str> = open.into_iter().filter(|name| book.labs.iter().all(|lab| lab.name != **name)).collect();
    if !open.is_empty() {
        writeln!(out, "\nNot graded yet, so it does not count: {}", open.join(", "))?;
    }
    if let Some(file) = &args.csv {
        save::put(file, book.to_csv())?;
        writeln!(out, "\n{}: written", file.display())?;
    }
    Ok(Answer::Yes)
}
