//! Edges that overlap on one line are cut where one of them begins or ends, before anything else.
//!
//! ```text
//!   e0   ●──────────────●                              runs   [ p0 | p1 | p2 | p3 ]    the pieces of the line, each
//!   e1        ●───────────────●                               e0 = p0 p1 p2            of them once, from left to
//!   e2        ●────●                                          e1 = p1 p2 p3            right; an edge is a stretch of
//!                                                             e2 = p1                  them
//!        p0 │ p1   │ p2 │ p3
//! ```
//!
//! So n edges that all overlap are 2n pieces at most and n stretches, not n² of both. Pieces of an edge run between
//! points of the input on its line: nothing is rounded.

use super::graph::Graph;
use crate::geometry::predicates::{ROUNDING, orientation, sort_key};
use crate::plane::Point;
use crate::plane::meet::{Expansion, cross};
use crate::plane::sweep::rightwards;
use std::cmp::Ordering;
use std::ops::Range;

/// How the edges of before are made of edges of which no two overlap: the pieces.
pub(super) struct Pieces {
    /// Half-edges of pieces (twice the piece, plus 1 against it), line by line in order.
    pub(super) runs: Vec<u32>,
    /// By edge: its stretch of `runs`.
    pub(super) stretches: Vec<Stretch>,
}

/// Where an edge lies in the runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stretch {
    pub(super) range: Range<u32>,
    /// Whether the edge runs against them.
    pub(super) backwards: bool,
}

impl Pieces {
    /// Every one of so many edges is its own piece.
    pub(super) fn whole(edges: usize) -> Self {
        let count = edges as u32;
        Self {
            runs: (0..count).map(|e| 2 * e).collect(),
            stretches: (0..count).map(|e| Stretch { range: e..e + 1, backwards: false }).collect(),
        }
    }

    /// Cuts edges of the graph that overlap. No two edges may have the same ends.
    ///
    /// Cost: O(n log n); exact arithmetic only among edges of nearly the same slope.
    pub(super) fn cut(graph: &mut Graph) -> Self {
        let lines = Lines::new(graph);
        let clusters = lines.overlapping();
        if clusters.is_empty() {
            return Self::whole(graph.edges.len());
        }
        let (edges, pieces) = lines.cut(graph, &clusters);
        graph.edges = edges;
        pieces
    }
}

/// Edges with what is needed to compare their lines.
struct Lines<'a> {
    points: &'a [Point],
    /// The ends from left to right.
    edges: Vec<[u32; 2]>,
    /// The place of each point in the order from left to right.
    rank: Vec<u32>,
}

impl<'a> Lines<'a> {
    fn new(graph: &'a Graph) -> Self {
        let mut rank = vec![0; graph.points.len()];
        graph.by_place().iter().zip(0..).for_each(|(&p, i)| rank[p as usize] = i);
        Self { points: &graph.points, edges: rightwards(&graph.points, &graph.edges), rank }
    }

    fn ends(&self, e: u32) -> [Point; 2] {
        self.edges[e as usize].map(|p| self.points[p as usize])
    }

    fn ranks(&self, e: u32) -> [u32; 2] {
        self.edges[e as usize].map(|p| self.rank[p as usize])
    }

    /// The edges that overlap others: line by line from left to right, and which of them are connected by overlaps.
    fn overlapping(&self) -> Vec<Vec<u32>> {
        let slope = |e: u32| {
            let [a, b] = self.ends(e);
            (b.y - a.y) / (b.x - a.x)
        };
        let mut order: Vec<(u64, u32)> = (0..self.edges.len() as u32).map(|e| (sort_key(slope(e)), e)).collect();
        order.sort_unstable();
        let mut clusters = Vec::new();
        // Equal slopes differ by a few last places when they are rounded: three roundings of half a place for each.
        let alike = |a: &(u64, u32), b: &(u64, u32)| b.0 - a.0 <= 8;
        for alike in order.chunk_by_mut(alike) {
            if alike.len() < 2 {
                continue;
            }
            // Edges of one line meet an axis at the same place, up to rounding.
            let flat = slope(alike[0].1).abs() <= 1.0;
            let crosses = |&(_, e): &(u64, u32)| Crosses::new(e, self.ends(e), slope(e), flat);
            let mut close: Vec<Crosses> = alike.iter().map(crosses).collect();
            close.sort_unstable_by(|a, b| a.at.total_cmp(&b.at).then(a.edge.cmp(&b.edge)));
            let most = close.iter().map(|crosses| crosses.error).fold(0.0, f64::max);
            for close in close.chunk_by_mut(|a, b| b.at - a.at <= 2.0 * most).filter(|close| close.len() > 1) {
                self.overlaps_among(close, &mut clusters);
            }
        }
        clusters
    }

