//! Pictures of a structure, as SVG. std only.

use crate::dcel::{Dcel, Point};
use std::fmt::Write;

/// A picture that is being drawn. y points up, as in the structure; the file has y pointing down, as SVG wants it.
#[derive(Default)]
pub struct Svg {
    elements: String,
    points: Vec<Point>,
}

impl Svg {
    /// Fills the polygon with these corners.
    pub fn polygon(&mut self, corners: &[Point], fill: &str) {
        let mut list = String::new();
        for &corner in corners {
            let (x, y) = self.place(corner);
            let blank = if list.is_empty() { "" } else { " " };
            let _ = write!(list, "{blank}{x},{y}");
        }
        let _ = std::writeln!(self.elements, "  <polygon points=\"{list}\" fill=\"{fill}\"/>");
    }

    /// Draws a line from `a` to `b`.
    pub fn line(&mut self, a: Point, b: Point, stroke: &str) {
        let ((x1, y1), (x2, y2)) = (self.place(a), self.place(b));
        let _ = std::writeln!(
            self.elements,
            "  <line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"{stroke}\" stroke-width=\"2\"/>"
        );
    }

    /// Draws a dot at `p`.
    pub fn dot(&mut self, p: Point, fill: &str) {
        let (x, y) = self.place(p);
        let _ = std::writeln!(self.elements, "  <circle cx=\"{x}\" cy=\"{y}\" r=\"4\" fill=\"{fill}\"/>");
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

/// The colours of the faces, in turn.
const FILLS: [&str; 13] = [
    "#cfe3f5", "#f8dfc2", "#d6ecd2", "#eed6e8", "#f5eeb9", "#d5dbe0", "#c9ecea", "#fbd5d0", "#dcd9f4", "#e6f2c4",
    "#fde8cf", "#e9e0d6", "#fdf0a8",
];

/// The picture of a structure: the faces but the outer one filled, a line for each edge, a dot for each vertex.
/// It uses your `incident_vertices` and your `destination`.
pub fn picture(dcel: &Dcel) -> String {
    let mut svg = Svg::default();
    for f in 0..dcel.faces.len() {
        if f != dcel.outer_face {
            let corners: Vec<Point> = dcel.incident_vertices(f).iter().map(|&v| dcel.position(v)).collect();
            svg.polygon(&corners, FILLS[f % FILLS.len()]);
        }
    }
    for h in 0..dcel.half_edges.len() {
        // Each edge once: from the side with the smaller number.
        if h < dcel.twin(h) {
            svg.line(dcel.position(dcel.origin(h)), dcel.position(dcel.destination(h)), "#333333");
        }
    }
    for vertex in &dcel.vertices {
        svg.dot(vertex.pos, "#111111");
    }
    svg.finish()
}
