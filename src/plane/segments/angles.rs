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
    let to = |h: u32| points[ends[(h ^ 1) as usize] as usize];
    for (v, range) in (0..).zip(starts.windows(2)) {
        let ring = &mut list[range[0] as usize..range[1] as usize];
        let at = points[v as usize];
        let order = |&(g, p): &End, &(h, q): &End| from_below(at, p, q).then(g.cmp(&h));
        let are_good = |pair: [Point; 2]| are_good(at, pair);
        match ring.len() {
            0 | 1 => {}
            2 => are_all_good &= sorted_few::<2>(ring, to, order, are_good),
            3 => are_all_good &= sorted_few::<3>(ring, to, order, are_good),
            4 => are_all_good &= sorted_few::<4>(ring, to, order, are_good),
            _ => {
                sort_by(ring, &|g, h| order(&(g, to(g)), &(h, to(h))));
                let pairs = (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]);
                are_all_good &= pairs.map(|pair| of_both(pair, to)).all(are_good);
            }
        }
        one_rings.link_all(v, ring.iter().copied());
    }
    Ok((one_rings, are_all_good))
}

/// A half-edge and where it ends.
type End = (u32, Point);

/// Sorts by comparisons that take much longer than the sort.
pub(super) fn sort_by(list: &mut [u32], compare: &dyn Fn(u32, u32) -> Ordering) {
    list.sort_unstable_by(|&a, &b| compare(a, b));
}

/// What most rings of a diagram are: a few half-edges with their ends, looked up once, sorted without the steps that a sort
/// takes to find out how many they are. Returns whether all pairs that follow each other are good.
#[inline]
fn sorted_few<const N: usize>(
    ring: &mut [u32],
    to: impl Fn(u32) -> Point,
    order: impl Fn(&End, &End) -> Ordering,
    are_good: impl Fn([Point; 2]) -> bool,
) -> bool {
    let mut ends = [(0, Point::new(0.0, 0.0)); N];
    ends.iter_mut().zip(&*ring).for_each(|(end, &h)| *end = (h, to(h)));
    for i in 1..N {
        for j in (0..i).rev() {
            if order(&ends[j], &ends[j + 1]).is_le() {
                break;
            }
            ends.swap(j, j + 1);
        }
    }
    let mut are_all_good = true;
    for (i, half_edge) in ring.iter_mut().enumerate() {
        *half_edge = ends[i].0;
        are_all_good &= are_good([ends[i].1, ends[(i + 1) % N].1]);
    }
    are_all_good
}

/// Which of two places comes first round a point, counter-clockwise from straight down; straight down itself is last.
fn from_below(round: Point, a: Point, b: Point) -> Ordering {
    let is_left = |p: Point| left_to_right(p, round).is_lt();
    is_left(a).cmp(&is_left(b)).then_with(|| orientation(round, a, b).reverse())
}
