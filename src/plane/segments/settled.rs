//! A look at a graph of which only some edges are new, or none: without a sweep.
//!
//! ```text
//!      ╲   ╱        edges that end at a crossing have moved by its rounding: they are compared with all that
//!   ────╲_╱────     is near them. The others meet as they did before. Then what is left of a sweep is to put
//!       ╱ ╲         the half-edges round each vertex in their order.
//! ```

use super::crossed::{Cuts, sort_by};
use super::graph::Graph;
use super::trace::{OneRings, Seen};
use crate::geometry::grouping::grouped;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::topology::TooMany;

/// A look at a graph in which some edges are known to meet at common ends only: `is_straight[e]` is 1 for them, 0 for the
/// others. None if something meets, or if so many pairs may meet that a sweep is needed.
///
/// Cost: that of [`Cuts::without_sweep`], and O(d log d) for a vertex with d edges.
pub(super) fn look_at_bent(graph: &Graph, is_straight: &[u8]) -> Result<Option<Seen>, TooMany> {
    if !Cuts::without_sweep(graph, is_straight).is_ok_and(|cuts| cuts.is_empty()) {
        return Ok(None);
    }
    where_nothing_meets(graph).map(Some)
}

/// A look at a graph in which nothing meets but at common ends.
///
/// Cost: O(n), and O(d log d) for a vertex with d edges.
pub(super) fn where_nothing_meets(graph: &Graph) -> Result<Seen, TooMany> {
    let Graph { points, edges, .. } = graph;
    let mut one_rings = OneRings::new(graph)?;
    let origins = edges.as_flattened();
    let (starts, mut half_edges) = grouped(points.len(), origins.len(), |h| origins[h] as usize);
    for (point, ends) in (0..).zip(starts.windows(2)) {
        let here = points[point as usize];
        let far = |h: u32| points[origins[(h ^ 1) as usize] as usize];
        let is_left = |h: u32| left_to_right(far(h), here).is_lt();
        let ring = &mut half_edges[ends[0] as usize..ends[1] as usize];
        sort_by(ring, &|g, h| {
            is_left(g).cmp(&is_left(h)).then_with(|| orientation(here, far(h), far(g))).then(g.cmp(&h))
        });
        one_rings.link_all(point, ring.iter().copied());
    }
    Ok(Seen::without_sweep(one_rings))
}
