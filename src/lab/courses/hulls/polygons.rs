//! Points and linked corners, as a program of this lab prints them.

use crate::cases::corners;
use crate::protocol::{Cell, ColumnSchema, RecordSchema, Records, TableSchema};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// Points, then corners.
pub(super) static SCHEMA: RecordSchema = RecordSchema {
    singles: &[],
    tables: &[
        TableSchema { word: "point", letter: 'p', columns: &[ColumnSchema::Number("x"), ColumnSchema::Number("y")] },
        corners::CORNERS,
    ],
};

/// The tables by their places in the schema.
const POINTS: usize = 0;
const CORNERS: usize = 1;

pub(super) use corners::{NEXT, PREV};

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
    corners::place(row).unwrap_or_default().into()
}

/// A link of a corner.
pub(super) fn link(records: &Records, corner: u32, which: usize) -> Option<u32> {
    records.row(CORNERS, corner as usize)?.get(which)?.to()
}

/// The corners of a polygon, by next; `None` if that does not come back.
pub(super) fn cycle(records: &Records, first: u32) -> Option<Vec<Corner>> {
    let corner = |number: u32| Some(Corner { number, place: place(records.row(CORNERS, number as usize)?) });
    corners::cycle(records, CORNERS, first)?.into_iter().map(corner).collect()
}

/// Adds a polygon to records; its corners are numbered on.
pub(super) fn add(records: &mut Records, polygon: &[Point]) {
    let places: Vec<[f64; 2]> = polygon.iter().map(|p| [p.x, p.y]).collect();
    corners::push(records, CORNERS, &places);
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
    (0..corners.len()).any(|i| is_beyond(corners, i, p))
}

/// Whether the side from a corner shows that a point is outside.
pub(super) fn is_beyond(corners: &[Corner], i: usize, p: Point) -> bool {
    let (a, b) = (corners[i].place, corners[(i + 1) % corners.len()].place);
    let side = orientation(a, b, p);
    side.is_lt() || side.is_eq() && !is_between(a, p, b)
}

/// A point as it stands in a sentence.
pub(super) fn named(p: Point) -> String {
    format!("({}, {})", p.x, p.y)
}
