//! From points to vertices: equal coordinates are one vertex.
//!
//! ```text
//!   points    p0 (0, 0)   p1 (2, 1)   p2 (2, 1)   p3 (-0, 0)         exactly equal, with -0 = 0; nothing else
//!   vertices  v0          v1          v1          v0                 is joined, however close
//! ```
//!
//! Equal points are found without any order (`geometry/equal.rs`). Their order from left to right serves the sweep, and is made
//! when one asks for it (`geometry/places.rs`).

use super::error::SegmentFault;
use crate::geometry::equal::{FEW, NONE, equals_among, first_of_equals};
use crate::geometry::grouping::grouped;
use crate::geometry::places::first_at_each_place;
use crate::geometry::predicates::left_to_right;
use crate::plane::Point;
use std::cell::OnceCell;

/// A straight-line graph: distinct points, and edges by the numbers of their ends.
#[derive(Clone, Debug, Default)]
pub(super) struct Graph {
    pub(super) points: Vec<Point>,
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) order: Order,
}

/// The numbers of distinct points from left to right, those above each other from bottom to top: known, or to be found when
/// it is asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Order(OnceCell<Vec<u32>>);

impl Order {
    pub(super) fn known(by_place: Vec<u32>) -> Self {
        Self(OnceCell::from(by_place))
    }

    /// The order, if it is known.
    pub(super) fn if_known(&self) -> Option<&[u32]> {
        self.0.get().map(Vec::as_slice)
    }
}

/// Distinct points, and which of them each given point is.
pub(super) struct Distinct {
    /// The distinct points in the order in which they first come. No coordinate is -0.
    pub(super) points: Vec<Point>,
    /// Their numbers from left to right.
    pub(super) order: Order,
    /// The number of each given point.
    pub(super) number: Vec<u32>,
}

impl Distinct {
    /// Finds equal points. O(n) to find them and O(n log n) to order them; less where they are spread evenly.
    pub(super) fn new(given: &[Point]) -> Self {
        let (number, by_place) = first_at_each_place(given);
        let (points, number) = Self::numbered(given, number);
        let by_place = by_place.into_iter().map(|first| number[first as usize]).collect();
        Self { points, order: Order::known(by_place), number }
    }

    /// The same without the order. Expected O(n).
    pub(super) fn without_order(given: &[Point]) -> Self {
        let (points, number) = Self::numbered(given, first_of_equals(given));
        Self { points, order: Order::default(), number }
    }

    /// The same of points that are all distinct; gives others back.
    pub(super) fn of_all(mut given: Vec<Point>) -> Result<Self, Vec<Point>> {
        let number = first_of_equals(&given);
        if (0..).zip(&number).any(|(i, &first)| first != i) {
            return Err(given);
        }
        given.iter_mut().for_each(|p| *p = Point::new(p.x + 0.0, p.y + 0.0));
        Ok(Self { points: given, order: Order::default(), number })
    }

