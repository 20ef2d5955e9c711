//! A structure that a program prints: half-edges, or records that a lab declares.
//!
//! ```text
//!   HALF-EDGES                           RECORDS                    of a lab that says
//!   outer 0                              first 0                    one reference of its own, `first`
//!   vertex 0 -250 -150 0                 node 0 0 0 1 3             a table of nodes: x y next prev
//!   half_edge 0 0 1 2 10 1               node 1 4 0 2 0
//!   face 0 1                             …
//! ```

use dcel_kit::topology::Table;
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::fmt::Write;
use std::sync::Arc;

/// What the records of a lab look like.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Schema {
    /// Vertices, half-edges and faces: a [`Table`].
    #[default]
    HalfEdges,
    /// Records of other kinds.
    Records(&'static RecordSchema),
}

/// The kinds of records of a lab, in the order of a dump.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordSchema {
    /// The references that the structure itself has, by name; they stand first.
    pub singles: &'static [&'static str],
    /// The tables.
    pub tables: &'static [TableSchema],
}

/// A kind of record.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TableSchema {
    /// The first word of its lines.
    pub word: &'static str,
    /// What its numbers begin with, in messages.
    pub letter: char,
    /// Its fields.
    pub columns: &'static [ColumnSchema],
}

/// A field of a record.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ColumnSchema {
    /// A number, such as a coordinate, by its name.
    Number(&'static str),
    /// A reference by its name, and the letter of what it leads to.
    Link(&'static str, char),
}

impl ColumnSchema {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Number(name) | Self::Link(name, _) => name,
        }
    }
}

/// What stands in a field.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// A reference, or none.
    Link(Option<u32>),
}

impl Cell {
    /// The number that a reference leads to.
    #[must_use]
    pub fn to(self) -> Option<u32> {
        if let Self::Link(to) = self { to } else { None }
    }

    /// The number.
    #[must_use]
    pub fn number(self) -> Option<f64> {
        if let Self::Number(x) = self { Some(x) } else { None }
    }
}

/// Records of the kinds that a lab declares.
#[derive(Clone, PartialEq, Debug)]
pub struct Records {
    schema: &'static RecordSchema,
    /// The references of the structure itself.
    pub singles: Vec<Option<u32>>,
    /// The fields of the records of each table, one after the other.
    tables: Vec<Vec<Cell>>,
}

impl Records {
    /// No records.
    #[must_use]
    pub fn new(schema: &'static RecordSchema) -> Self {
        Self { schema, singles: vec![None; schema.singles.len()], tables: vec![Vec::new(); schema.tables.len()] }
    }

    /// What they look like.
    #[must_use]
    pub fn schema(&self) -> &'static RecordSchema {
        self.schema
    }

    /// How many records a table has.
    #[must_use]
    pub fn len(&self, table: usize) -> usize {
        self.tables[table].len() / self.width(table)
    }

    /// How many records there are of all kinds.
    #[must_use]
    pub fn count(&self) -> usize {
        (0..self.tables.len()).map(|table| self.len(table)).sum()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.tables.iter().all(Vec::is_empty)
    }

    /// The fields of a record; `None` if there is no such record.
    #[must_use]
    pub fn row(&self, table: usize, number: usize) -> Option<&[Cell]> {
        let width = self.width(table);
        self.tables[table].get(number.checked_mul(width)?..)?.get(..width)
    }

    /// The records of a table, in the order of their numbers.
    pub fn rows(&self, table: usize) -> impl ExactSizeIterator<Item = &[Cell]> + DoubleEndedIterator {
        self.tables[table].chunks_exact(self.width(table))
    }

    /// Adds a record.
    ///
    /// # Panics
    /// If it has not the fields of its table.
    pub fn push(&mut self, table: usize, row: &[Cell]) {
        assert_eq!(row.len(), self.width(table), "a record of {}", self.schema.tables[table].word);
        self.tables[table].extend_from_slice(row);
    }

    /// The fields of a record, to be changed.
    pub fn row_mut(&mut self, table: usize, number: usize) -> Option<&mut [Cell]> {
        let width = self.width(table);
        self.tables[table].get_mut(number.checked_mul(width)?..)?.get_mut(..width)
    }

    /// A table without columns has no records.
    fn width(&self, table: usize) -> usize {
        self.schema.tables[table].columns.len().max(1)
    }
}

