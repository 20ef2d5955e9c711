//! A small writer of pictures, as SVG: filled polygons, lines and dots.
//!
//! What is drawn later lies above what was drawn before: polygons first, then lines, then dots.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::point::Point;
use std::fmt::Write;

/// The colours of the polygons, in turn.
const FILLS: [&str; 5] = ["#cfe3f5", "#f8dfc2", "#d6ecd2", "#eed6e8", "#f5eeb9"];
/// How far the picture goes on beyond what is drawn.
const MARGIN: f64 = 20.0;

/// A picture that is being drawn. y points up, as in the plane; the file has y pointing down, as SVG wants it.
#[derive(Default)]
pub struct Svg {
    elements: String,
    polygons: usize,
    /// Least x, least y, greatest x, greatest y, as they are in the file.
    extent: Option<[f64; 4]>,
}

impl Svg {
    /// Fills the polygon with these corners, each in another colour than the one before.
    pub fn polygon(&mut self, corners: &[Point]) {
        let fill = FILLS[self.polygons % FILLS.len()];
        self.polygons += 1;
        let corners: Vec<String> =
            corners.iter().map(|&corner| self.place(corner)).map(|[x, y]| format!("{x},{y}")).collect();
        let _ = writeln!(self.elements, "  <polygon points=\"{}\" fill=\"{fill}\"/>", corners.join(" "));
    }

    /// Draws a line from `a` to `b`.
    pub fn line(&mut self, a: Point, b: Point) {
        let ([x1, y1], [x2, y2]) = (self.place(a), self.place(b));
        let ends = format!("x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"");
        let _ = writeln!(self.elements, "  <line {ends} stroke=\"#333333\" stroke-width=\"2\"/>");
    }

    /// Draws a dot at `p`.
    pub fn dot(&mut self, p: Point) {
        let [x, y] = self.place(p);
        let _ = writeln!(self.elements, "  <circle cx=\"{x}\" cy=\"{y}\" r=\"4\" fill=\"#111111\"/>");
    }

    /// The whole file: everything drawn so far, with a margin around it.
    pub fn finish(&self) -> String {
        let [left, top, right, bottom] = self.extent.unwrap_or_default();
        let (width, height) = (right - left + 2.0 * MARGIN, bottom - top + 2.0 * MARGIN);
        let view = format!("{} {} {width} {height}", left - MARGIN, top - MARGIN);
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{view}\">\n{}</svg>\n", self.elements)
    }

    fn place(&mut self, p: Point) -> [f64; 2] {
        // 0.0 - y instead of -y: there is no "-0" in the file.
        let [x, y] = [p.x, 0.0 - p.y];
        let [left, top, right, bottom] = self.extent.unwrap_or([x, y, x, y]);
        self.extent = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
        [x, y]
    }
}
