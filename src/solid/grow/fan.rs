//! A vertex in the middle of a face, and spokes to its corners.
//!
//! ```text
//!    ●────────●            ●────────●            ●────────●            ●────────●
//!    │        │            │        │            │        │            │╲      ╱│
//!    │        │            │   ●    │            │   ●    │            │  ╲  ╱  │
//!    │   f    │    ==>     │  ╱     │    ==>     │  ╱ ╲   │    ==>     │   ●    │
//!    │        │            │╱       │            │╱     ╲ │            │ ╱   ╲  │
//!  h ●────────●            ●────────●            ●────────●            ●────────●
//!                          a spur                split off the ever-shrinking rest, n - 1 times
//! ```
//!
//! With a step of two outside sides for each spoke the new faces are quads.

use super::{GrowError, Primitives};
use crate::ids::{FaceId, HalfEdgeId, VertexId};

/// What [`pole`] and [`quads`] made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fan {
    /// The vertex in the middle.
    pub middle: VertexId,
    /// The faces round it, counter-clockwise from the one at the half-edge that was given. The old face is the last.
    pub faces: Vec<FaceId>,
}

/// Puts a vertex into the face of `h` and a spoke to each of its n corners: n triangles.
///
/// V + 1, E + n, F + n - 1. Cost: O(n).
///
/// # Errors
/// [`GrowError`]: `h` does not exist, the face has one side, or the structure is full.
///
/// ```
/// use dcel_kit::{HalfEdgeId, solid::grow::pole, topology::Dcel};
/// let mut disc = Dcel::polygon(8)?;
/// let fan = pole(&mut disc, HalfEdgeId::new(0))?;
/// assert_eq!((fan.faces.len(), disc.degree(fan.middle)), (8, 8));
/// assert_eq!((disc.vertex_count(), disc.edge_count(), disc.face_count()), (9, 16, 9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pole(on: &mut impl Primitives, h: HalfEdgeId) -> Result<Fan, GrowError> {
    on.dcel().check(h)?;
    spokes(on, h, 1, 2)
}

/// Puts a vertex into the face of `h` and a spoke to every second one of its n corners, the first to the origin of
/// `h`: n / 2 quads.
///
/// V + 1, E + n / 2, F + n / 2 - 1. Cost: O(n).
///
/// # Errors
/// [`GrowError`]: `h` does not exist, n is odd or less than 4, or the structure is full.
pub fn quads(on: &mut impl Primitives, h: HalfEdgeId) -> Result<Fan, GrowError> {
    let dcel = on.dcel();
    dcel.check(h)?;
    let sides = dcel.cycle(h).count();
    if !sides.is_multiple_of(2) {
        return Err(GrowError::OddSides { h, face: dcel.face(h), sides });
    }
    spokes(on, h, 2, 4)
}

fn spokes(on: &mut impl Primitives, h: HalfEdgeId, step: usize, least: usize) -> Result<Fan, GrowError> {
    let dcel = on.dcel();
    let (face, sides) = (dcel.face(h), dcel.cycle(h).count());
    if sides < least {
        return Err(GrowError::FewSides { h, face, sides, least });
    }
    let new = sides / step;
    dcel.room_for(1, new, new - 1)?;
    // The half-edges that start at the corners with spokes; the first one's spoke is the spur.
    let corners: Vec<HalfEdgeId> = dcel.cycle(h).step_by(step).collect();
    let corner = dcel.ccw(h);
    let (spur, middle) = on.split_vertex(corner, corner)?;
    let (mut back, mut faces) = (spur.twin(), Vec::with_capacity(new));
    for &corner in &corners[1..] {
        let (spoke, new) = on.split_face(corner, back)?;
        faces.push(new);
        back = spoke.twin();
    }
    faces.push(face);
    Ok(Fan { middle, faces })
}
