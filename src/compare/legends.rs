//! Legends that stand within the box of a drawing, in a corner where nothing is drawn.
//!
//! ```text
//!   ●──────────────●
//!    ╲    ┌─────┐  │      a legend is all that stands in one group of that name; it is beside the structure if
//!     ╲   │─ key│  │      neither an edge nor a vertex of the reference lies within its box
//!      ╲  └─────┘  │
//!       ●──────────●
//! ```
//!
//! One whose box lets what lies below it shine through may lie over edges, but not over vertices.

use super::beside::Extent;
use super::drawing::Drawing;
use super::frame::Frame;
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// A box that covers no more of what lies below it hides no edge.
const SHEER: f64 = 0.85;

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
    let mut boxes: BTreeMap<u32, bool> = BTreeMap::new();
    for outline in drawing.outlines.iter().filter(|outline| outline.legend > 0) {
        let is_sheer = drawing.painting.coats[outline.coat as usize].alpha <= SHEER;
        // The first area is the box; what lies in it is small.
        boxes.entry(outline.legend).or_insert(is_sheer);
    }
    let is_clear = |legend: u32, extent: &Extent| {
        let is_sheer = boxes.get(&legend).is_some_and(|is_sheer| *is_sheer);
        !points.iter().any(|&p| extent.meets([p, p])) && (is_sheer || !edges.iter().any(|&edge| extent.meets(edge)))
    };
    let all = held.into_iter().map(|(legend, points)| (legend, Extent::around(points)));
    all.filter(|(legend, extent)| is_clear(*legend, extent)).map(|(legend, _)| legend).collect()
}
