//! Systems other than Linux: the plain driver's limits, and the rest of the walls named as missing.

use super::{Hidden, Limits, Program, Ran, Task, Wall, WallChoice, Walls};
use crate::Driver;
use crate::program::run_within;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const WHY: &str = "no walls on this system: grade on Linux what you do not trust";

pub(super) fn probe(_: &Path, _: WallChoice) -> (WallChoice, Vec<Wall>) {
    let names =
        ["own user", "own files only", "own root folder, processes, network and shared memory", "nothing stays"];
    let said = names.map(|name| Wall { name: name.to_owned(), missing: Some(WHY.to_owned()) });
    (WallChoice { own_user: false, namespaces: false, own_files: false }, said.into())
}

pub(super) fn out_of_reach(_: &Walls, hidden: &[Hidden], _: &[PathBuf], _: &[PathBuf]) -> Vec<Wall> {
    hidden.iter().map(|thing| Wall { name: thing.wall(), missing: Some(WHY.to_owned()) }).collect()
}

pub(super) fn shown_to_compilers() -> Vec<PathBuf> {
    Vec::new()
}

pub(super) fn launched() -> Option<ExitCode> {
    None
}

/// As what a submission is built and run: here, the user who grades.
#[derive(Debug)]
pub(crate) struct Resident {
    said: Vec<Wall>,
}

impl Resident {
    pub(super) fn new(walls: &Walls) -> io::Result<Self> {
        Ok(Self { said: walls.said.clone() })
    }

    pub(crate) fn said(&self) -> &[Wall] {
        &self.said
    }

    pub(crate) fn give(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    pub(crate) fn let_in(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    pub(super) fn limits_said(&self, limits: &Limits) -> Vec<Wall> {
        vec![Wall { name: format!("memory {} MB", limits.memory_mb), missing: Some(WHY.to_owned()) }]
    }

    /// Runs a task until its deadline; a program without arguments within the limits that this system knows.
    pub(crate) fn run(&self, task: &Task, input: &str) -> Ran {
        if task.args.is_empty() {
            return Driver::new(&task.program, task.limits).run(input);
        }
        let mut command = Command::new(&task.program);
        command.args(&task.args).current_dir(&task.folder);
        command.envs(task.env.iter().map(|(name, value)| (name, value)));
        run_within(command, input, &task.limits, None)
    }

    pub(crate) fn leave(&self) -> bool {
        true
    }
}
