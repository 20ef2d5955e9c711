//! The subdivision of edges that fill a disk, for who will prove that no two of them cross: no sweep, only the order of
//! the half-edges round each vertex, and their cycles.
//!
//! ```text
//!   ┌──●─────┐      The border is one cycle. Every other cycle bounds a face that has no inner components; whoever
//!   │  │     │      asks has to make sure of that, for example by a place inside of each face from which all of its
//!   ●──●─────●      border is seen from the left: faces that are so cover what is inside the border once.
//!   └──┴─────┘
//! ```

use super::graph::Graph;
use super::trace::OneRings;
use crate::geometry::grouping::grouped;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::ids::{HalfEdgeId, MAX_IDS};
use crate::plane::{Point, Subdivision};
use crate::topology::{Columns, Dcel, InnerComponent, TooMany};
use std::cmp::Ordering;

const NONE: u32 = Columns::NONE;

impl Subdivision {
    /// See the head of the file; `outside` is a half-edge whose left side is not in the disk. All numbers are those of
    /// [`from_graph`](Self::from_graph). O(n), and O(k log k) for a vertex with k edges.
    pub(in crate::plane) fn disk(points: Vec<Point>, edges: Vec<[u32; 2]>, outside: u32) -> Result<Self, TooMany> {
        let graph = Graph { points, edges, by_place: Vec::new() };
        let mut one_rings = OneRings::new(&graph)?;
        let Graph { points, edges, .. } = graph;
        let ends = edges.as_flattened();
        let (starts, mut list) = grouped(points.len(), ends.len(), |h| ends[h] as usize);
        for (v, range) in (0..).zip(starts.windows(2)) {
            let ring = &mut list[range[0] as usize..range[1] as usize];
            let at = points[v as usize];
            let to = |h: u32| points[ends[(h ^ 1) as usize] as usize];
            let order = |g: u32, h: u32| from_below(at, to(g), to(h));
            match ring {
                [a, b, c] => sort_three([a, b, c], order),
                _ => ring.sort_unstable_by(|&g, &h| order(g, h)),
            }
            one_rings.link_all(v, ring.iter().copied());
        }
        let mut columns = one_rings.into_columns();
        // Euler's formula: a connected graph has so many bounded faces.
        columns.boundary.reserve(1 + edges.len() - edges.len().min(points.len()));
        let first = give_face(&mut columns, outside, 0);
        for start in 0..columns.face.len() as u32 {
            if columns.face[start as usize] == NONE {
                let face = columns.boundary.len();
                if face >= MAX_IDS {
                    return Err(TooMany);
                }
                give_face(&mut columns, start, face as u32);
                columns.boundary.push(start);
            }
        }
        let mut subdivision = Self::from_parts(Dcel::from_columns(columns), points.into());
        subdivision.order_inner_components(vec![InnerComponent::Cycle(HalfEdgeId::new(first))]);
        Ok(subdivision)
    }
}

/// What most rings of a diagram are, sorted without the steps that a sort takes to find out how long they are.
#[inline]
fn sort_three([a, b, c]: [&mut u32; 3], order: impl Fn(u32, u32) -> Ordering) {
    let sort = |g: &mut u32, h: &mut u32| {
        let is_wrong = order(*g, *h).is_gt();
        if is_wrong {
            std::mem::swap(g, h);
        }
        is_wrong
    };
    sort(a, b);
    if sort(b, c) {
        sort(a, b);
    }
}

/// Gives the half-edges of a cycle their face. Returns the smallest of them.
fn give_face(columns: &mut Columns, start: u32, face: u32) -> u32 {
    let (mut h, mut first) = (start, start);
    loop {
        columns.face[h as usize] = face;
        first = first.min(h);
        h = columns.next[h as usize];
        if h == start {
            return first;
        }
    }
}

/// Which of two places comes first round a point, counter-clockwise from straight down; straight down itself is last.
fn from_below(round: Point, a: Point, b: Point) -> Ordering {
    let is_left = |p: Point| left_to_right(p, round).is_lt();
    is_left(a).cmp(&is_left(b)).then_with(|| orientation(round, a, b).reverse())
}
