//! The search itself: cones in the order of their guesses.

use super::super::QueryPoint;
use super::super::marks::{ID, NONE, TURN};
use super::super::merged::Merged;
use super::super::mesh::NavMesh;
use super::super::nearest::{closest_on, distance, norm};
use super::super::planner::Planner;
use super::super::rooms::Rooms;
use super::super::scratch::Scratch;
use super::cone::{Beam, Cone, ENDS, Node, START};
use super::estimate::{DOUBT, between, guess, seen};
use super::ray::difference;
use super::side::EdgeOn;
use crate::ids::FaceId;
use crate::plane::Point;
use std::cmp::Reverse;

/// More, as a share, than rounding changes the lengths of two paths that are compared.
const ROUNDED: f64 = 1e-10;

/// The shortest path to a vertex as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct KnownRoot {
    /// The query that found it.
    pub(super) query: u32,
    pub(super) length: f64,
    /// Where it bends last before.
    pub(super) from: u32,
}

/// The memory of the exact search.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Exact {
    pub(super) nodes: Vec<Node>,
    /// The cones behind the one that was looked at last.
    pub(super) found: Vec<Beam>,
    /// The bends round sides seen edge-on that are put off till all sides of the room were seen.
    pub(super) edge_on: Vec<EdgeOn>,
    /// Whether all that can be reached is searched, and not for a goal.
    pub(super) everything: bool,
    /// For each vertex what is known of it as a root.
    pub(super) roots: Vec<KnownRoot>,
    pub(super) start: Point,
    /// What the last search ran through.
    searched: Searched,
}

/// How many sides and points a mesh has, and how many sides its merged faces, if these were searched.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct Searched {
    sides: usize,
    points: usize,
    merged: Option<usize>,
}

impl Searched {
    fn of(mesh: &NavMesh, merged: Option<&Merged>) -> Self {
        let merged = merged.map(Merged::bound);
        Self { sides: mesh.sides.len(), points: mesh.points.len(), merged }
    }
}

impl Exact {
    fn begin(&mut self, mesh: &NavMesh, merged: Option<&Merged>, scratch: &Scratch, start: Point) {
        if scratch.query == 1 {
            self.roots.clear();
        }
        self.roots.resize(mesh.vertex_bound().max(self.roots.len()), KnownRoot::default());
        self.nodes.clear();
        self.start = start;
        self.everything = false;
        self.searched = Searched::of(mesh, merged);
    }

    /// Finds the portals of the shortest path, from room to room. Returns whether there is one.
    pub(in super::super) fn search(
        &mut self,
        mesh: &NavMesh,
        merged: Option<&Merged>,
        scratch: &mut Scratch,
        start: &QueryPoint,
        goal: Point,
    ) -> bool {
        self.begin(mesh, merged, scratch, start.point);
        match merged {
            Some(merged) => self.search_in(&merged.rooms(mesh), scratch, goal),
            None => self.search_in(mesh, scratch, goal),
        }
    }

    fn search_in<R: Rooms>(&mut self, rooms: &R, scratch: &mut Scratch, goal: Point) -> bool {
        let mut best = (f64::INFINITY, NONE);
        self.found.clear();
        for i in 0..scratch.starts.len() {
            self.leave(rooms, scratch, scratch.starts[i].number(), NONE);
        }
        self.enqueue(rooms, scratch, goal, best.0);
        while let Some(Reverse((key, mut i))) = scratch.queue.pop() {
            if f64::from_bits(key) >= best.0 {
                break;
            }
            scratch.work.pops += 1;
            let node = self.nodes[i as usize];
            if self.is_outdone(scratch, &node) {
                continue;
            }
            let mut beam = self.beam(rooms, node);
            if self.is_outdone_by_endpoint(rooms, scratch, &beam, || seen(&beam)) {
                continue;
            }
            // A single successor is looked at straight away.
            loop {
                scratch.work.expansions += 1;
                let room = rooms.behind(beam.node.portal);
                if scratch.goals.contains(&FaceId::new(room))
                    && let Some(length) = self.length_to(rooms, &beam, goal)
                    && length < best.0
                {
                    best = (length, i);
                }
                self.expand(rooms, scratch, i, &beam);
                let &[only] = &*self.found else {
                    self.enqueue(rooms, scratch, goal, best.0);
                    break;
                };
                if only.node.length >= best.0 || self.is_outdone_by_endpoint(rooms, scratch, &only, || seen(&only)) {
                    break;
                }
                beam = only;
                i = self.nodes.len() as u32;
                self.nodes.push(beam.node);
            }
        }
        let mut at = best.1;
        while at != NONE {
            let node = self.nodes[at as usize];
            let from = if node.parent == NONE {
                let is_first = |f: &&FaceId| rooms.range(f.number()).contains(&rooms.side(node.portal));
                scratch.starts.iter().find(is_first).map_or(NONE, |f| f.number())
            } else {
                rooms.behind(self.nodes[node.parent as usize].portal)
            };
            scratch.portals.push((from, rooms.side(node.portal) as u32));
            at = node.parent;
        }
        best.1 != NONE
    }

