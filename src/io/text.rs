//! The tokenizer of all line-based formats: words of a line, each with its place.
//!
//! ```text
//!   v 1.5  2e3 # peak↵        words: `v` `1.5` `2e3`; `#` starts a comment,
//!   f 1 2 \↵                  `\` before a line end joins two lines (OBJ only),
//!     3 4↵                    ↵ is LF, CR LF or CR; the last one may be missing
//! ```
//!
//! Words are slices of the file; nothing is copied. A place is a byte offset; only an error turns it into line
//! and column, so that the way without errors pays nothing for them.

use super::block::Block;
use super::problem::{ReadError, ReadProblem};
use super::room::for_text;
use crate::plane::check_coordinate;
use crate::progress::Stage;
use std::borrow::Cow;
use std::sync::Arc;

/// Files must be smaller than this: 4 GiB, so that lines and corners can be counted in 32 bits.
pub(super) const LARGEST_FILE: u64 = u32::MAX as u64;

/// A word of the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    /// The bytes of the word.
    pub(super) text: &'a [u8],
    /// Where it starts in the file.
    pub(super) at: usize,
}

impl Word<'_> {
    /// The word for a message.
    pub(super) fn show(&self) -> String {
        let mut text: String = String::from_utf8_lossy(self.text).chars().take(40).collect();
        if text.len() < self.text.len() && text.chars().count() == 40 {
            text.push('…');
        }
        text.escape_debug().to_string()
    }
}

/// What separates and joins words in a format.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Syntax {
    /// Whether `#` starts a comment.
    pub(super) comments: bool,
    /// Whether `\` at the end of a line joins it with the next.
    pub(super) continuation: bool,
    /// Whether `"` starts a word that may hold blanks.
    pub(super) quotes: bool,
    /// Whether commas and semicolons are blanks.
    pub(super) separators: bool,
}

/// A file, or a block of one, with a reading position.
#[derive(Clone, Debug)]
pub(super) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    /// The bytes of the file before these, and the line in which these start.
    base: usize,
    first_line: u32,
    syntax: Syntax,
    /// Of [`KINDS`], those that part words, and those that end them.
    blanks: u8,
    ends: u8,
    source: &'a str,
    stage: Arc<Stage>,
}

const BLANK: u8 = 1;
const LINE_END: u8 = 2;
const COMMENT: u8 = 4;
const JOIN: u8 = 8;
const SEPARATOR: u8 = 16;

/// What each byte may mean.
const KINDS: [u8; 256] = {
    let mut kinds = [0; 256];
    let meanings = [
        (b' ', BLANK),
        (b'\t', BLANK),
        (0x0b, BLANK),
        (0x0c, BLANK),
        (b'\n', LINE_END),
        (b'\r', LINE_END),
        (b'#', COMMENT),
        (b'\\', JOIN),
        (b',', SEPARATOR),
        (b';', SEPARATOR),
    ];
    let mut i = 0;
    while i < meanings.len() {
        kinds[meanings[i].0 as usize] = meanings[i].1;
        i += 1;
    }
    kinds
};

const MARK: &[u8] = b"\xef\xbb\xbf";

const fn is_line_end(b: u8) -> bool {
    matches!(b, b'\n' | b'\r')
}

/// The number of characters in UTF-8 text; in other text, roughly.
fn characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|&&b| b & 0xc0 != 0x80).count()
}

/// Line and column, both from 1, of a byte of a file.
pub(super) fn line_and_column(bytes: &[u8], at: usize) -> (u32, u32) {
    let before = &bytes[..at.min(bytes.len())];
    let (mut line, mut start, mut i) = (1, 0, 0);
    while i < before.len() {
        if is_line_end(before[i]) {
            if before[i..].starts_with(b"\r\n") {
                i += 1;
            }
            line += 1;
            start = i + 1;
        }
        i += 1;
    }
    let text = before.get(start..).unwrap_or(&[]);
    let mark = usize::from(start == 0 && text.starts_with(b"\xef\xbb\xbf"));
    (line, (characters(text) - mark) as u32 + 1)
}

/// That the last line has no end, so that nothing tells whether it is all there: a file that was cut off while it was
/// written or sent looks like this. Nothing of binary data, and of a last line that says nothing.
pub(super) fn note_of_the_end(bytes: &[u8]) -> Option<String> {
    if bytes.contains(&0) { None } else { note_of_the_last_line(bytes, 1, false) }
}

