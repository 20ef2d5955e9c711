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
        // BEGIN SOLUTION
        // STARTER: let _ = c;
        // STARTER: todo!("corners_of")
        let mut corners = vec![c];
        let mut corner = self.next(c);
        while corner != c {
            corners.push(corner);
            corner = self.next(corner);
        }
        corners
        // END SOLUTION
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
        // BEGIN SOLUTION
        // STARTER: let _ = (u, v);
        // STARTER: todo!("split")
        if u == v || self.next(u) == v || self.next(v) == u {
            return None;
        }
        let first = self.next(u);
        let last = self.prev(v);
        let copy_of_u = self.new_corner(self.position(u));
        let copy_of_v = self.new_corner(self.position(v));
        self.make_next(u, v);
        self.make_next(copy_of_u, first);
        self.make_next(last, copy_of_v);
        self.make_next(copy_of_v, copy_of_u);
        Some(copy_of_u)
        // END SOLUTION
    }
}

/// Geometry.
impl Polygons {
    /// Task 3. Whether the line between the corners `u` and `v` of one polygon is a diagonal of it: it lies inside, and
    /// touches the boundary at its two ends only.
    pub fn is_diagonal(&self, u: CornerId, v: CornerId) -> bool {
        // BEGIN SOLUTION
        // STARTER: let _ = (u, v);
        // STARTER: // These two are given in predicates.rs.
        // STARTER: let _ = (orient2d, on_segment);
        // STARTER: todo!("is_diagonal")
        if u == v || self.next(u) == v || self.next(v) == u {
            return false;
        }
        if !begins_inside(self, u, v) {
            return false;
        }
        let (a, b) = (self.position(u), self.position(v));
        for corner in self.corners_of(u) {
            let next = self.next(corner);
            let (c, d) = (self.position(corner), self.position(next));
            if corner != u && corner != v && on_segment(c, a, b) {
                return false;
            }
            if ![u, v].contains(&corner) && ![u, v].contains(&next) && cross(a, b, c, d) {
                return false;
            }
        }
        true
        // END SOLUTION
    }

    /// Task 4. Whether the corner `c` is an ear: the line between its neighbours is a diagonal. The polygon has at least
    /// four corners.
    pub fn is_ear(&self, c: CornerId) -> bool {
        // BEGIN SOLUTION
        // STARTER: let _ = c;
        // STARTER: todo!("is_ear")
        self.is_diagonal(self.prev(c), self.next(c))
        // END SOLUTION
    }

    /// Task 5. Cuts the polygon of `c` into triangles by its diagonals. Returns one corner of each triangle, in any order.
    pub fn triangulate(&mut self, c: CornerId) -> Vec<CornerId> {
        // BEGIN SOLUTION
        // STARTER: let _ = c;
        // STARTER: todo!("triangulate")
        let mut left = self.corners_of(c).len();
        let mut triangles = Vec::new();
        let mut corner = c;
        while left > 3 {
            let next = self.next(corner);
            if self.is_ear(corner) {
                let before = self.prev(corner);
                triangles.extend(self.split(before, next));
                left -= 1;
            }
            corner = next;
        }
        triangles.push(corner);
        triangles
        // END SOLUTION
    }
}

// BEGIN SOLUTION
// STARTER: // Here is room for functions of your own.
use crate::point::Point;

/// Whether the way from `u` to `v` begins inside of their polygon.
fn begins_inside(polygons: &Polygons, u: CornerId, v: CornerId) -> bool {
    let [before, at, after, to] = [polygons.prev(u), u, polygons.next(u), v].map(|c| polygons.position(c));
    let (of_first, of_second) = (orient2d(at, after, to), orient2d(before, at, to));
    if orient2d(before, at, after) >= 0 {
        // On the left of both sides of the corner.
        of_first > 0 && of_second > 0
    } else {
        // A reflex corner: on the left of one of them is enough.
        of_first > 0 || of_second > 0
    }
}

/// Whether two line segments cross at a point inside both.
fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0
}
// END SOLUTION

/// Task 6. Draws all polygons: each filled, with a line for each of its sides and a dot at each corner.
pub fn picture(polygons: &Polygons, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (polygons, svg);
    // STARTER: todo!("picture")
    let count = polygons.corners.len();
    let mut done = vec![false; count];
    for first in 0..count {
        if done[first] {
            continue;
        }
        let corners = polygons.corners_of(first);
        let mut places = Vec::new();
        for &corner in &corners {
            done[corner] = true;
            places.push(polygons.position(corner));
        }
        svg.polygon(&places);
    }
    // Lines and dots lie above all areas.
    for corner in 0..count {
        svg.line(polygons.position(corner), polygons.position(polygons.next(corner)));
        svg.dot(polygons.position(corner));
    }
    // END SOLUTION
}
