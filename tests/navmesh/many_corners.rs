//! Faces of many corners: what lies round their vertices, what leads on from them, and what a surface has over itself.

use crate::maps::Random;
use dcel_kit::FaceId;
use dcel_kit::navmesh::{NavMesh, NavSurface, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::topology::PolygonList;
use std::collections::BTreeSet;

/// A hub of `n` corners inside two rings of four-sided faces; of the inner ring those are missing that `is_gap` names.
fn wheel(n: u32, is_gap: impl Fn(u32) -> bool) -> Subdivision {
    let mut points = Vec::new();
    for ring in 1..=3 {
        points.extend((0..n).map(|i| {
            let (s, c) = (std::f64::consts::TAU * f64::from(i) / f64::from(n)).sin_cos();
            Point::new(f64::from(ring) * c, f64::from(ring) * s)
        }));
    }
    let mut faces = PolygonList::new();
    faces.push_face(&(0..n).collect::<Vec<_>>());
    for ring in 0..2 {
        for i in (0..n).filter(|&i| ring == 1 || !is_gap(i)) {
            let (a, b) = (ring * n + i, ring * n + (i + 1) % n);
            faces.push_face(&[a, a + n, b + n, b]);
        }
    }
    Subdivision::from_polygons(points, &faces).expect("rings round a hub")
}

fn check_around(map: &Subdivision, mesh: &NavMesh, context: &str) {
    for v in map.vertices() {
        let expected: BTreeSet<FaceId> = map.incident_faces(v).filter(|&f| mesh.has_face(f)).collect();
        let around = mesh.faces_around(v);
        assert_eq!(around.iter().copied().collect::<BTreeSet<_>>(), expected, "{context}: round {v}");
        assert_eq!(around.len(), expected.len(), "{context}: round {v}");
        let in_wedges: BTreeSet<FaceId> = mesh.wedges(v).into_iter().flatten().collect();
        assert_eq!(in_wedges, expected.into_iter().filter(|&f| !mesh.is_blocked(f)).collect(), "{context}: {v}");
    }
}

#[test]
fn a_hub_of_many_corners_is_what_its_triangles_are() {
    for (n, every) in [(9, 0), (24, 3), (27, 3), (60, 0), (200, 7)] {
        let context = format!("{n} corners, every {every}");
        let mut map = wheel(n, |i| every > 0 && i % every == 0);
        let mut mesh = NavMesh::new(&map).expect("convex");
        check_around(&map, &mesh, &context);
        let mut cut = map.clone();
        cut.triangulate(TriangulationMethod::Delaunay).expect("convex faces");
        let triangles = NavMesh::new(&cut).expect("triangles");
        let hub = FaceId::new(1);
        let gaps = map.hole_faces().count() as u32;
        assert_eq!(gaps, if every > 0 { n.div_ceil(every) } else { 0 });
        assert!(mesh.link_junctions() > 0 && mesh.junctions().any(|f| f == hub), "{context}: the hub is a junction");
        let mut random = Random::new(u64::from(n));
        let (mut planner, mut plain) = (Planner::new(), Planner::face_by_face());
        for round in 0..40 {
            if round == 20 {
                // What follows knows no way over the hub, and what is around it is found anew.
                mesh.block(hub);
                check_around(&map, &mesh, &context);
                map.set_hole(hub, true);
            }
            let [a, b] = [(); 2].map(|()| {
                let (angle, far) = (random.unit() * std::f64::consts::TAU, 2.05 + 0.7 * random.unit());
                Point::new(far * angle.cos(), far * angle.sin())
            });
            let of = |planner: &mut Planner, mesh: &NavMesh, algorithm| {
                let [a, b] = [a, b].map(|p| mesh.place(p).expect("on the outer ring"));
                planner.route(mesh, algorithm, &a, &b).expect("in one piece")
            };
            let fewest = of(&mut planner, &mesh, PathAlgorithm::Breadth).faces.len();
            assert_eq!(fewest, of(&mut plain, &mesh, PathAlgorithm::Breadth).faces.len(), "{context}, round {round}");
            let shortest = of(&mut planner, &mesh, PathAlgorithm::Exact).length;
            let expected = if round < 20 {
                of(&mut planner, &triangles, PathAlgorithm::Exact).length
            } else {
                let anew = NavMesh::new(&map).expect("convex");
                of(&mut planner, &anew, PathAlgorithm::Exact).length
            };
            assert!((shortest - expected).abs() <= 1e-9 * expected, "{context}, round {round}: {shortest} {expected}");
        }
    }
}

/// Unit squares on a grid of `size` by `size`, each on a storey of its own height.
fn squares(places: &[[usize; 3]]) -> (Vec<[f64; 3]>, PolygonList) {
    let (mut points, mut faces) = (Vec::new(), PolygonList::new());
    for &[x, y, z] in places {
        let first = points.len() as u32;
        let [x, y, z] = [x, y, z].map(|c| c as f64);
        points.extend([[x, y, z], [x + 1.0, y, z], [x + 1.0, y + 1.0, z], [x, y + 1.0, z]]);
        faces.push_face(&[first, first + 1, first + 2, first + 3]);
    }
    (points, faces)
}

/// Squares that share no corner are floods of one face: from the lowest on, each takes the first layer in which nothing
/// lies over or under it.
#[test]
fn each_storey_takes_the_first_layer_that_is_free_there() {
    for (seed, size, count) in [(1, 1, 150), (2, 2, 300), (3, 5, 400), (4, 12, 300), (5, 1, 64), (6, 1, 63)] {
        let mut random = Random::new(seed);
        let mut heights: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            heights.swap(i, random.below(i + 1));
        }
        let places: Vec<[usize; 3]> =
            heights.iter().map(|&z| [2 * random.below(size), 2 * random.below(size), z]).collect();
        // Some are shifted, so that they lie over up to four others.
        let (mut points, faces) = squares(&places);
        for square in points.chunks_mut(4) {
            let shift = [(); 2].map(|()| if size > 1 { random.below(2) as f64 } else { 0.0 });
            square.iter_mut().for_each(|p| (0..2).for_each(|axis| p[axis] += shift[axis]));
        }
        let surface = NavSurface::new(&points, &faces, None).expect("squares");
        let corner = |f: usize| [points[4 * f][0], points[4 * f][1]];
        let is_over = |f: usize, g: usize| (0..2).all(|axis| (corner(f)[axis] - corner(g)[axis]).abs() < 1.0);
        let mut from_below: Vec<usize> = (0..count).collect();
        from_below.sort_by_key(|&f| places[f][2]);
        let mut layer = vec![0; count];
        for (i, &f) in from_below.iter().enumerate() {
            let taken: BTreeSet<usize> =
                from_below[..i].iter().filter(|&&g| is_over(f, g)).map(|&g| layer[g]).collect();
            layer[f] = (0..).find(|l| !taken.contains(l)).expect("there is always another");
        }
        let found: Vec<usize> = surface.faces().map(|f| surface.layer(f).expect("a layer")).collect();
        assert_eq!(found, layer, "seed {seed}");
        assert_eq!(Some(surface.layer_count() - 1), layer.iter().copied().max(), "seed {seed}");
        assert!(size > 1 || surface.layer_count() == count, "seed {seed}: {} layers", surface.layer_count());
    }
}

/// A corner costs its point, the record of its side and a word for the vertex: 32 bytes. Those of faces with more than 24
/// are kept in the order of the vertices, too: 8 bytes more.
#[test]
fn corners_of_large_faces_cost_eight_bytes_more() {
    let memory = |n: u32| {
        let corners = (0..n).map(|i| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(n)).sin_cos();
            Point::new(cos, sin)
        });
        let map = Subdivision::polygon(&corners.collect::<Vec<_>>()).expect("on a circle");
        NavMesh::new(&map).expect("convex").memory()
    };
    let least = memory(3);
    for n in [4, 9, 23, 24, 25, 26, 60, 200] {
        let more = if n > 24 { 8 * n as usize } else { 0 };
        assert_eq!(memory(n), least + 32 * (n as usize - 3) + more, "{n} corners");
    }
}
