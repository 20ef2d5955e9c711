//! Large inputs: edges as a few long paths, one or more for each tile of the canvas.
//!
//! ```text
//!   ┌─────────┬─────────┐     A path runs on along unused edges while it stays in its tile and then ends; a
//!   │ ╱╲__╱╲__│__╱╲     │     viewer that shows a part of the figure skips the other tiles. Points are
//!   │ ╲__╱    │    ╲__  │     tenths of a px, steps relative: 3 to 8 bytes an edge.
//!   └─────────┴─────────┘
//! ```

use super::scene::{Group, Node, Polylines, tenths};
use super::skeleton::{Skeleton, mutual_twin};
use super::vector::Xy;
use crate::ids::{HalfEdgeId, HalfEdgeMap};
use crate::plane::PlanarView;

/// Side of a tile in px.
const SIDE: f64 = 64.0;
/// How many edges round a vertex a path tries before it ends.
const TRIES: usize = 8;

/// All edges. The lines are thinner where the mesh is denser, so that a fine mesh does not become one blot.
pub(super) fn edges<V: PlanarView + ?Sized>(view: &V, skeleton: &Skeleton, size: Xy) -> Group {
    let columns = (size.x / SIDE) as usize + 1;
    let rows = (size.y / SIDE) as usize + 1;
    let tile = |p: Xy| {
        let (column, row) = ((p.x / SIDE).max(0.0) as usize, (p.y / SIDE).max(0.0) as usize);
        row.min(rows - 1) * columns + column.min(columns - 1)
    };
    let mut tiles: Vec<Polylines> = vec![Polylines::new(false); columns * rows];
    let mut open = HalfEdgeMap::filled(view.half_edge_bound(), false);
    let mut ink = 0.0;
    for &h in &skeleton.edges {
        open[h] = true;
        if let Some((a, b)) = skeleton.segment(h) {
            ink += (b - a).length();
        }
    }
    for &start in &skeleton.edges {
        let mut at = start;
        let mut path: Option<usize> = None;
        while let Some((a, b)) = take(view, skeleton, &mut open, at) {
            let home = tile(a);
            let (from, to) = (tenths(a), tenths(b));
            if path != Some(home) {
                if from != to {
                    tiles[home].start(from);
                    path = Some(home);
                } else {
                    path = None;
                }
            }
            if path.is_some() {
                tiles[home].line_to(to);
            }
            match onward(view, &open, at) {
                Some(next) => at = next,
                None => break,
            }
        }
    }
    let density = ink / (size.x * size.y);
    let width = if density > 0.0 { (0.35 / density).clamp(0.12, 1.0) } else { 1.0 };
    let paths = tiles.into_iter().filter(|lines| !lines.is_empty());
    Group {
        class: "edges",
        attributes: vec![("stroke-width", super::number::drawn(width))],
        nodes: paths.map(|lines| Node::Fine { class: "mesh", hatch: None, lines }).collect(),
        ..Group::default()
    }
}

/// The edge of `h` in the direction of `h`, if it has not been drawn; then it has.
fn take<V: PlanarView + ?Sized>(
    view: &V,
    skeleton: &Skeleton,
    open: &mut HalfEdgeMap<bool>,
    h: HalfEdgeId,
) -> Option<(Xy, Xy)> {
    let segment = skeleton.segment(h)?;
    let owner = owner(view, open, h)?;
    open[owner] = false;
    Some(segment)
}

/// The half-edge under which the edge of `h` is listed, if it is still to be drawn.
fn owner<V: PlanarView + ?Sized>(view: &V, open: &HalfEdgeMap<bool>, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let listed = |h: &HalfEdgeId| open.get(*h).copied().unwrap_or(false);
    Some(h).filter(listed).or_else(|| mutual_twin(view, h).filter(listed))
}

/// An undrawn half-edge that starts where `h` ends: the second one round the vertex first, which goes straight
/// on in a grid.
fn onward<V: PlanarView + ?Sized>(view: &V, open: &HalfEdgeMap<bool>, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let end = super::skeleton::destination(view, h)?;
    let turn = |g: HalfEdgeId| view.twin(g).and_then(|t| view.next(t));
    let first = view.next(h)?;
    let round = std::iter::successors(turn(first), |&g| turn(g)).take(TRIES).chain([first]);
    round.into_iter().find(|&g| owner(view, open, g).is_some() && view.origin(g) == Some(end))
}

/// Outlines of a face with steps below `step` px left out.
pub(super) fn outline(rings: &[Vec<Xy>], step: f64) -> Polylines {
    let mut out = Polylines::new(true);
    for ring in rings {
        let Some(&first) = ring.first() else { continue };
        let mut kept = first;
        out.start(tenths(first));
        for &p in &ring[1..] {
            if (p - kept).length() >= step {
                out.line_to(tenths(p));
                kept = p;
            }
        }
    }
    out
}
