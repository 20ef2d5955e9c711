//! The shortest length that a way through a part of a door may have.
//!
//! ```text
//!        goal ·                       A straight line if it meets the part that is seen, else round the nearer end.
//!             │╲                      A goal on the root's side of the door is mirrored first: the way has to touch
//!   ●─────────╪═╪════●                the door in any case.
//!             root
//! ```
//!
//! Points are constructed here, and here only; the guess may be off by a few last places.

use super::super::nearest::distance;
use crate::plane::Point;

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Point, b: Point) -> [f64; 2] {
    [a.x - b.x, a.y - b.y]
}

/// The point at the fraction `t` of the way from `a` to `b`.
pub(super) fn between(a: Point, b: Point, t: f64) -> Point {
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t)
    }
}

/// The length from `root` to `goal` by way of the door from `right` to `left`, of which the part between the
/// fractions `seen` is in sight.
pub(super) fn estimate(root: Point, [right, left]: [Point; 2], seen: [f64; 2], goal: Point) -> f64 {
    let door = minus(left, right);
    let [height, goal_height] = [root, goal].map(|p| cross(door, minus(p, right)));
    let goal = if height * goal_height > 0.0 {
        let t = 2.0 * goal_height / (door[0] * door[0] + door[1] * door[1]);
        Point::new(goal.x + door[1] * t, goal.y - door[0] * t)
    } else {
        goal
    };
    let line = minus(goal, root);
    let slope = cross(line, door);
    // Where the straight line meets the door; no number if both lie on its line.
    let t = cross(line, minus(root, right)) / slope;
    let bend = if t < seen[0] {
        between(right, left, seen[0])
    } else if t > seen[1] {
        between(right, left, seen[1])
    } else {
        return distance(root, goal);
    };
    distance(root, bend) + distance(bend, goal)
}
