//! The grader's side on Linux: running something behind the barriers that stand, and what it sees there.

use super::confine::loaders;
use super::processes::processes;
use super::spec::{Files, Outcome, Spec, Step, VARIABLE, WORD};
use super::user::OwnUser;
use super::{Barrier, Limits, Ran, Runner, Sandbox, Task, View, unguessable};
use crate::program::run_within;
use crate::{End, end_of};
use std::fs;
use std::io;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

pub(super) use super::launcher::launched;

/// The launcher's own processes; they count against the limit of the user they become.
const LAUNCHERS: u64 = 3;
/// What root is called within namespaces, where the program must have no rights.
const NOBODY: u32 = 65_534;
/// How much later than the watcher the grader loses patience, in seconds.
const PATIENCE: f64 = 2.0;
/// Where the system keeps its libraries.
const LIBRARIES: [&str; 8] =
    ["/lib", "/lib32", "/lib64", "/usr/lib", "/usr/lib32", "/usr/lib64", "/nix/store", "/gnu/store"];
/// Where the system keeps the programs of its compilers.
const PROGRAMS: [&str; 4] = ["/bin", "/usr/bin", "/usr/libexec", "/run/current-system/sw"];
/// What every program may read.
const COMMON: [&str; 5] = ["/etc/ld.so.cache", "/dev/zero", "/dev/urandom", "/dev/random", "/proc/self"];

/// What a compiler sees of the system: programs, libraries, and the settings of both.
pub(super) fn shown_to_compilers() -> Vec<PathBuf> {
    let settings = fs::read_dir("/etc").into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let wanted = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().as_encoded_bytes();
        name == b"alternatives" || name.starts_with(b"ld.so.")
    };
    PROGRAMS.iter().chain(&LIBRARIES).map(PathBuf::from).chain(settings.filter(wanted)).collect()
}

/// As what a submission is built and run. When it leaves, everything of it is ended.
#[derive(Debug)]
pub(crate) struct Resident {
    sandbox: Sandbox,
    user: Option<OwnUser>,
}

impl Resident {
    pub(super) fn new(sandbox: &Sandbox) -> io::Result<Self> {
        let user = if sandbox.up.own_user {
            if !nix::unistd::geteuid().is_root() {
                return Err(io::Error::other("only root can run a program as another user"));
            }
            Some(OwnUser::take()?)
        } else {
            None
        };
        Ok(Self { sandbox: sandbox.clone(), user })
    }

    pub(crate) fn said(&self) -> &[Barrier] {
        &self.sandbox.said
    }

    /// The number of its own user, if it has one.
    fn user(&self) -> Option<u32> {
        self.user.as_ref().map(|user| user.id)
    }

    pub(super) fn limits_said(&self, limits: &Limits) -> Vec<Barrier> {
        let Limits { cpu_seconds, memory_mb, file_kb, files, processes, .. } = limits;
        let names = [
            format!("processor {cpu_seconds} s"),
            format!("memory {memory_mb} MB"),
            format!("file size {file_kb} kB"),
            format!("{files} open files"),
            "no core files".to_owned(),
        ];
        let root = self.user.is_none() && nix::unistd::geteuid().is_root();
        let missing = root.then(|| "this limit binds everybody but root".to_owned());
        let mut said: Vec<Barrier> = names.map(|name| Barrier { name, missing: None }).into();
        said.push(Barrier { name: format!("{processes} processes"), missing });
        said
    }

    fn spec(&self, task: &Task, token: &str) -> Spec {
        let up = self.sandbox.up;
        // In a namespace of users the program is the first that is counted.
        let more = if up.namespaces { 1 } else { LAUNCHERS } + self.already_running();
        let limits = Limits { processes: task.limits.processes + more, ..task.limits };
        Spec {
            step: Step::Guard,
            token: token.to_owned(),
            task: Task { limits, ..task.clone() },
            user: self.user(),
            namespaces: up.namespaces,
            inside: match self.user().unwrap_or(nix::unistd::geteuid().as_raw()) {
                0 => NOBODY,
                user => user,
            },
            hidden: if up.namespaces { self.sandbox.hidden.clone() } else { Vec::new() },
            files: if up.namespaces || up.own_files { files(&task.view) } else { Files::default() },
            own_files: up.own_files,
        }
    }

    /// What the system counts of the user besides: only a user of its own has nothing else to run.
    fn already_running(&self) -> u64 {
        if self.user.is_some() {
            return 0;
        }
        let own = nix::unistd::getuid().as_raw();
        processes().iter().filter(|process| process.user == own).map(|process| process.threads).sum()
    }

