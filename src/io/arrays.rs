//! Nested arrays of numbers, read in place from JSON that has been parsed before.
//!
//! ```text
//!   "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]
//!                   ^each   ^position      nothing is stored on the way; every item knows its byte
//! ```

use super::nodes::Fault;
use super::problem::ReadProblem;
use super::text::parse_integer;
use serde_json::value::RawValue;

/// A reading position in a JSON value. The text is correct JSON; only its shape is not known.
pub(super) struct Arrays<'a> {
    text: &'a [u8],
    at: usize,
    /// Where the value starts in the file.
    start: usize,
}

impl<'a> Arrays<'a> {
    /// At the start of a value, which must be a part of `file`.
    pub(super) fn new(value: &'a RawValue, file: &str) -> Self {
        let start = (value.get().as_ptr() as usize).saturating_sub(file.as_ptr() as usize);
        Self { text: value.get().as_bytes(), at: 0, start }
    }

    /// The byte of the file at which the next item starts.
    pub(super) fn offset(&self) -> usize {
        self.start + self.at
    }

    /// The next byte that is not a blank.
    fn peek(&mut self) -> Option<u8> {
        while let Some(b) = self.text.get(self.at) {
            if !b.is_ascii_whitespace() {
                return Some(*b);
            }
            self.at += 1;
        }
        None
    }

    fn take(&mut self, wanted: u8) -> bool {
        let found = self.peek() == Some(wanted);
        self.at += usize::from(found);
        found
    }

    /// Reads an array item by item; `item` must read the item at hand. Anything else than an array is the
    /// problem `wrong`.
    pub(super) fn each(
        &mut self,
        wrong: impl FnOnce() -> ReadProblem,
        mut item: impl FnMut(&mut Self, usize) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        if !self.take(b'[') {
            return Err(Fault::at(self.offset(), wrong()));
        }
        if self.take(b']') {
            return Ok(());
        }
        for i in 0.. {
            self.peek();
            item(self, i)?;
            if !self.take(b',') {
                break;
            }
        }
        self.take(b']');
        Ok(())
    }

    fn word(&mut self) -> &'a [u8] {
        self.peek();
        let rest = &self.text[self.at..];
        let ends = |b: &u8| matches!(b, b',' | b']' | b'}') || b.is_ascii_whitespace();
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        &rest[..length]
    }

    /// The number at hand; none, and no step, if something else stands there.
    pub(super) fn number(&mut self) -> Option<f64> {
        let word = self.word();
        let digit = word.first().is_some_and(|&b| b == b'-' || b.is_ascii_digit());
        let number = std::str::from_utf8(word).ok().filter(|_| digit)?.parse().ok()?;
        self.at += word.len();
        Some(number)
    }

    /// The whole number at hand; none, and no step, if something else stands there.
    pub(super) fn integer(&mut self) -> Option<i64> {
        let word = self.word();
        let number = parse_integer(word)?;
        self.at += word.len();
        Some(number)
    }

    /// The position `[x, y, ...]` at hand and whether it has more than two coordinates; none if something else
    /// stands there.
    pub(super) fn position(&mut self) -> Option<([f64; 2], bool)> {
        if !self.take(b'[') {
            return None;
        }
        let x = self.number()?;
        let y = self.take(b',').then(|| self.number())??;
        let more = self.take(b',');
        if more {
            // Numbers and perhaps anything else, up to the bracket that closes the position.
            let mut depth = 0;
            while depth > 0 || self.peek()? != b']' {
                match self.text.get(self.at)? {
                    b'[' | b'{' => depth += 1,
                    b']' | b'}' => depth -= 1,
                    b'"' => self.skip_string(),
                    _ => {}
                }
                self.at += 1;
            }
        }
        self.take(b']').then_some(([x, y], more))
    }

    /// Steps from the quote that opens a string to the one that closes it.
    fn skip_string(&mut self) {
        self.at += 1;
        while let Some(&b) = self.text.get(self.at) {
            match b {
                b'"' => return,
                b'\\' => self.at += 2,
                _ => self.at += 1,
            }
        }
    }
}
