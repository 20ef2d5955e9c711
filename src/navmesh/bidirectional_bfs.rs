//! Breadth first, from both ends.
//!
//! ```text
//!   ┌───┬───┬───┬───┬───┬───┬───┐     Two searches, one from the start, one from the goal; the one with the shorter
//!   │ s │ 1 │ 2 │ 3 │ 2 │ 1 │ g │     front goes on, by one whole step. When a face of the one is beside a face of
//!   └───┴───┴───┴───┴───┴───┴───┘     the other for the first time, the row through both has the fewest faces.
//! ```
//!
//! Why the first meeting is the best: after i steps of one search and k of the other, all faces with a row of i portals to
//! the start and all with one of k to the goal have been reached. Had there been a row of at most i + k portals in all,
//! the searches would have met before. So there is none, and the one that is found has i + k + 1.
//!
//! Which search has reached a face is said by two bits, so that all of them stay in the nearest memory; whence, by the
//! search itself, which is written down once, from front to back. Afterwards the bits are cleared along the searches.
//! The neighbours of some faces are gathered before any of them is looked at: so the processor waits for the memory
//! once for all of them, and not at every branch.

use super::marks::{ID, NONE};
use super::scratch::Scratch;
use super::{NavMesh, Work};
use crate::ids::FaceId;
use std::ops::Range;

/// The faces that a search has reached, in order, each with the place of the one before it, or `NONE`.
type Frontier = Vec<(u32, u32)>;

/// Of how many faces the neighbours are gathered at a time.
const AT_A_TIME: usize = 32;

/// The memory of the search.
#[derive(Clone, Debug, Default)]
pub(super) struct BidirectionalBfs {
    /// For each face two bits: reached from the start, from the goal.
    marks: Vec<u64>,
    bidirectional_bfs: [Frontier; 2],
    /// Where the front of each search begins.
    fronts: [usize; 2],
    /// What lies across the sides of some faces of a front, each with the place of its face.
    gathered: Vec<(u32, u32)>,
    /// The sides of these faces.
    ranges: Vec<Range<usize>>,
}

impl BidirectionalBfs {
    #[inline]
    fn reach(&mut self, which: usize, f: u32, from: u32) {
        self.marks[f as usize / 32] |= 1 << (f % 32 * 2 + which as u32);
        self.bidirectional_bfs[which].push((f, from));
    }

    fn begin(&mut self, mesh: &NavMesh, starts: &[FaceId], goals: &[FaceId]) {
        self.marks.resize((mesh.face_bound() / 32 + 1).max(self.marks.len()), 0);
        self.fronts = [0, 0];
        for (which, faces) in [starts, goals].into_iter().enumerate() {
            self.bidirectional_bfs[which].clear();
            faces.iter().for_each(|f| self.reach(which, f.number(), NONE));
        }
    }

    /// Lets the search with the shorter front take a step. Returns how they met: the place of a face in this search, and
    /// the face of the other beside it.
    fn step(&mut self, mesh: &NavMesh, scratch: &Scratch, which: usize) -> Option<(usize, u32)> {
        let end = self.bidirectional_bfs[which].len();
        while self.fronts[which] < end {
            let some = self.fronts[which]..end.min(self.fronts[which] + AT_A_TIME);
            self.fronts[which] = some.end;
            self.gathered.clear();
            let faces = &self.bidirectional_bfs[which][some.clone()];
            self.ranges.clear();
            self.ranges.extend(faces.iter().map(|&(f, _)| mesh.range(FaceId::new(f))));
            for (i, range) in some.zip(&self.ranges) {
                self.gathered.extend(mesh.sides[range.clone()].iter().map(|side| (i as u32, side.across)));
            }
            let met = self.look_at_gathered(scratch, which);
            if met.is_some() {
                return met;
            }
        }
        None
    }

    /// Reaches the gathered faces that are new, or finds one of the other search. What is new and what is not is written
    /// down without a branch, as no processor could guess it.
    fn look_at_gathered(&mut self, scratch: &Scratch, which: usize) -> Option<(usize, u32)> {
        let frontier = &mut self.bidirectional_bfs[which];
        let mut len = frontier.len();
        frontier.resize(len + self.gathered.len(), (0, NONE));
        let mut met = None;
        for &(i, across) in &self.gathered {
            let f = across & ID;
            let (word, shift) = (&mut self.marks[f as usize / 32], f % 32 * 2);
            let open = u64::from(scratch.may_cross(across));
            let marks = *word >> shift & 3;
            let new = open & u64::from(marks == 0);
            *word |= new << (shift + which as u32);
            frontier[len] = (f, i);
            len += new as usize;
            if open & marks >> (1 - which) != 0 {
                met = Some((i as usize, f));
                break;
            }
        }
        frontier.truncate(len);
        met
    }

    /// The two faces at which the searches met, by their places.
    fn meet(&mut self, mesh: &NavMesh, scratch: &Scratch) -> Option<[usize; 2]> {
        loop {
            let [a, b] = [0, 1].map(|which| self.bidirectional_bfs[which].len() - self.fronts[which]);
            if a == 0 || b == 0 {
                return None;
            }
            let which = usize::from(b < a);
            if let Some((here, beside)) = self.step(mesh, scratch, which) {
                let there = self.bidirectional_bfs[1 - which].iter().rposition(|&(f, _)| f == beside)?;
                return Some(if which == 0 { [here, there] } else { [there, here] });
            }
        }
    }

    /// The faces of a search from the one at a place back to its first.
    fn back(&self, which: usize, at: usize) -> impl Iterator<Item = u32> + '_ {
        let frontier = &self.bidirectional_bfs[which];
        std::iter::successors(Some(frontier[at]), |&(_, from)| frontier.get(from as usize).copied()).map(|(f, _)| f)
    }
}

/// The row of the fewest faces. Returns whether there is one. No start may be a goal.
pub(super) fn breadth_first(mesh: &NavMesh, bidirectional_bfs: &mut BidirectionalBfs, scratch: &mut Scratch) -> bool {
    bidirectional_bfs.begin(mesh, &scratch.starts, &scratch.goals);
    let met = bidirectional_bfs.meet(mesh, scratch);
    if let Some([here, there]) = met {
        scratch.portals.extend(
            bidirectional_bfs
                .back(1, there)
                .zip(bidirectional_bfs.back(1, there).skip(1))
                .map(|(from, to)| mesh.portal_to(from, to)),
        );
        scratch.portals.reverse();
        let onwards =
            std::iter::once(bidirectional_bfs.bidirectional_bfs[1][there].0).chain(bidirectional_bfs.back(0, here));
        scratch.portals.extend(bidirectional_bfs.back(0, here).zip(onwards).map(|(from, to)| mesh.portal_to(from, to)));
    }
    let looked_at = bidirectional_bfs.fronts.iter().sum::<usize>() as u64;
    let reached = bidirectional_bfs.bidirectional_bfs.iter().map(|frontier| frontier.len() as u64).sum();
    scratch.work = Work { pops: looked_at, pushes: reached, expansions: looked_at };
    for &(f, _) in bidirectional_bfs.bidirectional_bfs.iter().flatten() {
        bidirectional_bfs.marks[f as usize / 32] = 0;
    }
    met.is_some()
}
