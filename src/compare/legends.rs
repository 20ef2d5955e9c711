//! Legends that stand within the box of a drawing.
//!
//! ```text
//!   ●──────────────●
//!    ╲    ┌─────┐  │      a legend is all that stands in one group of that name; it is beside the structure if
//!     ╲   │─ key│  │      neither an edge nor a vertex of the reference lies within its box
//!      ╲  └─────┘  │
//!       ●──────────●
//! ```
//!
//! One whose box lets what lies below it shine through may lie over edges, but not over vertices. One without a box may
//! lie anywhere, as long as none of its lines and circles ends at a vertex: what these hide is told by itself.

use super::beside::Extent;
use super::drawing::Drawing;
use super::frame::Frame;
use super::pairing::Places;
use crate::plane::Point;
use std::collections::BTreeMap;

/// A box that covers no more of what lies below it hides no edge.
const SHEER: f64 = 0.85;
/// An area is the box of a legend if it reaches as far as all of it, but for this part.
const WITHIN: f64 = 0.05;
/// How near to a vertex a line ends there, as a part of the size of the structure.
const NEAR: f64 = 1e-3;

/// What is held by a legend.
#[derive(Default)]
struct Held {
    /// Corners, ends and the reach of circles.
    points: Vec<Point>,
    /// Areas, and whether each lets shine through what lies below.
    areas: Vec<(Extent, bool)>,
    /// Whether a line or a circle ends at a vertex.
    touches: bool,
}

/// The legends of a drawing by their numbers, each with whether it lies clear of these points and edges, in the
/// coordinates of the frame. O(n log n + legends times edges).
pub(super) fn legends(drawing: &Drawing, frame: &Frame, points: &[Point], edges: &[[Point; 2]]) -> BTreeMap<u32, bool> {
    let mut held: BTreeMap<u32, Held> = BTreeMap::new();
    if !drawing.has_legend() {
        return BTreeMap::new();
    }
    let reach = NEAR * super::pairing::span(points);
    let places = Places::of(points, reach);
    let is_vertex = |p: Point| places.near(p, reach).is_some();
    for dot in drawing.dots.iter().filter(|dot| dot.legend > 0) {
        let at = |x: f64, y: f64| frame.apply(Point::new(dot.at.x + x * dot.radius, dot.at.y + y * dot.radius));
        let legend = held.entry(dot.legend).or_default();
        legend.points.extend([at(1.0, 1.0), at(-1.0, -1.0)]);
        legend.touches |= is_vertex(at(0.0, 0.0));
    }
    for line in drawing.lines.iter().filter(|line| line.legend > 0) {
        let legend = held.entry(line.legend).or_default();
        let ends = line.ends.map(|p| frame.apply(p));
        legend.points.extend(ends);
        legend.touches |= ends.iter().any(|&p| is_vertex(p));
    }
    for outline in drawing.outlines.iter().filter(|outline| outline.legend > 0) {
        let legend = held.entry(outline.legend).or_default();
        let corners: Vec<Point> = outline.points.iter().map(|&p| frame.apply(p)).collect();
        legend.points.extend(&corners);
        let is_sheer = drawing.painting.coats[outline.coat as usize].alpha <= SHEER;
        legend.areas.push((Extent::around(corners), is_sheer));
    }
    let is_clear = |legend: Held| {
        let extent = Extent::around(legend.points);
        let mut boxes = legend.areas.iter().filter(|(area, _)| area.reaches(&extent, WITHIN)).peekable();
        if boxes.peek().is_none() && !legend.touches {
            return true;
        }
        let is_sheer = boxes.all(|(_, is_sheer)| *is_sheer);
        !points.iter().any(|&p| extent.meets([p, p])) && (is_sheer || !edges.iter().any(|&edge| extent.meets(edge)))
    };
    held.into_iter().map(|(number, legend)| (number, is_clear(legend))).collect()
}