    /// Puts the cones that were found into the queue, but for those with too long a guess and those that hold no shortest
    /// path.
    fn enqueue<R: Rooms>(&mut self, rooms: &R, scratch: &mut Scratch, goal: Point, best: f64) {
        for beam in &self.found {
            let part = seen(beam);
            let guess = beam.node.length + guess(beam, part, goal);
            if guess < best && !self.is_outdone_by_endpoint(rooms, scratch, beam, || part) {
                scratch.push(guess, self.nodes.len() as u32);
                self.nodes.push(beam.node);
            }
        }
    }

    /// The cone of a node with its points.
    fn beam<R: Rooms>(&self, rooms: &R, node: Node) -> Beam {
        Beam::new(rooms, self.start, node, endpoints(rooms, node.portal))
    }

    /// Whether a shorter path to the root of the node has been found since.
    #[inline]
    fn is_outdone(&self, scratch: &Scratch, node: &Node) -> bool {
        if node.root == START {
            return false;
        }
        let known = &self.roots[node.root as usize];
        known.query == scratch.query && known.length < node.length
    }

    /// Looks at every cone that begins within `limit` and may hold a shortest path, without a goal, and tells `see` the
    /// shortest length to each corner in sight, again whenever it is seen.
    pub(in super::super) fn survey(
        &mut self,
        mesh: &NavMesh,
        merged: Option<&Merged>,
        scratch: &mut Scratch,
        start: &QueryPoint,
        limit: f64,
        see: impl FnMut(u32, f64),
    ) {
        self.begin(mesh, merged, scratch, start.point);
        self.everything = true;
        match merged {
            Some(merged) => self.survey_in(&merged.rooms(mesh), scratch, limit, see),
            None => self.survey_in(mesh, scratch, limit, see),
        }
    }

    fn survey_in<R: Rooms>(&mut self, rooms: &R, scratch: &mut Scratch, limit: f64, mut see: impl FnMut(u32, f64)) {
        let corner = |s: usize| rooms.corner(s).vertex & ID;
        self.found.clear();
        for i in 0..scratch.starts.len() {
            let range = self.leave(rooms, scratch, scratch.starts[i].number(), NONE);
            range.map(corner).for_each(|v| see(v, distance(self.start, rooms.point(v))));
        }
        self.enqueue_near(rooms, scratch, limit);
        while let Some(Reverse((_, i))) = scratch.queue.pop() {
            scratch.work.pops += 1;
            let node = self.nodes[i as usize];
            if self.is_outdone(scratch, &node) {
                continue;
            }
            let beam = self.beam(rooms, node);
            if self.is_outdone_by_endpoint(rooms, scratch, &beam, || seen(&beam)) {
                continue;
            }
            scratch.work.expansions += 1;
            let range = self.expand(rooms, scratch, i, &beam);
            for v in range.map(corner) {
                if let Some(length) = self.length_to(rooms, &beam, rooms.point(v)) {
                    see(v, length);
                }
            }
            self.enqueue_near(rooms, scratch, limit);
        }
    }

    /// Puts the cones that were found into the queue by how far their portals are, but for those beyond the limit and
    /// those that hold no shortest path.
    fn enqueue_near<R: Rooms>(&mut self, rooms: &R, scratch: &mut Scratch, limit: f64) {
        for beam in &self.found {
            let [right, left] = beam.endpoints;
            let part = seen(beam);
            let ends = part.map(|t| between(right, left, t));
            let nearest = beam.node.length + distance(beam.root, closest_on(ends, beam.root));
            if nearest <= limit && !self.is_outdone_by_endpoint(rooms, scratch, beam, || part) {
                scratch.push(nearest, self.nodes.len() as u32);
                self.nodes.push(beam.node);
            }
        }
    }

