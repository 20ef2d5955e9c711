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
        let piece = [a.point, b.point];
        // How far along the piece one is.
        let mut walked = 0.0;
        while let Some(portal) = portals.get(passed)
            && (is_last || !portal.contains(b))
        {
            let [left, right] = portal.map(|endpoint| endpoint.point);
            let along = [b.point.x - a.point.x, b.point.y - a.point.y];
            let height = |p: Point| along[0] * (p.y - a.point.y) - along[1] * (p.x - a.point.x);
            let whole = height(left) - height(right);
            // A portal on the line of the piece is passed where the piece ends.
            let share = if whole > 0.0 { -height(right) / whole } else { closest(right, left, b.point) };
            let share = onwards([right, left], share.clamp(0.0, 1.0), piece, &mut walked);
            steps.push(Step { end: End::Portal(passed, share), face: passed });
            passed += 1;
        }
        steps.push(Step { end: End::Endpoint(k + 1), face: passed });
        while !is_last && portals.get(passed).is_some_and(|portal| portal.contains(b)) {
            passed += 1;
        }
    }
    steps
}

/// By how much of a piece rounding may move a point along it.
const HAIR: f64 = 1e-12;

/// Where a portal is passed, `share` by the heights of its ends over the piece. Where they are so close to the line of the
/// piece that rounding decides, that may be in front of what was walked already, or behind the end of the piece: then it
/// is the point of the portal closest to there. So nobody walks back. Updates what was walked.
fn onwards([right, left]: [Point; 2], share: f64, [a, b]: [Point; 2], walked: &mut f64) -> f64 {
    let part_of_piece = |share: f64| {
        let p = Point::new(right.x + (left.x - right.x) * share, right.y + (left.y - right.y) * share);
        let [x, y] = [b.x - a.x, b.y - a.y];
        ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y)
    };
    let part = part_of_piece(share);
    let share = if part > 1.0 + HAIR {
        closest(right, left, b)
    } else if part < *walked - HAIR {
        let at = Point::new(a.x + (b.x - a.x) * *walked, a.y + (b.y - a.y) * *walked);
        closest(right, left, at)
    } else {
        *walked = walked.max(part.min(1.0));
        return share;
    };
    *walked = walked.max(part_of_piece(share.clamp(0.0, 1.0)).min(1.0));
    share.clamp(0.0, 1.0)
}

/// How far along a segment the point of it closest to `p` is.
fn closest(a: Point, b: Point, p: Point) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    let share = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
    if share.is_finite() { share } else { 0.0 }
}
