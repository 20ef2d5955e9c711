//! Walls between a submission and the machine.
//!
//! ```text
//!   grader ──▶ guard ──▶ watcher ──▶ entrant ──exec──▶ the student's program
//!              │         │           │
//!              │         │           └ limits of the system, its own files only
//!              │         └ first process of its namespace, or adopts whatever is left behind; ends all of it
//!              └ a user of its own, namespaces of its own
//! ```
//!
//! The three steps are one program, the *launcher*: the `dcel` command itself, started with a word that nobody types
//! ([`launched`]). Each step limits itself and then starts the next, so no step needs `unsafe`.
//!
//! # What is trusted
//! The grader, the kit, the lab's own files (driver included), the toolchain, the kernel. Not the student's file, and
//! not the process that runs it: whatever that process prints is text to be judged, its end is seen by the watcher.
//!
//! # What each wall keeps in
//! | wall | keeps in | needs |
//! |---|---|---|
//! | deadline, output cap | endless loops, sleeps, floods | nothing |
//! | limits of the system | processor, memory, files written, open files, processes, cores | Linux here, a shell elsewhere |
//! | own user | the grader's and other submissions' files (mode 0700), signals to others, what survives | root |
//! | own files only (Landlock) | every file but its own and the system's libraries; TCP; signals to others | Linux 5.13 |
//! | namespaces | network, shared memory, other processes; all of it dies with its first process | user namespaces |
//! | nothing stays | daemons that leave their session | Linux |
//!
//! The folder of the lab, its solution and the launcher belong to the grader: mode 0700 (0711 for the launcher, which
//! carries the labs) keeps them in where Landlock cannot. A folder that is in reach all the same is named.
//!
//! They overlap on purpose: a container without user namespaces still has a user of its own and Landlock, an ordinary
//! user has Landlock and namespaces. [`Walls::probe`] tries each one on this machine before any submission is run;
//! what is missing is named in every report, and a wall that stood at the probe and fails later stops the run
//! ([`NotStarted`](super::End::NotStarted), never a pass).
//!
//! # What remains possible
//! - Using the processor, the memory and the processes that the limits allow, several times over: memory is counted
//!   for each process. Only a control group could count it once.
//! - Reading the names of other processes where Landlock is missing; looking at the system's own libraries.
//! - UDP and Unix sockets with a name in the file system, where namespaces are missing.
//! - Shared memory in the style of System V that outlives its process, where namespaces are missing.
//! - Where there is no Landlock, ending the watcher of the same user: what is left is ended when the submission is
//!   done, if it has a user of its own, and not before.
//! - A hole in the kernel or in the compiler.
//! - Without a user of its own, without Landlock and without namespaces: reading every file of the user who grades.
//! - Answering rightly by other means than thinking: the driver judges answers, not minds.

#[cfg(target_os = "linux")]
mod confine;
#[cfg(not(target_os = "linux"))]
mod elsewhere;
#[cfg(target_os = "linux")]
mod launcher;
#[cfg(target_os = "linux")]
mod linux;
#[cfg(target_os = "linux")]
mod processes;
#[cfg(target_os = "linux")]
mod spec;
#[cfg(target_os = "linux")]
mod user;

#[cfg(not(target_os = "linux"))]
use elsewhere as system;
#[cfg(target_os = "linux")]
use linux as system;

pub(crate) use super::task::{Sandbox, Task, View};
use super::{Limits, Program, Ran, Wall};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
pub(crate) use system::Resident;

/// Which of the optional walls may be used. All of them, unless one is in the way on some machine or is to be tested
/// without the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WallChoice {
    /// A user of its own for every submission.
    pub own_user: bool,
    /// Namespaces of its own.
    pub namespaces: bool,
    /// Its own files only.
    pub own_files: bool,
}

impl Default for WallChoice {
    fn default() -> Self {
        Self { own_user: true, namespaces: true, own_files: true }
    }
}

/// The walls of this machine.
#[derive(Clone, Debug)]
pub struct Walls {
    /// The program that serves as launcher: one whose `main` calls [`launched`] first.
    launcher: PathBuf,
    /// Those that stood at the probe.
    up: WallChoice,
    /// What the report says of them.
    said: Vec<Wall>,
    /// Folders that a program must not see: the lab's solution, other submissions.
    hidden: Vec<PathBuf>,
}

