//! Centres of circles, with twice the digits of a double.

use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;

/// How far a centre may be from the right one, for each unit of the radius and of the coordinates.
const OF_RADIUS: f64 = 1e-9;
const OF_PLACE: f64 = 3e-16;
/// Triangles with a smaller angle, in radians, are only asked whether they have a centre.
pub(super) const THIN: f64 = 0.015;

/// A number as the sum of two doubles.
///
/// Source: T. J. Dekker, *A floating-point technique for extending the available precision*, 1971.
#[derive(Clone, Copy)]
struct Double(f64, f64);

impl Double {
    fn sum(a: f64, b: f64) -> Self {
        let s = a + b;
        let t = s - a;
        Self(s, (a - (s - t)) + (b - t))
    }

    fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.0, other.0);
        Self::sum(high.0, high.1 + self.1 + other.1)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self(-other.0, -other.1))
    }

    fn times(self, other: Self) -> Self {
        let high = self.0 * other.0;
        let low = self.0.mul_add(other.0, -high);
        Self::sum(high, low + self.0 * other.1 + self.1 * other.0)
    }

    fn over(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self.minus(other.times(Self(first, 0.0)));
        Self::sum(first, rest.0 / other.0)
    }
}

/// The centre of the circle through three points, and its radius; nothing if they are on one line.
pub(super) fn centre(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<([f64; 2], f64)> {
    if orientation(Point::from(a), Point::from(b), Point::from(c)).is_eq() {
        return None;
    }
    let from_a = |p: [f64; 2]| [Double::sum(p[0], -a[0]), Double::sum(p[1], -a[1])];
    let ([px, py], [qx, qy]) = (from_a(b), from_a(c));
    let square = |x: Double, y: Double| x.times(x).plus(y.times(y));
    let (p, q) = (square(px, py), square(qx, qy));
    let area = px.times(qy).minus(py.times(qx));
    let twice = area.plus(area);
    let x = qy.times(p).minus(py.times(q)).over(twice);
    let y = px.times(q).minus(qx.times(p)).over(twice);
    let place = [x.plus(Double(a[0], 0.0)).0, y.plus(Double(a[1], 0.0)).0];
    Some((place, square(x, y).0.sqrt()))
}

/// Whether a found centre is too far from the right one.
pub(super) fn is_off(found: [f64; 2], expected: [f64; 2], radius: f64) -> bool {
    let allowed = OF_RADIUS * radius + OF_PLACE * expected[0].abs().max(expected[1].abs());
    (0..2).any(|i| found[i].is_nan() || (found[i] - expected[i]).abs() > allowed)
}

/// The smallest angle of a triangle, about.
fn smallest_angle([a, b, c]: [[f64; 2]; 3]) -> f64 {
    let angle = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        let (u, v) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
        (u[0] * v[1] - u[1] * v[0]).abs().atan2(u[0] * v[0] + u[1] * v[1])
    };
    angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b))
}

/// The three points of a call.
pub(super) fn asked(exchange: &Exchange) -> Option<[[f64; 2]; 3]> {
    let numbers = exchange.numbers();
    let [a, b, c, d, e, f] = numbers[..] else { return None };
    Some([[a, b], [c, d], [e, f]])
}

/// Whether the place of a centre is looked at: there is one, and no angle is too small.
pub(super) fn is_looked_at(points: [[f64; 2]; 3]) -> bool {
    let [a, b, c] = points;
    centre(a, b, c).is_some() && smallest_angle(points) >= THIN
}

/// Whether the centre is another one when seen from the first point.
pub(super) fn moves_with_a(points: [[f64; 2]; 3]) -> bool {
    let [a, b, c] = points;
    let other = |(place, radius): ([f64; 2], f64)| is_off([place[0] - a[0], place[1] - a[1]], place, radius);
    is_looked_at(points) && centre(a, b, c).is_some_and(other)
}

/// Whether the plain determinant, from the coordinates as they are, has lost the centre.
pub(super) fn is_lost_from_the_origin(points: [[f64; 2]; 3]) -> bool {
    let [a, b, c] = points;
    let Some((expected, radius)) = centre(a, b, c) else { return false };
    let square = |p: [f64; 2]| p[0] * p[0] + p[1] * p[1];
    let twice = 2.0 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]));
    let x = (square(a) * (b[1] - c[1]) + square(b) * (c[1] - a[1]) + square(c) * (a[1] - b[1])) / twice;
    let y = (square(a) * (c[0] - b[0]) + square(b) * (a[0] - c[0]) + square(c) * (b[0] - a[0])) / twice;
    is_looked_at(points) && is_off([x, y], expected, radius)
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let points = asked(exchange)?;
    let [a, b, c] = points;
    let Some((expected, radius)) = centre(a, b, c) else {
        let refused = matches!(values, [Value::Refusal(_)]);
        return (!refused).then(|| Wrong::because("accepted", "the points are on one line: there is no circle"));
    };
    if let [Value::Refusal(_)] = values {
        return Some(Wrong::because("refused", "the points are not on one line"));
    }
    let Some(found) = values.first().and_then(Value::point).filter(|_| values.len() == 1) else {
        return Some(Wrong::kind("one point"));
    };
    if smallest_angle(points) < THIN || !is_off(found, expected, radius) {
        return None;
    }
    let mean = [0, 1].map(|i| (a[i] + b[i] + c[i]) / 3.0);
    let from_a = [0, 1].map(|i| expected[i] - a[i]);
    let words = Value::Point(expected.to_vec());
    Some(Wrong::value(&words, "it is as far from the first point as from the others").is([
        (!is_off(found, mean, radius), "the mean of the corners"),
        (!is_off(found, from_a, radius), "the centre seen from the first point"),
        (!is_off(found, expected.map(|x| 2.0 * x), radius), "twice the centre"),
    ]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::random::Random;

    #[test]
    fn a_centre_is_as_far_from_all_three_points() {
        let mut random = Random::new(1, "centres");
        for _ in 0..1000 {
            let mut point = || [random.below(2001) as f64 - 1000.0, random.below(2001) as f64 - 1000.0];
            let [a, b, c] = [point(), point(), point()];
            let Some(([x, y], radius)) = centre(a, b, c) else { continue };
            for [px, py] in [a, b, c] {
                assert!(((x - px).hypot(y - py) - radius).abs() <= 1e-12 * radius, "{a:?} {b:?} {c:?}");
            }
        }
        assert_eq!(centre([0.0, 0.0], [4.0, 0.0], [0.0, 2.0]), Some(([2.0, 1.0], 5f64.sqrt())));
        assert_eq!(centre([0.1, 0.1], [0.2, 0.2], [0.7, 0.7]), None);
        let far = 4503599627370496.0;
        assert_eq!(
            centre([far, far], [far + 4.0, far], [far, far + 2.0]).map(|(p, _)| p),
            Some([far + 2.0, far + 1.0])
        );
    }
}
