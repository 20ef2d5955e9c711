//! The kit's own text: one line a record, every pointer by its name.
//!
//! ```text
//!              v2 ●                vertex:     v2 2 3 out h4
//!                ╱ ╲                           its x and y, then `out` and a half-edge that starts here
//!            h4 ╱f1 ╲ h2           half-edge:  h0 origin v0 twin h1 next h2 prev h4 face f1
//!              ╱  ·v3╲   f0        face:       f1 half_edge h0 inner v3 name "Ohio"
//!          v0 ●───────● v1                     `half_edge` and a half-edge, `inner` and half-edges or
//!                 h0                           isolated vertices, and the words `outer`, `hole`, `name`
//! ```
//!
//! The whole of it, as a student may type it:
//!
//! ```
//! # use dcel_kit::io::{Document, Format, Model, ReadOptions, read_bytes, write};
//! let text = r#"dcel 1
//! v0 0 0 out h0
//! v1 4 0 out h2
//! v2 2 3 out h4
//! v3 2 1 out none
//! h0 origin v0 twin h1 next h2 prev h4 face f1
//! h1 origin v1 twin h0 next h5 prev h3 face f0
//! h2 origin v1 twin h3 next h4 prev h0 face f1
//! h3 origin v2 twin h2 next h1 prev h5 face f0
//! h4 origin v2 twin h5 next h0 prev h2 face f1
//! h5 origin v0 twin h4 next h3 prev h1 face f0
//! f0 outer half_edge h1 inner none
//! f1 half_edge h0 inner v3 name "Ohio"
//! "#;
//! let read = read_bytes(text.as_bytes(), Format::Dcel, "ohio.dcel", &ReadOptions::default())?;
//! let Document::Table(table) = read.document else { unreachable!() };
//! let mut again = Vec::new();
//! write(&mut again, &Model::table(&table), Format::Dcel)?;
//! assert_eq!(String::from_utf8(again)?, text);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The rules:
//! - The first line is `dcel 1`, the name and the version of the format. `#` starts a comment anywhere.
//! - One record a line, in any order; the first word is the name of the element. Ids that have no record do not
//!   exist. An id must not be larger than the number of lines plus a million.
//! - After a vertex come x and y, or nothing if it has no position. The other words come in any order, each at
//!   most once. A word that is left out counts as `none`, which is a pointer to nothing.
//! - `outer` marks the unbounded face, of which there is at most one; `hole` marks a bounded face outside the
//!   domain. `name` is followed by a text in quotes; `\"`, `\\`, `\n`, `\r` and `\t` stand in it for a quote, a
//!   backslash, line ends and a tab.
//! - Pointers may be wrong in every way: the text holds broken structures, and the validator names the breaks.
//!
//! The writer writes vertices, half-edges and faces in the order of their ids, all words, coordinates with as
//! many digits as bring back the same number. Reading gives the same table; writing that table gives the same
//! bytes. Ids after the last existing one are forgotten.

use super::closest;
use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::text::{Scanner, Syntax, Word};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::old_words::{Language, OldWord};
use crate::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow};
use std::str::FromStr;

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: true };
/// Ids may exceed the number of lines by this much.
const SPARE: usize = 1_000_000;

const HALF_EDGE_WORDS: [&str; 5] = ["origin", "twin", "next", "prev", "face"];
const FACE_WORDS: [&str; 5] = ["half_edge", "inner", "outer", "hole", "name"];

/// The tables while they are read, with the line of each record.
struct Reader<'a> {
    scanner: Scanner<'a>,
    table: Table,
    lines: [Vec<u32>; 3],
    outer_line: u32,
    limit: usize,
    old_words: Vec<&'static OldWord>,
}

/// Reads the kit's text. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    header(&mut scanner)?;
    let lines = bytes.iter().filter(|&&b| b == b'\n' || b == b'\r').count();
    let mut reader = Reader {
        scanner,
        table: Table::default(),
        lines: Default::default(),
        outer_line: 0,
        limit: lines + SPARE,
        old_words: Vec::new(),
    };
    while let Some(word) = reader.scanner.word_anywhere() {
        match word.text.first() {
            Some(b'v') => reader.vertex(word)?,
            Some(b'h') => reader.half_edge(word)?,
            Some(b'f') => reader.face(word)?,
            _ => {
                let help = "a line starts with the name of an element: v3, h7 or f0";
                return Err(reader.unknown(word, help.to_owned()));
            }
        }
        reader.scanner.end_of_line("one record a line")?;
    }
    let notes = reader.old_words.iter().map(ToString::to_string).collect();
    Ok(Read { document: Document::Table(reader.table), notes, format: Format::Dcel })
}

fn header(scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
    let word = scanner.need_anywhere(|| "the line `dcel 1`".to_owned())?;
    if word.text != b"dcel" {
        return Err(scanner.expected(word, "the line `dcel 1`", "the first line names the format and its version"));
    }
    let word = scanner.need(|| "the version, 1".to_owned())?;
    if word.text != b"1" {
        return Err(scanner.expected(word, "version 1", "this kit reads version 1"));
    }
    scanner.end_of_line("the records start on the next line")
}

