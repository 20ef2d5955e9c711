//! The one-rings of a graph: half-edges sorted by angle round each vertex, without a sweep.
//!
//! ```text
//!        h2 ╲   ╱ h4        counter-clockwise from straight down: first those to the right, upwards, then those to the
//!            ╲ ╱            left, downwards; straight down itself is last
//!             ●── h0
//! ```

use super::graph::Graph;
use super::one_rings::OneRings;
use crate::geometry::both::of_both;
use crate::geometry::grouping::grouped;
use crate::geometry::predicates::{is_before_round_of_sides, is_left_of, orientation};
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
    // Where the half-edges of some vertices end is looked up at once: memory answers many questions in the time of one.
    let mut far: Vec<Point> = Vec::new();
    for first in (0..points.len()).step_by(AT_ONCE) {
        let starts = &starts[first..=points.len().min(first + AT_ONCE)];
        let mut rest = &mut list[starts[0] as usize..starts[starts.len() - 1] as usize];
        far.clear();
        far.extend(rest.iter().map(|&h| to(h)));
        let mut far = &far[..];
        for (v, range) in (first..).zip(starts.windows(2)) {
            let ring;
            let there;
            (ring, rest) = rest.split_at_mut((range[1] - range[0]) as usize);
            (there, far) = far.split_at(ring.len());
            let at = points[v];
            let are_good = |pair: [Point; 2]| are_good(at, pair);
            match ring.len() {
                0 => continue,
                1 => {}
                2 => are_all_good &= sorted_few::<2>(at, ring, there, are_good),
                3 => are_all_good &= sorted_few::<3>(at, ring, there, are_good),
                4 => are_all_good &= sorted_few::<4>(at, ring, there, are_good),
                // A place is in no direction from itself: nothing could be put in order.
                _ if there.contains(&at) => are_all_good = false,
                _ => {
                    sort_by(ring, &|g, h| from_below(at, to(g), to(h)).then(g.cmp(&h)));
                    let pairs = (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]);
                    are_all_good &= pairs.map(|pair| of_both(pair, to)).all(are_good);
                }
            }
            one_rings.link_all(v as u32, ring.iter().copied());
        }
    }
    Ok((one_rings, are_all_good))
}

/// So many vertices or pairs at once.
pub(super) const AT_ONCE: usize = 64;

/// Sorts by comparisons that take much longer than the sort.
pub(super) fn sort_by(list: &mut [u32], compare: &dyn Fn(u32, u32) -> Ordering) {
    list.sort_unstable_by(|&a, &b| compare(a, b));
}

/// What most rings of a diagram are: a few half-edges, in increasing order, with their ends. Each counts those before it, without
/// a branch: the processor would guess half of the comparisons wrong. Returns whether all pairs that follow each other are good.
#[inline]
fn sorted_few<const N: usize>(
    at: Point,
    ring: &mut [u32],
    ends: &[Point],
    are_good: impl Fn([Point; 2]) -> bool,
) -> bool {
    let mut given = [(0, at, false); N];
    for (given, (&h, &p)) in given.iter_mut().zip(ring.iter().zip(ends)) {
        *given = (h, p, is_left_of(p, at));
    }
    let mut before = [0; N];
    for (i, &(_, p, is_p_left)) in given.iter().enumerate() {
        for (j, &(_, q, is_q_left)) in given.iter().enumerate().take(i) {
            let is_p_first = is_before_round_of_sides(at, [p, q], [is_p_left, is_q_left]);
            before[i] += usize::from(!is_p_first);
            before[j] += usize::from(is_p_first);
        }
    }
    let mut round = [at; N];
    for (&(h, p, _), place) in given.iter().zip(before) {
        ring[place] = h;
        round[place] = p;
    }
    let pairs = (0..N).map(|i| [round[i], round[(i + 1) % N]]);
    pairs.fold(true, |all, pair| all & are_good(pair))
}

/// Which of two places comes first round a point, counter-clockwise from straight down; straight down itself is last.
fn from_below(round: Point, a: Point, b: Point) -> Ordering {
    is_left_of(a, round).cmp(&is_left_of(b, round)).then_with(|| orientation(round, a, b).reverse())
}
