//! The Delaunay triangulation by divide and conquer.
//!
//! ```text
//!        ●─────────────●          Both halves are done. The lowest edge between them, w -> u, is found by walking
//!      ╱  ╲  L   R   ╱  ╲         down both outlines. Then the seam rises: of the next corner on the left and the
//!     ●    ●       ●     ●        next one on the right, that one makes a triangle with u and w whose circle does
//!      ╲  ╱ <───────╲   ╱         not hold the other. Edges of L and R in whose way it is are taken out first.
//!        u <──────── w
//! ```
//!
//! The outer face lies on the left of the *outline*, which runs clockwise; so the outline's half-edges are those of
//! the outer face. Only [`orientation`] and [`in_circle`] decide, and they are exact.
//!
//! Cost: O(n) for each level of division, O(n log n) in all; expected O(n log log n) for points spread evenly.
//!
//! Source: Guibas and Stolfi, *Primitives for the manipulation of general subdivisions and the computation of
//! Voronoi diagrams*, 1985.

use super::halves::Halves;
use super::order::{Axis, FINER, Ordered, middle};
use crate::geometry::predicates::{in_circle, orientation};
use crate::geometry::threads;
use crate::plane::Point;
use crate::progress::Stage;
use std::cmp::Ordering;
use std::ops::Range;

/// A finished triangulation: half-edges whose origins are places in the order, and one of the outline.
pub(super) struct Divided {
    pub(super) origin: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    pub(super) outer: u32,
}

/// Parts with more points than this are made of two that know nothing of each other, by two threads if there are two. One
/// thread does the same, so that edges get the same numbers.
const LARGE: u32 = 1 << 15;

/// The stage of the triangulation of ordered points. It is begun by the thread that is watched, which need not be the one that
/// does the work.
pub(super) fn stage(ordered: &Ordered) -> Stage {
    Stage::new("triangulating", ordered.sites.len())
}

/// Triangulates distinct points, if there are two or more. Points on one line become a path.
pub(super) fn divide_and_conquer(ordered: &Ordered, stage: &Stage) -> Option<Divided> {
    let count = ordered.sites.len() as u32;
    if count < 2 {
        return None;
    }
    let [mut origin, mut next, mut prev] = [(); 3].map(|()| vec![0; 6 * count as usize]);
    let (halves, part) = whole(ordered, stage, 0..count, [&mut origin, &mut next, &mut prev]);
    stage.set(count as usize);
    let outer = match part {
        Part::Edges(outer) => outer,
        Part::Point(_) => 0,
    };
    let (outer, length) = halves.fill_gaps(outer);
    [&mut origin, &mut next, &mut prev].into_iter().for_each(|column| column.truncate(length));
    Some(Divided { origin, next, prev, outer })
}

/// The points of a range; their half-edges lie in columns that have room for six for each point.
///
/// ```text
///     first half          second half          a new edge joins them in a place that one of the halves did not need:
///     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒·····│▒▒▒▒▒▒▒▒▒▒▒▒▒····    nothing is moved, and only as many places stay free as the outline
///                                              has edges, and three
/// ```
fn whole<'a>(
    ordered: &Ordered,
    stage: &Stage,
    range: Range<u32>,
    mut columns: [&'a mut [u32]; 3],
) -> (Halves<'a>, Part) {
    let (low, high) = (range.start, range.end);
    let Some((cut, axis)) = (high - low > LARGE).then(|| ordered.cut(0, low, high)).flatten() else {
        let mut work = Work { ordered, stage, halves: Halves::new(6 * low, columns) };
        let part = work.by_key(0, low, high);
        return (work.halves, part);
    };
    let half = |range, columns| {
        let (halves, part) = whole(ordered, stage, range, columns);
        (halves.into_free(), part)
    };
    let [left, right] = threads::halved(columns.each_mut().map(|column| &mut **column), 6 * (cut - low) as usize);
    let ((mut free, left), (more, right)) = threads::both(|| half(low..cut, left), || half(cut..high, right));
    free.extend(more);
    let mut work = Work { ordered, stage, halves: Halves::filled(6 * low, columns, free) };
    let part = work.merge(left, right, axis);
    (work.halves, part)
}

