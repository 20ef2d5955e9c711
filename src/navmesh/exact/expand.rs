//! From a cone to the cones behind it.
//!
//! ```text
//!                v2 ●────────● v1           The corners of the face behind the door, from the right post v0 on, are
//!                   │╲      ╱│              on the right of the cone, inside, or on its left, in this order. A side
//!                   │ ╲    ╱ │              is in sight if its first corner is not left of the cone, nor its second
//!        left post  ●══╪══╪══● v0           right of it.
//!                       ╲╱
//! ```
//!
//! Sides out of sight on the right are reached by a bend at the right post, if the cone ends there and a way may bend
//! there; so on the left. A side seen edge-on is passed by a bend at its nearer end.

use super::super::mesh::{ID, NavMesh, SHARED, TURN};
use super::super::nearest::distance;
use super::super::planner::Scratch;
use super::cone::{AT_POST, BENT_LEFT, BENT_RIGHT, ENDS_LEFT, ENDS_RIGHT, Node, START};
use super::search::Exact;
use crate::ids::FaceId;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// The face behind the door of a cone, with its corners from the right post on.
pub(super) struct Behind {
    start: usize,
    len: usize,
    /// The place of the right post.
    first: usize,
}

impl Behind {
    fn new(mesh: &NavMesh, face: u32, right_post: u32) -> Self {
        let range = mesh.range(FaceId::new(face));
        let first = mesh.sides[range.clone()].iter().position(|side| side.origin & ID == right_post);
        Self { start: range.start, len: range.len(), first: first.unwrap_or(0) }
    }

    /// The side from corner i to corner i + 1.
    #[inline]
    fn side(&self, i: usize) -> usize {
        let k = self.first + i;
        self.start + if k >= self.len { k - self.len } else { k }
    }
}

/// What all cones behind one door have in common.
struct Room<'a> {
    mesh: &'a NavMesh,
    scratch: &'a Scratch,
    parent: u32,
    behind: Behind,
}

impl Exact {
    /// Collects the cones behind the cone of node `parent`.
    pub(super) fn expand(&mut self, mesh: &NavMesh, scratch: &Scratch, parent: u32, node: &Node) {
        let right_post = mesh.sides[node.side as usize].origin & ID;
        let behind = Behind::new(mesh, node.face, right_post);
        let room = Room { mesh, scratch, parent, behind };
        if node.flags & AT_POST != 0 {
            for i in 0..room.behind.len - 1 {
                self.see_from_corner(&room, i, node.root, node.length, [None, None]);
            }
        } else {
            self.see_through_door(&room, node);
        }
    }

    /// The cones from the start, which lies in or on the closed face.
    pub(super) fn leave(&mut self, mesh: &NavMesh, scratch: &Scratch, face: FaceId, none: u32) {
        let range = mesh.range(face);
        let behind = Behind { start: range.start, len: range.len(), first: 0 };
        let room = Room { mesh, scratch, parent: none, behind };
        for i in 0..range.len() {
            self.see_from_corner(&room, i, START, 0.0, [None, None]);
        }
    }

