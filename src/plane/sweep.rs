//! A sweep from left to right over straight edges: what lies directly below each point, and whether any two
//! edges meet where they should not.
//!
//! ```text
//!                │    ╱            The sweep line stands at the points one after another. The edges it
//!          ●─────┼───╱──●          cuts are kept in order from bottom to top. At a point p the edges that
//!                ● p               end there leave, those that start there enter; only neighbours in the
//!          ●─────┼──────────●      order can meet next.
//! ```
//!
//! Every decision is an exact orientation. With `n` edges the cost is O(n log n) (plus O(n) moves in chunks of
//! a few hundred words, which no input makes large).
//!
//! Source: Shamos and Hoey, *Geometric intersection problems*, FOCS 1976.

use super::Point;
use super::status::Status;
use crate::geometry::both::of_both;
use crate::geometry::grouping::grouped;
use crate::geometry::places::from_left_to_right;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::progress::Stage;
use std::cmp::Ordering;
use std::ops::Range;

/// Two things that meet where they should not. Numbers are indices into the slices given to the sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Intersection {
    /// Two points at the same place.
    SamePlace(u32, u32),
    /// A point in the interior of an edge it does not belong to.
    PointOnEdge { point: u32, edge: u32 },
    /// Two edges that cross in their interiors.
    Crossing(u32, u32),
    /// Two edges that leave a common end in the same direction.
    Overlap(u32, u32),
}

/// Says nothing lies below.
pub(super) const NOTHING: u32 = u32::MAX;

/// The sweep. Its points are numbered in the order in which it comes to them, and its edges in that of their left
/// ends, so that what it looks at together lies together in memory.
struct Sweep {
    points: Vec<Point>,
    /// The left and the right end of each edge.
    edges: Vec<[u32; 2]>,
    status: Status,
    /// The edges that end at the event, from bottom to top.
    ending: Vec<u32>,
    /// Those that start there.
    starting: Vec<u32>,
    look_for_intersections: bool,
}

/// What a sweep found.
pub(super) struct Swept {
    /// For each point that took part: the edge directly below it, else `NOTHING`.
    pub(super) below: Vec<u32>,
    /// The first intersection on the way from left to right.
    pub(super) intersection: Option<Intersection>,
}

/// The edges round one point as half-edges that leave it, with h0 and h1 of edge 0, h2 and h3 of edge 1, and so on;
/// the even ones run as the edges are given.
pub(super) struct OneRing<'a> {
    /// The number of the point.
    pub(super) point: u32,
    /// To the left, from bottom to top; straight down is left.
    pub(super) left: &'a [u32],
    /// To the right, from bottom to top; straight up is right.
    pub(super) right: &'a [u32],
}

/// Sweeps over `edges` and the further points `extra`, all by their numbers in `points`: finds, for each of these
/// points, the edge directly below it, and the first intersection, if `look_for_intersections`.
///
/// Without `look_for_intersections` the input must have none; then the answer is right, otherwise it is some answer.
pub(super) fn sweep(points: &[Point], edges: &[[u32; 2]], extra: &[u32], look_for_intersections: bool) -> Swept {
    let mut takes_part = vec![false; points.len()];
    edges.iter().flatten().chain(extra).for_each(|&p| takes_part[p as usize] = true);
    let there = (0..).zip(takes_part).filter(|(_, takes_part)| *takes_part).map(|(p, _)| (p, ()));
    let events: Vec<u32> = from_left_to_right(there, |p| points[p as usize]).into_iter().map(|(p, ())| p).collect();
    sweep_in_order(points, edges, &events, look_for_intersections, |_| ())
}

