//! The lines with which the programs of half-edge labs make a structure.

use super::large;
use crate::protocol::{Start, Structure};
use std::fmt::Write;
use std::sync::Arc;

/// A polygon by its corners, counter-clockwise.
#[must_use]
pub fn polygon(corners: &[[f64; 2]]) -> Start {
    Start::line(format!("polygon{}", points(corners)))
}

/// Triangles: points, then corners by number.
#[must_use]
pub fn triangles(places: &[[f64; 2]], triangles: &[[u32; 3]]) -> Start {
    let mut line = format!("triangles{} /", points(places));
    for [i, j, k] in triangles {
        let _ = write!(line, " {i} {j} {k}");
    }
    Start::line(line)
}

/// A convex polygon with so many corners.
#[must_use]
pub fn convex(corners: usize) -> Start {
    Start::known(format!("convex {corners}"), Structure::HalfEdges(Arc::new(large::convex(corners))))
}

/// So many triangles round one vertex.
#[must_use]
pub fn wheel(spokes: usize) -> Start {
    Start::known(format!("wheel {spokes}"), Structure::HalfEdges(Arc::new(large::wheel(spokes))))
}

/// So many columns and rows of square cells.
#[must_use]
pub fn grid(columns: usize, rows: usize) -> Start {
    Start::known(format!("grid {columns} {rows}"), Structure::HalfEdges(large::grid(columns, rows)))
}

/// Points, two numbers each, with a blank before each number.
#[must_use]
pub fn points(points: &[[f64; 2]]) -> String {
    points.iter().fold(String::new(), |mut out, [x, y]| {
        let _ = write!(out, " {x} {y}");
        out
    })
}
