//! Larger faces for the exact search.
//!
//! ```text
//!   ●───────●───────●          ●───────●───────●       A portal is taken away if both its ends stay corners of at most
//!   │ ╲     │     ╱ │          │               │       half a turn: then the two faces are a convex one. The longest
//!   │   ╲   │   ╱   │   ──>    │               │       portals go first. A cone crosses fewer faces, and sees the same.
//!   ●─────●─┴─●─────●          ●─────●   ●─────●
//!         │   │                      │   │
//! ```
//!
//! Every portal that goes joins two different faces, and no vertex disappears. So the faces within a merged one hang
//! together like a tree, and its portals that went are chords: whoever goes straight from one of its sides to another
//! crosses those on the one path between them in the tree, and no others. That is how a path through merged faces
//! becomes one through the faces of the mesh: by looking at portals, without any computing.
//!
//! A dead end is merged with dead ends only, so that what need not be entered stays apart.
//!
//! When the mesh changes, the merged faces at the change are taken apart, and their faces put together again; the new
//! ones stand behind the last. Once half of all sides are spent the whole is made anew, when it is needed next.
//!
//! Source: Hertel and Mehlhorn, *Fast triangulation of simple polygons*, 1983, for taking portals away.

use super::curve::Curve;
use super::marks::{CLOSED, DEAD_END, ID, NONE, SideRecord};
use super::rooms::{Corner, Rooms};
use super::{NavMesh, QueryPoint};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::plane::cycle::turns_left_or_runs_straight;
use std::ops::Range;

/// The merged faces of a mesh, as the exact search takes them. One is named by the index of its first side.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    curve: Curve,
    /// How many sides are of no use any more; the `origin` of these is [`NONE`].
    spent: usize,
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

