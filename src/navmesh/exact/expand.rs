//! From a cone to the cones behind it.
//!
//! ```text
//!                v2 ●────────● v1           The corners of the room behind the portal, from the right endpoint v0 on, are
//!                   │╲      ╱│              on the right of the cone, inside, or on its left, in this order. A side
//!                   │ ╲    ╱ │              is in sight if its first corner is not left of the cone, nor its second
//!        left endpoint  ●══╪══╪══● v0           right of it.
//!                       ╲╱
//! ```
//!
//! Sides out of sight on the right are reached by a bend at the right endpoint, if the cone ends there and a path may bend
//! there; so on the left. A side seen edge-on is passed by a bend at its nearer end. A search of everything bends round
//! the nearest of the sides on a line only, and goes on to the next one when the order of lengths has come to it: most of
//! them have a shorter path by then.

use super::super::marks::{CLOSED, DEAD_END, ID, TURN};
use super::super::nearest::distance;
use super::super::rooms::{Corner, Rooms};
use super::super::scratch::Scratch;
use super::cone::{ALONG, AT_POST, BENT, Beam, ENDS, Node, START};
use super::ray::{Turn, difference};
use super::search::{Exact, KnownRoot};
use super::side::{EdgeOn, Side};
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;
use std::ops::Range;

/// The room behind the portal of a cone, and what all cones behind the portal have in common.
struct Behind<'a, R> {
    rooms: &'a R,
    scratch: &'a Scratch,
    start: Point,
    parent: u32,
    range: Range<usize>,
}

/// What sides are seen from.
#[derive(Clone, Copy)]
struct Root {
    /// A vertex, or [`START`].
    vertex: u32,
    at: Point,
    /// The length of the path to it.
    length: f64,
}

/// A ray that continues the line from a root before: that root, and the direction.
type Limit = (u32, [f64; 2]);

/// An endpoint of the portal, round which the path may bend.
struct Endpoint {
    corner: Corner,
    /// Whether a path may bend here at all.
    may_turn: bool,
    /// The endpoint as a root, once it was asked for; none if a shorter path to it is known.
    root: Option<Option<Root>>,
}

impl Endpoint {
    #[inline]
    fn new(corner: Corner, end: u32) -> Self {
        Self { corner, may_turn: end & ENDS != 0 && corner.vertex & TURN != 0, root: None }
    }
}

impl Exact {
    /// Finds the cones behind a cone, which is node `parent`. Returns the sides of the room that was entered.
    #[inline]
    pub(super) fn expand<R: Rooms>(&mut self, rooms: &R, scratch: &Scratch, parent: u32, beam: &Beam) -> Range<usize> {
        self.found.clear();
        let (range, first) = rooms.enter(beam.node.portal);
        let behind = Behind { rooms, scratch, start: self.start, parent, range };
        if beam.node.is_at_endpoint() {
            if beam.node.left == ALONG {
                self.go_along(&behind, first, beam);
            }
            let root = Root { vertex: beam.node.root, at: beam.root, length: beam.node.length };
            let portal = rooms.prev(&behind.range, first);
            self.see_all(&behind, first, portal, root);
        } else {
            self.see_through_portal(&behind, first, beam);
        }
        self.bend_round_nearest(&behind);
        behind.range
    }

    /// Finds the cones from the start, which lies in or on the closed room, besides those that were found already.
    pub(super) fn leave<R: Rooms>(&mut self, rooms: &R, scratch: &Scratch, room: u32, none: u32) -> Range<usize> {
        let behind = Behind { rooms, scratch, start: self.start, parent: none, range: rooms.range(room) };
        let root = Root { vertex: START, at: self.start, length: 0.0 };
        let (first, last) = (behind.range.start, behind.range.end - 1);
        self.see_all(&behind, first, last, root);
        let side = Side { number: last, next: first, right: rooms.corner(last), left: rooms.corner(first) };
        if behind.may_cross(&side) {
            self.see_from(&behind, &side, root, [None, None]);
        }
        self.bend_round_nearest(&behind);
        behind.range
    }