/// What is done of the points.
#[derive(Clone, Copy)]
enum Part {
    /// A point alone.
    Point(u32),
    /// Edges, by a half-edge of their outline.
    Edges(u32),
}

struct Work<'a, 'b> {
    ordered: &'b Ordered,
    stage: &'b Stage,
    halves: Halves<'a>,
}

impl Work<'_, '_> {
    #[inline]
    fn at(&self, v: u32) -> Point {
        self.ordered.sites[v as usize].point
    }

    /// Whether the point `v` lies strictly to the left of `h`.
    #[inline]
    fn is_left(&self, v: u32, h: u32) -> bool {
        orientation(self.at(self.halves.origin(h)), self.at(self.halves.destination(h)), self.at(v)).is_gt()
    }

    /// The points from `low` to `high`, parted by the grid at a depth, then by the finer ones in it.
    fn by_key(&mut self, depth: usize, low: u32, high: u32) -> Part {
        if high - low <= 3 {
            return self.few(low, high);
        }
        let Some((cut, axis)) = self.ordered.cut(depth, low, high) else {
            return if depth < FINER { self.by_key(depth + 1, low, high) } else { self.by_middle(low, high, Axis::X) };
        };
        let (left, right) = (self.by_key(depth, low, cut), self.by_key(depth, cut, high));
        self.merge(left, right, axis)
    }

    /// The points from `low` to `high`, all of one cell, parted as they were put in order.
    fn by_middle(&mut self, low: u32, high: u32, axis: Axis) -> Part {
        if high - low <= 3 {
            return self.few(low, high);
        }
        let cut = low + middle((high - low) as usize) as u32;
        let (left, right) = (self.by_middle(low, cut, axis.other()), self.by_middle(cut, high, axis.other()));
        self.merge(left, right, axis)
    }

    /// One, two or three points.
    fn few(&mut self, low: u32, high: u32) -> Part {
        self.stage.add((high - low) as usize);
        let (mut a, mut b, mut c) = (low, low + 1, low + 2);
        match high - low {
            1 => return Part::Point(a),
            2 => return Part::Edges(self.halves.edge(a, b)),
            _ => {}
        }
        let turn = orientation(self.at(a), self.at(b), self.at(c));
        if turn.is_eq() {
            let mut path = [a, b, c];
            path.sort_unstable_by(|&v, &w| Axis::X.compare(self.at(v), self.at(w)));
            [a, b, c] = path;
        }
        let h = self.halves.edge(a, b);
        let g = self.halves.extend(h, c);
        if turn.is_eq() {
            return Part::Edges(h);
        }
        self.halves.connect(g ^ 1, h);
        Part::Edges(if turn.is_gt() { h ^ 1 } else { h })
    }

    /// The half-edge of the outline through `start` whose origin comes first along the axis, or last. O(outline).
    fn extreme(&self, start: u32, axis: Axis, wanted: Ordering) -> u32 {
        match (axis, wanted) {
            (Axis::X, Ordering::Greater) => self.least(start, |p| [-p.x, -p.y]),
            (Axis::X, _) => self.least(start, |p| [p.x, p.y]),
            (Axis::Y, Ordering::Greater) => self.least(start, |p| [-p.y, p.x]),
            (Axis::Y, _) => self.least(start, |p| [p.y, -p.x]),
        }
    }

    /// The half-edge of the outline through `start` whose origin has the least first number, of these the least second one.
    #[inline]
    fn least(&self, start: u32, numbers: impl Fn(Point) -> [f64; 2]) -> u32 {
        let (mut best, mut least) = (start, numbers(self.at(self.halves.origin(start))));
        let mut h = self.halves.next(start);
        while h != start {
            let here = numbers(self.at(self.halves.origin(h)));
            if here[0] < least[0] || (here[0] <= least[0] && here[1] < least[1]) {
                (best, least) = (h, here);
            }
            h = self.halves.next(h);
        }
        best
    }

