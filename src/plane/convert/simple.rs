//! Whether a closed polygon is simple, and which way it runs.
//!
//! ```text
//!      ●───────●          ●     ●          ●────●──●        simple / bow-tie (sides cross) /
//!       ╲     ╱           │ ╲ ╱ │           ╲   ╱           a corner on a side
//!        ╲   ╱            │ ╱ ╲ │            ╲ ╱
//!          ●              ●     ●             ●
//! ```

use super::ConvertError;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::plane::cycle::{convex_direction, encloses};
use crate::plane::sweep::{Intersection, sweep};
use std::cmp::Ordering;

/// Which way the polygon with these corners runs: `Greater` = counter-clockwise. Exact.
///
/// Cost: O(corners) for a convex polygon, O(corners log corners) otherwise.
///
/// # Errors
/// If the corners lie on one line, sides cross, or a corner lies on a side; `face` is the number to report.
pub(super) fn direction(points: &[Point], corners: &[u32], face: u32) -> Result<Ordering, ConvertError> {
    let places = || corners.iter().map(|&v| points[v as usize]);
    if let [a, b, c] = *corners {
        let turn = orientation(points[a as usize], points[b as usize], points[c as usize]);
        return if turn.is_eq() { Err(ConvertError::ZeroArea { face }) } else { Ok(turn) };
    }
    match convex_direction(places()) {
        Some(Ordering::Equal) => return Err(ConvertError::ZeroArea { face }),
        Some(direction) => return Ok(direction),
        None => {}
    }
    check_simple(points, corners, face)?;
    Ok(if encloses(places()) { Ordering::Greater } else { Ordering::Less })
}

fn check_simple(points: &[Point], corners: &[u32], face: u32) -> Result<(), ConvertError> {
    let n = corners.len() as u32;
    let local: Vec<Point> = corners.iter().map(|&v| points[v as usize]).collect();
    let sides: Vec<[u32; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
    let side = |i: u32| (corners[i as usize], corners[((i + 1) % n) as usize]);
    Err(match sweep(&local, &sides, &[], true).intersection {
        None => return Ok(()),
        Some(Intersection::Crossing(a, b)) => ConvertError::SelfCrossing { face, first: side(a), second: side(b) },
        Some(Intersection::PointOnEdge { point, edge }) => {
            ConvertError::SelfTouching { face, vertex: corners[point as usize], side: side(edge) }
        }
        Some(Intersection::SamePlace(a, b)) => {
            ConvertError::SelfTouching { face, vertex: corners[a as usize], side: side(b) }
        }
        // Two sides leave a corner in the same direction: the nearer far end lies on the longer side.
        Some(Intersection::Overlap(a, b)) => {
            let far = |i: u32, j: u32| sides[i as usize].into_iter().find(|p| !sides[j as usize].contains(p));
            let (p, q) = (far(a, b).unwrap_or(a), far(b, a).unwrap_or(b));
            let nearer_is_p = left_to_right(local[p as usize], local[q as usize]).is_lt();
            let (vertex, on) = if nearer_is_p { (p, b) } else { (q, a) };
            ConvertError::SelfTouching { face, vertex: corners[vertex as usize], side: side(on) }
        }
    })
}
