//! From points to vertices: equal coordinates are one vertex.
//!
//! ```text
//!   points    p0 (0, 0)   p1 (2, 1)   p2 (2, 1)   p3 (-0, 0)         exactly equal, with -0 = 0; nothing else
//!   vertices  v0          v1          v1          v0                 is joined, however close
//! ```
//!
//! Equal points are found by sorting; the same order serves the sweep.

use super::error::SegmentFault;
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, sort_key};

/// A straight-line graph: distinct points, and edges by the numbers of their ends.
#[derive(Clone, Debug, Default)]
pub(super) struct Graph {
    pub(super) points: Vec<Point>,
    pub(super) edges: Vec<[u32; 2]>,
    /// The points from left to right, those above each other from bottom to top.
    pub(super) by_place: Vec<u32>,
}

/// Distinct points, and which of them each given point is.
pub(super) struct Distinct {
    /// The distinct points in the order in which they first come. No coordinate is -0.
    pub(super) points: Vec<Point>,
    /// Their numbers from left to right.
    pub(super) by_place: Vec<u32>,
    /// The number of each given point.
    pub(super) number: Vec<u32>,
}

impl Distinct {
    /// Finds equal points. O(n log n).
    pub(super) fn new(given: &[Point]) -> Self {
        let mut order: Vec<(u64, u64, u32)> =
            given.iter().enumerate().map(|(i, p)| (sort_key(p.x), sort_key(p.y), i as u32)).collect();
        order.sort_unstable();
        // The first point of each place stands for all of them.
        let mut number = vec![0; given.len()];
        let mut by_place = Vec::new();
        for same in order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let first = same[0].2;
            same.iter().for_each(|&(_, _, i)| number[i as usize] = first);
            by_place.push(first);
        }
        let mut points = Vec::with_capacity(by_place.len());
        for i in 0..given.len() {
            let first = number[i] as usize;
            if first == i {
                number[i] = points.len() as u32;
                points.push(Point::new(given[i].x + 0.0, given[i].y + 0.0));
            } else {
                number[i] = number[first];
            }
        }
        by_place.iter_mut().for_each(|p| *p = number[*p as usize]);
        Self { points, by_place, number }
    }
}

/// Edges of which no two join the same vertices, and which of them each given edge is.
pub(super) struct Single {
    /// The edges that were the first between their ends, as given.
    pub(super) edges: Vec<[u32; 2]>,
    /// Twice the number of the edge for each given one, plus 1 if it runs the other way.
    pub(super) half: Vec<u32>,
}

impl Single {
    /// Finds repeated edges; `repeated` hears of each with the earlier one. O(n log n).
    pub(super) fn new(given: &[[u32; 2]], mut repeated: impl FnMut(u32, u32)) -> Self {
        let mut order: Vec<(u32, u32, u32)> =
            given.iter().enumerate().map(|(e, &[a, b])| (a.min(b), a.max(b), e as u32)).collect();
        order.sort_unstable();
        let mut first_of = vec![0; given.len()];
        for same in order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            same.iter().for_each(|&(_, _, e)| first_of[e as usize] = same[0].2);
        }
        let mut edges = Vec::with_capacity(given.len());
        let mut half = vec![0; given.len()];
        for (e, &ends) in given.iter().enumerate() {
            let first = first_of[e] as usize;
            if first == e {
                half[e] = 2 * edges.len() as u32;
                edges.push(ends);
            } else {
                half[e] = half[first] ^ u32::from(given[first] != ends);
                repeated(e as u32, first as u32);
            }
        }
        Self { edges, half }
    }
}

impl Graph {
    /// Adds points to the graph and brings all in order; a new point at the place of an old one is the old one.
    /// Returns the numbers of the new points. O(n + k log k) for k new points.
    pub(super) fn add_points(&mut self, new: &[Point]) -> Vec<u32> {
        let Distinct { points, by_place, number } = Distinct::new(new);
        let mut numbers = vec![u32::MAX; points.len()];
        let old = std::mem::take(&mut self.by_place);
        let mut old = old.into_iter().peekable();
        let mut added: Vec<u32> = Vec::new();
        let at = |list: &[Point], p: u32| list[p as usize];
        let mut merged: Vec<(bool, u32)> = Vec::with_capacity(old.len() + points.len());
        for p in by_place {
            while let Some(&q) = old.peek() {
                if left_to_right(at(&self.points, q), at(&points, p)).is_ge() {
                    break;
                }
                merged.push((false, q));
                old.next();
            }
            match old.peek() {
                Some(&q) if at(&self.points, q) == at(&points, p) => numbers[p as usize] = q,
                _ => {
                    merged.push((true, p));
                    added.push(p);
                }
            }
        }
        merged.extend(old.map(|q| (false, q)));
        added.sort_unstable();
        for p in added {
            numbers[p as usize] = self.points.len() as u32;
            self.points.push(at(&points, p));
        }
        self.by_place = merged.into_iter().map(|(is_new, p)| if is_new { numbers[p as usize] } else { p }).collect();
        number.into_iter().map(|p| numbers[p as usize]).collect()
    }
}

/// The faults of given points and edges that need no look at the plane: two points at one place (where that is a
/// fault), edges without length, repeated ones.
pub(super) fn same_places(given: &[Point], number: &[u32], limit: usize) -> Vec<SegmentFault> {
    let mut first = vec![u32::MAX; given.len()];
    let mut faults = Vec::new();
    for (i, &v) in number.iter().enumerate() {
        let seen = &mut first[v as usize];
        if *seen == u32::MAX {
            *seen = i as u32;
        } else if faults.len() < limit {
            faults.push(SegmentFault::SamePlace { first: *seen, second: i as u32, at: given[i] });
        }
    }
    faults
}
