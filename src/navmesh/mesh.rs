//! The flat view: corners and neighbours of a face side by side in memory.
//!
//! ```text
//!        v7                   sides of f3:   origin   across            half-edge
//!       ╱  ╲                  k = 0          v5       f9                h22
//!  f4  ╱ f3 ╲  f9             k = 1          v7       f4, a dead end    h40
//!     ╱      ╲                k = 2          v2       f0, closed        h17
//!   v2 ────── v5
//!        f0                   side k runs from corner k to corner k + 1, counter-clockwise, f3 on its left
//! ```
//!
//! A side is *open* if one may cross it, else *closed*: a hole, a wall or a blocked face lies behind it. An open side
//! into a face that leads nowhere else is marked as a *dead end* (see `dead_ends.rs`). A corner is marked as a
//! *turn* if a shortest path may bend there: what is free round the vertex, in one piece, is more than half a turn.
//!
//! Memory: 48 bytes a triangle and 20 a vertex (`marks.rs`); holes take a few bits each (`records.rs`, `holes.rs`).

use super::error::NavMeshError;
use super::grid::Grid;
use super::hole_edges::HoleEdge;
use super::holes::Holes;
use super::junctions::Junctions;
use super::many_corners::{FEW, ManyCorners};
use super::marks::{BLOCKED, CLOSED, FaceRecord, ID, MOST, NONE, PEELED, SideRecord};
use super::merged::Merged;
use super::records::FaceTable;
use super::slivers::Slivers;
use crate::geometry::expansion::Expansion;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId, must_be_below};
use crate::plane::cycle::turns_left_or_runs_straight;
use crate::plane::{Point, Subdivision};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// A part of the mesh in which every face can be reached from every other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
pub struct ComponentId(pub u32);

impl std::fmt::Display for ComponentId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "component {}", self.0)
    }
}

/// One side of a face of the mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Side {
    /// The half-edge of the subdivision; the face is on its left.
    pub half_edge: HalfEdgeId,
    /// Where it starts.
    pub from: VertexId,
    /// Where it ends.
    pub to: VertexId,
    /// The face behind it: of the mesh, or a hole.
    pub across: FaceId,
    /// Whether one may cross it.
    pub open: bool,
}

/// A flat view of a subdivision for finding paths. It does not hold the subdivision; its ids are the same.
#[derive(Clone, Debug)]
pub struct NavMesh {
    pub(super) points: Vec<Point>,
    pub(super) faces: FaceTable,
    pub(super) sides: Vec<SideRecord>,
    pub(super) half_edges: Vec<HalfEdgeId>,
    /// Where the corners of large faces are.
    many_corners: ManyCorners,
    /// How many sides no face has any more.
    pub(super) spent_sides: usize,
    /// Where these are, by how many lie side by side.
    pub(super) free_sides: BTreeMap<usize, Vec<u32>>,
    /// For each vertex a face from which its first fan can be walked counter-clockwise to the end.
    pub(super) fans: Vec<u32>,
    /// Further fans of vertices where holes touch.
    pub(super) more_fans: BTreeMap<u32, Vec<u32>>,
    /// Edges between two faces that must not be crossed.
    pub(super) walls: BTreeSet<EdgeId>,
    /// How many faces have each component number; 0 for numbers that are free.
    pub(super) component_sizes: Vec<u32>,
    /// The numbers that are free.
    pub(super) free_components: BTreeSet<u32>,
    pub(super) holes: Holes,
    pub(super) grid: Grid,
    /// Larger faces for the exact search, made when they are first needed.
    pub(super) merged: OnceLock<Merged>,
    /// Junctions and corridors between them, made when they are first needed.
    pub(super) junctions: OnceLock<Junctions>,
    /// While a change runs: faces whose marks about dead ends were written, and whether each was one before.
    pub(super) written: Option<Vec<(u32, bool)>>,
    /// Whether sides have got new numbers since the last change.
    pub(super) renumbered: bool,
    /// How many faces changes have looked at for dead ends and components.
    pub(super) visited: usize,
}

