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
    /// Whether all that [`check_each`](Self::check_each) finds shows at some half-edge by itself: an end that is no vertex, or
    /// both ends the same.
    const SHOWN_BY_ENDS: bool;

    /// The number of faces.
    fn face_count(&self) -> usize;

    /// All corners of all cycles, in order.
    fn corners(&self) -> &[u32];

    /// Calls `visit(face, cycle of the face, corners)` for each cycle in order, until it fails.
    fn try_for_each_cycle<E>(&self, visit: impl FnMut(u32, usize, &[u32]) -> Result<(), E>) -> Result<(), E>;

    /// Calls `visit(corner, from, to)` for the half-edge of each corner in order, until it fails.
    fn try_for_each_half_edge<E>(&self, visit: impl FnMut(u32, u32, u32) -> Result<(), E>) -> Result<(), E>;

    /// The same for a `visit` that cannot fail.
    #[inline(always)]
    fn for_each_half_edge(&self, mut visit: impl FnMut(u32, u32, u32)) {
        let Ok(()) = self.try_for_each_half_edge::<std::convert::Infallible>(|corner, from, to| {
            visit(corner, from, to);
            Ok(())
        });
    }

    /// A function that tells where a corner is. Making it is O(corners), each call O(1).
    fn around(&self) -> impl Fn(usize) -> Around;

    /// Finds the first face that is wrong by itself: too few corners, a vertex that does not exist, a vertex
    /// twice on one cycle. O(corners + vertices).
    fn check_each(&self, vertices: usize) -> Result<(), BuildError>;
}

/// The surroundings of a corner.
pub(crate) struct Around {
    /// Its face.
    pub(crate) face: u32,
    /// The corner before it on its cycle.
    pub(crate) before: usize,
    /// The corner after it on its cycle.
    pub(crate) after: usize,
}

impl Faces for [[u32; 3]] {
    const SHOWN_BY_ENDS: bool = true;

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

    #[inline(always)]
    fn try_for_each_half_edge<E>(&self, mut visit: impl FnMut(u32, u32, u32) -> Result<(), E>) -> Result<(), E> {
        let mut corner = 0;
        for &[a, b, c] in self {
            visit(corner, a, b)?;
            visit(corner + 1, b, c)?;
            visit(corner + 2, c, a)?;
            corner += 3;
        }
        Ok(())
    }

    #[inline(always)]
    fn around(&self) -> impl Fn(usize) -> Around {
        |corner| {
            let face = corner as u32 / 3;
            let place = corner - 3 * face as usize;
            // Sums, not branches: the places of twins are as good as random.
            let before = corner + 3 * usize::from(place == 0) - 1;
            let after = corner + 1 - 3 * usize::from(place == 2);
            Around { face, before, after }
        }
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
    const SHOWN_BY_ENDS: bool = false;

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

    #[inline(always)]
    fn try_for_each_half_edge<E>(&self, mut visit: impl FnMut(u32, u32, u32) -> Result<(), E>) -> Result<(), E> {
        let mut corner = 0;
        for ends in self.cycle_starts().windows(2) {
            let corners = &self.corners()[ends[0] as usize..ends[1] as usize];
            let afters = corners.iter().skip(1).chain(corners.first());
            for (&from, &to) in corners.iter().zip(afters) {
                visit(corner, from, to)?;
                corner += 1;
            }
        }
        Ok(())
    }

    fn around(&self) -> impl Fn(usize) -> Around {
        // By corner: its cycle. By cycle: its face.
        let mut cycle_of = Vec::with_capacity(self.corner_count());
        let mut face_of = Vec::with_capacity(self.cycle_count());
        let _ = self.try_for_each_cycle::<()>(|face, _, corners| {
            cycle_of.resize(cycle_of.len() + corners.len(), face_of.len() as u32);
            face_of.push(face);
            Ok(())
        });
        move |corner| {
            let cycle = cycle_of[corner] as usize;
            let [start, end] = [cycle, cycle + 1].map(|c| self.cycle_starts()[c] as usize);
            Around {
                face: face_of[cycle],
                before: if corner == start { end - 1 } else { corner - 1 },
                after: if corner + 1 == end { start } else { corner + 1 },
            }
        }
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
