//! The sides of a hull: triangles in one plane are one side, and only extreme points are corners.
//!
//! ```text
//!    ●───────●             ●───────●        a point where three sides or more meet is extreme;
//!    │ ╲   ╱ │             │       │        where two meet it lies on an edge,
//!    │   ●   ●     ==>     │       │        and where there is but one, inside a side
//!    │ ╱   ╲ │             │       │
//!    ●───●───●             ●───────●
//! ```

use super::HullFaces;
use crate::solid::predicates::orient3d;
use crate::topology::PolygonList;
use std::cmp::Ordering;
use std::ops::Range;

const NONE: u32 = u32::MAX;

/// Triangles of a hull with the side each belongs to.
pub(super) struct Facets {
    triangles: Vec<([u32; 3], [u32; 3])>,
    /// By triangle: its side, by the lowest triangle of it.
    side: Vec<u32>,
    points: usize,
}

impl Facets {
    /// Finds the sides. O(triangles).
    pub(super) fn new(points: &[[f64; 3]], triangles: Vec<([u32; 3], [u32; 3])>) -> Self {
        let mut side = vec![NONE; triangles.len()];
        let mut queue = Vec::new();
        for first in 0..triangles.len() as u32 {
            if side[first as usize] != NONE {
                continue;
            }
            side[first as usize] = first;
            queue.push(first);
            let plane = triangles[first as usize].0.map(|i| points[i as usize]);
            while let Some(t) = queue.pop() {
                for &other in &triangles[t as usize].1 {
                    let mut corners = triangles[other as usize].0.iter().map(|&i| points[i as usize]);
                    let [a, b, c] = plane;
                    if side[other as usize] == NONE && corners.all(|p| orient3d(a, b, c, p) == Ordering::Equal) {
                        side[other as usize] = first;
                        queue.push(other);
                    }
                }
            }
        }
        Self { triangles, side, points: points.len() }
    }

    /// The edges between different sides, each with the side on its left.
    fn rims(&self) -> impl Iterator<Item = (u32, [u32; 2])> + '_ {
        self.triangles.iter().zip(&self.side).flat_map(move |(&(corners, beside), &side)| {
            (0..3)
                .filter(move |&i| self.side[beside[i] as usize] != side)
                .map(move |i| (side, [corners[i], corners[(i + 1) % 3]]))
        })
    }

    /// The points that are corners of the hull, in increasing order, and the sides over their numbers in that
    /// order, each from its lowest corner, in the order of these lists. O(n log n) for the order, O(n) for the rest.
    pub(super) fn polygons(&self, faces: HullFaces) -> (Vec<u32>, PolygonList) {
        let mut degree = vec![0_u32; self.points];
        self.rims().for_each(|(_, [from, _])| degree[from as usize] += 1);
        let corners: Vec<u32> = (0..self.points as u32).filter(|&p| degree[p as usize] >= 3).collect();
        let mut number = vec![NONE; self.points];
        corners.iter().zip(0..).for_each(|(&p, i)| number[p as usize] = i);

        let mut sorted: Vec<(u32, [u32; 2])> = self.rims().collect();
        sorted.sort_unstable();
        let mut after = vec![NONE; self.points];
        let mut flat: Vec<u32> = Vec::with_capacity(sorted.len());
        let mut cycles: Vec<Range<usize>> = Vec::new();
        for side in sorted.chunk_by(|a, b| a.0 == b.0) {
            side.iter().for_each(|&(_, [from, to])| after[from as usize] = to);
            let start = side.iter().map(|&(_, [from, _])| from).find(|&p| number[p as usize] != NONE);
            let start = start.expect("a side has corners");
            let round = std::iter::successors(Some(start), |&p| Some(after[p as usize]).filter(|&p| p != start));
            let begin = flat.len();
            flat.extend(round.map(|p| number[p as usize]).filter(|&i| i != NONE));
            cycles.push(begin..flat.len());
        }
        cycles.sort_unstable_by(|a, b| flat[a.clone()].cmp(&flat[b.clone()]));
        let mut list = PolygonList::new();
        for cycle in cycles {
            let cycle = &flat[cycle];
            match faces {
                HullFaces::Whole => list.push_face(cycle),
                HullFaces::Triangles => {
                    cycle[1..].windows(2).for_each(|pair| list.push_face(&[cycle[0], pair[0], pair[1]]));
                }
            }
        }
        (corners, list)
    }
}