    /// The distinct points, and the number of each given one, of which the first one at its place is known.
    fn numbered(given: &[Point], mut number: Vec<u32>) -> (Vec<Point>, Vec<u32>) {
        let mut points = Vec::with_capacity(given.len());
        for i in 0..given.len() {
            let first = number[i] as usize;
            if first == i {
                number[i] = points.len() as u32;
                points.push(Point::new(given[i].x + 0.0, given[i].y + 0.0));
            } else {
                number[i] = number[first];
            }
        }
        (points, number)
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
    /// Edges that are known to be single.
    pub(super) fn as_given(given: Vec<[u32; 2]>) -> Self {
        let half = (0..given.len() as u32).map(|e| 2 * e).collect();
        Self { edges: given, half }
    }

    /// Finds repeated edges; `repeated` hears of each with the earlier one. `vertices` is more than the greatest number
    /// of an end. O(n), and O(k log k) for a vertex with k edges.
    pub(super) fn new(vertices: usize, given: &[[u32; 2]], mut repeated: impl FnMut(u32, u32)) -> Self {
        let (starts, mut list) = grouped(vertices, given.len(), |e| given[e][0].min(given[e][1]) as usize);
        let high = |e: u32| given[e as usize][0].max(given[e as usize][1]);
        let mut first_of: Vec<u32> = (0..given.len() as u32).collect();
        for ends in starts.windows(2) {
            let here = &mut list[ends[0] as usize..ends[1] as usize];
            if here.len() > FEW {
                here.sort_unstable_by_key(|&e| (high(e), e));
                for same in here.chunk_by(|&e, &g| high(e) == high(g)) {
                    same.iter().for_each(|&e| first_of[e as usize] = same[0]);
                }
                continue;
            }
            for (i, &e) in here.iter().enumerate() {
                if let Some(&first) = here[..i].iter().find(|&&g| high(g) == high(e)) {
                    first_of[e as usize] = first;
                }
            }
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
    /// The points from left to right, those above each other from bottom to top.
    pub(super) fn by_place(&self) -> &[u32] {
        self.order.0.get_or_init(|| first_at_each_place(&self.points).1)
    }

    /// Adds points to the graph; a new point at the place of an old one is the old one. Returns the numbers of the new
    /// points. An order that is known stays known.
    ///
    /// Cost: O(n + k log k) for k new points, less where they come from left to right.
    pub(super) fn add_points(&mut self, new: &[Point]) -> Vec<u32> {
        let Distinct { points, order, number } = Distinct::new(new);
        let mut numbers = equals_among(&points, &self.points);
        let bound = self.points.len() as u32;
        for (&p, number) in points.iter().zip(&mut numbers).filter(|(_, number)| **number == NONE) {
            *number = self.points.len() as u32;
            self.points.push(p);
        }
        if let Some(old) = self.order.0.take() {
            let new = order.0.into_inner().into_iter().flatten().map(|p| numbers[p as usize]).filter(|&p| p >= bound);
            let at = |p: u32| self.points[p as usize];
            let mut merged = Vec::with_capacity(self.points.len());
            let mut old = old.into_iter().peekable();
            for p in new {
                while let Some(q) = old.next_if(|&q| left_to_right(at(q), at(p)).is_lt()) {
                    merged.push(q);
                }
                merged.push(p);
            }
            merged.extend(old);
            self.order = Order::known(merged);
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::xorshift;

    #[test]
    fn repeated_edges_are_those_of_all_pairs_also_at_a_vertex_of_many() {
        let mut random = xorshift(0x9e37_79b9_7f4a_7c15);
        let mut next = |below: u64| ((random() >> 20) % below) as u32;
        for vertices in [2, 5, 30] {
            // Every second edge is one of vertex 0.
            let ends = (0..60_u64).map(|i| (if i % 2 == 0 { 0 } else { next(vertices) }, next(vertices)));
            let given: Vec<[u32; 2]> = ends.filter(|(a, b)| a != b).map(|(a, b)| [a, b]).collect();
            let mut heard = Vec::new();
            let Single { edges, half } =
                Single::new(vertices as usize, &given, |second, first| heard.push((second, first)));
            let same = |e: usize, g: usize| given[e] == given[g] || given[e] == [given[g][1], given[g][0]];
            let first = |e: usize| (0..e).find(|&g| same(e, g));
            let expected: Vec<(u32, u32)> =
                (0..given.len()).filter_map(|e| first(e).map(|g| (e as u32, g as u32))).collect();
            assert_eq!(heard, expected);
            assert_eq!(edges.len(), given.len() - expected.len());
            for (e, ends) in given.iter().enumerate() {
                let [a, b] = edges[(half[e] >> 1) as usize];
                assert_eq!(if half[e] & 1 == 0 { [a, b] } else { [b, a] }, *ends, "edge {e}");
            }
        }
    }
}