impl<'a> Reader<'a> {
    fn vertex(&mut self, word: Word<'a>) -> Result<(), ReadError> {
        let id: VertexId = self.id(word)?;
        self.check_new(word, id.index(), 0)?;
        let mut row = VertexRow::default();
        let mut next = self.scanner.word();
        let looks_like_number = |word: &Word<'_>| {
            let text = std::str::from_utf8(word.text).unwrap_or("");
            !text.starts_with(|c: char| c.is_ascii_alphabetic()) || text.parse::<f64>().is_ok()
        };
        if let Some(x) = next.filter(looks_like_number) {
            let x = self.scanner.coordinate('x', x)?;
            let y = self.scanner.need(|| format!("the y of {id}"))?;
            row.position = Some([x, self.scanner.coordinate('y', y)?]);
            next = self.scanner.word();
        }
        if let Some(word) = next {
            if word.text != b"out" {
                return Err(self.unknown_word(word, &["out"]));
            }
            row.outgoing = self.pointer()?;
        }
        put(&mut self.table.vertices, id.index(), row);
        Ok(())
    }

    fn half_edge(&mut self, word: Word<'a>) -> Result<(), ReadError> {
        let id: HalfEdgeId = self.id(word)?;
        self.check_new(word, id.index(), 1)?;
        let mut row = HalfEdgeRow::default();
        let mut seen = 0;
        while let Some(word) = self.scanner.word() {
            self.once(word, &HALF_EDGE_WORDS, &mut seen)?;
            match word.text {
                b"origin" => row.origin = self.pointer()?,
                b"twin" => row.twin = self.pointer()?,
                b"next" => row.next = self.pointer()?,
                b"prev" => row.prev = self.pointer()?,
                _ => row.face = self.pointer()?,
            }
        }
        put(&mut self.table.half_edges, id.index(), row);
        Ok(())
    }

    fn face(&mut self, word: Word<'a>) -> Result<(), ReadError> {
        let id: FaceId = self.id(word)?;
        self.check_new(word, id.index(), 2)?;
        let mut row = FaceRow::default();
        let mut seen = 0;
        while let Some(word) = self.scanner.word() {
            let word = self.current(word);
            self.once(word, &FACE_WORDS, &mut seen)?;
            match word.text {
                b"half_edge" => row.half_edge = self.pointer()?,
                b"inner" => row.inner_components = self.inner_components()?,
                b"hole" => row.hole = true,
                b"name" => row.name = Some(self.name()?),
                _ => self.outer(id, word)?,
            }
        }
        put(&mut self.table.faces, id.index(), row);
        Ok(())
    }

    /// The word as it is written today; an old word is noted, once.
    fn current(&mut self, word: Word<'a>) -> Word<'a> {
        let text = std::str::from_utf8(word.text).unwrap_or_default();
        let Some(old) = OldWord::find(Language::DcelFile, text) else { return word };
        if !self.old_words.contains(&old) {
            self.old_words.push(old);
        }
        Word { text: old.new.as_bytes(), ..word }
    }

    fn outer(&mut self, id: FaceId, word: Word<'_>) -> Result<(), ReadError> {
        if let Some(first) = self.table.outer_face {
            let what = format!("the outer face ({first})");
            let problem = ReadProblem::Duplicate { what, first_line: self.outer_line };
            return Err(self.scanner.error(word.at, problem, "a subdivision has one unbounded face"));
        }
        self.table.outer_face = Some(id);
        self.outer_line = self.scanner.line();
        Ok(())
    }

    /// The half-edges and vertices behind `inner`, or `none`.
    fn inner_components(&mut self) -> Result<Vec<InnerComponent>, ReadError> {
        let mut inner = Vec::new();
        let first = self.scanner.need(|| "half-edges or vertices after `inner`, or none".to_owned())?;
        if first.text == b"none" {
            return Ok(inner);
        }
        let mut at = Some(first);
        while let Some(word) = at {
            match word.text {
                [b'h', b'0'..=b'9', ..] => inner.push(InnerComponent::Cycle(self.id(word)?)),
                [b'v', b'0'..=b'9', ..] => inner.push(InnerComponent::Isolated(self.id(word)?)),
                _ if inner.is_empty() => return Err(self.scanner.expected(word, "a half-edge or a vertex", "")),
                _ => {
                    self.scanner.go_back_to(word.at);
                    break;
                }
            }
            at = self.scanner.word();
        }
        Ok(inner)
    }

    fn name(&mut self) -> Result<String, ReadError> {
        let word = self.scanner.need(|| "a text in quotes".to_owned())?;
        let help = "write a name such as \"Ohio\"";
        let text = std::str::from_utf8(word.text)
            .map_err(|_| self.scanner.error(word.at, ReadProblem::NotText, "save the file as UTF-8 text"))?;
        match text.strip_prefix('"') {
            Some(inside) => unescape(inside).ok_or_else(|| {
                let help = "close the text with a quote; in it, write \\\" \\\\ \\n \\r \\t and no other word with \\";
                self.scanner.expected(word, "a text in quotes", help)
            }),
            None => Err(self.scanner.expected(word, "a text in quotes", help)),
        }
    }

    /// The id behind a word such as `next`; nothing for `none`.
    fn pointer<I: FromStr<Err = crate::ids::ParseIdError>>(&mut self) -> Result<Option<I>, ReadError> {
        let word = self.scanner.need(|| "an id, or none".to_owned())?;
        if word.text == b"none" { Ok(None) } else { self.id(word).map(Some) }
    }

    fn id<I: FromStr<Err = crate::ids::ParseIdError>>(&self, word: Word<'_>) -> Result<I, ReadError> {
        let text = std::str::from_utf8(word.text)
            .map_err(|_| self.scanner.error(word.at, ReadProblem::NotText, "save the file as UTF-8 text"))?;
        text.parse().map_err(|error: crate::ids::ParseIdError| {
            let problem = ReadProblem::UnknownWord { word: word.show() };
            self.scanner.error(word.at, problem, error.to_string())
        })
    }

    /// Refuses a second record of an element and an id that would blow up the table; notes the line.
    fn check_new(&mut self, word: Word<'_>, index: usize, kind: usize) -> Result<(), ReadError> {
        if index > self.limit {
            let what = ["vertices", "half-edges", "faces"][kind];
            let problem = ReadProblem::SparseId { id: word.show(), what, limit: self.limit as u64 };
            return Err(self.scanner.error(word.at, problem, "number the elements without large gaps"));
        }
        let lines = &mut self.lines[kind];
        if lines.len() <= index {
            lines.resize(index + 1, 0);
        }
        let first_line = std::mem::replace(&mut lines[index], self.scanner.line());
        if first_line != 0 {
            let problem = ReadProblem::Duplicate { what: word.show(), first_line };
            return Err(self.scanner.error(word.at, problem, "give each element one line"));
        }
        Ok(())
    }

    /// Accepts one of `words` that has not been seen in this line.
    fn once(&self, word: Word<'_>, words: &[&str], seen: &mut u32) -> Result<(), ReadError> {
        let Some(bit) = words.iter().position(|known| known.as_bytes() == word.text) else {
            return Err(self.unknown_word(word, words));
        };
        if *seen & 1 << bit != 0 {
            let problem =
                ReadProblem::Duplicate { what: format!("`{}`", word.show()), first_line: self.scanner.line() };
            return Err(self.scanner.error(word.at, problem, "give each word once in a record"));
        }
        *seen |= 1 << bit;
        Ok(())
    }

    fn unknown_word(&self, word: Word<'_>, words: &[&str]) -> ReadError {
        let list = words.join(", ");
        let help = match closest(&word.show(), words.iter().copied()) {
            Some(close) if words.len() > 1 => format!("did you mean `{close}`? The words here are {list}"),
            _ => format!("the words here are {list}"),
        };
        self.unknown(word, help)
    }

    fn unknown(&self, word: Word<'_>, help: String) -> ReadError {
        if std::str::from_utf8(word.text).is_err() {
            return self.scanner.error(word.at, ReadProblem::NotText, "save the file as UTF-8 text");
        }
        self.scanner.error(word.at, ReadProblem::UnknownWord { word: word.show() }, help)
    }
}

