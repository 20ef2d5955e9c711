//! `dcel lab list`: which labs there are, and what each asks for.

use super::super::{Answer, Failure, Output, output};
use super::lab;
use dcel_lab::{Lab, LabFiles, Points, Test};
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
#[derive(Serialize)]
struct Listed {
    name: String,
    title: String,
    points: Points,
    tasks: Vec<TaskListed>,
}

#[derive(Serialize)]
struct TaskListed {
    number: u32,
    title: String,
    tests: Vec<TestListed>,
}

#[derive(Serialize)]
struct TestListed {
    name: String,
    title: String,
    points: Points,
}

impl Listed {
    fn of(lab: Lab) -> Self {
        let Lab { name, manifest, .. } = lab;
        let tests = |task: u32| {
            let tests = manifest.tests.iter().filter(|test| test.task == task);
            let listed =
                |test: &Test| TestListed { name: test.name.clone(), title: test.title.clone(), points: test.points };
            tests.map(listed).collect()
        };
        let tasks = manifest.tasks.iter();
        let tasks = tasks.map(|t| TaskListed { number: t.number, title: t.title.clone(), tests: tests(t.number) });
        Self { name, title: manifest.title.clone(), points: manifest.max_points(), tasks: tasks.collect() }
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if args.json {
        match &args.lab {
            Some(name) => out.json(&Listed::of(lab(name)?))?,
            None => {
                let names = LabFiles::known_names();
                let all = names.iter().map(|name| lab(name).map(Listed::of));
                out.json(&all.collect::<Result<Vec<_>, _>>()?)?;
            }
        }
        return Ok(Answer::Yes);
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
