//! Holes that a drawing leaves in its areas where the reference fills a face.
//!
//! ```text
//!   ┌───────┐     ┌───────┐
//!   │░┌──┐░░│     │░┌──┐░░│     in the reference's hole, or where another area lies, the paper is not missed;
//!   │░└──┘░░│     │░│  │░░│     a hole that is larger, or elsewhere, is told where paper is seen in it
//!   └───────┘     └─┴──┴──┘
//! ```

use super::beside::Beside;
use super::drawing::Drawing;
use super::eye::{Eye, contrast};
use super::frame::Frame;
use super::painting::{Area, PALE, Painting, Part, Shape};
use super::pairing::span;
use super::rings;
use super::sketch::Sketch;
use crate::plane::Point;

/// So many sides of a hole are looked at beside their middles.
const SIDES: usize = 64;
/// How far within a side, as a part of how wide the hole is.
const WITHIN: f64 = 0.03;

/// A hole in the coordinates of the reference, and a point of it at which paper is seen.
pub(super) struct Window {
    pub(super) ring: Vec<Point>,
    at: Point,
}

/// The holes of a drawing in which paper is seen where the reference fills a face. O(n log n).
pub(super) fn windows(eye: &mut Eye<'_>, expected: &Sketch, found: &Sketch, frame: &Frame) -> Vec<Window> {
    let mut out = Vec::new();
    if found.holes.is_empty() || expected.outlines.is_empty() {
        return out;
    }
    let faces = Faces::new(expected);
    let mut wanted = faces.eye();
    for hole in &found.holes {
        let ring: Vec<Point> = hole.iter().map(|&m| found.graph.point(m)).collect();
        let missed = inside(&ring).into_iter().find(|&p| faces.fill(&mut wanted, p) && eye.is_blank(frame.back(p)));
        out.extend(missed.map(|at| Window { ring, at }));
    }
    out
}

/// Takes out those where the reference's own drawing, which is placed by a frame, shows paper, too.
pub(super) fn excuse(windows: &mut Vec<Window>, own: &Drawing, beside: &Beside, frame: &Frame) {
    let size = span(&own.points().collect::<Vec<Point>>());
    let mut eye = Eye::new(&own.painting, beside, own.lines.len(), size);
    windows.retain(|window| !eye.is_blank(frame.back(window.at)));
}

/// The faces that the reference fills, and what it leaves open in them, the smaller over the larger ones.
struct Faces {
    painting: Painting,
    /// Whether each is filled.
    filled: Vec<bool>,
    size: f64,
}

impl Faces {
    fn new(expected: &Sketch) -> Self {
        let points = |ring: &Vec<u32>| ring.iter().map(|&v| expected.graph.point(v)).collect::<Vec<Point>>();
        let filled = expected.outlines.iter().map(|outline| (points(&outline.ring), true));
        let open = expected.holes.iter().chain(&expected.open).map(|ring| (points(ring), false));
        let mut all: Vec<(f64, Vec<Point>, bool)> =
            filled.chain(open).map(|(ring, is)| (rings::area(ring.iter().copied()).abs(), ring, is)).collect();
        // Of a face and a hole with the same outline, the face is filled.
        all.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.2.cmp(&b.2)));
        let mut out = Self { painting: Painting::default(), filled: Vec::new(), size: span(&expected.graph.points) };
        for (_, ring, is) in all {
            let area = Shape::Area(Area::new(&[ring], false));
            out.painting.add(area, (super::colour::Paint::Some, 1.0), None, Part::Area);
            out.filled.push(is);
        }
        out
    }

    fn eye(&self) -> Eye<'_> {
        Eye::new(&self.painting, &Beside::default(), self.filled.len(), self.size)
    }

    /// Whether a face is to be filled at a point.
    fn fill(&self, eye: &mut Eye<'_>, p: Point) -> bool {
        eye.look(p);
        !eye.is_tired() && eye.stack.last().is_some_and(|&i| self.filled[i as usize])
    }
}

/// Points within a ring: well inside, and beside the middles of its sides.
fn inside(ring: &[Point]) -> Vec<Point> {
    let area = Area::new(&[ring.to_vec()], false);
    let mut out = area.inner_points(&area);
    out.extend(rings::beside_sides(ring, WITHIN).take(SIDES).filter(|&p| area.covers(p).0));
    out
}

impl Eye<'_> {
    /// Whether areas leave a point of the canvas as paper.
    fn is_blank(&mut self, p: Point) -> bool {
        self.look(p);
        let areas = self.colour(|_, coat| coat.part == Part::Area);
        !self.is_tired() && contrast(areas, self.blank()) < PALE
    }
}