    /// The bends that were put off.
    fn bend_round_nearest<R: Rooms>(&mut self, behind: &Behind<R>) {
        while let Some(EdgeOn { from, length, side, forwards }) = self.edge_on.pop() {
            let corner = if forwards { side.right } else { side.left };
            self.bend_along(behind, &side, corner, from, length);
        }
    }

    /// From a side that was seen edge-on to the next one on the line round which a path may bend. A path to that one that
    /// is shorter than by way of the first makes all further ones useless.
    fn go_along<R: Rooms>(&mut self, behind: &Behind<R>, first: usize, beam: &Beam) {
        let Behind { rooms, ref range, parent, .. } = *behind;
        let twin = rooms.prev(range, first);
        let before = rooms.range(rooms.behind(rooms.portal(twin)));
        let here = rooms.side(beam.node.portal);
        let forwards = rooms.corner(here).vertex & ID == beam.node.root;
        let mut number = here;
        loop {
            number = if forwards { rooms.next(&before, number) } else { rooms.prev(&before, number) };
            let next = rooms.next(&before, number);
            let side = Side { number, next, right: rooms.corner(number), left: rooms.corner(next) };
            if number == here || orientation(beam.root, side.right.at, side.left.at).is_ne() {
                return;
            }
            let corner = if forwards { side.right } else { side.left };
            if corner.vertex & TURN != 0 && behind.may_cross(&side) {
                let from_there = Behind { parent: self.nodes[parent as usize].parent, range: before, ..*behind };
                let length = beam.node.length + distance(beam.root, corner.at);
                self.bend_along(&from_there, &side, corner, beam.node.root, length);
                return;
            }
        }
    }

    /// Sees all sides from `first` on up to the one before `last`.
    fn see_all<R: Rooms>(&mut self, behind: &Behind<R>, first: usize, last: usize, root: Root) {
        let (mut number, mut right) = (first, behind.rooms.corner(first));
        while number != last {
            let next = behind.rooms.next(&behind.range, number);
            let left = behind.rooms.corner(next);
            let side = Side { number, next, right, left };
            if behind.may_cross(&side) {
                self.see_from(behind, &side, root, [None, None]);
            }
            (number, right) = (next, left);
        }
    }

    fn see_through_portal<R: Rooms>(&mut self, behind: &Behind<R>, first: usize, beam: &Beam) {
        let (rooms, node, start) = (behind.rooms, &beam.node, behind.start);
        // The side that is the portal: it starts at the left endpoint.
        let portal = rooms.prev(&behind.range, first);
        let mut right_endpoint = Endpoint::new(rooms.corner(first), node.right);
        let mut left_endpoint = Endpoint::new(rooms.corner(portal), node.left);

        // Where the ends of the side are, seen from the right ray and from the left.
        let mut of_right = if node.right & ENDS != 0 { 0 } else { -1 };
        let mut of_left = -1;
        let (mut number, mut right) = (first, right_endpoint.corner);
        loop {
            let next = rooms.next(&behind.range, number);
            let left = rooms.corner(next);
            let (at_right_endpoint, at_left_endpoint) = (number == first, next == portal);
            let (next_of_right, next_of_left) = if at_left_endpoint {
                (1, if node.left & ENDS != 0 { 0 } else { 1 })
            } else {
                let of_right = if of_right > 0 { 1 } else { beam.of_right(rooms, start, left.at) };
                let of_left = if of_left > 0 {
                    1
                } else if of_right > 0 {
                    beam.of_left(rooms, start, left.at)
                } else {
                    -1
                };
                (of_right, of_left)
            };
            let side = Side { number, next, right, left };
            if behind.may_cross(&side) {
                if next_of_right > 0 && of_left < 0 {
                    self.see(behind, &side, beam, [of_right, next_of_left]);
                }
                if right_endpoint.may_turn && (if at_right_endpoint { next_of_right <= 0 } else { of_right < 0 }) {
                    self.bend(behind, &side, beam, &mut right_endpoint, [next_of_right > 0, false]);
                }
                if left_endpoint.may_turn && (if at_left_endpoint { of_left >= 0 } else { next_of_left > 0 }) {
                    self.bend(behind, &side, beam, &mut left_endpoint, [false, of_left < 0]);
                }
                // Edge-on along a ray, further on than the endpoint.
                if !at_right_endpoint && of_right == 0 && next_of_right == 0 {
                    self.bend_round(behind, &side, right, node.root, node.length + distance(beam.root, right.at));
                }
                if !at_left_endpoint && of_left == 0 && next_of_left == 0 {
                    self.bend_round(behind, &side, left, node.root, node.length + distance(beam.root, left.at));
                }
            }
            if at_left_endpoint || (next_of_left > 0 && !left_endpoint.may_turn) {
                break;
            }
            (of_right, of_left) = (next_of_right, next_of_left);
            (number, right) = (next, left);
        }
    }

