//! A* from junction to junction.
//!
//! ```text
//!   X ─┄ · ─┄ · ─┄ · ─┄ X      The line of a metric is drawn through the first portal of a reduced corridor, and, if its guess is
//!                              the least, through all others: what is known of a face is kept for junctions only.
//! ```
//!
//! The lines are those of `corridor.rs`, and so are the guesses. Start and goal stand somewhere in reduced corridors, or in dead
//! ends beside them: from the start lines run to the junctions at the ends of its reduced corridor, and whoever gets to a
//! junction at the goal's reduced corridor also draws a line to the goal. The first of these to be taken from the queue wins.

use super::corridor::point_of_line;
use super::junctions::{CROSSING, CorridorRecord, Junctions, Link};
use super::marks::NONE;
use super::nearest::distance;
use super::reduced_bfs::{AT_JUNCTION, End, Meeting, ReducedBfs, from_end};
use super::scratch::Scratch;
use super::{NavMesh, PathAlgorithm, Work};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;
use std::cmp::Reverse;

/// In the queue: the number of a step, not of a junction.
const STRIDE: u32 = 1 << 31;

/// What the search knows of a junction.
#[derive(Clone, Copy, Debug, Default)]
struct Mark {
    query: u32,
    /// Whether it was taken from the queue with this guess.
    done: bool,
    /// The guess, as the queue has it.
    key: u64,
    line: Line,
}

/// The end of a line, and its length.
#[derive(Clone, Copy, Debug, Default)]
struct Line {
    at: Point,
    length: f64,
}

/// The memory of the search.
#[derive(Clone, Debug, Default)]
pub(super) struct ReducedAStar {
    marks: Vec<Mark>,
    reduced_astar: Vec<ReducedStep>,
}

/// What may be done next, apart from looking round at a junction.
#[derive(Clone, Copy, Debug)]
enum ReducedStep {
    /// Draw a line on through a reduced corridor, to the junction at one of its ends.
    On { line: Line, reduced_corridor: u32, from: u32, to: u32, junction: u32, by: u32 },
    /// Arrived at a goal from a junction: its number, and how; see `by` in `reduced_bfs.rs`.
    From { junction: u32, goal: usize, how: u32 },
    /// Arrived without a junction, from one of the starts at one of the goals.
    Direct([usize; 2]),
}

/// What all lines have in common.
struct Drawing<'a> {
    mesh: &'a NavMesh,
    junctions: &'a Junctions,
    metric: PathAlgorithm,
    goal: Point,
}

impl Drawing<'_> {
    /// Draws a line on through a portal into a face.
    #[inline]
    fn through(&self, line: Line, endpoints: [Point; 2], next: impl FnOnce() -> u32) -> Line {
        let at = point_of_line(self.mesh, self.metric, self.goal, endpoints, line.at, || FaceId::new(next()));
        Line { at, length: line.length + distance(line.at, at) }
    }

    /// Draws a line on from face to face.
    fn along<'b>(&self, mut line: Line, faces: impl Iterator<Item = &'b u32>) -> Line {
        let mut before = None;
        for &f in faces {
            if let Some(before) = before.replace(f) {
                let (from, side) = self.mesh.portal_to(before, f);
                let endpoints = self.mesh.ends(FaceId::new(from), side as usize).map(|v| self.mesh.point(v));
                line = self.through(line, endpoints, || f);
            }
        }
        line
    }

    /// Draws a line on through a reduced corridor, from one place in it to another: 0 is the junction before the first face, 1
    /// the first face, and so on up to the junction behind the last.
    fn run(&self, mut line: Line, reduced_corridor: u32, from: u32, to: u32) -> Line {
        let endpoints = |[right, left]: [u32; 2]| [right, left].map(|v| self.mesh.point(VertexId::new(v)));
        let face = |place: u32| self.junctions.face_at(reduced_corridor, place);
        let portals = self.junctions.portals(reduced_corridor);
        if from < to {
            for (i, &portal) in (from..to).zip(&portals[from as usize..to as usize]) {
                line = self.through(line, endpoints(portal), || face(i + 1));
            }
        } else {
            for (i, &[right, left]) in (to..from).zip(&portals[to as usize..from as usize]).rev() {
                line = self.through(line, endpoints([left, right]), || face(i));
            }
        }
        line
    }

    /// The guess of the length of a line that goes on to the goal.
    fn key(&self, line: &Line, least: u64) -> u64 {
        (line.length + distance(line.at, self.goal)).to_bits().max(least)
    }
}

