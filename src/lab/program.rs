//! A program that answers cases: text in, text out, and how it ended.
//!
//! ```text
//!   input ──stdin──▶ ┌──────────┐ ──stdout──▶ read up to a cap
//!                    │ process  │ ──stderr──▶ read up to a cap
//!   deadline ──────▶ └──────────┘ ──▶ End: exited, signalled, timed out, out of memory ...
//! ```
//!
//! [`Driver`] is the plain one for the author's own machine: it keeps a loop or a memory leak from doing harm, and
//! is no barrier against malice. It needs nothing but the standard library, so a lab can be done on every system.

mod clock;
mod pipes;
mod plain;

use super::Barrier;
#[cfg(all(feature = "grade", target_os = "linux"))]
pub(crate) use clock::Clock;
pub use plain::Driver;
pub(crate) use plain::{limited, run_within};
use serde::{Deserialize, Serialize};

/// Something that answers cases. Every call starts it anew.
pub trait Program: Sync {
    /// Gives it the input and waits for its end. Never panics, never waits much longer than the deadline.
    fn run(&self, input: &str) -> Ran;

    /// How many runs may go on at the same time without harm to each other.
    fn at_once(&self) -> usize {
        1
    }

    /// The barriers between it and the machine, for the report.
    fn sandbox(&self) -> Vec<Barrier> {
        Vec::new()
    }
}

/// What a program did.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ran {
    /// What it printed, cut at the cap.
    pub stdout: Vec<u8>,
    /// What it complained of, cut at 64 kB.
    pub stderr: Vec<u8>,
    /// How it ended.
    pub end: End,
    /// How long it took, in milliseconds.
    pub millis: u64,
}

/// How a program ended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum End {
    /// By itself, with this code.
    Exited(i32),
    /// By a signal.
    Signalled {
        /// Its number.
        signal: i32,
        /// Its name, `SIGSEGV`.
        name: &'static str,
    },
    /// It was ended at the deadline, or had used up its processor time.
    TimedOut,
    /// It was ended because it printed more than the cap.
    OutputLimit,
    /// It asked for more memory than it may have.
    OutOfMemory,
    /// It called itself too deeply.
    StackOverflow,
    /// It never ran: the file is missing, the system refused. Not the student's fault.
    NotStarted(String),
}

/// What a program may use.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct Limits {
    /// The deadline in seconds: of the clock on the wall, which goes slower, to a quarter, where more programs want to
    /// run than the machine has processors.
    pub seconds: f64,
    /// Processor time in seconds.
    pub cpu_seconds: u64,
    /// Address space in megabytes.
    pub memory_mb: u64,
    /// Standard output in kilobytes.
    pub output_kb: u64,
    /// Size of a file that it writes, in kilobytes.
    pub file_kb: u64,
    /// Open files.
    pub files: u64,
    /// Processes and threads.
    pub processes: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            seconds: 5.0,
            cpu_seconds: 5,
            memory_mb: 1024,
            output_kb: 16 * 1024,
            file_kb: 1024,
            files: 64,
            processes: 64,
        }
    }
}

/// The name of a signal.
#[must_use]
pub fn signal_name(signal: i32) -> &'static str {
    match signal {
        1 => "SIGHUP",
        2 => "SIGINT",
        3 => "SIGQUIT",
        4 => "SIGILL",
        5 => "SIGTRAP",
        6 => "SIGABRT",
        8 => "SIGFPE",
        9 => "SIGKILL",
        11 => "SIGSEGV",
        13 => "SIGPIPE",
        14 => "SIGALRM",
        15 => "SIGTERM",
        24 => "SIGXCPU",
        25 => "SIGXFSZ",
        31 => "SIGSYS",
        _ => "a signal",
    }
}

/// What a status and the complaints of a Rust program say of its end. `code` is `None` after a signal.
///
/// A program that overflows its stack, or cannot get memory, says so and aborts; the system only sees the abort.
#[must_use]
pub fn end_of(code: Option<i32>, signal: Option<i32>, stderr: &[u8]) -> End {
    /// The code with which Windows ends a program whose stack is used up.
    const WINDOWS_STACK: i32 = 0xC000_00FD_u32 as i32;
    /// The one with which it ends a program that aborts.
    const WINDOWS_ABORT: i32 = 0xC000_0409_u32 as i32;
    let says = |words: &str| stderr.windows(words.len()).any(|at| at == words.as_bytes());
    let aborted = matches!(signal, Some(6 | 11)) || matches!(code, Some(WINDOWS_STACK | WINDOWS_ABORT));
    match (code, signal) {
        _ if aborted && says("has overflowed its stack") => End::StackOverflow,
        _ if aborted && says("memory allocation of ") => End::OutOfMemory,
        (Some(WINDOWS_STACK), _) => End::StackOverflow,
        (_, Some(24)) => End::TimedOut,
        (_, Some(signal)) => End::Signalled { signal, name: signal_name(signal) },
        (Some(code), None) => End::Exited(code),
        (None, None) => End::Exited(-1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names of signals as the shell knows them: an oracle of its own. The numbers are those of Linux.
    #[test]
    #[cfg(target_os = "linux")]
    fn signals_have_the_names_that_the_system_gives_them() {
        for signal in 1..=64 {
            let name = signal_name(signal);
            let out =
                std::process::Command::new("/bin/sh").args(["-c", &format!("kill -l {signal}")]).output().unwrap();
            let known = String::from_utf8_lossy(&out.stdout).trim().to_owned();
            assert!(name == "a signal" || name == format!("SIG{known}"), "{signal}: {name}, not {known}");
        }
        let named = (1..=64).filter(|&signal| signal_name(signal) != "a signal");
        assert_eq!(named.collect::<Vec<_>>(), [1, 2, 3, 4, 5, 6, 8, 9, 11, 13, 14, 15, 24, 25, 31]);
    }

    #[test]
    fn aborts_are_told_apart_by_what_the_program_said() {
        let overflow = b"\nthread 'main' has overflowed its stack\nfatal runtime error: stack overflow\n";
        let memory = b"memory allocation of 8589934592 bytes failed\n";
        assert_eq!(end_of(None, Some(6), overflow), End::StackOverflow);
        assert_eq!(end_of(None, Some(6), memory), End::OutOfMemory);
        assert_eq!(end_of(None, Some(6), b""), End::Signalled { signal: 6, name: "SIGABRT" });
        assert_eq!(end_of(None, Some(24), b""), End::TimedOut);
        // Saying so is not enough: the program must have ended by it.
        assert_eq!(end_of(Some(0), None, memory), End::Exited(0));
        assert_eq!(end_of(Some(3), None, overflow), End::Exited(3));
    }
}