/// A structure as it was printed.
#[derive(Clone, PartialEq, Debug)]
pub enum Structure {
    /// Vertices, half-edges, faces.
    HalfEdges(Arc<Table>),
    /// Records of other kinds.
    Records(Arc<Records>),
}

impl Default for Structure {
    fn default() -> Self {
        Self::HalfEdges(Arc::default())
    }
}

impl Structure {
    /// Nothing.
    #[must_use]
    pub fn empty(schema: Schema) -> Self {
        match schema {
            Schema::HalfEdges => Self::default(),
            Schema::Records(schema) => Self::Records(Arc::new(Records::new(schema))),
        }
    }

    /// The half-edges.
    #[must_use]
    pub fn half_edges(&self) -> Option<&Arc<Table>> {
        if let Self::HalfEdges(table) = self { Some(table) } else { None }
    }

    /// The records of other kinds.
    #[must_use]
    pub fn records(&self) -> Option<&Arc<Records>> {
        if let Self::Records(records) = self { Some(records) } else { None }
    }

    /// How many records there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::HalfEdges(table) => table.vertices.len() + table.half_edges.len() + table.faces.len(),
            Self::Records(records) => records.count(),
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The records, one a line.
    pub(crate) fn text(&self) -> String {
        let mut out = String::new();
        self.write(&mut out);
        out
    }

    /// The records, one a line, as a program prints and reads them. Tables with gaps have no such text: programs
    /// number their records without gaps.
    pub(super) fn write(&self, out: &mut String) {
        match self {
            Self::HalfEdges(table) => write_half_edges(table, out),
            Self::Records(records) => write_records(records, out),
        }
    }
}

/// A reference, with a blank before it.
fn reference(out: &mut String, to: Option<u32>) {
    let _ = match to {
        Some(to) => write!(out, " {to}"),
        None => write!(out, " -"),
    };
}

fn write_half_edges(table: &Table, out: &mut String) {
    let mut row = |begin: String, links: &[Option<u32>]| {
        out.push_str(&begin);
        links.iter().for_each(|&link| reference(out, link));
        out.push('\n');
    };
    row("outer".to_owned(), &[table.outer_face.map(FaceId::number)]);
    for (i, vertex) in table.vertices.iter().flatten().enumerate() {
        let [x, y] = vertex.position.unwrap_or_default();
        row(format!("vertex {i} {x} {y}"), &[vertex.outgoing.map(HalfEdgeId::number)]);
    }
    for (i, half_edge) in table.half_edges.iter().flatten().enumerate() {
        let [twin, next, prev] = [half_edge.twin, half_edge.next, half_edge.prev].map(|h| h.map(HalfEdgeId::number));
        let [origin, face] = [half_edge.origin.map(VertexId::number), half_edge.face.map(FaceId::number)];
        row(format!("half_edge {i}"), &[origin, twin, next, prev, face]);
    }
    for (i, face) in table.faces.iter().flatten().enumerate() {
        row(format!("face {i}"), &[face.half_edge.map(HalfEdgeId::number)]);
    }
}

fn write_records(records: &Records, out: &mut String) {
    for (name, to) in records.schema.singles.iter().zip(&records.singles) {
        out.push_str(name);
        reference(out, *to);
        out.push('\n');
    }
    for (table, schema) in records.schema.tables.iter().enumerate() {
        for (number, row) in records.rows(table).enumerate() {
            let _ = write!(out, "{} {number}", schema.word);
            for cell in row {
                match cell {
                    Cell::Number(x) => drop(write!(out, " {x}")),
                    Cell::Link(to) => reference(out, *to),
                }
            }
            out.push('\n');
        }
    }
}
