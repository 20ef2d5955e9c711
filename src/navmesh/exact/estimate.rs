//! The shortest length that a path through a cone may have.
//!
//! ```text
//!        goal ·                       A straight line if it meets the part that is seen, else round the nearer end.
//!             │╲                      A goal on the root's side of the portal is mirrored first: the path has to touch
//!   ●─────────╪═╪════●                the portal in any case.
//!             root
//! ```
//!
//! Points are constructed here, and here only. The part that is seen is taken too large by what rounding may have
//! done to its ends, so that a portal seen edge-on counts as a whole; the length itself may be off by a few last
//! places. A guess that is too short costs work, not the answer.

use super::super::nearest::distance;
use super::cone::{Beam, ENDS};
use super::ray::{Ray, difference};
use crate::plane::Point;

/// More than rounding may change of the products that are compared, as a share of their sizes.
pub(super) const DOUBT: f64 = 4e-15;

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The point at the fraction `t` of the path from `a` to `b`.
#[inline]
pub(super) fn between(a: Point, b: Point, t: f64) -> Point {
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t)
    }
}

/// Which fractions of the portal, from right to left, the cone sees at most.
#[inline]
pub(super) fn seen(beam: &Beam) -> [f64; 2] {
    let (node, [right, left]) = (&beam.node, beam.endpoints);
    if node.is_at_endpoint() || node.left & node.right & ENDS != 0 {
        return [0.0, 1.0];
    }
    // The right endpoint is on the right of either ray, and the left one on its left.
    let fraction = |ray: Ray, outwards: f64| {
        let ([a, one], [b, other]) = (ray.height(right), ray.height(left));
        if b > a { (outwards * one.max(other) - a) / (b - a) } else { outwards }
    };
    let low = if node.right & ENDS != 0 { 0.0 } else { fraction(beam.right_ray(), -4.0) };
    let high = if node.left & ENDS != 0 { 1.0 } else { fraction(beam.left_ray(), 4.0) };
    [if low > 0.0 { low } else { 0.0 }, if high < 1.0 { high } else { 1.0 }]
}

/// The guess of the length from the root of a cone to the goal, by way of the part of its portal that is [`seen`].
#[inline]
pub(super) fn guess(beam: &Beam, [low, high]: [f64; 2], goal: Point) -> f64 {
    let root = beam.root;
    if beam.node.is_at_endpoint() {
        return distance(root, goal);
    }
    let [right, left] = beam.endpoints;
    let portal = difference(right, left);
    // The root is on the left of the line from the right endpoint to the left, or so close to it that rounding could say
    // otherwise: then a goal that was mirrored, or not, by that would be on the wrong side.
    let goal_height = cross(portal, difference(right, goal));
    let goal = if goal_height > 0.0 {
        let t = 2.0 * goal_height / (portal[0] * portal[0] + portal[1] * portal[1]);
        Point::new(goal.x + portal[1] * t, goal.y - portal[0] * t)
    } else {
        goal
    };
    // The line from the root to the goal meets the portal at the fraction at / slope. If that cannot be told from a
    // point that is seen, the straight line is a guess that is not too long.
    let (line, off) = (difference(root, goal), difference(right, root));
    let (slope, at) = (cross(line, portal), cross(line, off));
    let doubt =
        DOUBT * (line[0].abs() * (portal[1].abs() + off[1].abs()) + line[1].abs() * (portal[0].abs() + off[0].abs()));
    let bend = if at + doubt < low * slope {
        between(right, left, low)
    } else if at - doubt > high * slope {
        between(right, left, high)
    } else {
        return distance(root, goal);
    };
    distance(root, bend) + distance(bend, goal)
}

#[cfg(test)]
mod tests {
    use super::super::cone::{Node, START};
    use super::*;
    use crate::plane::predicates::orientation;

    #[test]
    fn a_portal_on_the_line_of_the_root_is_not_guessed_too_long() {
        // The root is on the left of the portal's line, but rounding says right; the near endpoint is the left one.
        let [root, left, right] = [(0.3, 2.1), (0.2, 1.4000000000000001), (0.1, 0.7000000000000001)].map(Point::from);
        assert!(orientation(root, right, left).is_gt());
        assert!(cross(difference(right, left), difference(right, root)) < 0.0);
        let node = Node { length: 0.0, root: START, before: START, left: ENDS, right: ENDS, portal: 0, parent: 0 };
        let [to_left, to_right] = [left, right].map(|endpoint| difference(root, endpoint));
        let beam = Beam { node, root, left: to_left, right: to_right, endpoints: [right, left] };
        for goal in [(0.27, 1.39), (0.13, 1.41)].map(Point::from) {
            let shortest = distance(root, left) + distance(left, goal);
            let guess = guess(&beam, seen(&beam), goal);
            assert!(guess <= shortest * (1.0 + 1e-15), "{goal}: {guess} > {shortest}");
        }
    }
}
