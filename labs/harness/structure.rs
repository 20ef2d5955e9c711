//! The records that a lab declares, as text, and the way back: one record a line.
//!
//! ```text
//!   outer 0                           a reference that the structure itself has
//!   vertex 0 -250 -150 0              number x y outgoing
//!   half_edge 0 0 1 2 10 1            number origin twin next prev face
//!   face 0 1                          number boundary            `-` stands for a reference that is not set
//! ```

use super::value::{coordinate, whole};
use std::fmt::Write;

/// A structure of records that refer to each other by number.
pub trait Structure: Clone + Default {
    /// The kinds of records, in the order of a dump.
    const TABLES: &'static [Table];
    /// References that the structure itself has, by name; they stand first in a dump.
    const SINGLES: &'static [&'static str];

    /// How many records a table has.
    fn len(&self, table: usize) -> usize;
    /// Of a table, the fields of a record by its number, in the order of the columns.
    fn rows(&self, table: usize) -> impl Fn(usize) -> Vec<Cell>;
    /// Adds a record with these fields.
    fn add(&mut self, table: usize, row: &[Cell]);
    /// Of a table, whether a record, by its number, is not what it is in `before`, where it exists, too.
    fn differs(&self, before: &Self, table: usize) -> impl Fn(usize) -> bool;
    /// One of the references of the structure itself.
    fn single(&self, which: usize) -> Option<usize>;
    /// Sets it.
    fn set_single(&mut self, which: usize, to: Option<usize>);
}

/// A kind of record.
pub struct Table {
    /// What its numbers begin with.
    pub letter: char,
    /// The first word of its lines.
    pub word: &'static str,
    /// In a sentence: "half-edge".
    pub name: &'static str,
    /// Several of them: "half-edges".
    pub plural: &'static str,
    /// Its fields.
    pub columns: &'static [Column],
    /// Links that are made of others.
    pub shortcuts: &'static [Shortcut],
}

/// A field of a record.
pub enum Column {
    /// A number, such as a coordinate.
    Number,
    /// A reference.
    Link(Link),
}

/// A reference to a record.
pub struct Link {
    /// Its name in the words of a case.
    pub name: &'static str,
    /// The letter of what it leads to.
    pub letter: char,
}

/// A link that is made of others: `destination` is `twin`, then `origin`.
pub struct Shortcut {
    /// Its name.
    pub name: &'static str,
    /// The links, in their order.
    pub path: &'static [&'static str],
}

/// What stands in a field.
#[derive(Clone, Copy, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// A reference, or none.
    Link(Option<usize>),
}

impl Column {
    /// The reference; `None` for a number.
    pub(super) fn link(&self) -> Option<&Link> {
        if let Self::Link(link) = self { Some(link) } else { None }
    }
}

impl Cell {
    /// The number that a reference leads to.
    pub fn to(self) -> Option<usize> {
        if let Self::Link(to) = self { to } else { None }
    }

    /// The number.
    pub fn number(self) -> f64 {
        if let Self::Number(x) = self { x } else { 0.0 }
    }
}

/// No structure: for labs whose functions need none.
impl Structure for () {
    const TABLES: &'static [Table] = &[];
    const SINGLES: &'static [&'static str] = &[];

    fn len(&self, _: usize) -> usize {
        0
    }

    fn rows(&self, _: usize) -> impl Fn(usize) -> Vec<Cell> {
        |_| Vec::new()
    }

    fn add(&mut self, _: usize, _: &[Cell]) {}

    fn differs(&self, (): &Self, _: usize) -> impl Fn(usize) -> bool {
        |_| false
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}

/// How many records of all kinds there are.
pub(super) fn records<S: Structure>(structure: &S) -> usize {
    (0..S::TABLES.len()).map(|table| structure.len(table)).sum()
}

/// The lines of a dump: of what a call returns, too, see [`Value::Structure`](super::Value::Structure).
pub fn dump<S: Structure>(structure: &S) -> String {
    let mut text = singles(structure);
    for table in 0..S::TABLES.len() {
        let row = structure.rows(table);
        (0..structure.len(table)).for_each(|number| record(&S::TABLES[table], number, row(number), &mut text));
    }
    text
}

/// The lines of the records that are not as they are in `before`, the new ones last.
pub(super) fn changes<S: Structure>(structure: &S, before: &S) -> String {
    let mut text = singles(structure);
    for table in 0..S::TABLES.len() {
        let differs = structure.differs(before, table);
        let is_other = |&number: &usize| number >= before.len(table) || differs(number);
        let changed: Vec<usize> = (0..structure.len(table)).filter(is_other).collect();
        if !changed.is_empty() {
            let row = structure.rows(table);
            changed.into_iter().for_each(|number| record(&S::TABLES[table], number, row(number), &mut text));
        }
    }
    text
}

fn singles<S: Structure>(structure: &S) -> String {
    let mut text = String::new();
    for (which, name) in S::SINGLES.iter().enumerate() {
        text.push_str(name);
        cell(&mut text, Cell::Link(structure.single(which)));
        text.push('\n');
    }
    text
}

fn record(table: &Table, number: usize, row: Vec<Cell>, text: &mut String) {
    let _ = write!(text, "{} {number}", table.word);
    row.into_iter().for_each(|content| cell(text, content));
    text.push('\n');
}

fn cell(text: &mut String, content: Cell) {
    let _ = match content {
        Cell::Number(x) => write!(text, " {x}"),
        Cell::Link(Some(to)) => write!(text, " {to}"),
        Cell::Link(None) => write!(text, " -"),
    };
}

/// Adds the record of a line of a dump. The records of a kind come in the order of their numbers.
pub(super) fn read_record<S: Structure>(structure: &mut S, kind: &str, words: &[&str]) -> Result<(), String> {
    let count = |expected: usize| {
        if words.len() == expected {
            return Ok(());
        }
        Err(format!("`{kind}` has {expected} values, not {}", words.len()))
    };
    if let Some(which) = S::SINGLES.iter().position(|name| *name == kind) {
        count(1)?;
        structure.set_single(which, reference(words[0])?);
        return Ok(());
    }
    let Some(table) = S::TABLES.iter().position(|table| table.word == kind) else {
        let mut kinds: Vec<&str> = S::SINGLES.to_vec();
        kinds.extend(S::TABLES.iter().map(|table| table.word));
        return Err(format!("a table has no line `{kind}`; it has {}, end_table", kinds.join(", ")));
    };
    let columns = S::TABLES[table].columns;
    count(columns.len() + 1)?;
    let (number, expected) = (whole(words[0])?, structure.len(table));
    if number != expected {
        return Err(format!("the next {kind} has the number {expected}, not {number}"));
    }
    let mut row = Vec::with_capacity(columns.len());
    for (column, word) in columns.iter().zip(&words[1..]) {
        row.push(match column {
            Column::Number => Cell::Number(coordinate(word)?),
            Column::Link(_) => Cell::Link(reference(word)?),
        });
    }
    structure.add(table, &row);
    Ok(())
}

fn reference(word: &str) -> Result<Option<usize>, String> {
    if word == "-" { Ok(None) } else { whole(word).map(Some) }
}
