//! Which way three points turn, without rounding: the reference version of what lab 01 is about.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::Point;

/// Which way the points a, b, c turn.
///
/// ```text
///                  ● c  Left: c lies on the left of the line from a to b
///
///   a ●──────▶● b     ● c  Straight: c lies on the line
///
///                  ● c  Right
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Turn {
    /// Counter-clockwise.
    Left,
    /// All three on one line. Two of them may be equal.
    Straight,
    /// Clockwise.
    Right,
}

/// Which way a, b, c turn. Right for all coordinates up to 1e60 that are 0 or not nearer to 0 than 1e-42.
pub fn turn(a: Point, b: Point, c: Point) -> Turn {
    let (one, other) = ((a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x));
    // What rounding may have changed is smaller than this; mostly the difference is clear.
    let doubt = 4e-16 * (one.abs() + other.abs());
    if one - other > doubt {
        Turn::Left
    } else if other - one > doubt {
        Turn::Right
    } else {
        exact(a, b, c)
    }
}

/// The same from the sum of six products, each of them and their sum kept without rounding.
fn exact(a: Point, b: Point, c: Point) -> Turn {
    let products = [(a.x, b.y), (-a.y, b.x), (b.x, c.y), (-b.y, c.x), (c.x, a.y), (-c.y, a.x)];
    // The sum is that of all parts. They do not overlap, so the last one that is not 0 has its sign.
    let mut parts: Vec<f64> = Vec::new();
    for (x, y) in products {
        let product = x * y;
        add(&mut parts, x.mul_add(y, -product));
        add(&mut parts, product);
    }
    match parts.iter().rev().find(|&&part| part != 0.0) {
        Some(&part) if part > 0.0 => Turn::Left,
        Some(_) => Turn::Right,
        None => Turn::Straight,
    }
}

fn add(parts: &mut Vec<f64>, number: f64) {
    let mut sum = number;
    for part in parts.iter_mut() {
        let new = sum + *part;
        // What the rounding of the sum has lost.
        let back = new - sum;
        *part = (sum - (new - back)) + (*part - back);
        sum = new;
    }
    parts.push(sum);
}
