//! Snap rounding: everything that meets is rounded to a grid, and nothing crosses any more.
//!
//! ```text
//!   ┆ ●╲┆   ┆ ╱●┆          ┆ ●╲┆   ┆ ╱●┆         Hot are the pixels with an end or a crossing of segments in them.
//!   ┄┄┄╲┄┄┄┄╱┄┄┄    ──>    ┄┄┄┄╲┄┄╱┄┄┄┄          Every segment becomes the chain of the middles of the hot pixels
//!   ┆   ┆╲╱ ┆   ┆          ┆   ┆ ●┆   ┆          that it passes, in its order.
//!   ┄┄┄┄┄╱╲┄┄┄┄┄           ┄┄┄┄╱┄┄╲┄┄┄┄
//! ```
//!
//! Why once is enough: see [`ArrangeOptions`](crate::plane::ArrangeOptions).
//!
//! Grid points and the sides of pixels are doubles (see [`Grid`]), and whether a segment passes a pixel, and in which one
//! a crossing lies, is decided exactly. No chain is further from its segment than half the diagonal of a pixel.
//!
//! Only the parts of the input are rounded in which edges still meet, and those that meet what they have become.
//!
//! Source: Hobby, *Practical segment intersection with finite precision output*, Computational Geometry 13, 1999; Guibas
//! and Marimont, *Rounding arrangements dynamically*, 1998; Goodrich, Guibas, Hershberger and Tanenbaum, *Snap rounding
//! line segments efficiently in two and three dimensions*, 1997.

use super::chains::{Snapped, Split};
use super::crossed::{what_meets, without_edge};
use super::graph::{Distinct, Graph, Single};
use super::pixels::Pixels;
use crate::geometry::both::of_both;
use crate::geometry::grouping::Joined;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::geometry::threads;
use crate::plane::Point;
use crate::plane::meet::{Crossed, EventPlace, Grid, Meetings, visit_intersections};
use crate::plane::sweep::rightwards;
use std::ops::ControlFlow;

/// So often parts are added one after another; then all are rounded.
const GENTLE: u32 = 3;

/// So many crossings, or edges, are a piece of work.
const PIECE: usize = 1 << 12;

/// What splitting in place has reached.
pub(super) struct Plain<'a> {
    pub(super) split: Split,
    /// How many points were there before, and the edges.
    pub(super) given: usize,
    pub(super) edges: &'a [[u32; 2]],
}

/// Rounds the parts of the graph in which edges meet; all of it if there is a `grid`. The graph becomes the result.
///
/// Cost: O((n + k) log n) for n edges with k crossings that are not yet rounded, found without a sweep where edges are about as
/// long as they are apart; O(√n) for each long edge, and the length of
/// all chains: in a bundle of edges that run along each other, each of them passes the crossings of all.
pub(super) fn snap(graph: &mut Graph, plain: &Plain<'_>, grid: Option<Grid>) -> Split {
    let mut parts = Parts::new(graph);
    if grid.is_some() {
        parts.choose_all();
    } else {
        parts.choose(meeting_points(graph));
    }
    for attempt in 1.. {
        if attempt == GENTLE {
            parts.choose_all();
        }
        let made = round(graph, plain, &mut parts, grid);
        let missed = if parts.all { Vec::new() } else { meeting_points(&made.graph) };
        if missed.is_empty() {
            *graph = made.graph;
            return made.split;
        }
        parts.choose(missed.into_iter().filter_map(|v| made.origin[v as usize]).collect());
    }
    unreachable!("rounding everything ends it")
}

/// The connected parts of a graph, and which of them are to be rounded.
struct Parts {
    joined: Joined,
    /// By root.
    chosen: Vec<bool>,
    all: bool,
}

impl Parts {
    fn new(graph: &Graph) -> Self {
        let mut joined = Joined::none(graph.points.len());
        for &[a, b] in &graph.edges {
            joined.join(a, b);
        }
        Self { chosen: vec![false; graph.points.len()], joined, all: false }
    }

    fn choose_all(&mut self) {
        self.all = true;
    }

    /// Chooses the parts of points. If they are all chosen already, everything.
    fn choose(&mut self, points: Vec<u32>) {
        let mut news = false;
        for p in points {
            let root = self.joined.root(p) as usize;
            news |= !std::mem::replace(&mut self.chosen[root], true);
        }
        self.all |= !news;
    }

