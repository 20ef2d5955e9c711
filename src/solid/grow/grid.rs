//! A face with four sides becomes n x m faces.
//!
//! ```text
//!         top, n pieces
//!      ●────●────●────●           ●────●────●────●           ●────●────●────●
//!      │              │           │    ^    ^    │           │    │    │    │
//!      │              ●  right    │    │    │    ●           ●────●────●────●   1. divide the sides
//!      │              │           │    │    │    │           │    │    │    │   2. cut across, bottom to top
//!      ●  left        │    ==>    ●    │    │    │    ==>    │    │    │    │   3. divide the cuts, and each
//!      │              │           │    │    │    │           │    │    │    │      column cut across
//!      ●────●────●────●           ●────●────●────●           ●────●────●────●
//!        bottom, n pieces
//! ```
//!
//! The four sides need not be four edges: the torus seed has its bottom and top in common, and left and right.

use super::{GrowError, Primitives};
use crate::ids::{HalfEdgeId, VertexId};

/// The sides of a face, each cut in pieces, along the boundary: bottom, right, top, left.
pub(super) struct Sides {
    pub(super) bottom: Vec<HalfEdgeId>,
    pub(super) right: Vec<HalfEdgeId>,
    pub(super) top: Vec<HalfEdgeId>,
    pub(super) left: Vec<HalfEdgeId>,
}

/// The same pieces from the other side.
pub(super) fn backwards(pieces: &[HalfEdgeId]) -> Vec<HalfEdgeId> {
    pieces.iter().rev().map(|h| h.twin()).collect()
}

/// Divides the edge of `h` in so many pieces: each time the vertex at its origin is split with `h` alone moving on.
/// Returns the pieces along `h`; `h` itself is the last. Its origin must have another edge.
pub(super) fn divide(on: &mut impl Primitives, h: HalfEdgeId, pieces: usize) -> Result<Vec<HalfEdgeId>, GrowError> {
    let mut all = Vec::with_capacity(pieces);
    for _ in 1..pieces {
        let after = on.dcel().ccw(h);
        all.push(on.split_vertex(h, after)?.0);
    }
    all.push(h);
    Ok(all)
}

/// Cuts a face from the corners inside `near` to those inside `far`, two sides of it with equally many pieces.
/// Returns the cuts, each from near to far, in the order of `near`.
fn across(on: &mut impl Primitives, near: &[HalfEdgeId], far: &[HalfEdgeId]) -> Result<Vec<HalfEdgeId>, GrowError> {
    let k = near.len();
    (1..k).map(|i| Ok(on.split_face(near[i], far[k - i])?.0)).collect()
}

/// Cuts the face with these sides into n x m faces. Returns the vertices row by row from the bottom left: the one
/// at column i and row j has index j (n + 1) + i.
pub(super) fn tessellate(on: &mut impl Primitives, sides: &Sides) -> Result<Vec<VertexId>, GrowError> {
    let (n, m) = (sides.bottom.len(), sides.right.len());
    let uprights = across(on, &sides.bottom, &sides.top)?;
    let mut table = vec![VertexId::new(0); (n + 1) * (m + 1)];
    let mut left = sides.left.clone();
    let mut place = |dcel: &crate::topology::Dcel, i: usize, upwards: &[HalfEdgeId]| {
        for (j, &h) in upwards.iter().enumerate() {
            table[j * (n + 1) + i] = dcel.origin(h);
            table[(j + 1) * (n + 1) + i] = dcel.destination(h);
        }
    };
    place(on.dcel(), 0, &backwards(&left));
    for i in 1..=n {
        let right = match uprights.get(i - 1) {
            Some(&cut) => divide(on, cut, m)?,
            None => sides.right.clone(),
        };
        across(on, &right, &left)?;
        place(on.dcel(), i, &right);
        left = backwards(&right);
    }
    Ok(table)
}
