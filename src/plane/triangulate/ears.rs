//! Ear clipping.
//!
//! ```text
//!            b               The corner a, b, c is an ear if it turns left and its closed triangle holds no vertex
//!          ╱   ╲             beside a, b and c. A vertex in it shows: the one nearest to b has a corner that is
//!        ╱   r   ╲           not convex, so only those are asked.
//!       a─ ─ ─ ─ ─c
//!      ╱           ╲         Some corner always is an ear: a triangulation has no closed chain of triangles, so one
//!                            of them has two sides in common with the boundary.
//! ```
//!
//! With bridges the boundary passes vertices twice. That changes nothing: the ends a and c may be passed again, and an
//! edge that leaves them into the triangle would lead to a vertex in it.

use super::TriangulateError;
use super::patch::Patch;
use crate::plane::Point;
use crate::plane::predicates::orientation;

const NONE: u32 = u32::MAX;

/// Cuts all faces of the patch, each of one cycle, into triangles.
///
/// Cost: O(n k) for a face of n corners, k of them not convex.
///
/// # Errors
/// [`TriangulateError::NotPlanar`] if no corner is an ear.
pub(super) fn clip(patch: &mut Patch) -> Result<(), TriangulateError> {
    let mut blunt = Blunt { corners: Vec::new(), index: Vec::new() };
    for i in 0..patch.parts.len() {
        clip_face(patch, patch.parts[i].first, &mut blunt)?;
    }
    Ok(())
}

/// The corners that are not convex.
struct Blunt {
    corners: Vec<u32>,
    /// Which of them each corner is, or `NONE`.
    index: Vec<u32>,
}

impl Blunt {
    /// Puts the corner in if it is not convex.
    fn look_at(&mut self, patch: &Patch, h: u32) {
        if !patch.turn(h).is_gt() {
            self.index[h as usize] = self.corners.len() as u32;
            self.corners.push(h);
        }
    }

    /// Takes the corner out if it is in.
    fn forget(&mut self, h: u32) {
        let i = std::mem::replace(&mut self.index[h as usize], NONE);
        if i == NONE {
            return;
        }
        self.corners.swap_remove(i as usize);
        if let Some(&moved) = self.corners.get(i as usize) {
            self.index[moved as usize] = i;
        }
    }

    /// Whether the corner of `b` is an ear.
    fn leaves_alone(&self, patch: &Patch, b: u32) -> bool {
        let places = [patch.prev(b), b, patch.next(b)].map(|h| patch.origin(h));
        let triangle = places.map(|place| patch.points[place as usize]);
        let (first, last) = (*places.iter().min().unwrap_or(&0), *places.iter().max().unwrap_or(&0));
        let inside = |&h: &u32| {
            let place = patch.origin(h);
            first < place && place < last && !places.contains(&place) && holds(triangle, patch.points[place as usize])
        };
        patch.turn(b).is_gt() && !self.corners.iter().any(inside)
    }
}

/// Whether the point lies in the closed triangle, which runs counter-clockwise.
fn holds([a, b, c]: [Point; 3], p: Point) -> bool {
    orientation(a, b, p).is_ge() && orientation(b, c, p).is_ge() && orientation(c, a, p).is_ge()
}

fn clip_face(patch: &mut Patch, start: u32, blunt: &mut Blunt) -> Result<(), TriangulateError> {
    blunt.index.resize(patch.len() as usize, NONE);
    blunt.corners.clear();
    let (mut h, mut left) = (start, 0_u32);
    loop {
        blunt.look_at(patch, h);
        left += 1;
        h = patch.next(h);
        if h == start {
            break;
        }
    }
    let mut missed = 0;
    while left > 3 {
        if !blunt.leaves_alone(patch, h) {
            missed += 1;
            if missed > left {
                return Err(patch.fault(h));
            }
            h = patch.next(h);
            continue;
        }
        (left, missed) = (left - 1, 0);
        let (a, c) = (patch.prev(h), patch.next(h));
        let rest = patch.cut(h);
        blunt.index.resize(patch.len() as usize, NONE);
        for corner in [a, c] {
            blunt.forget(corner);
        }
        for corner in [rest, c] {
            blunt.look_at(patch, corner);
        }
        // Not the next corner but the one after: ears all round rather than a fan.
        h = patch.next(c);
    }
    Ok(())
}
