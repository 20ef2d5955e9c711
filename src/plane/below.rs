//! The edges directly below some points: for few points less than a sweep.
//!
//! ```text
//!        ●───────●            Points asked for, from left to right: p q. Each edge knows by two counts which of them it
//!            p                passes above or below; of those below a point the highest is kept.
//!     ●───────────────●
//!          q ●                Counts of points asked for up to the left and up to the right end of an edge: 0 and 2
//!     ●──────────●            for the lowest.
//! ```

use super::Point;
use super::sweep::{NOTHING, is_above, sweep, sweep_in_order};
use crate::geometry::both::of_both;
use crate::geometry::predicates::{left_to_right, orientation};

/// So many edges above and below points are looked at for each edge; a sweep is quicker than more of them.
const MOST: usize = 4;

/// For each point asked for, the edge directly below it, else [`NOTHING`]; for all other points some answer. The edges meet at
/// common ends only; `by_place` holds all points from left to right, if their order is known.
///
/// Cost: O(n + k) for n edges that pass above or below points asked for k times, with another O(n log m) for m points asked
/// for if the order is not known; O(n log n) where k is more than a few n.
pub(super) fn edges_below(
    points: &[Point],
    edges: &[[u32; 2]],
    by_place: Option<&[u32]>,
    asked: impl Iterator<Item = u32>,
) -> Vec<u32> {
    let mut below = vec![NOTHING; points.len()];
    let compare = |&p: &u32, &q: &u32| left_to_right(points[p as usize], points[q as usize]);
    let mut asked: Vec<u32> = asked.collect();
    asked.sort_unstable_by(compare);
    asked.dedup();
    // Nothing lies below the first point of all.
    let first = (0..points.len() as u32).min_by(compare);
    asked.retain(|&p| Some(p) != first);
    if asked.is_empty() {
        return below;
    }
    // By point, how many of those asked for come up to it.
    let count = match by_place {
        Some(by_place) => {
            let mut count = vec![0; points.len()];
            let mut sum = 0;
            for p in by_place {
                sum += u32::from(asked.get(sum as usize) == Some(p));
                count[*p as usize] = sum;
            }
            count
        }
        None => (0..points.len() as u32).map(|p| asked.partition_point(|q| compare(q, &p).is_le()) as u32).collect(),
    };
    let passed = |ends: &[u32; 2]| {
        let [a, b] = of_both(*ends, |p| count[p as usize]);
        a.min(b) as usize..a.max(b) as usize
    };
    let work: usize = edges.iter().map(|ends| passed(ends).len()).sum();
    if work > MOST * edges.len() {
        return match by_place {
            Some(by_place) => sweep_in_order(points, edges, by_place, false, |_| ()),
            None => sweep(points, edges, &asked, false),
        }
        .below;
    }
    let rightwards = |edge: [u32; 2]| {
        let [a, b] = of_both(edge, |p| points[p as usize]);
        if left_to_right(a, b).is_gt() { [b, a] } else { [a, b] }
    };
    for (e, &edge) in (0..).zip(edges) {
        for &p in &asked[passed(&edge)] {
            let [a, b] = rightwards(edge);
            let best = &mut below[p as usize];
            let is_below = orientation(a, b, points[p as usize]).is_gt();
            if is_below && (*best == NOTHING || is_above([a, b], rightwards(edges[*best as usize]))) {
                *best = e;
            }
        }
    }
    below
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::tests::numbers;
    use crate::plane::{ArrangeOptions, Subdivision};

    #[test]
    fn some_points_have_the_same_edge_below_as_all_of_them() {
        let (mut found, mut swept) = ([0; 2], [0; 2]);
        for seed in 1..400_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let count = 2 + next(40);
            // Many points above each other, and upright edges.
            let mut place = || Point::new(next(9) as f64, next(9) as f64 / 2.0);
            let segments: Vec<[Point; 2]> = (0..count).map(|_| [place(), place()]).collect();
            let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
            let s = Subdivision::arrange_segments(&segments, &options).unwrap().subdivision;
            let points: Vec<Point> = s.vertices().map(|v| s.point(v)).collect();
            let edges: Vec<[u32; 2]> = s.edges().map(|e| s.edge_ends(e).map(crate::ids::VertexId::number)).collect();
            let mut by_place: Vec<u32> = (0..points.len() as u32).collect();
            by_place.sort_by(|&a, &b| left_to_right(points[a as usize], points[b as usize]));
            let all = sweep_in_order(&points, &edges, &by_place, false, |_| ()).below;
            let share = 1 + next(12);
            let asked: Vec<u32> = by_place.iter().copied().filter(|_| next(share) == 0).collect();
            for (way, known) in [Some(&by_place[..]), None].into_iter().enumerate() {
                let some = edges_below(&points, &edges, known, asked.iter().copied());
                for &p in &asked {
                    assert_eq!(some[p as usize], all[p as usize], "seed {seed}, point {p}");
                    found[way] += u32::from(some[p as usize] != NOTHING);
                }
                swept[way] += u32::from(some == all);
            }
        }
        for (found, swept) in found.into_iter().zip(swept) {
            assert!(found > 1_000 && swept > 20 && swept < 380, "{found} {swept}");
        }
    }
}