    fn see_through_door(&mut self, room: &Room, node: &Node) {
        let mesh = room.mesh;
        let (root, before) = (self.point(mesh, node.root), self.point(mesh, node.before));
        let ray = |vertex: u32, bent: u32| {
            if node.flags & bent != 0 { [before, root] } else { [root, self.point(mesh, vertex)] }
        };
        let (left_ray, right_ray) = (ray(node.left, BENT_LEFT), ray(node.right, BENT_RIGHT));
        let last = room.behind.len - 1;
        let corner = |i: usize| mesh.sides[room.behind.side(i)].origin;
        let place = |origin: u32| mesh.points[(origin & ID) as usize];
        let (right_post, left_post) = (corner(0), corner(last));
        let bend_right = node.flags & ENDS_RIGHT != 0 && right_post & TURN != 0;
        let bend_left = node.flags & ENDS_LEFT != 0 && left_post & TURN != 0;

        // Where each corner is, seen from the right ray and from the left.
        let mut of_right = if node.flags & ENDS_RIGHT != 0 { Ordering::Equal } else { Ordering::Less };
        let mut of_left = Ordering::Less;
        for i in 0..last {
            let (next_of_right, next_of_left) = if i + 1 == last {
                (Ordering::Greater, if node.flags & ENDS_LEFT != 0 { Ordering::Equal } else { Ordering::Greater })
            } else {
                let p = place(corner(i + 1));
                let of_right = match of_right {
                    Ordering::Greater => Ordering::Greater,
                    _ => orientation(right_ray[0], right_ray[1], p),
                };
                let of_left = match (of_right, of_left) {
                    (_, Ordering::Greater) => Ordering::Greater,
                    (Ordering::Greater, _) => orientation(left_ray[0], left_ray[1], p),
                    _ => Ordering::Less,
                };
                (of_right, of_left)
            };
            let side = room.behind.side(i);
            if room.may_cross(side) {
                if next_of_right.is_gt() && of_left.is_lt() {
                    self.see(room, i, node, [of_right, next_of_left]);
                }
                if bend_right && (if i == 0 { next_of_right.is_le() } else { of_right.is_lt() }) {
                    self.bend(room, i, node, ENDS_RIGHT, next_of_right.is_le());
                }
                if bend_left && (if i + 1 == last { of_left.is_ge() } else { next_of_left.is_gt() }) {
                    self.bend(room, i, node, ENDS_LEFT, of_left.is_ge());
                }
                // Edge-on along a ray, further on than the post.
                if i > 0 && of_right.is_eq() && next_of_right.is_eq() {
                    self.bend_round(room, i, i, node.length + distance(root, place(corner(i))));
                }
                if i + 1 < last && of_left.is_eq() && next_of_left.is_eq() {
                    self.bend_round(room, i, i + 1, node.length + distance(root, place(corner(i + 1))));
                }
            }
            (of_right, of_left) = (next_of_right, next_of_left);
        }
    }

    /// The part of side i in sight of the root of the node. `seen` is where its first corner is from the right ray,
    /// and its second from the left one.
    fn see(&mut self, room: &Room, i: usize, node: &Node, [of_right, next_of_left]: [Ordering; 2]) {
        let [right, left] = room.ends(i);
        let mut cone = Node { flags: 0, ..room.cone(i, node.root, node.length) };
        cone.before = node.before;
        if of_right.is_ge() {
            (cone.right, cone.flags) = (right, cone.flags | ENDS_RIGHT);
        } else {
            (cone.right, cone.flags) = (node.right, cone.flags | node.flags & BENT_RIGHT);
        }
        if next_of_left.is_le() {
            (cone.left, cone.flags) = (left, cone.flags | ENDS_LEFT);
        } else {
            (cone.left, cone.flags) = (node.left, cone.flags | node.flags & BENT_LEFT);
        }
        self.fresh.push(cone);
    }

    /// Side i, or the part of it out of sight, seen from the post round which the way bends. `whole` if all of the
    /// side is out of sight.
    fn bend(&mut self, room: &Room, i: usize, node: &Node, at: u32, whole: bool) {
        let end = if at == ENDS_RIGHT { 0 } else { room.behind.len - 1 };
        let post = room.corner(end);
        let (root, p) = (self.point(room.mesh, node.root), room.mesh.points[(post & ID) as usize]);
        let length = node.length + distance(root, p);
        if !self.may_bend(room, end, length) {
            return;
        }
        let limit = (!whole).then_some(node.root);
        let limits = if at == ENDS_RIGHT { [limit, None] } else { [None, limit] };
        self.see_from_corner(room, i, post & ID, length, limits);
    }

