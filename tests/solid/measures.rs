//! Angles, areas, volumes and counts against what books say.

use super::common::v;
use super::shapes::{L, cut_cube, polygons, prism, torus};
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{
    Archimedean, DualError, DualPositions, FaceFault, Hand, HullFaces, Platonic, Polyhedron, TruncateError,
};
use dcel_kit::topology::{isomorphic, violations};
use dcel_kit::{FaceId, VertexId};
use std::f64::consts::{PI, TAU};

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs().max(1.0)
}

/// Dihedral angle, edge, volume for an edge of 1, area of a face for an edge of 1.
fn book(solid: Platonic) -> (f64, f64, f64, f64) {
    let (r2, r3, r5) = (2f64.sqrt(), 3f64.sqrt(), 5f64.sqrt());
    let triangle = r3 / 4.0;
    match solid {
        Platonic::Tetrahedron => ((1.0 / 3.0_f64).acos(), 2.0 * r2, r2 / 12.0, triangle),
        Platonic::Cube => (PI / 2.0, 2.0, 1.0, 1.0),
        Platonic::Octahedron => ((-1.0 / 3.0_f64).acos(), r2, r2 / 3.0, triangle),
        Platonic::Dodecahedron => {
            ((-1.0 / r5).acos(), r5 - 1.0, (15.0 + 7.0 * r5) / 4.0, (25.0 + 10.0 * r5).sqrt() / 4.0)
        }
        Platonic::Icosahedron => ((-r5 / 3.0).acos(), 2.0, 5.0 * (3.0 + r5) / 12.0, triangle),
    }
}

#[test]
fn the_five_regular_solids_have_the_angles_and_volumes_of_the_books() {
    let counts = [[4, 6, 4], [8, 12, 6], [6, 12, 8], [20, 30, 12], [12, 30, 20]];
    for (kind, counts) in Platonic::ALL.into_iter().zip(counts) {
        let solid = Polyhedron::platonic(kind);
        assert_eq!(violations(&solid), []);
        assert_eq!([solid.vertex_count(), solid.edge_count(), solid.face_count()], counts, "{kind}");
        let (dihedral, edge, volume, face) = book(kind);
        assert!(solid.edges().all(|e| near(solid.dihedral_angle(e).unwrap(), dihedral)), "{kind}");
        for e in solid.edges() {
            let [a, b] = e.half_edges().map(|h| solid.point(solid.topology().origin(h)));
            let length = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
            assert!(near(length, edge), "{kind} {e}: {length}");
        }
        assert!(near(solid.signed_volume(), volume * edge.powi(3)), "{kind}: {}", solid.signed_volume());
        assert!(near(solid.area(), face * edge.powi(2) * counts[2] as f64), "{kind}");
        let deficit = 2.0 * TAU / counts[0] as f64;
        assert!(solid.vertices().all(|v| near(solid.deficit_angle(v), deficit)), "{kind}");
        assert!(solid.faces().all(|f| solid.bend_of_face(f) < 1e-15), "{kind}");
        assert!(solid.check_convex().is_ok(), "{kind}: {:?}", solid.check_convex());
    }
}

#[test]
fn the_dual_of_a_regular_solid_is_the_other_one_and_back() {
    for kind in Platonic::ALL {
        let solid = Polyhedron::platonic(kind);
        let dual = solid.dual().unwrap();
        assert_eq!(dual.positions, DualPositions::Polar, "{kind}");
        assert!(isomorphic(&dual.solid, &Polyhedron::platonic(kind.dual())).is_ok(), "{kind}");
        let (dihedral, ..) = book(kind.dual());
        assert!(dual.solid.edges().all(|e| near(dual.solid.dihedral_angle(e).unwrap(), dihedral)), "{kind}");
        let back = dual.solid.dual().unwrap().solid;
        for v in solid.vertices() {
            let (a, b) = (solid.point(v), back.point(v));
            assert!((0..3).all(|i| near(a[i], b[i])), "{kind} {v}: {a:?} {b:?}");
        }
    }
}

