//! The one-rings of a graph: half-edges sorted by angle round each vertex, without a sweep.
//!
//! ```text
//!        h2 ╲   ╱ h4        counter-clockwise from straight down: first those to the right, upwards, then those to the
//!            ╲ ╱            left, downwards; straight down itself is last
//!             ●── h0
//! ```

use super::graph::Graph;
use super::trace::OneRings;
use crate::geometry::both::of_both;
use crate::geometry::grouping::grouped;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::topology::TooMany;
use std::cmp::Ordering;

/// The one-rings by the angles of the half-edges; of those in one direction the smaller number comes first.
///
/// Cost: O(n), and O(d log d) for a vertex with d edges.
pub(super) fn one_rings_by_angle(graph: &Graph) -> Result<OneRings, TooMany> {
    Ok(one_rings_where(graph, |_, _| true)?.0)
}

/// The same, and whether all half-edges that follow each other are as they should be: that is asked with their vertex and
/// both other ends.
pub(super) fn one_rings_where(
    graph: &Graph,
    are_good: impl Fn(Point, [Point; 2]) -> bool,
) -> Result<(OneRings, bool), TooMany> {
    let mut one_rings = OneRings::new(graph)?;
    let mut are_all_good = true;
    let Graph { points, edges, .. } = graph;
    let ends = edges.as_flattened();
    let (starts, mut list) = grouped(points.len(), ends.len(), |h| ends[h] as usize);
    for (v, range) in (0..).zip(starts.windows(2)) {
        let ring = &mut list[range[0] as usize..range[1] as usize];
        let at = points[v as usize];
        let to = |h: u32| points[ends[(h ^ 1) as usize] as usize];
        let order = |g: u32, h: u32| from_below(at, to(g), to(h)).then(g.cmp(&h));
        match ring {
            [] | [_] => {}
            [a, b] => {
                sort_two(a, b, order);
            }
            [a, b, c] => sort_three([a, b, c], order),
            [a, b, c, d] => sort_four([a, b, c, d], order),
            _ => sort_by(ring, &order),
        }
        if let [first, .., last] = *ring {
            let mut pairs = ring.windows(2).map(|pair| [pair[0], pair[1]]).chain([[last, first]]);
            are_all_good &= pairs.all(|pair| are_good(at, of_both(pair, to)));
        }
        one_rings.link_all(v, ring.iter().copied());
    }
    Ok((one_rings, are_all_good))
}

/// Sorts by comparisons that take much longer than the sort.
pub(super) fn sort_by(list: &mut [u32], compare: &dyn Fn(u32, u32) -> Ordering) {
    list.sort_unstable_by(|&a, &b| compare(a, b));
}

/// Puts two in order; returns whether they were not.
#[inline]
fn sort_two(g: &mut u32, h: &mut u32, order: impl Fn(u32, u32) -> Ordering) -> bool {
    let is_wrong = order(*g, *h).is_gt();
    if is_wrong {
        std::mem::swap(g, h);
    }
    is_wrong
}

/// What most rings of a diagram are, sorted without the steps that a sort takes to find out how long they are.
#[inline]
fn sort_three([a, b, c]: [&mut u32; 3], order: impl Fn(u32, u32) -> Ordering) {
    sort_two(a, b, &order);
    if sort_two(b, c, &order) {
        sort_two(a, b, &order);
    }
}

/// The same for where two edges cross.
#[inline]
fn sort_four([a, b, c, d]: [&mut u32; 4], order: impl Fn(u32, u32) -> Ordering) {
    sort_two(a, b, &order);
    sort_two(c, d, &order);
    sort_two(a, c, &order);
    sort_two(b, d, &order);
    sort_two(b, c, &order);
}

/// Which of two places comes first round a point, counter-clockwise from straight down; straight down itself is last.
fn from_below(round: Point, a: Point, b: Point) -> Ordering {
    let is_left = |p: Point| left_to_right(p, round).is_lt();
    is_left(a).cmp(&is_left(b)).then_with(|| orientation(round, a, b).reverse())
}