/// The merged faces and the points of the mesh, to search through. A portal is the side of the face behind it.
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
    fn portal(&self, s: usize) -> u32 {
        self.sides[s].twin & ID
    }

    #[inline]
    fn side(&self, portal: u32) -> usize {
        (self.sides[portal as usize].twin & ID) as usize
    }

    #[inline]
    fn behind(&self, portal: u32) -> u32 {
        self.sides[portal as usize].start
    }

    #[inline]
    fn enter(&self, portal: u32) -> (Range<usize>, usize) {
        let range = self.sides[portal as usize].range();
        let first = self.next(&range, portal as usize);
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
    /// Puts faces together to larger convex ones now, if that has not been done. Over them
    /// [`PathAlgorithm::Exact`](super::PathAlgorithm::Exact) and [`distance_field`](super::Planner::distance_field) find the same as
    /// [face by face](super::Planner::face_by_face), with less than half of the work. Nobody has to call this: the first
    /// query that needs them does it. Returns how many merged faces there are. Routes speak of the faces of the mesh as
    /// before, and all else is as it was.
    ///
    /// When the mesh changes, the merged faces near the change are made anew.
    ///
    /// Cost: O(n log n) the first time, then O(number of merged faces); about 75 bytes a triangle.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// // Eight triangles round a square hole: four trapezoids.
    /// let points = [(0., 0.), (3., 0.), (3., 3.), (0., 3.), (1., 1.), (2., 1.), (2., 2.), (1., 2.)].map(Point::from);
    /// let sides = [0, 1, 2, 3].map(|i| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]);
    /// let triangles = sides.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).concat();
    /// let mesh = NavMesh::new(&Subdivision::from_triangles(points.to_vec(), &triangles)?)?;
    /// assert_eq!((mesh.face_count(), mesh.merge_faces()), (8, 4));
    /// let route = Planner::new().route_between(&mesh, PathAlgorithm::Exact, (1.2, 0.5).into(), (2.5, 1.8).into())?;
    /// assert_eq!(route.points[1], Point::new(2.0, 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn merge_faces(&self) -> usize {
        self.merged().faces().count()
    }

    /// The merged faces; made now if they have not been.
    pub(super) fn merged(&self) -> &Merged {
        self.merged.get_or_init(|| Merged::new(self))
    }

    /// The merged faces. O(n), and see [`merge_faces`](Self::merge_faces).
    #[must_use]
    pub fn merged_faces(&self) -> Vec<MergedFace> {
        let merged = self.merged();
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
        let bound = mesh.faces.len();
        let mut merged = Self {
            curve: Curve::over(mesh),
            spent: 0,
            sides: Vec::new(),
            originals: Vec::new(),
            wholes: vec![NONE; bound],
            ups: vec![NONE; bound],
        };
        merged.put_together(mesh, mesh.faces().map(FaceId::number).collect());
        merged.sides.shrink_to_fit();
        merged.originals.shrink_to_fit();
        merged
    }

    /// Merges those of the faces that may be entered, which are in no merged face.
    pub(super) fn put_together(&mut self, mesh: &NavMesh, mut faces: Vec<u32>) {
        self.wholes.resize(mesh.faces.len().max(self.wholes.len()), NONE);
        self.ups.resize(mesh.faces.len().max(self.ups.len()), NONE);
        faces.retain(|&f| mesh.is_walkable(FaceId::new(f)));
        let mut rings = Rings::new(mesh, faces);
        for [s, t] in rings.portals() {
            rings.open(s as usize, t as usize);
        }
        rings.add_to(self);
    }

    /// Takes apart the merged faces that have any of these faces, and appends all their faces to `loose`. The sides of
    /// the faces must still be those that were merged.
    pub(super) fn take_apart(&mut self, mesh: &NavMesh, faces: impl IntoIterator<Item = u32>, loose: &mut Vec<u32>) {
        for f in faces {
            let Some(&whole) = self.wholes.get(f as usize).filter(|&&whole| whole != NONE) else { continue };
            let range = self.sides[whole as usize].range();
            self.spent += range.len();
            self.sides[range].iter_mut().for_each(|side| side.origin = NONE);
            let mut next = loose.len();
            self.wholes[f as usize] = NONE;
            loose.push(f);
            while let Some(&f) = loose.get(next) {
                next += 1;
                self.ups[f as usize] = NONE;
                for side in mesh.sides_of(FaceId::new(f)) {
                    let beyond = side.across & ID;
                    if let Some(other) = self.wholes.get_mut(beyond as usize).filter(|other| **other == whole) {
                        *other = NONE;
                        loose.push(beyond);
                    }
                }
            }
        }
    }

    /// Writes the marks of the merged face that has `f` anew.
    pub(super) fn mark_again(&mut self, mesh: &NavMesh, f: u32) {
        let Some(&whole) = self.wholes.get(f as usize).filter(|&&whole| whole != NONE) else { return };
        for i in self.sides[whole as usize].range() {
            let SideRecord { origin, across } = mesh.sides[self.originals[i] as usize];
            let side = &mut self.sides[i];
            side.origin = origin;
            if side.twin & CLOSED == 0 {
                side.twin = side.twin & ID | across & DEAD_END;
            }
        }
    }

    /// Whether so much has been taken apart that it is better to begin anew.
    pub(super) fn is_spent(&self) -> bool {
        2 * self.spent > self.sides.len() + 64
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
        let all = std::iter::successors(after(0), move |range| after(range.end));
        all.filter(|range| self.sides[range.start].origin != NONE)
    }

    /// More than the names of all merged faces, and of those that were taken apart.
    pub(super) fn bound(&self) -> usize {
        self.sides.len()
    }

    /// The side of the mesh that a side of a merged face is.
    pub(super) fn original(&self, side: u32) -> u32 {
        self.originals[side as usize]
    }

    /// The endpoints of a side of a merged face, the right one first.
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
    pub(super) fn face_at(&self, mesh: &NavMesh, place: &QueryPoint, whole: FaceId) -> FaceId {
        if self.whole(place.face) == whole {
            return place.face;
        }
        mesh.faces_at(place).into_iter().find(|&f| self.whole(f) == whole).unwrap_or(place.face)
    }

    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.sides) + size_of_val(&*self.originals) + size_of_val(&*self.wholes) + size_of_val(&*self.ups)
    }

    /// Makes of a row of portals of merged faces one of portals of the mesh, from a face in the first to a face in the
    /// last of them. Both rows run from the goal to the start. O(k) for each merged face of k faces on the way.
    pub(super) fn refine(&self, mesh: &NavMesh, [start, goal]: [FaceId; 2], portals: &mut Vec<(u32, u32)>) {
        let mut row = Vec::with_capacity(3 * portals.len());
        let (mut at, mut paths) = (start.number(), [Vec::new(), Vec::new()]);
        for &(_, side) in portals.iter().rev() {
            // Behind a side lies the face that its twin belongs to, and the other way round.
            let [out, back] = [side, self.sides[side as usize].twin & ID].map(|side| self.original(side));
            self.walk(mesh, at, mesh.sides[back as usize].across & ID, &mut row, &mut paths);
            row.push((mesh.sides[back as usize].across & ID, out));
            at = mesh.sides[out as usize].across & ID;
        }
        self.walk(mesh, at, goal.number(), &mut row, &mut paths);
        row.reverse();
        *portals = row;
    }

    /// The portals from one face to another of the same merged face: up its tree to where the paths of both to the root
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
        row.extend(up.windows(2).map(|pair| mesh.portal_to(pair[0], pair[1])));
        row.extend(down.windows(2).rev().map(|pair| mesh.portal_to(pair[1], pair[0])));
    }
}

