//! Four points to start from that do not lie in one plane.
//!
//! ```text
//!   the first and the last by position  ->  the furthest from their line  ->  the furthest from their plane
//! ```

use super::HullError;
use crate::solid::predicates::{are_collinear, by_position, orient3d};
use crate::solid::vector::{cross, dot, minus};
use std::cmp::Ordering;

/// Four points such that the fourth is below the plane of the first three, as far apart as can be seen quickly.
/// O(n).
pub(super) fn spanning_points(points: &[[f64; 3]]) -> Result<[u32; 4], HullError> {
    let at = |i: u32| points[i as usize];
    let all = 0..points.len() as u32;
    let by = |a: &u32, b: &u32| by_position(at(*a), at(*b));
    // Of equal ones the first.
    let first = all.clone().min_by(by).ok_or(HullError::NoPoint)?;
    let last = all.clone().rev().max_by(by).ok_or(HullError::NoPoint)?;
    let (a, b) = (at(first), at(last));
    if by_position(a, b).is_eq() {
        return Err(HullError::AllEqual { points: points.len() });
    }
    let far_from_line = |i: u32| {
        let turn = cross(minus(b, a), minus(at(i), a));
        dot(turn, turn)
    };
    // What rounding calls furthest may lie on the line; then any other point that does not will do.
    let third = furthest(all.clone(), far_from_line)
        .filter(|&i| !are_collinear(a, b, at(i)))
        .or_else(|| all.clone().find(|&i| !are_collinear(a, b, at(i))));
    let Some(third) = third else { return Err(HullError::Collinear { through: [first, last] }) };
    let c = at(third);
    let normal = cross(minus(b, a), minus(c, a));
    let side = |i: u32| orient3d(a, b, c, at(i));
    let fourth = furthest(all.clone(), |i| dot(normal, minus(at(i), a)).abs())
        .filter(|&i| side(i) != Ordering::Equal)
        .or_else(|| all.clone().find(|&i| side(i) != Ordering::Equal));
    match fourth {
        None => Err(HullError::Coplanar { through: [first, last, third] }),
        Some(i) if side(i) == Ordering::Less => Ok([first, last, third, i]),
        Some(i) => Ok([last, first, third, i]),
    }
}

fn furthest(mut all: impl Iterator<Item = u32>, distance: impl Fn(u32) -> f64) -> Option<u32> {
    let first = all.next()?;
    let best = all.fold((first, distance(first)), |best, i| {
        let far = distance(i);
        if far > best.1 { (i, far) } else { best }
    });
    Some(best.0)
}
