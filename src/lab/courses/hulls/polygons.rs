//! Points and linked corners, as a program of this lab prints them.

use crate::protocol::{Cell, ColumnSchema, RecordSchema, Records, TableSchema};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// Points, then corners.
pub(super) static SCHEMA: RecordSchema = RecordSchema {
    singles: &[],
    tables: &[
        TableSchema { word: "point", letter: 'p', columns: &[ColumnSchema::Number("x"), ColumnSchema::Number("y")] },
        TableSchema {
            word: "corner",
            letter: 'c',
            columns: &[
                ColumnSchema::Number("x"),
                ColumnSchema::Number("y"),
                ColumnSchema::Link("next", 'c'),
                ColumnSchema::Link("prev", 'c'),
            ],
        },
    ],
};

/// The tables by their places in the schema.
const POINTS: usize = 0;
const CORNERS: usize = 1;
/// The fields of a corner that are links.
pub(super) const NEXT: usize = 2;
pub(super) const PREV: usize = 3;

/// A corner with its number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Corner {
    pub(super) number: u32,
    pub(super) place: Point,
}

/// The points of a dump.
pub(super) fn points(records: &Records) -> Vec<Point> {
    records.rows(POINTS).map(place).collect()
}

fn place(row: &[Cell]) -> Point {
    let number = |i: usize| row.get(i).and_then(|cell| cell.number()).unwrap_or_default();
    Point::new(number(0), number(1))
}

/// A link of a corner.
pub(super) fn link(records: &Records, corner: u32, which: usize) -> Option<u32> {
    records.row(CORNERS, corner as usize)?.get(which)?.to()
}

/// The corners of a polygon, by next; `None` if that does not come back.
pub(super) fn cycle(records: &Records, first: u32) -> Option<Vec<Corner>> {
    let mut out = Vec::new();
    let mut number = first;
    while out.len() < records.len(CORNERS) {
        out.push(Corner { number, place: place(records.row(CORNERS, number as usize)?) });
        number = link(records, number, NEXT)?;
        if number == first {
            return Some(out);
        }
    }
    None
}

/// Adds a polygon to records; its corners are numbered on.
pub(super) fn add(records: &mut Records, corners: &[Point]) {
    let (first, n) = (records.len(CORNERS), corners.len());
    for (i, p) in corners.iter().enumerate() {
        let link = |to: usize| Cell::Link(Some((first + to % n) as u32));
        records.push(CORNERS, &[Cell::Number(p.x), Cell::Number(p.y), link(i + 1), link(i + n - 1)]);
    }
}

/// Adds points to records.
pub(super) fn add_points(records: &mut Records, points: &[Point]) {
    points.iter().for_each(|p| records.push(POINTS, &[Cell::Number(p.x), Cell::Number(p.y)]));
}

/// Of three points on one line: whether b lies between a and c, or is equal to one of them.
pub(super) fn is_between(a: Point, b: Point, c: Point) -> bool {
    let ends = [left_to_right(a, b), left_to_right(b, c)];
    !(ends.contains(&Ordering::Less) && ends.contains(&Ordering::Greater))
}

/// Whether a point is outside of the convex polygon with these corners.
pub(super) fn is_outside(corners: &[Corner], p: Point) -> bool {
    (0..corners.len()).any(|i| {
        let (a, b) = (corners[i].place, corners[(i + 1) % corners.len()].place);
        let side = orientation(a, b, p);
        side.is_lt() || side.is_eq() && !is_between(a, p, b)
    })
}

/// A point as it stands in a sentence.
pub(super) fn named(p: Point) -> String {
    format!("({}, {})", p.x, p.y)
}
