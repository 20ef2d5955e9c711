//! Convex hulls against all planes through three points, in whole numbers.

use super::common::Random;
use super::shapes::{grid_points, round_solid};
use dcel_kit::solid::{HullError, HullFaces, Polyhedron};
use dcel_kit::topology::violations;
use std::collections::{BTreeMap, BTreeSet};

fn whole(p: [f64; 3]) -> [i64; 3] {
    p.map(|x| x as i64)
}

fn minus(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The sides of the hull as sets of positions: each set lies in a plane with all other points below. None if the
/// points lie in a plane.
fn sides(points: &[[f64; 3]]) -> Option<BTreeSet<BTreeSet<[i64; 3]>>> {
    let p: Vec<[i64; 3]> = points.iter().map(|&p| whole(p)).collect();
    let mut sides = BTreeSet::new();
    for (i, &a) in p.iter().enumerate() {
        for (j, &b) in p.iter().enumerate() {
            for &c in p.iter().skip(i.max(j) + 1) {
                let normal = cross(minus(b, a), minus(c, a));
                let heights = || p.iter().map(|&q| dot(normal, minus(q, a)));
                if normal == [0; 3] || heights().any(|height| height > 0) {
                    continue;
                }
                if heights().all(|height| height == 0) {
                    return None;
                }
                sides.insert(p.iter().copied().filter(|&q| dot(normal, minus(q, a)) == 0).collect());
            }
        }
    }
    (!sides.is_empty()).then_some(sides)
}

#[test]
fn hulls_of_few_points_are_what_all_triples_say() {
    let (mut solids, mut flat, mut inner, mut whole_sides) = (0, 0, 0, 0);
    for seed in 0..1500 {
        let mut random = Random(seed);
        let (count, size) = (4 + random.below(9), 1 + random.below(3));
        let points = grid_points(&mut random, count, size);
        let answer = Polyhedron::convex_hull(&points, HullFaces::Whole);
        let Some(sides) = sides(&points) else {
            assert!(
                matches!(
                    answer,
                    Err(HullError::Coplanar { .. } | HullError::Collinear { .. } | HullError::AllEqual { .. })
                ),
                "seed {seed}: {answer:?}"
            );
            flat += 1;
            continue;
        };
        let hull = answer.unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        let solid = &hull.solid;
        assert_eq!(violations(solid), [], "seed {seed}");
        assert!(solid.check_convex().is_ok(), "seed {seed}: {:?}", solid.check_convex());
        // Corners lie on three sides or more; a point on an edge lies on two.
        let mut on: BTreeMap<[i64; 3], usize> = BTreeMap::new();
        sides.iter().flatten().for_each(|&p| *on.entry(p).or_default() += 1);
        let extreme: BTreeSet<_> = on.iter().filter(|&(_, &sides)| sides >= 3).map(|(&p, _)| p).collect();
        let corners: BTreeSet<_> = solid.vertices().map(|v| whole(solid.point(v))).collect();
        assert_eq!(corners, extreme, "seed {seed}");
        assert_eq!(corners.len(), solid.vertex_count(), "seed {seed}");
        for v in solid.vertices() {
            assert_eq!(points[hull.points[v] as usize], solid.point(v), "seed {seed}");
        }
        assert!(hull.points.as_slice().is_sorted(), "seed {seed}");
        let found: BTreeSet<BTreeSet<_>> =
            solid.faces().map(|f| solid.incident_vertices(f).map(|v| whole(solid.point(v))).collect()).collect();
        let expected: BTreeSet<BTreeSet<_>> =
            sides.iter().map(|side| side.iter().copied().filter(|p| extreme.contains(p)).collect()).collect();
        assert_eq!(found, expected, "seed {seed}");
        assert!(solid.signed_volume() > 0.0, "seed {seed}");

        let cut = Polyhedron::convex_hull(&points, HullFaces::Triangles).unwrap();
        assert!(cut.solid.faces().all(|f| cut.solid.incident_half_edges(f).count() == 3));
        assert_eq!(cut.points, hull.points);
        assert_eq!(cut.solid.face_count(), 2 * cut.solid.vertex_count() - 4, "seed {seed}");
        let difference = cut.solid.signed_volume() - solid.signed_volume();
        assert!(difference.abs() < 1e-9, "seed {seed}");
        solids += 1;
        inner += usize::from(solid.vertex_count() < points.len());
        whole_sides += usize::from(solid.faces().any(|f| solid.incident_half_edges(f).count() > 4));
    }
    assert!(solids > 1000 && flat > 20 && inner > 500 && whole_sides > 50, "{solids} {flat} {inner} {whole_sides}");
}

/// Many points of a small grid: long rows in one line and in one plane, most points given several times.
#[test]
fn crowded_grids_keep_only_their_corners() {
    for seed in 0..20 {
        let mut random = Random(seed);
        let mut points = grid_points(&mut random, 3000, 5);
        points.extend((0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|bit| f64::from(10 * bit - 5))));
        let solid = Polyhedron::convex_hull(&points, HullFaces::Whole).unwrap().solid;
        assert_eq!((solid.vertex_count(), solid.edge_count(), solid.face_count()), (8, 12, 6), "seed {seed}");
    }
}

