//! Corridors: rows of faces from start to goal, found by simple rules.
//!
//! ```text
//!   breadth       the fewest faces (`bidirectional_bfs.rs`)
//!   centroid      ·───·───·      A*: the length of the line through the centroids (the means of the corners)
//!   midpoint      ·─|─·─|─·      ... through the midpoints of the portals
//!   closest       ·|·|·          ... from where one is to the closest point on the next portal
//!   aimed         ·─|──|──·      ... to where the straight line to the goal meets the next portal, or its nearer end
//! ```
//!
//! None of them is the shortest path: how good a corridor is shows only when it is pulled straight. That is why
//! people complain of detours, and what the exact search is for.
//!
//! A* looks at a face again if it is reached with a better guess: the length of the line, and from its end to the goal
//! as the crow flies. (The length alone would not do: lines through different portals end at different points.) The
//! guess never falls from face to face, nor does the length, so that a face is never reached again from itself: there
//! is an end. In the open the aimed line is the straight one, and the guess is right: little else is looked at. Where
//! only one way leads on it is taken at once, up to the next face with a choice, whatever else waits in the queue.

use super::marks::{ID, NONE, SideRecord};
use super::nearest::{closest_on, distance};
use super::scratch::{Reached, Scratch};
use super::{NavMesh, PathAlgorithm};
use crate::ids::{FaceId, FaceMap};
use crate::plane::Point;
use std::cmp::Reverse;
use std::collections::binary_heap::PeekMut;

/// A row of faces with a short line of the given kind, through sides that fit. Returns whether there is one. With costs, rows
/// to further faces at the goal are kept beside it, as long as one of them may be cheaper by its line.
pub(super) fn a_star(
    mesh: &NavMesh,
    scratch: &mut Scratch,
    metric: PathAlgorithm,
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
    // The least that a line to the goal costs, and how many faces there were reached; without costs the first one is the best.
    let (mut best, mut reached_goals) = (f64::INFINITY, 0);
    // The best face that was reached last waits here: mostly it is the next one, and never gets into the queue.
    let mut hand: Option<(u64, u32)> = None;
    while let Some((mut least, mut f)) = scratch.next(&mut hand) {
        if f64::from_bits(least) > best {
            break;
        }
        scratch.work.pops += 1;
        let mut here = scratch.reached[f as usize];
        if here.done {
            continue;
        }
        scratch.reached[f as usize].done = true;
        if scratch.goals.contains(&FaceId::new(f)) {
            if reached_goals == 0 {
                let mut row = std::mem::take(&mut scratch.portals);
                scratch.trace(f, &mut row);
                scratch.portals = row;
            } else {
                let mut row = Vec::new();
                scratch.trace(f, &mut row);
                scratch.others.push(row);
            }
            reached_goals += 1;
            let Some(costs) = costs.filter(|_| reached_goals < scratch.goals.len()) else { return true };
            best = best.min(here.length + costs[FaceId::new(f)].max(0.0) * distance(here.at, goal));
        }
        // Where there is but one way on, it is taken at once.
        loop {
            scratch.work.expansions += 1;
            let face = FaceId::new(f);
            let cost = costs.map_or(1.0, |costs| costs[face].max(0.0));
            let range = mesh.faces[f as usize].range();
            let (first, sides) = (range.start, &mesh.sides[range]);
            // Without a branch: which sides lead on is not to be guessed.
            let leads_on = |scratch: &Scratch, k: usize, side: &SideRecord| {
                (side.across & ID != here.from) & scratch.may_cross(side.across) & fits(face, first + k)
            };
            let (mut ways, mut last) = (0, 0);
            for (k, side) in sides.iter().enumerate() {
                let on = leads_on(scratch, k, side);
                ways += usize::from(on);
                last = if on { k } else { last };
            }
            let mut only = None;
            for k in if ways > 1 { 0..sides.len() } else { last..last + ways } {
                let side = &sides[k];
                if ways > 1 && !leads_on(scratch, k, side) {
                    continue;
                }
                let next = side.across & ID;
                let endpoint = |side: &SideRecord| mesh.points[(side.origin & ID) as usize];
                let endpoints = [endpoint(side), endpoint(sides.get(k + 1).unwrap_or(&sides[0]))];
                let at = point_of_line(mesh, metric, goal, endpoints, here.at, || FaceId::new(next));
                let length = here.length + cost * distance(here.at, at);
                let key = (length + distance(at, goal)).to_bits().max(least);
                let reached = &mut scratch.reached[next as usize];
                if reached.query == query && (reached.key, reached.length) <= (key, length) {
                    continue;
                }
                *reached = Reached { query, from: f, side: (first + k) as u32, done: false, key, length, at };
                if let Some(before) = only.replace((key, next)) {
                    scratch.offer(&mut hand, before);
                }
            }
            let Some((key, next)) = only else { break };
            if ways > 1 || scratch.goals.contains(&FaceId::new(next)) {
                scratch.offer(&mut hand, (key, next));
                break;
            }
            scratch.reached[next as usize].done = true;
            here = scratch.reached[next as usize];
            (least, f) = (key, next);
        }
    }
    reached_goals > 0
}

