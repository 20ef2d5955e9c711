//! The search itself: cones in the order of their guesses.

use super::super::Place;
use super::super::mesh::{ID, NONE, NavMesh};
use super::super::nearest::{closest_on, distance};
use super::super::planner::{Planner, Scratch};
use super::cone::{AT_POST, BENT_LEFT, BENT_RIGHT, Cone, ENDS_LEFT, ENDS_RIGHT, Node, START};
use super::estimate::{between, estimate};
use crate::ids::FaceId;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::{Ordering, Reverse};
use std::collections::BTreeMap;

/// The memory of the exact search.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Exact {
    pub(super) nodes: Vec<Node>,
    /// The successors of one node.
    pub(super) fresh: Vec<Node>,
    /// For each vertex in which query it was a root, and the shortest way there.
    pub(super) roots: Vec<(u32, f64)>,
    /// The same for the wedges of double corners, by their first side.
    pub(super) shared_roots: BTreeMap<usize, (u32, f64)>,
    start: Point,
}

impl Exact {
    /// The point of a root.
    #[inline]
    pub(super) fn point(&self, mesh: &NavMesh, v: u32) -> Point {
        if v == START { self.start } else { mesh.points[v as usize] }
    }

    fn begin(&mut self, mesh: &NavMesh, scratch: &Scratch, start: Point) {
        if scratch.query == 1 {
            self.roots.clear();
            self.shared_roots.clear();
        }
        self.roots.resize(mesh.vertex_bound().max(self.roots.len()), (0, 0.0));
        self.nodes.clear();
        self.start = start;
    }

    /// Finds the doors of the shortest way. Returns whether there is one.
    pub(in super::super) fn search(
        &mut self,
        mesh: &NavMesh,
        scratch: &mut Scratch,
        start: &Place,
        goal: Point,
    ) -> bool {
        self.begin(mesh, scratch, start.point);
        self.fresh.clear();
        for &face in &scratch.starts {
            self.leave(mesh, scratch, face, NONE);
        }
        let mut best = (f64::INFINITY, NONE);
        self.enqueue(mesh, scratch, goal, best.0);
        while let Some(Reverse((key, mut i))) = scratch.queue.pop() {
            if f64::from_bits(key) >= best.0 {
                break;
            }
            scratch.work.pops += 1;
            // A single successor is looked at straight away.
            loop {
                let node = self.nodes[i as usize];
                if node.length >= best.0 || self.is_outdone(scratch, &node) {
                    break;
                }
                scratch.work.expansions += 1;
                if scratch.goals.contains(&FaceId::new(node.face))
                    && let Some(length) = self.length_to(mesh, &node, goal)
                    && length < best.0
                {
                    best = (length, i);
                }
                self.fresh.clear();
                self.expand(mesh, scratch, i, &node);
                let [only] = self.fresh[..] else {
                    self.enqueue(mesh, scratch, goal, best.0);
                    break;
                };
                i = self.nodes.len() as u32;
                self.nodes.push(only);
            }
        }
        let mut at = best.1;
        while at != NONE {
            let node = self.nodes[at as usize];
            scratch.doors.push((face_before(mesh, &node), node.side));
            at = node.parent;
        }
        best.1 != NONE
    }

    /// Puts the fresh nodes into the queue.
    fn enqueue(&mut self, mesh: &NavMesh, scratch: &mut Scratch, goal: Point, best: f64) {
        for node in self.fresh.drain(..) {
            let start = self.start;
            let point = |v: u32| if v == START { start } else { mesh.points[v as usize] };
            let guess = node.length + guess(mesh, &node, point, goal);
            if guess < best {
                scratch.push(guess, self.nodes.len() as u32);
                self.nodes.push(node);
            }
        }
    }

    /// Whether a shorter way to the root of the node has been found since.
    fn is_outdone(&self, scratch: &Scratch, node: &Node) -> bool {
        if node.root == START {
            return false;
        }
        let (query, least) = self.roots[node.root as usize];
        query == scratch.query && least < node.length
    }

    /// Looks at every cone that begins within `limit`, without a goal, and tells `see` the shortest length to each
    /// corner in sight, again whenever it is seen.
    pub(in super::super) fn survey(
        &mut self,
        mesh: &NavMesh,
        scratch: &mut Scratch,
        start: &Place,
        limit: f64,
        mut see: impl FnMut(u32, f64),
    ) {
        self.begin(mesh, scratch, start.point);
        self.fresh.clear();
        for &face in &scratch.starts {
            self.leave(mesh, scratch, face, NONE);
            for v in mesh.corners(face) {
                see(v.number(), distance(start.point, mesh.point(v)));
            }
        }
        loop {
            while let Some(node) = self.fresh.pop() {
                let (root, [right, left]) = (self.point(mesh, node.root), posts(mesh, &node));
                let part = if node.flags & AT_POST != 0 {
                    [0.0, 1.0]
                } else {
                    seen(&node, [right, left], |v| self.point(mesh, v))
                };
                let ends = part.map(|t| between(right, left, t));
                let nearest = node.length + distance(root, closest_on(ends, root));
                if nearest <= limit {
                    scratch.push(nearest, self.nodes.len() as u32);
                    self.nodes.push(node);
                }
            }
            let Some(Reverse((_, i))) = scratch.queue.pop() else { return };
            scratch.work.pops += 1;
            let node = self.nodes[i as usize];
            if self.is_outdone(scratch, &node) {
                continue;
            }
            scratch.work.expansions += 1;
            for v in mesh.corners(FaceId::new(node.face)) {
                if let Some(length) = self.length_to(mesh, &node, mesh.point(v)) {
                    see(v.number(), length);
                }
            }
            self.expand(mesh, scratch, i, &node);
        }
    }

