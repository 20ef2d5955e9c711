//! What every edge and face of the map is there for.
//!
//! ```text
//!   ═══●═══════●═══    pieces of a border of the first map     An edge that is neither a piece of a border nor on the
//!      │      ╱        the side of an obstacle                 side of an obstacle is a cut: it is there to keep faces
//!      │ ┄┄┄┄╱         a cut                                   convex, and for nothing else.
//! ```
//!
//! Edges of the first map with walkable faces of one area on both sides are cuts, too. They are in the map whole, with
//! the id they had, or not at all: one that an obstacle crosses is out until nothing is in its way any more. Its id is
//! kept for it.
//!
//! What is split hands its reasons on to both parts. So two edges in a row have equal reasons just if the vertex
//! between them is in the middle of one line, as it was given; where rounding has bent the line, too.
//!
//! Each obstacle knows its edges and faces, and every change is written down until the edit is kept: so an edit costs
//! what it touches, however many obstacles there are. Obstacles over each other are listed one by one at each edge and
//! face: where one is split, so is its list.

use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::mesh::is_floor;
use crate::plane::{Point, Subdivision};
use crate::topology::{Change, Slot};
use std::collections::{BTreeMap, BTreeSet};

/// An obstacle of a [`LiveMesh`](super::LiveMesh).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
pub struct ObstacleId(pub u32);

impl std::fmt::Display for ObstacleId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "obstacle {}", self.0)
    }
}

/// One side of an obstacle, from 0.
pub(super) type SideOf = (ObstacleId, usize);

/// The elements of the map before the first obstacle: all with numbers below these. Vertices and borders never go, and
/// borders lend their ids to a piece.
#[derive(Clone, Debug, Default, PartialEq)]
struct First {
    vertices: usize,
    edges: usize,
    faces: usize,
    /// The faces beside each edge, that of its first half first.
    beside: Vec<[FaceId; 2]>,
    /// Whether each edge was a cut.
    cuts: Vec<bool>,
    /// The area of each face; empty if there is one only.
    areas: Vec<u32>,
}

/// An obstacle and what it closes.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Obstacle {
    /// Its corners as they were given; the two ends of a wall.
    pub(super) corners: Vec<Point>,
    edges: BTreeSet<EdgeId>,
    faces: BTreeSet<FaceId>,
    /// Cuts of the first map that are out, with something of this obstacle in their way.
    blocks: BTreeSet<EdgeId>,
}

/// What an entry was before it was changed.
#[derive(Clone, Debug, PartialEq)]
enum Before {
    Piece(EdgeId, Option<EdgeId>),
    Borders(EdgeId, BTreeSet<SideOf>),
    Border(EdgeId, SideOf, bool),
    Covers(FaceId, BTreeSet<ObstacleId>),
    Cover(FaceId, ObstacleId, bool),
    Area(FaceId, Option<u32>),
}

/// What has become of a cut of the first map that was out.
pub(super) enum Return {
    /// It is in the map again.
    Done,
    /// Something of this obstacle is in its way.
    Blocked(ObstacleId),
    /// What is in its way belongs to no obstacle: a border that rounding has bent.
    Later,
}

/// Who closes what, and what was there before.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Book {
    first: First,
    /// The first edge of which an edge is a piece, if it is not that edge itself.
    pieces: BTreeMap<EdgeId, EdgeId>,
    /// The sides of obstacles that run along an edge.
    borders: BTreeMap<EdgeId, BTreeSet<SideOf>>,
    /// The obstacles that cover a face.
    covers: BTreeMap<FaceId, BTreeSet<ObstacleId>>,
    /// The areas of faces that came later.
    areas: BTreeMap<FaceId, u32>,
    /// Cuts of the first map that are out, and the ends they had.
    out: BTreeMap<EdgeId, [VertexId; 2]>,
    /// Those of them that no obstacle blocks, as far as is known.
    waiting: BTreeSet<EdgeId>,
    obstacles: BTreeMap<ObstacleId, Obstacle>,
    next: u32,
    /// What the edit under way has changed, the last change last.
    before: Vec<Before>,
}

