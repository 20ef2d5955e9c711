//! Barriers between a submission and the machine.
//!
//! ```text
//!   grader ──▶ guard ──▶ watcher ──▶ entrant ──exec──▶ the student's program
//!              │         │           │
//!              │         │           └ limits of the system, its own files only
//!              │         └ first process of its namespace, with a root folder of its own, or adopts whatever is left
//!              │           behind; ends all of it
//!              └ closes what it was handed; a user of its own, namespaces of its own
//! ```
//!
//! The three steps are one program, the *launcher*: the `dcel` command itself, started with a word that nobody types
//! ([`launched`]). Each step limits itself and then starts the next, so no step needs `unsafe`.
//!
//! # What is trusted
//! The grader, the kit, the lab's own files (driver included), the toolchain, the kernel. Not the student's file, and
//! not the process that runs it: whatever that process prints is text to be judged, its end is seen by the watcher.
//!
//! # What each barrier keeps in
//! | barrier | keeps in | needs |
//! |---|---|---|
//! | deadline, output cap | endless loops, sleeps, floods | nothing |
//! | limits of the system | processor, memory, files written, open files, cores; processes of everybody but root | Linux here, a shell elsewhere |
//! | own user | the grader's and other submissions' files (mode 0700), signals to others, what survives | root |
//! | own files only (Landlock) | every file but its own and the system's libraries; TCP; signals to others | Linux 5.13 |
//! | namespaces | network, shared memory, other processes; every file but its own, in a root folder of its own; all of it dies with its first process | user namespaces |
//! | nothing stays | daemons that leave their session | Linux |
//!
//! A compiler sees more than a student's program does, read-only: the toolchain and its linker, wherever they are
//! installed, `/bin`, `/usr/bin`, `/usr/libexec` and the libraries of the system, of `/etc` only `alternatives` and
//! `ld.so.*`, and the submission's own work folder. Not `/home`, `/opt`, `/tmp`, `/usr/share`, other submissions or the
//! labs; what is hidden within something shown is covered. Where no barrier stands before a file, the compiler's own list
//! of what it read does (the module `submission` reads it): such a submission is refused.
//!
//! They overlap on purpose: a container without user namespaces still has a user of its own and Landlock, an ordinary
//! user has Landlock and namespaces.
//!
//! # A barrier is reported only after it was tried from inside
//! [`Sandbox::probe`] runs the launcher in the place of the student's program, behind each barrier by itself, and lets it
//! try what the barrier is for: reading files that everybody may read, seeing and signalling the grader, reaching it over
//! the network, becoming root, leaving something behind. Then, for the hidden things of a grading run, it tries
//! to read these in the place of the compiler and in that of the program. What it could do is named in every
//! report as a missing barrier. One that stood then and fails later stops the run
//! ([`NotStarted`](super::End::NotStarted), never a pass).
//!
//! # What remains possible
//! - Using the processor, the memory and the processes that the limits allow, several times over: memory is counted
//!   for each process. Only a control group could count it once.
//! - Reading the names of other processes where neither Landlock nor namespaces are; looking at the system's own
//!   libraries, and while compiling at its programs.
//! - With Landlock alone: learning whether a file of some name is there (not what is in it).
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
mod inside;
#[cfg(target_os = "linux")]
mod launcher;
#[cfg(target_os = "linux")]
mod linux;
#[cfg(target_os = "linux")]
mod probe;
#[cfg(target_os = "linux")]
mod processes;
#[cfg(target_os = "linux")]
mod root;
#[cfg(target_os = "linux")]
mod spec;
#[cfg(target_os = "linux")]
mod user;

#[cfg(not(target_os = "linux"))]
use elsewhere as system;
#[cfg(not(target_os = "linux"))]
use elsewhere as trials;
#[cfg(target_os = "linux")]
use linux as system;
#[cfg(target_os = "linux")]
use probe as trials;

pub(crate) use super::task::{Runner, Task, View};
use super::{Barrier, Limits, Program, Ran, Stop};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
pub(crate) use system::Resident;

/// Which of the optional barriers may be used. All of them, unless one is in the way on some machine or is to be tested
/// without the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SandboxChoice {
    /// A user of its own for every submission.
    pub own_user: bool,
    /// Namespaces of its own.
    pub namespaces: bool,
    /// Its own files only.
    pub own_files: bool,
}

impl Default for SandboxChoice {
    fn default() -> Self {
        Self { own_user: true, namespaces: true, own_files: true }
    }
}

/// Files and folders that no submission may see, as the reports call them: a student reads these, so they name no
/// path.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hidden {
    /// What it is, as the beginning of "... out of reach".
    pub name: String,
    /// Where it is. What is not there is passed over.
    pub paths: Vec<PathBuf>,
}

impl Hidden {
    /// Something hidden, by its name in reports.
    #[must_use]
    pub fn new(name: impl Into<String>, paths: Vec<PathBuf>) -> Self {
        Self { name: name.into(), paths }
    }

    /// What the barrier before it is called.
    fn barrier(&self) -> String {
        format!("{} out of reach", self.name)
    }
}

