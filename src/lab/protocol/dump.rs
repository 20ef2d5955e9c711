//! The records of a dump, read one line at a time.
//!
//! ```text
//!   outer 0
//!   vertex 0 -250 -150 0            number x y outgoing
//!   half_edge 0 0 1 2 10 1          number origin twin next prev face
//!   face 0 1                        number boundary
//! ```

use super::answer::Broken;
use super::cut;
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::sync::Arc;

/// How many records of all kinds are read.
const RECORDS: usize = 50_000;
/// Ids beyond are read as this one, which no structure has.
pub(super) const GREATEST: u32 = u32::MAX - 1;

/// A table that is being read.
#[derive(Default)]
pub(super) struct Dump {
    table: Table,
    begun: bool,
    /// Whether records may stand for others: those that have changed.
    over: bool,
    /// How many records were read.
    read: usize,
}

impl Dump {
    /// Changes of a structure.
    pub(super) fn on(base: Arc<Table>) -> Self {
        Self { table: Arc::unwrap_or_clone(base), over: true, ..Self::default() }
    }

    /// Reads a record.
    pub(super) fn line(&mut self, number: usize, line: &str) -> Result<(), Broken> {
        let mut words = Words { number, line, words: line.split(' ') };
        let kind = words.next().unwrap_or_default();
        if self.begun == (kind == "outer") {
            let expected = if self.begun { "a record of the dump" } else { "`outer`" };
            return Err(words.expected(expected));
        }
        self.read += 1;
        if self.read > RECORDS {
            return Err(Broken::TooMuch { line: number, what: "records", cap: RECORDS });
        }
        match kind {
            "outer" => {
                self.table.outer_face = words.pointer()?.map(FaceId::new);
                self.begun = true;
            }
            "vertex" => {
                let place = words.place("vertex", self.table.vertices.len(), self.over)?;
                let position = Some([words.coordinate()?, words.coordinate()?]);
                let outgoing = words.pointer()?.map(HalfEdgeId::new);
                put(&mut self.table.vertices, place, Some(VertexRow { position, outgoing }));
            }
            "half_edge" => {
                let place = words.place("half_edge", self.table.half_edges.len(), self.over)?;
                let row = HalfEdgeRow {
                    origin: words.pointer()?.map(VertexId::new),
                    twin: words.pointer()?.map(HalfEdgeId::new),
                    next: words.pointer()?.map(HalfEdgeId::new),
                    prev: words.pointer()?.map(HalfEdgeId::new),
                    face: words.pointer()?.map(FaceId::new),
                };
                put(&mut self.table.half_edges, place, Some(row));
            }
            "face" => {
                let place = words.place("face", self.table.faces.len(), self.over)?;
                let boundary = words.pointer()?.map(HalfEdgeId::new);
                put(&mut self.table.faces, place, Some(FaceRow { boundary, ..FaceRow::default() }));
            }
            _ => return Err(words.expected("a record of the dump or `end_dump`")),
        }
        words.end()
    }

    /// The table, at the line `end_dump`.
    pub(super) fn end(self, number: usize) -> Result<Table, Broken> {
        if self.begun {
            return Ok(self.table);
        }
        Err(Broken::Expected { line: number, expected: "`outer`".to_owned(), found: "end_dump".to_owned() })
    }
}

/// Puts a record where it belongs: over another, or at the end.
fn put<T>(records: &mut Vec<T>, place: usize, record: T) {
    match records.get_mut(place) {
        Some(old) => *old = record,
        None => records.push(record),
    }
}

/// The words of a line.
struct Words<'a> {
    number: usize,
    line: &'a str,
    words: std::str::Split<'a, char>,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a str> {
        self.words.next()
    }

    fn expected(&self, what: &str) -> Broken {
        Broken::Expected { line: self.number, expected: what.to_owned(), found: cut(self.line) }
    }

    fn word(&mut self) -> Result<&'a str, Broken> {
        self.words.next().ok_or_else(|| self.expected("one more number"))
    }

    fn not(&self, word: &str, wanted: &'static str) -> Broken {
        Broken::Number { line: self.number, word: cut(word), wanted }
    }

    /// The number of a record: the next one, or, of changes, one that is there.
    fn place(&mut self, kind: &'static str, expected: usize, over: bool) -> Result<usize, Broken> {
        let word = self.word()?;
        let found = id(word).ok_or_else(|| self.not(word, "the number of a record"))?;
        if found as usize == expected || over && (found as usize) < expected {
            return Ok(found as usize);
        }
        Err(Broken::OutOfOrder { line: self.number, kind, found, expected })
    }

    fn pointer(&mut self) -> Result<Option<u32>, Broken> {
        match self.word()? {
            "-" => Ok(None),
            word => id(word).map(Some).ok_or_else(|| self.not(word, "the number of a record or `-`")),
        }
    }

    fn coordinate(&mut self) -> Result<f64, Broken> {
        let word = self.word()?;
        word.parse().map_err(|_| self.not(word, "a coordinate"))
    }

    fn end(&mut self) -> Result<(), Broken> {
        if self.words.next().is_some() { Err(self.expected("no further word")) } else { Ok(()) }
    }
}

/// A number of an element; too great ones are those of none.
pub(super) fn id(word: &str) -> Option<u32> {
    let is_number = !word.is_empty() && word.len() <= 20 && word.bytes().all(|b| b.is_ascii_digit());
    is_number.then(|| word.parse::<u128>().map_or(GREATEST, |n| n.min(u128::from(GREATEST)) as u32))
}
