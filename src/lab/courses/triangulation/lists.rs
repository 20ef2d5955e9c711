//! Polygons as the records that the student's program prints: corners with a place, a next and a prev.

use crate::protocol::{Cell, ColumnSchema, RecordSchema, Records, Start, Structure, TableSchema};
use std::sync::Arc;

/// What the records look like.
pub(super) static SCHEMA: RecordSchema = RecordSchema {
    singles: &[],
    tables: &[TableSchema {
        word: "corner",
        letter: 'c',
        columns: &[
            ColumnSchema::Number("x"),
            ColumnSchema::Number("y"),
            ColumnSchema::Link("next", 'c'),
            ColumnSchema::Link("prev", 'c'),
        ],
    }],
};

/// Where a corner is; `None` if there is no such corner.
pub(super) fn place(records: &Records, corner: u32) -> Option<[f64; 2]> {
    let row = records.row(0, corner as usize)?;
    Some([row[0].number()?, row[1].number()?])
}

/// The corner after a corner.
pub(super) fn next(records: &Records, corner: u32) -> Option<u32> {
    records.row(0, corner as usize)?[2].to()
}

/// The corner before a corner.
pub(super) fn prev(records: &Records, corner: u32) -> Option<u32> {
    records.row(0, corner as usize)?[3].to()
}

/// The corners from one along next until it comes again; `None` if it does not, or a link is not set.
pub(super) fn cycle(records: &Records, first: u32) -> Option<Vec<u32>> {
    let mut corners = vec![first];
    let mut at = next(records, first)?;
    while at != first {
        if corners.len() > records.len(0) {
            return None;
        }
        corners.push(at);
        at = next(records, at)?;
    }
    Some(corners)
}

/// The places of the corners of a polygon.
pub(super) fn places(records: &Records, first: u32) -> Option<Vec<[f64; 2]>> {
    cycle(records, first)?.into_iter().map(|corner| place(records, corner)).collect()
}

/// Polygons by their places, one after the other in the list of corners.
pub(super) fn of_places(polygons: &[Vec<[f64; 2]>]) -> Records {
    let mut records = Records::new(&SCHEMA);
    let mut first = 0;
    for polygon in polygons {
        let count = polygon.len() as u32;
        for (i, &[x, y]) in (0..).zip(polygon) {
            let [next, prev] = [(i + 1) % count, (i + count - 1) % count].map(|c| Cell::Link(Some(first + c)));
            records.push(0, &[Cell::Number(x), Cell::Number(y), next, prev]);
        }
        first += count;
    }
    records
}

/// A start with one polygon, as it is typed.
pub(super) fn start(polygon: &[[f64; 2]]) -> Start {
    let line = super::polygons::line(polygon);
    Start::known(line, Structure::Records(Arc::new(of_places(&[polygon.to_vec()]))))
}

/// A start with a convex polygon of so many corners.
pub(super) fn convex(corners: usize) -> Start {
    let places = (0..corners).map(|i| [i as f64, (i * i) as f64]).collect();
    Start::known(format!("convex {corners}"), Structure::Records(Arc::new(of_places(&[places]))))
}
