//! What is right of each answer: by exact arithmetic, and never by the solution.

use super::map::naive;
use super::sum;
use crate::answers::{Function, Wrong};
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::{Point, predicates};
use std::cmp::Ordering;

/// All functions of the lab.
pub(super) const FUNCTIONS: &[Function] = &[
    Function {
        word: "parallelogram_area",
        test: "parallelogram_area",
        wrong: |exchange, found| area(exchange, found, 1.0),
    },
    Function { word: "triangle_area", test: "triangle_area", wrong: |exchange, found| area(exchange, found, 0.5) },
    Function { word: "turn", test: "turn", wrong: turn },
    Function { word: "in_triangle", test: "in_triangle", wrong: triangle },
    Function { word: "in_circle", test: "in_circle", wrong: circle },
    Function { word: "sign_of_sum", test: "sign_of_sum", wrong: sum_of },
    Function { word: "orient2d_exact", test: "orient2d_exact", wrong: exact },
    Function { word: "filter", test: "filter", wrong: filter },
    Function { word: "orient2d", test: "orient2d", wrong: exact },
];

/// How far an area may be from the true one, in parts of the sum of the two products.
pub(super) const TOLERANCE: f64 = 1e-15;
/// Where doubles are this sure, in parts of the sum of the two products, a filter must be sure, too.
pub(super) const SURE: f64 = 2e-15;

/// The points that a call was made for.
pub(super) fn points<const N: usize>(exchange: &Exchange) -> Option<[[f64; 2]; N]> {
    let numbers = exchange.numbers();
    let points: Vec<[f64; 2]> = numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
    points.try_into().ok()
}

