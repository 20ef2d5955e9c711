//! Systems other than Linux: the plain driver's limits, and the rest of the barriers named as missing.

use super::{Barrier, Hidden, Limits, Program, Ran, Runner, Sandbox, SandboxChoice, Task};
use crate::Driver;
use crate::program::run_within;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const WHY: &str = "no sandbox on this system: grade on Linux what you do not trust";

pub(super) fn probe(_: &Path, _: SandboxChoice) -> (SandboxChoice, Vec<Barrier>) {
    let names =
        ["own user", "own files only", "own root folder, processes, network and shared memory", "nothing stays"];
    let said = names.map(|name| Barrier { name: name.to_owned(), missing: Some(WHY.to_owned()) });
    (SandboxChoice { own_user: false, namespaces: false, own_files: false }, said.into())
}

pub(super) fn out_of_reach(_: &Sandbox, hidden: &[Hidden], _: &[PathBuf], _: &[PathBuf]) -> Vec<Barrier> {
    hidden.iter().map(|thing| Barrier { name: thing.barrier(), missing: Some(WHY.to_owned()) }).collect()
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
    said: Vec<Barrier>,
}

impl Resident {
    pub(super) fn new(sandbox: &Sandbox) -> io::Result<Self> {
        Ok(Self { said: sandbox.said.clone() })
    }

    pub(crate) fn said(&self) -> &[Barrier] {
        &self.said
    }

    pub(super) fn limits_said(&self, limits: &Limits) -> Vec<Barrier> {
        vec![Barrier { name: format!("memory {} MB", limits.memory_mb), missing: Some(WHY.to_owned()) }]
    }

    pub(crate) fn leave(&self) -> bool {
        true
    }
}

impl Runner for Resident {
    /// Runs a task until its deadline; a program without arguments within the limits that this system knows.
    fn run(&self, task: &Task, input: &str) -> Ran {
        if task.args.is_empty() {
            return Driver::new(&task.program, task.limits).run(input);
        }
        let mut command = Command::new(&task.program);
        command.args(&task.args).current_dir(&task.folder);
        command.envs(task.env.iter().map(|(name, value)| (name, value)));
        run_within(command, input, &task.limits, None)
    }
}
