//! A* from crossing to crossing.
//!
//! ```text
//!   X ─┄ · ─┄ · ─┄ · ─┄ X      The line of a metric is drawn through the first door of a passage, and, if its guess is
//!                              the least, through all others: what is known of a face is kept for crossings only.
//! ```
//!
//! The lines are those of `corridor.rs`, and so are the guesses. Start and goal stand somewhere in passages, or in dead
//! ends beside them: from the start lines run to the crossings at the ends of its passage, and whoever gets to a
//! crossing at the goal's passage also draws a line to the goal. The first of these to be taken from the queue wins.

use super::corridor::point_of_line;
use super::crossings::{CROSSING, Crossings, Link, PassageRecord};
use super::jumps::{AT_CROSSING, End, Jumps, Meeting, from_end};
use super::marks::NONE;
use super::nearest::distance;
use super::scratch::Scratch;
use super::{NavMesh, Rung, Work};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;
use std::cmp::Reverse;

/// In the queue: the number of a stride, not of a crossing.
const STRIDE: u32 = 1 << 31;

/// What the search knows of a crossing.
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
pub(super) struct Strides {
    marks: Vec<Mark>,
    strides: Vec<Stride>,
}

/// What may be done next, apart from looking round at a crossing.
#[derive(Clone, Copy, Debug)]
enum Stride {
    /// Draw a line on through a passage, to the crossing at one of its ends.
    On { line: Line, passage: u32, from: u32, to: u32, crossing: u32, by: u32 },
    /// Arrived at a goal from a crossing: its number, and how; see `by` in `jumps.rs`.
    From { crossing: u32, goal: usize, how: u32 },
    /// Arrived without a crossing, from one of the starts at one of the goals.
    Direct([usize; 2]),
}

/// What all lines have in common.
struct Drawing<'a> {
    mesh: &'a NavMesh,
    crossings: &'a Crossings,
    metric: Rung,
    goal: Point,
}

