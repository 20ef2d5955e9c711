//! A window on a drawing: what lies outside is left out, areas end at its border.
//!
//! ```text
//!        ┌ ─ ─ ─ ─ ─ ┐
//!     ●──┼──▸●───────┼▸●      lines that meet the window stay whole, the rest of the file is gone;
//!        │  f1       │        areas are cut, so that a face is labelled in the part that can be seen
//!        └ ─ ─ ─ ─ ─ ┘
//! ```
//!
//! Source: Sutherland and Hodgman, *Reentrant polygon clipping*, 1974. Two parts of a cut ring may stay joined
//! along the border: the even-odd rule counts that way twice.

use crate::figure::FigureOptions;
use crate::figure::canvas::scene::{Group, Node, Polylines};
use crate::figure::canvas::vector::{Bounds, Xy, xy};

/// Half the width of the widest line.
const LINE: f64 = 4.0;

/// The window of a canvas.
pub(crate) fn window(size: Xy) -> Bounds {
    Bounds { min: Xy::default(), max: size }
}

/// The part of a closed ring within a window; empty if there is none.
pub(crate) fn cut(ring: Vec<Xy>, window: &Bounds) -> Vec<Xy> {
    let sides: [(Xy, f64); 4] = [
        (xy(1.0, 0.0), window.min.x),
        (xy(-1.0, 0.0), -window.max.x),
        (xy(0.0, 1.0), window.min.y),
        (xy(0.0, -1.0), -window.max.y),
    ];
    sides.into_iter().fold(ring, |ring, (inward, border)| cut_by_side(&ring, inward, border))
}

/// The points p of a ring with p · inward >= border, and where the ring passes the border.
pub(crate) fn cut_by_side(ring: &[Xy], inward: Xy, border: f64) -> Vec<Xy> {
    let mut out = Vec::with_capacity(ring.len());
    let Some(mut a) = ring.last().copied() else { return out };
    for &b in ring {
        let (from, to) = (a.dot(inward) - border, b.dot(inward) - border);
        if (from >= 0.0) != (to >= 0.0) {
            out.push(a + (b - a) * (from / (from - to)));
        }
        if to >= 0.0 {
            out.push(b);
        }
        a = b;
    }
    out
}

/// A drawing that shares its canvas with others: of a cropped one nothing reaches beyond its own part of it.
pub(crate) fn framed(nodes: Vec<Node>, size: Xy, options: &FigureOptions) -> Vec<Node> {
    if options.crop.is_none() {
        return nodes;
    }
    vec![Node::Group(Group { window: Some(size), nodes: seen(nodes, size), ..Group::default() })]
}

/// What can be seen of a drawing on a canvas of this size. The group of an element stays whole if one of its
/// lines, discs or areas can be seen.
pub(crate) fn seen(nodes: Vec<Node>, size: Xy) -> Vec<Node> {
    let canvas = window(size).grown(LINE);
    nodes.into_iter().filter_map(|node| part(node, &canvas)).collect()
}

fn part(node: Node, canvas: &Bounds) -> Option<Node> {
    let meets = |bounds: Option<Bounds>| bounds.is_some_and(|b| b.overlaps(canvas));
    match node {
        Node::Group(group) => {
            let is_element = group.id.is_some();
            let all = if is_element { group.nodes.clone() } else { Vec::new() };
            let seen: Vec<Node> = group.nodes.into_iter().filter_map(|node| part(node, canvas)).collect();
            let shown = seen.iter().any(|node| !matches!(node, Node::Text { .. }));
            let nodes = if is_element { all } else { seen };
            shown.then_some(Node::Group(Group { nodes, ..group }))
        }
        Node::Line { from, to, .. } => canvas.meets_segment(from, to).then_some(node),
        Node::Area { ref outlines, .. } => meets(Bounds::of(outlines.iter().flatten().copied())).then_some(node),
        Node::Disc { centre, radius, .. } => meets(Some(Bounds::around(centre, radius, radius))).then_some(node),
        Node::Text { at, .. } => meets(Some(Bounds::around(at, 1.0, 1.0))).then_some(node),
        Node::Curve { .. } => Some(node),
        Node::Fine { class, hatch, lines } => {
            let mut kept = Polylines::new(lines.closed);
            for line in lines.iter() {
                let point = |p: &[i32; 2]| xy(f64::from(p[0]), f64::from(p[1])) * 0.1;
                let bounds = Bounds::of(line.iter().map(point)).map(|b| b.grown(0.1));
                if let (true, Some((&first, rest))) = (meets(bounds), line.split_first()) {
                    kept.start(first);
                    rest.iter().for_each(|&p| kept.line_to(p));
                }
            }
            (!kept.is_empty()).then_some(Node::Fine { class, hatch, lines: kept })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::canvas::vector::doubled_area;

    #[test]
    fn a_ring_is_cut_on_all_four_sides() {
        let window = Bounds { min: xy(0.0, 0.0), max: xy(10.0, 10.0) };
        let area = |ring: &[(f64, f64)]| {
            let mut cut = cut(ring.iter().map(|&(x, y)| xy(x, y)).collect(), &window);
            assert!(cut.iter().all(|&p| window.contains(&Bounds { min: p, max: p })), "{cut:?}");
            cut.extend(cut.first().copied());
            0.5 * doubled_area(&cut).abs()
        };
        assert!((area(&[(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)]) - 100.0).abs() < 1e-9);
        assert!((area(&[(5.0, -5.0), (15.0, 5.0), (5.0, 15.0), (-5.0, 5.0)]) - 100.0).abs() < 1e-9);
        assert!((area(&[(5.0, 0.0), (10.0, 5.0), (5.0, 10.0), (0.0, 5.0)]) - 50.0).abs() < 1e-9);
        assert!(area(&[(11.0, 0.0), (12.0, 5.0), (11.0, 10.0)]) < 1e-9);
    }
}
