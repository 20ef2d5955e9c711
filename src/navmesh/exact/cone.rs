//! A cone, as the search keeps it and as a figure wants it.
//!
//! ```text
//!     left post  ●══╲════════●  right post      ENDS_LEFT, ENDS_RIGHT: the ray runs through the post itself.
//!                    ╲      ╱                   BENT_LEFT, BENT_RIGHT: the ray is the continuation of the line from
//!              left ray    ╱  right ray         the root before to the root; the way may not bend further.
//!                      ╲  ╱                     AT_POST: the root is one of the posts, and everything behind the
//!                      root                     door is in sight.
//! ```

use crate::ids::FaceId;
use crate::plane::Point;

/// The ray runs through the post: what is out of sight may be reached by a bend there.
pub(super) const ENDS_LEFT: u32 = 1;
pub(super) const ENDS_RIGHT: u32 = 2;
/// The ray continues the line from `before` to `root`.
pub(super) const BENT_LEFT: u32 = 4;
pub(super) const BENT_RIGHT: u32 = 8;
/// The root is a post.
pub(super) const AT_POST: u32 = 16;

/// The start as a root; all others are numbers of vertices.
pub(super) const START: u32 = u32::MAX;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Node {
    /// The length of the way to the root.
    pub(super) length: f64,
    /// A vertex, or [`START`].
    pub(super) root: u32,
    /// The root before, for bent rays.
    pub(super) before: u32,
    /// A vertex on the left ray, and one on the right; meaningless if it is bent.
    pub(super) left: u32,
    pub(super) right: u32,
    /// The face that is entered, and the side of the face before by which it is.
    pub(super) face: u32,
    pub(super) side: u32,
    /// The node it came from.
    pub(super) parent: u32,
    pub(super) flags: u32,
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
