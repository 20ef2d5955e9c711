//! The subdivision of edges that fill a disk, for who will prove that no two of them cross: no sweep, only the order of
//! the half-edges round each vertex, and their cycles.
//!
//! ```text
//!   ┌──●─────┐      The border is one cycle. Every other cycle bounds a face that has no inner components; whoever
//!   │  │     │      asks has to make sure of that, for example by a place inside of each face from which all of its
//!   ●──●─────●      border is seen from the left: faces that are so cover what is inside the border once.
//!   └──┴─────┘
//! ```

use super::angles::one_rings_by_angle;
use super::graph::{Graph, Order};
use crate::ids::{HalfEdgeId, MAX_IDS};
use crate::plane::{Point, Subdivision};
use crate::topology::{Columns, Dcel, InnerComponent, TooMany};

const NONE: u32 = Columns::NONE;

impl Subdivision {
    /// See the head of the file; `outside` is a half-edge whose left side is not in the disk. All numbers are those of
    /// [`from_graph`](Self::from_graph). O(n), and O(k log k) for a vertex with k edges.
    pub(in crate::plane) fn disk(points: Vec<Point>, edges: Vec<[u32; 2]>, outside: u32) -> Result<Self, TooMany> {
        let graph = Graph { points, edges, order: Order::default() };
        let one_rings = one_rings_by_angle(&graph)?;
        let Graph { points, edges, .. } = graph;
        // Euler's formula: a connected graph has so many bounded faces.
        let bounded = 1 + edges.len() - edges.len().min(points.len());
        let mut columns = one_rings.into_columns(edges);
        columns.boundary.reserve(bounded);
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