    /// The same among few edges, by exact decisions.
    fn overlaps_among(&self, edges: &mut [Crosses], clusters: &mut Vec<Vec<u32>>) {
        edges.sort_unstable_by(|a, b| {
            self.by_line(a.edge, b.edge).then_with(|| self.ranks(a.edge).cmp(&self.ranks(b.edge)))
        });
        for line in edges.chunk_by(|a, b| self.by_line(a.edge, b.edge).is_eq()) {
            let mut reach = 0;
            let mut start = 0;
            for (i, crosses) in line.iter().enumerate() {
                let [left, right] = self.ranks(crosses.edge);
                if left >= reach {
                    clusters.extend(several(&line[start..i]));
                    start = i;
                }
                reach = reach.max(right);
            }
            clusters.extend(several(&line[start..]));
        }
    }

    /// An order of the lines through the edges: by direction, parallel ones from left to right of it. Exact.
    fn by_line(&self, e: u32, g: u32) -> Ordering {
        let ([a, b], [c, d]) = (self.ends(e), self.ends(g));
        turn([a, b], [c, d]).then_with(|| orientation(a, b, c))
    }

    /// The pieces of edges of which the clusters overlap: those of edge 0 first, then those of edge 1 that are new, and so
    /// on, each as the first of its edges runs.
    fn cut(&self, graph: &Graph, clusters: &[Vec<u32>]) -> (Vec<[u32; 2]>, Pieces) {
        const NONE: u32 = u32::MAX;
        let mut runs: Vec<[u32; 2]> = Vec::with_capacity(graph.edges.len());
        let mut stretches = vec![Stretch { range: 0..0, backwards: false }; graph.edges.len()];
        let mut ends: Vec<u32> = Vec::new();
        for cluster in clusters {
            ends.clear();
            ends.extend(cluster.iter().flat_map(|&e| self.ranks(e)));
            ends.sort_unstable();
            ends.dedup();
            let base = runs.len() as u32;
            let place = |rank: u32| base + ends.partition_point(|&r| r < rank) as u32;
            for &e in cluster {
                let [left, right] = self.ranks(e);
                let backwards = graph.edges[e as usize] != self.edges[e as usize];
                stretches[e as usize] = Stretch { range: place(left)..place(right), backwards };
            }
            let point = |rank: u32| graph.by_place()[rank as usize];
            runs.extend(ends.windows(2).map(|pair| [point(pair[0]), point(pair[1])]));
        }
        for (stretch, &ends) in stretches.iter_mut().zip(&graph.edges) {
            if stretch.range.is_empty() {
                let place = runs.len() as u32;
                runs.push(ends);
                stretch.range = place..place + 1;
            }
        }
        // Pieces get their numbers edge by edge; `free` leads from each place to the next one without a number.
        let mut number = vec![NONE; runs.len()];
        let mut free: Vec<u32> = (0..=runs.len() as u32).collect();
        let mut edges = Vec::with_capacity(runs.len());
        let mut fresh = Vec::new();
        for stretch in &stretches {
            fresh.clear();
            let mut place = first_free(&mut free, stretch.range.start);
            while place < stretch.range.end {
                fresh.push(place);
                free[place as usize] = place + 1;
                place = first_free(&mut free, place + 1);
            }
            if stretch.backwards {
                fresh.reverse();
            }
            for &place in &fresh {
                let [a, b] = runs[place as usize];
                number[place as usize] = 2 * edges.len() as u32 + u32::from(stretch.backwards);
                edges.push(if stretch.backwards { [b, a] } else { [a, b] });
            }
        }
        (edges, Pieces { runs: number, stretches })
    }
}