impl Walls {
    /// Tries every wall on this machine, with `launcher` as the program that puts them up; `None` is the running
    /// program itself.
    ///
    /// Cost: a few starts of the launcher, some 50 ms.
    #[must_use]
    pub fn probe(launcher: Option<&Path>, choice: WallChoice) -> Self {
        let itself = || std::env::current_exe().unwrap_or_default();
        let launcher = launcher.map_or_else(itself, Path::to_path_buf);
        let (up, said) = system::probe(&launcher, choice);
        Self { launcher, up, said, hidden: Vec::new() }
    }

    /// The same walls, and these folders are to be out of sight. A folder that nothing stands before is named in the
    /// report. `needed` is what must stay in sight; a folder around it is not covered.
    pub(crate) fn hiding(mut self, folders: &[PathBuf], needed: &[PathBuf]) -> Self {
        let mut folders: Vec<PathBuf> = folders.iter().filter_map(|folder| folder.canonicalize().ok()).collect();
        folders.sort();
        folders.dedup();
        let (around, apart): (Vec<_>, Vec<_>) =
            folders.into_iter().partition(|folder| needed.iter().any(|need| need.starts_with(folder)));
        let up = self.up;
        self.said.extend(system::in_reach(up, &apart));
        self.said.extend(system::in_reach(WallChoice { namespaces: false, ..up }, &around));
        self.hidden = apart;
        self
    }

    /// The program that puts the walls up.
    #[must_use]
    pub fn launcher(&self) -> &Path {
        &self.launcher
    }

    /// Which optional walls stand.
    #[must_use]
    pub fn up(&self) -> WallChoice {
        self.up
    }

    /// What a report says of the walls: those that stand, and those that are missing with the reason.
    #[must_use]
    pub fn said(&self) -> &[Wall] {
        &self.said
    }

    /// The executable at `path` behind these walls, as a user of its own where there is one. The user who runs it
    /// must be able to reach the file.
    ///
    /// # Errors
    /// If no user can be had for it.
    pub fn program(&self, path: &Path, limits: Limits) -> std::io::Result<WalledProgram> {
        Ok(WalledProgram::new(Arc::new(self.resident()?), path, limits))
    }

    /// Takes a resident in: what one submission is built and run as.
    pub(crate) fn resident(&self) -> std::io::Result<Resident> {
        Resident::new(self)
    }
}

/// A student's program behind walls.
#[derive(Debug)]
pub struct WalledProgram {
    resident: Arc<Resident>,
    task: Task,
}

impl WalledProgram {
    /// The executable at `path`, run as this resident within these limits.
    pub(crate) fn new(resident: Arc<Resident>, path: &Path, limits: Limits) -> Self {
        let folder = path.parent().unwrap_or(Path::new("/")).to_path_buf();
        let view = View { run: vec![path.to_path_buf()], ..View::default() };
        // A backtrace is of no use to anybody here, and reads files.
        let env = vec![("RUST_BACKTRACE".to_owned(), "0".to_owned())];
        Self { resident, task: Task { program: path.to_path_buf(), args: Vec::new(), env, folder, view, limits } }
    }
}

impl Program for WalledProgram {
    fn run(&self, input: &str) -> Ran {
        self.resident.run(&self.task, input)
    }

    fn walls(&self) -> Vec<Wall> {
        let limits = &self.task.limits;
        let stands = |name: String| Wall { name, missing: None };
        let mut walls =
            vec![stands(format!("deadline {} s", limits.seconds)), stands(format!("output {} kB", limits.output_kb))];
        walls.extend(self.resident.limits_said(limits));
        walls.extend(self.resident.said().iter().cloned());
        walls
    }
}

impl Sandbox for Resident {
    fn run(&self, task: &Task, input: &str) -> Ran {
        Self::run(self, task, input)
    }

    fn give(&self, path: &Path) -> std::io::Result<()> {
        Self::give(self, path)
    }

    fn let_in(&self, path: &Path) -> std::io::Result<()> {
        Self::let_in(self, path)
    }
}

/// What a binary calls first of all if it serves as launcher. `None` means that it was started as what it is.
///
/// ```text
///   fn main() -> ExitCode {
///       if let Some(code) = dcel_kit::lab::launched() {
///           return code;
///       }
///       …
/// ```
#[must_use]
pub fn launched() -> Option<ExitCode> {
    system::launched()
}

/// A word that nobody can guess, from what the system draws for hash maps.
pub(crate) fn unguessable() -> String {
    use std::hash::{BuildHasher, RandomState};
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    let word = |salt: u64| RandomState::new().hash_one((count, salt, std::process::id()));
    format!("{:016x}{:016x}", word(1), word(2))
}
