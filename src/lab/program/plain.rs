//! A program run as the user who asked for it, within limits that every system can hold.
//!
//! ```text
//!   unix:     sh -c 'ulimit -v ... ; exec "$0" "$@"' PROGRAM      own process group
//!   windows:  PROGRAM                                          deadline and output cap only
//! ```

use super::clock::Clock;
use super::pipes::{Event, Pipe, feed};
use super::{End, Limits, Program, Ran, end_of};
use crate::{Barrier, Stop};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How much of the complaints is kept.
const STDERR: usize = 64 * 1024;
/// How long a process that was ended may take to go, and its pipes to run dry.
const GRACE: Duration = Duration::from_millis(500);
/// More runs at the same time end no sooner: one suite takes longer than all others together.
const MOST_AT_ONCE: usize = 4;
/// How long to wait between two looks at a process whose pipes are open, and at one whose pipes are closed.
const LOOK: [Duration; 2] = [Duration::from_millis(5), Duration::from_micros(200)];

/// The plain [`Program`]: an executable, run by its author.
#[derive(Clone, PartialEq, Debug)]
pub struct Driver {
    /// The executable.
    pub path: PathBuf,
    /// What it may use.
    pub limits: Limits,
}

impl Driver {
    /// The executable at `path` with these limits.
    #[must_use]
    pub fn new(path: impl Into<PathBuf>, limits: Limits) -> Self {
        Self { path: path.into(), limits }
    }
}

impl Program for Driver {
    fn run(&self, input: &str) -> Ran {
        run_within(limited(&self.path, &self.limits), input, &self.limits, None)
    }

    fn at_once(&self) -> usize {
        std::thread::available_parallelism().map_or(1, usize::from).min(MOST_AT_ONCE)
    }

    fn sandbox(&self) -> Vec<Barrier> {
        let mut sandbox = vec![
            Barrier { name: format!("deadline {} s", self.limits.seconds), missing: None },
            Barrier { name: format!("output {} kB", self.limits.output_kb), missing: None },
        ];
        sandbox.extend(system_limits(&self.limits));
        sandbox
    }
}

/// Runs a prepared command to its end: deadline, cap on its output, and nothing of its process group left.
///
/// On unix the command must make its process the leader of a group. A wish to stop ends it as if it had not started.
pub(crate) fn run_within(mut command: Command, input: &str, limits: &Limits, stop: Option<&Stop>) -> Ran {
    let (begin, clock) = (Instant::now(), Clock::new());
    let ran = |stdout, stderr, end| Ran { stdout, stderr, end, millis: begin.elapsed().as_millis() as u64 };
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = match command.spawn() {
        Ok(child) => child,
        Err(error) => {
            let what = format!("{}: {error}", command.get_program().to_string_lossy());
            return ran(Vec::new(), Vec::new(), End::NotStarted(what));
        }
    };
    // Only standard output is capped by ending the process; the complaints are just cut.
    let (on_stdout, stdout_events) = channel();
    let (on_stderr, stderr_events) = channel();
    let stdout = child.stdout.take().map(|pipe| Pipe::read(pipe, limits.output_kb as usize * 1024, on_stdout));
    let stderr = child.stderr.take().map(|pipe| Pipe::read(pipe, STDERR, on_stderr));
    if let Some(pipe) = child.stdin.take() {
        feed(pipe, input.to_owned());
    }
    let seconds = Duration::try_from_secs_f64(limits.seconds).unwrap_or(Duration::MAX);
    let mut watch = Watch { stdout: stdout_events, closed: false };
    let (status, stopped) = match watch.until(&mut child, clock, seconds, stop) {
        Ok(status) => (status, None),
        Err(end) => {
            end_group(&mut child);
            (wait_a_moment(&mut child), Some(end))
        }
    };
    if !watch.closed && !runs_dry(&watch.stdout, GRACE) {
        end_group(&mut child);
        runs_dry(&watch.stdout, GRACE);
    }
    runs_dry(&stderr_events, GRACE);
    let [stdout, stderr] = [stdout, stderr].map(|pipe| pipe.map_or_else(Vec::new, |pipe| pipe.take()));
    let end = stopped.unwrap_or_else(|| {
        let (code, signal) = code_and_signal(status);
        end_of(code, signal, &stderr)
    });
    ran(stdout, stderr, end)
}

