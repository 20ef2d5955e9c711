//! Polygons as records of linked corners: a place, the next corner, the one before.

use crate::protocol::{Cell, ColumnSchema, Records, TableSchema};
use ColumnSchema::{Link, Number};

/// The records of corners.
pub const CORNERS: TableSchema = TableSchema {
    word: "corner",
    letter: 'c',
    columns: &[Number("x"), Number("y"), Link("next", 'c'), Link("prev", 'c')],
};
/// The fields of a corner that are links.
pub const NEXT: usize = 2;
/// The other one.
pub const PREV: usize = 3;

/// Where a corner or point is.
#[must_use]
pub fn place(row: &[Cell]) -> Option<[f64; 2]> {
    Some([row.first()?.number()?, row.get(1)?.number()?])
}

/// The corners of a polygon from one along next until it comes again; `None` if it does not, or a link is not set.
#[must_use]
pub fn cycle(records: &Records, table: usize, first: u32) -> Option<Vec<u32>> {
    let mut out = Vec::new();
    let mut at = first;
    while out.len() < records.len(table) {
        out.push(at);
        at = records.row(table, at as usize)?.get(NEXT)?.to()?;
        if at == first {
            return Some(out);
        }
    }
    None
}

/// Adds a polygon; its corners are numbered on.
pub fn push(records: &mut Records, table: usize, polygon: &[[f64; 2]]) {
    let (first, n) = (records.len(table), polygon.len());
    for (i, &[x, y]) in polygon.iter().enumerate() {
        let link = |to: usize| Cell::Link(Some((first + to % n) as u32));
        records.push(table, &[Cell::Number(x), Cell::Number(y), link(i + 1), link(i + n - 1)]);
    }
}
