//! The records of a PLY file, from text or from binary data.

use super::super::words::counted;
use super::header::{Element, Kind};
use crate::io::problem::{ReadError, ReadProblem};
use crate::io::text::{Scanner, Syntax};
use crate::plane::check_coordinate;
use crate::progress::Stage;

/// A source of records: values come one after the other, between `begin` and `end`.
pub(super) trait Records {
    /// How many bytes are left.
    fn remaining(&self) -> usize;
    /// Starts record `i` of an element; returns its line, if lines mean anything.
    fn begin(&mut self, element: &Element, i: u64) -> Result<Option<u32>, ReadError>;
    /// Reads a coordinate and checks it.
    fn coordinate(&mut self, axis: char, kind: Kind) -> Result<f64, ReadError>;
    /// Reads the length of a list.
    fn count(&mut self, kind: Kind) -> Result<u64, ReadError>;
    /// Reads the number of one of `points` points.
    fn index(&mut self, kind: Kind, points: u64) -> Result<u32, ReadError>;
    /// Steps over values.
    fn skip(&mut self, values: u64, kind: Kind) -> Result<(), ReadError>;
    /// Ends a record.
    fn end(&mut self) -> Result<(), ReadError>;
    /// Ends the file.
    fn finish(&mut self, notes: &mut Vec<String>) -> Result<(), ReadError>;
    /// An error at the current place.
    fn error_here(&self, what: ReadProblem) -> ReadError;
}

/// Records as lines of words.
pub(super) struct Text<'a> {
    scanner: Scanner<'a>,
}

impl<'a> Text<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize, source: &'a str) -> Result<Self, ReadError> {
        let mut scanner = Scanner::new(bytes, source, Syntax::default())?;
        while scanner.at() < at && scanner.next_line() {}
        Ok(Self { scanner })
    }
}

impl Records for Text<'_> {
    fn remaining(&self) -> usize {
        self.scanner.remaining()
    }

    #[inline]
    fn begin(&mut self, element: &Element, i: u64) -> Result<Option<u32>, ReadError> {
        let first = self.scanner.need_anywhere(|| format!("{} {i} of {}", element.name, element.count))?;
        self.scanner.go_back_to(first.at);
        Ok(Some(self.scanner.line()))
    }

    #[inline]
    fn coordinate(&mut self, axis: char, _: Kind) -> Result<f64, ReadError> {
        self.scanner.need_coordinate(axis, || "a vertex".to_owned())
    }

    #[inline]
    fn count(&mut self, _: Kind) -> Result<u64, ReadError> {
        let word = self.scanner.need(|| "the length of a list".to_owned())?;
        self.scanner.count(word)
    }

    #[inline]
    fn index(&mut self, _: Kind, points: u64) -> Result<u32, ReadError> {
        let word = self.scanner.need(|| "a corner of a face".to_owned())?;
        self.scanner.index(word, "vertex", points, 0)
    }

    fn skip(&mut self, values: u64, _: Kind) -> Result<(), ReadError> {
        for _ in 0..values {
            let word = self.scanner.need(|| "a value".to_owned())?;
            self.scanner.number(word)?;
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), ReadError> {
        self.scanner.end_of_line("this is more than the properties that the header announces")?;
        self.scanner.next_line();
        Ok(())
    }

    fn finish(&mut self, _: &mut Vec<String>) -> Result<(), ReadError> {
        match self.scanner.word_anywhere() {
            None => Ok(()),
            Some(word) => Err(self.scanner.expected(word, "the end of the file", "correct the counts in the header")),
        }
    }

    fn error_here(&self, what: ReadProblem) -> ReadError {
        self.scanner.error(self.scanner.at(), what, "")
    }
}

/// Records as bytes, the least significant first if `LITTLE`.
pub(super) struct Binary<'a, const LITTLE: bool> {
    bytes: &'a [u8],
    at: usize,
    source: &'a str,
    inside: (String, u64),
    stage: Stage,
}

impl<'a, const LITTLE: bool> Binary<'a, LITTLE> {
    pub(super) fn new(bytes: &'a [u8], at: usize, source: &'a str) -> Self {
        Self { bytes, at, source, inside: (String::new(), 0), stage: Stage::new("reading", bytes.len()) }
    }

