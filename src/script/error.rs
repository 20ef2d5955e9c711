//! What is wrong with the text of a script, where, and what to try.
//!
//! ```text
//!   lesson.dcels:3:12: `nxt` is not a link of a half-edge; known: next prev twin origin destination face edge
//!   └─ source ─┘ └ line:column, both from 1, the column in characters
//! ```

use super::kernel::KernelStartError;
use crate::plane::{ConvertError, CoordinateError};
use std::fmt;

/// A text that is no script. Prints as `source:line:column: what; help`.
#[derive(Debug, Clone, PartialEq)]
pub struct ScriptError {
    /// The file, or `<stdin>`.
    pub source: String,
    /// The line, from 1.
    pub line: u32,
    /// The column, from 1, in characters.
    pub column: u32,
    /// What is wrong. In a box, so that the way without errors carries little.
    pub what: Box<Problem>,
    /// What to try.
    pub help: String,
}

/// What can be wrong with the text of a script.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// There is no statement at all.
    #[error("the script is empty")]
    Empty,
    /// The first statement is no start, or a later one is.
    #[error("`{word}` {}", if *.first { "is no start" } else { "cannot start the script again" })]
    Start {
        /// The word.
        word: String,
        /// Whether it is the first statement.
        first: bool,
    },
    /// The first word of a statement is not known.
    #[error("unknown statement `{word}`")]
    Statement {
        /// The word.
        word: String,
    },
    /// Something should stand here and does not.
    #[error("{statement} needs {wanted}")]
    Missing {
        /// The statement.
        statement: String,
        /// What it needs.
        wanted: &'static str,
    },
    /// A word too many.
    #[error("`{word}` is one word too many for {statement}")]
    Extra {
        /// The word.
        word: String,
        /// The statement.
        statement: String,
    },
    /// A word that should be a number.
    #[error("`{word}` is not {wanted}")]
    Number {
        /// The word.
        word: String,
        /// `a number`, `the number of a point`.
        wanted: &'static str,
    },
    /// A coordinate with which exact geometry would not be exact.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// The start is no subdivision of the plane.
    #[error(transparent)]
    Convert(#[from] ConvertError),
    /// The start is no structure of the kernel.
    #[error(transparent)]
    KernelStart(#[from] KernelStartError),
    /// The start is no surface in space.
    #[cfg(feature = "solid")]
    #[error(transparent)]
    SolidStart(#[from] crate::solid::SolidError),
    /// A word that names nothing.
    #[error("`{word}` is not known")]
    Name {
        /// The word.
        word: String,
    },
    /// A number that the start does not give.
    #[error("`{word}` is not given: the start has {first} .. {last}")]
    NotGiven {
        /// The word.
        word: String,
        /// The first given element of the kind.
        first: String,
        /// The last given element of the kind.
        last: String,
    },
    /// A name that cannot be given.
    #[error("`{word}` cannot be a name")]
    BadName {
        /// The word.
        word: String,
    },
    /// A name that is taken.
    #[error("`{word}` is taken: line {line} has named it")]
    Taken {
        /// The word.
        word: String,
        /// The line that did.
        line: u32,
    },
    /// A link that the kind of element does not have.
    #[error("`{word}` is not a link of {kind}")]
    Link {
        /// The word.
        word: String,
        /// `a half-edge`, `a vertex`, ...
        kind: &'static str,
    },
    /// An element of the wrong kind.
    #[error("`{word}` is {kind}, but {statement} needs {wanted}")]
    Kind {
        /// The word.
        word: String,
        /// What it is.
        kind: &'static str,
        /// The statement.
        statement: String,
        /// What it should be.
        wanted: &'static str,
    },
    /// A statement that makes nothing to name.
    #[error("{statement} makes nothing new that could be named")]
    NothingToName {
        /// The statement.
        statement: String,
    },
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: {}", self.source, self.line, self.column, self.what)?;
        if self.help.is_empty() { Ok(()) } else { write!(f, "; {}", self.help) }
    }
}

impl std::error::Error for ScriptError {}
