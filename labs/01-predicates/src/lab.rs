//! Your part of the lab: areas, turns, two tests of position, and a sign that is never wrong.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; what helps is in `exact.rs`.
//! `cargo test` says how far you are.

use crate::exact::{two_product, two_sum};
use crate::map::{self, Map};
use crate::point::Point;

/// Task 1. The signed area of the parallelogram with the sides p q and p r: positive if p, q, r turn left.
pub fn parallelogram_area(p: Point, q: Point, r: Point) -> f64 {
    let _ = (p, q, r);
    todo!("parallelogram_area")
}

/// Task 1. The signed area of the triangle p q r: positive if p, q, r turn left.
pub fn triangle_area(p: Point, q: Point, r: Point) -> f64 {
    let _ = (p, q, r);
    todo!("triangle_area")
}

/// Task 2. Which way p, q, r turn, as doubles see it: 1 left, -1 right, 0 straight on or straight back.
pub fn turn(p: Point, q: Point, r: Point) -> i32 {
    let _ = (p, q, r);
    todo!("turn")
}

/// Task 3. Whether p lies inside the triangle a b c or on its boundary. The corners may run either way round.
pub fn in_triangle(p: Point, a: Point, b: Point, c: Point) -> bool {
    let _ = (p, a, b, c);
    todo!("in_triangle")
}

/// Task 4. Where d lies and the circle through a, b, c, which may run either way round: 1 inside, 0 on the circle,
/// -1 outside.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> i32 {
    let _ = (a, b, c, d);
    todo!("in_circle")
}

/// Task 5. The sign of the sum of these numbers, exactly: 1, 0 or -1. The sum of no numbers is 0.
pub fn sign_of_sum(numbers: &[f64]) -> i32 {
    let _ = numbers;
    // `two_sum` is given.
    let _ = two_sum;
    todo!("sign_of_sum")
}

/// Task 6. Which way p, q, r really turn: 1 left, -1 right, 0 if the three points are on one line.
pub fn orient2d_exact(p: Point, q: Point, r: Point) -> i32 {
    let _ = (p, q, r);
    // `two_product` is given.
    let _ = two_product;
    todo!("orient2d_exact")
}

/// Task 7. Which way p, q, r really turn, if doubles are sure of it; `None` if they are not.
pub fn filter(p: Point, q: Point, r: Point) -> Option<i32> {
    let _ = (p, q, r);
    todo!("filter")
}

/// Task 7. Which way p, q, r really turn: the filter, and the exact sign only where it is needed.
pub fn orient2d(p: Point, q: Point, r: Point) -> i32 {
    let _ = (p, q, r);
    todo!("orient2d")
}

/// Task 8. Colours the cells of the map where doubles are wrong: `turn` of the cell's point, Q and R is not `orient2d`.
pub fn wrong_signs(map: &mut Map) {
    // `map.point(column, row)`, `map.colour(column, row)`, `map::SIDE`, `map::Q` and `map::R` are given.
    let _ = (map, map::SIDE);
    todo!("wrong_signs")
}

// Here is room for functions of your own.