/// The same, for callers who know the order of the points: `events` holds every point that takes part once, from
/// left to right, points above each other from bottom to top. `see` is shown the one-ring of each point.
pub(super) fn sweep_in_order(
    points: &[Point],
    edges: &[[u32; 2]],
    events: &[u32],
    look_for_intersections: bool,
    mut see: impl FnMut(OneRing<'_>),
) -> Swept {
    let mut rank = vec![0_u32; points.len()];
    events.iter().enumerate().for_each(|(i, &p)| rank[p as usize] = i as u32);
    let ranks = |&[a, b]: &[u32; 2]| [rank[a as usize], rank[b as usize]];
    let rightwards: Vec<[u32; 2]> = edges.iter().map(ranks).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    let (firsts, by_left_end) = grouped(events.len(), edges.len(), |e| rightwards[e][0] as usize);
    let half_edge = |&e: &u32| {
        let [a, b] = ranks(&edges[e as usize]);
        2 * e + u32::from(a > b)
    };
    let half_edges: Vec<u32> = by_left_end.iter().map(half_edge).collect();
    let mut sweep = Sweep {
        points: events.iter().map(|&p| points[p as usize]).collect(),
        edges: by_left_end.iter().map(|&e| rightwards[e as usize]).collect(),
        status: Status::default(),
        ending: Vec::new(),
        starting: Vec::new(),
        look_for_intersections,
    };
    let name = |edge: u32| by_left_end[edge as usize];
    let mut below = vec![NOTHING; points.len()];
    let mut intersection = None;
    let stage = Stage::new("sweeping", events.len());
    for (event, &point) in events.iter().enumerate() {
        stage.at(event);
        match sweep.step(event as u32, firsts[event]..firsts[event + 1]) {
            Ok(edge) => below[point as usize] = edge.map_or(NOTHING, name),
            Err(found) => {
                let point = |p: u32| events[p as usize];
                intersection = Some(match found {
                    Intersection::SamePlace(p, q) => Intersection::SamePlace(point(p), point(q)),
                    Intersection::PointOnEdge { point: p, edge } => {
                        Intersection::PointOnEdge { point: point(p), edge: name(edge) }
                    }
                    Intersection::Crossing(e, g) => Intersection::Crossing(name(e).min(name(g)), name(e).max(name(g))),
                    Intersection::Overlap(e, g) => Intersection::Overlap(name(e), name(g)),
                });
                break;
            }
        }
        sweep.starting.iter_mut().for_each(|edge| *edge = half_edges[*edge as usize]);
        sweep.ending.iter_mut().for_each(|edge| *edge = half_edges[*edge as usize] ^ 1);
        see(OneRing { point, left: &sweep.ending, right: &sweep.starting });
    }
    Swept { below, intersection }
}

/// Each edge from its left end to its right end.
pub(super) fn rightwards(points: &[Point], edges: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let turned = |&[a, b]: &[u32; 2]| match left_to_right(points[a as usize], points[b as usize]) {
        Ordering::Greater => [b, a],
        _ => [a, b],
    };
    edges.iter().map(turned).collect()
}

impl Sweep {
    fn ends(&self, edge: u32) -> [Point; 2] {
        of_both(self.edges[edge as usize], |p| self.points[p as usize])
    }

    /// Where the point lies from the edge: `Greater` = above.
    fn side(&self, edge: u32, point: u32) -> Ordering {
        let [a, b] = self.ends(edge);
        orientation(a, b, self.points[point as usize])
    }

    /// Takes the sweep line over `event`, where the edges `starting` start; returns the edge directly below.
    fn step(&mut self, event: u32, starting: Range<u32>) -> Result<Option<u32>, Intersection> {
        let here = self.points[event as usize];
        if self.look_for_intersections && event > 0 && self.points[event as usize - 1] == here {
            return Err(Intersection::SamePlace(event - 1, event));
        }
        let mut at = self.status.partition(|edge| self.side(edge, event).is_gt());
        let below = self.status.before(at);
        self.ending.clear();
        while let Some(edge) = self.status.get(at) {
            if self.edges[edge as usize][1] == event {
                self.status.remove(&mut at);
                self.ending.push(edge);
            } else if self.side(edge, event).is_eq() {
                if self.look_for_intersections {
                    return Err(Intersection::PointOnEdge { point: event, edge });
                }
                break;
            } else {
                break;
            }
        }
        self.starting.clear();
        self.starting.extend(starting);
        let far = |edge: u32| self.points[self.edges[edge as usize][1] as usize];
        self.starting.sort_unstable_by(|&e, &g| orientation(here, far(g), far(e)).then(e.cmp(&g)));
        if self.look_for_intersections {
            for pair in self.starting.windows(2) {
                if orientation(here, far(pair[0]), far(pair[1])).is_eq() {
                    return Err(Intersection::Overlap(pair[0], pair[1]));
                }
            }
            let above = self.status.get(at);
            let neighbours = match self.starting[..] {
                [] => [(below, above), (None, None)],
                [lowest, .., highest] => [(below, Some(lowest)), (Some(highest), above)],
                [only] => [(below, Some(only)), (Some(only), above)],
            };
            for pair in neighbours {
                if let (Some(e), Some(g)) = pair {
                    self.meet(e, g)?;
                }
            }
        }
        self.status.insert(at, &self.starting);
        Ok(below)
    }

    /// Fails if the two neighbours cross in their interiors. A touching end is found when the sweep gets there.
    fn meet(&self, e: u32, g: u32) -> Result<(), Intersection> {
        let ([a, b], [c, d]) = (self.ends(e), self.ends(g));
        if cross(a, b, c, d) { Err(Intersection::Crossing(e, g)) } else { Ok(()) }
    }
}

/// Whether the open segments a-b and c-d cross in one point interior to both. Exact.
pub(super) fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let opposite = |s: Ordering, t: Ordering| s != Ordering::Equal && s == t.reverse();
    opposite(orientation(a, b, c), orientation(a, b, d)) && opposite(orientation(c, d, a), orientation(c, d, b))
}

