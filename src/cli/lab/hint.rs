//! `dcel lab hint`: help in three levels, one at a time.

use super::super::{Answer, Failure, Output};
use super::folder;
use dcel_kit::lab::{Lab, LabFiles, Manifest};
use std::io::Write;
use std::path::PathBuf;

/// Get a hint for a task: a nudge, then a pointer, then nearly the code
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel lab hint
  dcel lab hint 5
  dcel lab hint 5 --level 2")]
pub(crate) struct Args {
    /// The number of the task; without it, the tasks are listed
    #[arg(value_name = "TASK")]
    task: Option<u32>,
    /// 1 a nudge, 2 a pointer, 3 nearly the code
    #[arg(long, value_name = "LEVEL", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=3))]
    level: u8,
    /// The lab's folder; without it, the one you are in
    #[arg(long, value_name = "DIR")]
    dir: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let toml = folder::find(args.dir.as_deref())?.join("lab.toml");
    let manifest = Manifest::parse(&folder::read(&toml)?, &toml.display().to_string())
        .map_err(|error| Failure::input(error, "put back the lab.toml that the lab came with"))?;
    let Lab { manifest, files, .. } = super::lab(&manifest.name)?;
    let Some(number) = args.task else {
        writeln!(out, "Name a task:")?;
        for task in &manifest.tasks {
            writeln!(out, "  dcel lab hint {}   {}", task.number, task.title)?;
        }
        return Ok(Answer::Yes);
    };
    let Some(task) = manifest.task(number) else {
        let what = format!("there is no task {number}");
        return Err(Failure::input(what, format!("the tasks are 1 to {}", manifest.tasks.len())));
    };
    writeln!(out, "Task {number}: {}\n", task.title)?;
    let levels = levels(&files, number);
    let Some((heading, text)) = levels.get(usize::from(args.level) - 1) else {
        writeln!(out, "There is no further hint: ask your instructor.")?;
        return Ok(Answer::Yes);
    };
    writeln!(out, "{heading}\n\n{}", text.trim())?;
    if usize::from(args.level) < levels.len() {
        writeln!(out, "\nMore: dcel lab hint {number} --level {}", args.level + 1)?;
    }
    Ok(Answer::Yes)
}

/// The headings and texts of a task's hints.
fn levels(files: &LabFiles, task: u32) -> Vec<(&str, &str)> {
    let text = files.get(&format!("hints/task-{task}.md")).unwrap_or_default();
    text.split("\n## ").skip(1).map(|part| part.split_once('\n').unwrap_or((part, ""))).collect()
}