/// Faces in one plane have one pole: polar, their corners would fall together.
#[test]
fn a_solid_with_neighbours_in_one_plane_has_means_for_its_dual() {
    for shape in [
        Shape::Cuboid { x: 2, y: 3, z: 4 },
        Shape::Cylinder { sides: 6, layers: 3 },
        Shape::Cone { sides: 5, layers: 2 },
    ] {
        let solid = shape.build().unwrap().polyhedron;
        assert!(solid.check_convex().is_ok(), "{shape:?}");
        let dual = solid.dual().unwrap();
        assert_eq!(dual.positions, DualPositions::Means, "{shape:?}");
        let mut places: Vec<_> = dual.solid.vertices().map(|v| dual.solid.point(v).map(f64::to_bits)).collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), solid.face_count(), "{shape:?}");
    }
    let whole = Shape::Cuboid { x: 1, y: 1, z: 1 }.build().unwrap().polyhedron;
    assert_eq!(whole.dual().unwrap().positions, DualPositions::Polar);
}

/// V, E, F, and the faces round each vertex: in the order of [`Archimedean::ALL`].
const ARCHIMEDEAN: [([usize; 3], &[usize]); 15] = [
    ([12, 18, 8], &[3, 6, 6]),
    ([24, 36, 14], &[3, 8, 8]),
    ([24, 36, 14], &[4, 6, 6]),
    ([60, 90, 32], &[3, 10, 10]),
    ([60, 90, 32], &[5, 6, 6]),
    ([12, 24, 14], &[3, 4, 3, 4]),
    ([30, 60, 32], &[3, 5, 3, 5]),
    ([24, 48, 26], &[3, 4, 4, 4]),
    ([60, 120, 62], &[3, 4, 5, 4]),
    ([48, 72, 26], &[4, 6, 8]),
    ([120, 180, 62], &[4, 6, 10]),
    ([24, 60, 38], &[3, 3, 3, 3, 4]),
    ([24, 60, 38], &[3, 3, 3, 3, 4]),
    ([60, 150, 92], &[3, 3, 3, 3, 5]),
    ([60, 150, 92], &[3, 3, 3, 3, 5]),
];

