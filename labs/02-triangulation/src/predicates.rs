//! The predicates of lab 01, exact.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::point::Point;

/// Which way p, q, r turn: 1 left, -1 right, 0 if they are on one line. Never wrong.
pub fn orient2d(p: Point, q: Point, r: Point) -> i32 {
    let left = (q.x - p.x) * (r.y - p.y);
    let right = (q.y - p.y) * (r.x - p.x);
    if (left - right).abs() > 1e-15 * (left.abs() + right.abs()) {
        return compared(left, right);
    }
    // The formula multiplied out, with what each product is missing; added up without any loss.
    let mut exact = Vec::new();
    for (a, b) in [(q.x, r.y), (r.x, p.y), (p.x, q.y)] {
        add_product(&mut exact, a, b);
    }
    for (a, b) in [(q.y, r.x), (r.y, p.x), (p.y, q.x)] {
        add_product(&mut exact, -a, b);
    }
    exact.iter().rev().find(|part| **part != 0.0).map_or(0, |largest| compared(*largest, 0.0))
}

/// Whether p lies on the line segment from a to b, its ends included.
pub fn on_segment(p: Point, a: Point, b: Point) -> bool {
    let between = |x: f64, a: f64, b: f64| a.min(b) <= x && x <= a.max(b);
    between(p.x, a.x, b.x) && between(p.y, a.y, b.y) && orient2d(a, b, p) == 0
}

fn compared(x: f64, y: f64) -> i32 {
    i32::from(x > y) - i32::from(x < y)
}

fn add_product(exact: &mut Vec<f64>, a: f64, b: f64) {
    let product = a * b;
    for number in [a.mul_add(b, -product), product] {
        let mut x = number;
        for part in exact.iter_mut() {
            let total = x + *part;
            let of_part = total - x;
            *part = (x - (total - of_part)) + (*part - of_part);
            x = total;
        }
        exact.push(x);
    }
}
