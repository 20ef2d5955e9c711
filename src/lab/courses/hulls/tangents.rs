//! Tangents, by their definition: a line that has all corners on one side.

use super::polygons::{Corner, cycle, is_between, is_outside};
use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// The corners in which the tangents from a point touch a convex polygon, the right one first; `None` if the point is
/// not outside. Cost: O(n²).
pub(super) fn from_point(corners: &[Corner], p: Point) -> Option<[u32; 2]> {
    let touches = |allowed: Ordering| {
        let all = corners.iter().filter(|c| {
            corners.iter().all(|d| {
                let side = orientation(p, c.place, d.place);
                side == allowed || side.is_eq()
            })
        });
        all.reduce(|near, c| if is_between(p, c.place, near.place) { c } else { near }).map(|c| c.number)
    };
    if !is_outside(corners, p) {
        return None;
    }
    Some([touches(Ordering::Greater)?, touches(Ordering::Less)?])
}

/// The lower and the upper common tangent of two polygons, of which the first comes before the second. Cost: O(n³).
pub(super) fn common(first: &[Corner], second: &[Corner]) -> Option<[[u32; 2]; 2]> {
    let all = || first.iter().chain(second);
    let tangent = |allowed: Ordering| {
        let touches = |a: &Corner, b: &Corner| {
            all().all(|c| {
                let side = orientation(a.place, b.place, c.place);
                side == allowed || side.is_eq()
            })
        };
        let outermost = |best: Option<[Corner; 2]>, [a, b]: [Corner; 2]| {
            let Some([c, d]) = best else { return Some([a, b]) };
            let is_further = left_to_right(a.place, c.place).is_le() && left_to_right(d.place, b.place).is_le();
            Some(if is_further { [a, b] } else { [c, d] })
        };
        let pairs = first.iter().flat_map(|a| second.iter().map(move |b| [*a, *b]));
        let found = pairs.filter(|[a, b]| touches(a, b)).fold(None, outermost);
        found.map(|pair| pair.map(|c| c.number))
    };
    Some([tangent(Ordering::Greater)?, tangent(Ordering::Less)?])
}

/// The polygon that the first corner of a call belongs to, and the point.
pub(super) fn asked(exchange: &Exchange) -> Option<(Vec<Corner>, Point)> {
    let &first = exchange.called?.0.first()?;
    let [x, y] = [exchange.words.get(1)?.parse().ok()?, exchange.words.get(2)?.parse().ok()?];
    Some((cycle(exchange.records_before()?, first)?, Point::new(x, y)))
}

/// The two polygons of a call.
pub(super) fn asked_two(exchange: &Exchange) -> Option<[Vec<Corner>; 2]> {
    let &[a, b] = exchange.called?.0 else { return None };
    let records = exchange.records_before()?;
    Some([cycle(records, a)?, cycle(records, b)?])
}

/// What is wrong with the answer of `tangents`.
pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (corners, p) = asked(exchange)?;
    let Some(expected) = from_point(&corners, p) else {
        return match values {
            [Value::Refusal(_)] => None,
            _ => Some(Wrong::because("accepted", "the point is not outside of the polygon, so `None` was expected")),
        };
    };
    let value = ids(&expected);
    match values {
        [Value::Refusal(_)] => {
            Some(Wrong { tag: "refused".to_owned(), ..Wrong::value(&value, "the point is outside of the polygon") })
        }
        [Value::Id(right), Value::Id(left)] => {
            let found = [*right, *left];
            let on_the_line = |i: usize| {
                let place = |number: u32| corners.iter().find(|c| c.number == number).map(|c| c.place);
                let (Some(a), Some(b)) = (place(found[i]), place(expected[i])) else { return false };
                orientation(p, a, b).is_eq()
            };
            let because = if found == [expected[1], expected[0]] {
                "these are the two, but the right tangent comes first: the polygon is on the left of it"
            } else if on_the_line(0) && on_the_line(1) {
                "of two corners on one tangent, the nearer one is asked for"
            } else {
                "a corner of the polygon lies on the wrong side of one of these lines"
            };
            let wrong = Wrong::value(&value, because).is([
                (found == [expected[1], expected[0]], "the right two corners in the wrong order"),
                (on_the_line(0) && on_the_line(1), "the further corners of the two tangents"),
                (found[0] == expected[0], "right in its first corner"),
                (found[1] == expected[1], "right in its second corner"),
            ]);
            (found != expected).then_some(wrong)
        }
        _ => Some(Wrong::kind("two corners, or a refusal")),
    }
}

