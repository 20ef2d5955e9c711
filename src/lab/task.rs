//! Something to be run for a submission, and where: in the sandbox, or on the student's own machine.
//!
//! Building and judging ask for a [`Runner`] and nothing else, so that the student's own check and the grader run the
//! same code.

use super::program::limited;
use super::{Limits, Ran};
use serde::{Deserialize, Serialize};
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a program in the sandbox may do with the file system.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(crate) struct View {
    /// Files and folders that it may read and execute.
    pub(crate) run: Vec<PathBuf>,
    /// Folders in which it may do everything.
    pub(crate) write: Vec<PathBuf>,
    /// Whether it sees the whole of the system's programs, as a compiler must, or only the libraries.
    pub(crate) tools: bool,
}

/// Something to be run in the sandbox.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Task {
    /// The program.
    pub(crate) program: PathBuf,
    /// Its arguments.
    pub(crate) args: Vec<String>,
    /// Its whole environment.
    pub(crate) env: Vec<(String, String)>,
    /// Where it starts.
    pub(crate) folder: PathBuf,
    /// What it sees.
    pub(crate) view: View,
    /// What it may use.
    pub(crate) limits: Limits,
}

/// Where a submission is built and run.
#[allow(unused_variables)] // on the own machine nothing is handed over
pub(crate) trait Runner {
    /// Runs a task to its end, and to the end of whatever it started.
    fn run(&self, task: &Task, input: &str) -> Ran;

    /// Gives a file or folder to whoever runs there, so that it may write there: nothing to do for the user itself.
    fn give(&self, path: &Path) -> io::Result<()> {
        Ok(())
    }

    /// Lets whoever runs there into a folder, without write access.
    fn let_in(&self, path: &Path) -> io::Result<()> {
        Ok(())
    }

    /// Whether settings of the machine may have a say in a build: only where the machine is the student's own.
    fn obeys_settings(&self) -> bool {
        false
    }
}

/// The student's own machine: limits and a deadline against endless loops, and no barriers.
///
/// The environment stays, for what a linker may need of it, but for what cargo and rustc read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnMachine;

impl Runner for OwnMachine {
    fn run(&self, task: &Task, input: &str) -> Ran {
        let mut command: Command = limited(&task.program, &task.limits);
        command.args(&task.args).current_dir(&task.folder);
        for (name, _) in std::env::vars_os() {
            if ["CARGO", "RUST"].iter().any(|tool| name.to_string_lossy().starts_with(tool)) {
                command.env_remove(name);
            }
        }
        command.envs(task.env.iter().map(|(name, value)| (name, value)));
        super::program::run_within(command, input, &task.limits, None)
    }

    fn obeys_settings(&self) -> bool {
        true
    }
}
