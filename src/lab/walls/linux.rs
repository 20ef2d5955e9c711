//! The grader's side on Linux: trying the walls, and running something behind those that stand.

use super::confine::loaders;
use super::processes::processes;
use super::spec::{Files, Outcome, Spec, Step, VARIABLE, WORD};
use super::user::OwnUser;
use super::{End, Limits, Ran, Task, View, Wall, WallChoice, Walls, unguessable};
use crate::lab::end_of;
use crate::lab::program::run_within;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

pub(super) use super::launcher::launched;

/// The launcher's own processes; they count against the limit of the user they become.
const LAUNCHERS: u64 = 3;
/// How much later than the watcher the grader loses patience, in seconds.
const PATIENCE: f64 = 2.0;
/// Where the system keeps its libraries.
const LIBRARIES: [&str; 9] =
    ["/lib", "/lib32", "/lib64", "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/local/lib", "/nix/store", "/gnu/store"];
/// What a compiler and a linker need besides.
const TOOLS: [&str; 7] = ["/usr", "/bin", "/sbin", "/opt", "/nix/store", "/gnu/store", "/run/current-system"];
/// What every program may read.
const COMMON: [&str; 5] = ["/etc/ld.so.cache", "/dev/zero", "/dev/urandom", "/dev/random", "/proc/self"];

/// Tries the walls one after the other, each together with those that stand already.
pub(super) fn probe(launcher: &Path, choice: WallChoice) -> (WallChoice, Vec<Wall>) {
    let mut up = WallChoice { own_user: false, namespaces: false, own_files: false };
    let mut said = Vec::new();
    let not_wanted = || Some("switched off".to_owned());
    let base = trial(launcher, up);
    let mut attempt = |name: &str, wanted: bool, with: fn(&mut WallChoice)| {
        let mut next = up;
        with(&mut next);
        let missing = match (&base, wanted) {
            (Some(why), _) => Some(why.clone()),
            (None, false) => not_wanted(),
            (None, true) => trial(launcher, next),
        };
        if missing.is_none() {
            up = next;
        }
        said.push(Wall { name: name.to_owned(), missing });
    };
    attempt("own user", choice.own_user, |up| up.own_user = true);
    attempt("own files only", choice.own_files, |up| up.own_files = true);
    attempt("own processes, network and shared memory", choice.namespaces, |up| up.namespaces = true);
    said.push(Wall { name: "nothing stays".to_owned(), missing: base });
    (up, said)
}

/// Runs the launcher's own program to nowhere behind these walls; what is in the way.
fn trial(launcher: &Path, up: WallChoice) -> Option<String> {
    let walls = Walls { launcher: launcher.to_path_buf(), up, said: Vec::new(), hidden: Vec::new() };
    let resident = match Resident::new(&walls) {
        Ok(resident) => resident,
        Err(error) => return Some(error.to_string()),
    };
    let ran = resident.run(
        &Task {
            // Whatever it says: it has started, or the launcher tells why not.
            program: PathBuf::from("/bin/sh"),
            args: vec!["-c".to_owned(), "exit 7".to_owned()],
            env: Vec::new(),
            folder: PathBuf::from("/"),
            view: View { tools: true, ..View::default() },
            limits: Limits::default(),
        },
        "",
    );
    match ran.end {
        End::Exited(7) => None,
        End::NotStarted(why) => Some(why),
        other => Some(format!("a trial ended with {other:?}")),
    }
}

/// Names the hidden folders that nothing keeps out of reach.
pub(super) fn in_reach(up: WallChoice, hidden: &[PathBuf]) -> Vec<Wall> {
    let walled = up.own_files || up.namespaces;
    let everybody =
        |path: &Path| path.ancestors().all(|part| part.metadata().is_ok_and(|data| data.mode() & 0o001 != 0));
    let wall = |folder: &PathBuf| {
        let missing = if walled || (up.own_user && !everybody(folder)) {
            None
        } else if up.own_user {
            Some("every user of this machine can read it: chmod 700".to_owned())
        } else {
            Some("a program of the user who grades can read it".to_owned())
        };
        Wall { name: format!("{} out of reach", folder.display()), missing }
    };
    hidden.iter().map(wall).collect()
}

/// As what a submission is built and run. When it leaves, everything of it is ended.
#[derive(Debug)]
pub(crate) struct Resident {
    walls: Walls,
    user: Option<OwnUser>,
}

