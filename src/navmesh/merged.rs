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

use super::mesh::{CLOSED, DEAD_END, FaceRecord, ID, NONE, SideRecord, turns_left_or_runs_straight};
use super::{NavMesh, Place};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;

/// The merged faces of a mesh, as the exact search takes them.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    pub(super) faces: Vec<FaceRecord>,
    pub(super) sides: Vec<SideRecord>,
    /// For each of these sides which one of the mesh it is.
    origins: Vec<u32>,
    /// For each face of the mesh the merged one that has it; [`NONE`] for those nobody may enter.
    wholes: Vec<u32>,
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
    /// Cost: O(n log n); about 30 bytes a triangle.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, Rung};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from).to_vec();
    /// let mut mesh = NavMesh::new(&Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?)?;
    /// assert_eq!(mesh.merge_faces(), 1);
    /// let route = Planner::new().route_between(&mesh, Rung::Exact, (1.5, 0.5).into(), (0.5, 1.5).into())?;
    /// assert_eq!(route.faces.len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn merge_faces(&mut self) -> usize {
        let merged = Merged::new(self);
        let count = merged.faces.len();
        self.merged = Some(merged);
        count
    }

    /// The merged faces; none if [`merge_faces`](Self::merge_faces) was not called, or something has changed since.
    /// O(n).
    #[must_use]
    pub fn merged_faces(&self) -> Vec<MergedFace> {
        let Some(merged) = &self.merged else { return Vec::new() };
        let corners =
            |face: &FaceRecord| merged.sides[face.range()].iter().map(|side| VertexId::new(side.origin & ID)).collect();
        let mut faces: Vec<MergedFace> =
            merged.faces.iter().map(|face| MergedFace { corners: corners(face), faces: Vec::new() }).collect();
        for (f, &whole) in (0..).zip(&merged.wholes) {
            if let Some(face) = faces.get_mut(whole as usize) {
                face.faces.push(FaceId::new(f));
            }
        }
        faces
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

    /// The side of the mesh that a side of a merged face is.
    #[inline]
    pub(super) fn origin(&self, side: u32) -> u32 {
        self.origins[side as usize]
    }

    /// The merged face behind a side of another.
    pub(super) fn behind(&self, side: u32) -> FaceId {
        FaceId::new(self.sides[side as usize].across & ID)
    }

    /// The face of the merged one `whole` in which one stands at the place.
    pub(super) fn face_at(&self, mesh: &NavMesh, place: &Place, whole: FaceId) -> FaceId {
        if self.whole(place.face) == whole {
            return place.face;
        }
        mesh.faces_at(place).into_iter().find(|&f| self.whole(f) == whole).unwrap_or(place.face)
    }

    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.faces) + size_of_val(&*self.sides) + size_of_val(&*self.origins) + size_of_val(&*self.wholes)
    }

    /// Makes of a row of doors of merged faces one of doors of the mesh, from a face in the first to a face in the
    /// last of them. Both rows run from the goal to the start. O(sides of the merged faces on the way).
    pub(super) fn refine(&self, mesh: &NavMesh, [start, goal]: [FaceId; 2], doors: &mut Vec<(u32, u32)>) {
        let mut row = Vec::with_capacity(2 * doors.len());
        let mut at = start;
        for &(_, side) in doors.iter().rev() {
            let side = self.origin(side);
            at = self.walk(mesh, at, |f| mesh.range(f).contains(&(side as usize)), &mut row);
            row.push((at.number(), side));
            at = FaceId::new(mesh.sides[side as usize].across & ID);
        }
        self.walk(mesh, at, |f| f == goal, &mut row);
        row.reverse();
        *doors = row;
    }

    /// The doors from one face to another of the same merged face: the path between them in its tree. Returns where
    /// it ends.
    fn walk(
        &self,
        mesh: &NavMesh,
        from: FaceId,
        is_there: impl Fn(FaceId) -> bool,
        row: &mut Vec<(u32, u32)>,
    ) -> FaceId {
        let (first, whole) = (row.len(), self.whole(from));
        let borders = &self.origins[self.faces[whole.index()].range()];
        // The sides of the face on top that have not been tried yet; those below are on the path.
        let mut untried = vec![mesh.range(from)];
        let mut at = from;
        while !is_there(at) {
            let before = row[first..].last().map_or(NONE, |&(face, _)| face);
            let leads_on = |s: usize| {
                let across = mesh.sides[s].across;
                across & CLOSED == 0 && across & ID != before && !borders.contains(&(s as u32))
            };
            if let Some(s) = untried.last_mut().and_then(|sides| sides.find(|&s| leads_on(s))) {
                row.push((at.number(), s as u32));
                at = FaceId::new(mesh.sides[s].across & ID);
                untried.push(mesh.range(at));
            } else if row.len() > first
                && let Some((back, _)) = row.pop()
            {
                untried.pop();
                at = FaceId::new(back);
            } else {
                return from;
            }
        }
        at
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
    /// For each face one of the faces it was joined to; itself for one of each merged face.
    joined: Vec<u32>,
}

