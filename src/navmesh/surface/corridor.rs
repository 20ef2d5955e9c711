//! The quicker path algorithm: rows of triangles by simple rules, as in the plane.

use super::super::{PathAlgorithm, Work};
use super::{NONE, NavSurface, Space, between, dot, lerp, minus};
use crate::ids::FaceMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What a search knows of a triangle.
#[derive(Clone, Copy, Debug)]
struct Reached {
    query: u32,
    /// The side by which it is entered, or `NONE`.
    by: u32,
    done: bool,
    key: u64,
    length: f64,
    at: Space,
}

const UNKNOWN: Reached = Reached { query: 0, by: NONE, done: false, key: 0, length: 0.0, at: [0.0; 3] };

/// The search, with its memory.
#[derive(Clone, Debug, Default)]
pub(super) struct Corridors {
    query: u32,
    reached: Vec<Reached>,
    /// Keys are the bits of lengths: they are in the order of the lengths.
    queue: BinaryHeap<Reverse<(u64, u32)>>,
    pub(super) work: Work,
}

impl Corridors {
    /// Rows of triangles to the goal, by the sides that they are left by, from the start on. More than one only with costs and
    /// with several triangles at the goal, as long as another may be cheaper by its line.
    pub(super) fn find(
        &mut self,
        surface: &NavSurface,
        metric: PathAlgorithm,
        costs: Option<&FaceMap<f64>>,
        [start, goal]: [Space; 2],
        [starts, goals]: [&[usize]; 2],
    ) -> Vec<Vec<usize>> {
        self.query = self.query.wrapping_add(1);
        if self.query == 0 {
            self.reached.clear();
            self.query = 1;
        }
        let query = self.query;
        self.reached.resize(surface.triangle_count().max(self.reached.len()), UNKNOWN);
        self.queue.clear();
        self.work = Work::default();
        for &t in starts {
            self.reached[t] = Reached { query, at: start, ..UNKNOWN };
            self.put(0, t);
        }
        let mut rows = Vec::new();
        // The least that a line to the goal costs.
        let mut best = f64::INFINITY;
        while let Some(Reverse((least, t))) =
            self.queue.pop().filter(|&Reverse((least, _))| f64::from_bits(least) <= best)
        {
            let t = t as usize;
            self.work.pops += 1;
            let here = self.reached[t];
            if std::mem::replace(&mut self.reached[t].done, true) {
                continue;
            }
            let cost = costs.map_or(1.0, |costs| costs[surface.face_of(t)].max(0.0));
            if goals.contains(&t) {
                rows.push(self.row(surface, t));
                if costs.is_none() || rows.len() == goals.len() {
                    break;
                }
                best = best.min(here.length + cost * between(here.at, goal));
            }
            self.work.expansions += 1;
            for s in 3 * t..3 * t + 3 {
                let twin = surface.sides[s].twin;
                if twin == NONE || here.by == s as u32 {
                    continue;
                }
                let beyond = twin as usize / 3;
                let (at, length, key) = if metric == PathAlgorithm::Breadth {
                    (here.at, here.length + 1.0, here.length + 1.0)
                } else {
                    let at = surface.point_of_line(metric, s, here.at, goal);
                    let length = here.length + cost * between(here.at, at);
                    (at, length, length + between(at, goal))
                };
                let key = key.to_bits().max(least);
                let reached = &mut self.reached[beyond];
                if reached.query == query && (reached.key, reached.length) <= (key, length) {
                    continue;
                }
                *reached = Reached { query, by: twin, done: false, key, length, at };
                self.put(key, beyond);
            }
        }
        rows
    }

    fn put(&mut self, key: u64, triangle: usize) {
        self.work.pushes += 1;
        self.queue.push(Reverse((key, triangle as u32)));
    }

    /// The sides that led to a triangle.
    fn row(&self, surface: &NavSurface, goal: usize) -> Vec<usize> {
        let mut portals = Vec::new();
        let mut by = self.reached[goal].by;
        while by != NONE {
            let portal = surface.sides[by as usize].twin as usize;
            portals.push(portal);
            by = self.reached[portal / 3].by;
        }
        portals.reverse();
        portals
    }
}

impl NavSurface {
    /// To which point the line of a metric goes from `from` through a side.
    fn point_of_line(&self, metric: PathAlgorithm, s: usize, from: Space, goal: Space) -> Space {
        let [a, b] = self.ends(s);
        let along = |x: f64| lerp(a, b, (x / self.sides[s].length).clamp(0.0, 1.0));
        match metric {
            PathAlgorithm::Centroid => {
                let [a, b, c] = self.corners(self.sides[s].twin as usize / 3);
                [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0)
            }
            PathAlgorithm::Midpoint => lerp(a, b, 0.5),
            PathAlgorithm::Closest => along(dot(minus(b, a), minus(from, a)) / self.sides[s].length),
            _ => {
                // Turned round the side into one plane, the start below it and the goal above.
                let [[x, depth], [goal_x, height]] = [from, goal].map(|p| self.turned(s, p));
                let whole = depth + height;
                along(if whole > 0.0 { x + (goal_x - x) * (depth / whole) } else { goal_x })
            }
        }
    }
}
