//! What every edge and face of the map is there for.
//!
//! ```text
//!   ═══●═══════●═══    pieces of an edge of the first map      An edge that is neither a piece of the first map nor
//!      │      ╱        the side of an obstacle                 on the side of an obstacle is a cut: it is there to
//!      │ ┄┄┄┄╱         a cut                                   keep faces convex, and for nothing else.
//! ```
//!
//! What is split hands its reasons on to both parts. So two edges in a row have equal reasons just if the vertex
//! between them is in the middle of one line, as it was given; where rounding has bent the line, too.
//!
//! Each obstacle knows its edges and faces, and every change is written down until the edit is kept: so an edit costs
//! what it touches, however many obstacles there are.

use crate::ids::{EdgeId, Element, FaceId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::{Change, Slot};
use std::collections::{BTreeMap, BTreeSet};

/// An obstacle of a [`LiveMesh`](super::LiveMesh).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ObstacleId(pub u32);

impl std::fmt::Display for ObstacleId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "obstacle {}", self.0)
    }
}

/// One side of an obstacle, from 0.
pub(super) type SideOf = (ObstacleId, usize);

/// The elements of the map before the first obstacle. None of them ever goes: edges lend their ids to a piece.
#[derive(Clone, Debug, PartialEq)]
struct First {
    vertices: usize,
    edges: usize,
    faces: usize,
    /// Numbers below these that were free.
    free: BTreeSet<Element>,
}

/// An obstacle and what it closes.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Obstacle {
    /// Its corners as they were given; the two ends of a wall.
    pub(super) corners: Vec<Point>,
    edges: BTreeSet<EdgeId>,
    faces: BTreeSet<FaceId>,
}

/// What an entry was before it was changed.
#[derive(Clone, Debug, PartialEq)]
enum Before {
    Piece(EdgeId, Option<EdgeId>),
    Borders(EdgeId, BTreeSet<SideOf>),
    Covers(FaceId, BTreeSet<ObstacleId>),
}

/// Who closes what, and what was there before.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Book {
    first: First,
    /// The first edge of which an edge is a piece, if it is not that edge itself.
    pieces: BTreeMap<EdgeId, EdgeId>,
    /// The sides of obstacles that run along an edge.
    borders: BTreeMap<EdgeId, BTreeSet<SideOf>>,
    /// The obstacles that cover a face.
    covers: BTreeMap<FaceId, BTreeSet<ObstacleId>>,
    obstacles: BTreeMap<ObstacleId, Obstacle>,
    next: u32,
    /// What the edit under way has changed, the last change last.
    before: Vec<Before>,
}

impl Book {
    /// For a map without obstacles. O(n).
    pub(super) fn new(map: &Subdivision) -> Self {
        let [vertices, edges, faces] = [map.vertex_bound(), map.edge_bound(), map.face_bound()];
        let free_vertices = (0..vertices as u32).map(VertexId::new).filter(|&v| !map.has_vertex(v)).map(Element::from);
        let free_edges = (0..edges as u32).map(EdgeId::new).filter(|&e| !map.has_edge(e)).map(Element::from);
        let free_faces = (0..faces as u32).map(FaceId::new).filter(|&f| !map.has_face(f)).map(Element::from);
        let free = free_vertices.chain(free_edges).chain(free_faces).collect();
        Self {
            first: First { vertices, edges, faces, free },
            pieces: BTreeMap::new(),
            borders: BTreeMap::new(),
            covers: BTreeMap::new(),
            obstacles: BTreeMap::new(),
            next: 0,
            before: Vec::new(),
        }
    }

    /// Whether the element was there before the first obstacle.
    pub(super) fn is_first(&self, element: impl Into<Element>) -> bool {
        let element = element.into();
        let known = match element {
            Element::Vertex(v) => v.index() < self.first.vertices,
            Element::HalfEdge(h) => h.edge().index() < self.first.edges,
            Element::Edge(e) => e.index() < self.first.edges,
            Element::Face(f) => f.index() < self.first.faces,
        };
        known && !self.first.free.contains(&element)
    }

    /// Enters an obstacle under a new number.
    pub(super) fn add(&mut self, corners: &[Point]) -> ObstacleId {
        let obstacle = ObstacleId(self.next);
        self.next += 1;
        self.put_corners(obstacle, corners);
        obstacle
    }

    /// Enters an obstacle under its number, or gives it other corners.
    pub(super) fn put_corners(&mut self, obstacle: ObstacleId, corners: &[Point]) {
        self.obstacles.entry(obstacle).or_default().corners = corners.to_vec();
    }

    /// Takes out the entry of an obstacle that closes nothing.
    pub(super) fn forget(&mut self, obstacle: ObstacleId) {
        self.obstacles.remove(&obstacle);
    }

