//! From a cone to the cones behind it.
//!
//! ```text
//!                v2 ●────────● v1           The corners of the room behind the door, from the right post v0 on, are
//!                   │╲      ╱│              on the right of the cone, inside, or on its left, in this order. A side
//!                   │ ╲    ╱ │              is in sight if its first corner is not left of the cone, nor its second
//!        left post  ●══╪══╪══● v0           right of it.
//!                       ╲╱
//! ```
//!
//! Sides out of sight on the right are reached by a bend at the right post, if the cone ends there and a way may bend
//! there; so on the left. A side seen edge-on is passed by a bend at its nearer end.

use super::super::mesh::{CLOSED, DEAD_END, ID, TURN};
use super::super::nearest::distance;
use super::super::planner::Scratch;
use super::super::rooms::Rooms;
use super::cone::{AT_POST, BENT, ENDS, Node, START};
use super::search::Exact;
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;
use std::ops::Range;

/// The room behind the door of a cone, with its corners from the right post on, and what else all cones behind the
/// door have in common.
struct Behind<'a, R> {
    rooms: &'a R,
    scratch: &'a Scratch,
    parent: u32,
    range: Range<usize>,
    /// The place of the right post.
    first: usize,
}

/// A post round which the way may bend.
struct Post {
    /// The corner at which it is.
    corner: usize,
    /// Whether a way may bend here at all.
    may_turn: bool,
    /// The length of the way to it, once it was asked for; none if a shorter one is known.
    length: Option<Option<f64>>,
}

impl Exact {
    /// Appends the cones behind the cone of node `parent`. Returns the sides of the room that was entered.
    #[inline]
    pub(super) fn expand<R: Rooms>(&mut self, rooms: &R, scratch: &Scratch, parent: u32, node: &Node) -> Range<usize> {
        let (range, first) = rooms.enter(node.door);
        let behind = Behind { rooms, scratch, parent, range, first };
        if node.is_at_post() {
            for i in 0..behind.range.len() - 1 {
                self.see_from_corner(&behind, i, node.root, node.length, [None, None]);
            }
        } else {
            self.see_through_door(&behind, node);
        }
        behind.range
    }

    /// Appends the cones from the start, which lies in or on the closed room.
    pub(super) fn leave<R: Rooms>(&mut self, rooms: &R, scratch: &Scratch, room: u32, none: u32) -> Range<usize> {
        let range = rooms.range(room);
        let behind = Behind { rooms, scratch, parent: none, first: range.start, range };
        for i in 0..behind.range.len() {
            self.see_from_corner(&behind, i, START, 0.0, [None, None]);
        }
        behind.range
    }

    fn see_through_door<R: Rooms>(&mut self, behind: &Behind<R>, node: &Node) {
        let [left_ray, right_ray] = node.rays(behind.rooms, self.start);
        let last = behind.range.len() - 1;
        let post = |corner: usize, end: u32| {
            let may_turn = end & ENDS != 0 && behind.corner(corner) & TURN != 0;
            Post { corner, may_turn, length: None }
        };
        let (mut right_post, mut left_post) = (post(0, node.right), post(last, node.left));

        // Where each corner is, seen from the right ray and from the left.
        let mut of_right = if node.right & ENDS != 0 { Ordering::Equal } else { Ordering::Less };
        let mut of_left = Ordering::Less;
        for i in 0..last {
            let (next_of_right, next_of_left) = if i + 1 == last {
                (Ordering::Greater, if node.left & ENDS != 0 { Ordering::Equal } else { Ordering::Greater })
            } else {
                let p = behind.place(i + 1);
                let of_right = if of_right.is_gt() { of_right } else { right_ray.turn(p) };
                let of_left = match (of_right, of_left) {
                    (_, Ordering::Greater) => Ordering::Greater,
                    (Ordering::Greater, _) => left_ray.turn(p),
                    _ => Ordering::Less,
                };
                (of_right, of_left)
            };
            if behind.may_cross(i) {
                if next_of_right.is_gt() && of_left.is_lt() {
                    self.see(behind, i, node, [of_right, next_of_left]);
                }
                if right_post.may_turn && (if i == 0 { next_of_right.is_le() } else { of_right.is_lt() }) {
                    let limit = next_of_right.is_gt().then_some(node.root);
                    self.bend(behind, i, node, &mut right_post, [limit, None]);
                }
                if left_post.may_turn && (if i + 1 == last { of_left.is_ge() } else { next_of_left.is_gt() }) {
                    let limit = of_left.is_lt().then_some(node.root);
                    self.bend(behind, i, node, &mut left_post, [None, limit]);
                }
                // Edge-on along a ray, further on than the post.
                let edge_on = |one: Ordering, other: Ordering| one.is_eq() && other.is_eq();
                for (end, seen) in [
                    (i, i > 0 && edge_on(of_right, next_of_right)),
                    (i + 1, i + 1 < last && edge_on(of_left, next_of_left)),
                ] {
                    if seen {
                        let far = distance(node.root(behind.rooms, self.start), behind.place(end));
                        self.bend_round(behind, i, end, node.length + far);
                    }
                }
            }
            (of_right, of_left) = (next_of_right, next_of_left);
            if of_left.is_gt() && !left_post.may_turn {
                break;
            }
        }
    }

