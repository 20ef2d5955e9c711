//! The fewest faces, from junction to junction.
//!
//! ```text
//!    s · · X · · · X · · X · g     From the start to the junctions at the ends of its reduced corridor; from there by whole
//!          │       │     │         reduced corridors, the nearest junction first; and so from the goal backwards. Distances
//!          · · · · X · · ·         are numbers of portals: a list for each number is all the queue it takes.
//! ```
//!
//! Two searches, one from the start, one from the goal. Once what is left of the one is at least a portals away, what is
//! left of the other at least b, and a row of at most a + b portals is known, there is none with fewer: a shorter one
//! would have a junction that both have settled. Start and goal in one reduced corridor, or before one portal path, are looked at
//! apart, as there need not be any junction between them.

use super::junctions::{CROSSING, CorridorRecord, Junctions, Link};
use super::marks::NONE;
use super::scratch::Scratch;
use super::{NavMesh, Work};
use crate::ids::FaceId;
use std::ops::Range;

/// In `by`: reached from an end; the rest is four times its number, and how.
const FROM_END: u32 = 1 << 31;
/// How: the end leads to the junction itself, or stands before the first or the second end of a reduced corridor.
pub(super) const AT_JUNCTION: u32 = 0;

/// What a search knows of a junction.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// In which query it was reached.
    query: u32,
    /// The number of portals to it.
    portals: u32,
    /// The link by which it was reached, or [`FROM_END`].
    by: u32,
}

/// One of the faces at which the way starts, or ends.
#[derive(Clone, Debug)]
pub(super) struct End {
    /// Its portal path in `trails`, up to the first face that is no dead end.
    trail: Range<usize>,
    /// Where that face is.
    pub(super) spot: u32,
    /// The reduced corridor, if it is in one.
    pub(super) reduced_corridor: u32,
}

/// How the start and the goal are joined.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meeting {
    At(u32),
    /// Without a junction, from one of the starts to one of the goals.
    Direct([usize; 2]),
}

/// A list of junctions for each number of portals.
#[derive(Clone, Debug, Default)]
struct Queue {
    /// The first of each list, in `items`. There are as many lists as any query took.
    heads: Vec<u32>,
    /// A junction, the next item of its list, and which list that is.
    items: Vec<(u32, u32, u32)>,
    /// No list before this one has any items.
    least: usize,
    /// How many items there are in all lists.
    len: usize,
}

impl Queue {
    fn clear(&mut self) {
        self.items.drain(..).for_each(|(_, _, portals)| self.heads[portals as usize] = NONE);
        (self.least, self.len) = (0, 0);
    }

    #[inline]
    fn push(&mut self, portals: u32, junction: u32) {
        if self.heads.len() <= portals as usize {
            self.heads.resize(portals as usize + 1, NONE);
        }
        let head = &mut self.heads[portals as usize];
        self.items.push((junction, *head, portals));
        *head = self.items.len() as u32 - 1;
        self.len += 1;
    }

    /// Takes an item of the list that [`least`](Self::least) has named, if there is one left.
    #[inline]
    fn pop(&mut self) -> Option<u32> {
        let head = &mut self.heads[self.least];
        let &(junction, next, _) = self.items.get(*head as usize)?;
        *head = next;
        self.len -= 1;
        Some(junction)
    }

    /// The number of portals of the first list that has any items.
    #[inline]
    fn least(&mut self) -> Option<u32> {
        if self.len == 0 {
            return None;
        }
        self.least += self.heads.get(self.least..)?.iter().position(|&head| head != NONE)?;
        Some(self.least as u32)
    }
}

/// The memory of the search.
#[derive(Clone, Debug, Default)]
pub(super) struct ReducedBfs {
    query: u32,
    /// For each junction what the search from the start knows of it, and the one from the goal.
    seen: Vec<[Seen; 2]>,
    queues: [Queue; 2],
    ends: [Vec<End>; 2],
    /// The portal paths of all ends.
    trails: Vec<u32>,
    /// The fewest portals that are known, and how.
    best: Option<(u32, Meeting)>,
    settled: u64,
    /// The faces of the path.
    faces: Vec<u32>,
}

/// What is noted of a junction that was reached from end `i`: see [`AT_JUNCTION`].
pub(super) fn from_end(i: usize, how: u32) -> u32 {
    FROM_END | (i as u32) << 2 | how
}

impl ReducedBfs {
    /// Begins a query: takes in the faces at which the way starts (0) or ends (1).
    pub(super) fn begin(&mut self, mesh: &NavMesh, junctions: &Junctions, scratch: &Scratch) {
        let query = scratch.query;
        if query == 1 {
            self.seen.clear();
        }
        self.seen.resize(junctions.len().max(self.seen.len()), Default::default());
        self.query = query;
        self.queues.iter_mut().for_each(Queue::clear);
        self.ends.iter_mut().for_each(Vec::clear);
        self.trails.clear();
        self.best = None;
        self.settled = 0;
        for (which, faces) in [&scratch.starts, &scratch.goals].into_iter().enumerate() {
            faces.iter().for_each(|&f| self.add_end(mesh, junctions, which, f));
        }
    }

