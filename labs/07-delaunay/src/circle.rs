//! In or out of a circle: the question of lab 01, with an answer that is always right.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::Point;
use crate::predicates;
pub use crate::predicates::InCircle;

/// Where d lies, compared with the circle through a, b, c, which must run counter-clockwise: `InCircle::Inside`,
/// `InCircle::On` or `InCircle::Outside`. Always right.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> InCircle {
    let [a, b, c, d] = [a, b, c, d].map(|p| [p.x, p.y]);
    predicates::in_circle(a, b, c, d)
}
