//! What the grader tells the launcher, and what the launcher's exit code tells the grader.
//!
//! ```text
//!   0 ..= 180   the program ended by itself with this code; greater ones are cut to 180
//!   190         it was ended at the deadline
//!   191         a barrier could not be put up; the last line of stderr is the token and the reason
//!   192 + s     it was ended by signal s
//! ```
//!
//! The program cannot forge the last line: the token is drawn anew for each run and is gone from the environment
//! before the program starts. All it can do with such a code is to lose.

use super::Task;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// The word that makes the launcher of a binary.
pub(super) const WORD: &str = "__walled";
/// The word after it that makes the program which tries the barriers from inside.
pub(super) const INSIDE: &str = "inside";
/// The variable that holds the [`Spec`].
pub(super) const VARIABLE: &str = "DCEL_WALLED";

const LAST_CODE: i32 = 180;
const TIMED_OUT: i32 = 190;
const NO_WALL: i32 = 191;
const SIGNAL: i32 = 192;

/// The steps of the launcher.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(super) enum Step {
    /// Becomes another user, enters namespaces.
    Guard,
    /// Sees to the end of everything.
    Watch,
    /// Limits itself and becomes the program.
    Enter,
    /// Ends whatever else the user runs.
    Sweep,
}

/// Everything about one run.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) struct Spec {
    pub(super) step: Step,
    /// Marks a line of stderr as the launcher's own.
    pub(super) token: String,
    /// What is to be run; its limits count what the launcher needs, too.
    pub(super) task: Task,
    pub(super) user: Option<u32>,
    pub(super) namespaces: bool,
    /// The number that the user has within the namespaces; never that of root.
    pub(super) inside: u32,
    /// What is not to be seen even if it lies within what may be.
    pub(super) hidden: Vec<PathBuf>,
    /// What may be seen, where there are namespaces or own files only.
    pub(super) files: Files,
    /// Whether the kernel checks every file that is opened.
    pub(super) own_files: bool,
}

/// What may be seen of the file system.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(super) struct Files {
    pub(super) read: Vec<PathBuf>,
    pub(super) run: Vec<PathBuf>,
    pub(super) write: Vec<PathBuf>,
}

/// How a step ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Outcome {
    Exited(i32),
    Signalled(i32),
    TimedOut,
    NoWall,
}

impl Outcome {
    pub(super) fn of_status(status: std::process::ExitStatus) -> Self {
        use std::os::unix::process::ExitStatusExt;
        match (status.code(), status.signal()) {
            // The next step could not put up a barrier; or the program says so, and then there is no token.
            (Some(NO_WALL), _) => Self::NoWall,
            (Some(code), _) => Self::Exited(code),
            (None, signal) => Self::Signalled(signal.unwrap_or(0)),
        }
    }

    pub(super) fn code(self) -> u8 {
        let code = match self {
            Self::Exited(code) => code.clamp(0, LAST_CODE),
            Self::Signalled(signal) => SIGNAL + signal.clamp(0, 63),
            Self::TimedOut => TIMED_OUT,
            Self::NoWall => NO_WALL,
        };
        u8::try_from(code).unwrap_or(u8::MAX)
    }

    pub(super) fn of_code(code: i32) -> Self {
        match code {
            TIMED_OUT => Self::TimedOut,
            NO_WALL => Self::NoWall,
            SIGNAL.. => Self::Signalled(code - SIGNAL),
            _ => Self::Exited(code),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Outcome;

    #[test]
    fn outcomes_survive_an_exit_code() {
        let all = (0..=180).map(Outcome::Exited).chain((1..64).map(Outcome::Signalled));
        for outcome in all.chain([Outcome::TimedOut, Outcome::NoWall]) {
            assert_eq!(Outcome::of_code(i32::from(outcome.code())), outcome);
        }
        // A program that exits with a code of ours gets a smaller one.
        assert_eq!(Outcome::of_code(i32::from(Outcome::Exited(191).code())), Outcome::Exited(180));
    }
}
