//! What a command found, and how it is told: in words, or as JSON.

use super::{Failure, Output};
use serde::Serialize;
use std::io;
use std::process::ExitCode;

/// A value for an answer in JSON, with these fields in this order. Its type has no name to say.
macro_rules! fields {
    ($($name:ident $(: $value:expr)?),* $(,)?) => {{
        #[allow(non_camel_case_types)]
        mod shape {
            #[derive(serde::Serialize)]
            pub(super) struct Fields<$($name),*> {
                $(pub(super) $name: $name),*
            }
        }
        shape::Fields { $($name $(: $value)?),* }
    }};
}
pub(crate) use fields;

/// The answer of a command that could do its work.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Answer {
    /// Fine.
    Yes,
    /// Invalid, different.
    No,
}

impl Answer {
    pub(crate) fn exit_code(self) -> ExitCode {
        match self {
            Self::Yes => ExitCode::SUCCESS,
            Self::No => ExitCode::from(1),
        }
    }
}

/// A report whose fields are the answer in JSON, and that people can read, too.
pub(crate) trait InWords: Serialize {
    /// Prints it for people.
    fn print(&self, out: &mut Output) -> io::Result<()>;
}

/// Tells what was found: all is fine.
pub(crate) fn tell(report: &impl InWords, json: bool, out: &mut Output) -> Result<Answer, Failure> {
    if json {
        out.json(report)?;
    } else {
        report.print(out)?;
    }
    Ok(Answer::Yes)
}