    /// The part of a side in sight of the root: its right end is at `of_right` from the right ray, and its left end
    /// at `of_left` from the left one.
    #[inline]
    fn see<R: Rooms>(&mut self, behind: &Behind<R>, side: &Side, beam: &Beam, [of_right, of_left]: [Turn; 2]) {
        let Beam { node, root, .. } = *beam;
        let (right, right_end) = if of_right >= 0 {
            (difference(root, side.right.at), side.number as u32 | ENDS)
        } else {
            (beam.right, node.right & !ENDS)
        };
        let (left, left_end) = if of_left <= 0 {
            (difference(root, side.left.at), side.next as u32 | ENDS)
        } else {
            (beam.left, node.left & !ENDS)
        };
        let portal = behind.rooms.portal(side.number);
        let node = Node { right: right_end, left: left_end, portal, parent: behind.parent, ..node };
        self.found.push(Beam { node, root, left, right, endpoints: side.endpoints() });
    }

    /// A side, or the part of it out of sight, seen from the endpoint round which the path bends; on the left or on the
    /// right the cone may be limited by the line from the root before.
    #[inline]
    fn bend<R: Rooms>(
        &mut self,
        behind: &Behind<R>,
        side: &Side,
        beam: &Beam,
        endpoint: &mut Endpoint,
        limited: [bool; 2],
    ) {
        let Corner { at, vertex, .. } = endpoint.corner;
        if endpoint.root.is_none() {
            let length = beam.node.length + distance(beam.root, at);
            let vertex = vertex & ID;
            endpoint.root =
                Some(self.may_bend(behind, vertex, beam.node.root, length).then_some(Root { vertex, at, length }));
        }
        if let Some(Some(root)) = endpoint.root {
            let limit = (beam.node.root, difference(beam.root, at));
            // Not by `map` of the array: such calls are not always inlined, and this is the innermost loop.
            let [right, left] = limited;
            self.see_from(behind, side, root, [right.then_some(limit), left.then_some(limit)]);
        }
    }

    /// A side seen from a point of the room: a corner, or the start.
    fn see_from<R: Rooms>(&mut self, behind: &Behind<R>, side: &Side, root: Root, limits: [Option<Limit>; 2]) {
        if [side.right, side.left].iter().any(|corner| corner.vertex & ID == root.vertex) {
            self.found.push(behind.seen_from_endpoint(side, root));
            return;
        }
        let [right, left] = side.endpoints();
        match orientation(root.at, right, left) {
            Ordering::Greater => {
                let end = |limit: Option<Limit>, number: usize, at: Point| match limit {
                    Some((_, along)) => (along, BENT),
                    None => (difference(root.at, at), number as u32 | ENDS),
                };
                let [left_limit, right_limit] = limits;
                let ((left, left_end), (right, right_end)) =
                    (end(left_limit, side.next, left), end(right_limit, side.number, right));
                let beam = behind.seen_from_endpoint(side, root);
                let before = left_limit.or(right_limit).map_or(START, |(before, _)| before);
                let node = Node { before, left: left_end, right: right_end, ..beam.node };
                self.found.push(Beam { node, left, right, ..beam });
            }
            Ordering::Equal => {
                let [near, far] =
                    if is_nearer(root.at, right, left) { [side.right, side.left] } else { [side.left, side.right] };
                // A start inside the side itself leaves it for both rooms by their other sides; so does one at its end.
                let inside = near.at == root.at || !is_beyond(root.at, near.at, far.at);
                if !inside {
                    self.bend_round(behind, side, near, root.vertex, root.length + distance(root.at, near.at));
                }
            }
            Ordering::Less => {}
        }
    }

