//! Your part of the lab: a polygon is cut along diagonals until only triangles are left.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help are
//! in `polygon.rs` and `predicates.rs`. `cargo test` says how far you are.

use crate::polygon::{CornerId, Polygons};
use crate::predicates::{on_segment, orient2d};
use crate::svg::Svg;

/// Lists.
impl Polygons {
    /// Task 1. The corners of the polygon of `c`, counter-clockwise, each once, beginning with `c`.
    pub fn corners_of(&self, c: CornerId) -> Vec<CornerId> {
        let _ = c;
        todo!("corners_of")
    }

    /// Task 2. Splits the polygon of `u` and `v` in two, along the line between them.
    ///
    /// ```text
    ///      ●──── v ────●             ●──── v   copy of v ────●      u and v stay in the polygon in which v now follows
    ///      │           │      =>     │     │       │         │      u; the copies are in the other one, with all
    ///      ●──── u ────●             ●──── u   copy of u ────●      that was between u and v, counter-clockwise
    /// ```
    ///
    /// Returns the copy of `u`. But if `u` and `v` are the same corner, or one of them is the next of the other, it
    /// returns `None` and nothing has changed.
    pub fn split(&mut self, u: CornerId, v: CornerId) -> Option<CornerId> {
        let _ = (u, v);
        todo!("split")
    }
}

/// Geometry.
impl Polygons {
    /// Task 3. Whether the line between the corners `u` and `v` of one polygon is a diagonal of it: it lies inside, and
    /// touches the boundary at its two ends only.
    pub fn is_diagonal(&self, u: CornerId, v: CornerId) -> bool {
        let _ = (u, v);
        // These two are given in predicates.rs.
        let _ = (orient2d, on_segment);
        todo!("is_diagonal")
    }

    /// Task 4. Whether the corner `c` is an ear: the line between its neighbours is a diagonal. The polygon has at least
    /// four corners.
    pub fn is_ear(&self, c: CornerId) -> bool {
        let _ = c;
        todo!("is_ear")
    }

    /// Task 5. Cuts the polygon of `c` into triangles by its diagonals. Returns one corner of each triangle, in any order.
    pub fn triangulate(&mut self, c: CornerId) -> Vec<CornerId> {
        let _ = c;
        todo!("triangulate")
    }
}

// Here is room for functions of your own.

/// Task 6. Draws all polygons: each filled, with a line for each of its sides and a dot at each corner.
pub fn picture(polygons: &Polygons, svg: &mut Svg) {
    let _ = (polygons, svg);
    todo!("picture")
}
