//! What a driver answered, once it has been read.

use super::structure::Structure;
use super::value::Value;

/// The answer to some cases.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Answers {
    /// One for each case that was begun, in their order.
    pub cases: Vec<CaseAnswer>,
    /// Whether the driver said that it has come to its end.
    pub done: bool,
    /// The driver's complaint about the input, if it did not understand it: the grader's fault.
    pub complaint: Option<String>,
    /// What the student's code printed, cut.
    pub printed: String,
}

/// The answer to one case.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct CaseAnswer {
    /// One for each step that is answered, in their order, as far as it got.
    pub replies: Vec<Reply>,
    /// Whether all steps were answered, and the end was said.
    pub complete: bool,
    /// The first line that does not belong where it stands.
    pub broken: Option<Broken>,
}

/// The answer to one step.
#[derive(Clone, PartialEq, Debug)]
pub enum Reply {
    /// A call was made.
    Called(Called),
    /// A call could not be made, because a word of it leads over a pointer that is not set.
    Unresolved(String),
    /// The structure.
    Dump(Structure),
    /// A drawing.
    Svg(String),
    /// How many records the last call looked at.
    Reads(u64),
    /// What came of many calls.
    Many(Many),
}

/// What came of many calls of one function.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Many {
    /// How many were made, until the budget was used up.
    pub asked: usize,
    /// How many values came back altogether.
    pub answers: u64,
    /// How many records were looked at altogether.
    pub reads: u64,
    /// The most that one call looked at.
    pub most: u64,
    /// The number of the element that this call was made for.
    pub element: u32,
    /// Where it spends its reads, in the student's file.
    pub place: Option<String>,
}

/// A call and its end.
#[derive(Clone, PartialEq, Debug)]
pub struct Called {
    /// The arguments as numbers of elements; none if one of them is no such number.
    pub arguments: Vec<u32>,
    /// How it ended.
    pub end: CallEnd,
}

/// How a call ended.
#[derive(Clone, PartialEq, Debug)]
pub enum CallEnd {
    /// It returned.
    Returned(Vec<Value>),
    /// It panicked.
    Panicked {
        /// What it said.
        message: String,
        /// `src/lab.rs:41:9`, if the driver's hook saw it.
        place: Option<String>,
    },
    /// It read more records than any right answer needs, and was stopped.
    Stopped(Stopped),
}

/// A call that was stopped, and what it was doing.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stopped {
    /// How many records it had looked at.
    pub reads: u64,
    /// How its last reads follow each other.
    pub pattern: Pattern,
    /// `src/lab.rs:41:9`, where the last read came from.
    pub place: Option<String>,
    /// What it read last, in order, as words such as `h3`: one round of a circle, else the last few.
    pub elements: Vec<String>,
}

/// How the last reads of a call follow each other.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Pattern {
    /// Round and round through the same few records.
    Circle,
    /// Through all records in the order of their numbers, again and again.
    Scan,
    /// Neither.
    Open,
}

impl Stopped {
    /// What happened, as the end of a sentence about the call.
    #[must_use]
    pub fn words(&self) -> String {
        let reads = grouped(self.reads);
        let list = self.elements.join(", ");
        match (self.pattern, self.elements.len()) {
            (Pattern::Circle, 1) => format!("does not come back: after {reads} reads it stays at {list}"),
            (Pattern::Circle, _) => {
                format!("does not come back: after {reads} reads it goes round and round, {list}, {list} …")
            }
            (Pattern::Scan, _) => format!("looks at everything, again and again: {reads} reads and no end"),
            (Pattern::Open, 0) => format!("does not come back: {reads} reads and no end"),
            (Pattern::Open, _) => format!("does not come back: {reads} reads and no end, the last of them {list}"),
        }
    }
}

/// A number with its digits in groups of three.
#[must_use]
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

impl CallEnd {
    /// How it ended, as the end of a sentence about the call.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Returned(_) => "returned".to_owned(),
            Self::Panicked { message, .. } => format!("panicked: {message}"),
            Self::Stopped(stopped) => stopped.words(),
        }
    }

    /// Whether the code is still a `todo!()` there.
    #[must_use]
    pub fn is_todo(&self) -> bool {
        matches!(self, Self::Panicked { message, .. } if is_todo(message))
    }
}

/// Whether a panic message is that of `todo!()`.
#[must_use]
pub(crate) fn is_todo(message: &str) -> bool {
    message.starts_with("not yet implemented")
}

/// Why an answer is not what the driver prints for the case.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Broken {
    /// Another line was due.
    #[error("line {line} of the answer: expected {expected}, found `{found}`")]
    Expected {
        /// From 1.
        line: usize,
        /// What was due.
        expected: String,
        /// The line, cut.
        found: String,
    },
    /// A word that should be a number.
    #[error("line {line} of the answer: `{word}` is not {wanted}")]
    Number {
        /// From 1.
        line: usize,
        /// The word, cut.
        word: String,
        /// What it should be.
        wanted: &'static str,
    },
    /// Records of a dump are numbered from 0 without gaps.
    #[error("line {line} of the answer: {kind} {found} where {kind} {expected} is due")]
    OutOfOrder {
        /// From 1.
        line: usize,
        /// The record.
        kind: &'static str,
        /// Its number.
        found: u32,
        /// The number that is due.
        expected: usize,
    },
    /// More than the grader is willing to read.
    #[error("line {line} of the answer: more than {cap} {what}")]
    TooMuch {
        /// From 1.
        line: usize,
        /// Of what.
        what: &'static str,
        /// How many are read.
        cap: usize,
    },
    /// The structure was said to be the same as before, but there was none before.
    #[error("line {line} of the answer: `dump same` without a dump before it")]
    NothingBefore {
        /// From 1.
        line: usize,
    },
}