/// Which way three points turn, exactly.
pub(super) fn orientation(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> i32 {
    let [p, q, r] = [p, q, r].map(|[x, y]| Point::new(x, y));
    predicates::orientation(p, q, r) as i32
}

/// The two products of which the area is the difference, in doubles.
pub(super) fn products([px, py]: [f64; 2], [qx, qy]: [f64; 2], [rx, ry]: [f64; 2]) -> [f64; 2] {
    [(qx - px) * (ry - py), (qy - py) * (rx - px)]
}

/// Whether rounding can hardly change the area: it is 0, or much larger than that.
pub(super) fn is_clear([p, q, r]: [[f64; 2]; 3]) -> bool {
    let [one, other] = products(p, q, r);
    orientation(p, q, r) == 0 || (one - other).abs() > 1e-12 * (one.abs() + other.abs())
}

/// The area from products of the coordinates themselves.
pub(super) fn apart([px, py]: [f64; 2], [qx, qy]: [f64; 2], [rx, ry]: [f64; 2]) -> f64 {
    px * qy - py * qx + qx * ry - qy * rx + rx * py - ry * px
}

/// Where p lies: 1 inside the triangle, 0 on its boundary, -1 outside.
pub(super) fn place_in_triangle(p: [f64; 2], corners: [[f64; 2]; 3]) -> i32 {
    let [a, b, c] = corners;
    let way = orientation(a, b, c);
    [(a, b), (b, c), (c, a)].map(|(from, to)| way * orientation(from, to, p)).into_iter().min().unwrap_or(0)
}

/// Where d lies: 1 inside the circle, 0 on it, -1 outside.
pub(super) fn place_in_circle([a, b, c, d]: [[f64; 2]; 4]) -> i32 {
    let [p, q, r, d] = [a, b, c, d].map(|[x, y]| Point::new(x, y));
    let inside = match orientation(a, b, c) {
        -1 => predicates::in_circle(p, r, q, d),
        _ => predicates::in_circle(p, q, r, d),
    };
    inside as i32
}

fn area(exchange: &Exchange, found: &[Value], part: f64) -> Option<Wrong> {
    let [p, q, r] = points(exchange)?;
    let [Value::Number(found)] = *found else { return Some(Wrong::kind("one number")) };
    let of = |[x, y]: [f64; 2]| Point::new(x, y);
    let expected = part * predicates::twice_area(of(p), of(q), of(r));
    let [one, other] = products(p, q, r);
    let may_differ = TOLERANCE * (one.abs() + other.abs());
    if (found - expected).abs() <= may_differ {
        return None;
    }
    let is = |x: f64| (found - x).abs() <= may_differ;
    Some(Wrong::value(&Value::Number(expected), way(orientation(p, q, r))).is([
        (expected.abs() > 0.0 && is(-expected), "the opposite of the area"),
        (expected.abs() > 0.0 && is(expected.abs()), "the area without its sign"),
        (expected.abs() > 0.0 && is(2.0 * expected), "twice the area"),
        (expected.abs() > 0.0 && is(0.5 * expected), "half the area"),
        (is(part * (one + other)), "the sum of the two products, not their difference"),
        (
            same(found, part * apart(p, q, r)),
            "what comes of products of the coordinates themselves, whose roundings are large",
        ),
    ]))
}

/// Whether two numbers are the same; what a student's function gives may be NaN.
fn same(x: f64, y: f64) -> bool {
    x.partial_cmp(&y) == Some(Ordering::Equal)
}

/// What is wrong with a sign that was given back; `others` are further things that a wrong one may be.
fn sign<const N: usize>(
    found: &[Value],
    expected: i32,
    because: &str,
    others: impl Fn(f64) -> [(bool, &'static str); N],
) -> Option<Wrong> {
    let [Value::Number(found)] = *found else { return Some(Wrong::kind("one sign")) };
    let all = [
        (expected != 0 && same(found, f64::from(-expected)), "the opposite sign"),
        (same(found, 1.0), "always 1"),
        (same(found, -1.0), "always -1"),
        (same(found, 0.0), "always 0"),
        (found.abs() > 1.0, "a number that is no sign"),
    ];
    let expected = f64::from(expected);
    let wrong = || Wrong::value(&Value::Number(expected), because).is(others(found)).is(all);
    (!same(found, expected)).then(wrong)
}

fn way(sign: i32) -> &'static str {
    match sign {
        1 => "the points turn left",
        -1 => "the points turn right",
        _ => "the points are on one line",
    }
}

fn turn(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let [p, q, r] = points(exchange)?;
    let (expected, truth) = (naive(p, q, r), orientation(p, q, r));
    let because = if expected == truth {
        way(expected)
    } else {
        "that is what the formula of the handout gives in doubles, here wrongly; `turn` is that formula"
    };
    let is_true = |found| [(expected != truth && same(found, f64::from(truth)), "the true sign")];
    sign(found, expected, because, is_true)
}

fn exact(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let [p, q, r] = points(exchange)?;
    let (expected, doubles) = (orientation(p, q, r), naive(p, q, r));
    let in_doubles = |found| doubles != expected && same(found, f64::from(doubles));
    sign(found, expected, way(expected), |found| [(in_doubles(found), "the sign that the formula has in doubles")])
}

fn triangle(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let [p, a, b, c] = points(exchange)?;
    let [Value::Truth(found)] = *found else { return Some(Wrong::kind("yes or no")) };
    let place = place_in_triangle(p, [a, b, c]);
    let because = match place {
        1 => "the point is inside",
        0 if [a, b, c].contains(&p) => "the point is a corner, and the boundary counts",
        0 => "the point is on a side, and the boundary counts",
        _ => "the point is outside",
    };
    (found != (place >= 0)).then(|| Wrong::value(&Value::Truth(!found), because))
}

fn circle(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let expected = place_in_circle(points(exchange)?);
    let because = match expected {
        1 => "the fourth point is inside",
        0 => "the four points are on one circle",
        _ => "the fourth point is outside",
    };
    sign(found, expected, because, |_| [])
}

fn sum_of(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let numbers = exchange.numbers();
    let expected = sum::sign_of(&numbers);
    let because = match expected {
        1 => "the sum is above zero",
        -1 => "the sum is below zero",
        _ => "the sum is zero",
    };
    let is_sign_of = |found, x: f64| same(found, f64::from(x.partial_cmp(&0.0).unwrap_or(Ordering::Equal) as i32));
    let largest = numbers.iter().copied().fold(0.0, |most: f64, x| if x.abs() > most.abs() { x } else { most });
    let last = numbers.last().copied().unwrap_or_default();
    sign(found, expected, because, |found| {
        [
            (is_sign_of(found, numbers.iter().sum()), "the sign of the sum in doubles"),
            (is_sign_of(found, largest), "the sign of the largest number"),
            (is_sign_of(found, last), "the sign of the last number"),
        ]
    })
}

/// Whether a filter may give this answer: `None` for "doubles cannot tell".
fn filter(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let [p, q, r] = points(exchange)?;
    let found_sign = match *found {
        [Value::Number(sign)] => Some(sign),
        [Value::Refusal(_)] => None,
        _ => return Some(Wrong::kind("a sign or nothing")),
    };
    let truth = orientation(p, q, r);
    let [one, other] = products(p, q, r);
    let sure = (one - other).abs() > SURE * (one.abs() + other.abs());
    match found_sign {
        None if sure => {
            let because =
                format!("the two products are {one:e} and {other:e}, far enough apart to be sure that {}", way(truth));
            Some(Wrong::because("gives up", because).is([(true, "None where doubles are sure")]))
        }
        Some(found) if naive(p, q, r) != truth => {
            let because = format!(
                "the two products are {one:e} and {other:e}, and doubles cannot tell that {}: expected None",
                way(truth)
            );
            let wrong = Wrong::because("too sure", because);
            Some(wrong.is([(!same(found, f64::from(truth)), "the wrong sign that the formula has in doubles")]))
        }
        Some(_) => sign(found, truth, way(truth), |_| []),
        None => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a point of whole coordinates lies, by areas: those of the three parts add up to that of the triangle.
    #[test]
    fn places_in_triangles_agree_with_areas() {
        let twice = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        for [a, b, c] in [[[0, 0], [5, 1], [2, 5]], [[0, 0], [2, 5], [5, 1]], [[3, 0], [0, 0], [0, 4]]] {
            for p in (0..49).map(|k| [k % 7 - 1, k / 7 - 1]) {
                let parts = [twice(p, a, b), twice(p, b, c), twice(p, c, a)];
                let expected = match parts.iter().sum::<i64>() > twice(a, b, c) {
                    true => -1,
                    false => i64::from(parts.iter().all(|&part| part > 0)),
                };
                let [p, a, b, c] = [p, a, b, c].map(|p| p.map(|x| x as f64));
                assert_eq!(i64::from(place_in_triangle(p, [a, b, c])), expected, "{p:?} {a:?} {b:?} {c:?}");
            }
        }
    }

    /// Where a point lies, by its distance from the centre, in whole numbers.
    #[test]
    fn places_in_circles_agree_with_distances() {
        // On the circle of radius 5 round the origin.
        let corners = [[5, 0], [3, 4], [-4, 3]];
        for [a, b, c] in [corners, [corners[1], corners[0], corners[2]]] {
            for d in (0..225).map(|k: i64| [k % 15 - 7, k / 15 - 7]) {
                let expected = (25 - d[0] * d[0] - d[1] * d[1]).signum();
                let points = [a, b, c, d].map(|p| p.map(|x| x as f64));
                assert_eq!(i64::from(place_in_circle(points)), expected, "{points:?}");
            }
        }
    }
}
