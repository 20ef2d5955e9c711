//! The points and numbers that cases are made of.

use super::map;
use crate::cases::random::Random;
use crate::cases::starts::{shorter, words};

/// A call as it is typed: its word, then numbers, each in its shorter form.
pub(super) fn line(word: &str, numbers: impl IntoIterator<Item = f64>) -> String {
    format!("{word}{}", words(numbers.into_iter().map(shorter)))
}

/// A call for points.
pub(super) fn of_points(word: &str, points: &[[f64; 2]]) -> String {
    line(word, points.iter().flatten().copied())
}

/// Three points of whole coordinates, in every direction; the first of them is not where the coordinates begin.
pub(super) const PLAIN: [[[f64; 2]; 3]; 12] = [
    [[0.0, 0.0], [4.0, 0.0], [3.0, 3.0]],
    [[0.0, 0.0], [3.0, 3.0], [4.0, 0.0]],
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    [[2.0, 1.0], [5.0, 2.0], [3.0, 6.0]],
    [[2.0, 1.0], [3.0, 6.0], [5.0, 2.0]],
    [[-3.0, 2.0], [-1.0, -4.0], [6.0, -2.0]],
    [[1.0, 1.0], [3.0, 2.0], [5.0, 3.0]],
    [[5.0, 3.0], [1.0, 1.0], [3.0, 2.0]],
    [[4.0, 4.0], [1.0, 1.0], [-2.0, -2.0]],
    [[2.0, 5.0], [2.0, 1.0], [2.0, 9.0]],
    [[7.0, 3.0], [7.0, 3.0], [1.0, 2.0]],
    [[1.5, 0.25], [-2.5, 4.75], [0.5, -8.0]],
];

/// Far from the origin, and close to each other: products of the coordinates themselves have lost everything.
pub(super) const FAR: [[[f64; 2]; 3]; 5] = [
    [[1e9, 1e9], [1_000_000_001.0, 1e9], [1e9, 1_000_000_001.0]],
    [[1e9, -1e9], [1_000_000_003.0, -999_999_999.0], [1_000_000_001.0, -999_999_998.0]],
    [[-4e8, 3e9], [-399_999_998.0, 3_000_000_005.0], [-399_999_999.0, 3_000_000_001.0]],
    [
        [1e15, 1e15],
        [1_000_000_000_000_002.0, 1_000_000_000_000_001.0],
        [1_000_000_000_000_001.0, 1_000_000_000_000_003.0],
    ],
    [[123_456_789.5, 987_654_321.25], [123_456_790.25, 987_654_321.5], [123_456_789.75, 987_654_322.0]],
];

/// Points on, or as good as on, one line; where rounding matters.
pub(super) fn nearly_collinear() -> Vec<[[f64; 2]; 3]> {
    let ulp = f64::EPSILON / 2.0;
    let at = |i: f64, j: f64| [0.5 + i * ulp, 0.5 + j * ulp];
    let (q, r) = ([12.0, 12.0], [24.0, 24.0]);
    let mut all = vec![
        [[0.1, 0.1], [0.2, 0.2], [0.3, 0.3]],
        [[0.1, 0.3], [0.2, 0.6], [0.3, 0.9]],
        [[0.0, 0.0], [0.1, 0.7], [0.3, 2.1]],
        [[1e-30, 1e-30], [1.0, 1.0], [1e15, 1e15]],
        [[1e-30, 2e-30], [1.0, 1.0], [1e15, 1e15]],
        [[2e-30, 1e-30], [1.0, 1.0], [1e15, 1e15]],
        [[0.0, 1e-30], [1e15, 1e15], [-1e15, -1e15]],
        [[1e15, 1e15 + 0.125], [1.0, 1.0], [3.0, 3.0]],
        [[1.0 / 3.0, 2.0 / 3.0], [2.0 / 3.0, 4.0 / 3.0], [1.0, 2.0]],
        [[1e-20, 0.0], [1.0, 1e20], [2.0, 2e20]],
        [[0.0, 0.0], [1e-8, 0.0], [0.0, 1e-8]],
        [[1e-7, 0.0], [0.0, 3e-7], [-1e-7, -2e-7]],
        [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0 + 1e-10]],
        [[3.0, 5.0], [1.0, 1.0], [-1.0, -3.0 + 1e-10]],
    ];
    for sign in [1, -1] {
        // Where doubles take one side for the other.
        let wrong = map::wrong_cells().into_iter().map(map::point);
        let turned = wrong.map(|p| [p, map::Q, map::R]).filter(|&[p, q, r]| map::naive(p, q, r) == sign);
        all.extend(turned.step_by(3).take(4));
    }
    for (i, j) in
        [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (3.0, 5.0), (5.0, 3.0), (17.0, 40.0), (40.0, 17.0), (100.0, 99.0)]
    {
        all.extend([[at(i, j), q, r], [q, r, at(i, j)], [r, q, at(i, j)]]);
    }
    all
}

