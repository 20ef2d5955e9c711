//! A small writer of pictures, as SVG: lines, dots, and circles through three points.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::Point;
use std::fmt::Write;

/// A circle is drawn as a polygon of so many corners; the first one is on the right of the centre.
const CORNERS: u32 = 56;

/// A picture that is being drawn. y points up, as in the structure; the file has y pointing down, as SVG wants it.
#[derive(Default)]
pub struct Svg {
    elements: String,
    points: Vec<Point>,
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
        let _ = writeln!(self.elements, "  <circle cx=\"{x}\" cy=\"{y}\" r=\"2.5\" fill=\"#111111\"/>");
    }

    /// Draws the circle through three points that are not on one line.
    pub fn circle(&mut self, a: Point, b: Point, c: Point) {
        // The centre is the mean of the corners, each with the weight of its side s: s² (t² + u² - s²).
        let square = |p: Point, q: Point| (p.x - q.x).powi(2) + (p.y - q.y).powi(2);
        let [s, t, u] = [square(b, c), square(c, a), square(a, b)];
        let [i, j, k] = [s * (t + u - s), t * (u + s - t), u * (s + t - u)];
        let sum = i + j + k;
        let centre = Point { x: (i * a.x + j * b.x + k * c.x) / sum, y: (i * a.y + j * b.y + k * c.y) / sum };
        let radius = square(centre, a).sqrt();
        let mut list = String::new();
        for corner in 0..CORNERS {
            let angle = f64::from(corner) * std::f64::consts::TAU / f64::from(CORNERS);
            let on_it = Point { x: centre.x + radius * angle.cos(), y: centre.y + radius * angle.sin() };
            let (x, y) = self.place(on_it);
            let blank = if list.is_empty() { "" } else { " " };
            let _ = write!(list, "{blank}{x},{y}");
        }
        let _ = writeln!(self.elements, "  <polygon points=\"{list}\" fill=\"none\" stroke=\"#3a86c8\"/>");
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