/// A row of faces with a short line of the given kind. Returns whether there is one; `None` if the component has no
/// junction to go by. No start may be a goal.
pub(super) fn a_star(
    mesh: &NavMesh,
    junctions: &Junctions,
    (reduced_astar, reduced_bfs): (&mut ReducedAStar, &mut ReducedBfs),
    scratch: &mut Scratch,
    metric: PathAlgorithm,
    [start, goal]: [Point; 2],
) -> Option<bool> {
    let drawing = Drawing { mesh, junctions, metric, goal };
    reduced_bfs.begin(mesh, junctions, scratch);
    let goes_round =
        |end: &End| end.reduced_corridor != NONE && junctions.reduced_corridor(end.reduced_corridor).ends[0] == NONE;
    let found = if reduced_bfs.ends(0).iter().any(goes_round) {
        None
    } else {
        Some(reduced_astar.search(&drawing, reduced_bfs, scratch, start))
    };
    if found == Some(true) {
        scratch.portals.extend(reduced_bfs.faces().windows(2).rev().map(|pair| mesh.portal_to(pair[0], pair[1])));
    }
    found
}

impl ReducedAStar {
    fn search(&mut self, drawing: &Drawing, reduced_bfs: &mut ReducedBfs, scratch: &mut Scratch, start: Point) -> bool {
        if scratch.query == 1 {
            self.marks.clear();
        }
        self.marks.resize(drawing.junctions.len().max(self.marks.len()), Mark::default());
        self.reduced_astar.clear();
        scratch.work = Work::default();
        self.set_out(drawing, reduced_bfs, scratch, start);
        while let Some(Reverse((least, item))) = scratch.queue.pop() {
            scratch.work.pops += 1;
            if item & STRIDE != 0 {
                match self.reduced_astar[(item & !STRIDE) as usize] {
                    ReducedStep::On { line, reduced_corridor, from, to, junction, by } => {
                        scratch.work.expansions += u64::from(from.abs_diff(to));
                        let line = drawing.run(line, reduced_corridor, from, to);
                        self.reach(drawing, reduced_bfs, scratch, (junction, by), line, least);
                        continue;
                    }
                    ReducedStep::From { junction, goal, how } => {
                        reduced_bfs.note(1, junction, from_end(goal, how));
                        reduced_bfs.tell(drawing.junctions, Meeting::At(junction));
                    }
                    ReducedStep::Direct(pair) => reduced_bfs.tell(drawing.junctions, Meeting::Direct(pair)),
                }
                return true;
            }
            let mark = &mut self.marks[item as usize];
            if std::mem::replace(&mut mark.done, true) {
                continue;
            }
            let line = mark.line;
            self.go_on(drawing, reduced_bfs, scratch, item, line, least);
        }
        false
    }

    /// Draws the lines from the start.
    fn set_out(&mut self, drawing: &Drawing, reduced_bfs: &mut ReducedBfs, scratch: &mut Scratch, start: Point) {
        let junctions = drawing.junctions;
        let line = Line { at: start, length: 0.0 };
        for i in 0..reduced_bfs.ends(0).len() {
            let end = &reduced_bfs.ends(0)[i];
            let line = drawing.along(line, reduced_bfs.trail(end).iter());
            let (spot, reduced_corridor) = (end.spot, end.reduced_corridor);
            if reduced_corridor == NONE {
                self.reach(drawing, reduced_bfs, scratch, (spot & !CROSSING, from_end(i, AT_JUNCTION)), line, 0);
                continue;
            }
            let (place, far) = places(junctions, end);
            let ends = junctions.reduced_corridor(reduced_corridor).ends;
            for (how, junction, to) in [(1, ends[0], 0), (2, ends[1], far)] {
                let (first, by) = (if to < place { place - 1 } else { place + 1 }, from_end(i, how));
                let line = drawing.run(line, reduced_corridor, place, first);
                self.wait(
                    drawing,
                    scratch,
                    line,
                    0,
                    ReducedStep::On { line, reduced_corridor, from: first, to, junction, by },
                );
            }
        }
        let [starts, goals] = [0, 1].map(|which| reduced_bfs.ends(which).len());
        for (i, k) in (0..starts).flat_map(|i| (0..goals).map(move |k| (i, k))) {
            if reduced_bfs.portals_between(junctions, [&reduced_bfs.ends(0)[i], &reduced_bfs.ends(1)[k]]).is_some() {
                reduced_bfs.tell(junctions, Meeting::Direct([i, k]));
                let line = drawing.along(line, reduced_bfs.faces().iter());
                self.wait(drawing, scratch, line, 0, ReducedStep::Direct([i, k]));
            }
        }
    }

