//! The hull while it grows: triangles, their neighbours, and the points that each of them sees.
//!
//! ```text
//!             v2
//!            ●             beside[0] lies behind v0 v1, beside[1] behind v1 v2, beside[2] behind v2 v0;
//!   beside 2 ╱ ╲ beside 1    seen: the first of a list of points above it, linked through `next`
//!        v0 ●───● v1
//!          beside 0
//! ```

use super::HullEvent;
use crate::solid::predicates::orient3d;
use crate::topology::Observer;
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

struct Triangle {
    corners: [u32; 3],
    beside: [u32; 3],
    seen: u32,
    /// The last step that looked at the triangle, and what it found.
    mark: u32,
}

/// See the head of the file.
pub(super) struct Triangles<'a> {
    points: &'a [[f64; 3]],
    triangles: Vec<Triangle>,
    free: Vec<u32>,
    /// By point: a triangle that sees it, or `NONE` once it is inside or a corner.
    seen_by: Vec<u32>,
    /// By point: the next one in the list of that triangle.
    next: Vec<u32>,
    /// By point: the new triangle whose horizon edge starts there.
    starting: Vec<u32>,
    /// Grows by two with each point added.
    step: u32,
    /// Kept from step to step.
    stack: Vec<u32>,
    gone: Vec<u32>,
    horizon: Vec<Edge>,
    new: Vec<u32>,
}

/// An edge of the horizon: its ends with the triangles that go on the left, and the triangle beyond.
#[derive(Clone, Copy)]
struct Edge {
    from: u32,
    to: u32,
    beyond: u32,
}

impl<'a> Triangles<'a> {
    /// The hull of four points, the fourth below the plane of the others. Every other point that is wanted learns of a
    /// triangle that sees it, if one does.
    pub(super) fn simplex(points: &'a [[f64; 3]], [a, b, c, d]: [u32; 4], wanted: impl Fn(u32) -> bool) -> Self {
        let triangle = |corners, beside| Triangle { corners, beside, seen: NONE, mark: 0 };
        let mut this = Self {
            points,
            triangles: vec![
                triangle([a, b, c], [1, 2, 3]),
                triangle([b, a, d], [0, 3, 2]),
                triangle([c, b, d], [0, 1, 3]),
                triangle([a, c, d], [0, 2, 1]),
            ],
            free: Vec::new(),
            seen_by: vec![NONE; points.len()],
            next: vec![NONE; points.len()],
            starting: vec![NONE; points.len()],
            step: 0,
            stack: Vec::new(),
            gone: Vec::new(),
            horizon: Vec::new(),
            new: (0..4).collect(),
        };
        (0..points.len() as u32).filter(|&p| wanted(p)).for_each(|p| this.find_new_triangle(p));
        this
    }

    /// Whether `p` lies above triangle `t`.
    #[inline]
    fn sees(&self, p: u32, t: u32) -> bool {
        let at = |i: u32| self.points[i as usize];
        let [a, b, c] = self.triangles[t as usize].corners;
        orient3d(at(a), at(b), at(c), at(p)) == Ordering::Greater
    }

    /// Asks whether `p` sees `t`, once in each step.
    #[inline]
    fn sees_once(&mut self, p: u32, t: u32) -> bool {
        let mark = self.triangles[t as usize].mark;
        if mark >= self.step {
            return mark > self.step;
        }
        let sees = self.sees(p, t);
        self.triangles[t as usize].mark = self.step + u32::from(sees);
        sees
    }

    /// Makes `p` part of the hull. Nothing happens if it lies inside or on it.
    pub(super) fn add(&mut self, p: u32, observer: &mut impl Observer<HullEvent>) {
        let start = self.seen_by[p as usize];
        if start == NONE {
            observer.observe(|| HullEvent::Inside(p));
            return;
        }
        self.seen_by[p as usize] = NONE;
        self.find_horizon(p, start);
        observer.observe(|| HullEvent::Added {
            point: p,
            seen: self.gone.iter().map(|&t| self.triangles[t as usize].corners).collect(),
            horizon: self.horizon.iter().map(|edge| [edge.from, edge.to]).collect(),
        });
        self.make_triangles(p);
        for i in 0..self.gone.len() {
            let mut q = self.triangles[self.gone[i] as usize].seen;
            while q != NONE {
                let after = self.next[q as usize];
                if q != p {
                    self.find_triangle_again(q, self.gone[i]);
                }
                q = after;
            }
        }
        self.free.append(&mut self.gone);
    }

