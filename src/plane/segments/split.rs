//! Splitting segments where they meet, until nothing meets but at common ends.
//!
//! ```text
//!     round 1: all meetings of the       the crossings are rounded     round 2: the new edges are looked at as
//!     given segments, exactly            to doubles: edges bend        exactly; if a bend runs over something,
//!          ╲   ╱                              ╲   ╱                     that is a meeting, too, and is split
//!           ╲ ╱                                ╲_╱
//!           ╱ ╲                                ╱ ╲                      ... until a round finds nothing
//! ```
//!
//! Points of the input never move; a crossing moves to the nearest doubles. So the last round is the proof that the
//! result has no meetings, whatever was rounded before.
//!
//! In bundles of lines a few last bits apart, every round may make new crossings between the doubles. From the fifth
//! round on a vertex therefore attracts the edges that pass it, above or below and in the next round left or right,
//! within one last place of its coordinates; later within 2, 4, 8, ...
//!
//! Source: the rounding of crossings, the bending of edges and vertices that attract them are those of Hobby,
//! *Practical segment intersection with finite precision output*, 1999.

use super::error::SegmentsError;
use super::graph::{Graph, Single};
use crate::plane::Point;
use crate::plane::meet::{Spot, all_meetings};
use crate::plane::predicates::left_to_right;
use std::ops::ControlFlow;

/// Rounds after which splitting gives up. One or two are usual.
const MOST_ROUNDS: u32 = 40;
/// Rounds in which vertices attract nothing.
const PLAIN_ROUNDS: u32 = 4;

/// What became of the edges of a graph.
pub(super) struct Split {
    /// Where the chain of each edge starts in `chain`, and the end.
    pub(super) starts: Vec<u32>,
    /// Half-edges of the new edges, one chain after another: twice the edge, plus 1 against its direction.
    pub(super) chain: Vec<u32>,
    /// The points made for crossings, and how far each lies from its crossing.
    pub(super) made: Vec<(u32, f64)>,
    pub(super) rounds: u32,
}

impl Split {
    /// Every edge is its own chain.
    pub(super) fn none(edges: usize) -> Self {
        Self {
            starts: (0..=edges as u32).collect(),
            chain: (0..edges as u32).map(|e| 2 * e).collect(),
            made: Vec::new(),
            rounds: 0,
        }
    }
}

/// Splits the edges of `graph` until nothing meets. O((n + k) log n) a round, with k meetings.
pub(super) fn split(graph: &mut Graph) -> Result<Split, SegmentsError> {
    let mut split = Split::none(graph.edges.len());
    loop {
        let Cuts { cuts, new } = find_cuts(graph, split.rounds);
        if cuts.is_empty() {
            return Ok(split);
        }
        if split.rounds == MOST_ROUNDS {
            let (first, old) = (cuts[0].1, graph.points.len() as u32);
            let near = if first < old { graph.points[first as usize] } else { new[(first - old) as usize].0 };
            return Err(SegmentsError::Unsettled { rounds: split.rounds, near });
        }
        split.rounds += 1;
        let old = graph.points.len() as u32;
        let numbers = graph.add_points(&new.iter().map(|&(p, _)| p).collect::<Vec<_>>());
        for (&number, &(_, off)) in numbers.iter().zip(&new) {
            split.made.push((number, off));
        }
        let place = |p: u32| if p < old { p } else { numbers[(p - old) as usize] };
        let (starts, pieces) = cut(graph, &cuts, place);
        let Single { edges, half } = Single::new(graph.points.len(), &pieces, |_, _| {});
        graph.edges = edges;
        split.follow(&starts, &half);
    }
}

/// The cuts of one round.
struct Cuts {
    /// Edges with the points where they are to be cut, in the order of the sweep. Points from the number of the
    /// graph's points on are new.
    cuts: Vec<(u32, u32)>,
    /// The new points, and how far each is from its crossing.
    new: Vec<(Point, f64)>,
}