/// A horizon with many edges: an apex over a wide base, in every order. Points have to search for their triangle.
#[test]
fn an_apex_over_a_wide_base_joins_all_its_corners() {
    for (seed, n) in [(1, 40), (2, 300), (3, 1000)] {
        // Points of a parabola are in convex position, in whole numbers; two heights.
        let mut points: Vec<[f64; 3]> = (0..n)
            .map(|i| {
                let x = f64::from(i) - f64::from(n / 2);
                [x, x * x, f64::from(i % 2)]
            })
            .collect();
        points.push([0.0, f64::from(n * n), 1e7]);
        points.push([0.25, f64::from(n), -1e7]);
        let mut random = Random(seed);
        let shuffled: Vec<_> = random.shuffled(points.len()).into_iter().map(|i| points[i]).collect();
        let hull = Polyhedron::convex_hull(&shuffled, HullFaces::Triangles).unwrap();
        assert!(hull.solid.check_convex().is_ok());
        assert_eq!(violations(&hull.solid), []);
        let at = |z: f64| hull.solid.vertices().find(|&v| hull.solid.point(v)[2] == z).unwrap();
        assert!(hull.solid.degree(at(1e7)) + hull.solid.degree(at(-1e7)) > n as usize, "{n}");
        for p in &points {
            let above = hull.solid.faces().any(|f| {
                let mut corners = hull.solid.incident_vertices(f).map(|v| hull.solid.point(v));
                let [a, b, c] = std::array::from_fn(|_| corners.next().unwrap());
                dcel_kit::solid::predicates::orient3d(a, b, c, *p).is_gt()
            });
            assert!(!above, "{p:?} lies outside, n = {n}");
        }
    }
}

#[test]
fn hulls_of_round_clouds_are_convex_and_hold_all_points() {
    let mut random = Random(7);
    let solid = round_solid(&mut random, 4000);
    assert!(solid.check_convex().is_ok());
    assert!(solid.vertex_count() > 3900, "{}", solid.vertex_count());
    let [part] = solid.parts()[..] else { panic!("one piece") };
    assert_eq!((part.genus(), part.edges), (0, 3 * part.vertices - 6));
}

#[test]
fn points_that_span_no_solid_are_named() {
    let hull = |points: &[[f64; 3]]| Polyhedron::convex_hull(points, HullFaces::Whole).unwrap_err();
    assert_eq!(hull(&[]), HullError::NoPoint);
    assert_eq!(hull(&[[1.0, 2.0, 3.0]; 5]), HullError::AllEqual { points: 5 });
    let line: Vec<_> = (0..9).map(|i| [f64::from(i % 5), 2.0 * f64::from(i % 5), 0.0]).collect();
    assert_eq!(hull(&line), HullError::Collinear { through: [0, 4] });
    let tenth: Vec<_> = (0..9).map(|i| [0.1 * f64::from(i), 0.1 * f64::from(i), f64::from(i % 2)]).collect();
    assert!(matches!(hull(&tenth), HullError::Coplanar { .. }), "rounded coordinates, x = y");
    let mut bad = line.clone();
    bad[3][1] = f64::INFINITY;
    assert!(matches!(hull(&bad), HullError::Coordinate { point: 3, .. }));
    // One step of rounding out of the plane is a solid.
    let mut thin = vec![[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0]];
    thin[3][2] += f64::EPSILON;
    let solid = Polyhedron::convex_hull(&thin, HullFaces::Whole).unwrap().solid;
    assert_eq!((solid.vertex_count(), solid.face_count()), (4, 4));
}

