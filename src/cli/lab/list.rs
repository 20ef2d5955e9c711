//! `dcel lab list`: which labs there are, and what each asks for.

use super::super::{Answer, Failure, Output, output};
use super::lab;
use dcel_kit::lab::{Lab, LabFiles};
use std::io::Write;

/// List the labs, or the tasks and tests of one
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel lab list
  dcel lab list 04")]
pub(crate) struct Args {
    /// A lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: Option<String>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let Some(name) = &args.lab else {
        let mut rows = Vec::new();
        for name in LabFiles::bundled_names() {
            let manifest = lab(&name)?.manifest;
            rows.push([name, format!("{} points", manifest.max_points()), manifest.title]);
        }
        output::table(out, &rows)?;
        return Ok(Answer::Yes);
    };
    tasks(&lab(name)?, out)?;
    Ok(Answer::Yes)
}

/// The tasks of a lab with their tests and points.
pub(super) fn tasks(lab: &Lab, out: &mut Output) -> Result<(), Failure> {
    let manifest = &lab.manifest;
    writeln!(out, "{}: {} ({} points)", lab.name, manifest.title, manifest.max_points())?;
    for task in &manifest.tasks {
        writeln!(out, "\ntask {}: {}", task.number, task.title)?;
        let tests = manifest.tests.iter().filter(|test| test.task == task.number);
        let rows: Vec<[String; 3]> =
            tests.map(|test| [test.points.to_string(), test.name.clone(), test.title.clone()]).collect();
        output::table(out, &rows)?;
    }
    Ok(())
}