    /// Side i seen from a point of the face: a corner, or the start. A limit on the left or on the right is the root
    /// before: the cone ends on the continuation of the line from there.
    fn see_from_corner(&mut self, room: &Room, i: usize, root: u32, length: f64, limits: [Option<u32>; 2]) {
        if !room.may_cross(room.behind.side(i)) {
            return;
        }
        let [right, left] = room.ends(i);
        if right == root || left == root {
            self.fresh.push(room.cone(i, root, length));
            return;
        }
        let p = self.point(room.mesh, root);
        let [a, b] = [right, left].map(|v| room.mesh.points[v as usize]);
        match orientation(p, a, b) {
            Ordering::Greater => {
                let mut cone = Node { flags: ENDS_LEFT | ENDS_RIGHT, left, right, ..room.cone(i, root, length) };
                if let [Some(before), _] = limits {
                    (cone.before, cone.flags) = (before, BENT_LEFT | ENDS_RIGHT);
                }
                if let [_, Some(before)] = limits {
                    (cone.before, cone.flags) = (before, BENT_RIGHT | ENDS_LEFT);
                }
                self.fresh.push(cone);
            }
            Ordering::Equal => {
                let [near, far] = if is_nearer(p, a, b) { [i, i + 1] } else { [i + 1, i] };
                let q = room.mesh.points[room.id(near)];
                // A start inside the side itself leaves it for both faces by their other sides; so does one at its end.
                let inside = q == p || !is_beyond(p, q, room.mesh.points[room.id(far)]);
                if !inside {
                    self.bend_round(room, i, near, length + distance(p, q));
                }
            }
            Ordering::Less => {}
        }
    }

    /// Side i from the corner at its one end, if the way may bend there.
    fn bend_round(&mut self, room: &Room, i: usize, end: usize, length: f64) {
        let origin = room.corner(end);
        if origin & TURN != 0 && self.may_bend(room, end, length) {
            self.fresh.push(room.cone(i, origin & ID, length));
        }
    }

    /// Whether no shorter way to corner i is known. In a double corner the wedges are different places: there the
    /// first corner of the wedge, clockwise, stands for it.
    fn may_bend(&mut self, room: &Room, i: usize, length: f64) -> bool {
        let (scratch, origin) = (room.scratch, room.corner(i));
        let (query, least) = if origin & SHARED == 0 {
            &mut self.roots[(origin & ID) as usize]
        } else {
            let wedge = room.mesh.first_corner_of_wedge(room.corner_side(i));
            self.shared_roots.entry(wedge).or_default()
        };
        if *query == scratch.query && *least < length {
            return false;
        }
        (*query, *least) = (scratch.query, length);
        true
    }
}

impl Room<'_> {
    /// Corner i with its marks.
    #[inline]
    fn corner(&self, i: usize) -> u32 {
        self.mesh.sides[self.corner_side(i)].origin
    }

    /// The side that starts at corner i.
    #[inline]
    fn corner_side(&self, i: usize) -> usize {
        self.behind.side(if i == self.behind.len { 0 } else { i })
    }

    fn id(&self, i: usize) -> usize {
        (self.corner(i) & ID) as usize
    }

    #[inline]
    fn ends(&self, i: usize) -> [u32; 2] {
        [i, i + 1].map(|i| self.corner(i) & ID)
    }

    #[inline]
    fn may_cross(&self, side: usize) -> bool {
        self.scratch.may_cross(self.mesh.sides[side].across)
    }

    /// A cone behind side i with the root at one of its posts.
    #[inline]
    fn cone(&self, i: usize, root: u32, length: f64) -> Node {
        let side = self.behind.side(i);
        let face = self.mesh.sides[side].across & ID;
        Node {
            length,
            root,
            before: START,
            left: START,
            right: START,
            face,
            side: side as u32,
            parent: self.parent,
            flags: AT_POST,
        }
    }
}

/// Of three points on a line, whether `a` is closer to `p` than `b`, by the greater of the differences.
fn is_nearer(p: Point, a: Point, b: Point) -> bool {
    let far = |q: Point| (q.x - p.x).abs().max((q.y - p.y).abs());
    far(a) < far(b)
}

/// Of three points on a line, whether `b` is on the other side of `a` than `p`.
fn is_beyond(p: Point, a: Point, b: Point) -> bool {
    use crate::plane::predicates::left_to_right;
    left_to_right(p, a) == left_to_right(a, b)
}