#[test]
fn the_archimedean_solids_have_equal_edges_regular_faces_and_equal_corners() {
    for (kind, (counts, corner)) in Archimedean::ALL.into_iter().zip(ARCHIMEDEAN) {
        let solid = Polyhedron::archimedean(kind);
        assert_eq!(violations(&solid), []);
        assert_eq!([solid.vertex_count(), solid.edge_count(), solid.face_count()], counts, "{kind}");
        assert!(solid.check_convex().is_ok(), "{kind}: {:?}", solid.check_convex());
        let lengths: Vec<f64> = solid
            .edges()
            .map(|e| {
                let [a, b] = e.half_edges().map(|h| solid.point(solid.topology().origin(h)));
                (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
            })
            .collect();
        let equal = |length: &f64| (length - lengths[0]).abs() <= 1e-12 * lengths[0];
        assert!(lengths.iter().all(equal), "{kind}: {lengths:?}");
        let sides = |f: FaceId| solid.incident_half_edges(f).count();
        for f in solid.faces() {
            let n = sides(f) as f64;
            let regular = PI * (n - 2.0) / n;
            assert!(solid.incident_half_edges(f).all(|h| near(solid.corner_angle(h), regular)), "{kind} {f}");
        }
        for v in solid.vertices() {
            let round: Vec<usize> = solid.incident_faces(v).map(sides).collect();
            let n = round.len();
            let turned = |k: usize| (0..n).map(|i| round[(i + k) % n]).collect::<Vec<_>>();
            let ways = (0..n).map(turned).flat_map(|way| [way.iter().rev().copied().collect(), way]);
            assert_eq!(ways.min().as_deref(), Some(corner), "{kind} {v}");
        }
    }
}

#[test]
fn snub_solids_are_twisted_to_the_side_they_say_and_are_mirror_images() {
    for (of, one, other) in [
        (Platonic::Cube, Archimedean::SnubCube(Hand::Left), Archimedean::SnubCube(Hand::Right)),
        (Platonic::Dodecahedron, Archimedean::SnubDodecahedron(Hand::Left), Archimedean::SnubDodecahedron(Hand::Right)),
    ] {
        let (of, left, right) =
            (Polyhedron::platonic(of), Polyhedron::archimedean(one), Polyhedron::archimedean(other));
        for (solid, sign) in [(&left, 1.0), (&right, -1.0)] {
            for f in of.faces() {
                let (mean, normal) = (of.face_mean(f), of.normal(f).unwrap());
                // The faces keep their numbers, and so do the places of their corners.
                for (a, b) in of.incident_vertices(f).zip(solid.incident_vertices(f)) {
                    let from: [f64; 3] = std::array::from_fn(|i| of.point(a)[i] - mean[i]);
                    let to: [f64; 3] = std::array::from_fn(|i| solid.point(b)[i] - mean[i]);
                    let turn = [
                        from[1] * to[2] - from[2] * to[1],
                        from[2] * to[0] - from[0] * to[2],
                        from[0] * to[1] - from[1] * to[0],
                    ];
                    assert!((0..3).map(|i| turn[i] * normal[i]).sum::<f64>() * sign > 0.1, "{one} {f}");
                }
            }
        }
        let mirrored = |v| left.point(v).map(|x| -x);
        let is_there = |p: [f64; 3]| right.vertices().any(|w| (0..3).all(|i| (right.point(w)[i] - p[i]).abs() < 1e-12));
        assert!(left.vertices().all(|v| is_there(mirrored(v))) && !left.vertices().all(|v| is_there(left.point(v))));
    }
}

#[test]
fn solids_by_flags_refuse_what_they_cannot_place() {
    let cube = Polyhedron::platonic(Platonic::Cube);
    for weights in [[0.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, f64::NAN], [1.0, 1.0, 0.0]] {
        assert!(matches!(cube.omnitruncated(weights), Err(TruncateError::Weights { .. })), "{weights:?}");
        assert!(matches!(cube.snub(weights, Hand::Left), Err(TruncateError::Weights { .. })), "{weights:?}");
    }
    assert!(matches!(cube.cantellated(1.0), Err(TruncateError::Weights { .. })));
    let mut open = cube.clone();
    open.remove_face(FaceId::new(0)).unwrap();
    assert!(matches!(open.cantellated(0.5), Err(TruncateError::OnBorder { .. })));
    // Any closed surface will do: V' = sum of degrees and so on.
    let torus = torus(5, 4);
    let counts = |solid: &Polyhedron| [solid.vertex_count(), solid.edge_count(), solid.face_count()];
    let [v, e, f] = counts(&torus);
    let made = [
        torus.cantellated(0.5).unwrap(),
        torus.omnitruncated([1.0; 3]).unwrap(),
        torus.snub([1.0; 3], Hand::Right).unwrap(),
    ];
    let expected = [[2 * e, 4 * e, v + e + f], [4 * e, 6 * e, v + e + f], [2 * e, 5 * e, v + 2 * e + f]];
    for (made, expected) in made.iter().zip(expected) {
        assert_eq!((counts(made), violations(made)), (expected, vec![]));
        assert_eq!(made.parts()[0].genus(), 1);
    }
}

#[test]
fn a_reflex_corner_has_its_angles_and_the_deficits_still_add_up() {
    let solid = prism(&L, 1.0);
    assert!(near(solid.total_deficit(), 2.0 * TAU), "{}", solid.total_deficit());
    assert!(near(solid.signed_volume(), 3.0) && near(solid.area(), 14.0));
    let reflex = solid.find_half_edge(v(3), v(9)).unwrap();
    assert!(near(solid.dihedral_angle(reflex.edge()).unwrap(), 1.5 * PI));
    let below = solid.incident_half_edges(FaceId::new(0)).find(|&h| solid.topology().origin(h) == v(3)).unwrap();
    assert!(near(solid.corner_angle(below), 1.5 * PI));
    // 2 pi - (3 pi / 2 + pi / 2 + pi / 2)
    assert!(near(solid.deficit_angle(v(3)), -PI / 2.0));
    assert_eq!(solid.check_convex_face(FaceId::new(0)), Err(FaceFault::Reflex(below)));
    // Steiner: a box with sides a, b, c bends by pi (a + b + c).
    let bend = |solid: &Polyhedron| {
        solid.vertices().map(|v| solid.mean_curvature(v).unwrap() * solid.vertex_area(v)).sum::<f64>()
    };
    let cuboid = prism(&[[0.0, 0.0], [3.0, 0.0], [3.0, 5.0], [0.0, 5.0]], 7.0);
    assert!(near(bend(&cuboid), 15.0 * PI), "{}", bend(&cuboid));
    assert!(near(cuboid.gauss_curvature(v(0)).unwrap() * cuboid.vertex_area(v(0)), PI / 2.0));
    // Inside out, all signs change.
    let mut inside_out = dcel_kit::topology::PolygonList::new();
    for f in cuboid.faces() {
        inside_out.push_face(&cuboid.incident_vertices(f).rev().map(VertexId::number).collect::<Vec<_>>());
    }
    let points = cuboid.vertices().map(|v| cuboid.point(v)).collect();
    let inside_out = Polyhedron::from_polygons(points, &inside_out).unwrap();
    assert!(near(inside_out.signed_volume(), -105.0) && near(bend(&inside_out), -15.0 * PI));
}

#[test]
fn deficits_add_up_to_the_euler_characteristic_with_handles_borders_and_touching_fans() {
    let torus = torus(7, 5);
    let [part] = torus.parts()[..] else { panic!("one piece") };
    assert_eq!((part.euler(), part.genus(), part.borders), (0, 1, 0));
    assert!(torus.total_deficit().abs() < 1e-12);
    assert!(!part.is_genus_zero());

    let mut open = cut_cube(3);
    for f in [4, 21, 22, 50] {
        open.remove_face(FaceId::new(f)).unwrap();
    }
    let [part] = open.parts()[..] else { panic!("one piece") };
    assert_eq!((part.euler(), part.genus(), part.borders), (-1, 0, 3));
    assert!(near(open.total_deficit(), -TAU), "{}", open.total_deficit());
    assert_eq!(open.dual_graph().count(), open.edge_count() - 14);

    let mut bow_tie = Polyhedron::new();
    let p: Vec<_> = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 3.0, 0.0], [-2.0, -1.0, 5.0], [-1.0, -4.0, 1.0]]
        .into_iter()
        .map(|point| bow_tie.add_vertex(point).unwrap())
        .collect();
    bow_tie.add_face(&[p[0], p[1], p[2]]).unwrap();
    bow_tie.add_face(&[p[0], p[3], p[4]]).unwrap();
    let [part] = bow_tie.parts()[..] else { panic!("one piece") };
    assert_eq!((part.euler(), part.borders), (1, 1));
    assert!(near(bow_tie.total_deficit(), TAU), "{}", bow_tie.total_deficit());
}

