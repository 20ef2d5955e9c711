//! The points and polygons that cases begin with.

use super::hull::hull;
use super::polygons::{SCHEMA, add, add_points};
use crate::cases::random::Random;
use crate::protocol::{Records, Start, Structure};
use dcel_kit::plane::Point;
use std::sync::Arc;

/// Points, as a line.
pub(super) fn points(points: &[Point]) -> Start {
    Start::line(format!("points{}", words(points)))
}

/// Polygons, as a line.
pub(super) fn polygons(polygons: &[Vec<Point>]) -> Start {
    let all: Vec<String> = polygons.iter().map(|corners| words(corners)).collect();
    let mut records = Records::new(&SCHEMA);
    polygons.iter().for_each(|corners| add(&mut records, corners));
    Start::known(format!("polygons{}", all.join(" /")), Structure::Records(Arc::new(records)))
}

fn words(points: &[Point]) -> String {
    points.iter().map(|p| format!(" {} {}", p.x, p.y)).collect()
}

/// The points of a start that states them.
pub(super) fn stated(start: &Start) -> Option<Vec<Point>> {
    let words = start.text().strip_prefix("points")?;
    let numbers: Option<Vec<f64>> = words.split_whitespace().map(|word| word.parse().ok()).collect();
    Some(numbers?.chunks_exact(2).map(|pair| Point::new(pair[0], pair[1])).collect())
}

/// The polygons of a start that states them.
pub(super) fn stated_polygons(start: &Start) -> Option<Vec<Vec<Point>>> {
    let words = start.text().strip_prefix("polygons")?;
    let corners = |part: &str| stated(&Start::line(format!("points{part}")));
    words.split(" /").map(corners).collect()
}

/// Many points: some on a parabola, the others above it.
pub(super) fn bowl(count: usize) -> Start {
    let place = |i: usize| {
        let x = (i * 7919 % 2401) as f64 - 1200.0;
        let deep = 1_440_000.0 - x * x;
        Point::new(x, if i < 2401 { x * x } else { 1_440_000.0 - deep * (i * 31 % 997) as f64 / 1024.0 })
    };
    let mut records = Records::new(&SCHEMA);
    add_points(&mut records, &(0..count).map(place).collect::<Vec<_>>());
    Start::known(format!("bowl {count}"), Structure::Records(Arc::new(records)))
}

/// The points of the handout.
pub(super) fn handout() -> Vec<Point> {
    at(crate::cases::handouts::POINTS)
}

fn at<const N: usize>(places: [[f64; 2]; N]) -> Vec<Point> {
    places.map(Point::from).into()
}

/// Points of which no two are equal and no three are on one line.
pub(super) fn plain() -> Vec<(&'static str, Vec<Point>)> {
    vec![
        ("triangle", at([[0., 0.], [7., 1.], [2., 6.]])),
        ("triangle_clockwise", at([[0., 0.], [2., 6.], [7., 1.]])),
        ("one_inside", at([[3., 2.], [0., 0.], [7., 1.], [2., 6.]])),
        ("square", at([[0., 0.], [5., 1.], [4., 6.], [-1., 5.]])),
        ("first_is_inside", at([[4., 3.], [9., 1.], [5., 8.], [0., 4.], [3., 0.], [6., 4.]])),
        ("far_below", at([[1., 2.], [-3., 1.], [2., -9.], [5., 4.], [0., 7.], [4., -2.]])),
        ("parabola", (0..40).map(|k: i32| Point::new(f64::from(k), f64::from(k * k))).collect()),
        ("many_corners", (0..300).map(|k: i32| Point::new(f64::from(k), f64::from(k * k))).collect()),
        ("small", at([[1e-30, 0.], [3e-30, 1e-31], [2e-30, 5e-30], [2e-30, 1e-30]])),
        ("large", at([[1e15, 3.], [-1e15, 1e15], [4e14, 2e15], [1e14, 1e15], [-3e15, -7.]])),
    ]
}