/// The same of the last lines of a text, of which the first one has the number `first_line`. Commas and semicolons may be
/// blanks.
pub(super) fn note_of_the_last_line(bytes: &[u8], first_line: u32, separators: bool) -> Option<String> {
    let start = bytes.iter().rposition(|&b| is_line_end(b)).map_or(0, |end| end + 1);
    let says = |b: &u8| !(b.is_ascii_whitespace() || separators && matches!(b, b',' | b';'));
    let last = &bytes[start..];
    let last = &last[last.iter().position(says).unwrap_or(last.len())..];
    if last.is_empty() || last.starts_with(b"#") {
        return None;
    }
    let (line, _) = line_and_column(bytes, start);
    Some(format!("line {}, the last one, has no end: was the file cut off there?", first_line - 1 + line))
}

/// The lines of bytes that come in the order of the file, or nearly so.
pub(super) struct LineCounter<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
}

impl<'a> LineCounter<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { bytes: text.as_bytes(), at: 0, line: 1 }
    }

    /// The line of a byte, from 1.
    pub(super) fn line(&mut self, at: usize) -> u32 {
        if at < self.at {
            (self.at, self.line) = (0, 1);
        }
        self.line += self.bytes[self.at..at].iter().filter(|&&b| b == b'\n').count() as u32;
        self.at = at;
        self.line
    }
}

/// The lines and columns of many bytes, as [`line_and_column`] tells them one by one. O(length) if they come in
/// increasing order.
pub(super) fn lines_and_columns(bytes: &[u8], offsets: &[u32]) -> Vec<[u32; 2]> {
    let (mut at, mut place) = (0, [1, 1]);
    let mut places = Vec::with_capacity(offsets.len());
    for &offset in offsets {
        let offset = (offset as usize).min(bytes.len());
        if offset < at {
            (at, place) = (0, [1, 1]);
        }
        let [line, column] = line_and_column(&bytes[at..offset], offset - at).into();
        let mark = u32::from(at > 0 && bytes[at..].starts_with(b"\xef\xbb\xbf"));
        place = if line == 1 { [place[0], place[1] + column - 1 + mark] } else { [place[0] + line - 1, column] };
        at = offset;
        places.push(place);
    }
    places
}

impl<'a> Scanner<'a> {
    /// A scanner at the start of the file, behind a byte order mark.
    ///
    /// # Errors
    /// An empty file, one of 4 GiB or more, and one in UTF-16.
    pub(super) fn new(bytes: &'a [u8], source: &'a str, syntax: Syntax) -> Result<Self, ReadError> {
        check_text(bytes, source)?;
        let stage = Arc::new(Stage::new("reading", bytes.len()));
        let (left, is_part) = (bytes.len(), false);
        Ok(Self::of_block(Block { bytes, base: 0, line: 1, is_last: true, left, is_part, source, stage }, syntax))
    }

    /// A scanner at the start of a block, behind a byte order mark if it is the first one.
    pub(super) fn of_block(block: Block<'a>, syntax: Syntax) -> Self {
        let Block { bytes, base, line, source, stage, .. } = block;
        let at = if base == 0 && bytes.starts_with(MARK) { MARK.len() } else { 0 };
        let blanks = if syntax.separators { BLANK | SEPARATOR } else { BLANK };
        let comment = if syntax.comments { COMMENT } else { 0 };
        let ends = blanks | LINE_END | comment | if syntax.continuation { JOIN } else { 0 };
        Self { bytes, at, line, base, first_line: line, syntax, blanks, ends, source, stage }
    }

    /// The number of the line the scanner is in, from 1.
    pub(super) fn line(&self) -> u32 {
        self.line
    }

