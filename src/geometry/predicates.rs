//! Exact signs. Every geometric decision of the kit comes down to these.

use super::point::Point;
use robust::Coord;
use std::cmp::Ordering;

fn coord(p: Point) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// On which side of the directed line a -> b the point c lies: `Greater` = left (a, b, c turn
/// counter-clockwise), `Less` = right, `Equal` = on the line. Exact for all points that pass
/// [`Point::check`].
///
/// Mostly the difference of two products is clear; if it is not, crate `robust` decides. (It asks for the signs of the
/// products first, which no processor can guess.)
///
/// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997.
#[must_use]
#[inline]
pub fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let (difference, doubt) = doubtful_area(a, b, c);
    if difference > doubt {
        Ordering::Greater
    } else if difference < -doubt {
        Ordering::Less
    } else {
        sign(robust::orient2d(coord(a), coord(b), coord(c)))
    }
}

/// Twice the signed area of a triangle in doubles, and by how much it may be wrong.
#[inline(always)]
pub(crate) fn doubtful_area(a: Point, b: Point, c: Point) -> (f64, f64) {
    let [one, other] = [(a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x)];
    (one - other, ROUNDING * (one.abs() + other.abs()))
}

/// How much of the sum of two products of differences rounding may change their difference: (3 + 16 e) e, e = 2^-53.
pub(crate) const ROUNDING: f64 = 3.330_669_073_875_472e-16;

/// Whether d lies inside (`Greater`), on (`Equal`) or outside (`Less`) the circle through a, b, c, which must
/// turn counter-clockwise. Exact, as [`orientation`].
///
/// Mostly the determinant in doubles is clear. If it is not, four points of a grid are decided in whole numbers, since
/// there many circles pass through more than three points; else crate `robust` decides.
///
/// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997.
#[must_use]
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let from_d = |p: Point| [p.x - d.x, p.y - d.y];
    let ([ax, ay], [bx, by], [cx, cy]) = (from_d(a), from_d(b), from_d(c));
    let [bc, cb, ca, ac, ab, ba] = [bx * cy, cx * by, cx * ay, ax * cy, ax * by, bx * ay];
    let [aa, bb, cc] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
    let determinant = aa * (bc - cb) + bb * (ca - ac) + cc * (ab - ba);
    let size = (bc.abs() + cb.abs()) * aa + (ca.abs() + ac.abs()) * bb + (ab.abs() + ba.abs()) * cc;
    let doubt = CIRCLE_ROUNDING * size;
    if determinant > doubt {
        Ordering::Greater
    } else if determinant < -doubt {
        Ordering::Less
    } else {
        in_circle_exactly([a, b, c], d)
    }
}

/// The sign that is not clear from doubles. One of the corners lies on their circle: this is asked wherever a vertex has few
/// edges, and would take all digits.
#[cold]
fn in_circle_exactly(corners: [Point; 3], d: Point) -> Ordering {
    if corners.contains(&d) {
        return Ordering::Equal;
    }
    let by_digits = || {
        let [a, b, c] = corners.map(coord);
        sign(robust::incircle(a, b, c, coord(d)))
    };
    in_circle_on_grid(corners, d).unwrap_or_else(by_digits)
}

/// How much of the sum of the sizes of its products rounding may change the determinant of a circle: (10 + 96 e) e,
/// e = 2^-53.
const CIRCLE_ROUNDING: f64 = 1.110_223_024_625_157_7e-15;

/// The same for points whose differences are multiples of 1/1024, and smaller than 2^20: in whole numbers. `None` for
/// others.
fn in_circle_on_grid(corners: [Point; 3], d: Point) -> Option<Ordering> {
    let mut whole = [[0_i64; 2]; 3];
    for (p, whole) in corners.iter().zip(&mut whole) {
        *whole = [steps(p.x, d.x)?, steps(p.y, d.y)?];
    }
    let [a, b, c] = whole;
    let square = |[x, y]: [i64; 2]| x * x + y * y;
    let turn = |[x, y]: [i64; 2], [u, v]: [i64; 2]| x * v - u * y;
    // Differences below 2^30 steps: squares and turns are below 2^62, products below 2^124.
    let product = |n: i64, m: i64| i128::from(n) * i128::from(m);
    let determinant = product(square(a), turn(b, c)) + product(square(b), turn(c, a)) + product(square(c), turn(a, b));
    Some(determinant.cmp(&0))
}

/// a - b in steps of 1/1024, if that is a whole number below 2^30 without any rounding.
#[inline]
fn steps(a: f64, b: f64) -> Option<i64> {
    let difference = a - b;
    let (rest_b, scaled) = (a - difference, difference * 1024.0);
    // What the subtraction has lost, as in a sum of two doubles.
    let lost = (a - (difference + rest_b)) + (rest_b - b);
    let whole = scaled as i64;
    (lost == 0.0 && whole as f64 - scaled == 0.0 && whole.unsigned_abs() < 1 << 30).then_some(whole)
}

/// Twice the area of the triangle a, b, c: positive if it runs counter-clockwise. The sign is exact, the size rounded.
#[must_use]
#[inline]
pub fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    robust::orient2d(coord(a), coord(b), coord(c))
}

