//! The fewest faces, from crossing to crossing.
//!
//! ```text
//!    s · · X · · · X · · X · g     From the start to the crossings at the ends of its passage; from there by whole
//!          │       │     │         passages, the nearest crossing first; and so from the goal backwards. Distances
//!          · · · · X · · ·         are numbers of doors: a list for each number is all the queue it takes.
//! ```
//!
//! Two searches, one from the start, one from the goal. Once what is left of the one is at least a doors away, what is
//! left of the other at least b, and a row of at most a + b doors is known, there is none with fewer: a shorter one
//! would have a crossing that both have settled. Start and goal in one passage, or before one door path, are looked at
//! apart, as there need not be any crossing between them.

use super::crossings::{CROSSING, Crossings, Link, PassageRecord};
use super::marks::NONE;
use super::scratch::Scratch;
use super::{NavMesh, Work};
use crate::ids::FaceId;
use std::ops::Range;

/// In `by`: reached from an end; the rest is four times its number, and how.
const FROM_END: u32 = 1 << 31;
/// How: the end leads to the crossing itself, or stands before the first or the second end of a passage.
pub(super) const AT_CROSSING: u32 = 0;

/// What a search knows of a crossing.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// In which query it was reached.
    query: u32,
    /// The number of doors to it.
    doors: u32,
    /// The link by which it was reached, or [`FROM_END`].
    by: u32,
}

/// One of the faces at which the way starts, or ends.
#[derive(Clone, Debug)]
pub(super) struct End {
    /// Its door path in `trails`, up to the first face that is no dead end.
    trail: Range<usize>,
    /// Where that face is.
    pub(super) spot: u32,
    /// The passage, if it is in one.
    pub(super) passage: u32,
}

/// How the start and the goal are joined.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meeting {
    At(u32),
    /// Without a crossing, from one of the starts to one of the goals.
    Direct([usize; 2]),
}

/// A list of crossings for each number of doors.
#[derive(Clone, Debug, Default)]
struct Queue {
    /// The first of each list, in `items`. There are as many lists as any query took.
    heads: Vec<u32>,
    /// A crossing, the next item of its list, and which list that is.
    items: Vec<(u32, u32, u32)>,
    /// No list before this one has any items.
    least: usize,
    /// How many items there are in all lists.
    len: usize,
}

impl Queue {
    fn clear(&mut self) {
        self.items.drain(..).for_each(|(_, _, doors)| self.heads[doors as usize] = NONE);
        (self.least, self.len) = (0, 0);
    }

    #[inline]
    fn push(&mut self, doors: u32, crossing: u32) {
        if self.heads.len() <= doors as usize {
            self.heads.resize(doors as usize + 1, NONE);
        }
        let head = &mut self.heads[doors as usize];
        self.items.push((crossing, *head, doors));
        *head = self.items.len() as u32 - 1;
        self.len += 1;
    }

    /// Takes an item of the list that [`least`](Self::least) has named, if there is one left.
    #[inline]
    fn pop(&mut self) -> Option<u32> {
        let head = &mut self.heads[self.least];
        let &(crossing, next, _) = self.items.get(*head as usize)?;
        *head = next;
        self.len -= 1;
        Some(crossing)
    }

    /// The number of doors of the first list that has any items.
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
pub(super) struct Jumps {
    query: u32,
    /// For each crossing what the search from the start knows of it, and the one from the goal.
    seen: Vec<[Seen; 2]>,
    queues: [Queue; 2],
    ends: [Vec<End>; 2],
    /// The door paths of all ends.
    trails: Vec<u32>,
    /// The fewest doors that are known, and how.
    best: Option<(u32, Meeting)>,
    settled: u64,
    /// The faces of the way.
    faces: Vec<u32>,
}

/// What is noted of a crossing that was reached from end `i`: see [`AT_CROSSING`].
pub(super) fn from_end(i: usize, how: u32) -> u32 {
    FROM_END | (i as u32) << 2 | how
}

impl Jumps {
    /// Begins a query: takes in the faces at which the way starts (0) or ends (1).
    pub(super) fn begin(&mut self, mesh: &NavMesh, crossings: &Crossings, scratch: &Scratch) {
        let query = scratch.query;
        if query == 1 {
            self.seen.clear();
        }
        self.seen.resize(crossings.len().max(self.seen.len()), Default::default());
        self.query = query;
        self.queues.iter_mut().for_each(Queue::clear);
        self.ends.iter_mut().for_each(Vec::clear);
        self.trails.clear();
        self.best = None;
        self.settled = 0;
        for (which, faces) in [&scratch.starts, &scratch.goals].into_iter().enumerate() {
            faces.iter().for_each(|&f| self.add_end(mesh, crossings, which, f));
        }
    }