/// Points that are equal, on one line, above each other, few, or so near to a line that rounding hides it.
pub(super) fn degenerate() -> Vec<(&'static str, Vec<Point>)> {
    let beside = |i: u64, k: u64| [i, k].map(|steps| f64::from_bits(f64::to_bits(0.5) + steps)).into();
    let mut near_a_line: Vec<Point> = (0..4).flat_map(|i| (0..4).map(move |k| beside(i, k))).collect();
    near_a_line.extend(at([[12., 12.], [24., 24.]]));
    let tenths = |k: i32| f64::from(k) * 0.1;
    vec![
        ("none", Vec::new()),
        ("one", at([[3., 4.]])),
        ("two", at([[3., 4.], [1., 7.]])),
        ("two_equal", at([[3., 4.], [3., 4.]])),
        ("all_equal", at([[3., 4.]; 5])),
        ("three_on_a_line", at([[4., 4.], [0., 0.], [2., 2.]])),
        ("upright_line", at([[1., 5.], [1., 0.], [1., 9.], [1., 3.]])),
        ("level_line", at([[5., 1.], [0., 1.], [9., 1.], [3., 1.]])),
        ("on_a_side", at([[0., 0.], [2., 0.], [4., 0.], [4., 4.], [0., 4.]])),
        ("on_all_sides", at([[0., 2.], [2., 0.], [4., 2.], [2., 4.], [0., 0.], [4., 0.], [4., 4.], [0., 4.]])),
        ("corner_twice", at([[0., 0.], [6., 1.], [6., 1.], [3., 5.], [0., 0.], [3., 2.]])),
        ("last_corner_twice", at([[0., 0.], [6., 1.], [3., 5.], [3., 5.]])),
        ("several_on_the_last_side", at([[0., 0.], [5., 0.], [4., 4.], [3., 3.], [2., 2.], [1., 1.]])),
        ("several_leftmost", at([[0., 5.], [0., 0.], [0., 2.], [4., 3.]])),
        ("several_lowest", at([[2., 0.], [0., 0.], [5., 0.], [3., 4.]])),
        ("grid", (0..30).map(|k: i32| Point::new(f64::from(k % 6), f64::from(k / 6))).collect()),
        ("tenths", (0..9).map(|k| Point::new(tenths(k % 3), tenths(k / 3))).collect()),
        ("near_a_line", near_a_line),
    ]
}

/// All choices of points of a grid of three by three, in the order of a walk that jumps about.
pub(super) fn of_a_small_grid() -> Vec<Vec<Point>> {
    let order = [4, 8, 1, 6, 3, 0, 7, 5, 2];
    let chosen = |bits: u32| {
        let kept = order.into_iter().filter(move |&k| bits >> k & 1 == 1);
        kept.map(|k: i32| Point::new(f64::from(k % 3), f64::from(k / 3))).collect::<Vec<_>>()
    };
    let mut all: Vec<Vec<Point>> = (1..512).map(chosen).collect();
    all.sort_by_key(Vec::len);
    all
}

/// Points with whole coordinates up to a size; the smaller it is, the more of them are equal or on one line.
pub(super) fn random(random: &mut Random, count: usize, size: usize) -> Vec<Point> {
    let mut number = || random.below(2 * size + 1) as f64 - size as f64;
    (0..count).map(|_| Point::new(number(), number())).collect()
}

/// A convex polygon round random points, which begins at any one of its corners.
pub(super) fn random_polygon(from: &mut Random, count: usize, size: usize) -> Vec<Point> {
    turned_hull(&random(from, count, size), from)
}

fn turned_hull(points: &[Point], from: &mut Random) -> Vec<Point> {
    let mut corners = hull(points);
    let first = from.below(corners.len());
    corners.rotate_left(first);
    corners
}