/// The rings of sides round some faces, while these are put together. Their faces and sides have numbers of their own,
/// one after the other.
struct Rings<'a> {
    mesh: &'a NavMesh,
    /// The faces.
    faces: Vec<u32>,
    /// The sides as the mesh numbers them, face by face.
    sides: Vec<u32>,
    /// The side after each, and the one before it, along its face; [`NONE`] if it is not there any more.
    next: Vec<u32>,
    prev: Vec<u32>,
    /// The face on the left of each side.
    owner: Vec<u32>,
    /// The same side of the face behind it; [`NONE`] if it is closed, or that face is not among these.
    twin: Vec<u32>,
    /// For each face one of the faces it was joined to; itself for one of each merged face.
    joined: Vec<u32>,
}

impl<'a> Rings<'a> {
    fn new(mesh: &'a NavMesh, faces: Vec<u32>) -> Self {
        let count = faces.iter().map(|&f| mesh.range(FaceId::new(f)).len()).sum();
        let none = || vec![NONE; count];
        let joined = (0..faces.len() as u32).collect();
        let sides = Vec::with_capacity(count);
        let mut rings = Self { mesh, faces, sides, next: none(), prev: none(), owner: none(), twin: none(), joined };
        for face in 0..rings.faces.len() {
            let range = mesh.range(FaceId::new(rings.faces[face]));
            let first = rings.sides.len();
            let end = first + range.len();
            rings.sides.extend(range.map(|s| s as u32));
            for s in first..end {
                rings.owner[s] = face as u32;
                rings.link(s, if s + 1 == end { first } else { s + 1 });
            }
        }
        rings.find_twins();
        rings
    }

