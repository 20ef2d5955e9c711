//! Legends that stand within the box of a drawing, in a corner where nothing is drawn.
//!
//! ```text
//!   ●──────────────●
//!    ╲    ┌─────┐  │      a legend is all that stands in one group of that name; it is beside the structure if
//!     ╲   │─ key│  │      neither an edge nor a vertex of the reference lies within its box
//!      ╲  └─────┘  │
//!       ●──────────●
//! ```

use super::beside::Extent;
use super::drawing::Drawing;
use super::frame::Frame;
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// The numbers of the legends that lie clear of these points and edges, in the coordinates of the frame.
/// O(legends times edges).
pub(super) fn clear(drawing: &Drawing, frame: &Frame, points: &[Point], edges: &[[Point; 2]]) -> BTreeSet<u32> {
    let mut held: BTreeMap<u32, Vec<Point>> = BTreeMap::new();
    let mut add = |legend: u32, p: Point| held.entry(legend).or_default().push(frame.apply(p));
    for dot in drawing.dots.iter().filter(|dot| dot.legend > 0) {
        let at = |x: f64, y: f64| Point::new(dot.at.x + x * dot.radius, dot.at.y + y * dot.radius);
        [at(1.0, 1.0), at(-1.0, -1.0)].into_iter().for_each(|p| add(dot.legend, p));
    }
    for line in drawing.lines.iter().filter(|line| line.legend > 0) {
        line.ends.into_iter().for_each(|p| add(line.legend, p));
    }
    for outline in drawing.outlines.iter().filter(|outline| outline.legend > 0) {
        outline.points.iter().for_each(|&p| add(outline.legend, p));
    }
    let is_clear = |extent: &Extent| {
        !points.iter().any(|&p| extent.meets([p, p])) && !edges.iter().any(|&edge| extent.meets(edge))
    };
    let boxes = held.into_iter().map(|(legend, points)| (legend, Extent::around(points)));
    boxes.filter(|(_, extent)| is_clear(extent)).map(|(legend, _)| legend).collect()
}