fn find_cuts(graph: &Graph, round: u32) -> Cuts {
    let mut found = Cuts { cuts: Vec::new(), new: Vec::new() };
    let old = graph.points.len() as u32;
    let turned = Turned::new(graph, round);
    let (points, by_place) = turned.as_ref().map_or((&graph.points, &graph.by_place), |t| (&t.points, &t.by_place));
    let reach = if round < PLAIN_ROUNDS { 0.0 } else { f64::from((round - PLAIN_ROUNDS) / 4).exp2() };
    let mut meetings = 0;
    let _ = all_meetings(points, &graph.edges, by_place, reach, |stop| {
        let point = match stop.spot {
            Spot::Vertex(v) => v,
            Spot::Crossing(crossing) => {
                let (p, off) = crossing.rounded();
                found.new.push((if turned.is_some() { Point::new(p.y, p.x) } else { p }, off));
                old + found.new.len() as u32 - 1
            }
        };
        meetings += stop.through.len();
        let near = stop.near.iter().filter(|&&edge| graph.is_beside(edge, point));
        found.cuts.extend(stop.through.iter().chain(near).map(|&edge| (edge, point)));
        ControlFlow::Continue(())
    });
    if meetings == 0 {
        found.cuts.clear();
    }
    found
}

/// The graph with x and y exchanged, for every second of the rounds in which vertices attract.
struct Turned {
    points: Vec<Point>,
    by_place: Vec<u32>,
}

impl Turned {
    fn new(graph: &Graph, round: u32) -> Option<Self> {
        if round < PLAIN_ROUNDS || (round - PLAIN_ROUNDS).is_multiple_of(2) {
            return None;
        }
        let points: Vec<Point> = graph.points.iter().map(|p| Point::new(p.y, p.x)).collect();
        let mut by_place = graph.by_place.clone();
        by_place.sort_by(|&p, &q| left_to_right(points[p as usize], points[q as usize]));
        Some(Self { points, by_place })
    }
}

impl Graph {
    /// How far along the edge the point lies, in some unit: rounding keeps the order of points that follow each other
    /// in x and in y.
    fn along(&self, edge: u32, p: Point) -> f64 {
        let [a, b] = self.edges[edge as usize].map(|v| self.points[v as usize]);
        (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)
    }

    /// Whether a point near the line of the edge lies beside the edge, not behind one of its ends.
    fn is_beside(&self, edge: u32, point: u32) -> bool {
        let [_, b] = self.edges[edge as usize];
        let [p, b] = [point, b].map(|v| self.points[v as usize]);
        let along = self.along(edge, p);
        along > 0.0 && along < self.along(edge, b)
    }
}

/// The pieces of all edges, and where those of each edge start. A piece has two different ends.
fn cut(graph: &Graph, cuts: &[(u32, u32)], place: impl Fn(u32) -> u32) -> (Vec<u32>, Vec<[u32; 2]>) {
    // The cuts by edge.
    let mut firsts = vec![0_u32; graph.edges.len() + 1];
    cuts.iter().for_each(|&(edge, _)| firsts[edge as usize + 1] += 1);
    (0..graph.edges.len()).for_each(|e| firsts[e + 1] += firsts[e]);
    let mut next = firsts.clone();
    let mut by_edge = vec![0; cuts.len()];
    for &(edge, point) in cuts {
        by_edge[next[edge as usize] as usize] = place(point);
        next[edge as usize] += 1;
    }
    let mut starts = Vec::with_capacity(graph.edges.len() + 1);
    let mut pieces = Vec::with_capacity(graph.edges.len() + cuts.len());
    for (edge, (&[a, b], range)) in graph.edges.iter().zip(firsts.windows(2)).enumerate() {
        starts.push(pieces.len() as u32);
        let cuts = &mut by_edge[range[0] as usize..range[1] as usize];
        let at = |v: u32| graph.points[v as usize];
        if left_to_right(at(a), at(b)).is_gt() {
            cuts.reverse();
        }
        // Exactly in order, unless vertices attracted the edge.
        cuts.sort_by(|&u, &v| graph.along(edge as u32, at(u)).total_cmp(&graph.along(edge as u32, at(v))));
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
    fn follow(&mut self, starts: &[u32], half: &[u32]) {
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
