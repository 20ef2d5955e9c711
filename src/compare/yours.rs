//! What was handed in, drawn small beside the differences.
//!
//! ```text
//!   your drawing
//!   ┌─────────────┐    what was read, in one colour: areas, lines, circles; lines that nobody sees are dotted
//!   └─────────────┘
//! ```

use super::sketch::Sketch;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::fit::Fit;
use crate::plane::Point;

/// The room for it.
const HEIGHT: f64 = 300.0;
/// Drawings with more lines are not shown.
const LINES: usize = 5_000;
/// Space round a drawing that is placed by itself.
const PAD: f64 = 12.0;

/// A drawing at a place, so wide at most, and its height. `fit` places it as the reference is placed; without it the
/// drawing fills the room.
pub(super) fn panel(sketch: &Sketch, fit: Option<&Fit>, at: Xy, width: f64) -> (Node, f64) {
    let caption = |text: &str| Node::Text { class: "cs", at, size: 12.0, text: text.to_owned() };
    let graph = &sketch.graph;
    if graph.edges.len() > LINES {
        let nodes = vec![caption("your drawing has too many lines to be shown here")];
        return (Node::Group(Group { class: "yours", nodes, ..Group::default() }), 16.0);
    }
    let places: Vec<Xy> = match fit {
        Some(fit) => graph.points.iter().map(|&p| fit.place(p)).collect(),
        None => upright(&graph.points),
    };
    let reach = |of: fn(&Xy) -> f64| {
        let ends = places.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        if ends.0 <= ends.1 { ends } else { (0.0, 0.0) }
    };
    let ((left, right), (top, bottom)) = (reach(|p| p.x), reach(|p| p.y));
    let scale =
        ((width - 2.0 * PAD) / (right - left).max(1.0)).min((HEIGHT - 2.0 * PAD) / (bottom - top).max(1.0)).min(1.0);
    let corner = at + xy(PAD, 14.0 + PAD);
    let place = |m: u32| corner + (places[m as usize] - xy(left, top)) * scale;
    let mut nodes = vec![caption("your drawing, as it was read")];
    for outline in &sketch.outlines {
        let ring = outline.ring.iter().map(|&m| place(m)).collect();
        nodes.push(Node::Area { class: "ya", hatch: None, outlines: vec![ring] });
    }
    let line = |class: &'static str| move |[a, b]: [u32; 2]| Node::Line { class, from: place(a), to: place(b) };
    nodes.extend(sketch.hidden.keys().copied().map(line("yh")));
    nodes.extend(graph.edges.iter().copied().map(line("yl")));
    let dots = (0..graph.points.len() as u32).filter(|&m| sketch.dots[m as usize].is_ok());
    nodes.extend(dots.map(|m| Node::Disc { class: "yd", centre: place(m), radius: 2.6 }));
    let height = 14.0 + (bottom - top) * scale + 2.0 * PAD;
    (Node::Group(Group { class: "yours", nodes, ..Group::default() }), height)
}

/// Points on a canvas whose y points down, 1000 px wide or high.
fn upright(points: &[Point]) -> Vec<Xy> {
    let size = super::pairing::span(points).max(f64::MIN_POSITIVE);
    let base = points.first().copied().unwrap_or(Point::new(0.0, 0.0));
    points.iter().map(|p| xy((p.x - base.x) / size * 1000.0, (base.y - p.y) / size * 1000.0)).collect()
}