    /// Ends everything of its user; true if nothing is left.
    fn sweep(&self) -> bool {
        let Some(user) = &self.user else { return true };
        for round in 0..40 {
            if !user.is_running() {
                return true;
            }
            let nothing = Task { folder: PathBuf::from("/"), ..Task::default() };
            let spec = Spec { step: Step::Sweep, ..self.spec(&nothing, "sweep") };
            let Ok(text) = serde_json::to_string(&spec) else { return false };
            let mut command = Command::new(self.sandbox.launcher());
            command.arg(WORD).env_clear().env(VARIABLE, text).stdin(Stdio::null()).stdout(Stdio::null());
            let _ = command.stderr(Stdio::null()).status();
            std::thread::sleep(Duration::from_millis(1 + round));
        }
        !user.is_running()
    }

    /// Ends what is left of it. False if something could not be ended; then its files are left alone, too.
    pub(crate) fn leave(&self) -> bool {
        let gone = self.sweep();
        if let Some(user) = self.user.as_ref().filter(|_| gone) {
            user.clear();
        }
        gone
    }
}

impl Runner for Resident {
    /// Runs a task in the sandbox, to its end and the end of whatever it started.
    fn run(&self, task: &Task, input: &str) -> Ran {
        let token = format!("barrier-{}", unguessable());
        let text = match serde_json::to_string(&self.spec(task, &token)) {
            Ok(text) => text,
            Err(error) => return not_started(format!("{error}")),
        };
        let mut command = Command::new(self.sandbox.launcher());
        command.arg(WORD).env_clear().env(VARIABLE, text).process_group(0);
        let patient = Limits { seconds: task.limits.seconds + PATIENCE, ..task.limits };
        let mut ran = run_within(command, input, &patient, Some(&self.sandbox.stop));
        ran.end = match ran.end {
            End::Exited(code) => match Outcome::of_code(code) {
                Outcome::Exited(code) => End::Exited(code),
                Outcome::Signalled(signal) => end_of(None, Some(signal), &ran.stderr),
                Outcome::TimedOut => End::TimedOut,
                Outcome::NoWall => match refusal(&mut ran.stderr, &token) {
                    Some(why) => End::NotStarted(why),
                    None => End::Exited(code),
                },
            },
            other => other,
        };
        ran
    }

    /// Gives a file or folder to it, so that it may write there.
    fn give(&self, path: &Path) -> io::Result<()> {
        self.user().map_or(Ok(()), |id| std::os::unix::fs::lchown(path, Some(id), Some(id)))
    }

    /// Lets its group in, without write access.
    fn let_in(&self, path: &Path) -> io::Result<()> {
        self.user().map_or(Ok(()), |id| std::os::unix::fs::lchown(path, None, Some(id)))
    }
}

impl Drop for Resident {
    fn drop(&mut self) {
        self.leave();
    }
}

fn files(view: &View) -> Files {
    let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
    let mut files = Files { read: paths(&LIBRARIES), run: loaders(), write: vec![PathBuf::from("/dev/null")] };
    files.read.extend(paths(&COMMON));
    files.run.extend(view.run.iter().cloned());
    files.write.extend(view.write.iter().cloned());
    if view.tools {
        files.run.extend(shown_to_compilers());
    }
    // Libraries that lie elsewhere: the student's program needs what this one needs.
    files.read.extend(own_libraries());
    files
}

/// The shared libraries that this process has loaded.
fn own_libraries() -> Vec<PathBuf> {
    let table = fs::read_to_string("/proc/self/maps").unwrap_or_default();
    let files = table.lines().filter_map(|line| Some(&line[line.find('/')?..]));
    let mut files: Vec<PathBuf> = files.filter(|file| file.contains(".so")).map(PathBuf::from).collect();
    files.dedup();
    files.retain(|file| !LIBRARIES.iter().any(|folder| file.starts_with(folder)));
    files
}

/// What the launcher said of a barrier that could not be put up; taken out of the program's complaints.
fn refusal(stderr: &mut Vec<u8>, token: &str) -> Option<String> {
    let text = String::from_utf8_lossy(stderr).into_owned();
    let at = text.rfind(token)?;
    stderr.truncate(at);
    Some(text[at + token.len()..].trim().to_owned())
}

fn not_started(why: String) -> Ran {
    Ran { stdout: Vec::new(), stderr: Vec::new(), end: End::NotStarted(why), millis: 0 }
}