impl<'a> Rings<'a> {
    /// Those of the faces that may be entered.
    fn new(mesh: &'a NavMesh) -> Self {
        let none = vec![NONE; mesh.sides.len()];
        let joined = (0..mesh.faces.len() as u32).collect();
        let mut rings = Self { mesh, next: none.clone(), prev: none.clone(), owner: none, joined };
        for f in mesh.faces().filter(|&f| mesh.is_walkable(f)) {
            let range = mesh.range(f);
            for s in range.clone() {
                rings.owner[s] = f.number();
                rings.link(s, if s + 1 == range.end { range.start } else { s + 1 });
            }
        }
        rings
    }

    fn link(&mut self, s: usize, next: usize) {
        self.next[s] = next as u32;
        self.prev[next] = s as u32;
    }

    /// The doors that may be taken away, each with its two sides, the longest first.
    fn doors(&self) -> Vec<[u32; 2]> {
        let Self { mesh, owner, .. } = self;
        let bound = mesh.half_edges.iter().map(|h| h.index() + 1).max().unwrap_or(0);
        let mut side_of = vec![NONE; bound + 1];
        for (s, h) in mesh.half_edges.iter().enumerate().filter(|&(s, _)| owner[s] != NONE) {
            side_of[h.index()] = s as u32;
        }
        let mut doors: Vec<(f64, [u32; 2])> = Vec::new();
        for (s, h) in mesh.half_edges.iter().enumerate().filter(|&(s, _)| owner[s] != NONE) {
            let across = mesh.sides[s].across;
            let twin = side_of[h.twin().index()];
            let alike = || mesh.is_peeled(owner[s]) == mesh.is_peeled(across & ID);
            if across & CLOSED == 0 && twin != NONE && h.index() & 1 == 0 && alike() {
                let [a, b] = [s, twin as usize].map(|s| self.origin(s));
                let [x, y] = [b.x - a.x, b.y - a.y];
                doors.push((x * x + y * y, [s as u32, twin]));
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

    /// Writes the rings down one after the other, in the order of their first faces.
    fn collect(mut self) -> Merged {
        let mesh = self.mesh;
        let mut merged =
            Merged { faces: Vec::new(), sides: Vec::new(), origins: Vec::new(), wholes: vec![NONE; mesh.faces.len()] };
        for f in mesh.faces().filter(|&f| mesh.is_walkable(f)) {
            let root = self.root(f.number()) as usize;
            for first in mesh.range(f) {
                let start = merged.origins.len();
                let mut s = first;
                while self.next[s] != NONE {
                    merged.origins.push(s as u32);
                    s = std::mem::replace(&mut self.next[s], NONE) as usize;
                }
                if merged.origins.len() > start {
                    merged.wholes[root] = merged.faces.len() as u32;
                    merged.faces.push(FaceRecord::new(start, merged.origins.len()));
                }
            }
        }
        for f in mesh.faces().filter(|&f| mesh.is_walkable(f)) {
            merged.wholes[f.index()] = merged.wholes[self.root(f.number()) as usize];
        }
        merged.sides = merged.origins.iter().map(|&s| merged.renumbered(mesh.sides[s as usize])).collect();
        merged.faces.shrink_to_fit();
        merged.origins.shrink_to_fit();
        merged
    }
}

impl Merged {
    /// The record of a side with the merged face behind it.
    fn renumbered(&self, side: SideRecord) -> SideRecord {
        let across = if side.across & CLOSED == 0 {
            self.wholes[(side.across & ID) as usize] | side.across & DEAD_END
        } else {
            CLOSED
        };
        SideRecord { across, ..side }
    }
}