/// Whether the first edge runs above the second where the sweep line cuts both. Edges run from left to right and do
/// not cross.
pub(super) fn is_above([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let turns = if left_to_right(c, a).is_le() {
        [orientation(c, d, a), orientation(c, d, b)]
    } else {
        [orientation(a, b, c).reverse(), orientation(a, b, d).reverse()]
    };
    turns[0].then(turns[1]).is_gt()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::geometry::random::xorshift;

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|&p| p.into()).collect()
    }

    /// Numbers below bounds.
    pub(in crate::plane) fn numbers(seed: u64) -> impl FnMut(u64) -> u64 {
        let mut random = xorshift(seed);
        move |below| random() % below
    }

    #[test]
    fn the_edge_below_is_found_and_nothing_below_the_lowest() {
        let p = points(&[(0., 0.), (10., 0.), (0., 4.), (10., 5.), (5., 2.), (5., -1.), (5., 9.)]);
        let swept = sweep(&p, &[[0, 1], [3, 2]], &[4, 5, 6], true);
        assert_eq!(swept.intersection, None);
        assert_eq!([swept.below[4], swept.below[5], swept.below[6]], [0, NOTHING, 1]);
    }

    #[test]
    fn each_kind_of_meeting_is_named() {
        let p = points(&[(0., 0.), (4., 4.), (0., 4.), (4., 0.), (2., 2.), (2., 2.), (8., 8.)]);
        assert_eq!(sweep(&p, &[[0, 1], [2, 3]], &[], true).intersection, Some(Intersection::Crossing(0, 1)));
        assert_eq!(
            sweep(&p, &[[0, 1]], &[4], true).intersection,
            Some(Intersection::PointOnEdge { point: 4, edge: 0 })
        );
        assert_eq!(sweep(&p, &[], &[4, 5], true).intersection, Some(Intersection::SamePlace(4, 5)));
        assert_eq!(sweep(&p, &[[0, 1], [0, 6]], &[], true).intersection, Some(Intersection::Overlap(0, 1)));
        assert_eq!(
            sweep(&p, &[[0, 6], [1, 3]], &[], true).intersection,
            Some(Intersection::PointOnEdge { point: 1, edge: 0 })
        );
    }

    #[test]
    fn random_segments_on_a_small_grid_agree_with_all_pairs() {
        for seed in 1..400u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let size = 3 + next(30);
            let n = 2 + next(12);
            let mut p: Vec<Point> = Vec::new();
            for _ in 0..2 * n {
                let q = Point::new(next(size) as f64, next(size) as f64);
                if !p.contains(&q) {
                    p.push(q);
                }
            }
            let edges: Vec<[u32; 2]> = (0..p.len() as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
            let meets = |i: usize, j: usize| {
                let [[a, b], [c, d]] = [i, j].map(|e| edges[e].map(|v| p[v as usize]));
                let on = |a: Point, b: Point, c: Point| {
                    orientation(a, b, c).is_eq() && (c.x - a.x) * (c.x - b.x) <= 0.0 && (c.y - a.y) * (c.y - b.y) <= 0.0
                };
                cross(a, b, c, d) || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)
            };
            let expected = (0..edges.len()).any(|i| (0..i).any(|j| meets(i, j)));
            let found = sweep(&p, &edges, &[], true);
            assert_eq!(found.intersection.is_some(), expected, "seed {seed}");
            if expected {
                continue;
            }
            for (v, q) in p.iter().enumerate().take(2 * edges.len()) {
                // The sweep sees points above each other from left to right, too.
                let height = |e: &[u32; 2]| {
                    let [a, b] = e.map(|v| p[v as usize]);
                    let (a, b) = if left_to_right(a, b).is_lt() { (a, b) } else { (b, a) };
                    let cut = left_to_right(a, *q).is_lt() && left_to_right(*q, b).is_le();
                    (cut && orientation(a, b, *q).is_gt()).then(|| a.y + (b.y - a.y) * (q.x - a.x) / (b.x - a.x))
                };
                let best = edges.iter().filter_map(height).fold(f64::NEG_INFINITY, f64::max);
                let got = match found.below[v] {
                    NOTHING => Some(f64::NEG_INFINITY),
                    edge => height(&edges[edge as usize]),
                };
                assert_eq!(got, Some(best), "seed {seed} point {v}");
            }
        }
    }

    #[test]
    fn ten_thousand_edges_in_one_star_and_a_ladder_of_long_ones() {
        let n = 10_000u32;
        let mut p = vec![Point::new(0.0, 0.0)];
        p.extend((0..n).map(|i| Point::new(1000.0, f64::from(i) - 5000.0)));
        let one_ring: Vec<[u32; 2]> = (1..=n).map(|i| [0, i]).collect();
        assert_eq!(sweep(&p, &one_ring, &[], true).intersection, None);
        let mut q: Vec<Point> = Vec::new();
        let mut ladder: Vec<[u32; 2]> = Vec::new();
        for i in 0..n {
            q.push(Point::new(-f64::from(i % 97), f64::from(i)));
            q.push(Point::new(1e6 - f64::from(i), f64::from(i)));
            ladder.push([2 * i, 2 * i + 1]);
        }
        let swept = sweep(&q, &ladder, &[], true);
        assert_eq!(swept.intersection, None);
        for i in 1..n {
            assert_eq!(swept.below[2 * i as usize + 1], i - 1);
        }
    }
}
