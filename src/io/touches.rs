//! Where rings of a polygon touch, so that they cut its inside into pieces. Exact.
//!
//! ```text
//!      ●───────●───────●       Rings and the places where they touch are the nodes of a graph; a ring is joined to the
//!      │      ╱ ╲      │       places on it. The inside is in one piece as long as this graph has no cycle:
//!      │  A  ●   ●  B  │
//!      │      ╲ ╱      │       ring 0 ── top ── ring 1 ── bottom ── ring 0
//!      ●───────●───────●
//! ```

use crate::geometry::grouping::Joined;
use crate::plane::{ArrangeOptions, Point, SegmentFault, SegmentsError, Subdivision};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Rings that touch one after another, and where: each at the place of its number and at the one before.
pub(super) struct Chain {
    pub(super) rings: Vec<u32>,
    pub(super) places: Vec<Point>,
}

/// A closed chain of rings that touch, by their corners; none if the inside is in one piece. O(n log n) for n corners.
pub(super) fn closed_chain(rings: &[Vec<Point>]) -> Option<Chain> {
    let touches = touches(rings);
    // Nodes: the rings, then the places.
    let mut joined: Vec<Vec<u32>> = vec![Vec::new(); rings.len() + touches.len()];
    let mut sets = Joined::none(joined.len());
    for (i, (_, with)) in touches.iter().enumerate() {
        let place = (rings.len() + i) as u32;
        for &ring in with {
            if sets.root(ring) == sets.root(place) {
                let way = way(&joined, ring, place);
                let (rings_on, places): (Vec<u32>, Vec<u32>) =
                    way.into_iter().partition(|&node| (node as usize) < rings.len());
                let places = places.into_iter().map(|node| touches[node as usize - rings.len()].0).collect();
                return Some(Chain { rings: rings_on, places });
            }
            sets.join(ring, place);
            joined[ring as usize].push(place);
            joined[place as usize].push(ring);
        }
    }
    None
}

/// The places where two rings or more touch, with these.
fn touches(rings: &[Vec<Point>]) -> Vec<(Point, BTreeSet<u32>)> {
    let (mut sides, mut ring_of) = (Vec::new(), Vec::new());
    let mut at: BTreeMap<[u64; 2], (Point, BTreeSet<u32>)> = BTreeMap::new();
    let mut touch = |p: Point, ring: u32| {
        // -0 + 0 = 0: the two zeros are one coordinate.
        let p = Point::new(p.x + 0.0, p.y + 0.0);
        at.entry([p.x.to_bits(), p.y.to_bits()]).or_insert_with(|| (p, BTreeSet::new())).1.insert(ring);
    };
    for (ring, corners) in (0..).zip(rings) {
        for (i, &p) in corners.iter().enumerate() {
            touch(p, ring);
            sides.push([p, corners[(i + 1) % corners.len()]]);
            ring_of.push(ring);
        }
    }
    let options = ArrangeOptions { merge: true, most_faults: usize::MAX, ..ArrangeOptions::default() };
    if let Err(SegmentsError::Faults { faults, .. }) = Subdivision::arrange_segments(&sides, &options) {
        for fault in faults {
            if let SegmentFault::Touching { at, on, .. } = fault {
                touch(at, ring_of[on as usize]);
            }
        }
    }
    at.into_values().filter(|(_, with)| with.len() > 1).collect()
}

/// The nodes on the way from one node to another in a forest, both included.
fn way(joined: &[Vec<u32>], from: u32, to: u32) -> Vec<u32> {
    let mut before = vec![u32::MAX; joined.len()];
    before[to as usize] = to;
    let mut waiting = VecDeque::from([to]);
    while let Some(node) = waiting.pop_front().filter(|&node| node != from) {
        for &next in &joined[node as usize] {
            if before[next as usize] == u32::MAX {
                before[next as usize] = node;
                waiting.push_back(next);
            }
        }
    }
    let mut way = vec![from];
    let mut node = from;
    while node != to && before[node as usize] != u32::MAX {
        node = before[node as usize];
        way.push(node);
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&p| Point::from(p)).collect()
    }

    #[test]
    fn rings_that_touch_once_leave_the_inside_whole() {
        let shell = ring(&[(0., 0.), (8., 0.), (8., 8.), (0., 8.)]);
        // In a corner of the shell, inside a side of it, and on each other.
        let holes = [ring(&[(0., 0.), (2., 1.), (1., 2.)]), ring(&[(4., 0.), (5., 2.), (3., 2.)])];
        let all = [shell.clone(), holes[0].clone(), holes[1].clone()];
        assert!(closed_chain(&all).is_none());
        // One more, from the first hole to the second one, closes a chain.
        let last = ring(&[(2., 1.), (3., 2.), (2., 3.)]);
        let chain = closed_chain(&[all[0].clone(), all[1].clone(), all[2].clone(), last]).expect("a chain");
        let rings: BTreeSet<u32> = chain.rings.iter().copied().collect();
        assert_eq!((rings.len(), chain.rings.len(), chain.places.len()), (4, 4, 4));
        // Three rings at one place are no chain.
        let two = [shell.clone(), ring(&[(0., 0.), (3., 1.), (2., 1.)]), ring(&[(0., 0.), (1., 2.), (1., 3.)])];
        assert!(closed_chain(&two).is_none());
        // One that touches the shell twice, once inside a side.
        let wall = ring(&[(4., 0.), (5., 4.), (4., 8.), (3., 4.)]);
        let chain = closed_chain(&[shell, wall]).expect("a chain");
        assert_eq!((chain.rings.len(), chain.places.len()), (2, 2));
        assert!(chain.places.contains(&Point::new(4., 0.)) && chain.places.contains(&Point::new(4., 8.)));
    }
}