impl Resident {
    pub(super) fn new(walls: &Walls) -> io::Result<Self> {
        let user = if walls.up.own_user {
            if !nix::unistd::geteuid().is_root() {
                return Err(io::Error::other("only root can run a program as another user"));
            }
            Some(OwnUser::take()?)
        } else {
            None
        };
        Ok(Self { walls: walls.clone(), user })
    }

    pub(crate) fn said(&self) -> &[Wall] {
        &self.walls.said
    }

    /// The number of its own user, if it has one.
    pub(crate) fn user(&self) -> Option<u32> {
        self.user.as_ref().map(|user| user.id)
    }

    /// Gives a file or folder to it, so that it may write there.
    pub(crate) fn give(&self, path: &Path) -> io::Result<()> {
        self.user().map_or(Ok(()), |id| std::os::unix::fs::lchown(path, Some(id), Some(id)))
    }

    /// Lets its group in, without write access.
    pub(crate) fn let_in(&self, path: &Path) -> io::Result<()> {
        self.user().map_or(Ok(()), |id| std::os::unix::fs::lchown(path, None, Some(id)))
    }

    pub(super) fn limits_said(&self, limits: &Limits) -> Vec<Wall> {
        let Limits { cpu_seconds, memory_mb, file_kb, files, processes, .. } = limits;
        let names = [
            format!("processor {cpu_seconds} s"),
            format!("memory {memory_mb} MB"),
            format!("file size {file_kb} kB"),
            format!("{files} open files"),
            format!("{processes} processes"),
            "no core files".to_owned(),
        ];
        names.map(|name| Wall { name, missing: None }).into()
    }

    /// Runs a task behind the walls, to its end and the end of whatever it started.
    pub(crate) fn run(&self, task: &Task, input: &str) -> Ran {
        let token = format!("wall-{}", unguessable());
        let text = match serde_json::to_string(&self.spec(task, &token)) {
            Ok(text) => text,
            Err(error) => return not_started(format!("{error}")),
        };
        let mut command = Command::new(&self.walls.launcher);
        command.arg(WORD).env_clear().env(VARIABLE, text).process_group(0);
        let patient = Limits { seconds: task.limits.seconds + PATIENCE, ..task.limits };
        let mut ran = run_within(command, input, &patient);
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
            End::Signalled { signal: 9, .. } => End::Signalled { signal: 9, name: "SIGKILL" },
            other => other,
        };
        ran
    }

    fn spec(&self, task: &Task, token: &str) -> Spec {
        let limits = &task.limits;
        let up = self.walls.up;
        Spec {
            step: Step::Guard,
            token: token.to_owned(),
            program: task.program.clone(),
            args: task.args.clone(),
            env: task.env.clone(),
            folder: task.folder.clone(),
            user: self.user(),
            namespaces: up.namespaces,
            hidden: if up.namespaces { self.walls.hidden.clone() } else { Vec::new() },
            files: up.own_files.then(|| files(&task.view)),
            seconds: limits.seconds,
            cpu_seconds: limits.cpu_seconds,
            memory: limits.memory_mb << 20,
            file_size: limits.file_kb << 10,
            open_files: limits.files,
            processes: limits.processes + LAUNCHERS + self.already_running(),
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
            let nothing = Task {
                program: PathBuf::new(),
                args: Vec::new(),
                env: Vec::new(),
                folder: PathBuf::from("/"),
                view: View::default(),
                limits: Limits::default(),
            };
            let spec = Spec { step: Step::Sweep, ..self.spec(&nothing, "sweep") };
            let Ok(text) = serde_json::to_string(&spec) else { return false };
            let mut command = Command::new(&self.walls.launcher);
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
        files.run.extend(paths(&TOOLS));
        files.run.extend(paths(&LIBRARIES));
        files.read.extend(paths(&["/etc", "/proc"]));
    }
    files
}

/// What the launcher said of a wall that could not be put up; taken out of the program's complaints.
fn refusal(stderr: &mut Vec<u8>, token: &str) -> Option<String> {
    let text = String::from_utf8_lossy(stderr).into_owned();
    let at = text.rfind(token)?;
    stderr.truncate(at);
    Some(text[at + token.len()..].trim().to_owned())
}

fn not_started(why: String) -> Ran {
    Ran { stdout: Vec::new(), stderr: Vec::new(), end: End::NotStarted(why), millis: 0 }
}
