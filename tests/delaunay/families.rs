//! Points of every awkward kind, and what is asked of a triangulation without trusting the kit's own tests.

use crate::common::Random;
use dcel_kit::plane::predicates::{in_circle, orientation};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::{FaceId, VertexId};
use std::collections::BTreeSet;

/// The kinds of points, by name.
pub(crate) const FAMILIES: [&str; 10] = [
    "random",
    "grid",
    "line",
    "circle",
    "1-ulp",
    "slanted line",
    "falling line",
    "far outlier",
    "long and thin",
    "clusters",
];

pub(crate) fn unit(random: &mut Random) -> f64 {
    (random.next() >> 11) as f64 / (1_u64 << 53) as f64
}

/// All points with integer coordinates on the circle of radius 65 round the origin: 36 of them.
pub(crate) fn circle() -> Vec<Point> {
    let all = (-65..=65).flat_map(|x: i32| (-65..=65).map(move |y: i32| (x, y)));
    all.filter(|(x, y)| x * x + y * y == 65 * 65).map(|(x, y)| Point::new(f64::from(x), f64::from(y))).collect()
}

/// `n` points of a family; some of them at the same place.
pub(crate) fn points(family: &str, n: usize, random: &mut Random) -> Vec<Point> {
    let circle = circle();
    let point = |i: usize| {
        let mut below = |bound: usize| random.below(bound) as f64;
        match family {
            "grid" => Point::new(below(5), below(5)),
            "line" => Point::new(below(9), 3.0),
            "circle" => circle[random.below(circle.len())],
            "1-ulp" => Point::new(1.0 + below(4) * f64::EPSILON, 1.0 + below(4) * f64::EPSILON),
            "slanted line" => {
                let x = below(7);
                Point::new(x, 3.0 * x)
            }
            "falling line" => {
                let x = below(12);
                Point::new(x, 40.0 - x)
            }
            "far outlier" if i == 0 => Point::new(1e60, -1e60),
            "far outlier" => Point::new(below(6), below(3)),
            "long and thin" => Point::new(unit(random) * 1e-30, (i as f64).exp2()),
            "clusters" => Point::new(below(3) * 1e6 + unit(random) * 1e-6, unit(random) * 1e-6),
            _ => Point::new(unit(random), unit(random)),
        }
    };
    (0..n).map(point).collect()
}

/// The number of points on the outline of the convex hull, by its definition; all of them if they lie on one line.
fn on_hull(points: &[Point]) -> usize {
    let all_left = |p: Point, q: Point| p != q && points.iter().all(|&r| orientation(p, q, r).is_ge());
    points.iter().filter(|&&p| points.iter().any(|&q| all_left(p, q))).count()
}

pub(crate) fn corners(s: &Subdivision, f: FaceId) -> Vec<Point> {
    s.incident_vertices(f).map(|v| s.point(v)).collect()
}

/// The edges by the places of their ends.
pub(crate) fn edges(s: &Subdivision) -> BTreeSet<[[u64; 2]; 2]> {
    let bits = |v: VertexId| [s.point(v).x, s.point(v).y].map(|x| (x + 0.0).to_bits());
    let ends = s.edges().map(|e| e.half_edges().map(|h| bits(s.origin(h))));
    ends.map(|mut ends| {
        ends.sort_unstable();
        ends
    })
    .collect()
}

/// Whether no four of the points lie on a circle and no three on a line, so that there is one triangulation only.
pub(crate) fn is_general(s: &Subdivision) -> bool {
    let quads = s.edges().filter_map(|e| {
        let [h, t] = e.half_edges();
        (![h, t].iter().any(|&h| s.face(h) == s.outer_face()))
            .then(|| [h, t, s.prev(h), s.prev(t)].map(|h| s.point(s.origin(h))))
    });
    quads.into_iter().all(|[a, b, c, d]| in_circle(a, b, c, d).is_ne())
}

/// Checks a Delaunay triangulation of distinct points against the definition: every pair of triangle and point.
#[track_caller]
pub(crate) fn check(s: &Subdivision, context: &str) {
    assert_eq!(dcel_kit::topology::violations(s), [], "{context}");
    assert_eq!(s.geometry_violations(), [], "{context}");
    let points: Vec<Point> = s.vertices().map(|v| s.point(v)).collect();
    let n = points.len();
    let hull = on_hull(&points);
    let triangles = s.face_count() - 1;
    for f in s.faces().skip(1) {
        let [a, b, c] = corners(s, f)[..] else { panic!("{context}: {f} is no triangle") };
        assert!(orientation(a, b, c).is_gt(), "{context}: {f}");
        for &p in &points {
            assert!(in_circle(a, b, c, p).is_le(), "{context}: {p} lies in the circle of {f}, {a} {b} {c}");
        }
    }
    if hull == n && triangles == 0 {
        assert_eq!(s.edge_count(), n.saturating_sub(1), "{context}: a path");
        assert!(s.vertices().all(|v| s.degree(v) <= 2), "{context}: a path");
    } else {
        assert_eq!((triangles, s.edge_count()), (2 * n - 2 - hull, 3 * n - 3 - hull), "{context}");
    }
}
