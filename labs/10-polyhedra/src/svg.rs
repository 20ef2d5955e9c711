//! A small writer of pictures, as SVG: lines and dots in space, seen from the front, from above and a little from the
//! right.
//!
//! ```text
//!      z ▲   ▗ y        a point (x, y, z) is drawn at 100 x + 40 y to the right
//!        │ ╱                                and 100 z + 30 y - 15 x upwards
//!        ●──▗ x
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::polyhedron::Point;
use std::fmt::Write;

/// A picture that is being drawn.
#[derive(Default)]
pub struct Svg {
    elements: String,
    points: Vec<(f64, f64)>,
}

impl Svg {
    /// Draws a line from `a` to `b`.
    pub fn line(&mut self, a: Point, b: Point) {
        let ((x1, y1), (x2, y2)) = (self.place(a), self.place(b));
        let _ = writeln!(
            self.elements,
            "  <line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#333333\" stroke-width=\"2\"/>"
        );
    }

    /// Draws a dot at `p`.
    pub fn dot(&mut self, p: Point) {
        let (x, y) = self.place(p);
        let _ = writeln!(self.elements, "  <circle cx=\"{x}\" cy=\"{y}\" r=\"4\" fill=\"#111111\"/>");
    }

    /// The whole file: everything drawn so far, with a margin around it.
    pub fn finish(&self) -> String {
        let least = |numbers: &mut dyn Iterator<Item = f64>| numbers.reduce(f64::min).unwrap_or(0.0);
        let most = |numbers: &mut dyn Iterator<Item = f64>| numbers.reduce(f64::max).unwrap_or(0.0);
        let margin = 20.0;
        let (xs, ys) = (|| self.points.iter().map(|p| p.0), || self.points.iter().map(|p| p.1));
        let (left, top) = (least(&mut xs()) - margin, least(&mut ys()) - margin);
        let (width, height) = (most(&mut xs()) + margin - left, most(&mut ys()) + margin - top);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{left} {top} {width} {height}\">\n{}</svg>\n",
            self.elements
        )
    }

    /// Where a point is drawn; y points down in the file.
    fn place(&mut self, p: Point) -> (f64, f64) {
        let place = (100.0 * p.x + 40.0 * p.y, 15.0 * p.x - 30.0 * p.y - 100.0 * p.z);
        self.points.push(place);
        place
    }
}
