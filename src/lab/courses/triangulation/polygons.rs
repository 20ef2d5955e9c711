//! The polygons that cases begin with, each counter-clockwise and without a side that meets another one.
//!
//! ```text
//!   arrow       a reflex corner         house, ladder   straight corners       comb      many reflex corners
//!   spiral      few ears                needle          corners nearly on one line, or on a diagonal
//!   level       a side on the line of a diagonal, beyond its end
//! ```

use crate::cases::random::Random;
use crate::cases::starts::{shorter, words};
use std::f64::consts::TAU;

/// The polygon of the handout, which has one triangulation only.
pub const DRAWING: [[f64; 2]; 17] = [
    [0.0, 0.0],
    [-40.0, 110.0],
    [-90.0, -80.0],
    [120.0, 0.0],
    [180.0, -100.0],
    [90.0, -140.0],
    [160.0, -210.0],
    [150.0, -170.0],
    [250.0, -30.0],
    [220.0, -80.0],
    [300.0, -20.0],
    [190.0, 10.0],
    [200.0, -40.0],
    [60.0, 100.0],
    [110.0, 110.0],
    [190.0, 90.0],
    [30.0, 180.0],
];

/// A polygon as it is typed.
pub(super) fn line(polygon: &[[f64; 2]]) -> String {
    format!("polygon{}", words(polygon.iter().flatten().map(|&x| shorter(x))))
}

/// Small polygons with whole coordinates, the simplest first.
pub(super) fn small() -> Vec<(&'static str, Vec<[f64; 2]>)> {
    let mut all: Vec<(&'static str, Vec<[f64; 2]>)> = [
        ("square", &[[0, 0], [4, 0], [4, 4], [0, 4]] as &[[i32; 2]]),
        ("arrow", &[[0, 0], [4, -3], [2, 0], [4, 3]]),
        ("pentagon", &[[0, 0], [4, -1], [6, 3], [3, 6], [-1, 4]]),
        ("house", &[[0, 0], [2, 0], [4, 0], [4, 4], [2, 6], [0, 4]]),
        ("flat", &[[0, 0], [2, 0], [4, 0], [6, 0], [3, 5]]),
        ("bay", &[[0, 0], [6, 0], [6, 4], [3, 1], [0, 4]]),
        ("touching", &[[0, 0], [8, 0], [8, 4], [4, 2], [0, 4]]),
        ("corner_on_diagonal", &[[0, 0], [6, 0], [6, 6], [3, 3], [0, 6]]),
        ("ell", &[[0, 0], [6, 0], [6, 2], [2, 2], [2, 6], [0, 6]]),
        ("tee", &[[2, 0], [4, 0], [4, 4], [6, 4], [6, 6], [0, 6], [0, 4], [2, 4]]),
        ("star", &[[5, 0], [2, 1], [2, 5], [-1, 2], [-4, 3], [-2, 0], [-4, -3], [-1, -2], [2, -5], [2, -1]]),
        ("ladder", &[[0, 0], [2, 0], [4, 0], [6, 0], [8, 0], [8, 3], [6, 3], [4, 3], [2, 3], [0, 3]]),
        ("funnel", &[[0, 9], [-6, -1], [-3, 2], [0, 3], [3, 2], [6, -1]]),
        ("level", &[[0, 0], [8, 0], [8, 2], [6, 2], [5, 1], [4, 2], [3, 4], [2, 2]]),
    ]
    .into_iter()
    .map(|(name, places)| (name, places.iter().map(|p| p.map(f64::from)).collect()))
    .collect();
    all.extend([("comb", comb(3)), ("spiral", spiral(2)), ("drawing", DRAWING.to_vec())]);
    all
}

/// A comb with so many teeth, upwards: four corners a tooth.
pub(super) fn comb(teeth: usize) -> Vec<[f64; 2]> {
    let right = 4.0 * teeth as f64;
    let mut polygon = vec![[0.0, 0.0], [right, 0.0]];
    for tooth in (0..teeth).rev() {
        let x = 4.0 * tooth as f64;
        polygon.extend([[x + 4.0, 9.0], [x + 3.0, 10.0], [x + 1.0, 1.0]]);
    }
    polygon.push([0.0, 8.0]);
    polygon
}

/// A corridor of right angles that goes round and round so many times, inwards.
pub(super) fn spiral(turns: usize) -> Vec<[f64; 2]> {
    let mut outer = Vec::new();
    let mut inner = Vec::new();
    for turn in 0..turns {
        let (a, b) = (4.0 * turn as f64, 4.0 * (2 * turns) as f64 - 4.0 * turn as f64);
        // The corridor comes from the left, first along the wall and then along the outer turn.
        let [begin, inside] = if turn == 0 { [a, a] } else { [a - 4.0, a - 2.0] };
        outer.extend([[begin, a], [b, a], [b, b], [a, b]]);
        inner.extend([[inside, a + 2.0], [b - 2.0, a + 2.0], [b - 2.0, b - 2.0], [a + 2.0, b - 2.0]]);
    }
    let end = 4.0 * turns as f64;
    outer.push([end - 4.0, end]);
    inner.push([end - 2.0, end]);
    inner.reverse();
    outer.extend(inner);
    outer
}

/// Places on a circle, cut to whole numbers far apart: a star-shaped polygon round the origin.
pub(super) fn random_star(random: &mut Random, corners: usize) -> Vec<[f64; 2]> {
    let unit = |random: &mut Random| (random.bits() >> 11) as f64 / (1u64 << 53) as f64;
    (0..corners)
        .map(|i| {
            let angle = TAU * (i as f64 + 0.8 * unit(random)) / corners as f64;
            let radius = 1000.0 * (0.15 + 0.85 * unit(random));
            [(radius * angle.cos()).round(), (radius * angle.sin()).round()]
        })
        .collect()
}

/// Polygons where doubles go wrong: corners nearly on a diagonal, all digits, very small and very large.
pub(super) fn rounding() -> Vec<(&'static str, Vec<[f64; 2]>)> {
    let ulp = f64::EPSILON / 2.0;
    let bay = |depth: [f64; 2]| vec![[0.1, 0.1], [0.9, 0.1], [0.7, 0.7], depth];
    let moved = |polygon: &[[f64; 2]], size: f64, far: f64| {
        polygon.iter().map(|p| p.map(|x| x * size + far)).collect::<Vec<_>>()
    };
    let star = small().into_iter().find(|(name, _)| *name == "star").map(|(_, polygon)| polygon).unwrap_or_default();
    vec![
        ("just_reflex", vec![[0.0, 0.0], [24.0, 0.0], [24.0, 24.0], [0.5 + 8.0 * ulp, 0.5 + 9.0 * ulp]]),
        ("just_convex", vec![[0.0, 0.0], [24.0, 24.0], [0.5 + 9.0 * ulp, 0.5 + 12.0 * ulp], [-3.0, 24.0]]),
        (
            "nearly_on_it",
            vec![[12.0, 12.0], [24.0, 0.0], [24.0, 24.0], [9.0, 30.0], [0.5 + 17.0 * ulp, 0.5 + 17.0 * ulp]],
        ),
        ("tenths", bay([0.3, 0.3 + 0.1])),
        ("tenths_on_it", bay([0.2, 0.2 + ulp])),
        ("tiny", moved(&star, 1e-30, 0.0)),
        ("huge", moved(&star, 1e15 / 8.0, 0.1)),
        ("far", moved(&star, 0.25, 1e9)),
    ]
}
