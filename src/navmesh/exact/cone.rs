//! A cone, as the search keeps it and as a figure wants it.
//!
//! ```text
//!     left endpoint  ●══╲════════●  right endpoint      ENDS: the ray runs through the endpoint itself.
//!                    ╲      ╱                   BENT: the ray is the continuation of the line from the root before
//!              left ray    ╱  right ray         to the root; the path may not bend further.
//!                      ╲  ╱                     At an endpoint: the root is one of the endpoints, and everything behind the
//!                      root                     portal is in sight.
//! ```

use super::super::marks::ID;
use super::super::rooms::Rooms;
use super::ray::{Ray, Turn, difference};
use crate::ids::FaceId;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// In `left` and `right`: what is out of sight may be reached by a bend at the endpoint.
pub(super) const ENDS: u32 = 1 << 31;
/// In `left` and `right`: the ray continues the line from `before` to `root`.
pub(super) const BENT: u32 = 1 << 30;

/// The start as a root: greater than all ids of vertices.
pub(super) const START: u32 = ID;
/// In `left`, where the root is an endpoint of the portal: the portal was seen edge-on, and so may be others further on.
pub(super) const ALONG: u32 = BENT;
/// As the root before: the root is an endpoint of the portal.
pub(super) const AT_POST: u32 = u32::MAX;

/// A cone in 32 bytes: what is kept of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Node {
    /// The length of the path to the root.
    pub(super) length: f64,
    /// A vertex, or [`START`].
    pub(super) root: u32,
    /// The root before, for bent rays, or [`AT_POST`].
    pub(super) before: u32,
    /// A corner on the left ray, and one on the right, by the side that starts there, with marks; meaningless if the
    /// ray is bent.
    pub(super) left: u32,
    pub(super) right: u32,
    /// The portal by which the room behind is entered.
    pub(super) portal: u32,
    /// The node it came from.
    pub(super) parent: u32,
}

impl Node {
    #[inline]
    pub(super) fn is_at_endpoint(&self) -> bool {
        self.before == AT_POST
    }
}

/// A cone with its points at hand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beam {
    pub(super) node: Node,
    /// The place of the root.
    pub(super) root: Point,
    /// The directions of the left and of the right ray; meaningless if the root is at an endpoint.
    pub(super) left: [f64; 2],
    pub(super) right: [f64; 2],
    /// The endpoints of the portal, the right one first.
    pub(super) endpoints: [Point; 2],
}

impl Beam {
    /// The cone of a node, whose portal has these endpoints.
    #[inline]
    pub(super) fn new<R: Rooms>(rooms: &R, start: Point, node: Node, endpoints: [Point; 2]) -> Self {
        let root = place(rooms, start, node.root);
        let along = |end: u32| {
            if node.is_at_endpoint() {
                [0.0; 2]
            } else if end & BENT == 0 {
                difference(root, rooms.place((end & ID) as usize))
            } else {
                difference(place(rooms, start, node.before), root)
            }
        };
        Self { node, root, left: along(node.left), right: along(node.right), endpoints }
    }

    pub(super) fn left_ray(&self) -> Ray {
        Ray { from: self.root, along: self.left }
    }

    pub(super) fn right_ray(&self) -> Ray {
        Ray { from: self.root, along: self.right }
    }

    /// On which side of the left ray a point is.
    #[inline]
    pub(super) fn of_left<R: Rooms>(&self, rooms: &R, start: Point, p: Point) -> Turn {
        self.left_ray().turn(p, || self.exactly(rooms, start, self.node.left, p))
    }

    /// On which side of the right ray a point is.
    #[inline]
    pub(super) fn of_right<R: Rooms>(&self, rooms: &R, start: Point, p: Point) -> Turn {
        self.right_ray().turn(p, || self.exactly(rooms, start, self.node.right, p))
    }

    /// On which side of the ray with this end a point is, by the points that were given.
    #[cold]
    fn exactly<R: Rooms>(&self, rooms: &R, start: Point, end: u32, p: Point) -> Ordering {
        if end & BENT == 0 {
            orientation(self.root, rooms.place((end & ID) as usize), p)
        } else {
            orientation(place(rooms, start, self.node.before), self.root, p)
        }
    }
}

/// Where a root is.
#[inline]
fn place<R: Rooms>(rooms: &R, start: Point, root: u32) -> Point {
    if root == START { start } else { rooms.point(root) }
}

/// A cone that the last exact search looked at, for figures.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cone {
    /// Where it is seen from.
    pub root: Point,
    /// The left end of what is seen of the portal, rounded.
    pub left: Point,
    /// The right end.
    pub right: Point,
    /// The face that was left.
    pub from: FaceId,
    /// The face behind the portal.
    pub to: FaceId,
    /// The length of the path to the root.
    pub length: f64,
}
