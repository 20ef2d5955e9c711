//! Portals that close and faces that are blocked: everything that is derived is brought up to date near the change.
//!
//! ```text
//!   ┌───┬───┬───┐   block f    The near faces are f and its neighbours. Their portal paths are no dead ends for the time
//!   │   │ f │ ✕ │   ───────>   being: every new round trip runs along them. Then what can be peeled is peeled again,
//!   └───┴───┴───┘              as far as it goes. Components grow side by side from the near faces until all have
//!                              met, or all but one have come to an end.
//! ```
//!
//! Merged faces and junctions, if they have been made, are kept: those near the change are made anew (`upkeep.rs`).

use super::marks::{CLOSED, DEAD_END, ID, NONE, SideRecord};
use super::mesh::NavMesh;
use super::upkeep::Upkeep;
use crate::ids::{EdgeId, FaceId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

impl NavMesh {
    /// Blocks the face `f`: nobody may enter it, but it stays a face of the mesh and points are still found in it.
    /// Returns whether it was blocked before; `None` if it is no face of the mesh, and nothing happens.
    ///
    /// Cost: O(length of the portal paths nearby, number of faces that become or cease to be dead ends, and twice the
    /// size of what is cut off or joined); if merged faces and junctions have been made, O(k log k) more for k sides of
    /// the merged faces and faces of the corridors that reach there.
    ///
    /// ```
    /// use dcel_kit::{FaceId, navmesh::NavMesh, plane::{Point, Subdivision}};
    /// let points = [(0., 0.), (1., 0.), (2., 0.), (3., 0.), (0., 1.), (1., 1.), (2., 1.), (3., 1.)].map(Point::from);
    /// let mut squares = dcel_kit::topology::PolygonList::new();
    /// [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6]].iter().for_each(|square| squares.push_face(square));
    /// let mut mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &squares)?)?;
    /// assert_eq!(mesh.block(FaceId::new(2)), Some(false));
    /// assert_eq!(mesh.component_count(), 2);
    /// assert_eq!(mesh.unblock(FaceId::new(2)), Some(true));
    /// assert_eq!(mesh.component_count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn block(&mut self, f: FaceId) -> Option<bool> {
        self.put_blocked(f, true)
    }

    /// Takes back [`block`](Self::block). Returns whether the face was blocked before; `None` if it is no face of the
    /// mesh, and nothing happens. Cost as there.
    pub fn unblock(&mut self, f: FaceId) -> Option<bool> {
        self.put_blocked(f, false)
    }

    fn put_blocked(&mut self, f: FaceId, blocked: bool) -> Option<bool> {
        if !self.has_face(f) {
            return None;
        }
        let before = self.is_blocked(f);
        if before != blocked {
            self.change(&[f], |mesh| mesh.set_blocked(f, blocked));
        }
        Some(before)
    }

    /// Makes the edge between two faces a wall, or a portal again. Returns whether it was a wall before; `None` if
    /// `face` has no such edge, or a hole lies behind it, and nothing happens. Cost as for [`block`](Self::block).
    pub fn set_wall(&mut self, face: FaceId, edge: EdgeId, wall: bool) -> Option<bool> {
        let side = self.sides(face).find(|side| side.half_edge.edge() == edge)?;
        if !self.has_face(side.across) {
            return None;
        }
        let before = self.walls.contains(&edge);
        if before != wall {
            self.change(&[face, side.across], |mesh| mesh.put_wall(edge, wall));
        }
        Some(before)
    }

    /// Whether an edge between two faces was made a wall.
    #[must_use]
    pub fn is_wall(&self, edge: EdgeId) -> bool {
        self.walls.contains(&edge)
    }

    pub(super) fn put_wall(&mut self, edge: EdgeId, wall: bool) {
        if wall {
            self.walls.insert(edge)
        } else {
            self.walls.remove(&edge)
        };
    }

    /// Runs `edit`, which changes the marks or the sides of `faces` and of no others, and brings up to date what
    /// follows from them. Faces may come and go, provided that they are among `faces`.
    pub(super) fn change(&mut self, faces: &[FaceId], edit: impl FnOnce(&mut Self)) {
        let mut near = BTreeSet::new();
        self.gather_near(faces, &mut near);
        let upkeep = Upkeep::begin(self, &near);
        let mut open_again: Vec<u32> = Vec::new();
        near.iter().for_each(|&f| self.unpeel(f, &mut open_again));
        near.iter().for_each(|&f| self.set_component(f, NONE));

        edit(self);

        self.gather_near(faces, &mut near);
        let mut corners = BTreeSet::new();
        for &f in &near {
            self.unpeel(f, &mut open_again);
            self.set_component(f, NONE);
            self.close_and_open_sides(f);
            corners.extend(self.corners(FaceId::new(f)));
        }
        corners.iter().for_each(|&v: &VertexId| self.mark_turns(v));
        self.relabel_components(&near);
        open_again.extend(&near);
        self.peel(&mut open_again);
        upkeep.finish(self, &near, &corners);
    }

    fn gather_near(&self, faces: &[FaceId], near: &mut BTreeSet<u32>) {
        for &f in faces.iter().filter(|&&f| self.has_face(f)) {
            near.insert(f.number());
            let across = self.sides_of(f).iter().map(|side| side.across & ID);
            near.extend(across.filter(|&g| self.has_face(FaceId::new(g))));
        }
    }

    /// Makes all faces on the portal path of `f` ordinary ones.
    fn unpeel(&mut self, f: u32, open_again: &mut Vec<u32>) {
        // The portals are found by their marks, so the whole path comes first.
        let path: Vec<FaceId> = self.portal_path(FaceId::new(f)).collect();
        self.visited += path.len();
        for pair in path.windows(2) {
            self.set_peeled(pair[0].number(), false);
            self.mark_dead_end(pair[1].number(), pair[0].number(), false);
        }
        open_again.extend(path.into_iter().map(FaceId::number));
    }

    /// Decides anew which sides of `f` are closed.
    fn close_and_open_sides(&mut self, f: u32) {
        let here = self.is_blocked(FaceId::new(f));
        for s in self.range(FaceId::new(f)) {
            let across = self.sides[s].across & ID;
            let closed = here
                || !self.is_walkable(FaceId::new(across))
                || (!self.walls.is_empty() && self.walls.contains(&self.half_edges[s].edge()));
            let dead_end = self.sides[s].across & DEAD_END;
            self.sides[s].across = across | if closed { CLOSED } else { dead_end };
        }
    }

    /// Labels the near faces, which have lost their numbers, and whatever they are joined to or cut off from.
    fn relabel_components(&mut self, near: &BTreeSet<u32>) {
        let seeds: Vec<u32> = near.iter().copied().filter(|&f| self.is_walkable(FaceId::new(f))).collect();
        let (ended, growing) = self.grow_parts(&seeds);
        self.visited += ended.iter().map(Vec::len).sum::<usize>() + growing.len();
        // What is still growing keeps the number of its largest old part; the near faces have lost theirs.
        let open = |side: &&SideRecord| side.across & CLOSED == 0;
        let beside = growing.iter().flat_map(|&f| self.sides_of(FaceId::new(f)).iter().filter(open));
        let reached = growing.iter().copied().chain(beside.map(|side| side.across & ID));
        let numbers = reached.map(|f| self.faces[f as usize].component).filter(|&c| c != NONE);
        let largest = numbers.max_by_key(|&c| (self.component_sizes[c as usize], u32::MAX - c));
        for part in ended {
            let number = self.free_number();
            part.into_iter().for_each(|f| self.set_component(f, number));
        }
        if !growing.is_empty() {
            let number = largest.unwrap_or_else(|| self.free_number());
            growing.into_iter().for_each(|f| self.flood(f, number));
        }
    }

    fn free_number(&mut self) -> u32 {
        self.free_components.first().copied().unwrap_or_else(|| {
            self.component_sizes.push(0);
            self.component_sizes.len() as u32 - 1
        })
    }

    /// Grows parts from all seeds, turn by turn, joins those that meet, and stops when one is left. Returns the parts
    /// that came to an end, and all faces of the one that may go on (as far as it has grown).
    fn grow_parts(&self, seeds: &[u32]) -> (Vec<Vec<u32>>, Vec<u32>) {
        let mut part_of: BTreeMap<u32, usize> = seeds.iter().enumerate().map(|(i, &f)| (f, i)).collect();
        let mut joined_to: Vec<usize> = (0..seeds.len()).collect();
        // The faces of each part; those before the mark have been looked at.
        let mut parts: Vec<(Vec<u32>, usize)> = seeds.iter().map(|&f| (vec![f], 0)).collect();
        let mut growing: Vec<usize> = (0..seeds.len()).collect();
        let root = |joined_to: &[usize], mut i: usize| {
            while joined_to[i] != i {
                i = joined_to[i];
            }
            i
        };
        let mut ended = Vec::new();
        while growing.len() > 1 {
            for &i in &growing {
                if joined_to[i] != i {
                    continue;
                }
                let (faces, looked_at) = &mut parts[i];
                let Some(&f) = faces.get(*looked_at) else { continue };
                *looked_at += 1;
                for side in self.sides_of(FaceId::new(f)).iter().filter(|side| side.across & CLOSED == 0) {
                    let next = side.across & ID;
                    let here = root(&joined_to, i);
                    let Some(&other) = part_of.get(&next) else {
                        part_of.insert(next, here);
                        parts[here].0.push(next);
                        continue;
                    };
                    let other = root(&joined_to, other);
                    if other != here {
                        // The part with more to look at takes in the other, which has its faces looked at again.
                        let (faces, _) = std::mem::take(&mut parts[here]);
                        parts[other].0.extend(faces);
                        joined_to[here] = other;
                    }
                }
            }
            growing.retain(|&i| joined_to[i] == i);
            growing.retain(|&i| {
                let (faces, looked_at) = &mut parts[i];
                let goes_on = *looked_at < faces.len();
                if !goes_on {
                    ended.push(std::mem::take(faces));
                }
                goes_on
            });
        }
        let rest = growing.first().map_or_else(Vec::new, |&i| std::mem::take(&mut parts[i].0));
        (ended, rest)
    }
}
