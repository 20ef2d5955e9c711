//! Polygons as the records that the student's program prints: corners with a place, a next and a prev.

use crate::cases::corners::{self, NEXT, PREV};
use crate::protocol::{RecordSchema, Records, Start, Structure};
use std::sync::Arc;

/// What the records look like.
pub(super) static SCHEMA: RecordSchema = RecordSchema { singles: &[], tables: &[corners::CORNERS] };

/// Where a corner is; `None` if there is no such corner.
pub(super) fn place(records: &Records, corner: u32) -> Option<[f64; 2]> {
    corners::place(records.row(0, corner as usize)?)
}

/// The corner after a corner.
pub(super) fn next(records: &Records, corner: u32) -> Option<u32> {
    records.row(0, corner as usize)?[NEXT].to()
}

/// The corner before a corner.
pub(super) fn prev(records: &Records, corner: u32) -> Option<u32> {
    records.row(0, corner as usize)?[PREV].to()
}

/// The corners from one along next until it comes again; `None` if it does not, or a link is not set.
pub(super) fn cycle(records: &Records, first: u32) -> Option<Vec<u32>> {
    corners::cycle(records, 0, first)
}

/// The places of the corners of a polygon.
pub(super) fn places(records: &Records, first: u32) -> Option<Vec<[f64; 2]>> {
    cycle(records, first)?.into_iter().map(|corner| place(records, corner)).collect()
}

/// Polygons by their places, one after the other in the list of corners.
pub(super) fn of_places(polygons: &[Vec<[f64; 2]>]) -> Records {
    let mut records = Records::new(&SCHEMA);
    polygons.iter().for_each(|polygon| corners::push(&mut records, 0, polygon));
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
