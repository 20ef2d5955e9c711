//! Points that lie inside the sides of polygons.
//!
//! ```text
//!          ╲  ╱                 A tip touches the side of another polygon: nothing overlaps, but the side has to
//!     a ────●v──── b            become two, a -> v and v -> b, before the polygons are a subdivision.
//! ```

use super::graph::Single;
use crate::geometry::grouping::grouped;
use crate::geometry::places::first_at_each_place;
use crate::geometry::predicates::left_to_right;
use crate::plane::Point;
use crate::plane::meet::{EventPlace, visit_intersections};
use crate::topology::PolygonList;
use std::ops::ControlFlow;

/// A corner that was inserted into a side of a polygon.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct InsertedCorner {
    /// The polygon.
    pub face: u32,
    /// The cycle of the polygon: 0 is the outer one.
    pub cycle: u32,
    /// The vertex that lay inside a side.
    pub vertex: u32,
}

/// The polygons with a corner wherever a vertex lies exactly inside a side, and the corners that were inserted, polygon
/// by polygon. No point moves and none is made. None if sides cross, if two vertices lie at the same place, or if there
/// is nothing to insert.
///
/// Cost: O((n + k) log n) for n sides with k vertices inside them.
pub(in crate::plane) fn insert_touching(
    points: &[Point],
    polygons: &PolygonList,
) -> Option<(PolygonList, Vec<InsertedCorner>)> {
    let mut used = vec![false; points.len()];
    polygons.corners().iter().for_each(|&corner| used[corner as usize] = true);
    let (first, mut by_place) = first_at_each_place(points);
    if (0..points.len()).any(|i| used[i] && first[i] as usize != i) {
        return None;
    }
    by_place.retain(|&p| used[p as usize]);
    let sides: Vec<[u32; 2]> = (0..polygons.cycle_count()).flat_map(|cycle| sides_of(polygons.cycle(cycle))).collect();
    if sides.iter().any(|[a, b]| a == b) {
        return None;
    }
    let Single { edges, half } = Single::new(points.len(), &sides, |_, _| {});
    let mut found: Vec<(u32, u32)> = Vec::new();
    let crossed = visit_intersections(points, &edges, &by_place, |event| {
        let EventPlace::Vertex(vertex) = event.place else { return ControlFlow::Break(()) };
        found.extend(event.through.iter().map(|&edge| (edge, vertex)));
        ControlFlow::Continue(())
    });
    if crossed.is_break() || found.is_empty() {
        return None;
    }
    let (starts, list) = grouped(edges.len(), found.len(), |i| found[i].0 as usize);
    let mut inserted = Vec::new();
    let (mut whole, mut side) = (PolygonList::default(), 0);
    let mut ring = Vec::new();
    for face in 0..polygons.face_count() {
        for (cycle, corners) in polygons.cycles(face).enumerate() {
            ring.clear();
            for [a, b] in sides_of(corners) {
                let edge = (half[side] >> 1) as usize;
                side += 1;
                ring.push(a);
                // The sweep comes to them from left to right.
                let inside = &list[starts[edge] as usize..starts[edge + 1] as usize];
                let rightwards = left_to_right(points[a as usize], points[b as usize]).is_lt();
                for k in 0..inside.len() {
                    let i = if rightwards { k } else { inside.len() - 1 - k };
                    let vertex = found[inside[i] as usize].1;
                    ring.push(vertex);
                    inserted.push(InsertedCorner { face: face as u32, cycle: cycle as u32, vertex });
                }
            }
            if cycle == 0 { whole.push_face(&ring) } else { whole.push_hole(&ring) }
        }
    }
    Some((whole, inserted))
}

/// The sides of a cycle, each from its first end to its second.
pub(in crate::plane) fn sides_of(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]])
}
