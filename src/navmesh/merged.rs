//! Larger faces for the exact search.
//!
//! ```text
//!   ●───────●───────●          ●───────●───────●       A door is taken away if both its ends stay corners of at most
//!   │ ╲     │     ╱ │          │               │       half a turn: then the two faces are a convex one. The longest
//!   │   ╲   │   ╱   │   ──>    │               │       doors go first. A cone crosses fewer faces, and sees the same.
//!   ●─────●─┴─●─────●          ●─────●   ●─────●
//!         │   │                      │   │
//! ```
//!
//! Every door that goes joins two different faces, and no vertex disappears. So the faces within a merged one hang
//! together like a tree, and its doors that went are chords: whoever goes straight from one of its sides to another
//! crosses those on the one path between them in the tree, and no others. That is how a way through merged faces
//! becomes one through the faces of the mesh: by looking at doors, without any computing.
//!
//! A dead end is merged with dead ends only, so that what need not be entered stays apart.
//!
//! Source: Hertel and Mehlhorn, *Fast triangulation of simple polygons*, 1983, for taking doors away.

use super::curve::Curve;
use super::mesh::{CLOSED, DEAD_END, ID, NONE, SideRecord, turns_left_or_runs_straight};
use super::rooms::{Corner, Rooms};
use super::{NavMesh, Place};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;
use std::ops::Range;

/// The merged faces of a mesh, as the exact search takes them. One is named by the index of its first side.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    /// In the order of a curve that fills the plane, so that what is near is near in memory.
    sides: Vec<WideSide>,
    /// For each of these sides which one of the mesh it is.
    originals: Vec<u32>,
    /// For each face of the mesh the merged one that has it; [`NONE`] for those nobody may enter.
    wholes: Vec<u32>,
    /// For each face of the mesh the next one on the path to a certain face of the same merged one, its root;
    /// [`NONE`] for roots.
    ups: Vec<u32>,
}

/// A side in 32 bytes: what there is to know about a room lies in one piece, and the next one is one step away.
#[derive(Clone, Copy, PartialEq, Debug)]
struct WideSide {
    /// Where it starts.
    at: Point,
    /// The vertex it starts from, with its marks.
    origin: u32,
    /// The same side of the merged face behind it, with the marks of an `across`.
    twin: u32,
    /// The sides of its own face.
    start: u32,
    end: u32,
}

impl WideSide {
    #[inline]
    fn range(&self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// The merged faces and the points of the mesh, to search through. A door is the side of the face behind it.
pub(super) struct MergedRooms<'a> {
    sides: &'a [WideSide],
    points: &'a [Point],
}

impl Rooms for MergedRooms<'_> {
    #[inline]
    fn corner(&self, s: usize) -> Corner {
        let WideSide { at, origin, twin, .. } = self.sides[s];
        Corner { at, vertex: origin, marks: twin }
    }

    #[inline]
    fn place(&self, s: usize) -> Point {
        self.sides[s].at
    }

    #[inline]
    fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    #[inline]
    fn door(&self, s: usize) -> u32 {
        self.sides[s].twin & ID
    }

    #[inline]
    fn side(&self, door: u32) -> usize {
        (self.sides[door as usize].twin & ID) as usize
    }

    #[inline]
    fn behind(&self, door: u32) -> u32 {
        self.sides[door as usize].start
    }

    #[inline]
    fn enter(&self, door: u32) -> (Range<usize>, usize) {
        let range = self.sides[door as usize].range();
        let first = self.next(&range, door as usize);
        (range, first)
    }

    #[inline]
    fn range(&self, room: u32) -> Range<usize> {
        self.sides[room as usize].range()
    }
}

/// A convex face that was put together.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MergedFace {
    /// Its corners, counter-clockwise; some may lie in the middle of a straight side.
    pub corners: Vec<VertexId>,
    /// The faces of the mesh that it was put together from, in the order of their numbers.
    pub faces: Vec<FaceId>,
}

