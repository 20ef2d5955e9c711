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

use super::blocks::Blocks;
use super::closest;
use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::room::too_little;
use super::text::{Scanner, Syntax, Word};
use crate::ids::{FaceId, HalfEdgeId, Id, ParseIdError, VertexId};
use crate::old_words::{Language, OldWord};
use crate::topology::{FaceRow, HalfEdgeRow, InnerComponent, TableColumns, VertexRow, View};
use std::str::FromStr;

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: true, separators: false };
/// Ids may exceed the number of lines by this much.
const SPARE: usize = 1_000_000;

const HALF_EDGE_WORDS: [&str; 5] = ["origin", "twin", "next", "prev", "face"];
const FACE_WORDS: [&str; 5] = ["half_edge", "inner", "outer", "hole", "name"];

/// The table while it is read, with the line of each record.
struct Reader<'a> {
    table: TableColumns,
    lines: [Vec<u32>; 3],
    outer_line: u32,
    limit: Limit,
    old_words: Vec<&'static OldWord>,
    source: &'a str,
}

/// How large ids may be.
struct Limit {
    greatest: usize,
    /// Whether all lines were counted for it; else only those up to the end of the block.
    is_final: bool,
}

/// Why reading stops before the end of a block.
enum Stop {
    /// Something is wrong.
    Error(ReadError),
    /// Whether an id is too large is known when all lines are counted: here the record starts.
    Count { at: usize, line: u32 },
}

impl From<ReadError> for Stop {
    fn from(error: ReadError) -> Self {
        Self::Error(error)
    }
}

/// Reads the kit's text, into columns or into a table. O(length).
pub(super) fn read(blocks: &mut Blocks<'_>, columns: bool) -> Result<Read, ReadError> {
    let mut reader = Reader {
        table: TableColumns::default(),
        lines: Default::default(),
        outer_line: 0,
        limit: Limit { greatest: 0, is_final: false },
        old_words: Vec::new(),
        source: blocks.source(),
    };
    let mut has_header = false;
    while let Some(block) = blocks.next()? {
        let is_last = block.is_last;
        let mut scanner = Scanner::of_block(block, SYNTAX);
        if !has_header {
            has_header = header(&mut scanner, is_last)?;
        }
        let (mut at, mut line) = (scanner.at(), scanner.line());
        if !reader.limit.is_final {
            reader.limit = Limit { greatest: blocks.line_ends_so_far() + SPARE, is_final: is_last };
        }
        loop {
            let mut scanner = Scanner::of_block(blocks.same(), SYNTAX);
            scanner.go_to(at, line);
            match reader.records(&mut scanner) {
                Ok(()) => break,
                Err(Stop::Error(error)) => return Err(error),
                Err(Stop::Count { at: here, line: there }) => (at, line) = (here, there),
            }
            reader.limit = Limit { greatest: blocks.line_ends()? + SPARE, is_final: true };
        }
    }
    let notes = reader.old_words.iter().map(ToString::to_string).collect();
    drop(reader.lines);
    let document = if columns {
        Document::Columns(reader.table)
    } else {
        let bytes = reader.table.half_edge_bound() * size_of::<Option<HalfEdgeRow>>();
        Document::Table(reader.table.try_into_table().map_err(|_| too_little(bytes, blocks.source()))?)
    };
    Ok(Read { document, notes, format: Format::Dcel })
}

/// Reads the first line. Returns whether it was in this block.
fn header(scanner: &mut Scanner<'_>, is_last: bool) -> Result<bool, ReadError> {
    let Some(word) = scanner.word_anywhere() else {
        return if is_last { Err(scanner.missing("the line `dcel 1`".to_owned())) } else { Ok(false) };
    };
    if word.text != b"dcel" {
        return Err(scanner.expected(word, "the line `dcel 1`", "the first line names the format and its version"));
    }
    let word = scanner.need(|| "the version, 1".to_owned())?;
    if word.text != b"1" {
        return Err(scanner.expected(word, "version 1", "this kit reads version 1"));
    }
    scanner.end_of_line("the records start on the next line")?;
    Ok(true)
}

