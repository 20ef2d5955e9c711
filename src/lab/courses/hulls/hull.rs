//! The hull of points: what is right, and what a wrong one is.

use super::polygons::{is_between, named, points};
use crate::answers::Wrong;
use crate::checks::cyclic::is_rotation;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;

/// The corners of the hull, counter-clockwise.
pub(super) fn hull(points: &[Point]) -> Vec<Point> {
    let corners = dcel_kit::plane::convex_hull(points).unwrap_or_default();
    corners.into_iter().map(|i| points[i as usize]).collect()
}

/// What is wrong with the polygon that a function gave back as the hull of the points.
pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let points = points(exchange.records_before()?);
    let [Value::Polygon(found)] = values else { return Some(Wrong::kind("a polygon")) };
    let found: Vec<Point> = found.iter().map(|&place| place.into()).collect();
    of_corners(&hull(&points), &points, &found)
}

/// What is wrong with some corners as the hull of points.
pub(super) fn of_corners(expected: &[Point], points: &[Point], found: &[Point]) -> Option<Wrong> {
    let [right, answer] = [expected, found].map(keys);
    if right.is_empty() && answer.is_empty() || is_rotation(&answer, &right) {
        return None;
    }
    let (tag, because) = explain(expected, points, found);
    let wrong = Wrong::value(&Value::Polygon(expected.iter().map(|p| [p.x, p.y]).collect()), because);
    Some(Wrong { tag: tag.to_owned(), ..wrong })
}

/// Why they are no hull, the plainest reason first.
fn explain(expected: &[Point], points: &[Point], found: &[Point]) -> (&'static str, String) {
    let among = |list: &[Point], p: &Point| list.iter().any(|q| q == p);
    let mut backwards = keys(found);
    backwards.reverse();
    if is_rotation(&backwards, &keys(expected)) {
        return ("clockwise", "these are the right corners, clockwise".to_owned());
    }
    if let Some(p) = found.iter().find(|p| !among(points, p)) {
        return ("foreign", format!("{} is none of the points", named(*p)));
    }
    if let Some((i, p)) = found.iter().enumerate().find(|(i, p)| among(&found[..*i], p)) {
        let words = if i + 1 == found.len() && *p == found[0] { "at its end, too" } else { "twice" };
        return ("twice", format!("{} is in the list {words}", named(*p)));
    }
    if let Some(p) = found.iter().find(|p| !among(expected, p)) {
        return if (0..expected.len()).any(|i| is_on_side(expected, i, *p)) {
            ("side", format!("{} lies on a side of the hull, and is no corner", named(*p)))
        } else {
            ("inside", format!("{} lies inside of the hull", named(*p)))
        };
    }
    match expected.iter().find(|p| !among(found, p)) {
        Some(p) => ("missing", format!("{} is a corner, and is not in the list", named(*p))),
        None => ("order", "the corners are right, their order is not".to_owned()),
    }
}

/// Whether a point lies on the side from a corner of a hull, its ends included.
pub(super) fn is_on_side(hull: &[Point], i: usize, p: Point) -> bool {
    let (a, b) = (hull[i], hull[(i + 1) % hull.len()]);
    orientation(a, b, p).is_eq() && is_between(a, p, b)
}

fn keys(points: &[Point]) -> Vec<[u64; 2]> {
    // -0 is 0.
    points.iter().map(|p| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::random::Random;

    /// By the definition: a point is a corner if it lies on no segment between two others and in no triangle of others.
    fn is_corner(points: &[Point], p: Point) -> bool {
        let others: Vec<Point> = points.iter().copied().filter(|q| *q != p).collect();
        let n = others.len();
        for i in 0..n {
            for j in 0..i {
                if orientation(others[i], p, others[j]).is_eq() && is_between(others[i], p, others[j]) {
                    return false;
                }
                for k in 0..j {
                    let [a, b, c] = [others[i], others[j], others[k]];
                    let sides = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
                    if sides.iter().all(|s| s.is_gt()) || sides.iter().all(|s| s.is_lt()) {
                        return false;
                    }
                }
            }
        }
        true
    }

    #[test]
    fn the_hull_is_that_of_the_definition() {
        let mut random = Random::new(3, "hulls");
        for size in 1..9 {
            for _ in 0..40 {
                let points: Vec<Point> =
                    (0..size).map(|_| Point::new(random.below(5) as f64, random.below(4) as f64)).collect();
                let hull = hull(&points);
                for &p in &points {
                    assert_eq!(hull.contains(&p), is_corner(&points, p), "{points:?}: {p}");
                }
                let n = hull.len();
                assert!(n < 3 || (0..n).all(|i| orientation(hull[i], hull[(i + 1) % n], hull[(i + 2) % n]).is_gt()));
                assert_eq!(of_corners(&hull, &points, &hull), None);
            }
        }
    }

    #[test]
    fn a_wrong_hull_is_told_by_its_plainest_fault() {
        let points = [[0., 0.], [2., 0.], [4., 0.], [4., 4.], [0., 4.], [1., 1.]].map(Point::from);
        let [a, on, b, c, d, inside] = points;
        let said = |found: &[Point]| of_corners(&hull(&points), &points, found).map(|wrong| wrong.tag);
        assert_eq!(said(&[b, c, d, a]), None);
        for (found, tag) in [
            (vec![a, d, c, b], "clockwise"),
            (vec![a, on, b, c, d], "side"),
            (vec![a, inside, b, c, d], "inside"),
            (vec![a, b, c, d, a], "twice"),
            (vec![a, b, c], "missing"),
            (vec![a, c, b, d], "order"),
            (vec![a, b, c, Point::new(0.0, 5.0)], "foreign"),
            (vec![], "missing"),
        ] {
            assert_eq!(said(&found).as_deref(), Some(tag), "{found:?}");
        }
    }
}
