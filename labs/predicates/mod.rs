//! On which side of a line, in or out of a circle: answers that are always right.
//!
//! ```text
//!            ● c   Left                     Inside: d lies in the circle through a, b, c,
//!   a ──────────▶ b   Straight              which turn left
//!            ● c   Right
//! ```
//!
//! Mostly doubles are good enough: the result is clearly above or below 0, by more than rounding can have changed. If it
//! is not, the same is computed once more with whole numbers, which are never rounded. A double is a whole number times
//! a power of two, so after scaling all coordinates by one power of two they are whole numbers. This takes longer, and
//! is needed seldom.

// A lab uses the parts that it needs.
#![allow(dead_code)]

mod whole;

use whole::Whole;

/// Where c lies, for somebody who goes from a to b.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Turn {
    /// On the left: a, b, c run counter-clockwise.
    Left,
    /// On the right: a, b, c run clockwise.
    Right,
    /// On the line through a and b; also if two of the points are equal.
    Straight,
}

/// Where a point lies, compared with a circle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InCircle {
    /// In it.
    Inside,
    /// On it.
    On,
    /// Out of it.
    Outside,
}

/// Up to this size whole numbers are computed with in one step.
const FOR_A_TURN: f64 = 9_007_199_254_740_992.0;
const FOR_A_CIRCLE: f64 = 268_435_456.0;
/// Below this, products of doubles may have lost digits that no bound accounts for.
const TINY: f64 = 1e-290;

/// Which way the path a, b, c turns at b. Always right.
pub fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Turn {
    let up = (b[0] - a[0]) * (c[1] - a[1]);
    let down = (b[1] - a[1]) * (c[0] - a[0]);
    let doubt = 4e-16 * (up.abs() + down.abs()) + TINY;
    let clear = up - down;
    if clear > doubt {
        return Turn::Left;
    }
    if clear < -doubt {
        return Turn::Right;
    }
    let places = [a, b, c];
    let sign = match small(&places, FOR_A_TURN) {
        Some(places) => {
            let [u, v] = [from(places[0], places[1]), from(places[0], places[2])];
            (u[0] * v[1] - u[1] * v[0]).signum() as i32
        }
        None => {
            let places = scaled(&places);
            let u = away(&places[0], &places[1]);
            let v = away(&places[0], &places[2]);
            u[0].times(&v[1]).minus(&u[1].times(&v[0])).sign()
        }
    };
    match sign {
        1 => Turn::Left,
        -1 => Turn::Right,
        _ => Turn::Straight,
    }
}

/// Where d lies, compared with the circle through a, b, c, which must turn left. Always right.
pub fn in_circle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> InCircle {
    let places = [d, a, b, c];
    let sign = match clear_of_circle(a, b, c, d) {
        Some(sign) => sign,
        None => match small(&places, FOR_A_CIRCLE) {
            Some(places) => {
                let [u, v, w] = [1, 2, 3].map(|i| from(places[0], places[i]));
                let size = |p: [i128; 2]| p[0] * p[0] + p[1] * p[1];
                let cross = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - p[1] * q[0];
                (size(u) * cross(v, w) + size(v) * cross(w, u) + size(w) * cross(u, v)).signum() as i32
            }
            None => {
                let places = scaled(&places);
                let [u, v, w] = [1, 2, 3].map(|i| away(&places[0], &places[i]));
                let size = |p: &[Whole; 2]| p[0].times(&p[0]).plus(&p[1].times(&p[1]));
                let cross = |p: &[Whole; 2], q: &[Whole; 2]| p[0].times(&q[1]).minus(&p[1].times(&q[0]));
                let sum = size(&u).times(&cross(&v, &w)).plus(&size(&v).times(&cross(&w, &u)));
                sum.plus(&size(&w).times(&cross(&u, &v))).sign()
            }
        },
    };
    match sign {
        1 => InCircle::Inside,
        -1 => InCircle::Outside,
        _ => InCircle::On,
    }
}

/// The sign of the determinant, if doubles are sure of it.
fn clear_of_circle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Option<i32> {
    let [u, v, w] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]]);
    let (mut sum, mut sizes) = (0.0, 0.0);
    for (p, q, r) in [(u, v, w), (v, w, u), (w, u, v)] {
        let size = p[0] * p[0] + p[1] * p[1];
        let (up, down) = (q[0] * r[1], q[1] * r[0]);
        sum += size * (up - down);
        sizes += size * (up.abs() + down.abs());
    }
    let doubt = 2e-15 * sizes + TINY;
    if sum > doubt {
        Some(1)
    } else if sum < -doubt {
        Some(-1)
    } else {
        None
    }
}

/// The coordinates as whole numbers, if they are whole and at most `largest`.
fn small<const N: usize>(places: &[[f64; 2]; N], largest: f64) -> Option<[[i128; 2]; N]> {
    let is_small = |x: &f64| x.fract() == 0.0 && x.abs() <= largest;
    places.iter().flatten().all(is_small).then(|| places.map(|place| place.map(|x| x as i128)))
}

fn from(p: [i128; 2], q: [i128; 2]) -> [i128; 2] {
    [q[0] - p[0], q[1] - p[1]]
}

/// The coordinates, all times the same power of two, so that they are whole numbers.
fn scaled<const N: usize>(places: &[[f64; 2]; N]) -> [[Whole; 2]; N] {
    let lowest = places.iter().flatten().filter(|x| **x != 0.0).map(|x| whole::power(*x)).min().unwrap_or(0);
    places.map(|place| place.map(|x| Whole::scaled(x, lowest)))
}

fn away(p: &[Whole; 2], q: &[Whole; 2]) -> [Whole; 2] {
    [q[0].minus(&p[0]), q[1].minus(&p[1])]
}
