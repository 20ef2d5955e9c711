//! Which of two points is higher, as seen along a direction, without rounding.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::{Place, Point};
use std::cmp::Ordering;

/// Whether `a` is higher than `b` in the direction `d` (`Greater`), lower (`Less`), or neither (`Equal`): compares the
/// dot products d·a and d·b. Exact for numbers that are 0 or between 1e-60 and 1e60 in size.
pub fn higher(d: Place, a: Place, b: Place) -> Ordering {
    // The sum of all parts of the six products. They do not overlap, so the last one that is not 0 has its sign.
    let mut parts: Vec<f64> = Vec::new();
    for i in 0..3 {
        for (x, y) in [(d[i], a[i]), (-d[i], b[i])] {
            let product = x * y;
            add(&mut parts, x.mul_add(y, -product));
            add(&mut parts, product);
        }
    }
    let last = parts.iter().rev().find(|&&part| part != 0.0);
    last.map_or(Ordering::Equal, |part| part.total_cmp(&0.0))
}

fn add(parts: &mut Vec<f64>, number: f64) {
    let mut sum = number;
    for part in parts.iter_mut() {
        let new = sum + *part;
        let back = new - sum;
        *part = (sum - (new - back)) + (*part - back);
        sum = new;
    }
    parts.push(sum);
}

/// Where a point of space is in a picture: x to the right, z upwards, y backwards, which is drawn to the right and
/// upwards at half of its length.
pub fn projected([x, y, z]: Place) -> Point {
    Point { x: x + 0.5 * y, y: z + 0.25 * y }
}
