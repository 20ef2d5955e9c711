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

//!
//! Cutting an ear changes no corner but its two neighbours. An ear stays one; and a corner that is none stays none: if
//! the tip of the ear lay in its triangle, so did a vertex nearer to it, whose corner is not convex. So each corner is
//! asked once, and its neighbours again after each cut.

use super::candidates::Candidates;
use super::patch::Patch;
use super::reflex::ReflexCorners;
use super::{EarEvent, TriangulateError};
use crate::ids::VertexId;
use crate::progress::Stage;
use crate::topology::Observer;

/// Cuts all faces of the patch, each of one cycle, into triangles.
///
/// Cost: O(n (√k + log n)) for a face of n corners, k of them not convex, if few corners share a vertex.
///
/// # Errors
/// [`TriangulateError::NotPlanar`] if no corner is an ear.
pub(super) fn clip(patch: &mut Patch, observer: &mut impl Observer<EarEvent>) -> Result<(), TriangulateError> {
    let mut clipper = Clipper::default();
    for i in 0..patch.parts.len() {
        clipper.clip_face(patch, patch.parts[i].first, observer)?;
    }
    Ok(())
}

/// What is known of the face that is being cut. Its corners have numbers along its boundary; when an ear goes, the
/// half-edge of the diagonal takes the number of the corner before it.
#[derive(Default)]
struct Clipper {
    /// The half-edge that leaves each corner.
    corners: Vec<u32>,
    /// The corner that each half-edge of the patch leaves.
    numbers: Vec<u32>,
    reflex: ReflexCorners,
    /// The corners that have not been asked since something changed beside them.
    unasked: Candidates,
}

impl Clipper {
    fn clip_face(
        &mut self,
        patch: &mut Patch,
        start: u32,
        observer: &mut impl Observer<EarEvent>,
    ) -> Result<(), TriangulateError> {
        self.begin(patch, start);
        let (mut at, mut left) = (0, self.corners.len());
        let stage = Stage::new("triangulating", left);
        while left > 3 {
            stage.at(self.corners.len() - left);
            let Some(number) = self.unasked.next(at) else { return Err(patch.fault(self.corners[at])) };
            self.unasked.remove(number);
            let h = self.corners[number];
            if !self.is_ear(patch, h) {
                let is_convex = || patch.turn(h).is_gt();
                observer.observe(|| EarEvent::Refused { corners: corners(patch, h), is_convex: is_convex() });
                at = number;
                continue;
            }
            observer.observe(|| EarEvent::Cut(corners(patch, h)));
            let (before, after) = (patch.prev(h), patch.next(h));
            let [before, after] = [before, after].map(|h| self.numbers[h as usize]);
            let rest = patch.cut(h);
            left -= 1;
            self.numbers.resize(patch.len() as usize, 0);
            self.numbers[rest as usize] = before;
            self.corners[before as usize] = rest;
            for corner in [before, after] {
                self.unasked.insert(corner as usize);
                if patch.turn(self.corners[corner as usize]).is_gt() {
                    self.reflex.remove(corner);
                }
            }
            // Not the next corner but the one after: ears all round rather than a fan.
            at = self.numbers[patch.next(self.corners[after as usize]) as usize] as usize;
        }
        Ok(())
    }

    fn begin(&mut self, patch: &Patch, start: u32) {
        self.corners.clear();
        self.numbers.resize(patch.len() as usize, 0);
        let mut h = start;
        loop {
            self.numbers[h as usize] = self.corners.len() as u32;
            self.corners.push(h);
            h = patch.next(h);
            if h == start {
                break;
            }
        }
        self.reflex.begin(patch, &self.corners);
        self.unasked.begin(self.corners.len());
    }

    fn is_ear(&self, patch: &Patch, b: u32) -> bool {
        let places = [patch.prev(b), b, patch.next(b)].map(|h| patch.origin(h));
        patch.turn(b).is_gt() && !self.reflex.any_in(patch, places)
    }
}

/// The vertices before, at and after the corner that `h` leaves.
fn corners(patch: &Patch, h: u32) -> [VertexId; 3] {
    [patch.prev(h), h, patch.next(h)].map(|h| patch.vertex(patch.origin(h)))
}
