//! Splitting segments where they meet, until nothing meets but at common ends.
//!
//! ```text
//!     round 1: all intersections of the       the crossings are rounded     round 2: the new edges are looked at as
//!     given segments, exactly            to doubles: edges bend        exactly; if a bend runs over something,
//!          ╲   ╱                              ╲   ╱                     that is an intersection, too, and is split
//!           ╲ ╱                                ╲_╱
//!           ╱ ╲                                ╱ ╲                      ... until a round finds nothing
//! ```
//!
//! In these rounds points of the input do not move; a crossing moves to the nearest doubles. So the last round is the
//! proof that the result has no intersections, whatever was rounded before.
//!
//! In bundles of lines a few last bits apart, every round may make new crossings between the doubles. What has not
//! settled after four rounds, or has more crossings in a later round than edges, is therefore rounded to a grid, which always
//! settles: see `snap.rs`.

use super::chains::Split;
use super::crossed::Cuts;
use super::graph::{Graph, Order, Single};
use super::settled::{look_at_bent, look_by_pairs, look_within, proved_by_faces};
use super::snap::{Plain, snap};
use super::trace::{Seen, look};
use crate::geometry::grouping::Groups;
use crate::geometry::predicates::is_left_of;
use crate::plane::Point;
use crate::plane::meet::{EventPlace, Gap, Grid, visit_intersections};
use crate::topology::TooMany;
use std::ops::ControlFlow;

/// Rounds after which a grid is used. One or two are usual.
const PLAIN_ROUNDS: u32 = 4;

/// Where less than this part of the edges was cut, not all of them are looked at again.
const FEW_CUTS: usize = 8;

/// Splits the edges of `graph` until nothing meets; on the grid, if there is one, else in place where that settles. Also
/// gives what the last look at the graph, the one that found nothing, has seen. The cuts of the first round may be known.
///
/// Cost: O((n + k) log n) a round, with k intersections; see [`snap`] for the grid.
///
/// # Errors
/// If there are more half-edges than ids.
pub(super) fn split(graph: &mut Graph, grid: Option<Grid>, first: Option<Cuts>) -> Result<(Split, Seen), TooMany> {
    let given = graph.points.len();
    // The edges before the first round, once there was one.
    let mut uncut = None;
    let mut split = Split::none(graph.edges.len());
    let mut known = first;
    while grid.is_none() && split.rounds < PLAIN_ROUNDS {
        // Bent edges that cross more often than there are edges do not settle: every round would find still more.
        let most = if split.rounds == 0 { usize::MAX } else { graph.edges.len() };
        let all_is_known = known.is_some();
        let Some(Cuts { cuts, new, gap }) = known.take().or_else(|| find_cuts(graph, most)) else { break };
        if cuts.is_empty() {
            return Ok((split, look(graph)?));
        }
        split.rounds += 1;
        let old = graph.points.len() as u32;
        // The edges of this round are no further from those of the input than the bends of all rounds together.
        let off = new.iter().map(|&(_, off)| off).fold(0.0, f64::max);
        // The edges that cross here are bent themselves, by the rounds before.
        let bent = split.farthest;
        let sum = |off: f64| if bent > 0.0 { (bent + off).next_up() } else { off };
        if off > 0.0 {
            split.farthest = (split.farthest + off).next_up();
        }
        if let Some(gap) = gap.filter(|gap| all_is_known && gap.exceeds(off))
            && let Some((starts, half, seen)) = cut_within(graph, &cuts, &new, gap)?
        {
            split.made.extend((old..).zip(&new).map(|(number, &(_, off))| (number, sum(off))));
            split.follow(starts, half);
            return Ok((split, seen));
        }
        let numbers = graph.add_points(&new.iter().map(|&(p, _)| p).collect::<Vec<_>>());
        let are_apart = graph.points.len() == old as usize + new.len();
        split.made.extend(numbers.iter().zip(&new).map(|(&number, &(_, off))| (number, sum(off))));
        let place = |p: u32| if p < old { p } else { numbers[(p - old) as usize] };
        let (starts, pieces) = cut(graph, &cuts, place);
        // Pieces with the same ends come from edges that overlap, or from crossings that rounding has brought together.
        let Single { edges, half } = if all_is_known && are_apart {
            Single::as_given(pieces)
        } else {
            Single::new(graph.points.len(), &pieces, |_, _| {})
        };
        let before = std::mem::replace(&mut graph.edges, edges);
        uncut.get_or_insert(before);
        let few_are_bent = all_is_known && cuts.len() < graph.edges.len() / FEW_CUTS;
        let mut is_straight = Vec::new();
        if few_are_bent {
            let mut is_bent = vec![false; starts.len() - 1];
            cuts.iter().filter(|&&(_, p)| p >= old).for_each(|&(edge, _)| is_bent[edge as usize] = true);
            is_straight = vec![0; graph.edges.len()];
            for (pieces, _) in starts.windows(2).zip(is_bent).filter(|&(_, is_bent)| !is_bent) {
                let pieces = &half[pieces[0] as usize..pieces[1] as usize];
                pieces.iter().for_each(|piece| is_straight[(piece >> 1) as usize] = 1);
            }
        }
        split.follow(starts, half);
        if few_are_bent && let Some(seen) = look_at_bent(graph, &is_straight)? {
            return Ok((split, seen));
        }
        if let Some(made) = proved_by_faces(graph)? {
            return Ok((split, Seen::Made(Box::new(made))));
        }
        // Looking stops at the first intersection: it is the cheaper proof that there is none.
        let seen = look(graph)?;
        if seen.intersection().is_none() {
            return Ok((split, seen));
        }
    }
    let edges = uncut.unwrap_or_else(|| graph.edges.clone());
    let split = snap(graph, &Plain { split, given, edges: &edges }, grid);
    let seen = look_by_pairs(graph)?.map_or_else(|| look(graph), Ok)?;
    Ok((split, seen))
}