    /// Joins two parts, of which `left` comes before `right` along the axis.
    fn merge(&mut self, left: Part, right: Part, axis: Axis) -> Part {
        let lowest = match (left, right) {
            (Part::Point(u), Part::Point(w)) => self.halves.edge(w, u),
            (Part::Point(u), Part::Edges(r)) => {
                let mut r = self.halves.prev(self.extreme(r, axis, Ordering::Less));
                while self.is_left(u, r) {
                    r = self.halves.prev(r);
                }
                self.halves.extend(r, u)
            }
            (Part::Edges(l), Part::Point(w)) => {
                let mut l = self.extreme(l, axis, Ordering::Greater);
                while self.is_left(w, l) {
                    l = self.halves.next(l);
                }
                let before = self.halves.prev(l);
                self.halves.extend(before, w) ^ 1
            }
            (Part::Edges(l), Part::Edges(r)) => self.lowest(l, r, axis),
        };
        Part::Edges(self.rise(lowest))
    }

    /// Makes the lowest edge between two outlines; returns its half from right to left.
    fn lowest(&mut self, l: u32, r: u32, axis: Axis) -> u32 {
        let mut l = self.extreme(l, axis, Ordering::Greater);
        let mut r = self.halves.prev(self.extreme(r, axis, Ordering::Less));
        loop {
            if self.is_left(self.halves.destination(r), l) {
                l = self.halves.next(l);
            } else if self.is_left(self.halves.origin(l), r) {
                r = self.halves.prev(r);
            } else {
                let after = self.halves.next(r);
                return self.halves.connect(after, l);
            }
        }
    }

    /// Closes the seam above its lowest edge, and returns a half-edge of the common outline: the twin of the highest.
    ///
    /// ```text
    ///      x ●               ● y         base runs from w to u. Triangles over it are tried with x, the next corner
    ///         ╲             ╱            counter-clockwise round u, and with y, the next one clockwise round w.
    ///        u ●<── base ──● w
    /// ```
    ///
    /// An edge that is taken out lays bare the corner at its other end, which the seam then has to reach by an edge of
    /// its own further up. So at the end all numbers of edges taken out are in use again.
    fn rise(&mut self, lowest: u32) -> u32 {
        let mut base = lowest;
        loop {
            let (w, u) = (self.halves.origin(base), self.halves.destination(base));
            let (at_w, at_u) = (self.at(w), self.at(u));
            let above = |v: Point| orientation(v, at_u, at_w).is_gt();

            let mut left = self.halves.ccw(base ^ 1);
            let mut x = self.at(self.halves.destination(left));
            let left_fits = above(x);
            if left_fits {
                loop {
                    let behind = self.halves.ccw(left);
                    let next = self.at(self.halves.destination(behind));
                    if !in_circle(at_u, at_w, x, next).is_gt() {
                        break;
                    }
                    self.halves.remove(left);
                    (left, x) = (behind, next);
                }
            }
            let mut right = self.halves.cw(base);
            let mut y = self.at(self.halves.destination(right));
            let right_fits = above(y);
            if right_fits {
                loop {
                    let behind = self.halves.cw(right);
                    let next = self.at(self.halves.destination(behind));
                    if !in_circle(at_u, at_w, y, next).is_gt() {
                        break;
                    }
                    self.halves.remove(right);
                    (right, y) = (behind, next);
                }
            }
            let take_right = match (left_fits, right_fits) {
                (false, false) => return base ^ 1,
                (true, true) => in_circle(x, at_u, at_w, y).is_gt(),
                (_, right) => right,
            };
            base = if take_right {
                let after = self.halves.next(right);
                self.halves.connect(after, base ^ 1)
            } else {
                let after = self.halves.next(base ^ 1);
                self.halves.connect(after, left ^ 1)
            };
        }
    }
}
