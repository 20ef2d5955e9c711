//! Convexity of solids whose faces are flat only up to rounding, against the definition: at each edge, every corner of
//! the one face fits every corner of the other.

use super::common::Random;
use super::shapes::{prism, torus};
use dcel_kit::HalfEdgeId;
use dcel_kit::solid::predicates::{are_collinear, orient3d};
use dcel_kit::solid::{NotConvex, Polyhedron};
use dcel_kit::topology::PolygonList;
use std::cmp::Ordering;

type Vector = [f64; 3];

/// A drum over a regular polygon of `2 k` corners, turned in space so that no face is flat exactly. Its lid is two
/// polygons of `k + 1` corners each, one of them sloping down by `slope` from the edge between them.
fn turned_drum(k: u32, slope: f64, random: &mut Random) -> Polyhedron {
    let angles = [(); 3].map(|()| random.below(6283) as f64 / 1000.0);
    let turn = |mut p: Vector| {
        for (axis, angle) in angles.into_iter().enumerate() {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let (sin, cos) = angle.sin_cos();
            (p[i], p[j]) = (cos * p[i] - sin * p[j], sin * p[i] + cos * p[j]);
        }
        p
    };
    let n = 2 * k;
    let corner = |i: u32, top: bool| {
        let (y, x) = (f64::from(i) * std::f64::consts::PI / f64::from(k)).sin_cos();
        turn([x, y, if top { 1.0 - slope * y.max(0.0) } else { 0.0 }])
    };
    let mut faces = PolygonList::new();
    faces.push_face(&(0..n).rev().collect::<Vec<_>>());
    faces.push_face(&(n..=n + k).collect::<Vec<_>>());
    faces.push_face(&(n + k..2 * n).chain([n]).collect::<Vec<_>>());
    for i in 0..n {
        let j = (i + 1) % n;
        faces.push_face(&[i, j, n + j, n + i]);
    }
    let points = (0..n).map(|i| corner(i, false)).chain((0..n).map(|i| corner(i, true)));
    Polyhedron::from_polygons(points.collect(), &faces).unwrap()
}

/// Whether no edge is reflex, by asking each pair of corners.
fn fits_everywhere(solid: &Polyhedron) -> bool {
    let dcel = solid.topology();
    solid.edges().all(|e| {
        let [h, twin] = e.half_edges();
        let [a, b] = [h, twin].map(|h| solid.point(dcel.origin(h)));
        let corners = |h: HalfEdgeId| {
            let all: Vec<Vector> = dcel.cycle(h).map(|g| solid.point(dcel.origin(g))).collect();
            all.into_iter().filter(|&p| !are_collinear(a, b, p)).collect::<Vec<_>>()
        };
        let of_right = corners(twin);
        corners(h).into_iter().all(|c| of_right.iter().all(|&d| orient3d(a, b, c, d) == Ordering::Less))
    })
}

#[test]
fn bent_faces_of_any_size_are_judged_as_by_all_pairs_of_corners() {
    let mut random = Random(41);
    let mut seen = [0; 2];
    for round in 0..120 {
        // On both sides of the size from which a face has a hull of its own.
        let k = 2 + random.below(28) as u32;
        let slope = [0.0, 1e-16, -1e-16, 4e-16, -4e-16, 1e-15][round % 6];
        let solid = turned_drum(k, slope, &mut random);
        let expected = match solid.check_convex() {
            // Faces are judged before edges.
            Err(NotConvex::ReflexCorner { .. } | NotConvex::NoArea { .. }) => continue,
            Err(NotConvex::ReflexEdge { .. }) => false,
            Ok(_) => true,
            Err(other) => panic!("round {round}: {other}"),
        };
        assert_eq!(fits_everywhere(&solid), expected, "round {round}, {k}, slope {slope}");
        seen[usize::from(expected)] += 1;
    }
    assert!(seen[0] >= 20 && seen[1] >= 20, "{seen:?}");
}

/// At an edge in the middle of a long straight side, the corners next to it are in line with it.
#[test]
fn a_flat_face_with_long_straight_sides_is_judged_by_a_corner_beside_them() {
    let n = 40;
    let row = |y: f64| (0..=n).map(move |i| [f64::from(i), y]);
    let base: Vec<[f64; 2]> = row(0.0).chain(row(1.0).rev()).collect();
    assert!(prism(&base, 2.0).check_convex().is_ok());
    let mut dented = base.clone();
    dented[20][1] = 1e-40;
    assert!(matches!(prism(&dented, 2.0).check_convex(), Err(NotConvex::ReflexCorner { .. })));
}

#[test]
fn measures_of_a_surface_looked_at_once_are_those_asked_one_by_one() {
    for solid in [torus(7, 5), prism(&[[0.0, 0.0], [3.0, 0.5], [2.0, 2.0]], 1.5), turned_drum(9, 0.1, &mut Random(3))] {
        let measures = solid.measures();
        for h in solid.half_edges() {
            assert_eq!(measures.corner_angle(h).to_bits(), solid.corner_angle(h).to_bits());
        }
        for e in solid.edges() {
            assert_eq!(measures.dihedral_angle(e), solid.dihedral_angle(e));
        }
        for v in solid.vertices() {
            assert_eq!(measures.deficit_angle(v), solid.deficit_angle(v));
            assert_eq!(measures.gauss_curvature(v), solid.gauss_curvature(v));
            assert_eq!(measures.mean_curvature(v), solid.mean_curvature(v));
        }
        let one_by_one: f64 = solid.vertices().map(|v| solid.deficit_angle(v)).sum();
        assert_eq!(solid.total_deficit().to_bits(), one_by_one.to_bits());
    }
}
