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

use crate::ids::{EdgeId, Element, FaceId, VertexId};
use crate::plane::Subdivision;
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
    next: u32,
}

impl Book {
    /// For a map without obstacles. O(n).
    pub(super) fn new(map: &Subdivision) -> Self {
        let [vertices, edges, faces] = [map.vertex_bound(), map.edge_bound(), map.face_bound()];
        let free_vertices = (0..vertices as u32).map(VertexId::new).filter(|&v| !map.has_vertex(v)).map(Element::from);
        let free_edges = (0..edges as u32).map(EdgeId::new).filter(|&e| !map.has_edge(e)).map(Element::from);
        let free_faces = (0..faces as u32).map(FaceId::new).filter(|&f| !map.has_face(f)).map(Element::from);
        let free = free_vertices.chain(free_edges).chain(free_faces).collect();
        let first = First { vertices, edges, faces, free };
        Self { first, pieces: BTreeMap::new(), borders: BTreeMap::new(), covers: BTreeMap::new(), next: 0 }
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

    /// A number for a new obstacle.
    pub(super) fn number(&mut self) -> ObstacleId {
        self.next += 1;
        ObstacleId(self.next - 1)
    }

    /// The obstacles in the map.
    pub(super) fn obstacles(&self) -> BTreeSet<ObstacleId> {
        self.borders.values().flatten().map(|&(obstacle, _)| obstacle).collect()
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
        self.borders.entry(e).or_default().insert(side);
    }

    pub(super) fn cover(&mut self, f: FaceId, obstacle: ObstacleId) {
        self.covers.entry(f).or_default().insert(obstacle);
    }

    /// The edges along the sides of an obstacle. O(number of all borders).
    pub(super) fn border_of(&self, obstacle: ObstacleId) -> Vec<EdgeId> {
        let has = |owners: &BTreeSet<SideOf>| owners.iter().any(|&(owner, _)| owner == obstacle);
        self.borders.iter().filter(|(_, owners)| has(owners)).map(|(&e, _)| e).collect()
    }

    /// Strikes an obstacle out; returns the edges and faces it closed. O(number of all borders).
    pub(super) fn strike(&mut self, obstacle: ObstacleId) -> (Vec<EdgeId>, Vec<FaceId>) {
        let edges = self.border_of(obstacle);
        let faces: Vec<FaceId> =
            self.covers.iter().filter(|(_, owners)| owners.contains(&obstacle)).map(|(&f, _)| f).collect();
        for &e in &edges {
            drop_owners(&mut self.borders, e, |&(owner, _)| owner == obstacle);
        }
        for &f in &faces {
            drop_owners(&mut self.covers, f, |&owner| owner == obstacle);
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
                        self.borders.insert(e, owners);
                    }
                    if let Some(first) = self.piece_of(h.edge()) {
                        self.pieces.insert(e, first);
                    }
                }
                Change::Write { slot: Slot::Face(_), old: Some(Element::Face(old)), new: Some(Element::Face(new)) } => {
                    if let Some(owners) = self.covers.get(&old).cloned() {
                        self.covers.insert(new, owners);
                    }
                }
                Change::Removed { element: Element::Edge(e) } => {
                    new_edge = None;
                    self.borders.remove(&e);
                    self.pieces.remove(&e);
                }
                Change::Removed { element: Element::Face(f) } => {
                    self.covers.remove(&f);
                }
                // A split writes nothing but origins between its new edge and the twin's.
                _ => new_edge = None,
            }
        }
    }
}

fn drop_owners<K: Ord + Copy, T: Ord>(owners: &mut BTreeMap<K, BTreeSet<T>>, key: K, goes: impl Fn(&T) -> bool) {
    if let Some(set) = owners.get_mut(&key) {
        set.retain(|owner| !goes(owner));
        if set.is_empty() {
            owners.remove(&key);
        }
    }
}