/// A process being waited for.
struct Watch {
    stdout: Receiver<Event>,
    closed: bool,
}

impl Watch {
    /// Until the process ends by itself; or the reason to end it.
    fn until(
        &mut self,
        child: &mut Child,
        mut clock: Clock,
        limit: Duration,
        stop: Option<&Stop>,
    ) -> Result<Option<ExitStatus>, End> {
        loop {
            match child.try_wait() {
                Ok(None) => {}
                Ok(status) => return Ok(status),
                Err(_) => return Ok(None),
            }
            if stop.is_some_and(Stop::is_wished) {
                return Err(End::NotStarted("the grader is to stop".to_owned()));
            }
            let left = clock.left_of(limit).ok_or(End::TimedOut)?;
            let pause = left.min(LOOK[usize::from(self.closed)]);
            if self.closed {
                std::thread::sleep(pause);
                continue;
            }
            match self.stdout.recv_timeout(pause) {
                Ok(Event::Full) => return Err(End::OutputLimit),
                Ok(Event::Closed) => self.closed = true,
                Err(_) => {}
            }
        }
    }
}

/// Waits until a pipe is closed, for a while.
fn runs_dry(events: &Receiver<Event>, grace: Duration) -> bool {
    let until = Instant::now() + grace;
    loop {
        match events.recv_timeout(until.saturating_duration_since(Instant::now())) {
            Ok(Event::Closed) => return true,
            Ok(Event::Full) => {}
            Err(_) => return false,
        }
    }
}

fn wait_a_moment(child: &mut Child) -> Option<ExitStatus> {
    let begin = Instant::now();
    while begin.elapsed() < GRACE {
        if let Ok(Some(status)) = child.try_wait() {
            return Some(status);
        }
        std::thread::sleep(LOOK[1]);
    }
    None
}

#[cfg(unix)]
fn code_and_signal(status: Option<ExitStatus>) -> (Option<i32>, Option<i32>) {
    use std::os::unix::process::ExitStatusExt;
    (status.and_then(|s| s.code()), status.and_then(|s| s.signal()))
}

#[cfg(not(unix))]
fn code_and_signal(status: Option<ExitStatus>) -> (Option<i32>, Option<i32>) {
    (status.and_then(|s| s.code()), None)
}

/// Ends the process and all of its group. The shell's own `kill` reaches a group on every unix.
#[cfg(unix)]
fn end_group(child: &mut Child) {
    let _ = Command::new("/bin/sh")
        .args(["-c", "kill -s KILL -- \"-$0\""])
        .arg(child.id().to_string())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    let _ = child.kill();
}

#[cfg(not(unix))]
fn end_group(child: &mut Child) {
    let _ = child.kill();
}

/// The limits as words for the shell's `ulimit`, each with what it is called in reports.
#[cfg(unix)]
fn ulimits(limits: &Limits) -> [(String, String); 5] {
    let Limits { cpu_seconds: cpu, memory_mb, file_kb, files, .. } = limits;
    [
        (format!("-S -t {cpu}"), format!("processor {cpu} s")),
        (format!("-S -v {}", memory_mb * 1024), format!("memory {memory_mb} MB")),
        // In blocks of 512 bytes.
        (format!("-S -f {}", file_kb * 2), format!("file size {file_kb} kB")),
        (format!("-S -n {files}"), format!("{files} open files")),
        ("-S -c 0".to_owned(), "no core files".to_owned()),
    ]
}

/// The program, to be run within what the system can limit before it starts. Arguments may be added.
#[cfg(unix)]
pub(crate) fn limited(path: &Path, limits: &Limits) -> Command {
    use std::os::unix::process::CommandExt;
    if !path.is_file() {
        // The shell would hide that the program is missing behind an exit code of its own.
        return Command::new(path);
    }
    let mut script: String = ulimits(limits).iter().map(|(words, _)| format!("ulimit {words} 2>&-; ")).collect();
    script.push_str("exec \"$0\" \"$@\"");
    let mut command = Command::new("/bin/sh");
    command.arg("-c").arg(script).arg(path).process_group(0);
    command
}