impl Scratch {
    /// Puts the lesser of what is in the hand and a face that was reached into the hand, the other into the queue.
    #[inline]
    fn offer(&mut self, hand: &mut Option<(u64, u32)>, reached: (u64, u32)) {
        let worse = match *hand {
            Some(best) if best <= reached => Some(reached),
            _ => hand.replace(reached),
        };
        self.work.pushes += 1;
        self.queue.extend(worse.map(Reverse));
    }

    /// Takes the least of the queue and of what is in the hand.
    fn next(&mut self, hand: &mut Option<(u64, u32)>) -> Option<(u64, u32)> {
        match (hand.take(), self.queue.peek_mut()) {
            (None, least) => least.map(PeekMut::pop).map(|Reverse(least)| least),
            (Some(held), Some(mut least)) if least.0 < held => Some(std::mem::replace(&mut least.0, held)),
            (held, _) => held,
        }
    }

    pub(super) fn push(&mut self, key: f64, item: u32) {
        self.work.pushes += 1;
        self.queue.push(Reverse((key.to_bits(), item)));
    }

    /// Writes down the portals that led to `f`, from the last to the first.
    fn trace(&self, f: u32, portals: &mut Vec<(u32, u32)>) {
        let mut at = self.reached[f as usize];
        while at.from != NONE {
            portals.push((at.from, at.side));
            at = self.reached[at.from as usize];
        }
    }
}

/// To which point the line of a metric goes from `from` through a portal into the next face.
#[inline]
pub(super) fn point_of_line(
    mesh: &NavMesh,
    metric: PathAlgorithm,
    goal: Point,
    endpoints: [Point; 2],
    from: Point,
    next: impl FnOnce() -> FaceId,
) -> Point {
    match metric {
        PathAlgorithm::Centroid => mesh.centroid(next()),
        PathAlgorithm::Midpoint => {
            Point::new((endpoints[0].x + endpoints[1].x) / 2.0, (endpoints[0].y + endpoints[1].y) / 2.0)
        }
        PathAlgorithm::Closest => closest_on(endpoints, from),
        _ => aimed_at(goal, endpoints, from),
    }
}

/// Where the straight line from `from` to the goal goes through a portal, rounded: if it passes beside the portal, the end
/// that is nearer to it; if it leads away from the portal, the closest point.
#[inline]
fn aimed_at(goal: Point, [right, left]: [Point; 2], from: Point) -> Point {
    let line = [goal.x - from.x, goal.y - from.y];
    let height = |p: Point| line[0] * (p.y - from.y) - line[1] * (p.x - from.x);
    let [of_right, of_left] = [right, left].map(height);
    if of_left > of_right {
        let t = (of_right / (of_right - of_left)).clamp(0.0, 1.0);
        Point::new(right.x + (left.x - right.x) * t, right.y + (left.y - right.y) * t)
    } else {
        closest_on([right, left], from)
    }
}
