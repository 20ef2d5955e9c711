//! How much of its tile a pattern paints: a hatch of thin lines lets most of what lies below it be seen.
//!
//! ```text
//!   ┌────┐
//!   │╱  ╱│      areas of all that is filled, and length times width of all lines, as a part of width times height
//!   └────┘
//! ```

use super::geometry::path_data;
use super::ink::{Ink, Own};
use super::numbers;
use super::pairing::ring_sides;
use super::path;
use roxmltree::Node;

/// The area of a tile, if its sides are lengths.
pub(super) fn area(width: &str, height: &str) -> Option<f64> {
    Some(numbers::measure(width)? * numbers::measure(height)?)
}

/// The areas that a shape fills and that its lines cover, about.
pub(super) fn painted(node: Node<'_, '_>, ink: &Ink, own: &Own) -> [f64; 2] {
    let element = node.tag_name().name();
    let said = |name: &str| own.geometry.of(element, name).or_else(|| node.attribute(name));
    let side = |name: &str| said(name).and_then(numbers::measure).unwrap_or(0.0).max(0.0);
    let (filled, length) = match element {
        "rect" => (side("width") * side("height"), 2.0 * (side("width") + side("height"))),
        "circle" => (std::f64::consts::PI * side("r") * side("r"), std::f64::consts::TAU * side("r")),
        "ellipse" => {
            (std::f64::consts::PI * side("rx") * side("ry"), std::f64::consts::TAU * side("rx").max(side("ry")))
        }
        "line" => (0.0, along(&[end(node, "x1", "y1"), end(node, "x2", "y2")])),
        "path" => {
            let data = own.geometry.of(element, "d").and_then(path_data).or_else(|| node.attribute("d"));
            let read = path::read(data.unwrap_or("")).unwrap_or_default();
            let rings = read.iter().map(|path| path.points.iter().map(|p| p.0).collect::<Vec<_>>());
            rings.fold((0.0, 0.0), |sum, ring| (sum.0 + inside(&ring), sum.1 + along(&ring)))
        }
        _ => {
            let list = numbers::list(node.attribute("points").unwrap_or("")).unwrap_or_default();
            let ring: Vec<[f64; 2]> = list.chunks_exact(2).map(|p| [p[0], p[1]]).collect();
            (inside(&ring), along(&ring))
        }
    };
    let fill = if ink.hidden_fill().is_none() { filled } else { 0.0 };
    let stroke = if ink.hidden_stroke().is_none() { length * ink.width() } else { 0.0 };
    [fill, stroke]
}

fn end(node: Node<'_, '_>, x: &str, y: &str) -> [f64; 2] {
    [x, y].map(|name| node.attribute(name).and_then(numbers::measure).unwrap_or(0.0))
}

/// The length of a line through these points.
fn along(points: &[[f64; 2]]) -> f64 {
    points.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).sum()
}

/// The area within these points.
fn inside(points: &[[f64; 2]]) -> f64 {
    let twice: f64 = ring_sides(points).map(|[p, q]| p[0] * q[1] - p[1] * q[0]).sum();
    0.5 * twice.abs()
}
