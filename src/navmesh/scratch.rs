//! What all searches share: the query, what may be entered, what was reached, the corridor that was found.

use super::funnel::{self, Endpoint, Funnel};
use super::marks::{CLOSED, DEAD_END, ID};
use super::merged::Merged;
use super::{NavMesh, QueryPoint, Route, Work};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What a search knows about a face.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reached {
    /// In which query it was reached.
    pub(super) query: u32,
    /// From which face, by which side of it; `NONE` for a start.
    pub(super) from: u32,
    pub(super) side: u32,
    /// Whether it was taken from the queue with this guess.
    pub(super) done: bool,
    /// The guess, as the queue has it.
    pub(super) key: u64,
    /// The length of the line so far.
    pub(super) length: f64,
    /// Where the line ends.
    pub(super) at: Point,
}

/// What all searches share.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// The number of the query.
    pub(super) query: u32,
    /// A bit for each face, or for each side of the merged ones: whether what it belongs to may be entered even if it
    /// is a dead end.
    allowed: Vec<u64>,
    /// The words of these bits that are not 0.
    allowed_words: Vec<usize>,
    pub(super) reached: Vec<Reached>,
    /// Keys are the bits of a length, which is not negative: they are in the order of the lengths.
    pub(super) queue: BinaryHeap<Reverse<(u64, u32)>>,
    pub(super) funnel: Funnel,
    pub(super) starts: Vec<FaceId>,
    pub(super) goals: Vec<FaceId>,
    pub(super) work: Work,
    /// The portals of the corridor that was found, by side, from the goal to the start.
    pub(super) portals: Vec<(u32, u32)>,
    /// Further corridors that were found on the way, to other faces at the goal.
    pub(super) others: Vec<Vec<(u32, u32)>>,
}

impl Scratch {
    /// Takes a new number for the query, and lets it into the dead ends of its start and goal. Starts, goals and dead
    /// ends are merged faces, if there are any.
    pub(super) fn begin(&mut self, mesh: &NavMesh, start: &QueryPoint, goal: &QueryPoint, merged: Option<&Merged>) {
        self.query = self.query.wrapping_add(1);
        if self.query == 0 {
            self.reached.clear();
            self.query = 1;
        }
        self.allowed_words.drain(..).for_each(|word| self.allowed[word] = 0);
        let bound = merged.map_or(mesh.face_bound(), Merged::bound);
        self.allowed.resize((bound / 64 + 1).max(self.allowed.len()), 0);
        self.queue.clear();
        self.portals.clear();
        self.others.clear();
        self.work = Work::default();
        self.starts.clear();
        mesh.add_faces_at(start, &mut self.starts);
        self.goals.clear();
        mesh.add_faces_at(goal, &mut self.goals);
        let room = |f: FaceId| merged.map_or(f, |merged| merged.whole(f));
        for &f in self.starts.iter().chain(&self.goals) {
            for f in mesh.portal_path(f) {
                let bits = merged.map_or(f.index()..f.index() + 1, |merged| merged.range(room(f)));
                // A merged face is let in once, however many of its faces the path has.
                if self.is_allowed(bits.start as u32) {
                    continue;
                }
                for bit in bits {
                    let word = &mut self.allowed[bit / 64];
                    if *word == 0 {
                        self.allowed_words.push(bit / 64);
                    }
                    *word |= 1 << (bit % 64);
                }
            }
        }
        if merged.is_some() {
            for ends in [&mut self.starts, &mut self.goals] {
                ends.iter_mut().for_each(|f| *f = room(*f));
                ends.dedup();
            }
        }
    }

    /// Lets the query into all dead ends.
    pub(super) fn allow_all(&mut self) {
        self.allowed.fill(u64::MAX);
        self.allowed_words.clear();
        self.allowed_words.extend(0..self.allowed.len());
    }

    /// Whether a search may cross a side with this word: it is open, and no useless dead end lies behind.
    #[inline]
    pub(super) fn may_cross(&self, across: u32) -> bool {
        // Without a branch: what lies where is not to be guessed.
        (across & CLOSED == 0) & ((across & DEAD_END == 0) | self.is_allowed(across & ID))
    }

    /// Whether a dead end, by the face or by the side of the merged one, is no useless one.
    #[inline]
    pub(super) fn is_allowed(&self, dead_end: u32) -> bool {
        self.allowed[dead_end as usize / 64] >> (dead_end % 64) & 1 != 0
    }

    /// Pulls the path straight through the portals that were found: its points, and the vertices it bends at.
    pub(super) fn pull(
        &mut self,
        mesh: &NavMesh,
        merged: Option<&Merged>,
        [start, goal]: [Point; 2],
    ) -> (Vec<Point>, Vec<VertexId>) {
        self.funnel.start(Endpoint::free(start));
        for &(face, side) in self.portals.iter().rev() {
            let face = FaceId::new(face);
            let [right, left] = merged.map_or_else(|| mesh.ends(face, side as usize), |merged| merged.ends(side));
            self.funnel.pass_between(mesh, left, right);
        }
        let way = self.funnel.finish(Endpoint::free(goal));
        // A bend at the start or the goal itself is none; but a path may come back to that corner in another wedge.
        let begin = way.iter().position(|endpoint| endpoint.point != start).unwrap_or(way.len());
        let end = way.iter().rposition(|endpoint| endpoint.point != goal).map_or(begin, |last| begin.max(last + 1));
        let corners: Vec<VertexId> = way[begin..end].iter().map(|endpoint| VertexId::new(endpoint.vertex)).collect();
        let bends = corners.iter().map(|&v| mesh.point(v));
        (std::iter::once(start).chain(bends).chain([goal]).collect(), corners)
    }

    /// The route along the way, through the portals of the mesh.
    pub(super) fn finish(
        &self,
        mesh: &NavMesh,
        first: FaceId,
        (points, corners): (Vec<Point>, Vec<VertexId>),
    ) -> Route {
        let mut faces = Vec::with_capacity(self.portals.len() + 1);
        let mut portals: Vec<HalfEdgeId> = Vec::with_capacity(self.portals.len());
        faces.push(first);
        for &(_, side) in self.portals.iter().rev() {
            portals.push(mesh.half_edges[side as usize]);
            faces.push(FaceId::new(mesh.sides[side as usize].across & ID));
        }
        Route { faces, portals, length: funnel::length(&points), points, corners, work: self.work }
    }
}
