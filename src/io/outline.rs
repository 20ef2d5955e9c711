//! A ring as a closed line: along what it runs, what lies at its corners, what it goes round. All exact.
//!
//! ```text
//!      ●─────────●          A side runs along every piece of it, whatever corners other rings have there:
//!      │         ● q        the right side of the square along p -> q.
//!      │         ● p
//!      ●─────────●
//! ```

use crate::plane::cycle::{by_direction, on_segment, surrounds};
use crate::plane::predicates::left_to_right;
use crate::plane::{Point, is_counter_clockwise};
use std::cmp::Ordering;

/// The corners of a ring that touches itself nowhere.
pub(super) struct Outline(Vec<Point>);

impl Outline {
    pub(super) fn new(corners: impl Iterator<Item = Point>) -> Self {
        Self(corners.collect())
    }

    fn sides(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        (0..self.0.len()).map(|i| [self.0[i], self.0[(i + 1) % self.0.len()]])
    }

    /// The sides that run along the whole of `p -> q`, in either direction.
    pub(super) fn sides_along(&self, [p, q]: [Point; 2]) -> impl Iterator<Item = [Point; 2]> + '_ {
        self.sides().filter(move |&[a, b]| p != q && on_segment(a, b, p) && on_segment(a, b, q))
    }

    /// Whether one of the corners is here.
    pub(super) fn has_corner(&self, p: Point) -> bool {
        self.0.contains(&p)
    }

    /// Whether what it goes round lies left of `p -> q`, if it runs along that.
    pub(super) fn is_left_of(&self, [p, q]: [Point; 2]) -> Option<bool> {
        let [a, b] = self.sides_along([p, q]).next()?;
        let along = left_to_right(a, b) == left_to_right(p, q);
        Some(along == is_counter_clockwise(&self.0))
    }

    /// The directions that bound what it goes round at a point of it, counter-clockwise, each by a point further on.
    pub(super) fn wedge(&self, v: Point) -> Option<[Point; 2]> {
        let n = self.0.len();
        let [before, after] = match self.0.iter().position(|&corner| corner == v) {
            Some(i) => [self.0[(i + n - 1) % n], self.0[(i + 1) % n]],
            None => self.sides().find(|&[a, b]| on_segment(a, b, v))?,
        };
        Some(if is_counter_clockwise(&self.0) { [after, before] } else { [before, after] })
    }

    /// `Greater` if it goes round the point an odd number of times, `Equal` if the point lies on it.
    pub(super) fn place_of(&self, p: Point) -> Ordering {
        if self.sides().any(|[a, b]| on_segment(a, b, p)) {
            return Ordering::Equal;
        }
        if surrounds(self.0.iter().copied(), p) { Ordering::Greater } else { Ordering::Less }
    }
}

/// The directions round a point, each once, counter-clockwise: between each and the next there is nothing.
pub(super) struct Directions {
    v: Point,
    all: Vec<Point>,
}

impl Directions {
    pub(super) fn new(v: Point, mut all: Vec<Point>) -> Self {
        all.sort_by(|&a, &b| by_direction(v, a, b));
        all.dedup_by(|a, b| by_direction(v, *a, *b).is_eq());
        Self { v, all }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.all.len()
    }

    /// Whether a wedge covers what follows each direction.
    pub(super) fn covered(&self, [from, to]: [Point; 2]) -> Vec<bool> {
        let number = |p: Point| self.all.iter().position(|&q| by_direction(self.v, p, q).is_eq()).unwrap_or(0);
        let (n, start) = (self.all.len(), number(from));
        let length = (number(to) + n - start) % n;
        (0..n).map(|i| (i + n - start) % n < length).collect()
    }
}