/// Two convex polygons, the first of which comes before the second: the hulls of the left and the right part of some
/// random points, each beginning at any one of its corners.
pub(super) fn random_pair(from: &mut Random, count: usize, size: usize) -> Vec<Vec<Point>> {
    let mut all = random(from, count, size);
    all.sort_by(|p, q| dcel_kit::plane::predicates::left_to_right(*p, *q));
    all.dedup();
    if all.len() < 2 {
        all = at([[0., 0.], [1., 0.]]);
    }
    let middle = 1 + from.below(all.len() - 1);
    let (left, right) = all.split_at(middle);
    [left, right].map(|part| turned_hull(part, from)).into()
}

/// Convex polygons with a point from which tangents are asked.
pub(super) fn with_a_point() -> Vec<(&'static str, Vec<Point>, Point)> {
    let square = || at([[0., 0.], [4., 0.], [4., 4.], [0., 4.]]);
    let bowl: Vec<Point> = (-150..150).map(|k: i32| Point::new(f64::from(k), f64::from(k * k))).collect();
    vec![
        ("right_of_it", square(), Point::new(8., 2.)),
        ("left_of_it", square(), Point::new(-5., 1.)),
        ("above_it", square(), Point::new(1., 9.)),
        ("below_it", square(), Point::new(3., -2.)),
        ("beyond_a_corner", square(), Point::new(9., 9.)),
        ("triangle", at([[0., 0.], [7., 1.], [2., 6.]]), Point::new(6., 7.)),
        ("near_a_side", square(), Point::new(4.000_000_1, 2.)),
        ("large", bowl.clone(), Point::new(3., -50.)),
        ("large_above", bowl, Point::new(0., 1e6)),
        ("small_numbers", at([[1e-30, 0.], [3e-30, 1e-31], [2e-30, 5e-30]]), Point::new(-1e-30, 1e-30)),
        ("large_numbers", at([[1e15, 0.], [3e15, 1.], [2e15, 5e15]]), Point::new(-1e15, 0.1)),
    ]
}

/// The same where the point is on the line of a side, the polygon has one or two corners, or there is no tangent.
pub(super) fn with_an_odd_point() -> Vec<(&'static str, Vec<Point>, Point)> {
    let square = || at([[0., 0.], [4., 0.], [4., 4.], [0., 4.]]);
    let edge = || at([[1., 1.], [5., 3.]]);
    let tenths = || at([[0.1, 0.1], [0.7, 0.1], [0.4, 0.9]]);
    vec![
        ("on_the_line_of_a_side", square(), Point::new(7., 0.)),
        ("on_the_line_of_a_side_behind", square(), Point::new(-3., 0.)),
        ("on_the_line_of_an_upright_side", square(), Point::new(4., -2.)),
        ("on_the_line_of_the_last_side", square(), Point::new(0., 8.)),
        ("on_the_lines_of_two_sides", at([[0., 0.], [6., 0.], [4., 2.], [2., 2.]]), Point::new(3., 3.)),
        ("one_corner", at([[2., 3.]]), Point::new(5., 5.)),
        ("two_corners", edge(), Point::new(0., 6.)),
        ("two_corners_other_side", edge(), Point::new(6., -1.)),
        ("beyond_two_corners", edge(), Point::new(9., 5.)),
        ("before_two_corners", edge(), Point::new(-1., 0.)),
        ("tenths", tenths(), Point::new(1.3, 0.1)),
        ("inside", square(), Point::new(1., 2.)),
        ("just_inside", square(), Point::new(3.999_999_9, 2.)),
        ("on_a_side", square(), Point::new(4., 1.)),
        ("on_the_last_side", square(), Point::new(0., 1.)),
        ("at_a_corner", square(), Point::new(4., 4.)),
        ("on_an_edge", edge(), Point::new(3., 2.)),
        ("at_the_only_corner", at([[2., 3.]]), Point::new(2., 3.)),
    ]
}