impl Drawing<'_> {
    /// Draws a line on through a door into a face.
    #[inline]
    fn through(&self, line: Line, posts: [Point; 2], next: impl FnOnce() -> u32) -> Line {
        let at = point_of_line(self.mesh, self.metric, self.goal, posts, line.at, || FaceId::new(next()));
        Line { at, length: line.length + distance(line.at, at) }
    }

    /// Draws a line on from face to face.
    fn along<'b>(&self, mut line: Line, faces: impl Iterator<Item = &'b u32>) -> Line {
        let mut before = None;
        for &f in faces {
            if let Some(before) = before.replace(f) {
                let (from, side) = self.mesh.door_to(before, f);
                let posts = self.mesh.ends(FaceId::new(from), side as usize).map(|v| self.mesh.point(v));
                line = self.through(line, posts, || f);
            }
        }
        line
    }

    /// Draws a line on through a passage, from one place in it to another: 0 is the crossing before the first face, 1
    /// the first face, and so on up to the crossing behind the last.
    fn run(&self, mut line: Line, passage: u32, from: u32, to: u32) -> Line {
        let posts = |[right, left]: [u32; 2]| [right, left].map(|v| self.mesh.point(VertexId::new(v)));
        let face = |place: u32| self.crossings.face_at(passage, place);
        let doors = self.crossings.doors(passage);
        if from < to {
            for (i, &door) in (from..to).zip(&doors[from as usize..to as usize]) {
                line = self.through(line, posts(door), || face(i + 1));
            }
        } else {
            for (i, &[right, left]) in (to..from).zip(&doors[to as usize..from as usize]).rev() {
                line = self.through(line, posts([left, right]), || face(i));
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
/// crossing to go by. No start may be a goal.
pub(super) fn a_star(
    mesh: &NavMesh,
    crossings: &Crossings,
    (strides, jumps): (&mut Strides, &mut Jumps),
    scratch: &mut Scratch,
    metric: Rung,
    [start, goal]: [Point; 2],
) -> Option<bool> {
    let drawing = Drawing { mesh, crossings, metric, goal };
    jumps.begin(mesh, crossings, scratch);
    let goes_round = |end: &End| end.passage != NONE && crossings.passage(end.passage).ends[0] == NONE;
    let found =
        if jumps.ends(0).iter().any(goes_round) { None } else { Some(strides.search(&drawing, jumps, scratch, start)) };
    if found == Some(true) {
        scratch.doors.extend(jumps.faces().windows(2).rev().map(|pair| mesh.door_to(pair[0], pair[1])));
    }
    found
}

impl Strides {
    fn search(&mut self, drawing: &Drawing, jumps: &mut Jumps, scratch: &mut Scratch, start: Point) -> bool {
        if scratch.query == 1 {
            self.marks.clear();
        }
        self.marks.resize(drawing.crossings.len().max(self.marks.len()), Mark::default());
        self.strides.clear();
        scratch.work = Work::default();
        self.set_out(drawing, jumps, scratch, start);
        while let Some(Reverse((least, item))) = scratch.queue.pop() {
            scratch.work.pops += 1;
            if item & STRIDE != 0 {
                match self.strides[(item & !STRIDE) as usize] {
                    Stride::On { line, passage, from, to, crossing, by } => {
                        scratch.work.expansions += u64::from(from.abs_diff(to));
                        let line = drawing.run(line, passage, from, to);
                        self.reach(drawing, jumps, scratch, (crossing, by), line, least);
                        continue;
                    }
                    Stride::From { crossing, goal, how } => {
                        jumps.note(1, crossing, from_end(goal, how));
                        jumps.tell(drawing.crossings, Meeting::At(crossing));
                    }
                    Stride::Direct(pair) => jumps.tell(drawing.crossings, Meeting::Direct(pair)),
                }
                return true;
            }
            let mark = &mut self.marks[item as usize];
            if std::mem::replace(&mut mark.done, true) {
                continue;
            }
            let line = mark.line;
            self.go_on(drawing, jumps, scratch, item, line, least);
        }
        false
    }

    /// Draws the lines from the start.
    fn set_out(&mut self, drawing: &Drawing, jumps: &mut Jumps, scratch: &mut Scratch, start: Point) {
        let crossings = drawing.crossings;
        let line = Line { at: start, length: 0.0 };
        for i in 0..jumps.ends(0).len() {
            let end = &jumps.ends(0)[i];
            let line = drawing.along(line, jumps.trail(end).iter());
            let (spot, passage) = (end.spot, end.passage);
            if passage == NONE {
                self.reach(drawing, jumps, scratch, (spot & !CROSSING, from_end(i, AT_CROSSING)), line, 0);
                continue;
            }
            let (place, far) = places(crossings, end);
            let ends = crossings.passage(passage).ends;
            for (how, crossing, to) in [(1, ends[0], 0), (2, ends[1], far)] {
                let (first, by) = (if to < place { place - 1 } else { place + 1 }, from_end(i, how));
                let line = drawing.run(line, passage, place, first);
                self.wait(drawing, scratch, line, 0, Stride::On { line, passage, from: first, to, crossing, by });
            }
        }
        let [starts, goals] = [0, 1].map(|which| jumps.ends(which).len());
        for (i, k) in (0..starts).flat_map(|i| (0..goals).map(move |k| (i, k))) {
            if jumps.doors_between(crossings, [&jumps.ends(0)[i], &jumps.ends(1)[k]]).is_some() {
                jumps.tell(crossings, Meeting::Direct([i, k]));
                let line = drawing.along(line, jumps.faces().iter());
                self.wait(drawing, scratch, line, 0, Stride::Direct([i, k]));
            }
        }
    }

    /// Draws lines on from a crossing, through all passages there, and to goals before their next crossing. Where the
    /// line came from there is nothing new.
    fn go_on(
        &mut self,
        drawing: &Drawing,
        jumps: &mut Jumps,
        scratch: &mut Scratch,
        crossing: u32,
        line: Line,
        least: u64,
    ) {
        let crossings = drawing.crossings;
        for (k, end) in jumps.ends(1).iter().enumerate() {
            let mut arrive = |how: u32, line: Line| {
                let line = drawing.along(line, jumps.trail(end).iter().rev());
                self.wait(drawing, scratch, line, least, Stride::From { crossing, goal: k, how });
            };
            if end.passage == NONE {
                if end.spot == CROSSING | crossing {
                    arrive(AT_CROSSING, line);
                }
                continue;
            }
            let (place, far) = places(crossings, end);
            for (how, from) in [(1, 0), (2, far)] {
                let is_here = crossings.passage(end.passage).ends[how as usize - 1] == crossing;
                if is_here && !jumps.is_back(crossing, end.passage, how) {
                    arrive(how, drawing.run(line, end.passage, from, place));
                }
            }
        }
        for &Link { to: next, doors, by } in crossings.links(crossing) {
            let passage = by >> 1;
            if !jumps.is_back(crossing, passage, (by & 1) + 1) {
                let [at, first, to] = if by & 1 == 0 { [0, 1, doors] } else { [doors, doors - 1, 0] };
                let line = drawing.run(line, passage, at, first);
                let on = Stride::On { line, passage, from: first, to, crossing: next, by };
                self.wait(drawing, scratch, line, least, on);
            }
        }
    }

    /// Reaches a crossing by a link or from an end, unless it was reached with no worse a guess before.
    #[inline]
    fn reach(
        &mut self,
        drawing: &Drawing,
        jumps: &mut Jumps,
        scratch: &mut Scratch,
        (crossing, by): (u32, u32),
        line: Line,
        least: u64,
    ) {
        let key = drawing.key(&line, least);
        let mark = &mut self.marks[crossing as usize];
        if mark.query == scratch.query && (mark.key, mark.line.length) <= (key, line.length) {
            return;
        }
        *mark = Mark { query: scratch.query, done: false, key, line };
        jumps.note(0, crossing, by);
        scratch.work.pushes += 1;
        scratch.queue.push(Reverse((key, crossing)));
    }

    /// Puts a stride into the queue, with the guess for the line so far.
    #[inline]
    fn wait(&mut self, drawing: &Drawing, scratch: &mut Scratch, line: Line, least: u64, stride: Stride) {
        let item = STRIDE | self.strides.len() as u32;
        self.strides.push(stride);
        scratch.work.pushes += 1;
        scratch.queue.push(Reverse((drawing.key(&line, least), item)));
    }
}

/// The place of an end in its passage, and that of the crossing behind the last face.
fn places(crossings: &Crossings, end: &End) -> (u32, u32) {
    let PassageRecord { first, end: behind, .. } = crossings.passage(end.passage);
    (end.spot - first + 1, behind - first + 1)
}
