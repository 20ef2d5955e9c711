//! The first cuts of all edges, from the pairs of edges that meet: without a sweep.
//!
//! ```text
//!      ╲  ╱ ╱        pairs of edges that cross, each rounded by itself; then all from left to right. Rounding keeps
//!       ●╱ ╱         that order, so that only those with the same x after it are compared exactly.
//!       ╱╲╱
//!      ╱ ╱╲
//! ```
//!
//! Three edges through one point would be one cut, not three: they are left to the sweep.

use super::angles::{AT_ONCE, sort_by};
use super::graph::Graph;
use crate::geometry::both::of_both;
use crate::geometry::grouping::Groups;
use crate::geometry::places::by_coordinate;
use crate::geometry::predicates::{left_to_right, sort_key};
use crate::plane::Point;
use crate::plane::meet::{Crossed, Gap, Meetings, NoMeetings, is_moved, meetings, placed as placed_at};
use crate::plane::sweep::rightwards;

/// The cuts of one round.
pub(super) struct Cuts {
    /// Edges with the points where they are to be cut, those of one edge from left to right. Points from the number of the
    /// graph's points on are new.
    pub(super) cuts: Vec<(u32, u32)>,
    /// The new points from left to right, as they were before rounding, and how far each is from its crossing.
    pub(super) new: Vec<(Point, f64)>,
    /// Edges that cross something are farther than this from all that they have no point in common with, if that is known.
    pub(super) gap: Option<Gap>,
}

impl Cuts {
    /// The cuts of a graph, as a sweep over it gives them. `sets[e]` has a bit for each set of edges that meet at common
    /// ends only and that edge e belongs to.
    ///
    /// # Errors
    /// [`NoMeetings`]: the sweep has to find them.
    pub(super) fn without_sweep(graph: &Graph, sets: &[u8]) -> Result<Self, NoMeetings> {
        let Graph { points, edges, .. } = graph;
        let edges = rightwards(points, edges);
        let loose = without_edge(points.len(), 0..points.len() as u32, &edges);
        let (Meetings { crossings, touches, gap }, touched) = what_meets(points, &edges, &loose, sets)?;
        let ends = |e: u32| of_both(edges[e as usize], |p| points[p as usize]);
        let both = |[e, g]: [u32; 2]| [ends(e), ends(g)];
        let placed = placed_all(&crossings, both);
        let order = from_left_to_right(&placed, |i| both(crossings[i as usize])).ok_or(NoMeetings::LeftToSweep)?;

        let new = order.iter().map(|&i| placed[i as usize]).map(|(p, off, _)| (p, off)).collect();
        let old = points.len() as u32;
        let mut cuts: Vec<(u32, u32)> = Vec::with_capacity(2 * order.len() + touches.len());
        for (number, &i) in (old..).zip(&order) {
            let [one, other] = crossings[i as usize];
            cuts.push((one, number));
            cuts.push((other, number));
        }
        let Some(touched) = touched else { return Ok(Self { cuts, new, gap }) };
        cuts.extend(touches.iter().map(|&[edge, point]| (edge, point)));
        let compare = |one: u32, other: u32| {
            let known = |p: u32| points.get(p as usize).copied();
            let crossed = |p: u32| {
                let [one, other] = both(crossings[order[(p - old) as usize] as usize]);
                Crossed::new(one, other)
            };
            match (known(one), known(other)) {
                (Some(p), Some(q)) => left_to_right(p, q),
                (None, None) => one.cmp(&other),
                (None, Some(q)) => crossed(one).order_to_point(q),
                (Some(p), None) => crossed(other).order_to_point(p).reverse(),
            }
        };
        let mut by_edge = Groups::new(edges.len(), cuts.iter().map(|&(edge, point)| (edge as usize, point)));
        cuts.clear();
        for (edge, of) in (0..edges.len()).map(|e| (e as u32, touched.of(e))) {
            let list = by_edge.of_mut(edge as usize);
            if !of.is_empty() {
                sort_by(list, &compare);
            }
            cuts.extend(list.iter().map(|&point| (edge, point)));
        }
        Ok(Self { cuts, new, gap })
    }

    /// Whether nothing is to be cut.
    pub(super) fn is_empty(&self) -> bool {
        self.cuts.is_empty()
    }
}