/// Where the line through an edge crosses an axis.
struct Crosses {
    edge: u32,
    at: f64,
    /// The place is off by no more.
    error: f64,
}

impl Crosses {
    /// Where it crosses the axis of y if it is flat, else that of x.
    fn new(edge: u32, [a, _]: [Point; 2], slope: f64, flat: bool) -> Self {
        let (here, run) = if flat { (a.y, a.x * slope) } else { (a.x, a.y / slope) };
        // The slope is off by three roundings, what follows adds two.
        Self { edge, at: here - run, error: 8.0 * ROUNDING * (here.abs() + run.abs()) }
    }
}

/// The edges of a cluster, if there are several.
fn several(line: &[Crosses]) -> Option<Vec<u32>> {
    (line.len() > 1).then(|| line.iter().map(|crosses| crosses.edge).collect())
}

/// The first place from `place` on that is free; the way there is shortened for the next one.
fn first_free(free: &mut [u32], place: u32) -> u32 {
    let mut end = place;
    while free[end as usize] != end {
        end = free[end as usize];
    }
    let mut at = place;
    while free[at as usize] != at {
        at = std::mem::replace(&mut free[at as usize], end);
    }
    end
}

/// Whether c -> d points to the left (`Greater`) or to the right of a -> b, or in its direction; both run to the right.
/// Exact.
fn turn([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Ordering {
    let [one, other] = [(b.x - a.x) * (d.y - c.y), (b.y - a.y) * (d.x - c.x)];
    let (difference, doubt) = (one - other, 4.0 * ROUNDING * (one.abs() + other.abs()));
    // A difference of different numbers is not 0, and no product of such differences gets lost below: a product that
    // is 0 is exact, and so is the sign of the other.
    if difference.abs() > doubt || one == 0.0 || other == 0.0 {
        return difference.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    }
    let vector = |p: Point, q: Point| [Expansion::difference(q.x, p.x), Expansion::difference(q.y, p.y)];
    cross(&vector(a, b), &vector(c, d)).sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::predicates::left_to_right;
    use crate::geometry::random::xorshift;
    use crate::plane::segments::graph::{Distinct, Single};

    fn graph(segments: &[[(i64, i64); 2]]) -> Graph {
        let ends: Vec<Point> = segments.iter().flatten().map(|&(x, y)| Point::new(x as f64, y as f64)).collect();
        let Distinct { points, order, number } = Distinct::new(&ends);
        let given: Vec<[u32; 2]> = number.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect();
        let edges = Single::new(points.len(), &given, |_, _| {}).edges;
        Graph { points, edges, order }
    }

    /// The chain of points of an edge.
    fn chain(made: &Graph, pieces: &Pieces, e: usize) -> Vec<u32> {
        let Stretch { range, backwards } = pieces.stretches[e].clone();
        let mut halves = pieces.runs[range.start as usize..range.end as usize].to_vec();
        if backwards {
            halves = halves.iter().rev().map(|h| h ^ 1).collect();
        }
        let ends = |h: u32| {
            let [a, b] = made.edges[(h >> 1) as usize];
            if h & 1 == 0 { [a, b] } else { [b, a] }
        };
        halves.windows(2).for_each(|pair| assert_eq!(ends(pair[0])[1], ends(pair[1])[0]));
        halves.iter().map(|&h| ends(h)[0]).chain(halves.last().map(|&h| ends(h)[1])).collect()
    }

    #[test]
    fn edges_are_cut_where_those_that_overlap_them_end_and_nowhere_else() {
        let mut cut = 0;
        for seed in 1..600_u64 {
            let mut random = xorshift(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut next = |below: u64| ((random() >> 20) % below) as i64;
            let size = 3 + next(4) as u64;
            let mut end = || (next(size), next(size));
            let list: Vec<_> = (0..14).map(|_| [end(), end()]).filter(|[a, b]| a != b).collect();
            let graph = graph(&list);
            let mut made = graph.clone();
            let pieces = Pieces::cut(&mut made);
            let at = |p: u32| graph.points[p as usize];
            let overlap = |e: [u32; 2], g: [u32; 2]| {
                let ([a, b], [c, d]) = (e.map(at), g.map(at));
                let key = |p: Point| (p.x as i64, p.y as i64);
                let (low, high) =
                    (key(a).min(key(b)).max(key(c).min(key(d))), key(a).max(key(b)).min(key(c).max(key(d))));
                orientation(a, b, c).is_eq() && orientation(a, b, d).is_eq() && low < high
            };
            for (i, &e) in made.edges.iter().enumerate() {
                assert!(made.edges[..i].iter().all(|&g| !overlap(e, g)), "seed {seed}: pieces overlap");
            }
            let mut new = 0;
            for (e, &[a, b]) in graph.edges.iter().enumerate() {
                let points = chain(&made, &pieces, e);
                assert_eq!([points[0], points[points.len() - 1]], [a, b], "seed {seed}");
                cut += points.len() - 2;
                // Each point in between is an end of an edge on the same line, in order along the edge.
                for pair in points.windows(2) {
                    let ([p, q], [a, b]) = ([pair[0], pair[1]].map(at), [a, b].map(at));
                    assert!((q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y) > 0.0, "seed {seed}: order");
                    assert!(orientation(a, b, q).is_eq(), "seed {seed}: off the line");
                }
                // Numbers follow the edges.
                let Stretch { range, .. } = &pieces.stretches[e];
                let run = &pieces.runs[range.start as usize..range.end as usize];
                assert!(run.iter().all(|h| (h >> 1) < new + run.len() as u32), "seed {seed}");
                new = run.iter().map(|h| (h >> 1) + 1).chain([new]).max().unwrap_or(new);
            }
            assert_eq!(new as usize, made.edges.len(), "seed {seed}: pieces of no edge");
        }
        assert!(cut > 500, "{cut}");
    }

    #[test]
    fn rounded_slopes_hide_no_overlap() {
        let mut random = xorshift(77);
        let mut next = |below: i64| (random() >> 20) as i64 % below;
        let mut cut = 0;
        for round in 0..3000 {
            // Whole numbers, so that edges of one line are on it exactly; their slopes and crossings are rounded.
            let size = [30, 1 << 20][round % 2];
            let far = [0, 1 << 40, -(1 << 46)][round / 2 % 3];
            let (dx, dy) = match round / 6 % 5 {
                0 => (1 + next(size), next(2 * size) - size),
                1 => (next(3), 1 + next(size)),
                2 => (1 + next(size), next(3) - 1),
                // About the diagonal.
                3 => (size, size + next(3) - 1),
                _ => (size + next(3) - 1, -size),
            };
            let (x, y) = (far + next(1 << 30), far + next(1 << 30));
            let mut at = || {
                let k = next(1 << 8);
                (x + k * dx, y + k * dy)
            };
            let mut list: Vec<_> = (0..6).map(|_| [at(), at()]).filter(|[a, b]| a != b).collect();
            // Nearly the same line beside it.
            let beside = list.iter().map(|&[(ax, ay), (bx, by)]| [(ax, ay + 1), (bx, by + 1)]).collect::<Vec<_>>();
            list.extend(beside);
            let graph = graph(&list);
            let mut made = graph.clone();
            Pieces::cut(&mut made);
            let ends = |e: &[u32; 2]| {
                let [a, b] = e.map(|p| graph.points[p as usize]);
                if left_to_right(a, b).is_lt() { [a, b] } else { [b, a] }
            };
            let later = |a: Point, b: Point| if left_to_right(a, b).is_lt() { b } else { a };
            let sooner = |a: Point, b: Point| if left_to_right(a, b).is_lt() { a } else { b };
            for (i, e) in made.edges.iter().enumerate() {
                for g in &made.edges[..i] {
                    let ([a, b], [c, d]) = (ends(e), ends(g));
                    let one_line = orientation(a, b, c).is_eq() && orientation(a, b, d).is_eq();
                    let common = left_to_right(later(a, c), sooner(b, d)).is_lt();
                    assert!(!(one_line && common), "round {round}: {list:?}");
                }
            }
            cut += made.edges.len().saturating_sub(graph.edges.len());
        }
        assert!(cut > 5000, "{cut}");
    }
}
