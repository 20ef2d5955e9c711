//! Reading the words of a line one after the other; what does not fit is reported with its place.

use super::error::Problem;
use super::words::{Line, Word};
use crate::plane::{Point, check_coordinate};

/// A [`ScriptError`] whose source is not known yet.
pub(super) struct Complaint {
    pub(super) line: u32,
    pub(super) column: u32,
    pub(super) what: Problem,
    pub(super) help: String,
}

/// The words of a line that have not been read yet.
pub(super) struct Cursor<'a> {
    pub(super) line: &'a Line<'a>,
    pub(super) at: usize,
    /// The word that says what statement it is.
    pub(super) statement: &'a str,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(line: &'a Line<'a>) -> Self {
        Self { line, at: 0, statement: "" }
    }

    pub(super) fn at(&self, word: Word<'_>, what: Problem, help: impl Into<String>) -> Complaint {
        Complaint { line: self.line.number, column: word.column, what, help: help.into() }
    }

    pub(super) fn peek(&self) -> Option<Word<'a>> {
        self.line.words.get(self.at).copied()
    }

    pub(super) fn next(&mut self) -> Option<Word<'a>> {
        let word = self.peek()?;
        self.at += 1;
        Some(word)
    }

    pub(super) fn need(&mut self, wanted: &'static str, help: &str) -> Result<Word<'a>, Complaint> {
        self.next().ok_or_else(|| Complaint {
            line: self.line.number,
            column: self.line.end,
            what: Problem::Missing { statement: self.statement.to_owned(), wanted },
            help: help.to_owned(),
        })
    }

    pub(super) fn done(&self) -> Result<(), Complaint> {
        self.peek().map_or(Ok(()), |word| {
            let what = Problem::Extra { word: show(word.text), statement: self.statement.to_owned() };
            Err(self.at(word, what, "write one statement a line; `#` starts a comment"))
        })
    }

    pub(super) fn number(&mut self, wanted: &'static str, help: &str) -> Result<f64, Complaint> {
        let word = self.need(wanted, help)?;
        let not = Problem::Number { word: show(word.text), wanted: "a number" };
        let value: f64 = word.text.parse().map_err(|_| self.at(word, not, "write a number such as 1.5 or -250"))?;
        let axis = wanted.chars().next().unwrap_or('x');
        check_coordinate(axis, value).map_err(|error| self.at(word, error.into(), ""))?;
        Ok(value)
    }

    /// A number that is no coordinate.
    pub(super) fn plain_number(&mut self, wanted: &'static str, help: &str) -> Result<f64, Complaint> {
        let word = self.need(wanted, help)?;
        let number = word.text.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| self.at(word, Problem::Number { word: show(word.text), wanted: "a number" }, help))
    }

    pub(super) fn point(&mut self, help: &str) -> Result<Point, Complaint> {
        Ok(Point::new(self.number("x", help)?, self.number("y", help)?))
    }
}

/// A word for a message.
pub(super) fn show(word: &str) -> String {
    let mut text: String = word.chars().take(40).collect();
    if text.len() < word.len() {
        text.push('…');
    }
    text.escape_debug().to_string()
}