    #[cold]
    fn error(&self, at: usize, what: ReadProblem) -> ReadError {
        ReadError { offset: Some(at as u64), ..ReadError::whole(self.source, what, "") }
    }

    #[cold]
    fn truncated(&self) -> ReadError {
        let (element, i) = &self.inside;
        self.error(self.bytes.len(), ReadProblem::Truncated { inside: format!("{element} {i}") })
    }

    #[inline]
    fn take<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let Some(bytes) = self.bytes[self.at..].first_chunk::<N>() else { return Err(self.truncated()) };
        self.at += N;
        let mut bytes = *bytes;
        if !LITTLE {
            bytes.reverse();
        }
        Ok(bytes)
    }

    #[inline]
    fn whole(&mut self, kind: Kind) -> Result<i64, ReadError> {
        Ok(match kind {
            Kind::I8 => i8::from_le_bytes(self.take()?).into(),
            Kind::U8 => u8::from_le_bytes(self.take()?).into(),
            Kind::I16 => i16::from_le_bytes(self.take()?).into(),
            Kind::U16 => u16::from_le_bytes(self.take()?).into(),
            Kind::I32 => i32::from_le_bytes(self.take()?).into(),
            Kind::U32 => u32::from_le_bytes(self.take()?).into(),
            // The header lets no such type through where a whole number is needed.
            Kind::F32 => f32::from_le_bytes(self.take()?) as i64,
            Kind::F64 => f64::from_le_bytes(self.take()?) as i64,
        })
    }
}

impl<const LITTLE: bool> Records for Binary<'_, LITTLE> {
    fn remaining(&self) -> usize {
        self.bytes.len() - self.at
    }

    #[inline]
    fn begin(&mut self, element: &Element, i: u64) -> Result<Option<u32>, ReadError> {
        if i == 0 {
            self.inside.0.clone_from(&element.name);
        }
        self.inside.1 = i;
        if i.is_multiple_of(4096) {
            self.stage.set(self.at);
        }
        Ok(None)
    }

    #[inline]
    fn coordinate(&mut self, axis: char, kind: Kind) -> Result<f64, ReadError> {
        let at = self.at;
        let value = match kind {
            Kind::F32 => f32::from_le_bytes(self.take()?).into(),
            Kind::F64 => f64::from_le_bytes(self.take()?),
            whole => self.whole(whole)? as f64,
        };
        check_coordinate(axis, value).map_err(|error| self.error(at, error.into()))?;
        Ok(value)
    }

    #[inline]
    fn count(&mut self, kind: Kind) -> Result<u64, ReadError> {
        let at = self.at;
        let count = self.whole(kind)?;
        u64::try_from(count).map_err(|_| {
            let problem = ReadProblem::NotANumber { word: count.to_string(), wanted: "the length of a list" };
            self.error(at, problem)
        })
    }

    #[inline]
    fn index(&mut self, kind: Kind, points: u64) -> Result<u32, ReadError> {
        let at = self.at;
        let index = self.whole(kind)?;
        match u32::try_from(index).ok().filter(|&i| u64::from(i) < points) {
            Some(i) => Ok(i),
            None => Err(self.error(at, ReadProblem::IndexOutOfRange { what: "vertex", index, count: points })),
        }
    }

    fn skip(&mut self, values: u64, kind: Kind) -> Result<(), ReadError> {
        let bytes = values.saturating_mul(kind.bytes() as u64);
        if bytes > self.remaining() as u64 {
            return Err(self.truncated());
        }
        self.at += bytes as usize;
        Ok(())
    }

    #[inline]
    fn end(&mut self) -> Result<(), ReadError> {
        Ok(())
    }

    fn finish(&mut self, notes: &mut Vec<String>) -> Result<(), ReadError> {
        let rest = self.bytes[self.at..].trim_ascii().len();
        if rest > 0 {
            let (left, were) = (self.remaining(), if self.remaining() == 1 { "was" } else { "were" });
            notes.push(format!("{} after the last element {were} skipped", counted(left, "byte", "bytes")));
        }
        Ok(())
    }

    fn error_here(&self, what: ReadProblem) -> ReadError {
        self.error(self.at, what)
    }
}
