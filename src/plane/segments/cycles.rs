//! From linked half-edges to faces: the cycles, and which of them are inner components.
//!
//! ```text
//!    ┌─────────●     From left to right, what a cycle has on its left comes to a fork at ○, and ends at ●. With a face
//!    │   ┌───┐ │     on its left a cycle turns once counter-clockwise: there are more ends than forks, by one. An inner
//!    │   │   │ │     component turns the other way. At its leftmost vertex there is a fork, as nothing of it is to the
//!    │   ○───┘ │     left of that.
//!    └─────────┘
//! ```
//!
//! So no coordinate is looked at but those of the forks.

use super::one_rings::{OneRings, has_no_face, turn};
use crate::geometry::predicates::left_to_right;
use crate::ids::{HalfEdgeId, MAX_IDS, VertexId};
use crate::plane::Point;
use crate::plane::rings::Loose;
use crate::topology::{Columns, InnerComponent, TooMany};

/// In the place of a face: the inner components, from this number on. Faces have smaller numbers.
const INNER: u32 = 1 << 31;

/// Gives every half-edge its face, inner components for the time being `f0`. Returns the inner components and the isolated vertices.
///
/// Cost: O(n).
pub(super) fn cycles(one_rings: OneRings, points: &[Point]) -> Result<(Columns, Vec<Loose>), TooMany> {
    let (mut columns, tips) = one_rings.into_parts();
    let mut loose: Vec<Loose> = Vec::new();
    for start in 0..columns.face.len() as u32 {
        if !has_no_face(columns.face[start as usize]) {
            continue;
        }
        let face = columns.boundary.len() as u32;
        let mut turns = 0;
        each_of(start, &columns.next, |h| turns += turn(std::mem::replace(&mut columns.face[h as usize], face)));
        if turns > 0 {
            if columns.boundary.len() >= MAX_IDS {
                return Err(TooMany);
            }
            columns.boundary.push(start);
            continue;
        }
        let inner = INNER + loose.len() as u32;
        each_of(start, &columns.next, |h| columns.face[h as usize] = inner);
        let leftmost = VertexId::new(columns.origin[start as usize]);
        loose.push(Loose { ring: InnerComponent::Cycle(HalfEdgeId::new(start)), leftmost, owner: None });
    }
    for v in tips {
        let fork = columns.outgoing[v as usize] ^ 1;
        let inner = columns.face[fork as usize].wrapping_sub(INNER);
        if let Some(Loose { leftmost, .. }) = loose.get_mut(inner as usize)
            && left_to_right(points[v as usize], points[leftmost.index()]).is_lt()
        {
            *leftmost = VertexId::new(v);
        }
    }
    columns.face.iter_mut().filter(|face| **face >= INNER).for_each(|face| *face = 0);
    let isolated = columns.outgoing.iter().enumerate().filter(|&(_, &h)| h == Columns::NONE);
    loose.extend(isolated.map(|(v, _)| {
        let v = VertexId::new(v as u32);
        Loose { ring: InnerComponent::Isolated(v), leftmost: v, owner: None }
    }));
    Ok((columns, loose))
}

/// Calls with each half-edge of a cycle.
#[inline]
fn each_of(start: u32, next: &[u32], mut call: impl FnMut(u32)) {
    let mut h = start;
    loop {
        call(h);
        h = next[h as usize];
        if h == start {
            return;
        }
    }
}
