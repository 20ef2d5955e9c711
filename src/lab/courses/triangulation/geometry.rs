//! Diagonals, ears and triangles of polygons given by their places; every decision is exact.

use dcel_kit::plane::{Point, predicates};
use std::cmp::Ordering;

/// Which way three places turn: 1 left, -1 right.
#[must_use]
pub fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> i32 {
    let [p, q, r] = [p, q, r].map(|[x, y]| Point::new(x, y));
    predicates::orientation(p, q, r) as i32
}

/// Whether a place is on a line segment, its ends included.
#[must_use]
pub fn on_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> bool {
    let between = |i: usize| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]);
    between(0) && between(1) && turn(a, b, p) == 0
}

/// Whether two segments meet inside of both.
#[must_use]
pub fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
}

dcel_kit::named! {
    /// What is wrong with a line between two corners of a polygon as a diagonal.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Diagonal {
        /// Nothing.
        Yes = "the line between the two corners lies inside and touches nothing",
        /// Both are the same corner.
        Same = "both are the same corner",
        /// They are neighbours.
        Side = "it is a side of the polygon",
        /// It begins outside of the polygon.
        Outside = "it begins outside of the polygon",
        /// Another corner lies on it.
        Touches = "another corner lies on the line between the two",
        /// It crosses a side.
        Crosses = "it crosses a side",
    }

    /// The reason, as the end of a sentence.
    fn because;
}

/// Whether the line between the corners i and j of a polygon is a diagonal.
#[must_use]
pub fn diagonal(polygon: &[[f64; 2]], i: usize, j: usize) -> Diagonal {
    let n = polygon.len();
    if i == j {
        return Diagonal::Same;
    }
    if (i + 1) % n == j || (j + 1) % n == i {
        return Diagonal::Side;
    }
    let (a, b) = (polygon[i], polygon[j]);
    let (before, after) = (polygon[(i + n - 1) % n], polygon[(i + 1) % n]);
    let (one, other) = (turn(a, after, b), turn(before, a, b));
    let begins_inside = if turn(before, a, after) >= 0 { one > 0 && other > 0 } else { one > 0 || other > 0 };
    if !begins_inside {
        return Diagonal::Outside;
    }
    let others = (0..n).filter(|k| ![i, j].contains(k));
    if others.clone().any(|k| on_segment(polygon[k], a, b)) {
        return Diagonal::Touches;
    }
    let crosses = |k: usize| cross([a, b], [polygon[k], polygon[(k + 1) % n]]);
    if others.filter(|k| ![i, j].contains(&((k + 1) % n))).any(crosses) { Diagonal::Crosses } else { Diagonal::Yes }
}

/// Whether a corner is an ear of a polygon of at least four corners.
#[must_use]
pub fn ear(polygon: &[[f64; 2]], i: usize) -> Diagonal {
    let n = polygon.len();
    diagonal(polygon, (i + n - 1) % n, (i + 1) % n)
}

/// A triangulation of a polygon, as corners by number, by cutting off ears.
#[must_use]
pub fn triangles(polygon: &[[f64; 2]]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..polygon.len()).collect();
    let mut out = Vec::new();
    while left.len() > 3 {
        let places: Vec<[f64; 2]> = left.iter().map(|&k| polygon[k]).collect();
        let Some(i) = (0..left.len()).find(|&i| ear(&places, i) == Diagonal::Yes) else { return out };
        let n = left.len();
        out.push([left[(i + n - 1) % n], left[i], left[(i + 1) % n]]);
        left.remove(i);
    }
    out.extend(<[usize; 3]>::try_from(left));
    out
}

/// How often the boundary of a polygon goes round a place that is not on it, counter-clockwise: 1 inside, 0 outside.
#[must_use]
pub fn winding(polygon: &[[f64; 2]], p: [f64; 2]) -> i32 {
    let n = polygon.len();
    let sides = (0..n).map(|k| (polygon[k], polygon[(k + 1) % n]));
    sides
        .map(|(a, b)| match (a[1].total_cmp(&p[1]), b[1].total_cmp(&p[1])) {
            (Ordering::Less | Ordering::Equal, Ordering::Greater) => i32::from(turn(a, b, p) > 0),
            (Ordering::Greater, Ordering::Less | Ordering::Equal) => -i32::from(turn(a, b, p) < 0),
            _ => 0,
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::triangulation::polygons::small;

    /// A line that meets the boundary at its two ends only is a diagonal if its middle is inside.
    #[test]
    fn diagonals_agree_with_the_place_of_their_middle() {
        let mut kinds = [0; 2];
        for (name, polygon) in small() {
            let n = polygon.len();
            for (i, j) in (0..n * n).map(|k| (k / n, k % n)).filter(|(i, j)| i != j) {
                let (a, b) = (polygon[i], polygon[j]);
                let free = (0..n).all(|k| {
                    let (c, d) = (polygon[k], polygon[(k + 1) % n]);
                    let ends = [i, j].contains(&k) || [i, j].contains(&((k + 1) % n));
                    let crossing = turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
                    ([i, j].contains(&k) || !on_segment(c, a, b)) && (ends || !crossing || turn(a, b, c) == 0)
                });
                let side = (i + 1) % n == j || (j + 1) % n == i;
                // Twice as large, the middle has whole coordinates.
                let large: Vec<[f64; 2]> = polygon.iter().map(|p| p.map(|x| 2.0 * x)).collect();
                let middle = [a[0] + b[0], a[1] + b[1]];
                let expected = free && !side && winding(&large, middle) == 1;
                assert_eq!(diagonal(&polygon, i, j) == Diagonal::Yes, expected, "{name}: {i} {j}");
                kinds[usize::from(expected)] += 1;
            }
        }
        assert!(kinds.iter().all(|&count| count > 100), "{kinds:?}");
    }

    #[test]
    fn all_polygons_are_simple_and_have_triangulations() {
        let twice = |polygon: &[[f64; 2]]| -> f64 {
            let n = polygon.len();
            (0..n).map(|k| polygon[k][0] * polygon[(k + 1) % n][1] - polygon[k][1] * polygon[(k + 1) % n][0]).sum()
        };
        for (name, polygon) in small() {
            let triangles = triangles(&polygon);
            assert_eq!(triangles.len(), polygon.len() - 2, "{name}");
            let parts: f64 = triangles.iter().map(|t| twice(&t.map(|k| polygon[k]))).sum();
            assert!(parts > 0.0 && (parts - twice(&polygon)).abs() < 1e-6, "{name}");
            assert!(triangles.iter().all(|t| twice(&t.map(|k| polygon[k])) > 0.0), "{name}");
        }
    }
}