    fn add_end(&mut self, mesh: &NavMesh, junctions: &Junctions, which: usize, f: FaceId) {
        let first = self.trails.len();
        self.trails.extend(mesh.portal_path(f).map(FaceId::number));
        let spot = junctions.spot(self.trails[self.trails.len() - 1]);
        let reduced_corridor = if spot & CROSSING == 0 { junctions.reduced_corridor_at(spot) } else { NONE };
        self.ends[which].push(End { trail: first..self.trails.len(), spot, reduced_corridor });
    }

    /// The faces at which the way starts, or ends.
    pub(super) fn ends(&self, which: usize) -> &[End] {
        &self.ends[which]
    }

    /// The portal path of one of them.
    pub(super) fn trail(&self, end: &End) -> &[u32] {
        &self.trails[end.trail.clone()]
    }

    /// The faces of the path that was told last.
    pub(super) fn faces(&self) -> &[u32] {
        &self.faces
    }

    /// Reaches the junctions next to an end.
    fn set_out(&mut self, junctions: &Junctions, which: usize, i: usize) {
        let End { ref trail, spot, reduced_corridor } = self.ends[which][i];
        let depth = trail.len() as u32 - 1;
        if reduced_corridor == NONE {
            self.reach(which, spot & !CROSSING, depth, from_end(i, AT_JUNCTION));
            return;
        }
        let CorridorRecord { ends, first, end } = junctions.reduced_corridor(reduced_corridor);
        for (how, junction, portals) in [(1, ends[0], spot - first + 1), (2, ends[1], end - spot)] {
            if junction != NONE {
                self.reach(which, junction, depth + portals, from_end(i, how));
            }
        }
    }

    /// Reaches a junction, unless it was reached through no more portals before, or a row with no more is known.
    #[inline]
    fn reach(&mut self, which: usize, junction: u32, portals: u32, by: u32) {
        if self.best.is_some_and(|(least, _)| least <= portals) {
            return;
        }
        let query = self.query;
        let seen = &mut self.seen[junction as usize];
        if seen[which].query == query && seen[which].portals <= portals {
            return;
        }
        seen[which] = Seen { query, portals, by };
        let other = seen[1 - which];
        self.queues[which].push(portals, junction);
        if other.query == query {
            self.improve(portals + other.portals, Meeting::At(junction));
        }
    }

    fn improve(&mut self, portals: u32, meeting: Meeting) {
        if self.best.is_none_or(|(least, _)| portals < least) {
            self.best = Some((portals, meeting));
        }
    }

    /// Lets both searches go on until nothing better can come.
    fn search(&mut self, junctions: &Junctions) {
        while let [Some(a), Some(b)] = self.queues.each_mut().map(Queue::least) {
            if self.best.is_some_and(|(portals, _)| portals <= a + b) {
                break;
            }
            let which = usize::from(self.queues[1].len < self.queues[0].len);
            let portals = [a, b][which];
            while let Some(junction) = self.queues[which].pop() {
                // One that was reached through fewer portals since has been settled already.
                if self.seen[junction as usize][which].portals == portals {
                    self.settled += 1;
                    for &Link { to, portals: more, by } in junctions.links(junction) {
                        self.reach(which, to, portals + more, by);
                    }
                }
            }
        }
    }

    /// The number of portals from a start to a goal if there need not be a junction between them.
    pub(super) fn portals_between(&self, junctions: &Junctions, [a, b]: [&End; 2]) -> Option<u32> {
        let [up, down] = [a, b].map(|end| end.trail.len());
        let common = self.common([a, b]);
        if common > 0 {
            return Some((up - common + down - common) as u32);
        }
        let along = if a.reduced_corridor != NONE && a.reduced_corridor == b.reduced_corridor {
            junctions.reduced_corridor(a.reduced_corridor).portals_between(a.spot, b.spot).0
        } else {
            return None;
        };
        Some((up - 1 + down - 1) as u32 + along)
    }

    /// How many faces the portal paths of two ends have in common: the last ones.
    fn common(&self, [a, b]: [&End; 2]) -> usize {
        let [a, b] = [a, b].map(|end| self.trails[end.trail.clone()].iter().rev());
        a.zip(b).take_while(|(f, g)| f == g).count()
    }

    /// Notes by which link, or from which end, a junction was reached.
    pub(super) fn note(&mut self, which: usize, junction: u32, by: u32) {
        self.seen[junction as usize][which] = Seen { query: self.query, portals: 0, by };
    }

    /// Whether who goes into a reduced corridor from the junction at its first (1) or second (2) end goes back on the way by which
    /// the search from the start came to that junction.
    pub(super) fn is_back(&self, junction: u32, reduced_corridor: u32, end: u32) -> bool {
        let by = self.seen[junction as usize][0].by;
        if by & FROM_END == 0 {
            by >> 1 == reduced_corridor
        } else {
            by & 3 == end && self.ends[0][(by & !FROM_END) as usize >> 2].reduced_corridor == reduced_corridor
        }
    }

