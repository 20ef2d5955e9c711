//! The launcher's steps: guard, watcher, entrant.
//!
//! ```text
//!   guard     closes files → new user → namespaces → starts the watcher, passes its code on
//!   watcher   own root folder, own session, adopts orphans; deadline; kills whatever is left until nothing is
//!   entrant   no rights → files → limits → exec
//! ```
//!
//! Each step asks the kernel to be killed with its parent, so the end of the grader is the end of all of them.

use super::processes::{descendants, processes};
use super::spec::{INSIDE, Outcome, Spec, Step, VARIABLE, WORD};
use super::{Task, confine, inside, root};
use crate::program::Clock;
use nix::errno::Errno;
use nix::sys::prctl;
use nix::sys::signal::{Signal, kill};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::{Pid, getpid, getppid, setsid};
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, ExitCode};
use std::time::{Duration, Instant};

/// How long the watcher tries to end what a program left behind.
const LAST_ORDERS: Duration = Duration::from_secs(2);
/// The shortest and the longest pause between two looks at the program.
const LOOK: [Duration; 2] = [Duration::from_micros(200), Duration::from_millis(2)];

/// Runs a step if the program was started as the launcher.
pub(super) fn launched() -> Option<ExitCode> {
    let mut words = std::env::args_os().skip(1);
    (words.next()? == WORD).then(|| {
        if words.next().is_some_and(|word| word == INSIDE) {
            return inside::answer(words.next().is_some());
        }
        let Some(spec) = std::env::var(VARIABLE).ok().and_then(|text| serde_json::from_str(&text).ok()) else {
            eprintln!("dcel: this word is for the grader's own use");
            return ExitCode::from(2);
        };
        let outcome = step(&spec).unwrap_or_else(|why| {
            eprintln!("\n{} {why}", spec.token);
            Outcome::NoWall
        });
        ExitCode::from(outcome.code())
    })
}

fn step(spec: &Spec) -> Result<Outcome, String> {
    match spec.step {
        Step::Guard => guard(spec),
        Step::Watch => watch(spec),
        Step::Enter => enter(spec),
        Step::Sweep => sweep(spec),
    }
}

/// The launcher again, for the next step.
fn next(spec: &Spec, step: Step) -> Result<Command, String> {
    let spec = serde_json::to_string(&Spec { step, ..spec.clone() }).map_err(|error| error.to_string())?;
    let mut command = Command::new("/proc/self/exe");
    command.arg0("dcel").arg(WORD).env_clear().env(VARIABLE, spec);
    Ok(command)
}

fn guard(spec: &Spec) -> Result<Outcome, String> {
    confine::close_inherited();
    prctl::set_no_new_privs().map_err(|e| format!("no_new_privs: {e}"))?;
    if let Some(user) = spec.user {
        confine::become_user(user)?;
    }
    if spec.namespaces {
        confine::enter_namespaces()?;
    }
    // After the change of user and of rights: these would undo it.
    dies_with_parent()?;
    let mut watcher = next(spec, Step::Watch)?.spawn().map_err(|e| format!("the watcher does not start: {e}"))?;
    let status = watcher.wait().map_err(|e| format!("the watcher is lost: {e}"))?;
    Ok(match Outcome::of_status(status) {
        Outcome::Exited(code) => Outcome::of_code(code),
        // Ended from outside, and with it the namespace, or by the grader.
        other => other,
    })
}

fn watch(spec: &Spec) -> Result<Outcome, String> {
    if spec.namespaces {
        root::enter(&spec.files, &spec.hidden)?;
    }
    // What runs as the same user may not look into this process, where the token is.
    prctl::set_dumpable(false).map_err(|e| format!("dumpable: {e}"))?;
    setsid().map_err(|e| format!("a session of its own: {e}"))?;
    // The first process of a namespace takes all others with it, so it may be killed with the guard. Elsewhere it
    // must outlive the guard for a moment, to clean up.
    if spec.namespaces {
        dies_with_parent()?;
    }
    prctl::set_child_subreaper(true).map_err(|e| format!("subreaper: {e}"))?;
    let guard = getppid();
    let mut child = next(spec, Step::Enter)?.spawn().map_err(|e| format!("the program does not start: {e}"))?;
    let outcome =
        wait_for(&mut child, Duration::try_from_secs_f64(spec.task.limits.seconds).unwrap_or(Duration::MAX), guard);
    if !end_all(&mut child, spec.namespaces) {
        return Err("something that the program left behind cannot be ended".to_owned());
    }
    outcome
}

/// The end of the program by itself, the deadline, or the end of the guard.
fn wait_for(child: &mut Child, limit: Duration, guard: Pid) -> Result<Outcome, String> {
    let mut clock = Clock::new();
    let mut pause = LOOK[0];
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Ok(Outcome::of_status(status)),
            Ok(None) => {}
            Err(error) => return Err(format!("the program is lost: {error}")),
        }
        if clock.left_of(limit).is_none() {
            return Ok(Outcome::TimedOut);
        }
        if getppid() != guard {
            return Err("the grader is gone".to_owned());
        }
        std::thread::sleep(pause);
        pause = LOOK[1].min(pause * 2);
    }
}

/// Ends every process that comes from this one, in whatever session it hides: orphans are adopted, so there are none
/// left when there is no child to wait for. `alone`: this is the first process of a namespace, where every other one
/// comes from it (and has another number than `/proc` says).
fn end_all(child: &mut Child, alone: bool) -> bool {
    let begin = Instant::now();
    let _ = child.kill();
    let _ = child.wait();
    while begin.elapsed() < LAST_ORDERS {
        match waitpid(Pid::from_raw(-1), Some(WaitPidFlag::WNOHANG)) {
            Err(Errno::ECHILD) => return true,
            Ok(WaitStatus::StillAlive) => {
                if alone && getpid().as_raw() == 1 {
                    let _ = kill(Pid::from_raw(-1), Signal::SIGKILL);
                } else {
                    for pid in descendants(&processes(), getpid().as_raw()) {
                        let _ = kill(Pid::from_raw(pid), Signal::SIGKILL);
                    }
                }
                std::thread::sleep(LOOK[0]);
            }
            _ => {}
        }
    }
    false
}

fn enter(spec: &Spec) -> Result<Outcome, String> {
    if spec.namespaces {
        confine::leave_rights(spec.inside)?;
    }
    dies_with_parent()?;
    let Task { program, args, env, folder, limits, .. } = &spec.task;
    std::env::set_current_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    if spec.own_files {
        confine::only_files(&spec.files)?;
    }
    confine::limits(limits)?;
    let error = Command::new(program).args(args).env_clear().envs(env.iter().map(|(name, value)| (name, value))).exec();
    Err(format!("{}: {error}", program.display()))
}

/// Ends everything of the spec's user. A signal to all reaches them at one moment, so nothing can fork away from it.
fn sweep(spec: &Spec) -> Result<Outcome, String> {
    let user = spec.user.ok_or("a sweep needs a user")?;
    confine::become_user(user)?;
    match kill(Pid::from_raw(-1), Signal::SIGKILL) {
        Ok(()) | Err(Errno::ESRCH) => Ok(Outcome::Exited(0)),
        Err(error) => Err(format!("ending what user {user} runs: {error}")),
    }
}

fn dies_with_parent() -> Result<(), String> {
    prctl::set_pdeathsig(Signal::SIGKILL).map_err(|e| format!("end with the parent: {e}"))
}
