//! A distance beside which all rounding of coordinates is small: what is farther apart than that stays apart when its ends
//! are rounded.
//!
//! ```text
//!        ● b          The corner of a triangle is farther than the gap from the line through the others if
//!       ╱             |area| > gap · |side|. The same comparison tells, without more digits, on which side it lies.
//!      ╱    ● p
//!   a ●
//! ```
//!
//! Rounding moves each vertex of an arrangement by much less than the gap. If no vertex is within the gap of a segment that does
//! not pass it, nothing can meet on the way from the exact places to the rounded ones: two pieces that come to meet do so
//! first at an end of one of them. That no vertex is so near is seen from two things.
//!
//! 1. Segments that have no point in common are farther apart than the gap, if one of them crosses something: the others stay
//!    where they are.
//! 2. Round each vertex: of two half-edges that follow each other, the end of the shorter one is farther than the gap from the
//!    line of the longer one, or they form an obtuse angle and both are longer than the gap.
//!
//! For a vertex v on a segment e, and a segment s that does not pass v: if e and s have no point in common, that is 1. Else
//! they have a vertex w in common, and from w along e, v is no nearer to s than the neighbour of w, which by 2 is not
//! near to the half-edges beside it, and even less to those that form larger angles. Vertices of one segment are farther apart
//! than the gap, too: by 2 all half-edges of a vertex that has several are longer than that.

use crate::geometry::both::of_both;
use crate::plane::Point;

/// The gap, as a part of the greatest coordinate: 2⁷ times what rounding to the nearest doubles moves a coordinate.
const PART: f64 = 1.0 / (1_u64 << 46) as f64;

/// A gap for points with coordinates up to some size. The range of coordinates keeps areas from underflow.
#[derive(Clone, Copy, Debug)]
pub(in crate::plane) struct Gap {
    width: f64,
}

impl Gap {
    /// The gap for coordinates that are not greater.
    pub(super) fn new(reach: f64) -> Self {
        Self { width: reach * PART }
    }

    /// The distance.
    #[inline]
    pub(super) fn width(self) -> f64 {
        self.width
    }

    /// Whether so much, by which vertices have moved, is little beside it.
    pub(in crate::plane) fn exceeds(self, moved: f64) -> bool {
        16.0 * moved < self.width
    }

    /// A line through two points.
    #[inline]
    pub(super) fn line(self, [from, to]: [Point; 2]) -> Line {
        let along = [to.x - from.x, to.y - from.y];
        Line { from, along, bound: self.width * length(along) }
    }

    /// Whether two half-edges from a point to two others are as 2 says.
    #[inline]
    pub(in crate::plane) fn is_between(self, from: Point, ends: [Point; 2]) -> bool {
        let [[a, b], [c, d]] = [[ends[0].x - from.x, ends[0].y - from.y], [ends[1].x - from.x, ends[1].y - from.y]];
        let [one, other] = [length([a, b]), length([c, d])];
        // Twice as much, as the points themselves have been rounded.
        let is_wide = (a * d - b * c).abs() > 2.0 * self.width * one.max(other);
        is_wide || (a * c + b * d < 0.0 && one.min(other) > 4.0 * self.width)
    }
}

/// The sum of both coordinates of a vector: not less than its length.
#[inline]
fn length([x, y]: [f64; 2]) -> f64 {
    x.abs() + y.abs()
}

/// A line from one point to another.
#[derive(Clone, Copy)]
pub(super) struct Line {
    from: Point,
    along: [f64; 2],
    bound: f64,
}

impl Line {
    /// Whether two points lie on one side of the line; `None` if one of them is not farther from it than the gap.
    #[inline]
    pub(super) fn has_on_one_side(&self, points: [Point; 2]) -> Option<bool> {
        let area = |p: Point| self.along[0] * (p.y - self.from.y) - self.along[1] * (p.x - self.from.x);
        let [one, other] = of_both(points, area);
        (one.abs().min(other.abs()) > self.bound).then_some((one > 0.0) == (other > 0.0))
    }
}