/// The barriers of this machine.
#[derive(Clone, Debug)]
pub struct Sandbox {
    /// The program that serves as launcher: one whose `main` calls [`launched`] first.
    launcher: PathBuf,
    /// Those that stood at the probe.
    up: SandboxChoice,
    /// What the report says of them.
    said: Vec<Barrier>,
    /// What must not be seen even though it lies within what a compiler sees.
    hidden: Vec<PathBuf>,
    /// Ends what runs behind them.
    stop: Stop,
}

impl Sandbox {
    /// Tries every barrier on this machine, with `launcher` as the program that puts them up; `None` is the running
    /// program itself.
    ///
    /// Cost: a few starts of the launcher, some 50 ms.
    #[must_use]
    pub fn probe(launcher: Option<&Path>, choice: SandboxChoice) -> Self {
        let itself = || std::env::current_exe().unwrap_or_default();
        let launcher = launcher.map_or_else(itself, Path::to_path_buf);
        let (up, said) = trials::probe(&launcher, choice);
        Self::of(&launcher, up, said)
    }

    fn of(launcher: &Path, up: SandboxChoice, said: Vec<Barrier>) -> Self {
        Self { launcher: launcher.to_path_buf(), up, said, hidden: Vec::new(), stop: Stop::new() }
    }

    /// The same barriers, and these things are to be out of reach. What came of trying to reach them from inside, in the
    /// place of the compiler and in that of the student's program, is said in the report. `tools` is what the
    /// compiler sees besides the system's own; `needed` is what stays in sight even if it lies in something hidden.
    pub(crate) fn hiding(mut self, hidden: &[Hidden], tools: &[PathBuf], needed: &[PathBuf]) -> Self {
        let there = |paths: &[PathBuf]| -> Vec<PathBuf> {
            let mut paths: Vec<PathBuf> = paths.iter().filter_map(|path| path.canonicalize().ok()).collect();
            paths.sort();
            paths.dedup();
            paths
        };
        let hidden: Vec<Hidden> =
            hidden.iter().map(|thing| Hidden { name: thing.name.clone(), paths: there(&thing.paths) }).collect();
        let shown = there(&system::shown_to_compilers().into_iter().chain(tools.to_vec()).collect::<Vec<_>>());
        let within = |path: &&PathBuf| shown.iter().any(|folder| path.starts_with(folder));
        self.hidden = hidden.iter().flat_map(|thing| &thing.paths).filter(within).cloned().collect();
        let said = trials::out_of_reach(&self, &hidden, tools, &there(needed));
        self.said.extend(said);
        self
    }

    /// The same barriers; when an end is wished, what runs behind them is ended.
    pub(crate) fn until(mut self, stop: &Stop) -> Self {
        self.stop = stop.clone();
        self
    }

    /// The program that puts the barriers up.
    #[must_use]
    pub fn launcher(&self) -> &Path {
        &self.launcher
    }

    /// Which optional barriers stand.
    #[must_use]
    pub fn up(&self) -> SandboxChoice {
        self.up
    }

    /// What a report says of the barriers: those that stand, and those that are missing with the reason.
    #[must_use]
    pub fn said(&self) -> &[Barrier] {
        &self.said
    }

    /// The executable at `path` in the sandbox, as a user of its own where there is one. The user who runs it
    /// must be able to reach the file.
    ///
    /// # Errors
    /// If no user can be had for it.
    pub fn program(&self, path: &Path, limits: Limits) -> std::io::Result<SandboxedProgram> {
        Ok(SandboxedProgram::new(Arc::new(self.resident()?), path, limits))
    }

    /// Takes a resident in: what one submission is built and run as.
    pub(crate) fn resident(&self) -> std::io::Result<Resident> {
        Resident::new(self)
    }
}

/// A student's program in the sandbox.
#[derive(Debug)]
pub struct SandboxedProgram {
    resident: Arc<Resident>,
    task: Task,
}

impl SandboxedProgram {
    /// The executable at `path`, run as this resident within these limits.
    pub(crate) fn new(resident: Arc<Resident>, path: &Path, limits: Limits) -> Self {
        let folder = path.parent().unwrap_or(Path::new("/")).to_path_buf();
        let view = View { run: vec![path.to_path_buf()], ..View::default() };
        // A backtrace is of no use to anybody here, and reads files.
        let env = vec![("RUST_BACKTRACE".to_owned(), "0".to_owned())];
        Self { resident, task: Task { program: path.to_path_buf(), args: Vec::new(), env, folder, view, limits } }
    }
}

impl Program for SandboxedProgram {
    fn run(&self, input: &str) -> Ran {
        self.resident.run(&self.task, input)
    }

    fn sandbox(&self) -> Vec<Barrier> {
        let limits = &self.task.limits;
        let stands = |name: String| Barrier { name, missing: None };
        let mut sandbox =
            vec![stands(format!("deadline {} s", limits.seconds)), stands(format!("output {} kB", limits.output_kb))];
        sandbox.extend(self.resident.limits_said(limits));
        sandbox.extend(self.resident.said().iter().cloned());
        sandbox
    }
}

/// What a binary calls first of all if it serves as launcher. `None` means that it was started as what it is.
///
/// ```text
///   fn main() -> ExitCode {
///       if let Some(code) = dcel_lab::launched() {
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
