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
use super::graph::{Graph, Single};
use super::snap::{Plain, snap};
use super::trace::{OneRings, look};
use crate::geometry::grouping::Groups;
use crate::geometry::predicates::left_to_right;
use crate::plane::Point;
use crate::plane::meet::{EventPlace, Grid, visit_intersections};
use crate::plane::sweep::Swept;
use crate::topology::TooMany;
use std::ops::ControlFlow;

/// Rounds after which a grid is used. One or two are usual.
const PLAIN_ROUNDS: u32 = 4;

/// Splits the edges of `graph` until nothing meets; on the grid, if there is one, else in place where that settles. Also
/// gives what the last look at the graph, the one that found nothing, has seen.
///
/// Cost: O((n + k) log n) a round, with k intersections; see [`snap`] for the grid.
///
/// # Errors
/// If there are more half-edges than ids.
pub(super) fn split(graph: &mut Graph, grid: Option<Grid>) -> Result<(Split, (OneRings, Swept)), TooMany> {
    let given = graph.points.len();
    let edges = graph.edges.clone();
    let mut split = Split::none(edges.len());
    while grid.is_none() && split.rounds < PLAIN_ROUNDS {
        // Bent edges that cross more often than there are edges do not settle: every round would find still more.
        let most = if split.rounds == 0 { usize::MAX } else { graph.edges.len() };
        let Some(Cuts { cuts, new }) = find_cuts(graph, most) else { break };
        if cuts.is_empty() {
            return Ok((split, look(graph)?));
        }
        split.rounds += 1;
        let old = graph.points.len() as u32;
        let numbers = graph.add_points(&new.iter().map(|&(p, _)| p).collect::<Vec<_>>());
        // The edges that cross here are bent themselves, by the rounds before.
        let bent = split.farthest;
        let sum = |off: f64| if bent > 0.0 { (bent + off).next_up() } else { off };
        split.made.extend(numbers.iter().zip(&new).map(|(&number, &(_, off))| (number, sum(off))));
        // The edges of this round are no further from those of the input than the bends of all rounds together.
        let off = new.iter().map(|&(_, off)| off).fold(0.0, f64::max);
        if off > 0.0 {
            split.farthest = (split.farthest + off).next_up();
        }
        let place = |p: u32| if p < old { p } else { numbers[(p - old) as usize] };
        let (starts, pieces) = cut(graph, &cuts, place);
        let Single { edges, half } = Single::new(graph.points.len(), &pieces, |_, _| {});
        graph.edges = edges;
        split.follow(&starts, &half);
        // Looking stops at the first intersection: it is the cheaper proof that there is none.
        let seen = look(graph)?;
        if seen.1.intersection.is_none() {
            return Ok((split, seen));
        }
    }
    let split = snap(graph, &Plain { split, given, edges: &edges }, grid);
    Ok((split, look(graph)?))
}

/// The cuts of one round.
struct Cuts {
    /// Edges with the points where they are to be cut, in the order of the sweep. Points from the number of the
    /// graph's points on are new.
    cuts: Vec<(u32, u32)>,
    /// The new points, and how far each is from its crossing.
    new: Vec<(Point, f64)>,
}

/// Where edges are to be cut; none if there are more than `most` crossings.
fn find_cuts(graph: &Graph, most: usize) -> Option<Cuts> {
    let mut found = Cuts { cuts: Vec::new(), new: Vec::new() };
    let old = graph.points.len() as u32;
    let flow = visit_intersections(&graph.points, &graph.edges, &graph.by_place, |event| {
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
        if left_to_right(at(a), at(b)).is_gt() {
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