impl NavMesh {
    /// Puts faces together to larger convex ones, for [`Rung::Exact`](super::Rung::Exact) and for
    /// [`distance_field`](super::Planner::distance_field): both then find the same with less than half of the work.
    /// Returns how many merged faces there are. Routes speak of the faces of the mesh as before, and all else is as
    /// it was.
    ///
    /// Worth it from a handful of queries on. The merged faces are given up when a face is blocked or freed, or a
    /// wall or an obstacle comes or goes; call this again when things have come to rest.
    ///
    /// Cost: O(n log n); about 75 bytes a triangle.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, Rung};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// // Eight triangles round a square gap: four trapezoids.
    /// let points = [(0., 0.), (3., 0.), (3., 3.), (0., 3.), (1., 1.), (2., 1.), (2., 2.), (1., 2.)].map(Point::from);
    /// let sides = [0, 1, 2, 3].map(|i| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]);
    /// let triangles = sides.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).concat();
    /// let mut mesh = NavMesh::new(&Subdivision::from_triangles(points.to_vec(), &triangles)?)?;
    /// assert_eq!((mesh.face_count(), mesh.merge_faces()), (8, 4));
    /// let route = Planner::new().route_between(&mesh, Rung::Exact, (1.2, 0.5).into(), (2.5, 1.8).into())?;
    /// assert_eq!(route.points[1], Point::new(2.0, 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn merge_faces(&mut self) -> usize {
        let merged = Merged::new(self);
        let count = merged.faces().count();
        self.merged = Some(merged);
        count
    }

    /// The merged faces; none if [`merge_faces`](Self::merge_faces) was not called, or something has changed since.
    /// O(n).
    #[must_use]
    pub fn merged_faces(&self) -> Vec<MergedFace> {
        let Some(merged) = &self.merged else { return Vec::new() };
        let mut members: Vec<Vec<FaceId>> = vec![Vec::new(); merged.sides.len()];
        for (f, &whole) in (0..).zip(&merged.wholes).filter(|&(_, &whole)| whole != NONE) {
            members[whole as usize].push(FaceId::new(f));
        }
        let corner = |side: &WideSide| VertexId::new(side.origin & ID);
        let face = |range: Range<usize>| {
            let faces = std::mem::take(&mut members[range.start]);
            MergedFace { corners: merged.sides[range].iter().map(corner).collect(), faces }
        };
        merged.faces().map(face).collect()
    }
}

impl Merged {
    fn new(mesh: &NavMesh) -> Self {
        let mut rings = Rings::new(mesh);
        for [s, t] in rings.doors() {
            rings.open(s as usize, t as usize);
        }
        rings.collect()
    }

    /// The merged face that has the face.
    #[inline]
    pub(super) fn whole(&self, f: FaceId) -> FaceId {
        FaceId::new(self.wholes[f.index()])
    }

    /// The sides of a merged face.
    pub(super) fn range(&self, whole: FaceId) -> Range<usize> {
        self.sides[whole.index()].range()
    }

    /// To search through.
    pub(super) fn rooms<'a>(&'a self, mesh: &'a NavMesh) -> MergedRooms<'a> {
        MergedRooms { sides: &self.sides, points: &mesh.points }
    }

    /// The sides of the merged faces, one after the other.
    fn faces(&self) -> impl Iterator<Item = Range<usize>> {
        let after = |start: usize| self.sides.get(start).map(WideSide::range);
        std::iter::successors(after(0), move |range| after(range.end))
    }

    /// More than the names of all merged faces.
    pub(super) fn bound(&self) -> usize {
        self.sides.len()
    }

    /// The side of the mesh that a side of a merged face is.
    pub(super) fn original(&self, side: u32) -> u32 {
        self.originals[side as usize]
    }

    /// The posts of a side of a merged face, the right one first.
    pub(super) fn ends(&self, side: u32) -> [VertexId; 2] {
        let WideSide { start, end, .. } = self.sides[side as usize];
        let next = if side + 1 == end { start } else { side + 1 };
        [side, next].map(|s| VertexId::new(self.sides[s as usize].origin & ID))
    }

    /// The merged face behind a side of another.
    pub(super) fn beyond(&self, side: u32) -> FaceId {
        FaceId::new(self.sides[(self.sides[side as usize].twin & ID) as usize].start)
    }

