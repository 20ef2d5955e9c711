//! A small writer of pictures, as SVG: lines and dots in space, seen from the front, from above and a little from the
//! right; six panels, three in a row.
//!
//! ```text
//!      z ▲   ▗ y        a point (x, y, z) is drawn at 100 x + 45 y to the right
//!        │ ╱                                and 100 z + 60 y - 10 x upwards
//!        ●──▗ x         from (400 column, -400 row) on
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use std::fmt::Write;

/// A point of space: x to the right, y to the back, z upwards.
pub type Place = [f64; 3];

/// A picture that is being drawn.
#[derive(Default)]
pub struct Svg {
    elements: String,
    points: Vec<(f64, f64)>,
    panel: usize,
}

impl Svg {
    /// What is drawn from now on stands in this panel: 0, 1, 2 above, 3, 4, 5 below.
    pub fn panel(&mut self, panel: usize) {
        self.panel = panel;
    }

    /// Draws a line from `a` to `b`.
    pub fn line(&mut self, a: Place, b: Place) {
        let ((x1, y1), (x2, y2)) = (self.drawn(a), self.drawn(b));
        let _ = writeln!(
            self.elements,
            "  <line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#333333\" stroke-width=\"2\"/>"
        );
    }

    /// Draws a dot at `p`.
    pub fn dot(&mut self, p: Place) {
        let (x, y) = self.drawn(p);
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
    fn drawn(&mut self, [x, y, z]: Place) -> (f64, f64) {
        let (column, row) = ((self.panel % 3) as f64, (self.panel / 3) as f64);
        let place = (400.0 * column + 100.0 * x + 45.0 * y, 400.0 * row + 10.0 * x - 60.0 * y - 100.0 * z);
        self.points.push(place);
        place
    }
}