/// Three points of which the last one is nearly on the line of the others.
pub(super) fn random_nearly(random: &mut Random) -> [[f64; 2]; 3] {
    let scale = [1.0, 1.0, 100.0, 1e-30, 1e15][random.below(5)];
    let mut unit = || (random.bits() >> 11) as f64 / (1u64 << 53) as f64;
    let p = [scale * (unit() - 0.5), scale * (unit() - 0.5)];
    let q = [scale * (unit() - 0.5), scale * (unit() - 0.5)];
    let t = 4.0 * unit() - 2.0;
    [p, q, [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]]
}

/// So many points with small whole coordinates.
pub(super) fn random_whole<const N: usize>(random: &mut Random, size: usize) -> [[f64; 2]; N] {
    [(); N].map(|()| [(); 2].map(|()| random.below(2 * size + 1) as f64 - size as f64))
}

/// Lists of numbers whose sums a double gets wrong, and some that it gets right; the short ones first.
pub(super) fn sums() -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = [
        &[2.0, 1.0] as &[f64],
        &[1.0, -3.0],
        &[5.0, -5.0],
        &[0.0],
        &[-7.5],
        &[],
        &[1e16, 1.0, -1e16],
        &[1e16, -1.0, -1e16],
        &[1e16, 1.0, -1e16, -1.0],
        &[0.1, 0.2, -0.3],
        &[-0.1, -0.2, 0.3],
        &[1e15, 1e-30, -1e15],
        &[1e-30, -1e15, 1e15],
        &[1.0, 1e-30, -1e-30, -1.0],
        &[1e15, 1.0, 1e-30, -1.0, -1e15],
        &[1e15, 1.0, -1e-30, -1.0, -1e15],
        &[1e30, 1.0, 1e-30, -1e30, -1.0],
        &[1e30, 1.0, -1e-30, -1.0, -1e30],
        &[-1.0, 1e-20, 1e20, 1.0, -1e20],
    ]
    .map(<[f64]>::to_vec)
    .into();
    let ulp = f64::EPSILON / 2.0;
    for set in [[1e16, 1.0, -1e16, -2.0], [1.0, ulp, -1.0, -0.5 * ulp], [1e15, 1e-15, -1e15, -1e-16]] {
        all.extend(orders(&set));
    }
    all
}

/// A list in every order.
fn orders(list: &[f64]) -> Vec<Vec<f64>> {
    if list.is_empty() {
        return vec![Vec::new()];
    }
    let mut out = Vec::new();
    for i in 0..list.len() {
        let mut rest = list.to_vec();
        let first = rest.remove(i);
        out.extend(orders(&rest).into_iter().map(|order| [vec![first], order].concat()));
    }
    out
}

/// Numbers of every size with their opposites in some order, and one small number that decides; sometimes none.
pub(super) fn random_sum(random: &mut Random, pairs: usize) -> Vec<f64> {
    let mut numbers = Vec::<f64>::with_capacity(3 * pairs + 1);
    for _ in 0..pairs {
        let x = (random.bits() >> 11) as f64 * 2f64.powi(random.below(500) as i32 - 250);
        // In two parts, which may not be those of the double.
        let part = x * ((random.bits() >> 40) as f64 / (1 << 24) as f64);
        let rest = x - part;
        numbers.extend([x, -part, -rest]);
    }
    numbers.push([1e-99, -1e-99, 0.0][random.below(3)]);
    let order = random.order(numbers.len());
    order.into_iter().map(|i| numbers[i]).collect()
}