#[test]
fn flat_is_exact_and_convex_goes_round_once() {
    let tent = |z: f64| {
        let points = vec![[0.0, 0.0, 0.1], [1.0, 0.0, 0.1], [1.0, 1.0, 0.1 + z], [0.0, 1.0, 0.1]];
        Polyhedron::from_polygons(points, &polygons(&[&[0, 1, 2, 3]])).unwrap()
    };
    assert!(tent(0.0).is_flat(FaceId::new(0)));
    assert!(!tent(f64::EPSILON / 8.0).is_flat(FaceId::new(0)));
    // A pentagram turns left at each corner, twice round.
    let corner = |i: f64| [(TAU * i / 5.0).cos(), (TAU * i / 5.0).sin(), 0.0];
    let star =
        Polyhedron::from_polygons([0.0, 2.0, 4.0, 1.0, 3.0].map(corner).to_vec(), &polygons(&[&[0, 1, 2, 3, 4]]));
    assert!(matches!(star.unwrap().check_convex_face(FaceId::new(0)), Err(FaceFault::Reflex(_))));
    let pentagon =
        Polyhedron::from_polygons([0.0, 1.0, 2.0, 3.0, 4.0].map(corner).to_vec(), &polygons(&[&[0, 1, 2, 3, 4]]));
    assert_eq!(pentagon.unwrap().check_convex_face(FaceId::new(0)), Ok(()));
    let line = vec![[0.0; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0], [2.0, 2.0, 2.0]];
    let line = Polyhedron::from_polygons(line, &polygons(&[&[0, 1, 2, 3]])).unwrap();
    assert_eq!(line.check_convex_face(FaceId::new(0)), Err(FaceFault::NoArea));
}

