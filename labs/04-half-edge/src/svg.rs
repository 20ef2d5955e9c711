//! A small writer of pictures, as SVG: filled polygons, lines and dots.
//!
//! What is drawn later lies above what was drawn before: polygons first, then lines, then dots.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::Point;
use std::fmt::Write;

/// The colours of the polygons, in turn.
const FILLS: [&str; 13] = [
    "#cfe3f5", "#f8dfc2", "#d6ecd2", "#eed6e8", "#f5eeb9", "#d5dbe0", "#c9ecea", "#fbd5d0", "#dcd9f4", "#e6f2c4",
    "#fde8cf", "#e9e0d6", "#fdf0a8",
];

/// A picture that is being drawn. y points up, as in the structure; the file has y pointing down, as SVG wants it.
#[derive(Default)]
pub struct Svg {
    elements: String,
    points: Vec<Point>,
    polygons: usize,
}

impl Svg {
    /// Fills the polygon with these corners, each in a colour of its own.
    pub fn polygon(&mut self, corners: &[Point]) {
        let fill = FILLS[self.polygons % FILLS.len()];
        self.polygons += 1;
        let mut list = String::new();
        for &corner in corners {
            let (x, y) = self.place(corner);
            let blank = if list.is_empty() { "" } else { " " };
            let _ = write!(list, "{blank}{x},{y}");
        }
        let _ = writeln!(self.elements, "  <polygon points=\"{list}\" fill=\"{fill}\"/>");
    }

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
        let xs: Vec<f64> = self.points.iter().map(|p| p.x).collect();
        let ys: Vec<f64> = self.points.iter().map(|p| -p.y).collect();
        let least = |numbers: &[f64]| numbers.iter().copied().reduce(f64::min).unwrap_or(0.0);
        let most = |numbers: &[f64]| numbers.iter().copied().reduce(f64::max).unwrap_or(0.0);
        let margin = 20.0;
        let (left, top) = (least(&xs) - margin, least(&ys) - margin);
        let (width, height) = (most(&xs) + margin - left, most(&ys) + margin - top);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{left} {top} {width} {height}\">\n{}</svg>\n",
            self.elements
        )
    }

    fn place(&mut self, p: Point) -> (f64, f64) {
        self.points.push(p);
        // 0.0 - y instead of -y: there is no "-0" in the file.
        (p.x, 0.0 - p.y)
    }
}