/// What is wrong with the answer of `common_tangents`.
pub(super) fn wrong_common(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let [first, second] = asked_two(exchange)?;
    let expected = common(&first, &second)?;
    let [lower, upper] = values else { return Some(Wrong::kind("two tangents")) };
    let (Some(lower), Some(upper)) = (lower.ids(), upper.ids()) else { return Some(Wrong::kind("two tangents")) };
    let found = [lower, upper];
    if found == expected {
        return None;
    }
    let place = |number: u32| first.iter().chain(&second).find(|c| c.number == number).map(|c| c.place);
    let line = |[a, b]: [u32; 2]| Some([place(a)?, place(b)?]);
    let same_line = |i: usize| match (line(found[i]), line(expected[i])) {
        (Some([a, b]), Some([c, d])) => a != b && orientation(a, b, c).is_eq() && orientation(a, b, d).is_eq(),
        _ => false,
    };
    let swapped = found == [expected[1], expected[0]];
    let because = if swapped {
        "these are the two, but the lower one comes first: both polygons are on the left of it"
    } else if same_line(0) && same_line(1) {
        "of several corners on one tangent, the outermost two are asked for"
    } else if found[0] == expected[0] || same_line(0) {
        "a corner lies above the second line"
    } else {
        "a corner lies below the first line"
    };
    let listed: Vec<Value> = expected.iter().map(|pair| Value::List(pair.map(Value::Id).into())).collect();
    let wrong = Wrong::because(if same_line(0) && same_line(1) { "inner" } else { "value" }, because);
    let expected_words = listed.iter().map(Value::words).collect::<Vec<_>>().join(" ");
    Some(Wrong { expected: Some(expected_words), ..wrong }.is([
        (swapped, "the right two tangents in the wrong order"),
        (same_line(0) && same_line(1), "inner corners of the two tangents"),
        (found[0] == expected[0], "right in its lower tangent"),
        (found[1] == expected[1], "right in its upper tangent"),
    ]))
}

fn ids(numbers: &[u32]) -> Value {
    Value::List(numbers.iter().map(|&number| Value::Id(number)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(first: u32, places: &[[f64; 2]]) -> Vec<Corner> {
        (first..).zip(places).map(|(number, &place)| Corner { number, place: place.into() }).collect()
    }

    #[test]
    fn tangents_touch_the_nearest_corner_and_inside_there_is_none() {
        let square = corners(0, &[[0., 0.], [4., 0.], [4., 4.], [0., 4.]]);
        let from = |x, y| from_point(&square, Point::new(x, y));
        assert_eq!(from(8.0, 2.0), Some([2, 1]));
        assert_eq!(from(-1.0, 2.0), Some([0, 3]));
        assert_eq!(from(6.0, 0.0), Some([2, 1]), "on the line of a side");
        assert_eq!(from(9.0, 9.0), Some([3, 1]));
        for (x, y) in [(2.0, 2.0), (4.0, 2.0), (0.0, 0.0)] {
            assert_eq!(from(x, y), None);
        }
        let edge = corners(7, &[[0., 0.], [4., 0.]]);
        assert_eq!(from_point(&edge, Point::new(6.0, 0.0)), Some([8, 8]));
        assert_eq!(from_point(&edge, Point::new(2.0, 0.0)), None);
        assert_eq!(from_point(&edge, Point::new(2.0, -1.0)), Some([8, 7]));
        assert_eq!(from_point(&edge[..1], Point::new(2.0, 0.0)), Some([7, 7]));
        assert_eq!(from_point(&edge[..1], Point::new(0.0, 0.0)), None);
    }

    #[test]
    fn common_tangents_join_the_outermost_corners() {
        let left = corners(0, &[[0., 0.], [4., 0.], [4., 4.], [0., 4.]]);
        let right = corners(4, &[[6., 0.], [9., 0.], [7., 9.]]);
        assert_eq!(common(&left, &right), Some([[0, 5], [3, 6]]));
        let [a, b] = [corners(0, &[[0., 0.], [1., 1.]]), corners(2, &[[2., 2.], [3., 3.]])];
        assert_eq!(common(&a, &b), Some([[0, 3], [0, 3]]), "all on one line");
        let [a, b] = [corners(0, &[[0., 0.]]), corners(1, &[[0., 5.]])];
        assert_eq!(common(&a, &b), Some([[0, 1], [0, 1]]));
    }
}