    /// A side from the corner at its one end, if the path may bend there.
    fn bend_round<R: Rooms>(&mut self, behind: &Behind<R>, side: &Side, corner: Corner, from: u32, length: f64) {
        let vertex = corner.vertex & ID;
        if corner.vertex & TURN == 0 {
            return;
        }
        if self.everything {
            let forwards = vertex == side.right.vertex & ID;
            let new = EdgeOn { from, length, side: *side, forwards };
            match self.edge_on.iter_mut().find(|old| old.from == from && old.forwards == forwards) {
                Some(old) if old.length <= length => {}
                Some(old) => *old = new,
                None => self.edge_on.push(new),
            }
        } else if self.may_bend(behind, vertex, from, length) {
            self.found.push(behind.seen_from_endpoint(side, Root { vertex, at: corner.at, length }));
        }
    }

    /// A side from the corner at its nearer end, to be gone on from along its line.
    fn bend_along<R: Rooms>(&mut self, behind: &Behind<R>, side: &Side, corner: Corner, from: u32, length: f64) {
        let vertex = corner.vertex & ID;
        if self.may_bend(behind, vertex, from, length) {
            let mut beam = behind.seen_from_endpoint(side, Root { vertex, at: corner.at, length });
            beam.node.left = ALONG;
            self.found.push(beam);
        }
    }

    /// Whether no shorter path to a vertex is known, and none as long that bends last elsewhere than at `from`: what lies
    /// behind the vertex for one of two such ways and not for the other, that other reaches by a shorter way, so that
    /// one of them is enough. All of them would be as many as there are orders of the steps between rows of pillars.
    ///
    /// At a double corner there is no question which wedge: ways bend in a wedge of more than half a turn, and no vertex
    /// has two of those.
    #[inline]
    fn may_bend<R: Rooms>(&mut self, behind: &Behind<R>, vertex: u32, from: u32, length: f64) -> bool {
        let query = behind.scratch.query;
        let known = &mut self.roots[vertex as usize];
        let is_enough = match known.length.total_cmp(&length) {
            Ordering::Less => true,
            Ordering::Equal => known.from != from,
            Ordering::Greater => false,
        };
        if known.query == query && is_enough {
            return false;
        }
        *known = KnownRoot { query, length, from };
        true
    }
}

impl<R: Rooms> Behind<'_, R> {
    #[inline]
    fn may_cross(&self, side: &Side) -> bool {
        let marks = side.right.marks & (CLOSED | DEAD_END);
        (marks == 0) | (marks == DEAD_END && self.is_allowed(side))
    }

    /// Whether the dead end behind a side is no useless one.
    #[cold]
    fn is_allowed(&self, side: &Side) -> bool {
        self.scratch.is_allowed(side.right.marks & ID)
    }

    /// A cone behind a side with the root at one of its endpoints.
    #[inline]
    fn seen_from_endpoint(&self, side: &Side, root: Root) -> Beam {
        let Root { vertex, at, length } = root;
        let (portal, parent) = (self.rooms.portal(side.number), self.parent);
        let node = Node { length, root: vertex, before: AT_POST, left: START, right: START, portal, parent };
        Beam { node, root: at, left: [0.0; 2], right: [0.0; 2], endpoints: side.endpoints() }
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
