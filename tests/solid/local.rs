//! Local edits of surfaces: Euler's formula, the invariants, inverses by edits of the kernel, and every refusal.

use super::common::{Random, f, h, v};
use dcel_kit::plane::Affine;
use dcel_kit::solid::{
    BevelEdgeError, BevelVertexError, Platonic, Polyhedron, RimError, SpaceTransformError, SurfaceEditError,
    SurfaceJournal,
};
use dcel_kit::topology::{Dcel, PolygonList, isomorphic, measure, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

fn counts(p: &Polyhedron) -> [i64; 3] {
    [p.vertex_count(), p.edge_count(), p.face_count()].map(|n| n as i64)
}

/// A sheet of n x n squares, with a border.
fn sheet(n: u32) -> Polyhedron {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let points =
        (0..=n).flat_map(|i| (0..=n).map(move |j| [f64::from(i), f64::from(j), f64::from(i * j % 3)])).collect();
    let mut faces = PolygonList::new();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        faces.push_face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    Polyhedron::from_polygons(points, &faces).unwrap()
}

fn all() -> Vec<Polyhedron> {
    let mut all: Vec<Polyhedron> = Platonic::ALL.into_iter().map(Polyhedron::platonic).collect();
    all.push(sheet(2));
    all.push(sheet(3));
    let mut open = Polyhedron::platonic(Platonic::Icosahedron);
    open.remove_face(f(0)).unwrap();
    all.push(open);
    all
}

fn sound(p: &Polyhedron, words: &str) {
    assert_eq!(violations(p), [], "{words}");
    for face in p.faces() {
        let corners: Vec<VertexId> = p.incident_vertices(face).collect();
        assert!(corners.len() > 2, "{face} has {} sides: {words}", corners.len());
    }
    for face in p.boundary_faces() {
        assert!(p.has_face(face), "{face}: {words}");
    }
}

/// Contracts the face to a vertex: the inverse of cutting a vertex off, in edits of the kernel.
fn contracted(p: &Polyhedron, face: FaceId) -> Dcel {
    let mut d = p.topology().clone();
    while d.incident_half_edges(face).count() > 1 {
        d.join_vertices(d.half_edge(face).unwrap()).unwrap();
    }
    d.join_faces(d.half_edge(face).unwrap()).unwrap();
    d
}

#[test]
fn every_vertex_of_every_surface_can_be_cut_off_and_grown_back() {
    let mut made = 0;
    for start in all() {
        for vertex in start.vertices() {
            let mut p = start.clone();
            let d = p.degree(vertex);
            let words = format!("bevel_vertex {vertex} of degree {d}");
            let borders: Vec<FaceId> = p.boundary_faces().collect();
            let answer = p.bevel_vertex(vertex, 0.25);
            if d < 3 {
                assert_eq!(answer, Err(BevelVertexError::TooFewEdges { vertex, degree: d }));
                assert_eq!(p, start);
                continue;
            }
            let (side, face) = answer.unwrap();
            sound(&p, &words);
            let d = d as i64;
            let [vs, es, fs] = counts(&start);
            assert_eq!(counts(&p), [vs + d - 1, es + d, fs + 1], "{words}");
            assert_eq!((p.origin(side), p.face(side)), (vertex, face), "{words}");
            assert_eq!(p.incident_vertices(face).count() as i64, d, "{words}");
            assert!(p.boundary_faces().eq(borders), "{words}");
            // Each corner stands a quarter of the way along an edge of the old surface.
            let from = start.point(vertex);
            let mut corners: Vec<[f64; 3]> = p.incident_vertices(face).map(|w| p.point(w)).collect();
            let mut expected: Vec<[f64; 3]> = start
                .adjacent_vertices(vertex)
                .map(|w| std::array::from_fn(|i| from[i] + (start.point(w)[i] - from[i]) * 0.25))
                .collect();
            corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
            expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
            assert_eq!(corners, expected, "{words}");
            assert!(isomorphic(&contracted(&p, face), start.topology()).is_ok(), "{words}: not grown back");
            made += 1;
        }
    }
    assert!(made > 60, "{made}");
}

/// Cutting off all vertices one after the other gives the truncated solid.
#[test]
fn all_vertices_cut_off_are_the_truncated_solid() {
    let mut cube = Polyhedron::platonic(Platonic::Cube);
    for vertex in (0..8).map(v) {
        // The edges get shorter: a third of the rest, then a half.
        cube.bevel_vertex(vertex, 0.3).unwrap();
    }
    sound(&cube, "truncated cube");
    let truncated = Polyhedron::platonic(Platonic::Cube).truncated(0.3).unwrap();
    assert!(isomorphic(cube.topology(), truncated.topology()).is_ok());
}

#[test]
fn every_edge_of_every_surface_can_be_cut_off() {
    let mut made = 0;
    for start in all() {
        for h in start.half_edges() {
            let mut p = start.clone();
            let (d, e) = (p.degree(p.origin(h)), p.degree(p.destination(h)));
            let words = format!("bevel_edge {h} between degrees {d} and {e}");
            match p.bevel_edge(h, 0.25) {
                Err(error) => {
                    assert_eq!(p, start, "{words}: {error}");
                    let border = [h, h.twin()].iter().any(|&side| start.is_boundary_face(start.face(side)));
                    assert_eq!(border, matches!(error, BevelEdgeError::OnBorder { .. }), "{words}: {error}");
                    assert!(border, "{words}: {error}");
                }
                Ok((side, face)) => {
                    sound(&p, &words);
                    let corners = (d + e - 2) as i64;
                    let [vs, es, fs] = counts(&start);
                    assert_eq!(counts(&p), [vs + corners - 2, es + corners - 1, fs + 1], "{words}");
                    assert_eq!((side, p.face(h)), (h, face), "{words}");
                    assert_eq!(p.incident_vertices(face).count() as i64, corners, "{words}");
                    // The same as joining the ends and cutting off what is left.
                    let mut joined = start.topology().clone();
                    joined.join_vertices(h).unwrap();
                    assert!(isomorphic(&contracted(&p, face), &joined).is_ok(), "{words}");
                    made += 1;
                }
            }
        }
    }
    assert!(made > 200, "{made}");
}

#[test]
fn every_face_of_every_surface_gets_a_rim() {
    for start in all() {
        for face in start.faces() {
            for (share, distance) in [(0.5, 0.0), (0.0, 0.0), (0.25, -0.5)] {
                let mut p = start.clone();
                let words = format!("bevel_face {face} {share} {distance}");
                let answer = p.bevel_face(face, share, distance);
                if start.is_boundary_face(face) {
                    assert_eq!(answer, Err(RimError::BoundaryFace { face }));
                    assert_eq!(p, start);
                    continue;
                }
                let side = answer.unwrap();
                sound(&p, &words);
                let k = start.incident_vertices(face).count();
                let [vs, es, fs] = counts(&start);
                let more = k as i64;
                assert_eq!(counts(&p), [vs + more, es + 2 * more, fs + more], "{words}");
                assert_eq!((p.face(side), p.incident_vertices(face).count()), (face, k), "{words}");
                // Each new face has an old side, then a new one opposite.
                for old in start.incident_half_edges(face) {
                    assert_eq!(p.cycle(old).count(), 4, "{words}");
                    let inner = p.next(p.next(old)).twin();
                    assert_eq!(p.face(inner), face, "{words}");
                    let (from, to) = (start.point(start.origin(old)), p.point(p.origin(inner)));
                    let (mean, normal) = (start.face_mean(face), start.normal(face).unwrap());
                    for i in 0..3 {
                        let expected = from[i] + (mean[i] - from[i]) * share + normal[i] * distance;
                        assert!((to[i] - expected).abs() < 1e-12, "{words}");
                    }
                }
                // Inverse: the rim goes, and with it everything that dangles.
                let mut d = p.topology().clone();
                let inner: Vec<HalfEdgeId> = d.incident_half_edges(face).collect();
                for h in inner {
                    d.join_faces(h.twin()).unwrap();
                }
                let spokes: Vec<HalfEdgeId> =
                    start.vertices().flat_map(|v| d.outgoing_half_edges(v).collect::<Vec<_>>()).collect();
                for spoke in spokes {
                    if !start.topology().has_half_edge(spoke) && d.has_half_edge(spoke) {
                        d.join_vertices(spoke).unwrap();
                    }
                }
                assert!(isomorphic(&d, start.topology()).is_ok(), "{words}");
            }
        }
    }
}

#[test]
fn edges_are_split_joined_and_flipped_and_borders_stay() {
    for start in all() {
        for h in start.half_edges() {
            let mut p = start.clone();
            let (vertex, _) = p.split_in_half(h).unwrap();
            sound(&p, "split_in_half");
            let ends = [start.origin(h), start.destination(h)].map(|v| start.point(v));
            let [from, to] = ends;
            let middle: [f64; 3] = std::array::from_fn(|i| (from[i] + to[i]) / 2.0);
            assert!(p.point(vertex).iter().zip(middle).all(|(x, m)| (x - m).abs() < 1e-12));
            assert_eq!(p.join_edges(h), Ok(vertex));
            assert!(isomorphic(p.topology(), start.topology()).is_ok());

            let mut p = start.clone();
            p.bisect_edge(h).unwrap();
            sound(&p, "bisect_edge");
            let triangle = |side| !start.is_boundary_face(start.face(side)) && start.cycle(side).count() == 3;
            let more = [h, h.twin()].into_iter().filter(|&side| triangle(side)).count() as i64;
            let [vs, es, fs] = counts(&start);
            assert_eq!(counts(&p), [vs + 1, es + 1 + more, fs + more]);

            let mut p = start.clone();
            match p.flip_edge(h) {
                Err(error) => assert_eq!(p, start, "{error}"),
                Ok(()) => {
                    sound(&p, "flip_edge");
                    assert_eq!(counts(&p), counts(&start));
                    let outline = start.cycle(h).count() + start.cycle(h.twin()).count() - 2;
                    let mut d = p.topology().clone();
                    (1..outline).for_each(|_| d.flip_edge(h).unwrap());
                    assert!(isomorphic(&d, start.topology()).is_ok(), "{outline} flips are nothing");
                }
            }

            let mut p = start.clone();
            match p.join_faces(h) {
                Err(error) => assert_eq!(p, start, "{error}"),
                Ok(_) => sound(&p, "join_faces"),
            }
        }
    }
}

#[test]
fn refusals_say_why_and_what_to_try() {
    let mut tetrahedron = Polyhedron::platonic(Platonic::Tetrahedron);
    let before = tetrahedron.clone();
    let error = tetrahedron.flip_edge(h(0)).unwrap_err();
    assert!(matches!(error, SurfaceEditError::EdgeExists { .. }), "{error}");
    assert!(matches!(tetrahedron.join_edges(h(0)), Err(SurfaceEditError::JoinEdges(_))));
    assert!(matches!(tetrahedron.bevel_vertex(v(0), 1.0), Err(BevelVertexError::Share { .. })));
    assert!(matches!(tetrahedron.bevel_vertex(v(0), f64::NAN), Err(BevelVertexError::Share { .. })));
    assert!(matches!(tetrahedron.bevel_vertex(v(9), 0.5), Err(BevelVertexError::Id(_))));
    assert!(matches!(tetrahedron.inset_face(f(0), 1.0), Err(RimError::Share { .. })));
    assert!(matches!(tetrahedron.extrude_face(f(0), f64::INFINITY), Err(RimError::Distance { .. })));
    assert!(matches!(tetrahedron.extrude_face(f(0), 1e80), Err(RimError::Coordinate { .. })));
    assert!(tetrahedron.set_point(v(0), [0.0, f64::NAN, 0.0]).is_err());
    assert_eq!(
        tetrahedron.transform(&Affine { matrix: [[1.0; 3]; 3], shift: [0.0; 3] }),
        Err(SpaceTransformError::Flat)
    );
    assert_eq!(tetrahedron, before);
    let mut sheet = sheet(2);
    let border = sheet.boundary_faces().next().unwrap();
    let outside = sheet.half_edge(border).unwrap();
    let third = sheet.next(sheet.next(outside));
    assert_eq!(sheet.split_face(outside, third), Err(SurfaceEditError::OnBorder { h: outside, face: border }));
    assert!(matches!(sheet.flip_edge(outside), Err(SurfaceEditError::OnBorder { .. })));
    assert!(matches!(sheet.join_faces(outside), Err(SurfaceEditError::OnBorder { .. })));
    // A flat face without area has no way outwards; in place it can be pulled.
    for vertex in sheet.incident_vertices(f(0)).collect::<Vec<_>>() {
        sheet.set_point(vertex, [1.0, 1.0, 1.0]).unwrap();
    }
    assert_eq!(sheet.extrude_face(f(0), 1.0), Err(RimError::NoNormal { face: f(0) }));
    assert!(sheet.extrude_face(f(0), 0.0).is_ok());
}

/// Random long scripts of all local edits, with one log, and back to the beginning; far from the origin.
#[test]
fn long_scripts_keep_the_genus_and_are_taken_back() {
    let mut made = [0; 8];
    for seed in 0..30 {
        let mut random = Random(seed);
        let mut p = Polyhedron::platonic(Platonic::ALL[seed as usize % 5]);
        p.transform(&Affine::translation([1e9, -1e9, 1e9])).unwrap();
        if seed % 2 == 1 {
            p.remove_face(f(0)).unwrap();
        }
        let (start, mut log) = (p.clone(), SurfaceJournal::new());
        let euler = measure(&start).closed_euler();
        for _ in 0..40 {
            let a = h(random.below(p.half_edge_bound()) as u32);
            let (vertex, face) = (v(random.below(p.vertex_bound()) as u32), f(random.below(p.face_bound()) as u32));
            let b = if p.has_half_edge(a) { p.next(p.next(a)) } else { a };
            let kind = random.below(8);
            let log = &mut log;
            let done = match kind {
                0 => p.bevel_vertex_with(vertex, 0.5, log).is_ok(),
                1 => p.bevel_edge_with(a, 0.5, log).is_ok(),
                2 => p.bevel_face_with(face, 0.5, 1.0, log).is_ok(),
                3 => p.flip_edge_with(a, log).is_ok(),
                4 => p.bisect_edge_with(a, log).is_ok(),
                5 => p.split_face_with(a, b, log).is_ok(),
                6 => p.join_faces_with(a, log).is_ok(),
                _ => p.join_edges_with(a, log).is_ok(),
            };
            made[kind] += usize::from(done);
            sound(&p, &format!("seed {seed}, edit {kind}"));
            assert_eq!(measure(&p).closed_euler(), euler, "seed {seed}, edit {kind}");
            assert_eq!(p.boundary_faces().len(), start.boundary_faces().len(), "seed {seed}, edit {kind}");
        }
        p.undo(&mut log, 0);
        assert_eq!(p, start, "seed {seed}");
        assert!(log.is_empty());
    }
    assert!(made.iter().all(|&n| n > 5), "{made:?}");
}

#[test]
fn a_reflected_surface_is_right_side_out() {
    for mut p in all() {
        let (start, volume) = (p.clone(), p.signed_volume());
        p.transform(&Affine::reflection(1)).unwrap();
        sound(&p, "reflected");
        if start.boundary_faces().len() == 0 {
            assert!((p.signed_volume() - volume).abs() <= 1e-12 * volume.abs());
        }
        let faces = |p: &Polyhedron| p.faces().map(|f| p.incident_vertices(f).count()).collect::<Vec<_>>();
        assert_eq!(faces(&p), faces(&start));
        assert_ne!(p, start);
        p.transform(&Affine::reflection(1)).unwrap();
        assert_eq!(p, start);
        p.transform(&Affine { matrix: [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], shift: [0.5; 3] }).unwrap();
        assert_eq!(p.face_bound(), start.face_bound());
    }
}

#[test]
fn parts_are_checked_and_renumbering_keeps_the_surface() {
    use dcel_kit::VertexMap;
    use dcel_kit::solid::PartsError;
    let mut p = Polyhedron::platonic(Platonic::Icosahedron);
    p.remove_face(f(3)).unwrap();
    p.remove_vertex(v(7)).unwrap();
    p.bevel_vertex(v(2), 0.5).unwrap();
    let (dcel, points, borders) = p.clone().into_parts();
    assert_eq!(Polyhedron::from_parts(dcel.clone(), points.clone(), borders.clone()), Ok(p.clone()));
    let no_face = Polyhedron::from_parts(dcel.clone(), points.clone(), [f(999)]);
    assert_eq!(no_face, Err(PartsError::NoFace { face: f(999) }));
    let few = Polyhedron::from_parts(dcel.clone(), VertexMap::default(), borders.clone());
    assert!(matches!(few, Err(PartsError::NoPoint { .. })), "{few:?}");
    let mut bad = points;
    bad[v(0)] = [0.0, f64::NAN, 0.0];
    let bad = Polyhedron::from_parts(dcel, bad, borders);
    assert!(matches!(bad, Err(PartsError::Coordinate { vertex, .. }) if vertex == v(0)), "{bad:?}");

    let before = p.clone();
    let map = p.compact();
    sound(&p, "compact");
    assert_eq!(p.vertex_bound(), before.vertex_count());
    for vertex in before.vertices() {
        assert_eq!(p.point(map.vertices[vertex].unwrap()), before.point(vertex));
    }
    for face in before.faces() {
        assert_eq!(p.is_boundary_face(map.faces[face].unwrap()), before.is_boundary_face(face));
    }
    assert!(isomorphic(p.topology(), before.topology()).is_ok());
}