    /// The obstacles in the map.
    pub(super) fn obstacles(&self) -> impl Iterator<Item = ObstacleId> + '_ {
        self.obstacles.keys().copied()
    }

    pub(super) fn obstacle(&self, obstacle: ObstacleId) -> Option<&Obstacle> {
        self.obstacles.get(&obstacle)
    }

    /// Whether nobody may cross the edge.
    pub(super) fn is_border(&self, e: EdgeId) -> bool {
        self.borders.contains_key(&e)
    }

    /// Whether nobody may enter the face.
    pub(super) fn is_covered(&self, f: FaceId) -> bool {
        self.covers.contains_key(&f)
    }

    /// Whether the edge is there for convex faces only.
    pub(super) fn is_cut(&self, e: EdgeId) -> bool {
        self.piece_of(e).is_none() && !self.is_border(e)
    }

    /// Whether two edges are parts of the same lines.
    pub(super) fn is_one_line(&self, a: EdgeId, b: EdgeId) -> bool {
        self.piece_of(a) == self.piece_of(b) && self.borders.get(&a) == self.borders.get(&b)
    }

    fn piece_of(&self, e: EdgeId) -> Option<EdgeId> {
        if self.is_first(e) { Some(e) } else { self.pieces.get(&e).copied() }
    }

    pub(super) fn put_border(&mut self, e: EdgeId, side: SideOf) {
        let mut owners = self.borders.get(&e).cloned().unwrap_or_default();
        owners.insert(side);
        self.set_borders(e, owners);
    }

    pub(super) fn cover(&mut self, f: FaceId, obstacle: ObstacleId) {
        let mut owners = self.covers.get(&f).cloned().unwrap_or_default();
        owners.insert(obstacle);
        self.set_covers(f, owners);
    }

    /// The edges along the sides of an obstacle.
    pub(super) fn border_of(&self, obstacle: ObstacleId) -> Vec<EdgeId> {
        self.obstacles.get(&obstacle).map_or_else(Vec::new, |o| o.edges.iter().copied().collect())
    }

    /// Opens what an obstacle closes; returns these edges and faces.
    pub(super) fn strike(&mut self, obstacle: ObstacleId) -> (Vec<EdgeId>, Vec<FaceId>) {
        let edges = self.border_of(obstacle);
        let faces: Vec<FaceId> =
            self.obstacles.get(&obstacle).map_or_else(Vec::new, |o| o.faces.iter().copied().collect());
        for &e in &edges {
            let mut owners = self.borders.get(&e).cloned().unwrap_or_default();
            owners.retain(|&(owner, _)| owner != obstacle);
            self.set_borders(e, owners);
        }
        for &f in &faces {
            let mut owners = self.covers.get(&f).cloned().unwrap_or_default();
            owners.remove(&obstacle);
            self.set_covers(f, owners);
        }
        (edges, faces)
    }

    /// What was split hands its reasons on to both parts; what went needs none.
    pub(super) fn follow(&mut self, changes: &[Change]) {
        let mut new_edge = None;
        for change in changes {
            match *change {
                Change::Added { element, .. } => {
                    new_edge = if let Element::Edge(e) = element { Some(e) } else { None };
                }
                Change::Write { slot: Slot::Origin(_), old: None, .. } => {}
                // The twin of the half-edge that is split starts at the new vertex from now on.
                Change::Write { slot: Slot::Origin(h), old: Some(_), new: Some(_) } => {
                    let Some(e) = new_edge.take() else { continue };
                    if let Some(owners) = self.borders.get(&h.edge()).cloned() {
                        self.set_borders(e, owners);
                    }
                    if let Some(first) = self.piece_of(h.edge()) {
                        self.set_piece(e, Some(first));
                    }
                }
                Change::Write { slot: Slot::Face(_), old: Some(Element::Face(old)), new: Some(Element::Face(new)) } => {
                    if let Some(owners) = self.covers.get(&old).cloned() {
                        self.set_covers(new, owners);
                    }
                }
                Change::Removed { element: Element::Edge(e) } => {
                    new_edge = None;
                    self.set_borders(e, BTreeSet::new());
                    self.set_piece(e, None);
                }
                Change::Removed { element: Element::Face(f) } => self.set_covers(f, BTreeSet::new()),
                // A split writes nothing but origins between its new edge and the twin's.
                _ => new_edge = None,
            }
        }
    }

    /// From here on changes can be taken back.
    pub(super) fn begin(&mut self) {
        self.before.clear();
    }

    /// Takes back what was changed since [`begin`](Self::begin); obstacles that came or went are none of it.
    pub(super) fn roll_back(&mut self) {
        while let Some(before) = self.before.pop() {
            match before {
                Before::Piece(e, first) => self.set_piece(e, first),
                Before::Borders(e, owners) => self.set_borders(e, owners),
                Before::Covers(f, owners) => self.set_covers(f, owners),
            }
            self.before.pop();
        }
    }

    fn set_piece(&mut self, e: EdgeId, first: Option<EdgeId>) {
        let before = match first {
            Some(first) => self.pieces.insert(e, first),
            None => self.pieces.remove(&e),
        };
        self.before.push(Before::Piece(e, before));
    }

    fn set_borders(&mut self, e: EdgeId, owners: BTreeSet<SideOf>) {
        let before = self.borders.remove(&e).unwrap_or_default();
        for (obstacle, _) in &before {
            self.obstacles.entry(*obstacle).or_default().edges.remove(&e);
        }
        for (obstacle, _) in &owners {
            self.obstacles.entry(*obstacle).or_default().edges.insert(e);
        }
        if !owners.is_empty() {
            self.borders.insert(e, owners);
        }
        self.before.push(Before::Borders(e, before));
    }

    fn set_covers(&mut self, f: FaceId, owners: BTreeSet<ObstacleId>) {
        let before = self.covers.remove(&f).unwrap_or_default();
        for obstacle in &before {
            self.obstacles.entry(*obstacle).or_default().faces.remove(&f);
        }
        for obstacle in &owners {
            self.obstacles.entry(*obstacle).or_default().faces.insert(f);
        }
        if !owners.is_empty() {
            self.covers.insert(f, owners);
        }
        self.before.push(Before::Covers(f, before));
    }
}