/// Where edges are to be cut; none if there are more than `most` crossings.
fn find_cuts(graph: &Graph, most: usize) -> Option<Cuts> {
    let mut found = Cuts { cuts: Vec::new(), new: Vec::new(), gap: None };
    let old = graph.points.len() as u32;
    let flow = visit_intersections(&graph.points, &graph.edges, graph.by_place(), |event| {
        let point = match event.place {
            EventPlace::Vertex(v) => v,
            EventPlace::Crossing(crossing) => {
                found.new.push(crossing.rounded());
                old + found.new.len() as u32 - 1
            }
        };
        found.cuts.extend(event.through.iter().map(|&edge| (edge, point)));
        if found.new.len() > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    flow.is_continue().then_some(found)
}

/// Where the pieces of each edge start, the pieces by half-edge, and a look at them.
type CutWithin = (Vec<u32>, Vec<u32>, Seen);

/// Cuts the edges at points that are all new vertices: so it is where all is farther apart than the gap. Nothing has happened if
/// a look at the pieces does not show that.
///
/// Two vertices at one place would show: what has no vertex in common is farther apart than the gap before it is rounded, and
/// neighbours have an edge without length between them.
fn cut_within(
    graph: &mut Graph,
    cuts: &[(u32, u32)],
    new: &[(Point, f64)],
    gap: Gap,
) -> Result<Option<CutWithin>, TooMany> {
    let old = graph.points.len();
    graph.points.extend(new.iter().map(|&(p, _)| Point::new(p.x + 0.0, p.y + 0.0)));
    let (starts, pieces) = cut(graph, cuts, |p| p);
    let Single { edges, half } = Single::as_given(pieces);
    let whole = std::mem::replace(&mut graph.edges, edges);
    let seen = look_within(graph, gap)?;
    if seen.is_some() {
        graph.order = Order::default();
    } else {
        graph.edges = whole;
        graph.points.truncate(old);
    }
    Ok(seen.map(|seen| (starts, half, seen)))
}

/// The pieces of all edges, and where those of each edge start. A piece has two different ends.
fn cut(graph: &Graph, cuts: &[(u32, u32)], place: impl Fn(u32) -> u32) -> (Vec<u32>, Vec<[u32; 2]>) {
    // The cuts by edge.
    let mut by_edge = Groups::new(graph.edges.len(), cuts.iter().map(|&(edge, point)| (edge as usize, place(point))));
    let mut starts = Vec::with_capacity(graph.edges.len() + 1);
    let mut pieces = Vec::with_capacity(graph.edges.len() + cuts.len());
    for (e, &[a, b]) in graph.edges.iter().enumerate() {
        starts.push(pieces.len() as u32);
        let cuts = by_edge.of_mut(e);
        let at = |v: u32| graph.points[v as usize];
        if cuts.len() > 1 && is_left_of(at(b), at(a)) {
            cuts.reverse();
        }
        let mut last = a;
        for &to in cuts.iter().chain([&b]) {
            if to != last {
                pieces.push([last, to]);
                last = to;
            }
        }
    }
    starts.push(pieces.len() as u32);
    (starts, pieces)
}

impl Split {
    /// Replaces every edge of the chains by its pieces: those of edge e are `half[starts[e]..starts[e + 1]]`.
    fn follow(&mut self, starts: Vec<u32>, half: Vec<u32>) {
        if self.rounds == 1 {
            // Every edge was its own chain.
            (self.starts, self.chain) = (starts, half);
            return;
        }
        let mut chain = Vec::with_capacity(half.len());
        let mut chain_starts = Vec::with_capacity(self.starts.len());
        for range in self.starts.windows(2) {
            chain_starts.push(chain.len() as u32);
            for &h in &self.chain[range[0] as usize..range[1] as usize] {
                let edge = (h >> 1) as usize;
                let pieces = &half[starts[edge] as usize..starts[edge + 1] as usize];
                if h & 1 == 0 {
                    chain.extend_from_slice(pieces);
                } else {
                    chain.extend(pieces.iter().rev().map(|piece| piece ^ 1));
                }
            }
        }
        chain_starts.push(chain.len() as u32);
        (self.starts, self.chain) = (chain_starts, chain);
    }
}

#[cfg(test)]
mod tests {
    use super::super::collinear::Pieces;
    use super::super::graph::Distinct;
    use super::super::trace::trace;
    use super::*;
    use crate::plane::sweep::tests::numbers;

    fn graph(segments: &[[Point; 2]]) -> Graph {
        let Distinct { points, order, number } = Distinct::new(segments.as_flattened());
        let ends: Vec<[u32; 2]> =
            number.chunks_exact(2).map(|ends| [ends[0], ends[1]]).filter(|[a, b]| a != b).collect();
        let mut graph = Graph { edges: Single::new(points.len(), &ends, |_, _| {}).edges, points, order };
        Pieces::cut(&mut graph);
        graph
    }

    /// Long segments over many short ones that do not meet: few cuts.
    fn few_cuts(next: &mut impl FnMut(u64) -> u64) -> Vec<[Point; 2]> {
        let mut segments: Vec<[Point; 2]> = Vec::new();
        for i in 0..400 + next(100) {
            let (x, y) = ((i % 20) as f64, (i / 20) as f64);
            let to = Point::new(x + 0.1 * next(8) as f64, y + 0.1 + 0.1 * next(8) as f64);
            segments.push([Point::new(x, y), to]);
        }
        for _ in 0..1 + next(3) {
            let [x, y] = [next(18), next(18)].map(|x| x as f64 + 0.3);
            segments.push([Point::new(x, y), Point::new(x + 1.0 + 0.3 * next(9) as f64, y + 0.7)]);
        }
        segments
    }

    /// Bundles of segments that are a few last places apart, across each other, and some that end near them: rounding makes
    /// some of them meet.
    fn bundles(next: &mut impl FnMut(u64) -> u64) -> Vec<[Point; 2]> {
        let mut segments: Vec<[Point; 2]> = Vec::new();
        let unit = |next: &mut dyn FnMut(u64) -> u64| next(1 << 40) as f64 / (1_u64 << 40) as f64;
        for _ in 0..2 + next(3) {
            let ends = [0; 4].map(|_| unit(next));
            // From far less than the gap to far more.
            let off = 2f64.powi(-(next(16) as i32) - 38);
            for _ in 0..1 + next(4) {
                let [a, b, c, d] = ends.map(|x| x + off * (next(9) as f64 - 4.0));
                let share = if next(3) == 0 { unit(next) } else { 1.0 };
                segments.push([Point::new(a, b), Point::new(a + share * (c - a), b + share * (d - b))]);
            }
        }
        for _ in 0..next(4) {
            let [a, b] = segments[next(segments.len() as u64) as usize];
            let (at, far) = (unit(next), [unit(next), unit(next)]);
            segments.push([Point::new(a.x + at * (b.x - a.x), a.y + at * (b.y - a.y)), far.into()]);
        }
        segments
    }

    #[test]
    fn what_is_told_by_the_gap_is_what_the_sweep_says() {
        let (mut by_gap, mut by_sweep, mut bent) = (0, 0, 0);
        for seed in 1..12_000_u64 {
            let segments = bundles(&mut numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
            let mut graph = graph(&segments);
            let Ok(cuts) = Cuts::without_sweep(&graph, &[]) else { continue };
            let mut other = graph.clone();
            let (split_one, seen_one) = split(&mut graph, None, Some(cuts)).unwrap();
            let (split_other, seen_other) = split(&mut other, None, None).unwrap();
            assert_eq!((&split_one.chain, split_one.rounds), (&split_other.chain, split_other.rounds), "seed {seed}");
            let is_by_gap = split_one.rounds == 1 && matches!(seen_one, Seen::OneRings(_));
            by_gap += u32::from(is_by_gap);
            by_sweep += u32::from(split_one.rounds == 1 && !is_by_gap);
            bent += u32::from(split_one.rounds > 1);
            assert_eq!(trace(&mut graph, seen_one).unwrap(), trace(&mut other, seen_other).unwrap(), "seed {seed}");
        }
        assert!(by_gap > 300 && by_sweep > 300 && bent > 100, "{by_gap} {by_sweep} {bent}");
    }

    /// Whether two segments have nothing but ends in common.
    fn are_free(one: [Point; 2], other: [Point; 2]) -> bool {
        let [a, b] = other;
        one != [a, b]
            && one != [b, a]
            && Cuts::without_sweep(&graph(&[one, other]), &[]).is_ok_and(|cuts| cuts.is_empty())
    }

    /// Two sets of segments that meet at common ends only, with the bit of each.
    fn two_sets(all: Vec<[Point; 2]>) -> Vec<([Point; 2], u8)> {
        let mut kept: Vec<([Point; 2], u8)> = Vec::new();
        for segment in all.into_iter().filter(|[a, b]| a != b) {
            let is_free = |set: u8| kept.iter().filter(|kept| kept.1 == set).all(|kept| are_free(kept.0, segment));
            if let Some(set) = [1, 2].into_iter().find(|&set| is_free(set)) {
                kept.push((segment, set));
            }
        }
        kept
    }

    /// Lines of one set, crossed by the other set at their beginning; far from there, segments of the first set, some of which
    /// end as near to a line as doubles can; now and then many of them in one spot.
    fn lines_far_from_their_crossings(next: &mut impl FnMut(u64) -> u64) -> Vec<([Point; 2], u8)> {
        let unit = |next: &mut dyn FnMut(u64) -> u64| next(1 << 40) as f64 / (1_u64 << 40) as f64;
        let mut lines: Vec<[Point; 2]> = Vec::new();
        for i in 0..1 + next(3) {
            let [from, to] = [0; 2].map(|_| 0.3 * i as f64 + 0.1 + 0.2 * unit(next));
            lines.push([Point::new(0.0, from), Point::new(2.0, to)]);
        }
        let across = (1..4).map(|i| {
            let x = 0.03 * i as f64 + 0.001 * unit(next);
            [Point::new(x, 0.0), Point::new(x + 0.01 * unit(next), 1.0)]
        });
        let mut kept: Vec<([Point; 2], u8)> = across.map(|segment| (segment, 2)).collect();
        let mut all: Vec<[Point; 2]> = Vec::new();
        for (column, row) in (0..500).map(|i| (i % 25, i / 25)) {
            let p = Point::new(0.2 + 0.07 * f64::from(column), 1.0 + 0.05 * f64::from(row));
            all.push([p, Point::new(p.x + 1e-3, p.y + 1e-3 * unit(next))]);
        }
        let is_spot = next(2) == 0;
        for _ in 0..if is_spot { 40 } else { 1 + next(8) } {
            let x = if is_spot { 0.3 + 0.004 * unit(next) } else { 1.0 + 0.9 * unit(next) };
            let [a, b] = lines[if is_spot { 0 } else { next(lines.len() as u64) as usize }];
            let y = a.y + x / 2.0 * (b.y - a.y);
            all.extend([1.0, -1.0].map(|side| [Point::new(x, y), Point::new(x + 1e-6 * unit(next), y + 0.01 * side)]));
        }
        if is_spot {
            // Some of the other set wherever a line comes.
            kept.extend((2..40).map(|i| {
                let p = Point::new(0.05 * f64::from(i), if i % 2 == 0 { 0.02 } else { 0.98 });
                ([p, Point::new(p.x + 1e-3, p.y)], 2)
            }));
        }
        let given = kept.len() + 500;
        for segment in all {
            let others = kept.iter().map(|kept| kept.0).skip(given);
            if lines.iter().copied().chain(others).all(|other| are_free(other, segment)) {
                kept.push((segment, 1));
            }
        }
        kept.extend(lines.into_iter().map(|line| (line, 1)));
        kept
    }

    #[test]
    fn what_is_told_by_the_gap_of_two_sets_is_what_the_sweep_says() {
        let (mut by_gap, mut by_sweep, mut bent) = ([0; 2], [0; 2], [0; 2]);
        for seed in 1..4_000_u64 {
            let next = &mut numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let kind = usize::from(seed % 8 == 0);
            let kept = if kind == 0 { two_sets(bundles(next)) } else { lines_far_from_their_crossings(next) };
            let (segments, sets): (Vec<[Point; 2]>, Vec<u8>) = kept.into_iter().unzip();
            let mut graph = graph(&segments);
            if graph.edges.len() != sets.len() {
                continue;
            }
            let Ok(cuts) = Cuts::without_sweep(&graph, &sets) else { continue };
            let mut other = graph.clone();
            let (split_one, seen_one) = split(&mut graph, None, Some(cuts)).unwrap();
            let (split_other, seen_other) = split(&mut other, None, None).unwrap();
            assert_eq!((&split_one.chain, split_one.rounds), (&split_other.chain, split_other.rounds), "seed {seed}");
            let is_by_gap = split_one.rounds == 1 && matches!(seen_one, Seen::OneRings(_));
            by_gap[kind] += u32::from(is_by_gap);
            by_sweep[kind] += u32::from(split_one.rounds == 1 && !is_by_gap);
            bent[kind] += u32::from(split_one.rounds > 1);
            assert_eq!(trace(&mut graph, seen_one).unwrap(), trace(&mut other, seen_other).unwrap(), "seed {seed}");
        }
        let enough = by_gap.iter().chain(&bent).all(|&count| count > 150) && by_sweep[0] > 300;
        assert!(enough, "{by_gap:?} {by_sweep:?} {bent:?}");
    }

    #[test]
    fn crossings_that_are_rounded_to_a_vertex_of_many_edges_are_seen() {
        // A fan to the right of a vertex, and a line across all of it, a quarter of a last place from the vertex.
        let mut fan: Vec<[Point; 2]> = (0..40)
            .map(|i| [Point::new(1.0, 1.0), Point::new(1.25, 1.0 + 0.25 * f64::from(i * 17 % 40 - 20) / 2.0)])
            .collect();
        fan.push([Point::new(1.0 - f64::EPSILON / 2.0, -2.0), Point::new(1.0 + f64::EPSILON, 4.0)]);
        let mut graph = graph(&fan);
        let mut other = graph.clone();
        let cuts = Cuts::without_sweep(&graph, &[]).unwrap();
        assert!(cuts.gap.is_some() && cuts.new.len() == 40);
        let (split_one, seen_one) = split(&mut graph, None, Some(cuts)).unwrap();
        let (split_other, seen_other) = split(&mut other, None, None).unwrap();
        assert_eq!((&split_one.chain, split_one.rounds), (&split_other.chain, split_other.rounds));
        assert_eq!(trace(&mut graph, seen_one).unwrap(), trace(&mut other, seen_other).unwrap());
    }

    #[test]
    fn cuts_and_what_comes_of_them_are_those_of_the_sweep() {
        let (mut known, mut new, mut left, mut without_sweep) = (0, 0, 0, 0);
        for seed in 1..900_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let segments = match seed % 4 {
                0 => few_cuts(&mut next),
                // Squares in rows: their crossings lie above each other up to rounding.
                1 => (0..36)
                    .flat_map(|i| {
                        let off = if i % 2 == 0 { 0.0 } else { 0.35 };
                        let (x, y) =
                            (f64::from(i / 12) + off, f64::from(i / 2 % 6) * (1.0 + (seed / 4) as f64) + 1.1 * off);
                        let corners = [(x, y), (x + 0.7, y + 0.01), (x + 0.69, y + 0.71), (x - 0.01, y + 0.7)];
                        [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]].map(Point::from))
                    })
                    .collect(),
                kind => {
                    let size = if kind == 2 { 9 } else { 1 << 30 };
                    let mut place = || Point::new(next(size) as f64 * 0.7, next(size) as f64);
                    (0..30).map(|_| [place(), place()]).collect::<Vec<_>>()
                }
            };
            let graph = graph(&segments);
            let swept = find_cuts(&graph, usize::MAX).unwrap();
            let Ok(cuts) = Cuts::without_sweep(&graph, &[]) else {
                left += 1;
                continue;
            };
            assert_eq!(cuts.new, swept.new, "seed {seed}");
            let mut by_edge = swept.cuts;
            by_edge.sort_by_key(|&(edge, _)| edge);
            let mut found = cuts.cuts.clone();
            found.sort_by_key(|&(edge, _)| edge);
            assert_eq!(found, by_edge, "seed {seed}");
            known += 1;
            new += cuts.new.len();

            let few = cuts.cuts.len() < graph.edges.len() / FEW_CUTS;
            let (mut one, mut other) = (graph.clone(), graph);
            let (split_one, seen_one) = split(&mut one, None, None).unwrap();
            let (split_other, seen_other) = split(&mut other, None, Some(cuts)).unwrap();
            assert_eq!(split_one.chain, split_other.chain, "seed {seed}");
            assert_eq!((split_one.made, split_one.rounds), (split_other.made, split_other.rounds), "seed {seed}");
            without_sweep += u32::from(few && matches!(seen_other, Seen::OneRings(_)));
            assert_eq!(trace(&mut one, seen_one).unwrap(), trace(&mut other, seen_other).unwrap(), "seed {seed}");
        }
        assert!(known > 500 && new > 20_000 && without_sweep > 100, "{known} {new} {left} {without_sweep}");
    }
}
