//! The lines with which the programs of half-edge labs make a structure.

use super::large;
use crate::protocol::{Start, Structure};
use std::fmt::Display;
use std::sync::Arc;

/// A polygon by its corners, counter-clockwise.
#[must_use]
pub fn polygon(corners: &[[f64; 2]]) -> Start {
    Start::line(format!("polygon{}", points(corners)))
}

/// Triangles: points, then corners by number.
#[must_use]
pub fn triangles(places: &[[f64; 2]], triangles: &[[u32; 3]]) -> Start {
    Start::line(format!("triangles{} /{}", points(places), words(triangles.iter().flatten())))
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
    words(points.iter().flatten())
}

/// Words with a blank before each of them.
pub fn words(all: impl IntoIterator<Item: Display>) -> String {
    all.into_iter().map(|word| format!(" {word}")).collect()
}

/// A number in its shorter form: in full, or with a power of ten.
#[must_use]
pub fn shorter(x: f64) -> String {
    let (plain, powers) = (x.to_string(), format!("{x:e}"));
    if powers.len() < plain.len() { powers } else { plain }
}