/// A wide cap of points, all of them corners, and an apex that sees its middle: points that lose their triangle to
/// the apex and are still outside must find another one, among many.
#[test]
fn points_beyond_a_wide_horizon_are_not_lost() {
    for seed in 0..12 {
        let mut points: Vec<[f64; 3]> = (0..29 * 29)
            .map(|i| [f64::from(i % 29) - 14.0, f64::from(i / 29) - 14.0])
            .map(|[x, y]| [x, y, -(x * x + y * y)])
            .collect();
        points.push([0.0, 0.0, 130.5]);
        let mut random = Random(seed);
        let shuffled: Vec<_> = random.shuffled(points.len()).into_iter().map(|i| points[i]).collect();
        let hull = Polyhedron::convex_hull(&shuffled, HullFaces::Triangles).unwrap();
        // The cone from the apex touches the cap where x^2 + y^2 = 130.5.
        let outside = points.iter().filter(|p| p[0] * p[0] + p[1] * p[1] > 130.5).count();
        let apex = hull.solid.vertices().find(|&v| hull.solid.point(v)[2] > 0.0).unwrap();
        assert!(hull.solid.degree(apex) > 16, "seed {seed}");
        let kept = hull.solid.vertices().filter(|&v| {
            let [x, y, _] = hull.solid.point(v);
            x * x + y * y > 130.5
        });
        assert_eq!(kept.count(), outside, "seed {seed}");
        assert!(hull.solid.check_convex().is_ok(), "seed {seed}");
    }
}

/// Clouds that nearly lie on a line, in a plane, on a sphere, or nearly coincide, in every size and place.
fn awkward_points(random: &mut Random) -> Vec<[f64; 3]> {
    let kind = random.below(8);
    let offset = [0.0, 0.0, 1e-15, 1.0, 1e6, 1e15][random.below(6)];
    let scale = [1.0, 1.0, 1e-15, 1e15, 1e-3][random.below(5)];
    let count = 4 + random.below(20);
    let mut number = |size: usize| random.below(size) as f64;
    (0..count)
        .map(|_| {
            let [a, b, c] = [number(11), number(11), number(11)];
            let mut nudge = |x: f64| (0..number(4) as u32).fold(x, |x, _| x.next_up());
            let p = match kind {
                // A grid of tenths.
                0 => [a * 0.1, b * 0.1, c * 0.1],
                // Nearly in the plane z = x + y, up to rounding.
                1 => [a * 0.1, b * 0.1, a * 0.1 + b * 0.1],
                2 => [a * 0.1, b * 0.1, nudge(a * 0.1 + b * 0.1)],
                // Nearly on one line.
                3 => [nudge(a * 0.1), nudge(a * 0.3), nudge(a * 0.7)],
                // Needles: a line and a point far off.
                4 if c < 1.0 => [5.0, 7.0, b],
                4 => [nudge(a * 0.1), nudge(a * 0.2), nudge(a * 0.3)],
                // Nearly one point.
                5 => [nudge(1.0), nudge(1.1), nudge(1.2)],
                // On a sphere, and its equator.
                6 => [(a * b).cos(), (a * b).sin(), if c < 5.0 { 0.0 } else { 1e-16 * c }],
                _ => [a.cos() * b.sin(), a.sin() * b.sin(), b.cos()],
            };
            p.map(|x| x * scale + offset).map(|x| if x.abs() < dcel_kit::plane::SMALLEST { 0.0 } else { x })
        })
        .collect()
}