    /// The face of the merged one `whole` in which one stands at the place.
    pub(super) fn face_at(&self, mesh: &NavMesh, place: &Place, whole: FaceId) -> FaceId {
        if self.whole(place.face) == whole {
            return place.face;
        }
        mesh.faces_at(place).into_iter().find(|&f| self.whole(f) == whole).unwrap_or(place.face)
    }

    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.sides) + size_of_val(&*self.originals) + size_of_val(&*self.wholes) + size_of_val(&*self.ups)
    }

    /// Makes of a row of doors of merged faces one of doors of the mesh, from a face in the first to a face in the
    /// last of them. Both rows run from the goal to the start. O(k) for each merged face of k faces on the way.
    pub(super) fn refine(&self, mesh: &NavMesh, [start, goal]: [FaceId; 2], doors: &mut Vec<(u32, u32)>) {
        let mut row = Vec::with_capacity(3 * doors.len());
        let (mut at, mut paths) = (start.number(), [Vec::new(), Vec::new()]);
        for &(_, side) in doors.iter().rev() {
            // Behind a side lies the face that its twin belongs to, and the other way round.
            let [out, back] = [side, self.sides[side as usize].twin & ID].map(|side| self.original(side));
            self.walk(mesh, at, mesh.sides[back as usize].across & ID, &mut row, &mut paths);
            row.push((mesh.sides[back as usize].across & ID, out));
            at = mesh.sides[out as usize].across & ID;
        }
        self.walk(mesh, at, goal.number(), &mut row, &mut paths);
        row.reverse();
        *doors = row;
    }

    /// The doors from one face to another of the same merged face: up its tree to where the paths of both to the root
    /// meet, and down again.
    fn walk(&self, mesh: &NavMesh, from: u32, to: u32, row: &mut Vec<(u32, u32)>, paths: &mut [Vec<u32>; 2]) {
        if from == to {
            return;
        }
        let up = |&f: &u32| Some(self.ups[f as usize]).filter(|&up| up != NONE);
        for (path, f) in paths.iter_mut().zip([from, to]) {
            path.clear();
            path.extend(std::iter::successors(Some(f), up));
        }
        let [up, down] = paths;
        let common = up.iter().rev().zip(down.iter().rev()).take_while(|(f, g)| f == g).count();
        debug_assert_ne!(common, 0, "{from} and {to} are in different merged faces");
        let [up, down] = [up, down].map(|path| &path[..=path.len() - common]);
        row.extend(up.windows(2).map(|pair| mesh.door_to(pair[0], pair[1])));
        row.extend(down.windows(2).rev().map(|pair| mesh.door_to(pair[1], pair[0])));
    }
}

/// The rings of sides round the faces, while they are put together.
struct Rings<'a> {
    mesh: &'a NavMesh,
    /// The side after each, and the one before it, along its face; [`NONE`] if it is not there.
    next: Vec<u32>,
    prev: Vec<u32>,
    /// The face on the left of each side.
    owner: Vec<u32>,
    /// The same side of the face behind it; [`NONE`] if it is closed.
    twin: Vec<u32>,
    /// For each face one of the faces it was joined to; itself for one of each merged face.
    joined: Vec<u32>,
}

impl<'a> Rings<'a> {
    /// Those of the faces that may be entered.
    fn new(mesh: &'a NavMesh) -> Self {
        let none = vec![NONE; mesh.sides.len()];
        let joined = (0..mesh.faces.len() as u32).collect();
        let [next, prev, owner, twin] = [(); 4].map(|()| none.clone());
        let mut rings = Self { mesh, next, prev, owner, twin, joined };
        for f in mesh.faces().filter(|&f| mesh.is_walkable(f)) {
            let range = mesh.range(f);
            for s in range.clone() {
                rings.owner[s] = f.number();
                rings.link(s, if s + 1 == range.end { range.start } else { s + 1 });
            }
        }
        rings.find_twins();
        rings
    }

    fn find_twins(&mut self) {
        let bound = self.mesh.half_edges.iter().map(|h| h.index() + 1).max().unwrap_or(0);
        let mut side_of = vec![NONE; bound + 1];
        let open = |s: usize| self.owner[s] != NONE && self.mesh.sides[s].across & CLOSED == 0;
        let sides = || self.mesh.half_edges.iter().enumerate().filter(|&(s, _)| open(s));
        sides().for_each(|(s, h)| side_of[h.index()] = s as u32);
        sides().for_each(|(s, h)| self.twin[s] = side_of[h.twin().index()]);
    }

    fn link(&mut self, s: usize, next: usize) {
        self.next[s] = next as u32;
        self.prev[next] = s as u32;
    }

    /// The doors that may be taken away, each with its two sides, the longest first.
    fn doors(&self) -> Vec<[u32; 2]> {
        let mut doors: Vec<(f64, [u32; 2])> = Vec::new();
        for (s, &t) in (0..).zip(&self.twin) {
            let is_dead_end = |s: u32| self.mesh.is_peeled(self.owner[s as usize]);
            if t != NONE && s < t && is_dead_end(s) == is_dead_end(t) {
                let [a, b] = [s, t].map(|s| self.origin(s as usize));
                let [x, y] = [b.x - a.x, b.y - a.y];
                doors.push((x * x + y * y, [s, t]));
            }
        }
        doors.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        doors.into_iter().map(|(_, door)| door).collect()
    }