    fn add_end(&mut self, mesh: &NavMesh, crossings: &Crossings, which: usize, f: FaceId) {
        let first = self.trails.len();
        self.trails.extend(mesh.door_path(f).map(FaceId::number));
        let spot = crossings.spot(self.trails[self.trails.len() - 1]);
        let passage = if spot & CROSSING == 0 { crossings.passage_at(spot) } else { NONE };
        self.ends[which].push(End { trail: first..self.trails.len(), spot, passage });
    }

    /// The faces at which the way starts, or ends.
    pub(super) fn ends(&self, which: usize) -> &[End] {
        &self.ends[which]
    }

    /// The door path of one of them.
    pub(super) fn trail(&self, end: &End) -> &[u32] {
        &self.trails[end.trail.clone()]
    }

    /// The faces of the way that was told last.
    pub(super) fn faces(&self) -> &[u32] {
        &self.faces
    }

    /// Reaches the crossings next to an end.
    fn set_out(&mut self, crossings: &Crossings, which: usize, i: usize) {
        let End { ref trail, spot, passage } = self.ends[which][i];
        let depth = trail.len() as u32 - 1;
        if passage == NONE {
            self.reach(which, spot & !CROSSING, depth, from_end(i, AT_CROSSING));
            return;
        }
        let PassageRecord { ends, first, end } = crossings.passage(passage);
        for (how, crossing, doors) in [(1, ends[0], spot - first + 1), (2, ends[1], end - spot)] {
            if crossing != NONE {
                self.reach(which, crossing, depth + doors, from_end(i, how));
            }
        }
    }

    /// Reaches a crossing, unless it was reached through no more doors before, or a row with no more is known.
    #[inline]
    fn reach(&mut self, which: usize, crossing: u32, doors: u32, by: u32) {
        if self.best.is_some_and(|(least, _)| least <= doors) {
            return;
        }
        let query = self.query;
        let seen = &mut self.seen[crossing as usize];
        if seen[which].query == query && seen[which].doors <= doors {
            return;
        }
        seen[which] = Seen { query, doors, by };
        let other = seen[1 - which];
        self.queues[which].push(doors, crossing);
        if other.query == query {
            self.improve(doors + other.doors, Meeting::At(crossing));
        }
    }

    fn improve(&mut self, doors: u32, meeting: Meeting) {
        if self.best.is_none_or(|(least, _)| doors < least) {
            self.best = Some((doors, meeting));
        }
    }

    /// Lets both searches go on until nothing better can come.
    fn search(&mut self, crossings: &Crossings) {
        while let [Some(a), Some(b)] = self.queues.each_mut().map(Queue::least) {
            if self.best.is_some_and(|(doors, _)| doors <= a + b) {
                break;
            }
            let which = usize::from(self.queues[1].len < self.queues[0].len);
            let doors = [a, b][which];
            while let Some(crossing) = self.queues[which].pop() {
                // One that was reached through fewer doors since has been settled already.
                if self.seen[crossing as usize][which].doors == doors {
                    self.settled += 1;
                    for &Link { to, doors: more, by } in crossings.links(crossing) {
                        self.reach(which, to, doors + more, by);
                    }
                }
            }
        }
    }

    /// The number of doors from a start to a goal if there need not be a crossing between them.
    pub(super) fn doors_between(&self, crossings: &Crossings, [a, b]: [&End; 2]) -> Option<u32> {
        let [up, down] = [a, b].map(|end| end.trail.len());
        let common = self.common([a, b]);
        if common > 0 {
            return Some((up - common + down - common) as u32);
        }
        let along = if a.passage != NONE && a.passage == b.passage {
            crossings.passage(a.passage).doors_between(a.spot, b.spot).0
        } else {
            return None;
        };
        Some((up - 1 + down - 1) as u32 + along)
    }

    /// How many faces the door paths of two ends have in common: the last ones.
    fn common(&self, [a, b]: [&End; 2]) -> usize {
        let [a, b] = [a, b].map(|end| self.trails[end.trail.clone()].iter().rev());
        a.zip(b).take_while(|(f, g)| f == g).count()
    }

    /// Notes by which link, or from which end, a crossing was reached.
    pub(super) fn note(&mut self, which: usize, crossing: u32, by: u32) {
        self.seen[crossing as usize][which] = Seen { query: self.query, doors: 0, by };
    }

    /// Whether who goes into a passage from the crossing at its first (1) or second (2) end goes back on the way by which
    /// the search from the start came to that crossing.
    pub(super) fn is_back(&self, crossing: u32, passage: u32, end: u32) -> bool {
        let by = self.seen[crossing as usize][0].by;
        if by & FROM_END == 0 {
            by >> 1 == passage
        } else {
            by & 3 == end && self.ends[0][(by & !FROM_END) as usize >> 2].passage == passage
        }
    }