    /// Whether each point that the cone sees of its portal is reached by a shorter path: straight along the portal, from an
    /// endpoint to which the length of some path is known. `part` is asked for what is [`seen`] only if there is one.
    ///
    /// ```text
    ///   right endpoint v ●───a━━━p━━━━━b──────●   If v is outdone at b, the far end of what is seen, it is at each point p
    ///                         ╲  ╱            before b, for root p + p b >= root b, and v p = v b - p b. So two lengths
    ///                         root            decide for the whole part.
    /// ```
    ///
    /// Two paths that are equally long but for rounding do not outdo each other. Only endpoints that paths bend round
    /// count: at another one, a path may be known to one wedge of a double corner, and the portal be in the other. Cost:
    /// that of entering the room.
    ///
    /// Source: Xin and Wang, *Improving Chen and Han's algorithm on the discrete geodesic problem*, 2009, which filters by
    /// the three corners of a triangle.
    fn is_outdone_by_endpoint<R: Rooms>(
        &self,
        rooms: &R,
        scratch: &Scratch,
        beam: &Beam,
        part: impl FnOnce() -> [f64; 2],
    ) -> bool {
        let (range, first) = rooms.enter(beam.node.portal);
        let known = |s: usize| {
            let vertex = rooms.corner(s).vertex;
            let known = &self.roots[(vertex & ID) as usize];
            if vertex & TURN != 0 && known.query == scratch.query { known.length } else { f64::INFINITY }
        };
        let [by_right, by_left] = [known(first), known(rooms.prev(&range, first))];
        if by_right.min(by_left).is_infinite() {
            return false;
        }
        let [right, left] = beam.endpoints;
        let [low, high] = part();
        // By differences of points that were given: as exact far from the origin as near it.
        let (portal, off) = (difference(right, left), difference(beam.root, right));
        let whole = norm(portal);
        let straight = |t: f64| beam.node.length + norm([off[0] + portal[0] * t, off[1] + portal[1] * t]);
        // What rounding changes of a point on the portal is a share of all of it, however close the root.
        let off_portal = DOUBT * (portal[0].abs() + portal[1].abs());
        let is_shorter = |round: f64, straight: f64| round < straight * (1.0 - ROUNDED) - off_portal;
        is_shorter(by_right + whole * high, straight(high)) || is_shorter(by_left + whole * (1.0 - low), straight(low))
    }

    /// The length of the shortest path to the goal, which lies in the room behind the portal, through the cone; `None`
    /// if another cone has a shorter one.
    fn length_to<R: Rooms>(&self, rooms: &R, beam: &Beam, goal: Point) -> Option<f64> {
        let Beam { node, root, .. } = beam;
        if !node.is_at_endpoint() {
            let round = |end: u32| {
                let endpoint = rooms.place((end & ID) as usize);
                node.length + distance(*root, endpoint) + distance(endpoint, goal)
            };
            for (turn, end, outside) in [
                (beam.of_left(rooms, self.start, goal), node.left, 1),
                (beam.of_right(rooms, self.start, goal), node.right, -1),
            ] {
                if turn == outside {
                    return (end & ENDS != 0).then(|| round(end));
                }
            }
        }
        Some(node.length + distance(*root, goal))
    }
}

/// The endpoints of a portal, the right one first.
#[inline]
fn endpoints<R: Rooms>(rooms: &R, portal: u32) -> [Point; 2] {
    let (range, first) = rooms.enter(portal);
    [rooms.place(first), rooms.place(rooms.prev(&range, first))]
}

impl Planner {
    /// The cones of the last exact search, in the order in which they came up. Their points are rounded: for figures.
    /// None if this is plainly another mesh, or it was changed since. On merged faces the portals are theirs, told by the
    /// faces of the mesh that they lie between.
    pub fn cones(&self, mesh: &NavMesh) -> impl Iterator<Item = Cone> {
        let exact = &self.exact;
        let merged = mesh.merged.get().filter(|_| exact.searched.merged.is_some());
        let cones: Vec<Cone> = match merged {
            _ if exact.searched != Searched::of(mesh, merged) => Vec::new(),
            Some(merged) => exact.cones_of(mesh, &merged.rooms(mesh), |s| merged.original(s)),
            None => exact.cones_of(mesh, mesh, |s| s),
        };
        cones.into_iter()
    }
}

impl Exact {
    /// The cones of all nodes; `original` is the side of the mesh that a side of a room is.
    fn cones_of<R: Rooms>(&self, mesh: &NavMesh, rooms: &R, original: impl Fn(u32) -> u32) -> Vec<Cone> {
        let cone = |node: &Node| {
            let side = original(rooms.side(node.portal) as u32) as usize;
            let to = FaceId::new(mesh.sides[side].across & ID);
            let twin = mesh.half_edges[side].twin();
            let entry = mesh.range(to).find(|&s| mesh.half_edges[s] == twin)?;
            let from = FaceId::new(mesh.sides[entry].across & ID);
            let endpoints = mesh.ends(from, side).map(|v| mesh.point(v));
            let beam = Beam::new(rooms, self.start, *node, endpoints);
            let [right, left] = seen(&beam).map(|t| between(endpoints[0], endpoints[1], t));
            Some(Cone { root: beam.root, left, right, from, to, length: node.length })
        };
        self.nodes.iter().filter_map(cone).collect()
    }
}
