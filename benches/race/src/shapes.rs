//! Polygons: closed lines, counter-clockwise.

use crate::Random;
use std::f64::consts::TAU;

/// A closed line.
pub type Ring = Vec<[f64; 2]>;

/// The line `radius(angle)` round a place.
pub fn round(corners: usize, centre: [f64; 2], radius: impl Fn(usize, f64) -> f64) -> Ring {
    let angle = |i: usize| i as f64 / corners as f64 * TAU;
    let at = |i: usize| {
        let (a, r) = (angle(i), radius(i, angle(i)));
        [centre[0] + r * a.cos(), centre[1] + r * a.sin()]
    };
    (0..corners).map(at).collect()
}

/// A ragged coast: halves of halves, each middle pushed in or out at random. `corners` is a power of 2.
pub fn coast(corners: usize, centre: [f64; 2], seed: u64) -> Ring {
    let mut random = Random::new(seed);
    let mut radii = vec![1.0_f64; corners];
    let (mut step, mut size) = (corners / 8, 0.2);
    while step > 1 {
        for i in (0..corners).step_by(step) {
            let (a, b) = (radii[i], radii[(i + step) % corners]);
            radii[i + step / 2] = (a + b) / 2.0 + size * (random.unit() - 0.5);
        }
        (step, size) = (step / 2, size * 0.55);
    }
    round(corners, centre, |i, _| radii[i])
}

/// Squares in rows, which do not touch.
pub fn squares(side: usize, offset: f64) -> Vec<Ring> {
    let square = |x: f64, y: f64| vec![[x, y], [x + 0.7, y + 0.01], [x + 0.69, y + 0.71], [x - 0.01, y + 0.7]];
    let at = |i: usize| square((i % side) as f64 + offset, (i / side) as f64 + offset * 1.1);
    (0..side * side).map(at).collect()
}

/// A star whose radius changes at random within a fifth.
pub fn ragged(corners: usize) -> Ring {
    let mut random = Random::new(5);
    let radii: Vec<f64> = (0..corners).map(|_| 1.0 - 0.2 * random.unit()).collect();
    round(corners, [0.0; 2], |i, _| radii[i])
}

/// A corridor that winds inwards.
pub fn spiral(corners: usize) -> Ring {
    let half = corners / 2;
    let turns = (half as f64 / 60.0).max(2.0);
    let at = |t: f64, gap: f64| {
        let (a, r) = (t * turns * TAU, 1.0 - 0.9 * t - gap * 0.4 / turns);
        [r * a.cos(), r * a.sin()]
    };
    let there = (0..half).map(|i| at(i as f64 / half as f64, 0.0));
    there.chain((0..half).rev().map(|i| at(i as f64 / half as f64, 1.0))).collect()
}
