//! The corner of a convex face.

use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// Whether the corner u -> v -> w turns left, or runs straight on.
pub(super) fn turns_left_or_runs_straight([u, v, w]: [Point; 3]) -> bool {
    match orientation(u, v, w) {
        Ordering::Greater => true,
        Ordering::Equal => left_to_right(u, v) == left_to_right(v, w),
        Ordering::Less => false,
    }
}