    /// Writes the faces of a way down, from the start to the goal.
    pub(super) fn tell(&mut self, crossings: &Crossings, meeting: Meeting) {
        let mut faces = std::mem::take(&mut self.faces);
        faces.clear();
        match meeting {
            Meeting::At(crossing) => {
                self.tell_back(crossings, 0, crossing, &mut faces);
                faces.reverse();
                faces.push(crossings.face(crossing));
                self.tell_back(crossings, 1, crossing, &mut faces);
            }
            Meeting::Direct([i, k]) => {
                let ends = [&self.ends[0][i], &self.ends[1][k]];
                let [up, down] = ends.map(|end| &self.trails[end.trail.clone()]);
                let common = self.common(ends);
                // With a common face it is told once, by the first path.
                faces.extend(&up[..(up.len() + 1 - common).min(up.len())]);
                if common == 0 {
                    crossings.passage(ends[0].passage).tell(crossings.row(), ends.map(|end| end.spot), &mut faces);
                }
                faces.extend(down[..down.len() - common].iter().rev());
            }
        }
        self.faces = faces;
    }

    /// The faces from a crossing back to the end it was reached from, without its own.
    fn tell_back(&self, crossings: &Crossings, which: usize, mut crossing: u32, faces: &mut Vec<u32>) {
        loop {
            let by = self.seen[crossing as usize][which].by;
            if by & FROM_END != 0 {
                let end = &self.ends[which][(by & !FROM_END) as usize >> 2];
                let trail = &self.trails[end.trail.clone()];
                if by & 3 != AT_CROSSING {
                    let PassageRecord { first, end: behind, .. } = crossings.passage(end.passage);
                    let row = |from: u32, to: u32| &crossings.row()[from as usize..to as usize];
                    if by & 3 == 1 {
                        faces.extend(row(first, end.spot + 1));
                    } else {
                        faces.extend(row(end.spot, behind).iter().rev());
                    }
                }
                faces.extend(trail[..trail.len() - 1].iter().rev());
                return;
            }
            let passage = crossings.passage(by >> 1);
            let row = &crossings.row()[passage.range()];
            if by & 1 == 0 {
                faces.extend(row.iter().rev());
            } else {
                faces.extend(row);
            }
            crossing = passage.ends[(by & 1) as usize];
            faces.push(crossings.face(crossing));
        }
    }
}

impl PassageRecord {
    /// The number of doors from one place in it to another without leaving it, and whether the shorter row runs
    /// forward.
    fn doors_between(&self, from: u32, to: u32) -> (u32, bool) {
        let straight = from.abs_diff(to);
        let round = self.end - self.first - straight;
        if self.ends[0] == NONE && round < straight { (round, to < from) } else { (straight, from < to) }
    }

    /// The faces strictly between two places, along the shorter row.
    fn tell(&self, row: &[u32], [from, to]: [u32; 2], faces: &mut Vec<u32>) {
        let (doors, forward) = self.doors_between(from, to);
        let len = self.end - self.first;
        let step = if forward { 1 } else { len - 1 };
        let steps = (1..doors).map(|i| u64::from(from - self.first) + u64::from(i) * u64::from(step));
        faces.extend(steps.map(|place| row[(u64::from(self.first) + place % u64::from(len)) as usize]));
    }
}

/// The row of the fewest faces. Returns whether there is one. No start may be a goal.
pub(super) fn fewest_faces(mesh: &NavMesh, crossings: &Crossings, jumps: &mut Jumps, scratch: &mut Scratch) -> bool {
    jumps.begin(mesh, crossings, scratch);
    for i in 0..jumps.ends[0].len() {
        for k in 0..jumps.ends[1].len() {
            if let Some(doors) = jumps.doors_between(crossings, [&jumps.ends[0][i], &jumps.ends[1][k]]) {
                jumps.improve(doors, Meeting::Direct([i, k]));
            }
        }
    }
    for which in [0, 1] {
        (0..jumps.ends[which].len()).for_each(|i| jumps.set_out(crossings, which, i));
    }
    jumps.search(crossings);
    let best = jumps.best;
    if let Some((_, meeting)) = best {
        jumps.tell(crossings, meeting);
        scratch.doors.extend(jumps.faces.windows(2).rev().map(|pair| mesh.door_to(pair[0], pair[1])));
    }
    let pushes = jumps.queues.iter().map(|queue| queue.items.len() as u64).sum();
    scratch.work = Work { pops: jumps.settled, pushes, expansions: jumps.settled };
    best.is_some()
}