impl Reader<'_> {
    /// Reads the records of a block.
    fn records(&mut self, scanner: &mut Scanner<'_>) -> Result<(), Stop> {
        while let Some(word) = scanner.word_anywhere() {
            match word.text.first() {
                Some(b'v') => self.vertex(scanner, word)?,
                Some(b'h') => self.half_edge(scanner, word)?,
                Some(b'f') => self.face(scanner, word)?,
                _ => {
                    let help = "a line starts with the name of an element: v3, h7 or f0";
                    return Err(unknown(scanner, word, help.to_owned()).into());
                }
            }
            scanner.end_of_line("one record a line")?;
        }
        Ok(())
    }

    fn vertex(&mut self, scanner: &mut Scanner<'_>, word: Word<'_>) -> Result<(), Stop> {
        let id: VertexId = id(scanner, word)?;
        self.check_new(scanner, word, id.index(), 0)?;
        let mut row = VertexRow::default();
        let mut next = scanner.word();
        let looks_like_number = |word: &Word<'_>| {
            let is_letter = word.text.first().is_some_and(u8::is_ascii_alphabetic);
            !is_letter || std::str::from_utf8(word.text).is_ok_and(|text| text.parse::<f64>().is_ok())
        };
        if let Some(x) = next.filter(looks_like_number) {
            let x = scanner.coordinate('x', x)?;
            row.position = Some([x, scanner.need_coordinate('y', || id.to_string())?]);
            next = scanner.word();
        }
        if let Some(word) = next {
            if word.text != b"out" {
                return Err(unknown_word(scanner, word, &["out"]).into());
            }
            row.outgoing = pointer(scanner)?;
        }
        let set = self.table.set_vertex(id, row);
        Ok(set.map_err(|_| self.too_little())?)
    }

    fn half_edge(&mut self, scanner: &mut Scanner<'_>, word: Word<'_>) -> Result<(), Stop> {
        let id: HalfEdgeId = id(scanner, word)?;
        self.check_new(scanner, word, id.index(), 1)?;
        let mut row = HalfEdgeRow::default();
        let mut seen = 0;
        while let Some(word) = scanner.word() {
            let Some(place) = HALF_EDGE_WORDS.iter().position(|known| known.as_bytes() == word.text) else {
                return Err(unknown_word(scanner, word, &HALF_EDGE_WORDS).into());
            };
            once(scanner, word, place, &mut seen)?;
            match place {
                0 => row.origin = pointer(scanner)?,
                1 => row.twin = pointer(scanner)?,
                2 => row.next = pointer(scanner)?,
                3 => row.prev = pointer(scanner)?,
                _ => row.face = pointer(scanner)?,
            }
        }
        let set = self.table.set_half_edge(id, row);
        Ok(set.map_err(|_| self.too_little())?)
    }

    fn face(&mut self, scanner: &mut Scanner<'_>, word: Word<'_>) -> Result<(), Stop> {
        let id: FaceId = id(scanner, word)?;
        self.check_new(scanner, word, id.index(), 2)?;
        let mut row = FaceRow::default();
        let mut seen = 0;
        while let Some(word) = scanner.word() {
            let mut place = FACE_WORDS.iter().position(|known| known.as_bytes() == word.text);
            if place.is_none() {
                place = self.old_word(word).and_then(|new| FACE_WORDS.iter().position(|known| *known == new));
            }
            let Some(place) = place else { return Err(unknown_word(scanner, word, &FACE_WORDS).into()) };
            let word = Word { text: FACE_WORDS[place].as_bytes(), at: word.at };
            once(scanner, word, place, &mut seen)?;
            match word.text {
                b"half_edge" => row.half_edge = pointer(scanner)?,
                b"inner" => row.inner_components = inner_components(scanner)?,
                b"hole" => row.hole = true,
                b"name" => row.name = Some(name(scanner)?),
                _ => self.outer(scanner, id, word)?,
            }
        }
        let set = self.table.set_face(id, row);
        Ok(set.map_err(|_| self.too_little())?)
    }

    /// The error that the table cannot grow.
    #[cold]
    fn too_little(&self) -> ReadError {
        let table = &self.table;
        let rows = 20 * table.half_edge_bound() + 20 * table.vertex_bound() + 4 * table.face_bound();
        too_little(2 * rows, self.source)
    }

    /// What is written today for an old word, which is noted, once.
    fn old_word(&mut self, word: Word<'_>) -> Option<&'static str> {
        let old = OldWord::find(Language::DcelFile, std::str::from_utf8(word.text).unwrap_or_default())?;
        if !self.old_words.contains(&old) {
            self.old_words.push(old);
        }
        Some(old.new)
    }

    fn outer(&mut self, scanner: &Scanner<'_>, id: FaceId, word: Word<'_>) -> Result<(), ReadError> {
        if let Some(first) = self.table.outer_face {
            let what = format!("the outer face ({first})");
            let problem = ReadProblem::Duplicate { what, first_line: self.outer_line };
            return Err(scanner.error(word.at, problem, "a subdivision has one unbounded face"));
        }
        self.table.outer_face = Some(id);
        self.outer_line = scanner.line();
        Ok(())
    }

    /// Refuses a second record of an element and an id that would blow up the table; notes the line.
    fn check_new(&mut self, scanner: &Scanner<'_>, word: Word<'_>, index: usize, kind: usize) -> Result<(), Stop> {
        let Limit { greatest, is_final } = self.limit;
        if index > greatest && !is_final {
            return Err(Stop::Count { at: word.at, line: scanner.line() });
        }
        if index > greatest {
            let what = ["vertices", "half-edges", "faces"][kind];
            let problem = ReadProblem::SparseId { id: word.show(), what, limit: greatest as u64 };
            return Err(scanner.error(word.at, problem, "number the elements without large gaps").into());
        }
        let first_line = self.lines[kind].get(index).copied().unwrap_or(0);
        put(&mut self.lines[kind], index, scanner.line(), self.source)?;
        if first_line != 0 {
            let problem = ReadProblem::Duplicate { what: word.show(), first_line };
            return Err(scanner.error(word.at, problem, "give each element one line").into());
        }
        Ok(())
    }
}

