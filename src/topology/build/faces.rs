//! Where the builder reads its faces from, and what must hold for each face on its own.
//!
//! ```text
//!        2                 cycle (0, 1, 2), counter-clockwise: corner k stands for the half-edge from the
//!       / ^                k-th vertex to the next one, so corners and half-edges of faces are the same
//!    2 v   \ 1             thing under two names. All corners of all cycles are numbered through, in order.
//!     0 ──> 1
//!        0
//! ```

use super::BuildError;
use crate::topology::PolygonList;

/// A list of faces, each one or more cycles of corners. Implementations are monomorphised into the loops.
pub(crate) trait Faces {
    /// The number of faces.
    fn face_count(&self) -> usize;

    /// All corners of all cycles, in order.
    fn corners(&self) -> &[u32];

    /// Calls `visit(face, cycle of the face, corners)` for each cycle in order, until it fails.
    fn try_for_each_cycle<E>(&self, visit: impl FnMut(u32, usize, &[u32]) -> Result<(), E>) -> Result<(), E>;

    /// Finds the first face that is wrong by itself: too few corners, a vertex that does not exist, a vertex
    /// twice on one cycle. O(corners + vertices).
    fn check_each(&self, vertices: usize) -> Result<(), BuildError>;
}

impl Faces for [[u32; 3]] {
    fn face_count(&self) -> usize {
        self.len()
    }

    fn corners(&self) -> &[u32] {
        self.as_flattened()
    }

    #[inline(always)]
    fn try_for_each_cycle<E>(&self, mut visit: impl FnMut(u32, usize, &[u32]) -> Result<(), E>) -> Result<(), E> {
        self.iter().enumerate().try_for_each(|(face, corners)| visit(face as u32, 0, corners))
    }

    fn check_each(&self, vertices: usize) -> Result<(), BuildError> {
        // The first question is asked of all triangles at once, without branches.
        let bad = |&[a, b, c]: &[u32; 3]| (a.max(b).max(c) as usize >= vertices) | (a == b) | (b == c) | (c == a);
        if !self.iter().fold(false, |any, triangle| any | bad(triangle)) {
            return Ok(());
        }
        let face = self.iter().position(bad).map_or(0, |face| face as u32);
        check_cycle(face, &self[face as usize], vertices, |i, corners| corners[..i].contains(&corners[i]))
    }
}

impl Faces for PolygonList {
    fn face_count(&self) -> usize {
        self.face_count()
    }

    fn corners(&self) -> &[u32] {
        self.corners()
    }

    #[inline(always)]
    fn try_for_each_cycle<E>(&self, mut visit: impl FnMut(u32, usize, &[u32]) -> Result<(), E>) -> Result<(), E> {
        (0..self.face_count()).try_for_each(|face| {
            self.cycles(face).enumerate().try_for_each(|(cycle, corners)| visit(face as u32, cycle, corners))
        })
    }

    fn check_each(&self, vertices: usize) -> Result<(), BuildError> {
        // Short cycles are compared corner by corner, long ones through the last cycle each vertex was on.
        const SHORT: usize = 16;
        let mut last_cycle = Vec::new();
        let mut stamp = 0;
        self.try_for_each_cycle(|face, _, corners| {
            if corners.len() <= SHORT {
                return check_cycle(face, corners, vertices, |i, corners| corners[..i].contains(&corners[i]));
            }
            last_cycle.resize(vertices, 0);
            stamp += 1;
            check_cycle(face, corners, vertices, |i, corners| {
                std::mem::replace(&mut last_cycle[corners[i] as usize], stamp) == stamp
            })
        })
    }
}

/// Checks one cycle. `seen(i)` says whether corner `i` stands among the corners before it; it is asked for
/// each corner in turn, and only about vertices that exist.
fn check_cycle(
    face: u32,
    corners: &[u32],
    vertices: usize,
    mut seen: impl FnMut(usize, &[u32]) -> bool,
) -> Result<(), BuildError> {
    if corners.len() < 3 {
        return Err(BuildError::TooFewCorners { face, corners: corners.len() });
    }
    for (i, &vertex) in corners.iter().enumerate() {
        if vertex as usize >= vertices {
            return Err(BuildError::IndexOutOfRange { face, vertex, vertices });
        }
        if seen(i, corners) {
            return Err(BuildError::RepeatedVertex { face, vertex });
        }
    }
    Ok(())
}