/// Those of some points at which no edge ends. All numbers of points are below a bound.
pub(super) fn without_edge(bound: usize, points: impl Iterator<Item = u32>, edges: &[[u32; 2]]) -> Vec<u32> {
    let mut is_loose = vec![true; bound];
    edges.as_flattened().iter().for_each(|&p| is_loose[p as usize] = false);
    points.filter(|&p| is_loose[p as usize]).collect()
}

/// What meets, see [`meetings`], and by edge the points in its interior, if there are any. Edges that cross at a point that
/// both of them pass are cut there already: they are not among the crossings.
pub(super) fn what_meets(
    points: &[Point],
    edges: &[[u32; 2]],
    loose: &[u32],
    sets: &[u8],
) -> Result<(Meetings, Option<Groups<u32>>), NoMeetings> {
    let mut found = meetings(points, edges, loose, sets)?;
    if found.touches.is_empty() {
        return Ok((found, None));
    }
    let touched = Groups::new(edges.len(), found.touches.iter().map(|&[edge, point]| (edge as usize, point)));
    found.crossings.retain(|&[e, g]| {
        let [one, other] = of_both([e, g], |edge| touched.of(edge as usize));
        one.is_empty() || other.is_empty() || one.iter().all(|point| !other.contains(point))
    });
    Ok((found, Some(touched)))
}

/// A crossing rounded to a point, how far that is from it, and between which bounds the crossing lies to its right.
type Placed = (Point, f64, [f64; 2]);

/// The crossings of all pairs. The ends of many pairs are looked up before the first of their crossings is placed: memory answers
/// many questions in the time of one.
fn placed_all(pairs: &[[u32; 2]], ends: impl Fn([u32; 2]) -> [[Point; 2]; 2]) -> Vec<Placed> {
    let mut placed = Vec::with_capacity(pairs.len());
    let mut known = Vec::with_capacity(AT_ONCE);
    for pairs in pairs.chunks(AT_ONCE) {
        known.clear();
        known.extend(pairs.iter().map(|&pair| ends(pair)));
        placed.extend(known.iter().map(|&ends| placed_at(ends)));
    }
    placed
}

/// The order of crossings, as they are before rounding, from left to right. None if two of them are one point.
fn from_left_to_right(placed: &[Placed], ends: impl Fn(u32) -> [[Point; 2]; 2]) -> Option<Vec<u32>> {
    let mut order = by_coordinate(&placed.iter().map(|(p, ..)| p.x).collect::<Vec<_>>());
    let right = |&(_, i): &(u64, u32)| placed[i as usize].2;
    for same in order.chunk_by_mut(|a, b| a.0 == b.0).filter(|same| same.len() > 1) {
        same.iter_mut().for_each(|place| place.0 = sort_key(right(place)[0]));
        same.sort_unstable();
        // Those before a place are left of those behind it if all bounds say so.
        let mut first = 0;
        let mut reach = f64::NEG_INFINITY;
        for place in 0..same.len() {
            reach = reach.max(right(&same[place])[1]);
            if same.get(place + 1).is_none_or(|next| reach < right(next)[0]) {
                exactly(&mut same[first..=place], &ends)?;
                first = place + 1;
            }
        }
    }
    Some(order.into_iter().map(|(_, i)| i).collect())
}

/// Puts crossings in order by exact comparisons. None if two of them are one point.
fn exactly(some: &mut [(u64, u32)], ends: impl Fn(u32) -> [[Point; 2]; 2]) -> Option<()> {
    let [(_, first), rest @ ..] = &*some else { return Some(()) };
    // In rows of things that are alike, crossings lie above each other as the things do.
    let are_moved = rest.iter().all(|&(_, i)| is_moved(ends(i), ends(*first)));
    let crossed = |&(_, i): &(u64, u32)| {
        let [one, other] = ends(i);
        Crossed::new(one, other)
    };
    let all: Vec<Crossed> = if are_moved { Vec::new() } else { some.iter().map(crossed).collect() };
    let compare = |a: u32, b: u32| {
        if are_moved {
            let [p, q] = of_both([a, b], |place| ends(some[place as usize].1)[0][0]);
            return left_to_right(p, q);
        }
        all[a as usize].order_to(&all[b as usize])
    };
    let mut places: Vec<u32> = (0..some.len() as u32).collect();
    sort_by(&mut places, &compare);
    let are_different = places.windows(2).all(|pair| compare(pair[0], pair[1]).is_lt());
    let sorted: Vec<(u64, u32)> = places.iter().map(|&place| some[place as usize]).collect();
    some.copy_from_slice(&sorted);
    are_different.then_some(())
}
