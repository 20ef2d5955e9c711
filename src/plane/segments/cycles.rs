//! From linked half-edges to faces: the cycles, and which of them are inner components.
//!
//! ```text
//!    ┌─────────┐     At its leftmost vertex ○ an inner component has all that is to the left of it on its left: it comes
//!    │   ┌───┐ │     along the twin of the first half-edge, counter-clockwise from straight down, and leaves by the last
//!    │   │   │ │     one. The cycle round a bounded face turns between two others there.
//!    │   ○───┘ │
//!    └─────────┘
//! ```

use super::one_rings::OneRings;
use crate::geometry::predicates::is_left_of;
use crate::ids::{HalfEdgeId, MAX_IDS, VertexId};
use crate::plane::Point;
use crate::plane::rings::Loose;
use crate::topology::{Columns, InnerComponent, TooMany};

/// Gives every half-edge its face, inner components for the time being `f0`. Returns the inner components and the isolated vertices.
/// Edges and points are those of the graph.
///
/// Cost: O(n).
pub(super) fn cycles(
    one_rings: OneRings,
    edges: Vec<[u32; 2]>,
    points: &[Point],
) -> Result<(Columns, Vec<Loose>), TooMany> {
    let mut columns = one_rings.into_columns(edges);
    let mut loose = Vec::new();
    for start in 0..columns.face.len() as u32 {
        if columns.face[start as usize] != Columns::NONE {
            continue;
        }
        let face = columns.boundary.len() as u32;
        let mut leftmost = columns.origin[start as usize];
        let mut place = points[leftmost as usize];
        let mut h = start;
        loop {
            columns.face[h as usize] = face;
            let v = columns.origin[h as usize];
            let here = points[v as usize];
            let is_left = is_left_of(here, place);
            leftmost = if is_left { v } else { leftmost };
            place = if is_left { here } else { place };
            h = columns.next[h as usize];
            if h == start {
                break;
            }
        }
        let first = columns.outgoing[leftmost as usize];
        if columns.face[(first ^ 1) as usize] != face {
            if columns.boundary.len() >= MAX_IDS {
                return Err(TooMany);
            }
            columns.boundary.push(start);
            continue;
        }
        let leftmost = VertexId::new(leftmost);
        loose.push(Loose { ring: InnerComponent::Cycle(HalfEdgeId::new(start)), leftmost, owner: None });
        while columns.face[h as usize] != 0 {
            columns.face[h as usize] = 0;
            h = columns.next[h as usize];
        }
    }
    let isolated = columns.outgoing.iter().enumerate().filter(|&(_, &h)| h == Columns::NONE);
    loose.extend(isolated.map(|(v, _)| {
        let v = VertexId::new(v as u32);
        Loose { ring: InnerComponent::Isolated(v), leftmost: v, owner: None }
    }));
    Ok((columns, loose))
}
