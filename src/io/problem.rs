//! What is wrong with an input, where, and what to try.
//!
//! ```text
//!   map.obj:12:5: `1,5` is not a number; write a number such as 1.5, with a decimal point
//!   └─ source ┘ └── what ─────────────┘  └── help ─────────────────────────────────────┘
//!           line:column, both from 1, the column in characters
//! ```

use super::words::counted;
use crate::plane::CoordinateError;
use std::borrow::Cow;
use std::fmt;

/// An input that cannot be read. Prints as `source:line:column: what; help`.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadError {
    /// The file, or `<stdin>`.
    pub source: String,
    /// The line, from 1; none where lines mean nothing (binary data, elements of a JSON file).
    pub line: Option<u32>,
    /// The column, from 1, in characters.
    pub column: Option<u32>,
    /// The byte, from 0, in binary data.
    pub offset: Option<u64>,
    /// What is wrong. In a box, so that the way without errors carries little.
    pub what: Box<ReadProblem>,
    /// What to try; empty where the problem says it all.
    pub help: Cow<'static, str>,
}

/// What can be wrong with an input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadProblem {
    /// The machine refused.
    #[error("cannot be read: {reason}")]
    Io {
        /// The machine's words.
        reason: String,
    },
    /// There is not so much memory.
    #[error("not enough memory: this takes about {}", megabytes(*bytes))]
    OutOfMemory {
        /// How much is needed at once.
        bytes: u64,
    },
    /// Nothing says which format it is.
    #[error("the format is not known")]
    UnknownFormat,
    /// The kit writes this format and does not read it.
    #[error("{format} is written, not read")]
    WriteOnly {
        /// The format's name.
        format: &'static str,
    },
    /// The format keeps one drawing in two files, and one is missing.
    #[error("the partner file {partner} is missing")]
    PartnerMissing {
        /// The file that was looked for.
        partner: String,
    },
    /// A variant of the format that the kit does not read.
    #[error("{what} cannot be read")]
    Refused {
        /// The variant.
        what: Cow<'static, str>,
    },
    /// No bytes at all.
    #[error("the file is empty")]
    Empty,
    /// Bytes that are not UTF-8 text.
    #[error("this is not text in UTF-8")]
    NotText,
    /// More than the ids can name.
    #[error("too large: more than {limit} {what}")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much is possible.
        limit: u64,
    },
    /// A word that should be a number.
    #[error("`{word}` is not {wanted}")]
    NotANumber {
        /// The word.
        word: String,
        /// `a number`, `a whole number`, ...
        wanted: &'static str,
    },
    /// A coordinate with which exact geometry would not be exact.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// Something else was expected here.
    #[error("expected {wanted}, found {found}")]
    Expected {
        /// What should stand here.
        wanted: Cow<'static, str>,
        /// What stands here.
        found: String,
    },
    /// A word that the format does not know here.
    #[error("unknown word `{word}`")]
    UnknownWord {
        /// The word.
        word: String,
    },
    /// A reference to something that is not there.
    #[error("{what} {index} does not exist: there are {count}")]
    IndexOutOfRange {
        /// What is referred to: `vertex`, `arc`, ...
        what: &'static str,
        /// The number as the file writes it.
        index: i64,
        /// How many there are.
        count: u64,
    },
    /// The data end too early.
    #[error("the data end inside {inside}")]
    Truncated {
        /// What was being read.
        inside: String,
    },
    /// There is more than the header counts.
    #[error("there is more than the {count} {what} that the header counts")]
    MoreThanCounted {
        /// What is counted.
        what: &'static str,
        /// The count.
        count: u64,
    },
    /// Something that may come once came twice.
    #[error("{what} was given before, in line {first_line}")]
    Duplicate {
        /// The record or the word.
        what: String,
        /// The line of the first one.
        first_line: u32,
    },
    /// The number of a record is so large that most of the table would be empty.
    #[error("{id} is too large a number: this file may number its {what} up to {limit}")]
    SparseId {
        /// The id.
        id: String,
        /// `vertices`, `half-edges` or `faces`.
        what: &'static str,
        /// The greatest number allowed.
        limit: u64,
    },
    /// A ring of a polygon that does not end where it starts.
    #[error("{place}: the ring starts at {first} and ends at {last}")]
    UnclosedRing {
        /// Feature, polygon and ring.
        place: String,
        /// The first point.
        first: String,
        /// The last point.
        last: String,
    },
    /// A ring of a polygon that encloses nothing.
    #[error("{place}: the ring has only {} and encloses nothing", counted(*distinct, "distinct point", "distinct points"))]
    DegenerateRing {
        /// Feature, polygon and ring.
        place: String,
        /// How many distinct points it has: 0, 1 or 2.
        distinct: usize,
    },
    /// Two arcs that follow each other in a ring and do not meet.
    #[error("{place}: arc {arc} does not start where the arc before it ends")]
    BrokenRing {
        /// Feature, polygon and ring.
        place: String,
        /// The reference as the file writes it.
        arc: i64,
    },
    /// A JSON text that is not JSON.
    #[error("not JSON: {message}")]
    Json {
        /// The parser's words.
        message: String,
    },
    /// A JSON value of the wrong shape.
    #[error("{place}: expected {wanted}")]
    Shape {
        /// The path of the value.
        place: String,
        /// What it should be.
        wanted: Cow<'static, str>,
    },
    /// A coordinate in a JSON file.
    #[error("{place}: {error}")]
    CoordinateAt {
        /// Feature, polygon and ring.
        place: String,
        /// What is wrong with it.
        error: CoordinateError,
    },
}

/// `12 MB`, rounded up.
fn megabytes(bytes: u64) -> String {
    format!("{} MB", bytes.div_ceil(1_000_000))
}

impl ReadError {
    /// A problem of the whole input.
    pub(super) fn whole(source: &str, what: ReadProblem, help: impl Into<Cow<'static, str>>) -> Self {
        Self {
            source: source.to_owned(),
            line: None,
            column: None,
            offset: None,
            what: Box::new(what),
            help: help.into(),
        }
    }

    /// A problem at a line and a column.
    pub(super) fn at(
        source: &str,
        (line, column): (u32, u32),
        what: ReadProblem,
        help: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self { line: Some(line), column: Some(column), ..Self::whole(source, what, help) }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.source)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(column) = self.column {
            write!(f, ":{column}")?;
        }
        if let Some(offset) = self.offset {
            write!(f, ": byte {offset}")?;
        }
        write!(f, ": {}", self.what)?;
        if !self.help.is_empty() {
            write!(f, "; {}", self.help)?;
        }
        Ok(())
    }
}

impl std::error::Error for ReadError {}