    fn is_chosen(&mut self, p: u32) -> bool {
        self.all || self.chosen[self.joined.root(p) as usize]
    }
}

/// Points of all edges that meet others where they should not, and of the points on them. Where they meet more often than
/// there are edges, the first ones: what is missed is looked for again.
fn meeting_points(graph: &Graph) -> Vec<u32> {
    let mut points = Vec::new();
    let most = 4 * graph.edges.len() + 4;
    let _ = visit_intersections(&graph.points, &graph.edges, graph.by_place(), |event| {
        points.extend(event.through.iter().map(|&e| graph.edges[e as usize][0]));
        if let EventPlace::Vertex(v) = event.place {
            points.push(v);
        }
        if points.len() > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    points
}

/// A graph with the chosen parts on the grid.
struct Made {
    graph: Graph,
    split: Split,
    /// By point of the graph: the one of the graph before, if it was not rounded.
    origin: Vec<Option<u32>>,
}

/// What some edges become.
#[derive(Clone, Default)]
struct Chains {
    /// The ends of the pieces, edge by edge.
    ends: Vec<[u32; 2]>,
    /// By edge, how many pieces there are up to its last one.
    lengths: Vec<u32>,
    /// Whether an edge bends.
    bend: bool,
}

/// What all edges become: where the pieces of each start, the ends of all of them, and whether an edge bends.
fn chains(edges: usize, add: impl Fn(usize, &mut Vec<u32>, &mut Chains) + Sync) -> (Vec<u32>, Vec<[u32; 2]>, bool) {
    let mut groups = vec![Chains::default(); edges.div_ceil(PIECE)];
    threads::pieces(&mut groups, 1, |first, groups| {
        let mut found = Vec::new();
        for (first, group) in (first * PIECE..).step_by(PIECE).zip(groups) {
            (first..edges.min(first + PIECE)).for_each(|e| add(e, &mut found, group));
        }
    });
    let bends = groups.iter().any(|group| group.bend);
    let mut starts = Vec::with_capacity(edges + 1);
    let mut pieces: Vec<[u32; 2]> = Vec::with_capacity(groups.iter().map(|group| group.ends.len()).sum());
    starts.push(0);
    for group in groups {
        starts.extend(group.lengths.iter().map(|length| pieces.len() as u32 + length));
        pieces.extend(group.ends);
    }
    (starts, pieces, bends)
}

fn round(graph: &Graph, plain: &Plain<'_>, parts: &mut Parts, grid: Option<Grid>) -> Made {
    let given = plain.given as u32;
    let chosen: Vec<bool> = (0..graph.points.len() as u32).map(|p| parts.is_chosen(p)).collect();
    let Graph { points: before, edges: cut, .. } = graph;
    let at = |p: u32| before[p as usize];
    let grid = grid.unwrap_or_else(|| {
        let reach = |p: u32| at(p).x.abs().max(at(p).y.abs());
        Grid::finest((0..given).filter(|&p| chosen[p as usize]).map(reach).fold(0.0, f64::max))
    });
    let (middles, off) = hot_pixels(graph, plain, &chosen, grid);

    // The points: those given, those of crossings that stay, the middles.
    let mut places: Vec<Point> =
        (0..given).map(|p| if chosen[p as usize] { grid.place(at(p)) } else { at(p) }).collect();
    let stays: Vec<u32> = (given..graph.points.len() as u32).filter(|&p| !chosen[p as usize]).collect();
    places.extend(stays.iter().map(|&p| at(p)));
    let first_middle = places.len();
    places.extend_from_slice(&middles);
    let (pixels, Distinct { points, order, number }) =
        threads::both(|| Pixels::new(grid, middles), || Distinct::without_order(&places));
    let middle = |pixel: u32| number[first_middle + pixel as usize];
    let mut now: Vec<u32> = number[..plain.given].to_vec();
    now.resize(graph.points.len(), u32::MAX);
    stays.iter().zip(&number[plain.given..]).for_each(|(&p, &n)| now[p as usize] = n);

    let piece = |e: usize, found: &mut Vec<u32>, pieces: &mut Chains| {
        let [a, b] = plain.edges[e];
        if chosen[a as usize] {
            pixels.passed(at(a), at(b), found);
            let is_off = |&pixel: &u32| orientation(at(a), at(b), pixels.middles[pixel as usize]).is_ne();
            pieces.bend = pieces.bend || found.iter().any(is_off);
            pieces.ends.extend(found.windows(2).map(|pair| [middle(pair[0]), middle(pair[1])]));
        } else {
            let range = plain.split.starts[e] as usize..plain.split.starts[e + 1] as usize;
            pieces.ends.extend(plain.split.chain[range].iter().map(|&h| {
                let [a, b] = cut[(h >> 1) as usize].map(|p| now[p as usize]);
                if h & 1 == 0 { [a, b] } else { [b, a] }
            }));
        }
        pieces.lengths.push(pieces.ends.len() as u32);
    };
    let (starts, pieces, bends) = chains(plain.edges.len(), piece);
    let Single { edges, half } = Single::new(points.len(), &pieces, |_, _| {});

    let kept_made = plain.split.made.iter().filter(|&&(p, _)| !chosen[p as usize]);
    let mut made: Vec<(u32, f64)> = kept_made.map(|&(p, by)| (now[p as usize], by)).collect();
    made.extend(off.iter().map(|&(pixel, by)| (middle(pixel), by)));
    let moved = |p: u32| {
        let (from, to) = (at(p), places[p as usize]);
        (number[p as usize], (to.x - from.x).hypot(to.y - from.y))
    };
    let displaced: Vec<(u32, f64)> = (0..given).map(moved).filter(|&(_, by)| by > 0.0).collect();
    // Where a crossing is not in the middle of its pixel, the middle is not on both of its segments: one of them bends.
    let is_moved = bends || !displaced.is_empty();
    let mut origin = vec![None; points.len()];
    for p in (0..graph.points.len() as u32).filter(|&p| !chosen[p as usize]) {
        origin[now[p as usize] as usize] = Some(p);
    }
    let farthest = if parts.all { 0.0 } else { plain.split.farthest };
    let of_given = number[..plain.given].iter().max().map_or(0, |&last| last as usize + 1);
    Made {
        graph: Graph { points, edges, order },
        split: Split {
            starts,
            chain: half,
            made,
            rounds: plain.split.rounds + 1,
            farthest: if is_moved { grid.half_diagonal().max(farthest) } else { farthest },
            snapped: Some(Snapped { grid, number: number[..plain.given].to_vec(), given: of_given, displaced }),
        },
        origin,
    }
}

/// The middles of the pixels with a point or a crossing of the chosen parts, from left to right, and for those with crossings
/// off the middle how far the furthest of these is from it.
fn hot_pixels(graph: &Graph, plain: &Plain<'_>, chosen: &[bool], grid: Grid) -> (Vec<Point>, Vec<(u32, f64)>) {
    let is_given = |p: u32| (p as usize) < plain.given && chosen[p as usize];
    let by_place: Vec<u32> = graph.by_place().iter().copied().filter(|&p| is_given(p)).collect();
    let edges: Vec<[u32; 2]> = plain.edges.iter().copied().filter(|&[a, _]| chosen[a as usize]).collect();
    let crossings = match crossings_of_pairs(&graph.points, &edges, &by_place, grid) {
        Some(crossings) => crossings,
        None => crossings_of_sweep(&graph.points, &edges, &by_place, grid),
    };
    // Every pixel once, with the greatest distance of a crossing in it.
    let mut hot: Crossings = by_place.iter().map(|&p| (grid.place(graph.points[p as usize]), 0.0)).collect();
    hot.extend(crossings);
    hot.sort_unstable_by(|p, q| left_to_right(p.0, q.0).then(q.1.total_cmp(&p.1)));
    hot.dedup_by_key(|pixel| pixel.0);
    let off = (0..).zip(&hot).filter(|(_, pixel)| pixel.1 > 0.0).map(|(i, pixel)| (i, pixel.1)).collect();
    (hot.into_iter().map(|(middle, _)| middle).collect(), off)
}

/// The middles of the pixels with crossings, and how far these are from there at most.
type Crossings = Vec<(Point, f64)>;

/// The crossings that a sweep meets, from left to right.
fn crossings_of_sweep(points: &[Point], edges: &[[u32; 2]], by_place: &[u32], grid: Grid) -> Crossings {
    let mut crossings = Crossings::new();
    let _ = visit_intersections(points, edges, by_place, |event| {
        if let EventPlace::Crossing(crossing) = event.place {
            add(&mut crossings, crossing, grid);
        }
        ControlFlow::Continue(())
    });
    crossings
}

/// The crossings of pairs of edges, where these can be found without a sweep. A crossing of more than two edges is
/// there for each pair of them.
fn crossings_of_pairs(points: &[Point], edges: &[[u32; 2]], given: &[u32], grid: Grid) -> Option<Crossings> {
    let edges = rightwards(points, edges);
    let loose = without_edge(points.len(), given.iter().copied(), &edges);
    let (Meetings { crossings: pairs, .. }, _) = what_meets(points, &edges, &loose, &[]).ok()?;
    let ends = |e: u32| of_both(edges[e as usize], |p| points[p as usize]);
    let mut pieces: Vec<(&[[u32; 2]], Crossings)> = pairs.chunks(PIECE).map(|pairs| (pairs, Vec::new())).collect();
    threads::pieces(&mut pieces, 1, |_, pieces| {
        for (pairs, crossings) in pieces {
            pairs.iter().for_each(|&[one, other]| add(crossings, &Crossed::new(ends(one), ends(other)), grid));
        }
    });
    Some(pieces.into_iter().flat_map(|(_, crossings)| crossings).collect())
}

/// Adds a crossing; in a bundle many follow each other in one pixel.
fn add(crossings: &mut Crossings, crossing: &Crossed, grid: Grid) {
    let (middle, off) = crossing.on_grid(grid);
    match crossings.last_mut() {
        Some(last) if last.0 == middle => last.1 = last.1.max(off),
        _ => crossings.push((middle, off)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::collinear::Pieces;
    use super::*;
    use crate::plane::sweep::tests::numbers;

    /// The greatest distance in each pixel.
    fn by_pixel(mut crossings: Crossings) -> Crossings {
        crossings.sort_by(|p, q| left_to_right(p.0, q.0).then(q.1.total_cmp(&p.1)));
        crossings.dedup_by_key(|crossing| crossing.0);
        crossings
    }

    #[test]
    fn pairs_of_edges_and_a_sweep_give_the_same_pixels() {
        let (mut two, mut more, mut without, mut at_points) = (0, 0, 0, 0);
        for seed in 1..3_000_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            // Of few places, so that many edges cross in one point, and at points of others; or of many.
            let range = [5, 9, 1 << 30][seed as usize % 3];
            let mut place = || Point::new(next(range) as f64, next(range) as f64);
            let places: Vec<Point> = (0..30).map(|_| place()).collect();
            let Distinct { points, order, number } = Distinct::new(&places);
            let ends: Vec<[u32; 2]> =
                number[..24].chunks_exact(2).map(|ends| [ends[0], ends[1]]).filter(|[a, b]| a != b).collect();
            let mut graph = Graph { edges: Single::new(points.len(), &ends, |_, _| {}).edges, points, order };
            Pieces::cut(&mut graph);
            let grid = Grid::of([0.25, 1.0, 2f64.powi(-20), 64.0][seed as usize / 3 % 4]).unwrap();
            let Graph { points, edges, .. } = &graph;
            let Some(pairs) = crossings_of_pairs(points, edges, graph.by_place(), grid) else {
                without += 1;
                continue;
            };
            let mut events = 0;
            let _ = visit_intersections(points, edges, graph.by_place(), |event| {
                match event.place {
                    EventPlace::Crossing(_) if event.through.len() == 2 => two += 1,
                    EventPlace::Crossing(_) => more += 1,
                    EventPlace::Vertex(_) => at_points += u32::from(event.through.len() > 1),
                }
                events += 1;
                ControlFlow::Continue(())
            });
            let swept = by_pixel(crossings_of_sweep(points, edges, graph.by_place(), grid));
            let pairs = by_pixel(pairs);
            assert!(swept.len() <= events && swept.len() == pairs.len(), "seed {seed}: {swept:?} {pairs:?}");
            for (one, other) in swept.iter().zip(&pairs) {
                // A crossing of more than two edges is known from any two of them, up to a few last places.
                let is_near = (one.1 - other.1).abs() <= 1e-14 * range as f64;
                assert!(one.0 == other.0 && is_near, "seed {seed}: {one:?} {other:?}");
            }
        }
        assert!(two > 20_000 && more > 300 && at_points > 300 && without < 30, "{two} {more} {at_points} {without}");
    }
}
