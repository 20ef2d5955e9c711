//! The triangulation of points alone.

use crate::common::Random;
use crate::families::{FAMILIES, check, circle, edges, points};
use dcel_kit::VertexId;
use dcel_kit::plane::{CoordinateError, DelaunayError, Point, Subdivision};

#[test]
fn all_families_are_delaunay_by_the_definition() {
    for family in FAMILIES {
        for seed in 0..40 {
            let mut random = Random(seed);
            let n = 1 + random.below(36);
            let points = points(family, n, &mut random);
            let built = Subdivision::delaunay(&points).unwrap();
            let context = format!("{family}, seed {seed}, {n} points");
            check(&built.subdivision, &context);
            // Every point has the vertex at its place, and the first of equal points gave it its number.
            let mut next = 0;
            for (i, (&p, &v)) in points.iter().zip(&built.vertices).enumerate() {
                assert_eq!(built.subdivision.point(v), p, "{context}: point {i}");
                match points[..i].iter().position(|&q| q == p) {
                    Some(first) => {
                        assert!(built.repeated.contains(&(i as u32, first as u32)), "{context}: point {i}");
                        assert_eq!(v, built.vertices[first], "{context}: point {i}");
                    }
                    None => {
                        assert_eq!(v, VertexId::new(next), "{context}: point {i}");
                        next += 1;
                    }
                }
            }
            assert_eq!(built.repeated.len() + next as usize, n, "{context}");
            assert_eq!(built.subdivision.vertex_count(), next as usize, "{context}");
        }
    }
}

#[test]
fn the_triangulation_does_not_depend_on_the_order_of_the_points() {
    for family in FAMILIES {
        for seed in 100..110 {
            let mut random = Random(seed);
            let given = points(family, 30, &mut random);
            let mixed: Vec<Point> = random.shuffled(30).into_iter().map(|i| given[i]).collect();
            let [a, b] = [given, mixed].map(|points| edges(&Subdivision::delaunay(&points).unwrap().subdivision));
            assert_eq!(a, b, "{family}, seed {seed}");
        }
    }
}

#[test]
fn a_right_angle_turns_the_triangulation_with_the_points() {
    let turn = |p: Point| Point::new(-p.y, p.x);
    for seed in 200..220 {
        let given = points("random", 30, &mut Random(seed));
        let turned: Vec<Point> = given.iter().map(|&p| turn(p)).collect();
        let [a, b] = [&given, &turned].map(|points| Subdivision::delaunay(points).unwrap().subdivision);
        let pairs = |s: &Subdivision| {
            let ends = s.edges().map(|e| e.half_edges().map(|h| s.origin(h)));
            ends.map(|[u, v]| (u.min(v), u.max(v))).collect::<std::collections::BTreeSet<_>>()
        };
        assert_eq!(pairs(&a), pairs(&b), "seed {seed}");
    }
}

#[test]
fn few_points_points_on_a_line_and_points_on_a_circle() {
    let none = Subdivision::delaunay(&[]).unwrap().subdivision;
    assert_eq!((none.vertex_count(), none.edge_count(), none.face_count()), (0, 0, 1));
    assert_eq!(none.geometry_violations(), []);
    let one = Subdivision::delaunay(&[Point::new(2.0, 3.0); 3]).unwrap();
    assert_eq!((one.subdivision.vertex_count(), one.subdivision.edge_count()), (1, 0));
    assert_eq!(one.repeated, [(1, 0), (2, 0)]);
    assert_eq!(dcel_kit::topology::violations(&one.subdivision), []);
    assert_eq!(one.subdivision.inner_components(one.subdivision.outer_face()).len(), 1);

    // A path in the order of the line, whatever the order of the points.
    let line: Vec<Point> = [3, 0, 2, 4, 1].map(|x| Point::new(f64::from(x), 0.5 * f64::from(x))).to_vec();
    let path = Subdivision::delaunay(&line).unwrap().subdivision;
    let lengths = path.edges().map(|e| {
        let [a, b] = e.half_edges().map(|h| path.point(path.origin(h)).x);
        (a - b).abs()
    });
    assert_eq!(lengths.collect::<Vec<_>>(), [1.0; 4]);

    // All points of a circle: every triangulation of the polygon will do; a convex polygon has no other edges.
    let circle = circle();
    let s = Subdivision::delaunay(&circle).unwrap().subdivision;
    assert_eq!((circle.len(), s.face_count() - 1), (36, 34));
    check(&s, "the circle");
    // With its centre it is a wheel.
    let wheel: Vec<Point> = circle.iter().copied().chain([Point::new(0.0, 0.0)]).collect();
    let s = Subdivision::delaunay(&wheel).unwrap().subdivision;
    assert_eq!(s.degree(VertexId::new(36)), 36);
}