    /// Fills `gone` with the triangles that see `p`, and `horizon` with the edges round them.
    fn find_horizon(&mut self, p: u32, start: u32) {
        self.step += 2;
        self.horizon.clear();
        self.gone.clear();
        self.stack.push(start);
        self.triangles[start as usize].mark = self.step + 1;
        while let Some(t) = self.stack.pop() {
            self.gone.push(t);
            let Triangle { corners, beside, .. } = self.triangles[t as usize];
            for i in 0..3 {
                let fresh = self.triangles[beside[i] as usize].mark < self.step;
                if !self.sees_once(p, beside[i]) {
                    self.horizon.push(Edge { from: corners[i], to: corners[(i + 1) % 3], beyond: beside[i] });
                } else if fresh {
                    self.stack.push(beside[i]);
                }
            }
        }
    }

    /// A triangle from each edge of the horizon to `p`.
    fn make_triangles(&mut self, p: u32) {
        self.new.clear();
        for i in 0..self.horizon.len() {
            let Edge { from, to, beyond } = self.horizon[i];
            let triangle = Triangle { corners: [from, to, p], beside: [beyond, NONE, NONE], seen: NONE, mark: 0 };
            // Triangles that go still hold their lists, so their places are free only later.
            let t = self.free.pop().unwrap_or(self.triangles.len() as u32);
            if t as usize == self.triangles.len() {
                self.triangles.push(triangle);
            } else {
                self.triangles[t as usize] = triangle;
            }
            let other = &mut self.triangles[beyond as usize];
            if let Some(edge) = other.corners.iter().position(|&corner| corner == to) {
                other.beside[edge] = t;
            }
            self.starting[from as usize] = t;
            self.new.push(t);
        }
        for i in 0..self.new.len() {
            let t = self.new[i];
            let after = self.starting[self.horizon[i].to as usize];
            self.triangles[t as usize].beside[1] = after;
            self.triangles[after as usize].beside[2] = t;
        }
    }

    /// Looks for one of the new triangles that sees `q`, which saw the triangle `gone`.
    fn find_triangle_again(&mut self, q: u32, gone: u32) {
        /// So few new triangles are asked one by one.
        const FEW: usize = 16;
        if self.new.len() <= FEW {
            return self.find_new_triangle(q);
        }
        // From the triangle that is gone, over others that are gone and see q, to the horizon: a new triangle can
        // see q only if one beside its horizon edge did. So each pair of a point and a triangle costs once.
        let gone_mark = self.step + 1;
        let first_of_search = self.stack.len();
        self.stack.push(gone);
        let mut at = first_of_search;
        let mut found = NONE;
        self.triangles[gone as usize].mark = gone_mark - 1;
        'search: while at < self.stack.len() {
            let t = self.stack[at];
            at += 1;
            let Triangle { corners, beside, .. } = self.triangles[t as usize];
            for i in 0..3 {
                let new = self.starting[corners[i] as usize];
                let across = self.triangles[beside[i] as usize].mark;
                if across == gone_mark {
                    if self.sees(q, beside[i]) {
                        self.triangles[beside[i] as usize].mark = gone_mark - 1;
                        self.stack.push(beside[i]);
                    }
                } else if self.is_on_horizon(new, corners[i], corners[(i + 1) % 3]) && self.sees(q, new) {
                    found = new;
                    break 'search;
                }
            }
        }
        for i in first_of_search..self.stack.len() {
            let t = self.stack[i];
            self.triangles[t as usize].mark = gone_mark;
        }
        self.stack.truncate(first_of_search);
        self.note(q, found);
    }

    /// Whether `t` is the new triangle of the horizon edge between these points.
    fn is_on_horizon(&self, t: u32, from: u32, to: u32) -> bool {
        self.triangles.get(t as usize).is_some_and(|t| t.corners[..2] == [from, to] && t.mark == 0)
    }

    /// Asks the new triangles one by one.
    fn find_new_triangle(&mut self, q: u32) {
        let found = self.new.iter().copied().find(|&t| self.sees(q, t));
        self.note(q, found.unwrap_or(NONE));
    }

    fn note(&mut self, q: u32, t: u32) {
        self.seen_by[q as usize] = t;
        if t != NONE {
            self.next[q as usize] = std::mem::replace(&mut self.triangles[t as usize].seen, q);
        }
    }

    /// The triangles of the hull, each with its neighbours, numbered from 0.
    pub(super) fn triangles(self) -> Vec<([u32; 3], [u32; 3])> {
        let mut numbers = vec![0; self.triangles.len()];
        self.free.iter().for_each(|&t| numbers[t as usize] = NONE);
        for (number, count) in numbers.iter_mut().filter(|number| **number != NONE).zip(0..) {
            *number = count;
        }
        let live = self.triangles.iter().zip(&numbers).filter(|&(_, &number)| number != NONE);
        live.map(|(t, _)| (t.corners, t.beside.map(|t| numbers[t as usize]))).collect()
    }
}
