//! What a command found, and how it is told: in words, or as JSON.

use super::{Failure, Output};
use serde::Serialize;
use std::io;
use std::process::ExitCode;

/// A value for an answer in JSON, with these fields in this order. Its type has no name to say.
macro_rules! fields {
    ($($(#[$how:meta])* $name:ident $(: $value:expr)?),* $(,)?) => {{
        #[allow(non_camel_case_types)]
        mod shape {
            #[derive(serde::Serialize)]
            pub(super) struct Fields<$($name),*> {
                $($(#[$how])* pub(super) $name: $name),*
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

/// Tells what was found, as JSON or for people: all is fine.
pub(crate) fn tell(
    answer: &impl Serialize,
    json: bool,
    out: &mut Output,
    print: impl FnOnce(&mut Output) -> io::Result<()>,
) -> Result<Answer, Failure> {
    if json {
        out.json(answer)?;
    } else {
        print(out)?;
    }
    Ok(Answer::Yes)
}