impl Book {
    /// For a map without obstacles, with the area of each face; none if there is one only. O(n).
    pub(super) fn new(map: &Subdivision, areas: Vec<u32>) -> Self {
        let [vertices, edges, faces] = [map.vertex_bound(), map.edge_bound(), map.face_bound()];
        let beside = |e: EdgeId| match map.has_edge(e) {
            true => e.half_edges().map(|h| map.face(h)),
            false => [map.outer_face(); 2],
        };
        let beside: Vec<[FaceId; 2]> = (0..edges as u32).map(|e| beside(EdgeId::new(e))).collect();
        let area = |f: FaceId| areas.get(f.index());
        let cuts = beside.iter().map(|&[f, g]| is_floor(map, f) && is_floor(map, g) && area(f) == area(g)).collect();
        Self { first: First { vertices, edges, faces, beside, cuts, areas }, ..Self::default() }
    }

    /// Whether the element was there before the first obstacle. Ids of that time are used by nothing else.
    pub(super) fn is_first(&self, element: impl Into<Element>) -> bool {
        match element.into() {
            Element::Vertex(v) => v.index() < self.first.vertices,
            Element::HalfEdge(h) => h.edge().index() < self.first.edges,
            Element::Edge(e) => e.index() < self.first.edges,
            Element::Face(f) => f.index() < self.first.faces,
        }
    }

    /// Whether the edge is a cut of the first map: whole, or not there.
    pub(super) fn is_first_cut(&self, e: EdgeId) -> bool {
        self.first.cuts.get(e.index()) == Some(&true)
    }

    /// The face of the first map on the left of a half-edge that is one of it, or of a piece of it with its id.
    pub(super) fn first_face(&self, h: HalfEdgeId) -> Option<FaceId> {
        self.first.beside.get(h.edge().index()).map(|faces| faces[h.index() % 2])
    }

    /// The area of a face.
    pub(super) fn area(&self, f: FaceId) -> u32 {
        let first = || self.first.areas.get(f.index()).copied().unwrap_or(0);
        self.areas.get(&f).copied().unwrap_or_else(first)
    }

    /// The cuts of the first map that are out and that no obstacle blocks, as far as is known, with the ends they had.
    pub(super) fn waiting(&self) -> Vec<(EdgeId, [VertexId; 2])> {
        self.waiting.iter().filter_map(|&e| Some((e, *self.out.get(&e)?))).collect()
    }

    /// What is out since the obstacle came is blocked by it.
    pub(super) fn claim(&mut self, obstacle: ObstacleId) {
        let waiting = std::mem::take(&mut self.waiting);
        self.obstacles.entry(obstacle).or_default().blocks.extend(waiting);
    }

    /// Writes down what has become of cuts of the first map.
    pub(super) fn put_returned(&mut self, returned: Vec<(EdgeId, Return)>) {
        for (e, what) in returned {
            match what {
                Return::Done => {
                    self.out.remove(&e);
                    self.waiting.remove(&e);
                }
                Return::Blocked(obstacle) => {
                    self.waiting.remove(&e);
                    self.obstacles.entry(obstacle).or_default().blocks.insert(e);
                }
                Return::Later => {}
            }
        }
    }

    /// An obstacle that closes the edge.
    pub(super) fn owner(&self, e: EdgeId) -> Option<ObstacleId> {
        self.borders.get(&e)?.first().map(|&(obstacle, _)| obstacle)
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
        if let Some(gone) = self.obstacles.remove(&obstacle) {
            self.waiting.extend(gone.blocks);
        }
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
        match self.first.cuts.get(e.index()) {
            Some(&is_cut) => (!is_cut).then_some(e),
            None => self.pieces.get(&e).copied(),
        }
    }

    pub(super) fn put_border(&mut self, e: EdgeId, side: SideOf) {
        self.set_border(e, side, true);
    }