/// The program; this system limits nothing before it starts.
#[cfg(not(unix))]
pub(crate) fn limited(path: &Path, _: &Limits) -> Command {
    Command::new(path)
}

#[cfg(unix)]
fn system_limits(limits: &Limits) -> Vec<Barrier> {
    let holds = |words: &str| {
        let shell = Command::new("/bin/sh").arg("-c").arg(format!("ulimit {words}")).output();
        match shell {
            Ok(out) if out.status.success() => None,
            Ok(out) => Some(String::from_utf8_lossy(&out.stderr).trim().to_owned()),
            Err(error) => Some(format!("/bin/sh: {error}")),
        }
    };
    ulimits(limits).into_iter().map(|(words, name)| Barrier { missing: holds(&words), name }).collect()
}

#[cfg(not(unix))]
fn system_limits(limits: &Limits) -> Vec<Barrier> {
    let missing = Some("only unix systems limit a process before it starts".to_owned());
    vec![Barrier { name: format!("memory {} MB", limits.memory_mb), missing }]
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    /// A shell script as a program.
    fn program(dir: &tempfile::TempDir, script: &str, limits: Limits) -> Driver {
        let path = dir.path().join("program");
        std::fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
        Driver::new(path, limits)
    }

    #[test]
    fn a_program_answers_and_its_end_is_known() {
        let dir = tempfile::tempdir().unwrap();
        let ran = program(&dir, "cat; echo no >&2; exit 3", Limits::default()).run("a case\n");
        assert_eq!((&*ran.stdout, &*ran.stderr), (&b"a case\n"[..], &b"no\n"[..]));
        assert_eq!(ran.end, End::Exited(3));
        let ran = program(&dir, "kill -s SEGV $$", Limits::default()).run("");
        assert_eq!(ran.end, End::Signalled { signal: 11, name: "SIGSEGV" });
        let missing = Driver::new(dir.path().join("none"), Limits::default()).run("");
        assert!(matches!(&missing.end, End::NotStarted(what) if what.contains("none")), "{:?}", missing.end);
    }

    #[test]
    fn deadline_and_output_cap_end_it() {
        let dir = tempfile::tempdir().unwrap();
        let short = Limits { seconds: 0.2, ..Limits::default() };
        let ran = program(&dir, "echo begun; sleep 60", short).run("");
        assert_eq!((&*ran.stdout, ran.end), (&b"begun\n"[..], End::TimedOut));
        assert!(ran.millis < 2000, "{} ms", ran.millis);
        let small = Limits { output_kb: 64, ..Limits::default() };
        let ran = program(&dir, "while :; do echo xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx; done", small).run("");
        assert_eq!((ran.stdout.len(), ran.end), (64 * 1024, End::OutputLimit));
        // What it complains of is cut, too, but that ends nothing.
        let ran = program(&dir, "head -c 200000 /dev/zero >&2; echo end", small).run("");
        assert_eq!((ran.stdout.len(), ran.stderr.len(), ran.end), (4, 64 * 1024, End::Exited(0)));
    }

    #[test]
    fn a_child_that_keeps_the_pipe_open_is_not_waited_for() {
        let dir = tempfile::tempdir().unwrap();
        let ran = program(&dir, "sleep 60 & echo $!", Limits::default()).run("");
        assert_eq!(ran.end, End::Exited(0));
        assert!(ran.millis < 3000, "{} ms", ran.millis);
        let pid = String::from_utf8(ran.stdout).unwrap();
        // One that has ended, and that nobody has asked about yet, is a zombie.
        let state = Command::new("ps").args(["-o", "stat=", "-p", pid.trim()]).output().unwrap().stdout;
        assert!(matches!(state.first(), None | Some(b'Z')), "the child {pid} was left behind");
    }

    #[test]
    fn limits_of_the_system_hold() {
        let dir = tempfile::tempdir().unwrap();
        let driver = program(&dir, "ulimit -S -v; ulimit -S -t", Limits::default());
        assert_eq!(String::from_utf8(driver.run("").stdout).unwrap(), "1048576\n5\n");
        assert!(driver.sandbox().iter().all(|barrier| barrier.missing.is_none()), "{:?}", driver.sandbox());
    }
}