fn sign(value: f64) -> Ordering {
    value.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// Order from left to right, points above each other from bottom to top.
#[must_use]
#[inline]
pub fn left_to_right(a: Point, b: Point) -> Ordering {
    let by = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    by(a.x, b.x).then(by(a.y, b.y))
}

/// Whether a point is left of another in the order of [`left_to_right`]. No branch, for loops in which nobody can guess the
/// answer.
#[inline]
pub(crate) fn is_left_of(a: Point, b: Point) -> bool {
    (a.x < b.x) | ((a.x <= b.x) & (a.y < b.y))
}

/// Whether a place comes before another round a point, counter-clockwise from straight down; straight down itself is last.
/// Of those in one direction none comes first.
#[inline]
pub(crate) fn is_before_round(at: Point, p: Point, q: Point) -> bool {
    is_before_round_of_sides(at, [p, q], [is_left_of(p, at), is_left_of(q, at)])
}

/// The same for places that are known to be left of the point or not. Without a branch, as [`doubtful_area`] is.
#[inline]
pub(crate) fn is_before_round_of_sides(at: Point, [p, q]: [Point; 2], [is_p_left, is_q_left]: [bool; 2]) -> bool {
    let (area, doubt) = doubtful_area(at, p, q);
    let is_same_side = is_p_left == is_q_left;
    if is_same_side & (area.abs() <= doubt) {
        orientation(at, p, q).is_gt()
    } else {
        (is_same_side & (area > 0.0)) | (!is_p_left & is_q_left)
    }
}

/// A whole number that orders finite numbers as they are, with -0 = 0.
#[inline]
pub(crate) fn sort_key(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn left_of_is_the_order_from_left_to_right() {
        let numbers = [-1e150, -1.0, -0.0, 0.0, 1.0_f64.next_down(), 1.0, 1e150];
        let points: Vec<Point> = numbers.iter().flat_map(|&x| numbers.map(|y| Point::new(x, y))).collect();
        for (&a, &b) in points.iter().flat_map(|a| points.iter().map(move |b| (a, b))) {
            assert_eq!(is_left_of(a, b), left_to_right(a, b).is_lt(), "{a:?} {b:?}");
        }
    }

    #[test]
    fn a_sign_that_is_clear_is_the_one_of_all_digits() {
        // A few last places beside a line through two points, where plain products are often wrong (Kettner and
        // others, *Classroom examples of robustness problems in geometric computations*, 2008), and further off.
        let [b, c] = [Point::new(12.0, 12.0), Point::new(24.0, 24.0)];
        let [mut wrong, mut clear, mut on_the_line] = [0, 0, 0];
        for (i, k) in (0..48).flat_map(|i| (0..48).map(move |k| (i, k))) {
            for step in [1, 9] {
                let [x, y] = [i, k].map(|i| f64::from_bits(f64::to_bits(0.5) + i * step));
                let a = Point::new(x, y);
                let exact = sign(robust::orient2d(coord(a), coord(b), coord(c)));
                for (p, q, r) in [(a, b, c), (b, c, a), (c, a, b)] {
                    assert_eq!(orientation(p, q, r), exact, "{p} {q} {r}");
                    let [one, other] = [(p.x - r.x) * (q.y - r.y), (p.y - r.y) * (q.x - r.x)];
                    wrong += i32::from(sign(one - other) != exact);
                    clear += i32::from((one - other).abs() > ROUNDING * (one.abs() + other.abs()));
                }
                on_the_line += i32::from(exact.is_eq());
            }
        }
        assert!(wrong > 500 && clear > 100 && on_the_line >= 96, "{wrong} {clear} {on_the_line}: an easy test");
    }

    #[test]
    fn circles_are_decided_as_by_all_digits() {
        let mut state = 9_u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % n
        };
        // By kind of step: decided on the grid, left to all digits; and how many points lie on the circle.
        let [mut on_grid, mut left, mut round] = [[0; 9]; 3];
        for i in 0..225_000 {
            let kind = i % 9;
            let step = [1.0, 0.5, 1.0 / 1024.0, 1.0 / 2048.0, 0.1, 1.0, 40_000.0, 1e-30, 1.0][kind];
            let far = [0.0, 1000.0, 3.0, 0.0, 0.0, 2f64.powi(50), 0.0, 0.0, 0.0][kind];
            let size = [6, 6, 9, 6, 6, 9, 30, 9, 4][kind];
            let mut place = || {
                let (x, y) = (far + below(size) as f64 * step, far * 0.5 + below(size) as f64 * step);
                // What a difference from other numbers loses.
                if kind == 8 && x == 0.0 { Point::new(1e-30, y) } else { Point::new(x, y) }
            };
            let [mut a, b, mut c, mut d] = [place(), place(), place(), place()];
            if i / 9 % 3 == 0 {
                // The fourth corner of a rectangle, often a little beside it.
                d = Point::new(a.x - b.x + c.x, a.y - b.y + c.y);
            }
            if robust::orient2d(coord(a), coord(b), coord(c)) < 0.0 {
                std::mem::swap(&mut a, &mut c);
            }
            let exact = sign(robust::incircle(coord(a), coord(b), coord(c), coord(d)));
            assert_eq!(in_circle(a, b, c, d), exact, "{a} {b} {c} {d}");
            match in_circle_on_grid([a, b, c], d) {
                Some(found) => {
                    assert_eq!(found, exact, "{a} {b} {c} {d}");
                    on_grid[kind] += 1;
                }
                None => left[kind] += 1,
            }
            round[kind] += usize::from(exact.is_eq());
        }
        let all = 25_000;
        assert_eq!([0, 1, 2, 5].map(|kind| on_grid[kind]), [all; 4], "{on_grid:?}");
        assert!([3, 4, 7].iter().all(|&kind| left[kind] > all / 2) && left[6] > 1000, "{left:?}");
        assert!(
            on_grid[3] > 100 && on_grid[6] > 1000 && round.iter().all(|&count| count > 200),
            "{on_grid:?} {round:?}"
        );
    }
}
