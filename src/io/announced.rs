//! Counts that a file says before the things come.

use super::problem::{ReadError, ReadProblem};
use super::text::{Scanner, Word};

/// A number of things that a file says at its start.
pub(super) struct Announced {
    count: u64,
    place: (u32, u32),
    word: String,
}

impl Announced {
    pub(super) fn new(scanner: &Scanner<'_>, word: Word<'_>) -> Result<Self, ReadError> {
        Ok(Self { count: scanner.count(word)?, place: scanner.place(word.at), word: word.show() })
    }

    /// Refuses another number of things than there are.
    pub(super) fn check(self, there: usize, what: &'static str, source: &str) -> Result<(), ReadError> {
        if self.count == there as u64 {
            return Ok(());
        }
        let wanted = format!("the number of {what}, {there}").into();
        let problem = ReadProblem::Expected { wanted, found: format!("`{}`", self.word) };
        Err(ReadError::at(source, self.place, problem, "correct it or leave the line out"))
    }
}