    /// Writes the faces of a path down, from the start to the goal.
    pub(super) fn tell(&mut self, junctions: &Junctions, meeting: Meeting) {
        let mut faces = std::mem::take(&mut self.faces);
        faces.clear();
        match meeting {
            Meeting::At(junction) => {
                self.tell_back(junctions, 0, junction, &mut faces);
                faces.reverse();
                faces.push(junctions.face(junction));
                self.tell_back(junctions, 1, junction, &mut faces);
            }
            Meeting::Direct([i, k]) => {
                let ends = [&self.ends[0][i], &self.ends[1][k]];
                let [up, down] = ends.map(|end| &self.trails[end.trail.clone()]);
                let common = self.common(ends);
                // With a common face it is told once, by the first path.
                faces.extend(&up[..(up.len() + 1 - common).min(up.len())]);
                if common == 0 {
                    junctions.reduced_corridor(ends[0].reduced_corridor).tell(
                        junctions.row(),
                        ends.map(|end| end.spot),
                        &mut faces,
                    );
                }
                faces.extend(down[..down.len() - common].iter().rev());
            }
        }
        self.faces = faces;
    }

    /// The faces from a junction back to the end it was reached from, without its own.
    fn tell_back(&self, junctions: &Junctions, which: usize, mut junction: u32, faces: &mut Vec<u32>) {
        loop {
            let by = self.seen[junction as usize][which].by;
            if by & FROM_END != 0 {
                let end = &self.ends[which][(by & !FROM_END) as usize >> 2];
                let trail = &self.trails[end.trail.clone()];
                if by & 3 != AT_JUNCTION {
                    let CorridorRecord { first, end: behind, .. } = junctions.reduced_corridor(end.reduced_corridor);
                    let row = |from: u32, to: u32| &junctions.row()[from as usize..to as usize];
                    if by & 3 == 1 {
                        faces.extend(row(first, end.spot + 1));
                    } else {
                        faces.extend(row(end.spot, behind).iter().rev());
                    }
                }
                faces.extend(trail[..trail.len() - 1].iter().rev());
                return;
            }
            let reduced_corridor = junctions.reduced_corridor(by >> 1);
            let row = &junctions.row()[reduced_corridor.range()];
            if by & 1 == 0 {
                faces.extend(row.iter().rev());
            } else {
                faces.extend(row);
            }
            junction = reduced_corridor.ends[(by & 1) as usize];
            faces.push(junctions.face(junction));
        }
    }
}

impl CorridorRecord {
    /// The number of portals from one place in it to another without leaving it, and whether the shorter row runs
    /// forward.
    fn portals_between(&self, from: u32, to: u32) -> (u32, bool) {
        let straight = from.abs_diff(to);
        let round = self.end - self.first - straight;
        if self.ends[0] == NONE && round < straight { (round, to < from) } else { (straight, from < to) }
    }

    /// The faces strictly between two places, along the shorter row.
    fn tell(&self, row: &[u32], [from, to]: [u32; 2], faces: &mut Vec<u32>) {
        let (portals, forward) = self.portals_between(from, to);
        let len = self.end - self.first;
        let step = if forward { 1 } else { len - 1 };
        let steps = (1..portals).map(|i| u64::from(from - self.first) + u64::from(i) * u64::from(step));
        faces.extend(steps.map(|place| row[(u64::from(self.first) + place % u64::from(len)) as usize]));
    }
}

/// The row of the fewest faces. Returns whether there is one. No start may be a goal.
pub(super) fn fewest_faces(
    mesh: &NavMesh,
    junctions: &Junctions,
    reduced_bfs: &mut ReducedBfs,
    scratch: &mut Scratch,
) -> bool {
    reduced_bfs.begin(mesh, junctions, scratch);
    for i in 0..reduced_bfs.ends[0].len() {
        for k in 0..reduced_bfs.ends[1].len() {
            if let Some(portals) =
                reduced_bfs.portals_between(junctions, [&reduced_bfs.ends[0][i], &reduced_bfs.ends[1][k]])
            {
                reduced_bfs.improve(portals, Meeting::Direct([i, k]));
            }
        }
    }
    for which in [0, 1] {
        (0..reduced_bfs.ends[which].len()).for_each(|i| reduced_bfs.set_out(junctions, which, i));
    }
    reduced_bfs.search(junctions);
    let best = reduced_bfs.best;
    if let Some((_, meeting)) = best {
        reduced_bfs.tell(junctions, meeting);
        scratch.portals.extend(reduced_bfs.faces.windows(2).rev().map(|pair| mesh.portal_to(pair[0], pair[1])));
    }
    let pushes = reduced_bfs.queues.iter().map(|queue| queue.items.len() as u64).sum();
    scratch.work = Work { pops: reduced_bfs.settled, pushes, expansions: reduced_bfs.settled };
    best.is_some()
}