    /// The point at which a side starts.
    fn origin(&self, s: usize) -> Point {
        self.mesh.points[(self.mesh.sides[s].origin & ID) as usize]
    }

    /// Takes away the door with these two sides, if the faces beside it are different ones and make a convex one.
    fn open(&mut self, s: usize, t: usize) {
        let [one, other] = [s, t].map(|s| self.root(self.owner[s]));
        if one == other {
            return;
        }
        // Where each side starts, the side before it runs on to the one after its twin.
        let joints = [(s, t), (t, s)].map(|(s, twin)| [self.prev[s] as usize, s, self.next[twin] as usize]);
        let stays_convex = |&[before, at, after]: &[usize; 3]| {
            let end = self.origin(self.next[after] as usize);
            turns_left_or_runs_straight([self.origin(before), self.origin(at), end])
        };
        if joints.iter().all(stays_convex) {
            for [before, _, after] in joints {
                self.link(before, after);
            }
            for gone in [s, t] {
                (self.next[gone], self.prev[gone]) = (NONE, NONE);
            }
            self.joined[one as usize] = other;
        }
    }

    /// The face that stands for the merged face of `f`.
    fn root(&mut self, f: u32) -> u32 {
        let mut at = f;
        while self.joined[at as usize] != at {
            let up = self.joined[self.joined[at as usize] as usize];
            self.joined[at as usize] = up;
            at = up;
        }
        at
    }

    /// The trees of faces that were put together, each by the next face on the way to its root.
    fn ups(&self) -> Vec<u32> {
        let mut ups = vec![NONE; self.mesh.faces.len()];
        let is_root = |f: &u32| self.joined[*f as usize] == *f;
        let mut stack: Vec<u32> = (0..self.mesh.faces.len() as u32).filter(is_root).collect();
        while let Some(f) = stack.pop() {
            for s in self.mesh.range(FaceId::new(f)) {
                let beyond = self.mesh.sides[s].across & ID;
                let was_opened = self.next[s] == NONE && self.twin[s] != NONE;
                if was_opened && ups[f as usize] != beyond {
                    ups[beyond as usize] = f;
                    stack.push(beyond);
                }
            }
        }
        ups
    }

    /// Writes the rings down one after the other, in the order of a curve.
    fn collect(mut self) -> Merged {
        let mesh = self.mesh;
        let free = || mesh.faces().filter(|&f| mesh.is_walkable(f));
        let mut wholes = vec![NONE; mesh.faces.len()];
        let mut firsts: Vec<(u64, u32)> = Vec::new();
        let curve = Curve::over(mesh);
        for s in free().flat_map(|f| mesh.range(f)) {
            if self.next[s] == NONE {
                continue;
            }
            let root = self.root(self.owner[s]) as usize;
            if std::mem::replace(&mut wholes[root], 0) == NONE {
                firsts.push((curve.key(self.origin(s)), s as u32));
            }
        }
        firsts.sort_unstable();
        let mut originals: Vec<u32> = Vec::new();
        let mut ranges: Vec<Range<u32>> = Vec::new();
        let mut placed = vec![NONE; self.next.len()];
        for &(_, first) in &firsts {
            let start = originals.len() as u32;
            let ring = std::iter::successors(Some(first), |&s| Some(self.next[s as usize]).filter(|&s| s != first));
            originals.extend(ring);
            let range = start..originals.len() as u32;
            range.clone().for_each(|i| placed[originals[i as usize] as usize] = i);
            wholes[self.root(self.owner[first as usize]) as usize] = start;
            ranges.push(range);
        }
        for f in free() {
            wholes[f.index()] = wholes[self.root(f.number()) as usize];
        }
        originals.shrink_to_fit();
        let ups = self.ups();
        let side = |range: &Range<u32>, i: u32| {
            let s = originals[i as usize] as usize;
            let SideRecord { origin, across } = mesh.sides[s];
            let twin = if self.twin[s] == NONE { CLOSED } else { placed[self.twin[s] as usize] | across & DEAD_END };
            WideSide { at: self.origin(s), origin, twin, start: range.start, end: range.end }
        };
        let mut sides = Vec::with_capacity(originals.len());
        ranges.iter().for_each(|range| sides.extend(range.clone().map(|i| side(range, i))));
        Merged { sides, originals, wholes, ups }
    }
}