    /// What errors call the file.
    pub(super) fn source(&self) -> &'a str {
        self.source
    }

    /// The offset of the next byte to read.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// How many bytes are left.
    pub(super) fn remaining(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// Continues inside a word, at this byte.
    pub(super) fn go_back_to(&mut self, at: usize) {
        self.at = at;
    }

    /// Continues at this byte of the block, which is in line `line`.
    pub(super) fn go_to(&mut self, at: usize, line: u32) {
        (self.at, self.line) = (at, line);
    }

    /// Line and column, both from 1, of a byte of the block.
    pub(super) fn place(&self, at: usize) -> (u32, u32) {
        let (line, column) = line_and_column(self.bytes, at);
        // Only the first bytes of a file are a byte order mark.
        let mark = self.base > 0 && line == 1 && self.bytes[..at.min(self.bytes.len())].starts_with(MARK);
        (self.first_line - 1 + line, column + u32::from(mark))
    }

    fn byte(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// Steps over a line end, if there is one here.
    fn line_end(&mut self) -> bool {
        let length = match &self.bytes[self.at..] {
            [b'\r', b'\n', ..] => 2,
            [b'\n' | b'\r', ..] => 1,
            _ => return false,
        };
        self.at += length;
        self.line += 1;
        if self.line.is_multiple_of(4096) {
            self.stage.set(self.base + self.at);
        }
        true
    }

    fn skip_blanks(&mut self) {
        while let Some(b) = self.byte() {
            if KINDS[usize::from(b)] & self.blanks != 0 {
                self.at += 1;
            } else if b == b'\\'
                && self.syntax.continuation
                && self.bytes.get(self.at + 1).is_some_and(|&b| is_line_end(b))
            {
                self.at += 1;
                self.line_end();
            } else {
                break;
            }
        }
    }

    /// The next word of this line; none at the end of the line, of the file, or before a comment.
    #[inline]
    pub(super) fn word(&mut self) -> Option<Word<'a>> {
        self.skip_blanks();
        let at = self.at;
        let first = self.byte()?;
        if is_line_end(first) || (first == b'#' && self.syntax.comments) {
            return None;
        }
        if first == b'"' && self.syntax.quotes {
            return Some(self.quoted());
        }
        let rest = &self.bytes[at..];
        let ends = |(i, &b): (usize, &u8)| {
            let kind = KINDS[usize::from(b)] & self.ends;
            kind != 0 && (kind != JOIN || rest.get(i + 1).is_some_and(|&b| is_line_end(b)))
        };
        let length = rest.iter().enumerate().position(ends).unwrap_or(rest.len());
        self.at += length;
        Some(Word { text: &rest[..length], at })
    }

    /// A word from `"` to the next `"` of the line that no `\` escapes; without one, the rest of the line.
    fn quoted(&mut self) -> Word<'a> {
        let at = self.at;
        self.at += 1;
        while let Some(b) = self.byte().filter(|&b| !is_line_end(b)) {
            self.at += 1;
            match b {
                b'"' => break,
                b'\\' if self.byte().is_some_and(|b| !is_line_end(b)) => self.at += 1,
                _ => {}
            }
        }
        Word { text: &self.bytes[at..self.at], at }
    }

    /// Leaves this line and the lines joined to it; false at the end of the file. A `\` at the end of a
    /// comment joins nothing: it ends a path more often than not.
    #[inline]
    pub(super) fn next_line(&mut self) -> bool {
        loop {
            let rest = &self.bytes[self.at..];
            let skipped = &rest[..rest.iter().position(|&b| is_line_end(b)).unwrap_or(rest.len())];
            self.at += skipped.len();
            let joined = self.syntax.continuation && skipped.ends_with(b"\\") && !skipped.contains(&b'#');
            if !self.line_end() {
                return false;
            }
            if !joined {
                return true;
            }
        }
    }

    /// The rest of the line as it stands, comments included, without blanks at its ends.
    pub(super) fn rest_of_line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|&b| is_line_end(b)).unwrap_or(rest.len());
        self.at += length;
        rest[..length].trim_ascii()
    }

    /// The next word, in this line or a later one.
    #[inline]
    pub(super) fn word_anywhere(&mut self) -> Option<Word<'a>> {
        loop {
            if let Some(word) = self.word() {
                return Some(word);
            }
            if !self.next_line() {
                return None;
            }
        }
    }

    /// The next word of this line, or an error that names what is missing.
    #[inline]
    pub(super) fn need(&mut self, wanted: impl FnOnce() -> String) -> Result<Word<'a>, ReadError> {
        let word = self.word();
        word.ok_or_else(|| self.missing(wanted()))
    }

    /// The next word in this line or a later one, or an error that names what is missing.
    #[inline]
    pub(super) fn need_anywhere(&mut self, wanted: impl FnOnce() -> String) -> Result<Word<'a>, ReadError> {
        let word = self.word_anywhere();
        word.ok_or_else(|| self.missing(wanted()))
    }

    /// The error that `wanted` is missing here.
    #[cold]
    pub(super) fn missing(&self, wanted: String) -> ReadError {
        let found = if self.at >= self.bytes.len() { "the end of the file" } else { "the end of the line" };
        self.error(self.at, ReadProblem::Expected { wanted: wanted.into(), found: found.to_owned() }, "")
    }

    /// Refuses a word that comes after the `count` of `what` that the file announces.
    pub(super) fn no_more(&mut self, what: &'static str, count: u64, help: &'static str) -> Result<(), ReadError> {
        let Some(word) = self.word_anywhere() else { return Ok(()) };
        Err(self.error(word.at, ReadProblem::MoreThanCounted { what, count }, help))
    }

    /// Accepts the end of the line (or a comment) and nothing else.
    pub(super) fn end_of_line(&mut self, help: &'static str) -> Result<(), ReadError> {
        match self.word() {
            None => Ok(()),
            Some(word) => Err(self.expected(word, "the end of the line", help)),
        }
    }

    /// An error at a byte of the file.
    #[cold]
    pub(super) fn error(&self, at: usize, what: ReadProblem, help: impl Into<Cow<'static, str>>) -> ReadError {
        ReadError::at(self.source, self.place(at), what, help)
    }

    /// The error that `word` stands where `wanted` should.
    #[cold]
    pub(super) fn expected(
        &self,
        word: Word<'_>,
        wanted: impl Into<Cow<'static, str>>,
        help: impl Into<Cow<'static, str>>,
    ) -> ReadError {
        let found = format!("`{}`", word.show());
        self.wrong(word, ReadProblem::Expected { wanted: wanted.into(), found }, help)
    }

    #[cold]
    fn not_a_number(&self, word: Word<'_>, wanted: &'static str, help: &'static str) -> ReadError {
        self.wrong(word, ReadProblem::NotANumber { word: word.show(), wanted }, help)
    }

    /// What is wrong with a word, or that it is no text at all.
    #[cold]
    pub(super) fn wrong(&self, word: Word<'_>, what: ReadProblem, help: impl Into<Cow<'static, str>>) -> ReadError {
        self.text(word).map_or_else(|error| error, |_| self.error(word.at, what, help))
    }

    /// The word as text.
    pub(super) fn text<'w>(&self, word: Word<'w>) -> Result<&'w str, ReadError> {
        let not_text = |_| self.error(word.at, ReadProblem::NotText, "save the file as UTF-8 text");
        std::str::from_utf8(word.text).map_err(not_text)
    }

    /// The next word, wherever it stands, as a count.
    pub(super) fn need_count(&mut self, wanted: &'static str) -> Result<u64, ReadError> {
        let word = self.need_anywhere(|| wanted.to_owned())?;
        self.count(word)
    }

    /// The next word of the line as a coordinate: the one along this axis of something.
    #[inline]
    pub(super) fn need_coordinate(&mut self, axis: char, of: impl FnOnce() -> String) -> Result<f64, ReadError> {
        let word = self.need(|| format!("the {axis} of {}", of()))?;
        self.coordinate(axis, word)
    }

    /// The word as a number.
    #[inline]
    pub(super) fn number(&self, word: Word<'_>) -> Result<f64, ReadError> {
        let number = std::str::from_utf8(word.text).ok().and_then(|text| text.parse().ok());
        number.ok_or_else(|| self.not_a_number(word, "a number", "write a number such as 1.5, with a decimal point"))
    }

    /// The word as a coordinate that the exact predicates can take.
    #[inline]
    pub(super) fn coordinate(&self, axis: char, word: Word<'_>) -> Result<f64, ReadError> {
        let value = self.number(word)?;
        check_coordinate(axis, value).map_err(|error| self.error(word.at, error.into(), ""))?;
        Ok(value)
    }

    /// The word as a whole number.
    #[inline]
    pub(super) fn integer(&self, word: Word<'_>) -> Result<i64, ReadError> {
        parse_integer(word.text)
            .ok_or_else(|| self.not_a_number(word, "a whole number", "write a whole number such as 12"))
    }

    /// The word as a number of things.
    pub(super) fn count(&self, word: Word<'_>) -> Result<u64, ReadError> {
        let count = self.integer(word)?;
        u64::try_from(count)
            .map_err(|_| self.not_a_number(word, "a count", "a count is a whole number and not negative"))
    }

    /// The word as a reference to one of `count` things numbered from `first`; returns the number from 0.
    #[inline]
    pub(super) fn index(&self, word: Word<'_>, what: &'static str, count: u64, first: i64) -> Result<u32, ReadError> {
        let index = self.integer(word)?;
        match index.checked_sub(first).and_then(|i| u32::try_from(i).ok()).filter(|&i| u64::from(i) < count) {
            Some(i) => Ok(i),
            None => Err(self.out_of_range(word, what, index, count, first)),
        }
    }

    /// The error that a reference leads nowhere.
    #[cold]
    pub(super) fn out_of_range(
        &self,
        word: Word<'_>,
        what: &'static str,
        index: i64,
        count: u64,
        first: i64,
    ) -> ReadError {
        let (problem, help) = no_such(what, index, count, first);
        self.error(word.at, problem, help)
    }
}