impl NavMesh {
    /// The navmesh of a map: its faces are the bounded faces that are no holes, and they must be convex. Corners in
    /// the middle of a straight side are allowed.
    ///
    /// Cost: O(n); O(n log² n) where so many faces are long and thin that they would fill the cells of the index.
    ///
    /// # Errors
    /// [`NavMeshError`] names the face that is not convex, or says that there is none.
    ///
    /// ```
    /// use dcel_kit::{FaceId, navmesh::NavMesh, plane::Subdivision};
    /// let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(dcel_kit::plane::Point::from).to_vec();
    /// let mesh = NavMesh::new(&Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?)?;
    /// assert!(mesh.neighbours(FaceId::new(1)).eq([FaceId::new(2)]));
    /// assert_eq!((mesh.face_count(), mesh.component_count()), (2, 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(map: &Subdivision) -> Result<Self, NavMeshError> {
        if map.vertex_bound() >= MOST || map.half_edge_bound() >= MOST || map.face_bound() >= MOST {
            return Err(NavMeshError::TooMany);
        }
        let mut mesh = Self {
            points: (0..map.vertex_bound() as u32).map(|v| place_of(map, VertexId::new(v))).collect(),
            faces: FaceTable::new(map.face_bound(), |f| is_floor(map, FaceId::new(f as u32))),
            sides: Vec::new(),
            half_edges: Vec::new(),
            many_corners: ManyCorners::default(),
            spent_sides: 0,
            free_sides: BTreeMap::new(),
            fans: vec![NONE; map.vertex_bound()],
            more_fans: BTreeMap::new(),
            walls: BTreeSet::new(),
            component_sizes: Vec::new(),
            free_components: BTreeSet::new(),
            holes: Holes::default(),
            grid: Grid::default(),
            merged: OnceLock::new(),
            junctions: OnceLock::new(),
            written: None,
            renumbered: false,
            visited: 0,
        };
        mesh.holes = Holes::new(map, &mesh.faces);
        for f in map.faces().filter(|&f| is_floor(map, f)) {
            mesh.read_face(map, f)?;
        }
        if mesh.sides.is_empty() {
            return Err(NavMeshError::NoFaces);
        }
        mesh.sides.shrink_to_fit();
        mesh.half_edges.shrink_to_fit();
        mesh.find_fans();
        mesh.mark_all_turns();
        mesh.label_components();
        mesh.peel_all();
        mesh.index_all(map);
        Ok(mesh)
    }

    /// Appends the sides of a face.
    pub(super) fn read_face(&mut self, map: &Subdivision, f: FaceId) -> Result<(), NavMeshError> {
        if !map.inner_components(f).is_empty() {
            return Err(NavMeshError::Rings { face: f, rings: map.inner_components(f).len() });
        }
        let start = self.sides.len();
        for h in map.incident_half_edges(f) {
            let corners = [map.origin(map.prev(h)), map.origin(h), map.destination(h)];
            if !turns_left_or_runs_straight(corners.map(|v| map.point(v))) {
                self.sides.truncate(start);
                self.half_edges.truncate(start);
                return Err(NavMeshError::Concave { face: f, corner: corners[1] });
            }
            let across = map.face(h.twin());
            let closed = across == map.outer_face() || map.is_hole(across);
            let mark = if closed { CLOSED } else { 0 };
            self.sides.push(SideRecord { origin: corners[1].number(), across: across.number() | mark });
            self.half_edges.push(h);
        }
        let count = self.sides.len() - start;
        if self.sides.len() >= MOST {
            return Err(NavMeshError::TooMany);
        }
        let start = self.put_into_free_place(start);
        self.faces[f.index()] = FaceRecord::new(start, start + count);
        let corners = self.sides[start..start + count].iter().map(|side| side.origin & ID);
        self.many_corners.insert(f.number(), corners);
        Ok(())
    }

    /// Moves the sides from `start` on, which are the last ones, to a place that others have left. Returns where they are.
    fn put_into_free_place(&mut self, start: usize) -> usize {
        let count = self.sides.len() - start;
        let Some(free) = self.free_sides.get_mut(&count).and_then(Vec::pop) else { return start };
        let free = free as usize;
        self.sides.copy_within(start.., free);
        self.half_edges.copy_within(start.., free);
        self.sides.truncate(start);
        self.half_edges.truncate(start);
        self.spent_sides -= count;
        free
    }

    /// The sides of `f` are of no use any more, and neither is its record.
    pub(super) fn drop_face(&mut self, f: FaceId) {
        let range = self.range(f);
        if !range.is_empty() {
            self.spent_sides += range.len();
            self.free_sides.entry(range.len()).or_default().push(range.start as u32);
        }
        self.many_corners.remove(f.number());
        self.faces[f.index()] = FaceRecord::ABSENT;
    }

    /// Bytes of the arrays; the index for location, and merged faces and junctions, if they have been made, among
    /// them.
    #[must_use]
    pub fn memory(&self) -> usize {
        size_of_val(&*self.points)
            + self.faces.memory()
            + self.holes.memory()
            + size_of_val(&*self.sides)
            + size_of_val(&*self.half_edges)
            + self.many_corners.memory()
            + size_of_val(&*self.fans)
            + self.grid.memory()
            + self.merged.get().map_or(0, Merged::memory)
            + self.junctions.get().map_or(0, Junctions::memory)
    }

    /// Makes the index anew. O(n); O(n log² n) where faces are long and thin.
    pub(super) fn index_all(&mut self, map: &Subdivision) {
        self.grid = Grid::new(self, HoleEdge::all(map, self), || self.slivers(map));
    }

    /// Makes the index anew after edits. O(n), as [`index_all`](Self::index_all).
    pub(super) fn index_again(&mut self, map: &Subdivision) {
        let mut grid = std::mem::take(&mut self.grid);
        self.grid = grid.anew(self, || self.slivers(map));
    }

    fn slivers(&self, map: &Subdivision) -> Slivers {
        Slivers::new(map, |f| if self.has_face(f) { f } else { FaceId::new(self.hole_name(f.number())) })
    }

    /// The name of the hole that has `hole`, which is no face of the mesh.
    pub(super) fn hole_name(&self, hole: u32) -> u32 {
        self.holes.name(&self.faces, hole)
    }

    /// Where `v` is. O(1).
    ///
    /// # Panics
    /// If there is no such vertex: `there is no v99: there are 5 vertices`.
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn point(&self, v: VertexId) -> Point {
        must_be_below(v, v.index(), self.points.len());
        self.points[v.index()]
    }

    /// One more than the greatest face number.
    #[must_use]
    pub fn face_bound(&self) -> usize {
        self.faces.len()
    }

    /// One more than the greatest vertex number.
    #[must_use]
    pub fn vertex_bound(&self) -> usize {
        self.points.len()
    }

    /// Whether `f` is a face of the mesh, blocked or not; holes are not.
    #[must_use]
    #[inline]
    pub fn has_face(&self, f: FaceId) -> bool {
        self.faces.get(f.index()).is_some_and(|face| face.len != 0)
    }

    /// The faces of the mesh in the order of their numbers.
    pub fn faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        (0..self.faces.len() as u32).map(FaceId::new).filter(|&f| self.has_face(f))
    }

    /// The number of faces of the mesh. O(number of faces).
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.faces().count()
    }

    /// Whether `f` is a face that was blocked: nobody may enter it. Its sides are closed.
    #[must_use]
    pub fn is_blocked(&self, f: FaceId) -> bool {
        self.faces.get(f.index()).is_some_and(|face| face.len & BLOCKED != 0)
    }

    /// Whether one may stand in `f`: a face of the mesh that is not blocked.
    #[must_use]
    pub fn is_walkable(&self, f: FaceId) -> bool {
        self.has_face(f) && !self.is_blocked(f)
    }

    /// The corners of `f`, counter-clockwise; none if it is no face of the mesh.
    pub fn corners(&self, f: FaceId) -> impl ExactSizeIterator<Item = VertexId> + DoubleEndedIterator + Clone + '_ {
        self.sides_of(f).iter().map(|side| VertexId::new(side.origin & ID))
    }

    /// The area of some faces together, blocked or not: exact, rounded once, however far from the origin they lie.
    /// O(corners).
    ///
    /// ```
    /// use dcel_kit::{navmesh::NavMesh, plane::Subdivision};
    /// let corners = [(1e9, 1e9), (1e9 + 1., 1e9), (1e9 + 1., 1e9 + 1.), (1e9, 1e9 + 1.)].map(Into::into);
    /// let square = Subdivision::from_graph(&corners, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let mesh = NavMesh::new(&square)?;
    /// assert_eq!(mesh.area(mesh.faces()), 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn area(&self, faces: impl IntoIterator<Item = FaceId>) -> f64 {
        let mut twice = Expansion::default();
        for f in faces {
            let corners = self.corners(f).map(|v| self.point(v));
            let next = corners.clone().cycle().skip(1);
            for (p, q) in corners.zip(next) {
                twice.add_product(p.x, q.y);
                twice.add_product(-p.y, q.x);
            }
        }
        0.5 * twice.rounded()
    }

    /// The sides of `f`, counter-clockwise; none if it is no face of the mesh.
    pub fn sides(&self, f: FaceId) -> impl ExactSizeIterator<Item = Side> + Clone + '_ {
        self.range(f).map(move |s| self.side(f, s))
    }

    /// The faces that can be entered from `f`, one for each open side. O(1) each.
    pub fn neighbours(&self, f: FaceId) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        let open = |side: &SideRecord| side.across & CLOSED == 0;
        self.sides_of(f).iter().copied().filter(open).map(|side| FaceId::new(side.across & ID))
    }

    /// The indices of the sides of `f`.
    #[inline]
    pub(super) fn range(&self, f: FaceId) -> std::ops::Range<usize> {
        self.faces.get(f.index()).map_or(0..0, FaceRecord::range)
    }

    /// The records of the sides of `f`.
    #[inline]
    pub(super) fn sides_of(&self, f: FaceId) -> &[SideRecord] {
        &self.sides[self.range(f)]
    }

    /// Side `s`, which must be one of `f`.
    pub(super) fn side(&self, f: FaceId, s: usize) -> Side {
        let [from, to] = self.ends(f, s);
        let SideRecord { across, .. } = self.sides[s];
        let across_id = FaceId::new(across & ID);
        Side { half_edge: self.half_edges[s], from, to, across: across_id, open: across & CLOSED == 0 }
    }

    /// The ends of side `s`, which must be one of `f`.
    #[inline]
    pub(super) fn ends(&self, f: FaceId, s: usize) -> [VertexId; 2] {
        let range = self.range(f);
        let next = if s + 1 == range.end { range.start } else { s + 1 };
        [s, next].map(|s| VertexId::new(self.sides[s].origin & ID))
    }

    /// A portal from a face to one beside it: the face, and its side. O(sides of the face).
    ///
    /// # Panics
    /// If there is none.
    pub(super) fn portal_to(&self, from: u32, to: u32) -> (u32, u32) {
        let is_portal = |&s: &usize| self.sides[s].across & (CLOSED | ID) == to;
        let side = self.range(FaceId::new(from)).find(is_portal);
        (from, side.expect("one may pass from the one to the other") as u32)
    }

    /// The side of `f` that starts at `v`. O(1), or O(log n) in a face of many sides.
    #[inline]
    pub(super) fn side_from(&self, f: FaceId, v: u32) -> Option<usize> {
        let range = self.range(f);
        let place = if range.len() <= FEW {
            self.sides[range.clone()].iter().position(|side| side.origin & ID == v)
        } else {
            self.many_corners.place(f.number(), v)
        };
        place.map(|k| range.start + k)
    }

    /// The side of `f` that ends at `v`. O(1), or O(log n) in a face of many sides.
    pub(super) fn side_to(&self, f: FaceId, v: u32) -> Option<usize> {
        let range = self.range(f);
        self.side_from(f, v).map(|s| if s == range.start { range.end - 1 } else { s - 1 })
    }

    pub(super) fn is_peeled(&self, f: u32) -> bool {
        self.faces.get(f as usize).is_some_and(|face| face.len & PEELED != 0)
    }

    pub(super) fn set_peeled(&mut self, f: u32, peeled: bool) {
        self.note_written(f);
        let face = &mut self.faces[f as usize];
        face.len = face.len & !PEELED | if peeled { PEELED } else { 0 };
    }

    /// Writes down that marks of `f` about dead ends are going to change.
    pub(super) fn note_written(&mut self, f: u32) {
        let was_peeled = self.is_peeled(f);
        if let Some(written) = &mut self.written {
            written.push((f, was_peeled));
        }
    }

    pub(super) fn set_blocked(&mut self, f: FaceId, blocked: bool) {
        let face = &mut self.faces[f.index()];
        face.len = face.len & !BLOCKED | if blocked { BLOCKED } else { 0 };
    }
}

/// Whether a face of the map is one of its navmesh.
pub(super) fn is_floor(map: &Subdivision, f: FaceId) -> bool {
    map.has_face(f) && f != map.outer_face() && !map.is_hole(f)
}

pub(super) fn place_of(map: &Subdivision, v: VertexId) -> Point {
    if map.has_vertex(v) { map.point(v) } else { Point::default() }
}