/// Larger inputs: too many for all pairs, enough for every level of the division and for the sort by digits.
#[test]
fn thousands_of_points_are_locally_delaunay_everywhere() {
    for (family, n) in [("random", 3000), ("grid of 60", 3600), ("clusters", 2000), ("rows", 2500)] {
        let mut random = Random(7);
        let points: Vec<Point> = match family {
            "grid of 60" => (0..n).map(|i| Point::new((i % 60) as f64, (i / 60) as f64)).collect(),
            "rows" => (0..n).map(|i| Point::new(random.below(1 << 20) as f64, (i % 3) as f64)).collect(),
            _ => points(family, n, &mut random),
        };
        let built = Subdivision::delaunay(&points).unwrap();
        let s = &built.subdivision;
        assert_eq!(dcel_kit::topology::violations(s), [], "{family}");
        assert_eq!(s.geometry_violations(), [], "{family}");
        assert_eq!(s.non_delaunay_edges(|_| false).count(), 0, "{family}");
        // f0 is the outline of the hull: it never turns left, seen along its own direction.
        let outline: Vec<Point> = s.incident_half_edges(s.outer_face()).map(|h| s.point(s.origin(h))).collect();
        for i in 0..outline.len() {
            let [a, b, c] = [0, 1, 2].map(|k| outline[(i + k) % outline.len()]);
            assert!(dcel_kit::plane::predicates::orientation(a, b, c).is_le(), "{family}");
        }
        assert_eq!(s.face_count() - 1, 2 * s.vertex_count() - 2 - outline.len(), "{family}");
    }
}

/// Heaps of points within heaps, down to the last places of their coordinates: each level leaves all of a heap in one cell
/// of the grid above it.
fn heaps(random: &mut Random, kind: &str) -> Vec<Point> {
    let mut points = vec![Point::new(-1.0, -1.0), Point::new(2.0, 2.0)];
    let centres = [(); 3].map(|()| [(); 2].map(|()| random.below(1 << 10) as f64 / 1024.0));
    for [x, y] in centres {
        for level in 1..=4 {
            // A power of two: points on a grid are not rounded.
            let step = 0.5_f64.powi(10 * level);
            let place = |random: &mut Random| match kind {
                "grids" => [random.below(32) as f64, random.below(32) as f64],
                "lines" => [(); 2].map(|()| level as f64).map(|x| x * random.below(200) as f64),
                _ => [(); 2].map(|()| 32.0 * crate::families::unit(random)),
            };
            points.extend((0..60).map(|_| place(random)).map(|[u, v]| Point::new(x + step * u, y + step * v)));
        }
        // One place, again and again.
        points.extend([Point::new(x, y); 40]);
    }
    points
}

#[test]
fn heaps_within_heaps_are_delaunay_and_do_not_depend_on_the_order_of_the_points() {
    for kind in ["random", "grids", "lines"] {
        for seed in 0..4 {
            let mut random = Random(seed);
            let given = heaps(&mut random, kind);
            let context = format!("{kind}, seed {seed}");
            let built = Subdivision::delaunay(&given).unwrap();
            let places: std::collections::BTreeSet<[u64; 2]> =
                given.iter().map(|p| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()]).collect();
            assert_eq!(built.subdivision.vertex_count(), places.len(), "{context}");
            assert_eq!(built.repeated.len(), given.len() - places.len(), "{context}");
            check(&built.subdivision, &context);
            let mixed: Vec<Point> = random.shuffled(given.len()).into_iter().map(|i| given[i]).collect();
            let [a, b] = [built.subdivision, Subdivision::delaunay(&mixed).unwrap().subdivision].map(|s| edges(&s));
            assert_eq!(a, b, "{context}");
        }
    }
}

#[test]
fn points_that_cannot_be_used_are_named() {
    let error = Subdivision::delaunay(&[Point::new(0.0, 0.0), Point::new(f64::NAN, 1.0)]).unwrap_err();
    assert!(matches!(error, DelaunayError::Coordinate { point: 1, error: CoordinateError::NotFinite { .. } }));
    assert!(error.to_string().starts_with("point 1: x is NaN"), "{error}");
    let error = Subdivision::delaunay(&[Point::new(0.0, 1e300)]).unwrap_err();
    assert!(matches!(error, DelaunayError::Coordinate { point: 0, error: CoordinateError::OutOfRange { .. } }));
    // The two zeros are one place.
    let built = Subdivision::delaunay(&[Point::new(0.0, -0.0), Point::new(-0.0, 0.0)]).unwrap();
    assert_eq!(built.repeated, [(1, 0)]);
}