    /// The length of the shortest way to the goal, which lies in the face behind the door, through the cone; `None`
    /// if another cone has a shorter one.
    fn length_to(&self, mesh: &NavMesh, node: &Node, goal: Point) -> Option<f64> {
        let root = self.point(mesh, node.root);
        if node.flags & AT_POST == 0 {
            let before = self.point(mesh, node.before);
            let turn = |vertex: u32, bent: u32| match node.flags & bent {
                0 => orientation(root, self.point(mesh, vertex), goal),
                _ => orientation(before, root, goal),
            };
            let round = |vertex: u32, ends: u32| {
                let post = self.point(mesh, vertex);
                (node.flags & ends != 0).then(|| node.length + distance(root, post) + distance(post, goal))
            };
            if turn(node.left, BENT_LEFT) == Ordering::Greater {
                return round(node.left, ENDS_LEFT);
            }
            if turn(node.right, BENT_RIGHT) == Ordering::Less {
                return round(node.right, ENDS_RIGHT);
            }
        }
        Some(node.length + distance(root, goal))
    }
}

/// The face from which the cone enters its own.
fn face_before(mesh: &NavMesh, node: &Node) -> u32 {
    let twin = mesh.half_edges[node.side as usize].twin();
    let entry = mesh.range(FaceId::new(node.face)).find(|&s| mesh.half_edges[s] == twin);
    entry.map_or(node.face, |s| mesh.sides[s].across & ID)
}

/// The posts of the door of a node, the right one first.
fn posts(mesh: &NavMesh, node: &Node) -> [Point; 2] {
    let right = mesh.sides[node.side as usize].origin & ID;
    let range = mesh.range(FaceId::new(node.face));
    // In the face behind, the side before that of the right post is the door, and starts at the left post.
    let at = mesh.sides[range.clone()].iter().position(|side| side.origin & ID == right).unwrap_or(0);
    let left = mesh.sides[range.start + if at == 0 { range.len() - 1 } else { at - 1 }].origin & ID;
    [right, left].map(|v| mesh.points[v as usize])
}

/// Which fractions of the door, from right to left, the cone sees.
fn seen(node: &Node, [right, left]: [Point; 2], point: impl Fn(u32) -> Point) -> [f64; 2] {
    let fraction = |vertex: u32, bent: u32| {
        let root = point(node.root);
        let [p, q] = if node.flags & bent != 0 { [point(node.before), root] } else { [root, point(vertex)] };
        let height = |r: Point| robust::orient2d(coord(p), coord(q), coord(r));
        let (a, b) = (height(right), height(left));
        a / (a - b)
    };
    let low = if node.flags & ENDS_RIGHT != 0 { 0.0 } else { fraction(node.right, BENT_RIGHT) };
    let high = if node.flags & ENDS_LEFT != 0 { 1.0 } else { fraction(node.left, BENT_LEFT) };
    [low, high]
}

fn coord(p: Point) -> robust::Coord<f64> {
    robust::Coord { x: p.x, y: p.y }
}

/// The guess of the length from the root of a node to the goal.
fn guess(mesh: &NavMesh, node: &Node, point: impl Fn(u32) -> Point, goal: Point) -> f64 {
    let root = point(node.root);
    if node.flags & AT_POST != 0 {
        return distance(root, goal);
    }
    let posts = posts(mesh, node);
    estimate(root, posts, seen(node, posts, point), goal)
}

impl Planner {
    /// The cones of the last exact search, in the order in which they came up. Their points are rounded: for figures.
    pub fn cones<'a>(&'a self, mesh: &'a NavMesh) -> impl Iterator<Item = Cone> + 'a {
        let exact = &self.exact;
        exact.nodes.iter().map(move |node| {
            let point = |v: u32| exact.point(mesh, v);
            let posts = posts(mesh, node);
            let part = if node.flags & AT_POST != 0 { [0.0, 1.0] } else { seen(node, posts, point) };
            let [right, left] = part.map(|t| between(posts[0], posts[1], t));
            let [from, to] = [face_before(mesh, node), node.face].map(FaceId::new);
            Cone { root: point(node.root), left, right, from, to, length: node.length }
        })
    }
}