    /// The part of side i in sight of the root of the node: its first corner is at `of_right` from the right ray, and
    /// its second at `next_of_left` from the left one.
    #[inline]
    fn see<R: Rooms>(&mut self, behind: &Behind<R>, i: usize, node: &Node, [of_right, next_of_left]: [Ordering; 2]) {
        let [right, left] = behind.ends(i);
        self.nodes.push(Node {
            right: if of_right.is_ge() { right | ENDS } else { node.right & !ENDS },
            left: if next_of_left.is_le() { left | ENDS } else { node.left & !ENDS },
            before: node.before,
            ..behind.cone(i, node.root, node.length)
        });
    }

    /// Side i, or the part of it out of sight, seen from the post round which the way bends. A limit on the left or on
    /// the right is the root before.
    fn bend<R: Rooms>(&mut self, behind: &Behind<R>, i: usize, node: &Node, post: &mut Post, limits: [Option<u32>; 2]) {
        if post.length.is_none() {
            let root = node.root(behind.rooms, self.start);
            let length = node.length + distance(root, behind.place(post.corner));
            post.length = Some(self.may_bend(behind, post.corner, length).then_some(length));
        }
        if let Some(Some(length)) = post.length {
            self.see_from_corner(behind, i, behind.corner(post.corner) & ID, length, limits);
        }
    }

    /// Side i seen from a point of the room: a corner, or the start. A limit on the left or on the right is the root
    /// before: the cone ends on the continuation of the line from there.
    fn see_from_corner<R: Rooms>(
        &mut self,
        behind: &Behind<R>,
        i: usize,
        root: u32,
        length: f64,
        limits: [Option<u32>; 2],
    ) {
        if !behind.may_cross(i) {
            return;
        }
        let [right, left] = behind.ends(i);
        if [i, i + 1].iter().any(|&i| behind.corner(i) & ID == root) {
            self.nodes.push(behind.cone(i, root, length));
            return;
        }
        let p = if root == START { self.start } else { behind.rooms.point(root) };
        let [a, b] = [i, i + 1].map(|i| behind.place(i));
        match orientation(p, a, b) {
            Ordering::Greater => {
                let [left_limit, right_limit] = limits;
                self.nodes.push(Node {
                    before: left_limit.or(right_limit).unwrap_or(START),
                    left: if left_limit.is_some() { BENT } else { left | ENDS },
                    right: if right_limit.is_some() { BENT } else { right | ENDS },
                    ..behind.cone(i, root, length)
                });
            }
            Ordering::Equal => {
                let [near, far] = if is_nearer(p, a, b) { [i, i + 1] } else { [i + 1, i] };
                let q = behind.place(near);
                // A start inside the side itself leaves it for both rooms by their other sides; so does one at its end.
                let inside = q == p || !is_beyond(p, q, behind.place(far));
                if !inside {
                    self.bend_round(behind, i, near, length + distance(p, q));
                }
            }
            Ordering::Less => {}
        }
    }

    /// Side i from the corner at its one end, if the way may bend there.
    fn bend_round<R: Rooms>(&mut self, behind: &Behind<R>, i: usize, end: usize, length: f64) {
        let corner = behind.corner(end);
        if corner & TURN != 0 && self.may_bend(behind, end, length) {
            self.nodes.push(behind.cone(i, corner & ID, length));
        }
    }

    /// Whether no shorter way to the vertex at corner i is known. At a double corner there is no question which wedge:
    /// ways bend in a wedge of more than half a turn, and no vertex has two of those.
    fn may_bend<R: Rooms>(&mut self, behind: &Behind<R>, i: usize, length: f64) -> bool {
        let query = behind.scratch.query;
        let known = &mut self.roots[(behind.corner(i) & ID) as usize];
        if known.0 == query && known.1 < length {
            return false;
        }
        *known = (query, length);
        true
    }
}

impl<R: Rooms> Behind<'_, R> {
    /// The side from corner i to corner i + 1; i may be the number of corners.
    #[inline]
    fn side(&self, i: usize) -> usize {
        let s = self.first + i;
        if s < self.range.end { s } else { s - self.range.len() }
    }

    /// Corner i with its marks.
    #[inline]
    fn corner(&self, i: usize) -> u32 {
        self.rooms.origin(self.side(i))
    }

    /// The point of corner i.
    #[inline]
    fn place(&self, i: usize) -> Point {
        self.rooms.place(self.side(i))
    }

    /// The corners at the ends of side i, by the sides that start there.
    #[inline]
    fn ends(&self, i: usize) -> [u32; 2] {
        [i, i + 1].map(|i| self.side(i) as u32)
    }

    #[inline]
    fn may_cross(&self, i: usize) -> bool {
        let s = self.side(i);
        match self.rooms.marks(s) & (CLOSED | DEAD_END) {
            0 => true,
            DEAD_END => self.scratch.is_allowed(self.rooms.behind(self.rooms.door(s))),
            _ => false,
        }
    }

    /// A cone behind side i with the root at one of its posts.
    #[inline]
    fn cone(&self, i: usize, root: u32, length: f64) -> Node {
        let (door, parent) = (self.rooms.door(self.side(i)), self.parent);
        Node { length, root, before: AT_POST, left: START, right: START, door, parent }
    }
}

/// Of three points on a line, whether `a` is closer to `p` than `b`, by the greater of the differences.
fn is_nearer(p: Point, a: Point, b: Point) -> bool {
    let far = |q: Point| (q.x - p.x).abs().max((q.y - p.y).abs());
    far(a) < far(b)
}

/// Of three points on a line, whether `b` is on the other side of `a` than `p`.
fn is_beyond(p: Point, a: Point, b: Point) -> bool {
    left_to_right(p, a) == left_to_right(a, b)
}
