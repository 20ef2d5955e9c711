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
use super::graph::{Distinct, Graph, Single};
use super::pixels::Pixels;
use crate::geometry::grouping::Joined;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::plane::meet::{EventPlace, Grid, visit_intersections};
use std::ops::ControlFlow;

/// So often parts are added one after another; then all are rounded.
const GENTLE: u32 = 3;

/// What splitting in place has reached.
pub(super) struct Plain<'a> {
    pub(super) split: Split,
    /// How many points were there before, and the edges.
    pub(super) given: usize,
    pub(super) edges: &'a [[u32; 2]],
}

/// Rounds the parts of the graph in which edges meet; all of it if there is a `grid`. The graph becomes the result.
///
/// Cost: O((n + k) log n) for n edges with k crossings that are not yet rounded, O(√n) for each long edge, and the length of
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

fn round(graph: &Graph, plain: &Plain<'_>, parts: &mut Parts, grid: Option<Grid>) -> Made {
    let given = plain.given as u32;
    let chosen: Vec<bool> = (0..graph.points.len() as u32).map(|p| parts.is_chosen(p)).collect();
    let at = |p: u32| graph.points[p as usize];
    let grid = grid.unwrap_or_else(|| {
        let reach = |p: u32| at(p).x.abs().max(at(p).y.abs());
        Grid::finest((0..given).filter(|&p| chosen[p as usize]).map(reach).fold(0.0, f64::max))
    });
    let (pixels, off) = hot_pixels(graph, plain, &chosen, grid);

    // The points: those given, those of crossings that stay, the middles.
    let mut places: Vec<Point> =
        (0..given).map(|p| if chosen[p as usize] { grid.place(at(p)) } else { at(p) }).collect();
    let stays: Vec<u32> = (given..graph.points.len() as u32).filter(|&p| !chosen[p as usize]).collect();
    places.extend(stays.iter().map(|&p| at(p)));
    let first_middle = places.len();
    places.extend_from_slice(&pixels.middles);
    let Distinct { points, order, number } = Distinct::new(&places);
    let middle = |pixel: u32| number[first_middle + pixel as usize];
    let mut now: Vec<u32> = number[..plain.given].to_vec();
    now.resize(graph.points.len(), u32::MAX);
    stays.iter().zip(&number[plain.given..]).for_each(|(&p, &n)| now[p as usize] = n);

    let mut starts = Vec::with_capacity(plain.edges.len() + 1);
    let mut pieces: Vec<[u32; 2]> = Vec::new();
    let mut passed = Vec::new();
    let mut bends = false;
    for (e, &[a, b]) in plain.edges.iter().enumerate() {
        starts.push(pieces.len() as u32);
        if chosen[a as usize] {
            pixels.passed(at(a), at(b), &mut passed);
            bends |= passed.iter().any(|&pixel| orientation(at(a), at(b), pixels.middles[pixel as usize]).is_ne());
            pieces.extend(passed.windows(2).map(|pair| [middle(pair[0]), middle(pair[1])]));
        } else {
            let range = plain.split.starts[e] as usize..plain.split.starts[e + 1] as usize;
            pieces.extend(plain.split.chain[range].iter().map(|&h| {
                let [a, b] = graph.edges[(h >> 1) as usize].map(|p| now[p as usize]);
                if h & 1 == 0 { [a, b] } else { [b, a] }
            }));
        }
    }
    starts.push(pieces.len() as u32);
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

/// The pixels with a point or a crossing of the chosen parts, and for those with crossings how far the furthest of these
/// is from the middle.
fn hot_pixels(graph: &Graph, plain: &Plain<'_>, chosen: &[bool], grid: Grid) -> (Pixels, Vec<(u32, f64)>) {
    let is_given = |p: u32| (p as usize) < plain.given && chosen[p as usize];
    let by_place: Vec<u32> = graph.by_place().iter().copied().filter(|&p| is_given(p)).collect();
    let edges: Vec<[u32; 2]> = plain.edges.iter().copied().filter(|&[a, _]| chosen[a as usize]).collect();
    let mut crossings: Vec<(Point, f64)> = Vec::new();
    let _ = visit_intersections(&graph.points, &edges, &by_place, |event| {
        if let EventPlace::Crossing(crossing) = event.place {
            let (middle, off) = crossing.on_grid(grid);
            // Crossings come from left to right: in a bundle many follow each other in one pixel.
            match crossings.last_mut() {
                Some(last) if last.0 == middle => last.1 = last.1.max(off),
                _ => crossings.push((middle, off)),
            }
        }
        ControlFlow::Continue(())
    });
    let mut middles: Vec<Point> = by_place.iter().map(|&p| grid.place(graph.points[p as usize])).collect();
    middles.extend(crossings.iter().map(|&(p, _)| p));
    middles.sort_unstable_by(|&p, &q| left_to_right(p, q));
    middles.dedup();
    let pixels = Pixels::new(grid, middles);
    let off = crossings.iter().filter_map(|&(p, off)| Some((pixels.of(p)?, off))).collect();
    (pixels, off)
}
