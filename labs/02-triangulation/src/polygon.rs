//! Polygons as doubly-linked lists of their corners.
//!
//! ```text
//!        c3 ◀── next ── c2         Each polygon is a circle of corners, counter-clockwise. It is named by any one of
//!        │               ▲         its corners. All corners are in one list; a corner is named by its number there.
//!        ▼               │
//!        c0 ── next ──▶ c1
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::harness::{Record, Records};
use crate::point::Point;

/// The number of a corner.
pub type CornerId = usize;

/// A corner of a polygon.
#[derive(Clone, PartialEq, Debug)]
pub struct Corner {
    /// Where it is.
    pub pos: Point,
    /// The corner after it, counter-clockwise.
    pub next: Option<CornerId>,
    /// The corner before it.
    pub prev: Option<CornerId>,
}

impl Record for Corner {
    const KIND: &'static str = "corner";
    const LETTER: char = 'c';
}

/// All polygons: the corners of all of them.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Polygons {
    /// All corners. The corner c is `self.corners[c]`.
    pub corners: Records<Corner>,
}

/// Reading, and changing one reference or two.
impl Polygons {
    /// The corner after `c`.
    #[track_caller]
    pub fn next(&self, c: CornerId) -> CornerId {
        set(self.corners[c].next, "next", c)
    }

    /// The corner before `c`.
    #[track_caller]
    pub fn prev(&self, c: CornerId) -> CornerId {
        set(self.corners[c].prev, "prev", c)
    }

    /// Where the corner `c` is.
    #[track_caller]
    pub fn position(&self, c: CornerId) -> Point {
        self.corners[c].pos
    }

    /// Makes a corner that is not linked yet, and returns its number.
    #[track_caller]
    pub fn new_corner(&mut self, pos: Point) -> CornerId {
        self.corners.push(Corner { pos, next: None, prev: None });
        self.corners.len() - 1
    }

    /// Lets `after` follow `before`: sets `next` of one and `prev` of the other.
    #[track_caller]
    pub fn make_next(&mut self, before: CornerId, after: CornerId) {
        self.corners[before].next = Some(after);
        self.corners[after].prev = Some(before);
    }
}

#[track_caller]
fn set(reference: Option<CornerId>, name: &str, of: CornerId) -> CornerId {
    match reference {
        Some(corner) => corner,
        None => panic!("the {name} of corner {of} is not set"),
    }
}
