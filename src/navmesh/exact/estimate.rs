//! The shortest length that a way through a cone may have.
//!
//! ```text
//!        goal ·                       A straight line if it meets the part that is seen, else round the nearer end.
//!             │╲                      A goal on the root's side of the door is mirrored first: the way has to touch
//!   ●─────────╪═╪════●                the door in any case.
//!             root
//! ```
//!
//! Points are constructed here, and here only. The part that is seen is taken too large by what rounding may have
//! done to its ends, so that a door seen edge-on counts as a whole; the length itself may be off by a few last
//! places. A guess that is too short costs work, not the answer.

use super::super::nearest::distance;
use super::super::rooms::Rooms;
use super::cone::{ENDS, Node};
use super::ray::Ray;
use crate::plane::Point;

/// More than rounding may change of the products that are compared.
const DOUBT: f64 = 4e-15;

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Point, b: Point) -> [f64; 2] {
    [a.x - b.x, a.y - b.y]
}

/// The point at the fraction `t` of the way from `a` to `b`.
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

/// Which fractions of the door, from right to left, the cone sees at most.
#[inline]
pub(super) fn seen<R: Rooms>(rooms: &R, start: Point, node: &Node, [right, left]: [Point; 2]) -> [f64; 2] {
    if node.is_at_post() || node.left & node.right & ENDS != 0 {
        return [0.0, 1.0];
    }
    let [left_ray, right_ray] = node.rays(rooms, start);
    // The right post is on the right of either ray, and the left one on its left.
    let fraction = |ray: &Ray, outwards: f64| {
        let ([a, one], [b, other]) = (ray.height(right), ray.height(left));
        if b > a { (outwards * one.max(other) - a) / (b - a) } else { outwards }
    };
    let low = if node.right & ENDS != 0 { 0.0 } else { fraction(&right_ray, -4.0) };
    let high = if node.left & ENDS != 0 { 1.0 } else { fraction(&left_ray, 4.0) };
    [if low > 0.0 { low } else { 0.0 }, if high < 1.0 { high } else { 1.0 }]
}

/// The guess of the length from the root of a node to the goal, by way of the door with these posts.
#[inline]
pub(super) fn guess<R: Rooms>(rooms: &R, start: Point, node: &Node, posts: [Point; 2], goal: Point) -> f64 {
    let root = node.root(rooms, start);
    if node.is_at_post() {
        return distance(root, goal);
    }
    let [right, left] = posts;
    let [low, high] = seen(rooms, start, node, posts);
    let door = minus(left, right);
    let [height, goal_height] = [root, goal].map(|p| cross(door, minus(p, right)));
    let goal = if height * goal_height > 0.0 {
        let t = 2.0 * goal_height / (door[0] * door[0] + door[1] * door[1]);
        Point::new(goal.x + door[1] * t, goal.y - door[0] * t)
    } else {
        goal
    };
    // The line from the root to the goal meets the door at the fraction at / slope. If that cannot be told from a
    // point that is seen, the straight line is a guess that is not too long.
    let (line, off) = (minus(goal, root), minus(root, right));
    let (slope, at) = (cross(line, door), cross(line, off));
    let doubt =
        DOUBT * (line[0].abs() * (door[1].abs() + off[1].abs()) + line[1].abs() * (door[0].abs() + off[0].abs()));
    let bend = if at + doubt < low * slope {
        between(right, left, low)
    } else if at - doubt > high * slope {
        between(right, left, high)
    } else {
        return distance(root, goal);
    };
    distance(root, bend) + distance(bend, goal)
}
