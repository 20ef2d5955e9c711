//! Which of two edges comes later on the way of a sweep, and which lie left of a point of a level.
//!
//! ```text
//!        ╲   │   ╱             A level is the horizontal line just below a height y: edges with an upper end at y
//!    ─────●──┼──╱────── y      cross it, those with a lower end there do not, and horizontal ones never do. Which
//!    · · ·╲· │ ╱· · · · level  of two comes first on it is asked with x and y exchanged.
//! ```

use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
pub(super) use crate::plane::sweep::is_above;
use std::cmp::Ordering;

/// Two ends. Edges run from left to right, vertical ones upwards.
pub(super) type Ends = [Point; 2];

/// Whether the first edge runs to the right of the second at a level that both cross.
pub(super) fn is_right(e: Ends, g: Ends) -> bool {
    // Seen with x and y exchanged, right is above.
    let turned = |[a, b]: Ends| {
        let [p, q] = [a, b].map(|p| Point::new(p.y, p.x));
        if left_to_right(p, q).is_lt() { [p, q] } else { [q, p] }
    };
    is_above(turned(e), turned(g))
}

/// Whether the edge crosses the level just below `y`.
#[inline]
pub(super) fn crosses_level([a, b]: Ends, y: f64) -> bool {
    (a.y < y) != (b.y < y)
}

/// Whether the edge, which crosses the level just below `at.y`, does so to the left of `at`.
#[inline]
pub(super) fn is_left_of([a, b]: Ends, at: Point) -> bool {
    orientation(a, b, at).is_gt() != (a.y < b.y)
}

/// Whether the edge, which spans `p.x` and has `p` above it, runs above the level at `p.x`.
#[inline]
pub(super) fn is_above_level([a, b]: Ends, p: Point, level: f64) -> bool {
    (a.y >= level && b.y >= level) || orientation(a, b, Point::new(p.x, level)) != Ordering::Greater
}
