//! Your part of the lab: areas, turns, two tests of position, and a sign that is never wrong.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; what helps is in `exact.rs`.
//! `cargo test` says how far you are.

use crate::exact::{two_product, two_sum};
use crate::map::{self, Map};
use crate::point::Point;

/// Task 1. The signed area of the parallelogram with the sides p q and p r: positive if p, q, r turn left.
pub fn parallelogram_area(p: Point, q: Point, r: Point) -> f64 {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: todo!("parallelogram_area")
    let (one, other) = products(p, q, r);
    one - other
    // END SOLUTION
}

/// Task 1. The signed area of the triangle p q r: positive if p, q, r turn left.
pub fn triangle_area(p: Point, q: Point, r: Point) -> f64 {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: todo!("triangle_area")
    parallelogram_area(p, q, r) / 2.0
    // END SOLUTION
}

/// Task 2. Which way p, q, r turn, as doubles see it: 1 left, -1 right, 0 straight on or straight back.
pub fn turn(p: Point, q: Point, r: Point) -> i32 {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: todo!("turn")
    sign(parallelogram_area(p, q, r))
    // END SOLUTION
}

/// Task 3. Whether p lies inside the triangle a b c or on its boundary. The corners may run either way round.
pub fn in_triangle(p: Point, a: Point, b: Point, c: Point) -> bool {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, a, b, c);
    // STARTER: todo!("in_triangle")
    let sides = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
    // Left of one side and right of another one is outside, whichever way round the corners run.
    !(sides.contains(&1) && sides.contains(&-1))
    // END SOLUTION
}

/// Task 4. Where d lies and the circle through a, b, c, which may run either way round: 1 inside, 0 on the circle,
/// -1 outside.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> i32 {
    // BEGIN SOLUTION
    // STARTER: let _ = (a, b, c, d);
    // STARTER: todo!("in_circle")
    let ([ax, ay], [bx, by], [cx, cy]) = (minus(a, d), minus(b, d), minus(c, d));
    let lift_a = ax * ax + ay * ay;
    let lift_b = bx * bx + by * by;
    let lift_c = cx * cx + cy * cy;
    let det = lift_a * (bx * cy - by * cx) - lift_b * (ax * cy - ay * cx) + lift_c * (ax * by - ay * bx);
    // If a, b, c turn right, two rows of the determinant have changed places.
    sign(det) * turn(a, b, c)
    // END SOLUTION
}

/// Task 5. The sign of the sum of these numbers, exactly: 1, 0 or -1. The sum of no numbers is 0.
pub fn sign_of_sum(numbers: &[f64]) -> i32 {
    // BEGIN SOLUTION
    // STARTER: let _ = numbers;
    // STARTER: // `two_sum` is given.
    // STARTER: let _ = two_sum;
    // STARTER: todo!("sign_of_sum")
    // The sum so far, exactly: parts that do not overlap, the smallest first.
    let mut parts: Vec<f64> = Vec::new();
    for &number in numbers {
        let mut carry = number;
        let mut sum = Vec::new();
        for &part in &parts {
            let (rounded, missing) = two_sum(carry, part);
            if missing != 0.0 {
                sum.push(missing);
            }
            carry = rounded;
        }
        if carry != 0.0 {
            sum.push(carry);
        }
        parts = sum;
    }
    // The last part outweighs all others together.
    parts.last().map_or(0, |&largest| sign(largest))
    // END SOLUTION
}

/// Task 6. Which way p, q, r really turn: 1 left, -1 right, 0 if the three points are on one line.
pub fn orient2d_exact(p: Point, q: Point, r: Point) -> i32 {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: // `two_product` is given.
    // STARTER: let _ = two_product;
    // STARTER: todo!("orient2d_exact")
    // Multiplied out, because the products of coordinates can be had exactly, and their differences cannot.
    let products =
        [(q.x, r.y), (-q.x, p.y), (-p.x, r.y), (-q.y, r.x), (q.y, p.x), (p.y, r.x)];
    let mut numbers = Vec::new();
    for (a, b) in products {
        let (product, missing) = two_product(a, b);
        numbers.push(product);
        numbers.push(missing);
    }
    sign_of_sum(&numbers)
    // END SOLUTION
}

/// Task 7. Which way p, q, r really turn, if doubles are sure of it; `None` if they are not.
pub fn filter(p: Point, q: Point, r: Point) -> Option<i32> {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: todo!("filter")
    let (one, other) = products(p, q, r);
    let det = one - other;
    // Four roundings, each at most 2^-53 of what is rounded.
    let doubt = 4.0 * (f64::EPSILON / 2.0) * (one.abs() + other.abs());
    if det.abs() > doubt { Some(sign(det)) } else { None }
    // END SOLUTION
}

/// Task 7. Which way p, q, r really turn: the filter, and the exact sign only where it is needed.
pub fn orient2d(p: Point, q: Point, r: Point) -> i32 {
    // BEGIN SOLUTION
    // STARTER: let _ = (p, q, r);
    // STARTER: todo!("orient2d")
    match filter(p, q, r) {
        Some(certain) => certain,
        None => orient2d_exact(p, q, r),
    }
    // END SOLUTION
}

/// Task 8. Colours the cells of the map where doubles are wrong: `turn` of the cell's point, Q and R is not `orient2d`.
pub fn wrong_signs(map: &mut Map) {
    // BEGIN SOLUTION
    // STARTER: // `map.point(column, row)`, `map.colour(column, row)`, `map::SIDE`, `map::Q` and `map::R` are given.
    // STARTER: let _ = (map, map::SIDE);
    // STARTER: todo!("wrong_signs")
    for row in 0..map::SIDE {
        for column in 0..map::SIDE {
            let p = map.point(column, row);
            if turn(p, map::Q, map::R) != orient2d(p, map::Q, map::R) {
                map.colour(column, row);
            }
        }
    }
    // END SOLUTION
}

// BEGIN SOLUTION
// STARTER: // Here is room for functions of your own.
/// The two products of which the area is the difference.
fn products(p: Point, q: Point, r: Point) -> (f64, f64) {
    let ([ux, uy], [vx, vy]) = (minus(q, p), minus(r, p));
    (ux * vy, uy * vx)
}

/// From one point to another.
fn minus(to: Point, from: Point) -> [f64; 2] {
    [to.x - from.x, to.y - from.y]
}

/// 1, 0 or -1.
fn sign(x: f64) -> i32 {
    if x > 0.0 {
        1
    } else if x < 0.0 {
        -1
    } else {
        0
    }
}
// END SOLUTION
