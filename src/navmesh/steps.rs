//! A path piece by piece: where it passes the portals of its corridor, and in which face each piece runs.
//!
//! ```text
//!     f0   │   f1  ╱  f2        a step ends at a portal, at a corner round which the path bends, or at the goal
//!   s ─────┼──────●
//!          │     ╱ ╲──────
//! ```

use super::funnel::Endpoint;
use crate::plane::Point;

/// Where a step ends.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum End {
    /// On a portal, at this part of the path from its right endpoint to its left one.
    Portal(usize, f64),
    /// At a point of the path, by its number.
    Endpoint(usize),
}

/// A straight piece of a path within one face.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Step {
    pub(super) end: End,
    /// The face, by its number in the corridor.
    pub(super) face: usize,
}

/// The steps of a path that was pulled straight through portals, left endpoint and right endpoint each. Portals that belong to a
/// corner of the path are passed there. O(number of portals and points).
pub(super) fn steps(portals: &[[Endpoint; 2]], path: &[Endpoint]) -> Vec<Step> {
    let mut steps = Vec::with_capacity(portals.len() + path.len());
    // How many portals have been passed: the number of the face, too.
    let mut passed = 0;
    for (k, (a, b)) in path.iter().zip(path.iter().skip(1)).enumerate() {
        let is_last = k + 2 == path.len();
        while let Some(portal) = portals.get(passed)
            && (is_last || !portal.contains(b))
        {
            let [left, right] = portal.map(|endpoint| endpoint.point);
            let along = [b.point.x - a.point.x, b.point.y - a.point.y];
            let height = |p: Point| along[0] * (p.y - a.point.y) - along[1] * (p.x - a.point.x);
            let whole = height(left) - height(right);
            // A portal on the line of the piece is passed where the piece ends.
            let share = if whole > 0.0 { -height(right) / whole } else { closest(right, left, b.point) };
            steps.push(Step { end: End::Portal(passed, share.clamp(0.0, 1.0)), face: passed });
            passed += 1;
        }
        steps.push(Step { end: End::Endpoint(k + 1), face: passed });
        while !is_last && portals.get(passed).is_some_and(|portal| portal.contains(b)) {
            passed += 1;
        }
    }
    steps
}

/// How far along a segment the point of it closest to `p` is.
fn closest(a: Point, b: Point, p: Point) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    let share = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
    if share.is_finite() { share } else { 0.0 }
}
