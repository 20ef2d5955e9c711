//! Large inputs: edges as a few long paths, one or more for each tile of the canvas.
//!
//! ```text
//!   ┌─────────┬─────────┐     A path runs on along unused edges while it stays in its tile and then ends; a
//!   │ ╱╲__╱╲__│__╱╲     │     viewer that shows a part of the figure skips the other tiles. Points are
//!   │ ╲__╱    │    ╲__  │     tenths of a px, steps relative: 3 to 8 bytes an edge.
//!   └─────────┴─────────┘
//! ```

use crate::figure::canvas::scene::{Group, Node, Polylines, tenths};
use crate::figure::canvas::vector::Xy;
use crate::figure::structure::skeleton::{Skeleton, mutual_twin};
use crate::ids::{HalfEdgeId, HalfEdgeMap};
use crate::plane::PlanarView;

/// Side of a tile in px.
const SIDE: f64 = 64.0;
/// How many edges round a vertex a path tries before it ends.
const TRIES: usize = 8;

/// The tiles of a canvas.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tiling {
    columns: usize,
    rows: usize,
}

impl Tiling {
    /// The area of a tile.
    pub(crate) const AREA: f64 = SIDE * SIDE;

    pub(crate) fn over(size: Xy) -> Self {
        let count = |length: f64| (length / SIDE) as usize + 1;
        Self { columns: count(size.x), rows: count(size.y) }
    }

    pub(crate) fn count(&self) -> usize {
        self.columns * self.rows
    }

    /// The tile of a point; points outside belong to the nearest.
    pub(crate) fn tile(&self, p: Xy) -> usize {
        let (column, row) = ((p.x / SIDE).max(0.0) as usize, (p.y / SIDE).max(0.0) as usize);
        row.min(self.rows - 1) * self.columns + column.min(self.columns - 1)
    }
}

/// How wide lines may be that are `ink` px long together in an area: thinner, the denser they are.
pub(crate) fn line_width(ink: f64, area: f64) -> f64 {
    let density = ink / area;
    (0.35 / density).max(0.12)
}

/// All edges. The lines are thinner where the mesh is denser, so that a fine mesh does not become one blot.
pub(crate) fn edges<V: PlanarView + ?Sized>(view: &V, skeleton: &Skeleton, size: Xy) -> Group {
    let tiling = Tiling::over(size);
    let mut tiles: Vec<Polylines> = vec![Polylines::new(false); tiling.count()];
    let mut open = HalfEdgeMap::filled(view.half_edge_bound(), false);
    let mut ink = 0.0;
    for &h in &skeleton.edges {
        open[h] = true;
        if let Some((a, b)) = skeleton.segment(h) {
            ink += (b - a).length();
        }
    }
    // The edge of `h` in the direction of `h`, if it has not been drawn; then it has.
    let take = |open: &mut HalfEdgeMap<bool>, h: HalfEdgeId| {
        let segment = skeleton.segment(h)?;
        let owner = owner(view, open, h)?;
        open[owner] = false;
        Some(segment)
    };
    for &start in &skeleton.edges {
        let mut at = start;
        let mut path: Option<usize> = None;
        while let Some((a, b)) = take(&mut open, at) {
            let home = tiling.tile(a);
            let (from, to) = (tenths(a), tenths(b));
            if path != Some(home) {
                path = (from != to).then_some(home);
                if path.is_some() {
                    tiles[home].start(from);
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
    let width = line_width(ink, size.x * size.y).min(1.0);
    let paths = tiles.into_iter().filter(|lines| !lines.is_empty());
    Group {
        class: "edges",
        attributes: vec![("stroke-width", crate::figure::canvas::number::drawn(width))],
        nodes: paths.map(|lines| Node::Fine { class: "mesh", hatch: None, lines }).collect(),
        ..Group::default()
    }
}

/// The half-edge under which the edge of `h` is listed, if it is still to be drawn.
fn owner<V: PlanarView + ?Sized>(view: &V, open: &HalfEdgeMap<bool>, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let listed = |h: &HalfEdgeId| open.get(*h).copied().unwrap_or(false);
    Some(h).filter(listed).or_else(|| mutual_twin(view, h).filter(listed))
}

/// An undrawn half-edge that starts where `h` ends: the second one round the vertex first, which goes straight
/// on in a grid.
fn onward<V: PlanarView + ?Sized>(view: &V, open: &HalfEdgeMap<bool>, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let end = crate::figure::structure::skeleton::destination(view, h)?;
    let turn = |g: HalfEdgeId| view.twin(g).and_then(|t| view.next(t));
    let first = view.next(h)?;
    let round = std::iter::successors(turn(first), |&g| turn(g)).take(TRIES).chain([first]);
    round.into_iter().find(|&g| owner(view, open, g).is_some() && view.origin(g) == Some(end))
}

/// Outlines of a face with steps below `step` px left out.
pub(crate) fn outline(rings: &[Vec<Xy>], step: f64) -> Polylines {
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
