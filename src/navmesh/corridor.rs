//! Corridors: rows of faces from start to goal, found by simple rules.
//!
//! ```text
//!   breadth       the fewest faces
//!   centroid      ·───·───·      A*: the length of the line through the centroids (the means of the corners)
//!   midpoint      ·─|─·─|─·      ... through the midpoints of the doors
//!   closest       ·|·|·          ... from where one is to the closest point on the next door
//! ```
//!
//! None of them is the shortest way: how good a corridor is shows only when it is pulled straight. That is why
//! people complain of detours, and what the exact search is for.
//!
//! A* looks at a face again if it is reached by a shorter line. Its guess, the distance to the goal as the crow
//! flies, is never too long for these lines, or by little where faces cost less than 1.

use super::mesh::{CLOSED, ID, NONE};
use super::nearest::{closest_on, distance};
use super::planner::Scratch;
use super::{NavMesh, Rung, Work};
use crate::ids::{FaceId, FaceMap};
use crate::plane::Point;
use std::cmp::Reverse;

/// What a search knows about a face.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reached {
    /// In which query it was reached.
    query: u32,
    /// From which face, by which side of it; `NONE` for a start.
    from: u32,
    side: u32,
    /// Whether it was taken from the queue with this length.
    done: bool,
    /// The length of the line so far.
    length: f64,
    /// Where the line ends.
    at: Point,
}

/// The row of the fewest faces. Returns whether there is one.
pub(super) fn breadth_first(mesh: &NavMesh, scratch: &mut Scratch) -> bool {
    scratch.seen.resize(mesh.face_bound().max(scratch.seen.len()), (0, NONE));
    let query = scratch.query;
    let mut line = std::mem::take(&mut scratch.line);
    line.clear();
    line.extend(scratch.starts.iter().map(|f| f.number()));
    line.iter().for_each(|&f| scratch.seen[f as usize] = (query, NONE));
    let mut head = 0;
    let mut found = None;
    'search: while let Some(&f) = line.get(head) {
        head += 1;
        for side in mesh.sides_of(FaceId::new(f)) {
            let next = side.across & ID;
            if !scratch.may_cross(side.across) || scratch.seen[next as usize].0 == query {
                continue;
            }
            scratch.seen[next as usize] = (query, f);
            line.push(next);
            if scratch.goals.contains(&FaceId::new(next)) {
                found = Some(next);
                break 'search;
            }
        }
    }
    scratch.work = Work { pops: head as u64, pushes: line.len() as u64, expansions: head as u64 };
    scratch.line = line;
    let mut at = found.unwrap_or(NONE);
    while at != NONE {
        let from = scratch.seen[at as usize].1;
        let is_door = |&s: &usize| mesh.sides[s].across & (CLOSED | ID) == at;
        if from != NONE
            && let Some(side) = mesh.range(FaceId::new(from)).find(is_door)
        {
            scratch.doors.push((from, side as u32));
        }
        at = from;
    }
    found.is_some()
}

/// A row of faces with a short line of the given kind, through sides that fit. Returns whether there is one.
pub(super) fn a_star(
    mesh: &NavMesh,
    scratch: &mut Scratch,
    metric: Rung,
    costs: Option<&FaceMap<f64>>,
    fits: impl Fn(FaceId, usize) -> bool,
    [start, goal]: [Point; 2],
) -> bool {
    scratch.reached.resize(mesh.face_bound().max(scratch.reached.len()), Reached::default());
    let query = scratch.query;
    for i in 0..scratch.starts.len() {
        let f = scratch.starts[i];
        scratch.reached[f.index()] = Reached { query, from: NONE, at: start, ..Reached::default() };
        scratch.push(distance(start, goal), f.number());
    }
    while let Some(Reverse((_, f))) = scratch.queue.pop() {
        scratch.work.pops += 1;
        let here = scratch.reached[f as usize];
        if here.done {
            continue;
        }
        scratch.reached[f as usize].done = true;
        let face = FaceId::new(f);
        if scratch.goals.contains(&face) {
            scratch.trace(f);
            return true;
        }
        scratch.work.expansions += 1;
        let cost = costs.map_or(1.0, |costs| costs[face].max(0.0));
        let range = mesh.range(face);
        for s in range.clone() {
            let across = mesh.sides[s].across;
            let next = across & ID;
            if next == here.from || !scratch.may_cross(across) || !fits(face, s) {
                continue;
            }
            let post = |s: usize| mesh.points[(mesh.sides[s].origin & ID) as usize];
            let posts = [post(s), post(if s + 1 == range.end { range.start } else { s + 1 })];
            let at = match metric {
                Rung::Centroid => mesh.centroid(FaceId::new(next)),
                Rung::Midpoint => Point::new((posts[0].x + posts[1].x) / 2.0, (posts[0].y + posts[1].y) / 2.0),
                _ => closest_on(posts, here.at),
            };
            let length = here.length + cost * distance(here.at, at);
            let reached = &mut scratch.reached[next as usize];
            if reached.query == query && reached.length <= length {
                continue;
            }
            *reached = Reached { query, from: f, side: s as u32, done: false, length, at };
            scratch.push(length + distance(at, goal), next);
        }
    }
    false
}

impl Scratch {
    pub(super) fn push(&mut self, key: f64, item: u32) {
        self.work.pushes += 1;
        self.queue.push(Reverse((key.to_bits(), item)));
    }

    /// Writes down the doors that led to `f`, from the last to the first.
    fn trace(&mut self, f: u32) {
        let mut at = self.reached[f as usize];
        while at.from != NONE {
            self.doors.push((at.from, at.side));
            at = self.reached[at.from as usize];
        }
    }
}