    fn find_twins(&mut self) {
        let open = |&s: &u32| self.mesh.sides[self.sides[s as usize] as usize].across & CLOSED == 0;
        let half_edge = |s: u32| self.mesh.half_edges[self.sides[s as usize] as usize];
        let sides = || (0..self.sides.len() as u32).filter(open);
        let bound = sides().map(|s| half_edge(s).index() + 1).max().unwrap_or(0);
        if bound > 32 * self.sides.len() {
            // Few of many: not worth a list of all half-edges.
            let mut by_edge: Vec<(u32, u32)> = sides().map(|s| (half_edge(s).edge().number(), s)).collect();
            by_edge.sort_unstable();
            for pair in by_edge.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
                self.twin[pair[0].1 as usize] = pair[1].1;
                self.twin[pair[1].1 as usize] = pair[0].1;
            }
            return;
        }
        let mut side_of = vec![NONE; bound + 1];
        sides().for_each(|s| side_of[half_edge(s).index()] = s);
        let twins: Vec<(u32, u32)> = sides().map(|s| (s, side_of[half_edge(s).twin().index()])).collect();
        twins.into_iter().for_each(|(s, twin)| self.twin[s as usize] = twin);
    }

    fn link(&mut self, s: usize, next: usize) {
        self.next[s] = next as u32;
        self.prev[next] = s as u32;
    }

    /// The side as the mesh has it.
    fn record(&self, s: usize) -> SideRecord {
        self.mesh.sides[self.sides[s] as usize]
    }

    /// The portals that may be taken away, each with its two sides, the longest first.
    fn portals(&self) -> Vec<[u32; 2]> {
        let mut portals: Vec<(f64, [u32; 2])> = Vec::new();
        for (s, &t) in (0..).zip(&self.twin) {
            let is_dead_end = |s: u32| self.mesh.is_peeled(self.faces[self.owner[s as usize] as usize]);
            if t != NONE && s < t && is_dead_end(s) == is_dead_end(t) {
                let [a, b] = [s, t].map(|s| self.origin(s as usize));
                let [x, y] = [b.x - a.x, b.y - a.y];
                portals.push((x * x + y * y, [s, t]));
            }
        }
        portals.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        portals.into_iter().map(|(_, portal)| portal).collect()
    }

    /// The point at which a side starts.
    fn origin(&self, s: usize) -> Point {
        self.mesh.points[(self.record(s).origin & ID) as usize]
    }

    /// Takes away the portal with these two sides, if the faces beside it are different ones and make a convex one.
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

    /// Writes down the trees of faces that were put together, each by the next face on the way to its root.
    fn write_ups(&self, ups: &mut [u32]) {
        // The sides of a face are where they were at first: from its first one on.
        let mut firsts = Vec::with_capacity(self.faces.len() + 1);
        firsts.push(0);
        for (s, pair) in self.owner.windows(2).enumerate() {
            if pair[0] != pair[1] {
                firsts.push(s + 1);
            }
        }
        firsts.push(self.sides.len());
        let is_root = |f: &u32| self.joined[*f as usize] == *f;
        let mut stack: Vec<u32> = (0..self.faces.len() as u32).filter(is_root).collect();
        while let Some(face) = stack.pop() {
            let f = self.faces[face as usize];
            for s in firsts[face as usize]..firsts[face as usize + 1] {
                if self.next[s] != NONE || self.twin[s] == NONE {
                    continue;
                }
                let beyond = self.owner[self.twin[s] as usize];
                if ups[f as usize] != self.faces[beyond as usize] {
                    ups[self.faces[beyond as usize] as usize] = f;
                    stack.push(beyond);
                }
            }
        }
    }

    /// Writes the rings down one after the other, in the order of the curve, behind those that are there.
    fn add_to(mut self, merged: &mut Merged) {
        let mesh = self.mesh;
        let mut starts = vec![NONE; self.faces.len()];
        let mut firsts: Vec<(u64, u32)> = Vec::new();
        for s in 0..self.sides.len() {
            if self.next[s] == NONE {
                continue;
            }
            let root = self.root(self.owner[s]) as usize;
            if std::mem::replace(&mut starts[root], 0) == NONE {
                firsts.push((merged.curve.key(self.origin(s)), s as u32));
            }
        }
        firsts.sort_unstable();
        let begin = merged.sides.len();
        let mut order: Vec<u32> = Vec::new();
        let mut ranges: Vec<Range<usize>> = Vec::new();
        let mut placed = vec![NONE; self.next.len()];
        for &(_, first) in &firsts {
            let start = order.len();
            order.extend(std::iter::successors(Some(first), |&s| Some(self.next[s as usize]).filter(|&s| s != first)));
            let range = start..order.len();
            range.clone().for_each(|i| placed[order[i] as usize] = (begin + i) as u32);
            starts[self.root(self.owner[first as usize]) as usize] = (begin + start) as u32;
            ranges.push(range);
        }
        for face in 0..self.faces.len() as u32 {
            merged.wholes[self.faces[face as usize] as usize] = starts[self.root(face) as usize];
        }
        self.write_ups(&mut merged.ups);
        // Open sides into merged faces that were there before: the half-edge behind, and the side here.
        let mut outwards: Vec<(u32, HalfEdgeId, u32)> = Vec::new();
        merged.sides.reserve(order.len());
        merged.originals.extend(order.iter().map(|&s| self.sides[s as usize]));
        for range in ranges {
            for i in range.clone() {
                let s = order[i] as usize;
                let SideRecord { origin, across } = self.record(s);
                let twin = if across & CLOSED != 0 {
                    CLOSED
                } else if self.twin[s] != NONE {
                    placed[self.twin[s] as usize] | across & DEAD_END
                } else {
                    let behind = mesh.half_edges[self.sides[s] as usize].twin();
                    outwards.push((merged.wholes[(across & ID) as usize], behind, (begin + i) as u32));
                    across & DEAD_END
                };
                let [start, end] = [range.start, range.end].map(|i| (begin + i) as u32);
                merged.sides.push(WideSide { at: self.origin(s), origin, twin, start, end });
            }
        }
        outwards.sort_unstable();
        for same in outwards.chunk_by(|a, b| a.0 == b.0) {
            for other in merged.sides[same[0].0 as usize].range() {
                let half_edge = mesh.half_edges[merged.originals[other] as usize];
                if let Ok(found) = same.binary_search_by_key(&half_edge, |&(_, behind, _)| behind) {
                    let (_, _, here) = same[found];
                    merged.sides[here as usize].twin |= other as u32;
                    let there = &mut merged.sides[other].twin;
                    *there = *there & DEAD_END | here;
                }
            }
        }
    }
}
