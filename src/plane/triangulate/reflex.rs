//! The corners of a face that are not convex, so that "does one of them lie in this triangle?" is asked of few.
//!
//! ```text
//!   ┌─────────┬──────┐     a k-d tree: the corners left and right of the middle one, then those below and above,
//!   │ ·   ·   │·  ·  │     and so on. A box that lies beside the triangle is passed over with all that is in it;
//!   ├─────────┤   ·  │     only the boxes that a side of the triangle passes through are opened: O(√k) of them.
//!   │   ·  ·  │ ·    │
//!   └─────────┴──────┘     Corners only ever leave: what is left of a face turns less to the right with each cut.
//! ```
//!
//! Source: Bentley, *Multidimensional binary search trees used for associative searching*, CACM 18, 1975.

use super::patch::Patch;
use crate::geometry::point;
use crate::geometry::predicates::orientation;
use crate::plane::Point;
use std::cmp::Ordering;
use std::ops::Range;

/// With at most so many corners a box is not parted.
const LEAF: usize = 8;
const NONE: u32 = u32::MAX;

/// The corners that are not convex. Its memory is used again from face to face.
#[derive(Default)]
pub(super) struct ReflexCorners {
    /// The corners by their place in the patch, in the order of the tree; `NONE` for one that has left.
    places: Vec<u32>,
    /// Where each of the corners given is in the order; `NONE` for a convex one.
    index: Vec<u32>,
    /// The corners by their places, while they are put in order.
    order: Vec<(u32, u32)>,
    /// The boxes; those within box i are 2 i + 1 and 2 i + 2.
    boxes: Vec<Bounds>,
}

/// A box of corners.
#[derive(Clone, Copy)]
struct Bounds {
    low: Point,
    high: Point,
    /// How many corners in it have not left.
    left: u32,
}

impl ReflexCorners {
    /// Begins with the corners of a face; the number of a corner is its place in the list. O(n log n).
    pub(super) fn begin(&mut self, patch: &Patch, corners: &[u32]) {
        let mut order = std::mem::take(&mut self.order);
        order.clear();
        order.extend(
            corners.iter().zip(0..).filter(|(h, _)| !patch.turn(**h).is_gt()).map(|(&h, i)| (patch.origin(h), i)),
        );
        self.index.clear();
        self.index.resize(corners.len(), NONE);
        self.boxes.clear();
        self.open(patch, &mut order, 0, 0);
        self.places.clear();
        for (i, &(place, corner)) in (0..).zip(&order) {
            self.places.push(place);
            self.index[corner as usize] = i;
        }
        self.order = order;
    }

    /// Makes a box of these corners, and the boxes within it. The depth is the logarithm of their number.
    fn open(&mut self, patch: &Patch, corners: &mut [(u32, u32)], number: usize, axis: usize) {
        let at = |place: u32| patch.points[place as usize];
        let [low, high] = point::corners(corners.iter().map(|&(place, _)| at(place)));
        if self.boxes.len() <= number {
            let [low, high] = point::corners([]);
            let empty = Bounds { low, high, left: 0 };
            self.boxes.resize(number + 1, empty);
        }
        self.boxes[number] = Bounds { low, high, left: corners.len() as u32 };
        if corners.len() <= LEAF {
            return;
        }
        // Places are numbered from left to right.
        let half = corners.len() / 2;
        if axis == 0 {
            corners.select_nth_unstable(half);
        } else {
            corners.select_nth_unstable_by(half, |a, b| at(a.0).y.total_cmp(&at(b.0).y).then(a.cmp(b)));
        }
        let (before, after) = corners.split_at_mut(half);
        self.open(patch, before, 2 * number + 1, 1 - axis);
        self.open(patch, after, 2 * number + 2, 1 - axis);
    }

    /// Takes a corner out if it is in. O(log k).
    pub(super) fn remove(&mut self, corner: u32) {
        let at = std::mem::replace(&mut self.index[corner as usize], NONE);
        if at == NONE {
            return;
        }
        let at = at as usize;
        self.places[at] = NONE;
        let (mut number, mut range) = (0, 0..self.places.len());
        loop {
            self.boxes[number].left -= 1;
            if range.len() <= LEAF {
                return;
            }
            let middle = range.start + range.len() / 2;
            (number, range) =
                if at < middle { (2 * number + 1, range.start..middle) } else { (2 * number + 2, middle..range.end) };
        }
    }

    /// Whether a corner lies in the closed triangle between three places, which runs counter-clockwise, other than at
    /// these places. O(√k), if few corners share a place.
    pub(super) fn any_in(&self, patch: &Patch, places: [u32; 3]) -> bool {
        let triangle = places.map(|place| patch.points[place as usize]);
        let inside =
            |&place: &u32| place != NONE && !places.contains(&place) && holds(triangle, patch.points[place as usize]);
        self.any_in_box(0, 0..self.places.len(), triangle, &inside)
    }

    /// The same for the corners of one box, which are a range of the order. The depth is the logarithm of their number.
    fn any_in_box(
        &self,
        number: usize,
        range: Range<usize>,
        triangle: [Point; 3],
        inside: &impl Fn(&u32) -> bool,
    ) -> bool {
        if !self.boxes[number].may_touch(triangle) {
            return false;
        }
        if range.len() <= LEAF {
            return self.places[range].iter().any(inside);
        }
        let middle = range.start + range.len() / 2;
        self.any_in_box(2 * number + 1, range.start..middle, triangle, inside)
            || self.any_in_box(2 * number + 2, middle..range.end, triangle, inside)
    }
}

impl Bounds {
    /// Not if all of it lies on the outer side of one side of the triangle.
    fn may_touch(&self, [a, b, c]: [Point; 3]) -> bool {
        let is_beside = |p: Point, q: Point| {
            // The corner of the box that lies furthest to the left of the line from p to q.
            let x = if q.y > p.y { self.low.x } else { self.high.x };
            let y = if q.x > p.x { self.high.y } else { self.low.y };
            orientation(p, q, Point::new(x, y)) == Ordering::Less
        };
        self.left > 0 && !is_beside(a, b) && !is_beside(b, c) && !is_beside(c, a)
    }
}

/// Whether the point lies in the closed triangle, which runs counter-clockwise.
fn holds([a, b, c]: [Point; 3], p: Point) -> bool {
    orientation(a, b, p).is_ge() && orientation(b, c, p).is_ge() && orientation(c, a, p).is_ge()
}