#[test]
fn what_has_no_dual_or_corners_to_cut_is_named() {
    let mut open = Polyhedron::platonic(Platonic::Cube);
    assert_eq!(open.truncated(0.5).unwrap_err(), TruncateError::Ratio { ratio: 0.5 });
    assert!(matches!(open.truncated(f64::NAN), Err(TruncateError::Ratio { .. })));
    open.remove_face(FaceId::new(2)).unwrap();
    let border = open.boundary_faces().next().unwrap();
    assert_eq!(open.dual().unwrap_err(), DualError::Open { boundary_face: border });
    assert!(matches!(open.rectified(), Err(TruncateError::OnBorder { .. })));
    let disc = Polyhedron::from_polygons(vec![[0.0; 3]; 3], &polygons(&[&[0, 1, 2], &[0, 2, 1]])).unwrap();
    assert_eq!(disc.dual().unwrap_err(), DualError::TooFewEdges { vertex: v(0), degree: 2 });
    assert_eq!(disc.rectified().unwrap_err(), TruncateError::TooFewEdges { vertex: v(0), degree: 2 });
    // Without the origin inside: means of the corners.
    let far = prism(&[[5.0, 5.0], [6.0, 5.0], [6.0, 6.0], [5.0, 6.0]], 1.0);
    let dual = far.dual().unwrap();
    assert_eq!(dual.positions, DualPositions::Means);
    assert_eq!(dual.solid.point(v(0)), [5.5, 5.5, 0.0]);
}

/// The curve is closed, and the faces hang together without the edges of the curve.
#[test]
fn a_handle_is_shown_by_a_curve_that_does_not_cut() {
    let check = |solid: &Polyhedron| {
        let curve = solid.curve_without_sides().expect("a handle");
        let dcel = solid.topology();
        for (i, &h) in curve.iter().enumerate() {
            assert_eq!(dcel.destination(h), dcel.origin(curve[(i + 1) % curve.len()]), "{curve:?}");
        }
        let mut edges: Vec<_> = curve.iter().map(|h| h.edge()).collect();
        edges.sort_unstable();
        edges.dedup();
        assert_eq!(edges.len(), curve.len(), "an edge twice: {curve:?}");
        let mut met = vec![dcel.face(curve[0])];
        let mut done = 0;
        while let Some(&face) = met.get(done) {
            done += 1;
            for h in dcel.incident_half_edges(face).filter(|h| edges.binary_search(&h.edge()).is_err()) {
                if !met.contains(&dcel.face(h.twin())) {
                    met.push(dcel.face(h.twin()));
                }
            }
        }
        let piece = solid.parts().into_iter().find(|part| part.genus() > 0).unwrap();
        assert_eq!(met.len(), piece.faces + piece.borders, "{curve:?}");
    };
    for (n, m) in [(3, 3), (7, 5), (4, 9)] {
        let mut solid = torus(n, m);
        check(&solid);
        solid.remove_face(FaceId::new(2)).unwrap();
        check(&solid);
    }
    check(&Shape::Torus { n: 1, m: 1 }.build().unwrap().polyhedron);
    let mut open = cut_cube(3);
    assert_eq!(open.curve_without_sides(), None);
    open.remove_face(FaceId::new(0)).unwrap();
    open.remove_face(FaceId::new(30)).unwrap();
    assert_eq!(open.curve_without_sides(), None);
    assert_eq!(prism(&L, 1.0).curve_without_sides(), None);
}