/// The half-edges and vertices behind `inner`, or `none`.
fn inner_components(scanner: &mut Scanner<'_>) -> Result<Vec<InnerComponent>, ReadError> {
    let mut inner = Vec::new();
    let first = scanner.need(|| "half-edges or vertices after `inner`, or none".to_owned())?;
    if first.text == b"none" {
        return Ok(inner);
    }
    let mut at = Some(first);
    while let Some(word) = at {
        match word.text {
            [b'h', b'0'..=b'9', ..] => inner.push(InnerComponent::Cycle(id(scanner, word)?)),
            [b'v', b'0'..=b'9', ..] => inner.push(InnerComponent::Isolated(id(scanner, word)?)),
            _ if inner.is_empty() => return Err(scanner.expected(word, "a half-edge or a vertex", "")),
            _ => {
                scanner.go_back_to(word.at);
                break;
            }
        }
        at = scanner.word();
    }
    Ok(inner)
}

fn name(scanner: &mut Scanner<'_>) -> Result<String, ReadError> {
    let word = scanner.need(|| "a text in quotes".to_owned())?;
    let help = "write a name such as \"Ohio\"";
    match scanner.text(word)?.strip_prefix('"') {
        Some(inside) => unescape(inside).ok_or_else(|| {
            let help = "close the text with a quote; in it, write \\\" \\\\ \\n \\r \\t and no other word with \\";
            scanner.expected(word, "a text in quotes", help)
        }),
        None => Err(scanner.expected(word, "a text in quotes", help)),
    }
}

/// The id behind a word such as `next`; nothing for `none`.
#[inline]
fn pointer<I: Id + FromStr<Err = ParseIdError>>(scanner: &mut Scanner<'_>) -> Result<Option<I>, ReadError> {
    let word = scanner.need(|| "an id, or none".to_owned())?;
    if word.text == b"none" { Ok(None) } else { id(scanner, word).map(Some) }
}

#[inline]
fn id<I: Id + FromStr<Err = ParseIdError>>(scanner: &Scanner<'_>, word: Word<'_>) -> Result<I, ReadError> {
    match short_number(word.text, I::LETTER) {
        Some(number) => Ok(I::from_index(number)),
        None => long_id(scanner, word),
    }
}

/// An id with more digits than [`short_number`] takes, or what is wrong with it.
#[cold]
fn long_id<I: Id + FromStr<Err = ParseIdError>>(scanner: &Scanner<'_>, word: Word<'_>) -> Result<I, ReadError> {
    scanner.text(word)?.parse().map_err(|error: ParseIdError| {
        let problem = ReadProblem::UnknownWord { word: word.show() };
        scanner.error(word.at, problem, error.to_string())
    })
}

/// Accepts a word that has not been seen in this line; `place` is its number among those of the record.
#[inline]
fn once(scanner: &Scanner<'_>, word: Word<'_>, place: usize, seen: &mut u32) -> Result<(), ReadError> {
    if *seen & 1 << place != 0 {
        let problem = ReadProblem::Duplicate { what: format!("`{}`", word.show()), first_line: scanner.line() };
        return Err(scanner.error(word.at, problem, "give each word once in a record"));
    }
    *seen |= 1 << place;
    Ok(())
}

#[cold]
fn unknown_word(scanner: &Scanner<'_>, word: Word<'_>, words: &[&str]) -> ReadError {
    let list = words.join(", ");
    let help = match closest(&word.show(), words.iter().copied()) {
        Some(close) if words.len() > 1 => format!("did you mean `{close}`? The words here are {list}"),
        _ => format!("the words here are {list}"),
    };
    unknown(scanner, word, help)
}

#[cold]
fn unknown(scanner: &Scanner<'_>, word: Word<'_>, help: String) -> ReadError {
    scanner.wrong(word, ReadProblem::UnknownWord { word: word.show() }, help)
}

/// The number of at most nine digits behind the letter.
#[inline]
fn short_number(text: &[u8], letter: char) -> Option<usize> {
    let [first, digits @ ..] = text else { return None };
    if char::from(*first) != letter || !(1..10).contains(&digits.len()) || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    Some(digits.iter().fold(0, |number, digit| 10 * number + usize::from(digit - b'0')))
}

/// Sets an item of a list, which becomes as long as that.
#[inline]
fn put<T: Clone + Default>(list: &mut Vec<T>, index: usize, item: T, source: &str) -> Result<(), ReadError> {
    if list.len() <= index {
        let more = index + 1 - list.len();
        list.try_reserve(more).map_err(|_| too_little(2 * (index + 1) * size_of::<T>(), source))?;
        list.resize(index + 1, T::default());
    }
    list[index] = item;
    Ok(())
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
    let text = name.replace('\\', "\\\\").replace('"', "\\\"");
    let text = text.replace('\n', "\\n").replace('\r', "\\r").replace('\t', "\\t");
    format!("\"{text}\"")
}
