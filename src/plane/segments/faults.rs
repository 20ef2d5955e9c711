//! Naming what meets where it should not, from left to right.

use super::error::SegmentFault;
use super::graph::Graph;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::plane::meet::{EventPlace, EventPoint, same_direction, visit_intersections};
use crate::plane::sweep::rightwards;
use std::ops::ControlFlow;

/// All faults of a graph whose points are distinct and whose edges are single, and have length; not more than
/// `limit`, and whether there are others. `names` gives the number of an edge and of a point in the input.
pub(super) fn all_faults(
    graph: &Graph,
    limit: usize,
    names: (&dyn Fn(u32) -> u32, &dyn Fn(u32) -> u32),
) -> (Vec<SegmentFault>, bool) {
    let edges = rightwards(&graph.points, &graph.edges);
    let mut faults = Faults { graph, edges: &edges, found: Vec::new(), limit, names };
    let stopped =
        visit_intersections(&graph.points, &graph.edges, graph.by_place(), |event| faults.at(event)).is_break();
    (faults.found, stopped)
}

struct Faults<'a> {
    graph: &'a Graph,
    /// The edges from left to right.
    edges: &'a [[u32; 2]],
    found: Vec<SegmentFault>,
    limit: usize,
    names: (&'a dyn Fn(u32) -> u32, &'a dyn Fn(u32) -> u32),
}

impl Faults<'_> {
    fn add(&mut self, fault: SegmentFault) -> ControlFlow<()> {
        if self.found.len() == self.limit {
            return ControlFlow::Break(());
        }
        self.found.push(fault);
        ControlFlow::Continue(())
    }

    fn end(&self, e: u32, which: usize) -> Point {
        self.graph.points[self.edges[e as usize][which] as usize]
    }

    fn at(&mut self, event: &EventPoint<'_>) -> ControlFlow<()> {
        let number = |e: u32| (self.names.0)(e);
        match event.place {
            EventPlace::Crossing(crossing) => {
                let at = crossing.rounded().0;
                // Edges on one line overlap, which was told where that began. They have this point in common: one more is enough.
                let parallel = |e: u32, g: u32| orientation(self.end(e, 0), self.end(e, 1), self.end(g, 0)).is_eq();
                let found: Vec<[u32; 2]> = pairs(event.through, self.limit + 1)
                    .filter(|&[e, g]| !parallel(e, g))
                    .map(|p| p.map(number))
                    .collect();
                found.into_iter().try_for_each(|[first, second]| self.add(SegmentFault::Crossing { first, second, at }))
            }
            EventPlace::Vertex(v) => self.at_vertex(v, event),
        }
    }

    fn at_vertex(&mut self, v: u32, event: &EventPoint<'_>) -> ControlFlow<()> {
        let at = self.graph.points[v as usize];
        let points = &self.graph.points;
        let number = |e: u32| (self.names.0)(e);
        let mut new = Vec::new();
        let same = |e: u32, g: u32| same_direction(points, self.edges, v, e, g);
        let overlap = |e: u32, g: u32| {
            let [p, q] = [e, g].map(|e| self.end(e, 1));
            let to = if left_to_right(p, q).is_lt() { p } else { q };
            let [first, second] = [number(e.min(g)), number(e.max(g))];
            SegmentFault::Overlapping { first, second, from: at, to }
        };
        for group in event.starting.chunk_by(|&e, &g| same(e, g)) {
            new.extend(pairs(group, self.limit + 1).map(|[e, g]| overlap(e, g)));
        }
        // The edges that end here, and where they come from.
        let on_line = |c: u32, e: u32| orientation(at, self.end(c, 0), self.end(e, 0)).is_eq();
        for &c in event.through.iter().take(self.limit + 1) {
            let along = event.starting.iter().filter(|&&s| same(c, s));
            new.extend(along.clone().take(self.limit + 1).map(|&s| overlap(c, s)));
            let ends = event.starting.iter().filter(|&&s| !same(c, s));
            let ends = ends.chain(event.ending.iter().filter(|&&e| !on_line(c, e)));
            let mut touching: Vec<u32> = ends.take(self.limit + 1).map(|&e| number(e)).collect();
            touching.sort_unstable();
            new.extend(touching.iter().map(|&segment| SegmentFault::Touching { segment, at, on: number(c) }));
            if event.starting.is_empty() && event.ending.is_empty() {
                new.push(SegmentFault::PointOnSegment { point: (self.names.1)(v), at, on: number(c) });
            }
        }
        for [e, g] in pairs(event.through, self.limit + 1).filter(|&[e, g]| !same(e, g)) {
            new.push(SegmentFault::Crossing { first: number(e), second: number(g), at });
        }
        new.into_iter().try_for_each(|fault| self.add(fault))
    }
}

/// Pairs of different edges, the lower number first; of a long list not many more than `enough`.
fn pairs(edges: &[u32], enough: usize) -> impl Iterator<Item = [u32; 2]> + '_ {
    let mut few: Vec<u32> = edges.to_vec();
    few.sort_unstable();
    few.truncate(enough.saturating_add(1));
    (0..few.len()).flat_map(move |i| {
        let rest = few[i + 1..].to_vec();
        let e = few[i];
        rest.into_iter().map(move |g| [e, g])
    })
}
