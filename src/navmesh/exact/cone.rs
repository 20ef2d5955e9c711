//! A cone, as the search keeps it and as a figure wants it.
//!
//! ```text
//!     left post  ●══╲════════●  right post      ENDS: the ray runs through the post itself.
//!                    ╲      ╱                   BENT: the ray is the continuation of the line from the root before
//!              left ray    ╱  right ray         to the root; the way may not bend further.
//!                      ╲  ╱                     At a post: the root is one of the posts, and everything behind the
//!                      root                     door is in sight.
//! ```

use super::super::mesh::ID;
use super::super::rooms::Rooms;
use super::ray::Ray;
use crate::ids::FaceId;
use crate::plane::Point;

/// In `left` and `right`: what is out of sight may be reached by a bend at the post.
pub(super) const ENDS: u32 = 1 << 31;
/// In `left` and `right`: the ray continues the line from `before` to `root`.
pub(super) const BENT: u32 = 1 << 30;

/// The start as a root: greater than all ids of vertices.
pub(super) const START: u32 = ID;
/// As the root before: the root is a post of the door.
pub(super) const AT_POST: u32 = u32::MAX;

/// A cone in 32 bytes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Node {
    /// The length of the way to the root.
    pub(super) length: f64,
    /// A vertex, or [`START`].
    pub(super) root: u32,
    /// The root before, for bent rays, or [`AT_POST`].
    pub(super) before: u32,
    /// A corner on the left ray, and one on the right, by the side that starts there, with marks; meaningless if the
    /// ray is bent.
    pub(super) left: u32,
    pub(super) right: u32,
    /// The door by which the room behind is entered.
    pub(super) door: u32,
    /// The node it came from.
    pub(super) parent: u32,
}

impl Node {
    #[inline]
    pub(super) fn is_at_post(&self) -> bool {
        self.before == AT_POST
    }

    #[inline]
    pub(super) fn root<R: Rooms>(&self, rooms: &R, start: Point) -> Point {
        if self.root == START { start } else { rooms.point(self.root) }
    }

    /// The left and the right ray, from the root on or from the root before.
    #[inline]
    pub(super) fn rays<R: Rooms>(&self, rooms: &R, start: Point) -> [Ray; 2] {
        let root = self.root(rooms, start);
        [self.ray(rooms, start, root, self.left), self.ray(rooms, start, root, self.right)]
    }

    #[inline]
    fn ray<R: Rooms>(&self, rooms: &R, start: Point, root: Point, end: u32) -> Ray {
        if end & BENT == 0 {
            Ray::new(root, rooms.place((end & ID) as usize))
        } else {
            Ray::new(if self.before == START { start } else { rooms.point(self.before) }, root)
        }
    }
}

/// A cone that the last exact search looked at, for figures.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cone {
    /// Where it is seen from.
    pub root: Point,
    /// The left end of what is seen of the door, rounded.
    pub left: Point,
    /// The right end.
    pub right: Point,
    /// The face that was left.
    pub from: FaceId,
    /// The face behind the door.
    pub to: FaceId,
    /// The length of the way to the root.
    pub length: f64,
}