/// That a reference to one of `count` things numbered from `first` leads nowhere, and which ones do not.
pub(super) fn no_such(what: &'static str, index: i64, count: u64, first: i64) -> (ReadProblem, String) {
    let help = match count {
        0 => String::new(),
        _ => format!("they are numbered {first} to {}", count as i64 - 1 + first),
    };
    (ReadProblem::IndexOutOfRange { what, index, count }, help)
}

/// A whole number in decimal digits, with or without a sign.
#[inline]
pub(super) fn parse_integer(text: &[u8]) -> Option<i64> {
    let (negative, digits) = match text {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value = 0i64;
    for &b in digits {
        if !b.is_ascii_digit() {
            return None;
        }
        value = value * 10 + i64::from(b - b'0');
    }
    Some(if negative { -value } else { value })
}

/// Refuses what no reader can take: no bytes, too many bytes, more than there is memory for, UTF-16.
pub(super) fn check_text(bytes: &[u8], source: &str) -> Result<(), ReadError> {
    check_start(bytes, bytes.len(), source)?;
    for_text(bytes, source)
}

/// The same of a text of `length` bytes of which only the start is there; memory is not looked at.
pub(super) fn check_start(bytes: &[u8], length: usize, source: &str) -> Result<(), ReadError> {
    let fail = |what, help| Err(ReadError::whole(source, what, help));
    if bytes.is_empty() {
        return fail(ReadProblem::Empty, "");
    }
    if length as u64 >= LARGEST_FILE {
        return fail(ReadProblem::TooLarge { what: "bytes", limit: LARGEST_FILE }, "");
    }
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return fail(ReadProblem::Refused { what: "text in UTF-16".into() }, "save the file as UTF-8 text");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &[u8], syntax: Syntax) -> Vec<(String, u32)> {
        let mut scanner = Scanner::new(text, "test", syntax).unwrap();
        let mut found = Vec::new();
        while let Some(word) = scanner.word_anywhere() {
            found.push((word.show(), line_and_column(text, word.at).0));
            assert_eq!(found[found.len() - 1].1, scanner.line(), "line of {}", word.show());
        }
        found
    }

    #[test]
    fn words_are_found_across_line_ends_comments_and_joined_lines() {
        let all = Syntax { comments: true, continuation: true, ..Syntax::default() };
        let text = b"\xef\xbb\xbfa b#c d\r\n\r\n\te \\\r\nf\rg\\\nh\n# \\\ni";
        let expected = [("a", 1), ("b", 1), ("e", 3), ("f", 4), ("g", 5), ("h", 6), ("i", 8)];
        assert_eq!(words(text, all), expected.map(|(word, line)| (word.to_owned(), line)));
        let plain = words(b"a \\\nb#\n", Syntax::default());
        assert_eq!(plain.iter().map(|(word, _)| word.as_str()).collect::<Vec<_>>(), ["a", "\\\\", "b#"]);
    }

    #[test]
    fn quoted_words_hold_blanks_and_comment_signs() {
        let quotes = Syntax { comments: true, quotes: true, ..Syntax::default() };
        let found = words(br#"name "a # \" b" x "open"#, quotes);
        let texts: Vec<&str> = found.iter().map(|(text, _)| text.as_str()).collect();
        assert_eq!(texts, ["name", r#"\"a # \\\" b\""#, "x", r#"\"open"#]);
    }

    #[test]
    fn columns_count_characters() {
        let text = "ä ö 7".as_bytes();
        assert_eq!(line_and_column(text, 6), (1, 5));
        assert_eq!(line_and_column(b"\xef\xbb\xbfab", 4), (1, 2));
        assert_eq!(line_and_column(b"a\r\nb\rc\n", 7), (4, 1));
    }

    #[test]
    fn whole_numbers_overflow_to_nothing() {
        assert_eq!(parse_integer(b"-12"), Some(-12));
        for bad in [&b""[..], b"-", b"1.0", b"9999999999999999999", b"1e3", b"--1"] {
            assert_eq!(parse_integer(bad), None);
        }
    }
}