fn put<T: Clone>(rows: &mut Vec<Option<T>>, index: usize, row: T) {
    if rows.len() <= index {
        rows.resize(index + 1, None);
    }
    rows[index] = Some(row);
}

/// The text up to its closing quote; nothing if the quote is missing, something follows it, or an escape is
/// unknown.
fn unescape(inside: &str) -> Option<String> {
    let mut text = String::with_capacity(inside.len());
    let mut characters = inside.chars();
    loop {
        match characters.next()? {
            '"' => return characters.next().is_none().then_some(text),
            '\\' => text.push(match characters.next()? {
                'n' => '\n',
                'r' => '\r',
                't' => '\t',
                c @ ('"' | '\\') => c,
                _ => return None,
            }),
            c => text.push(c),
        }
    }
}

/// A name in quotes, as [`read`] takes it.
pub(super) fn quote(name: &str) -> String {
    let mut text = String::with_capacity(name.len() + 2);
    text.push('"');
    for c in name.chars() {
        match c {
            '"' => text.push_str("\\\""),
            '\\' => text.push_str("\\\\"),
            '\n' => text.push_str("\\n"),
            '\r' => text.push_str("\\r"),
            '\t' => text.push_str("\\t"),
            c => text.push(c),
        }
    }
    text.push('"');
    text
}
