//! Points, and polygons as linked lists of corners.
//!
//! ```text
//!                    next
//!        c2 ◀──────────────────── c1       counter-clockwise: the inside of the polygon is on the left
//!         │ ────────────────────▶ ▲        of whoever goes along next
//!    next ▼          prev         │ next
//!        c3 ────────────────────▶ c0
//! ```
//!
//! Corners refer to each other by number: the corner 3 is `polygons.corners[3]`. A polygon is named by any one of its
//! corners. A reference that is not set yet is `None`. The lists are [`Records`]: they are used like a `Vec`, and count how
//! often your code looks at a point or a corner.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::harness::{Record, Records};
use crate::predicates;
pub use crate::predicates::Turn;
use std::cmp::Ordering;

/// The number of a corner: its place in `Polygons::corners`.
pub type CornerId = usize;

/// A point of the plane. y points up.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Upwards.
    pub y: f64,
}

/// A corner of a polygon.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Corner {
    /// Where it is.
    pub pos: Point,
    /// The corner after it, counter-clockwise.
    pub next: Option<CornerId>,
    /// The corner before it.
    pub prev: Option<CornerId>,
}

impl Record for Point {
    const KIND: &'static str = "point";
    const LETTER: char = 'p';
}

impl Record for Corner {
    const KIND: &'static str = "corner";
    const LETTER: char = 'c';
}

/// Points to make a hull of, and the corners of all polygons.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Polygons {
    /// The points. They are linked to nothing.
    pub points: Records<Point>,
    /// All corners of all polygons.
    pub corners: Records<Corner>,
}

impl Polygons {
    /// Makes a polygon with corners at these places, in this order, and returns its first corner. One place gives a
    /// corner that is its own `next` and `prev`; none gives `None`.
    #[track_caller]
    pub fn new_polygon(&mut self, places: &[Point]) -> Option<CornerId> {
        let first = self.corners.len();
        for &pos in places {
            self.corners.push(Corner { pos, next: None, prev: None });
        }
        for i in 0..places.len() {
            self.make_next(first + i, first + (i + 1) % places.len());
        }
        (!places.is_empty()).then_some(first)
    }

    /// Makes `after` follow `before`: sets `before.next` and `after.prev`.
    #[track_caller]
    pub fn make_next(&mut self, before: CornerId, after: CornerId) {
        self.corners[before].next = Some(after);
        self.corners[after].prev = Some(before);
    }

    /// The corner after `c`, counter-clockwise.
    #[track_caller]
    pub fn next(&self, c: CornerId) -> CornerId {
        set(self.corners[c].next, "next", c)
    }

    /// The corner before `c`.
    #[track_caller]
    pub fn prev(&self, c: CornerId) -> CornerId {
        set(self.corners[c].prev, "prev", c)
    }

    /// Where `c` is.
    #[track_caller]
    pub fn position(&self, c: CornerId) -> Point {
        self.corners[c].pos
    }
}

#[track_caller]
fn set(reference: Option<usize>, name: &str, number: usize) -> usize {
    match reference {
        Some(to) => to,
        None => panic!("the {name} of corner {number} is not set"),
    }
}

impl Point {
    /// Whether this point comes before another one from left to right; of two above each other, the lower one does.
    /// Equal points do not come before each other.
    pub fn is_before(self, other: Self) -> bool {
        (self.x, self.y) < (other.x, other.y)
    }
}

/// The order of two points from left to right; of two above each other, the lower one comes first. For sorting:
/// `points.sort_by(left_to_right)`.
pub fn left_to_right(p: &Point, q: &Point) -> Ordering {
    (p.x, p.y).partial_cmp(&(q.x, q.y)).unwrap_or(Ordering::Equal)
}

/// Where c lies, for somebody who goes from a to b: `Turn::Left`, `Turn::Right` or `Turn::Straight`. Always right.
pub fn turn(a: Point, b: Point, c: Point) -> Turn {
    let [a, b, c] = [a, b, c].map(|p| [p.x, p.y]);
    predicates::turn(a, b, c)
}

/// Of three points on one line: whether b lies between a and c, or is equal to one of them.
pub fn is_between(a: Point, b: Point, c: Point) -> bool {
    let (low, high) = if a.is_before(c) { (a, c) } else { (c, a) };
    !b.is_before(low) && !high.is_before(b)
}
