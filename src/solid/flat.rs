//! Whether a face is flat, and whether it is convex. Exact.
//!
//! ```text
//!   flat: all corners lie in one plane         convex: seen from outside, no corner turns to the right, and
//!                                              the boundary goes round once
//!    ●───●      ●───●
//!    │   │      │ ╲ │ bent along a diagonal      ●───●      ●
//!    ●───●      ●───●                             ╲ ╱      ╱ ╲   ╱●      a face is looked at along the axis that
//!                                                  ●      ●───●─●        its normal is closest to
//! ```

use super::Polyhedron;
use super::predicates::{are_collinear, by_position, orient3d};
use super::vector::Vector;
use crate::ids::{FaceId, HalfEdgeId};
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// Where a corner of a face keeps it from being convex.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FaceFault {
    /// All corners lie on one line.
    NoArea,
    /// The corner at the origin of the half-edge turns to the right or goes straight back, or the boundary goes
    /// round a second time from there.
    Reflex(HalfEdgeId),
}

impl Polyhedron {
    /// Whether all corners of `f` lie in one plane. Exact. O(corners).
    #[must_use]
    pub fn is_flat(&self, f: FaceId) -> bool {
        self.spanning_corners(f).is_none_or(|corners| self.is_in_plane(f, corners))
    }

    /// Whether all corners of `f` lie in the plane of three of them.
    pub(super) fn is_in_plane(&self, f: FaceId, [a, b, c]: [Vector; 3]) -> bool {
        self.corners(f).all(|p| orient3d(a, b, c, p) == Ordering::Equal)
    }

    /// Three corners of `f` that do not lie on a line. O(corners).
    pub(super) fn spanning_corners(&self, f: FaceId) -> Option<[Vector; 3]> {
        let a = self.corners(f).next()?;
        let b = self.corners(f).find(|&p| by_position(p, a).is_ne())?;
        let c = self.corners(f).find(|&p| !are_collinear(a, b, p))?;
        Some([a, b, c])
    }

    /// Whether `f` is convex when it is looked at along the axis its normal is closest to; corners may lie on an
    /// edge. Exact but for the choice of the axis. O(corners).
    ///
    /// # Errors
    /// The first corner that is reflex.
    pub fn check_convex_face(&self, f: FaceId) -> Result<(), FaceFault> {
        let shadow = self.shadow(f);
        let shadow = |p| shadow.of(p);
        let mut turns_back = 0;
        let mut area = false;
        for h in self.incident_half_edges(f) {
            let dcel = self.topology();
            let [before, at, after] = [dcel.prev(h), h, h.twin()].map(|h| shadow(self.point(dcel.origin(h))));
            let (into, out) = (left_to_right(before, at), left_to_right(at, after));
            let turn = orientation(before, at, after);
            turns_back += u32::from(into != out);
            area |= turn == Ordering::Greater;
            // Straight on is allowed, straight back is not, and neither is staying in place.
            let straight_back = turn == Ordering::Equal && into != out;
            if turn == Ordering::Less || straight_back || out == Ordering::Equal || turns_back > 2 {
                return Err(if self.spanning_corners(f).is_none() { FaceFault::NoArea } else { FaceFault::Reflex(h) });
            }
        }
        if area { Ok(()) } else { Err(FaceFault::NoArea) }
    }

    /// How the corners of `f` look along the axis its normal is closest to, from outside. O(corners).
    pub(super) fn shadow(&self, f: FaceId) -> Shadow {
        let vector = self.area_vector(f);
        let axis = (0..3).max_by(|&i, &j| vector[i].abs().total_cmp(&vector[j].abs())).unwrap_or(2);
        let axes = [(axis + 1) % 3, (axis + 2) % 3];
        if vector[axis] < 0.0 { Shadow([axes[1], axes[0]]) } else { Shadow(axes) }
    }
}

/// Points of space seen along one of the three axes: the coordinates that are left, in the order in which they turn
/// to the left.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Shadow([usize; 2]);

impl Shadow {
    pub(super) fn of(self, p: Vector) -> Point {
        Point::new(p[self.0[0]], p[self.0[1]])
    }
}