    /// Draws lines on from a junction, through all reduced corridors there, and to goals before their next junction. Where the
    /// line came from there is nothing new.
    fn go_on(
        &mut self,
        drawing: &Drawing,
        reduced_bfs: &mut ReducedBfs,
        scratch: &mut Scratch,
        junction: u32,
        line: Line,
        least: u64,
    ) {
        let junctions = drawing.junctions;
        for (k, end) in reduced_bfs.ends(1).iter().enumerate() {
            let mut arrive = |how: u32, line: Line| {
                let line = drawing.along(line, reduced_bfs.trail(end).iter().rev());
                self.wait(drawing, scratch, line, least, ReducedStep::From { junction, goal: k, how });
            };
            if end.reduced_corridor == NONE {
                if end.spot == CROSSING | junction {
                    arrive(AT_JUNCTION, line);
                }
                continue;
            }
            let (place, far) = places(junctions, end);
            for (how, from) in [(1, 0), (2, far)] {
                let is_here = junctions.reduced_corridor(end.reduced_corridor).ends[how as usize - 1] == junction;
                if is_here && !reduced_bfs.is_back(junction, end.reduced_corridor, how) {
                    arrive(how, drawing.run(line, end.reduced_corridor, from, place));
                }
            }
        }
        for &Link { to: next, portals, by } in junctions.links(junction) {
            let reduced_corridor = by >> 1;
            if !reduced_bfs.is_back(junction, reduced_corridor, (by & 1) + 1) {
                let [at, first, to] = if by & 1 == 0 { [0, 1, portals] } else { [portals, portals - 1, 0] };
                let line = drawing.run(line, reduced_corridor, at, first);
                let on = ReducedStep::On { line, reduced_corridor, from: first, to, junction: next, by };
                self.wait(drawing, scratch, line, least, on);
            }
        }
    }

    /// Reaches a junction by a link or from an end, unless it was reached with no worse a guess before.
    #[inline]
    fn reach(
        &mut self,
        drawing: &Drawing,
        reduced_bfs: &mut ReducedBfs,
        scratch: &mut Scratch,
        (junction, by): (u32, u32),
        line: Line,
        least: u64,
    ) {
        let key = drawing.key(&line, least);
        let mark = &mut self.marks[junction as usize];
        if mark.query == scratch.query && (mark.key, mark.line.length) <= (key, line.length) {
            return;
        }
        *mark = Mark { query: scratch.query, done: false, key, line };
        reduced_bfs.note(0, junction, by);
        scratch.work.pushes += 1;
        scratch.queue.push(Reverse((key, junction)));
    }

    /// Puts a step into the queue, with the guess for the line so far.
    #[inline]
    fn wait(&mut self, drawing: &Drawing, scratch: &mut Scratch, line: Line, least: u64, reduced_step: ReducedStep) {
        let item = STRIDE | self.reduced_astar.len() as u32;
        self.reduced_astar.push(reduced_step);
        scratch.work.pushes += 1;
        scratch.queue.push(Reverse((drawing.key(&line, least), item)));
    }
}

/// The place of an end in its reduced corridor, and that of the junction behind the last face.
fn places(junctions: &Junctions, end: &End) -> (u32, u32) {
    let CorridorRecord { first, end: behind, .. } = junctions.reduced_corridor(end.reduced_corridor);
    (end.spot - first + 1, behind - first + 1)
}