    pub(super) fn cover(&mut self, f: FaceId, obstacle: ObstacleId) {
        self.set_cover(f, obstacle, true);
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
            let all = (obstacle, 0)..=(obstacle, usize::MAX);
            let sides: Vec<SideOf> =
                self.borders.get(&e).into_iter().flat_map(|owners| owners.range(all.clone())).copied().collect();
            sides.into_iter().for_each(|side| self.set_border(e, side, false));
        }
        faces.iter().for_each(|&f| self.set_cover(f, obstacle, false));
        (edges, faces)
    }

    /// What was split hands its reasons on to both parts; what went needs none.
    pub(super) fn follow(&mut self, changes: &[Change]) {
        let mut new_edge = None;
        let mut ends = [None; 2];
        for change in changes {
            match *change {
                Change::Added { element, .. } => new_edge = EdgeId::from_element(element),
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
                Change::Write { slot: Slot::Origin(h), old: Some(Element::Vertex(v)), new: None } => {
                    new_edge = None;
                    ends[h.index() % 2] = Some(v);
                }
                Change::Write { slot: Slot::Face(_), old: Some(Element::Face(old)), new: Some(Element::Face(new)) } => {
                    if let Some(owners) = self.covers.get(&old).cloned() {
                        self.set_covers(new, owners);
                    }
                    if !self.first.areas.is_empty() && !self.is_first(new) {
                        self.set_area(new, Some(self.area(old)));
                    }
                }
                Change::Removed { element: Element::Edge(e) } => {
                    new_edge = None;
                    if self.is_first_cut(e)
                        && let [Some(from), Some(to)] = std::mem::take(&mut ends)
                    {
                        self.out.insert(e, [from, to]);
                        self.waiting.insert(e);
                    }
                    self.set_borders(e, BTreeSet::new());
                    self.set_piece(e, None);
                }
                Change::Removed { element: Element::Face(f) } => {
                    self.set_covers(f, BTreeSet::new());
                    self.set_area(f, None);
                }
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
                Before::Border(e, side, there) => self.set_border(e, side, there),
                Before::Covers(f, owners) => self.set_covers(f, owners),
                Before::Cover(f, obstacle, there) => self.set_cover(f, obstacle, there),
                Before::Area(f, area) => self.set_area(f, area),
            }
            self.before.pop();
        }
    }

    fn set_piece(&mut self, e: EdgeId, first: Option<EdgeId>) {
        let before = put(&mut self.pieces, e, first);
        self.before.push(Before::Piece(e, before));
    }

    fn set_area(&mut self, f: FaceId, area: Option<u32>) {
        let before = put(&mut self.areas, f, area);
        self.before.push(Before::Area(f, before));
    }

    /// Whether a side of an obstacle runs along an edge. O(log n), however many others do.
    fn set_border(&mut self, e: EdgeId, side: SideOf, there: bool) {
        let owners = self.borders.entry(e).or_default();
        let was_there = keep(owners, side, there);
        // Another side of the obstacle may run along it, too.
        let runs_along = owners.range((side.0, 0)..=(side.0, usize::MAX)).next().is_some();
        if owners.is_empty() {
            self.borders.remove(&e);
        }
        keep(&mut self.obstacles.entry(side.0).or_default().edges, e, runs_along);
        self.before.push(Before::Border(e, side, was_there));
    }

    fn set_borders(&mut self, e: EdgeId, owners: BTreeSet<SideOf>) {
        let before = self.borders.remove(&e).unwrap_or_default();
        for (owners, there) in [(&before, false), (&owners, true)] {
            for (obstacle, _) in owners {
                keep(&mut self.obstacles.entry(*obstacle).or_default().edges, e, there);
            }
        }
        put(&mut self.borders, e, (!owners.is_empty()).then_some(owners));
        self.before.push(Before::Borders(e, before));
    }

    /// Whether an obstacle covers a face. O(log n), however many others do.
    fn set_cover(&mut self, f: FaceId, obstacle: ObstacleId, there: bool) {
        let owners = self.covers.entry(f).or_default();
        let was_there = keep(owners, obstacle, there);
        if owners.is_empty() {
            self.covers.remove(&f);
        }
        keep(&mut self.obstacles.entry(obstacle).or_default().faces, f, there);
        self.before.push(Before::Cover(f, obstacle, was_there));
    }

    fn set_covers(&mut self, f: FaceId, owners: BTreeSet<ObstacleId>) {
        let before = self.covers.remove(&f).unwrap_or_default();
        for (owners, there) in [(&before, false), (&owners, true)] {
            for obstacle in owners {
                keep(&mut self.obstacles.entry(*obstacle).or_default().faces, f, there);
            }
        }
        put(&mut self.covers, f, (!owners.is_empty()).then_some(owners));
        self.before.push(Before::Covers(f, before));
    }
}

/// Puts an item into a set or takes it out. Returns whether it was there.
fn keep<T: Ord>(set: &mut BTreeSet<T>, item: T, there: bool) -> bool {
    if there { !set.insert(item) } else { set.remove(&item) }
}

/// Sets or takes out a value. Returns the one before.
fn put<K: Ord, V>(map: &mut BTreeMap<K, V>, key: K, value: Option<V>) -> Option<V> {
    match value {
        Some(value) => map.insert(key, value),
        None => map.remove(&key),
    }
}