/// Pairs of polygons, the first of which comes before the second.
pub(super) fn pairs() -> Vec<(&'static str, Vec<Vec<Point>>)> {
    let triangle = || at([[0., 0.], [4., 1.], [1., 5.]]);
    let square = |x: f64| at([[x, 0.], [x + 4., 0.], [x + 4., 4.], [x, 4.]]);
    let bowl = |from: i32, to: i32| (from..to).map(|k| Point::new(f64::from(k), f64::from(k * k))).collect::<Vec<_>>();
    let mut high = at([[6., 20.], [9., 21.], [7., 25.]]);
    high.rotate_left(1);
    vec![
        ("two_triangles", vec![triangle(), at([[6., 1.], [10., 2.], [7., 7.]])]),
        ("much_higher", vec![triangle(), high]),
        ("much_lower", vec![triangle(), at([[6., -20.], [9., -19.], [7., -15.]])]),
        ("small_and_large", vec![at([[0., 2.], [1., 2.], [1., 3.]]), square(5.)]),
        ("large_and_small", vec![square(0.), at([[6., 1.], [7., 2.], [6., 2.]])]),
        (
            "push_again",
            vec![at([[-10., -20.], [6., 0.], [10., 10.], [-12., 15.]]), at([[11., 10.], [20., -30.], [25., 12.]])],
        ),
        ("two_squares", vec![square(0.), square(6.)]),
        ("one_above_the_other", vec![at([[0., 0.], [0., 3.]]), at([[0., 5.], [0., 9.]])]),
        ("points", vec![at([[0., 0.]]), at([[3., 1.]])]),
        ("point_above", vec![at([[0., 0.]]), at([[0., 1.]])]),
        ("point_and_triangle", vec![at([[-3., 2.]]), triangle()]),
        ("square_and_point", vec![square(0.), at([[9., 2.]])]),
        ("square_and_point_in_line", vec![square(0.), at([[9., 4.]])]),
        ("edges_in_line", vec![at([[0., 0.], [1., 1.]]), at([[2., 2.], [5., 5.]])]),
        ("edges", vec![at([[0., 0.], [1., 1.]]), at([[2., 0.], [2., 5.]])]),
        ("bowls", vec![bowl(-150, 0), bowl(0, 150)]),
        ("small_numbers", vec![at([[1e-30, 0.], [2e-30, 1e-30]]), at([[3e-30, 0.], [5e-30, 1e-31], [4e-30, 2e-30]])]),
        ("large_numbers", vec![at([[-1e15, 0.1], [2., -1e15], [0.3, 1e15]]), at([[1e15, 0.], [3e15, 1e-30]])]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::plane::predicates::{left_to_right, orientation};

    fn is_convex(corners: &[Point]) -> bool {
        let n = corners.len();
        n < 3 || (0..n).all(|i| orientation(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]).is_gt())
    }

    #[test]
    fn what_the_handout_promises_of_polygons_holds() {
        let mut from = Random::new(1, "polygons");
        let mut all = pairs();
        all.extend((0..200).map(|i| ("random", random_pair(&mut from, 2 + i % 20, 1 + i % 9))));
        for (name, pair) in all {
            assert!(pair.iter().all(|corners| is_convex(corners)), "{name}");
            assert!(pair[0].iter().all(|p| pair[1].iter().all(|q| left_to_right(*p, *q).is_lt())), "{name}");
        }
        for (name, corners, _) in with_a_point().into_iter().chain(with_an_odd_point()) {
            assert!(is_convex(&corners), "{name}");
        }
    }

    #[test]
    fn plain_points_are_in_general_position() {
        for (name, points) in plain() {
            let n = points.len().min(40);
            for (i, j, k) in (0..n).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| (i, j, k)))) {
                assert!(!orientation(points[i], points[j], points[k]).is_eq(), "{name}");
            }
        }
    }
}
