//! `dcel lab list`: which labs there are, and what each asks for.

use super::super::{Answer, Failure, Output, fields, output};
use super::lab;
use dcel_lab::{Lab, LabFiles, Task, Test};
use serde::Serialize;
use std::io::Write;

/// List the labs, or the tasks and tests of one
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel lab list
  dcel lab list 04
  dcel lab list 04 --json")]
pub(crate) struct Args {
    /// A lab: its name, or its number
    #[arg(value_name = "LAB")]
    lab: Option<String>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

/// A lab. The names are those of the JSON form.
fn listed(Lab { name, manifest, .. }: &Lab) -> impl Serialize + use<> {
    let test = |test: &Test| fields! { name: test.name.clone(), title: test.title.clone(), points: test.points };
    let tests = |task: u32| manifest.tests.iter().filter(move |test| test.task == task).map(test);
    let task =
        |t: &Task| fields! { number: t.number, title: t.title.clone(), tests: tests(t.number).collect::<Vec<_>>() };
    let tasks: Vec<_> = manifest.tasks.iter().map(task).collect();
    fields! { name: name.clone(), title: manifest.title.clone(), points: manifest.max_points(), tasks }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if args.json {
        return match &args.lab {
            Some(name) => out.json(&listed(&lab(name)?)),
            None => {
                let names = LabFiles::known_names();
                let all = names.iter().map(|name| lab(name).map(|lab| listed(&lab)));
                out.json(&all.collect::<Result<Vec<_>, _>>()?)
            }
        };
    }
    let Some(name) = &args.lab else {
        let mut rows = Vec::new();
        for name in LabFiles::known_names() {
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