/// Volumes and areas do not change when a solid is moved, and are those of whole numbers.
#[test]
fn measures_far_from_the_origin_and_of_thin_solids_are_right() {
    let mut random = super::common::Random(11);
    let mut hard = 0;
    for round in 0..300 {
        // Whole numbers times a power of two, so far off that sums of doubles keep few digits.
        let offset = [0_i64, 1 << 40, -(1 << 44), 3 << 45][round % 4];
        let flat = [1000, 1000, 3][round % 3];
        let points: Vec<[i64; 3]> = (0..5 + random.below(12))
            .map(|_| {
                let [x, y] = [random.below(1000), random.below(1000)].map(|x| x as i64);
                [x, y, x + 2 * y + random.below(flat) as i64]
            })
            .collect();
        let unit = 2f64.powi(-10);
        let placed: Vec<[f64; 3]> = points.iter().map(|p| p.map(|x| (x + offset) as f64 * unit)).collect();
        let Ok(hull) = Polyhedron::convex_hull(&placed, HullFaces::Whole) else { continue };
        let solid = &hull.solid;
        let at = |v| points[hull.points[v] as usize];
        let (mut six, mut area) = (0_i64, 0.0);
        for f in solid.faces() {
            let corners: Vec<[i64; 3]> = solid.incident_vertices(f).map(at).collect();
            let mut vector = [0_i64; 3];
            for (p, q) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                for (k, sum) in vector.iter_mut().enumerate() {
                    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                    *sum += p[i] * q[j] - p[j] * q[i];
                }
            }
            six += (0..3).map(|k| vector[k] * corners[0][k]).sum::<i64>();
            let expected = vector.map(|x| 0.5 * x as f64 * unit * unit);
            assert_eq!(solid.area_vector(f), expected, "round {round}: {f}");
            area += expected.iter().map(|x| x * x).sum::<f64>().sqrt();
        }
        // Each face vector counts twice the area.
        let volume = six as f64 / 6.0 * unit * unit * unit;
        assert!((solid.signed_volume() - volume).abs() <= 1e-12 * volume, "round {round}: {}", solid.signed_volume());
        assert!((solid.area() - area).abs() <= 1e-12 * area, "round {round}");
        hard += usize::from(flat == 3 && offset != 0);
    }
    assert!(hard > 40, "{hard}");
}

/// A needle far from its own first corner: sums of doubles lose its area.
#[test]
fn slivers_have_the_area_of_their_corners() {
    let e = 2f64.powi(-52);
    // (0, 0), (1, 1 + e), (3, 3 + 3e + 2e): twice the area is 2e, between products of 3.
    let corners = [[0.0, 0.0, 0.0], [1.0, 1.0 + e, 0.0], [3.0, 3.0 + 6.0 * e, 0.0], [1.0, 1.0, -1.0]];
    let solid = Polyhedron::convex_hull(&corners, HullFaces::Triangles).unwrap().solid;
    let areas: Vec<[f64; 3]> = solid.faces().map(|f| solid.area_vector(f)).collect();
    assert!(areas.contains(&[0.0, 0.0, 1.5 * e]), "{areas:?}");
    let volume = solid.signed_volume();
    assert!((volume - 1.5 * e / 3.0).abs() < 1e-12 * volume, "{volume:e}");
}
