//! The records of a dump, read one line at a time.
//!
//! ```text
//!   outer 0
//!   vertex 0 -250 -150 0            number x y outgoing
//!   half_edge 0 0 1 2 10 1          number origin twin next prev face
//!   face 0 1                        number boundary
//! ```

use super::answer::Broken;
use super::structure::{Cell, ColumnSchema, Records, Schema, Structure};
use super::text::{cut, id};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::sync::Arc;

/// How many records of all kinds are read.
const RECORDS: usize = 50_000;

/// A structure that is being read.
pub(super) struct Dump {
    read_into: Structure,
    /// How many of the references of the structure itself were read; they stand first.
    singles: usize,
    /// Whether records may stand for others: those that have changed.
    over: bool,
    /// How many records were read.
    read: usize,
}

impl Dump {
    /// A whole structure.
    pub(super) fn new(schema: Schema) -> Self {
        Self { read_into: Structure::empty(schema), singles: 0, over: false, read: 0 }
    }

    /// Changes of a structure.
    pub(super) fn on(base: Structure) -> Self {
        Self { read_into: base, singles: 0, over: true, read: 0 }
    }

    /// The reference of the structure itself that is due, if not all were read.
    fn due(&self) -> Option<&'static str> {
        match &self.read_into {
            Structure::HalfEdges(_) => ["outer"].get(self.singles).copied(),
            Structure::Records(records) => records.schema().singles.get(self.singles).copied(),
        }
    }

    /// Reads a record.
    pub(super) fn line(&mut self, number: usize, line: &str) -> Result<(), Broken> {
        let mut words = Words { number, line, words: line.split(' ') };
        let kind = words.next().unwrap_or_default();
        self.read += 1;
        if self.read > RECORDS {
            return Err(Broken::TooMuch { line: number, what: "records", cap: RECORDS });
        }
        if let Some(due) = self.due() {
            if kind != due {
                return Err(words.expected(&format!("`{due}`")));
            }
            let to = words.pointer()?;
            match &mut self.read_into {
                Structure::HalfEdges(table) => Arc::make_mut(table).outer_face = to.map(FaceId::new),
                Structure::Records(records) => Arc::make_mut(records).singles[self.singles] = to,
            }
            self.singles += 1;
            return words.end();
        }
        match &mut self.read_into {
            Structure::HalfEdges(table) => half_edge_record(Arc::make_mut(table), self.over, kind, &mut words),
            Structure::Records(records) => record(Arc::make_mut(records), self.over, kind, &mut words),
        }?;
        words.end()
    }

    /// The structure, at the line `end_dump`.
    pub(super) fn end(self, number: usize) -> Result<Structure, Broken> {
        if let Some(due) = self.due() {
            let found = "end_dump".to_owned();
            return Err(Broken::Expected { line: number, expected: format!("`{due}`"), found });
        }
        Ok(self.read_into)
    }
}

const A_RECORD: &str = "a record of the dump or `end_dump`";

fn half_edge_record(table: &mut Table, over: bool, kind: &str, words: &mut Words) -> Result<(), Broken> {
    match kind {
        "vertex" => {
            let place = words.place("vertex", table.vertices.len(), over)?;
            let position = Some([words.coordinate()?, words.coordinate()?]);
            let outgoing = words.pointer()?.map(HalfEdgeId::new);
            put(&mut table.vertices, place, Some(VertexRow { position, outgoing }));
        }
        "half_edge" => {
            let place = words.place("half_edge", table.half_edges.len(), over)?;
            let row = HalfEdgeRow {
                origin: words.pointer()?.map(VertexId::new),
                twin: words.pointer()?.map(HalfEdgeId::new),
                next: words.pointer()?.map(HalfEdgeId::new),
                prev: words.pointer()?.map(HalfEdgeId::new),
                face: words.pointer()?.map(FaceId::new),
            };
            put(&mut table.half_edges, place, Some(row));
        }
        "face" => {
            let place = words.place("face", table.faces.len(), over)?;
            let boundary = words.pointer()?.map(HalfEdgeId::new);
            put(&mut table.faces, place, Some(FaceRow { half_edge: boundary, ..FaceRow::default() }));
        }
        _ => return Err(words.expected(A_RECORD)),
    }
    Ok(())
}

fn record(records: &mut Records, over: bool, kind: &str, words: &mut Words) -> Result<(), Broken> {
    let schema = records.schema();
    let Some(table) = schema.tables.iter().position(|table| table.word == kind) else {
        return Err(words.expected(A_RECORD));
    };
    let place = words.place(schema.tables[table].word, records.len(table), over)?;
    let mut row = Vec::with_capacity(schema.tables[table].columns.len());
    for column in schema.tables[table].columns {
        row.push(match column {
            ColumnSchema::Number(_) => Cell::Number(words.coordinate()?),
            ColumnSchema::Link(..) => Cell::Link(words.pointer()?),
        });
    }
    match records.row_mut(table, place) {
        Some(old) => old.copy_from_slice(&row),
        None => records.push(table, &row),
    }
    Ok(())
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