#[test]
fn hulls_are_convex_for_the_kits_own_check() {
    let tries = std::env::var("HULLS").map_or(3000, |count| count.parse().expect("a number"));
    let mut solids = 0;
    for seed in 0..tries {
        let points = awkward_points(&mut Random(seed));
        for faces in [HullFaces::Whole, HullFaces::Triangles] {
            match Polyhedron::convex_hull(&points, faces) {
                Ok(hull) => {
                    solids += 1;
                    let verdict = hull.solid.check_convex().map(|_| ());
                    assert_eq!(verdict, Ok(()), "seed {seed}, {faces:?}: {points:?}");
                }
                Err(HullError::Collinear { .. } | HullError::Coplanar { .. } | HullError::AllEqual { .. }) => {}
                Err(error) => panic!("seed {seed}: {error}"),
            }
        }
    }
    assert!(solids > tries, "{solids} solids of {tries} clouds");
}

/// Clouds that are large enough for a core, in every shape that it may be wrong about: no point may lie above a side.
#[test]
fn large_hulls_hold_all_points() {
    let unit = |r: &mut Random| r.below(1 << 20) as f64 / f64::from(1 << 20);
    let in_ball = move |r: &mut Random| {
        loop {
            let p = [(); 3].map(|()| 2.0 * unit(r) - 1.0);
            if p.iter().map(|x| x * x).sum::<f64>() <= 1.0 {
                return p;
            }
        }
    };
    type Place = Box<dyn Fn(&mut Random) -> [f64; 3]>;
    let shapes: [(&str, Place); 9] = [
        ("a ball", Box::new(in_ball)),
        ("a cube", Box::new(move |r| [(); 3].map(|()| unit(r)))),
        ("a lattice", Box::new(|r| [(); 3].map(|()| r.below(20) as f64))),
        (
            "an ellipsoid",
            Box::new(move |r| {
                let [x, y, z] = in_ball(r);
                [1e3 * x, y, 1e-3 * z]
            }),
        ),
        (
            "a slanted slab",
            Box::new(move |r| {
                let [x, y, z] = in_ball(r);
                [x + 1e-3 * z, y - 1e-3 * z, x + y + 1e-3 * z]
            }),
        ),
        (
            "a corner of a cube",
            Box::new(move |r| {
                let mut p = [(); 3].map(|()| unit(r));
                p.sort_by(f64::total_cmp);
                [p[0], p[1] - p[0], p[2] - p[1]]
            }),
        ),
        (
            "clusters",
            Box::new(move |r| {
                let centre = [[0.0; 3], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 9.0], [2.0; 3]][r.below(5)];
                let p = in_ball(r);
                std::array::from_fn(|i| centre[i] + 1e-3 * p[i])
            }),
        ),
        ("far away", Box::new(|r| [(); 3].map(|()| 1e15 + r.below(64) as f64 * 0.125))),
        ("a ball and a far point", Box::new(move |r| if r.below(3000) == 0 { [1e6; 3] } else { in_ball(r) })),
    ];
    for (name, place) in &shapes {
        let mut random = Random(name.len() as u64);
        let points: Vec<[f64; 3]> = (0..12_000).map(|_| place(&mut random)).collect();
        let hull = Polyhedron::convex_hull(&points, HullFaces::Triangles).unwrap();
        assert!(hull.solid.check_convex().is_ok(), "{name}");
        for f in hull.solid.faces() {
            let mut corners = hull.solid.incident_vertices(f).map(|v| hull.solid.point(v));
            let [a, b, c] = std::array::from_fn(|_| corners.next().unwrap());
            let above = points.iter().find(|&&p| dcel_kit::solid::predicates::orient3d(a, b, c, p).is_gt());
            assert_eq!(above, None, "{name}: a point outside of {f}");
        }
        for v in hull.solid.vertices() {
            let point = hull.solid.point(v);
            assert_eq!(points[hull.points[v] as usize], point, "{name}: {v}");
        }
    }
}
