//! Welding: what was taken apart is put together again, and what nearly meets is named.

use crate::maps::{Map, Random};
use dcel_kit::navmesh::{MeshFault, NavMesh, NavSurface, mesh_faults, weld, weld_in_space};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use std::collections::BTreeSet;

/// Every face with corners of its own, each up to `jitter` from where it was; and which vertex each was.
fn apart(
    points: &[Point],
    faces: &[Vec<u32>],
    jitter: f64,
    random: &mut Random,
) -> (Vec<Point>, PolygonList, Vec<u32>) {
    let (mut copies, mut list, mut of) = (Vec::new(), PolygonList::new(), Vec::new());
    for face in faces {
        let first = copies.len() as u32;
        for &v in face {
            let [dx, dy] = [(); 2].map(|()| jitter * (2.0 * random.unit() - 1.0));
            copies.push(Point::new(points[v as usize].x + dx, points[v as usize].y + dy));
            of.push(v);
        }
        list.push_face(&(first..copies.len() as u32).collect::<Vec<_>>());
    }
    (copies, list, of)
}

#[test]
fn triangles_that_were_taken_apart_are_put_together_again() {
    for seed in 0..60 {
        let mut random = Random::new(seed + 8000);
        let shift = [0.0, 1e6, -3e8][seed as usize % 3];
        let map = Map::random(seed, 3 + seed as usize % 9, 0.7, 0.4).moved(|p| Point::new(p.x + shift, p.y - shift));
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|triangle| triangle.to_vec()).collect();
        for jitter in [0.0, 1e-5, 1e-3] {
            // Two copies of a vertex are no further apart than twice the diagonal of the jitter.
            let distance = jitter * 3.0;
            let (points, list, of) = apart(&map.points, &faces, jitter, &mut random);
            let welded = weld(&points, &list, distance);
            let context = format!("seed {seed}, jitter {jitter}");
            let used: BTreeSet<u32> = of.iter().copied().collect();
            assert_eq!((welded.joined, welded.inserted, welded.collapsed), (of.len() - used.len(), 0, 0), "{context}");
            assert!(welded.farthest <= distance, "{context}: {}", welded.farthest);
            for (face, cycle) in faces.iter().zip(welded.faces.outer_cycles()) {
                let corners: Vec<u32> = cycle.iter().map(|&v| of[v as usize]).collect();
                assert_eq!(&corners, face, "{context}");
            }
            let kept: BTreeSet<u32> = welded.faces.corners().iter().copied().collect();
            assert_eq!(kept.len(), used.len(), "{context}: one copy of each");
            // What is left to weld is nothing.
            let again = weld(&points, &welded.faces, distance);
            assert_eq!((again.joined, again.inserted, again.faces), (0, 0, welded.faces), "{context}");
        }
    }
}

/// A wall of bricks, each with its own four corners: rows of other lengths meet in T-junctions.
fn bricks(rows: usize, width: f64, random: &mut Random) -> (Vec<Point>, Vec<Vec<u32>>) {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for y in 0..rows {
        let mut x = 0.0;
        while x < width {
            let end = (x + 0.5 + (random.unit() * 64.0).floor() / 32.0).min(width);
            let end = if width - end < 0.5 { width } else { end };
            let first = points.len() as u32;
            let [low, high] = [y as f64, y as f64 + 1.0];
            points.extend([(x, low), (end, low), (end, high), (x, high)].map(Point::from));
            faces.push((first..first + 4).collect());
            x = end;
        }
    }
    (points, faces)
}

/// The length of all sides that no other face has in the other direction.
fn border_length(points: &[Point], faces: &PolygonList) -> f64 {
    let mut sides = BTreeSet::new();
    for cycle in faces.outer_cycles() {
        for (&a, &b) in cycle.iter().zip(cycle.iter().cycle().skip(1)) {
            assert!(sides.insert([a, b]), "two faces on one side");
        }
    }
    let border = sides.iter().filter(|&&[a, b]| !sides.contains(&[b, a]));
    border.map(|side| side.map(|v| points[v as usize])).map(|[a, b]| crate::oracle::distance(a, b)).sum()
}

#[test]
fn t_junctions_of_a_wall_of_bricks_are_split() {
    for seed in 0..40 {
        let mut random = Random::new(seed + 8100);
        let (rows, width) = (2 + seed as usize % 7, 6.0);
        let (corners, faces) = bricks(rows, width, &mut random);
        for jitter in [0.0, 1e-4] {
            let (points, list, _) = apart(&corners, &faces, jitter, &mut random);
            let welded = weld(&points, &list, 3.0 * jitter);
            let context = format!("seed {seed}, jitter {jitter}");
            // Inside the wall every side has a neighbour: nothing is left but what is round it.
            let round = 2.0 * (rows as f64 + width);
            let border = border_length(&points, &welded.faces);
            assert!((border - round).abs() <= 1e-9 + 40.0 * jitter, "{context}: {border} instead of {round}");
            assert!(welded.inserted > 0 && welded.farthest <= 3.0 * jitter, "{context}: {welded:?}");
            if jitter == 0.0 {
                assert_eq!(mesh_faults(&points, &welded.faces, &[]), [], "{context}");
                let map = Subdivision::from_polygons(points.clone(), &welded.faces).expect("bricks that fit");
                let mesh = NavMesh::new(&map).expect("convex");
                assert_eq!((mesh.component_count(), mesh.face_count()), (1, faces.len()), "{context}");
                assert_ne!(mesh_faults(&points, &list, &[]), [], "{context}: it was none before");
            }
        }
    }
}

#[test]
fn what_nearly_meets_is_a_warning_and_what_is_far_apart_or_joined_is_none() {
    let of = |points: &[(f64, f64)], faces: &[&[u32]]| {
        let points: Vec<Point> = points.iter().map(|&p| p.into()).collect();
        let mut list = PolygonList::new();
        faces.iter().for_each(|face| list.push_face(face));
        mesh_faults(&points, &list, &[])
    };
    let hole = |hole: f64| {
        let right = 1.0 + hole;
        let points = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (right, 0.), (2., 0.), (2., 1.), (right, 1.)];
        of(&points, &[&[0, 1, 2, 3], &[4, 5, 6, 7]])
    };
    let near = hole(1e-6);
    assert!(near.iter().all(MeshFault::is_warning) && near.len() == 2, "{near:?}");
    assert!(
        matches!(near[0], MeshFault::NearVertices { first: 1, second: 4, distance } if (distance - 1e-6).abs() < 1e-15)
    );
    assert_eq!(hole(1e-3), []);
    // A vertex beside a side of another face: joined to its ends by sides of its own.
    let beside = |y: f64| {
        let points = [(0., 0.), (1., 0.), (2., 0.), (2., 1.), (1., y), (0., 1.), (2., 2.), (0., 2.)];
        of(&points, &[&[0, 1, 4, 5], &[1, 2, 3, 4], &[5, 3, 6, 7]])
    };
    let near: Vec<MeshFault> = beside(1.0 - 1e-6).into_iter().filter(|fault| fault.kind() == "nearly-welded").collect();
    assert!(matches!(near.as_slice(), [MeshFault::NearSide { vertex: 4, face: 2, side: [5, 3], .. }]), "{near:?}");
    assert!(beside(0.999).iter().all(|fault| fault.kind() != "nearly-welded"));
    // A thin face is a thin face.
    assert_eq!(of(&[(0., 0.), (2., 0.), (1., 1e-6)], &[&[0, 1, 2]]), []);
}

#[test]
fn what_is_thinner_than_the_distance_is_gone() {
    let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (4., 4.001)].map(Point::from);
    let mut faces = PolygonList::new();
    [[0, 1, 2, 3], [3, 2, 4, 3]]
        .iter()
        .for_each(|face| faces.push_face(&face[..if face[3] == face[0] { 3 } else { 4 }]));
    let welded = weld(&points, &faces, 0.01);
    assert_eq!((welded.joined, welded.collapsed, welded.origins.as_slice()), (1, 1, &[0][..]));
    assert_eq!(weld(&points, &faces, 1e-9).collapsed, 0);
    // Numbers of no point stay for the validator to name.
    let mut wrong = PolygonList::new();
    wrong.push_face(&[0, 1, 99]);
    assert_eq!(weld(&points, &wrong, 0.5).faces, wrong);
}

/// Beside a corner a vertex is near two sides of the same face, and further from the corner itself.
#[test]
fn a_vertex_beside_two_sides_becomes_one_corner() {
    for (x, y, nearer) in [(0.9994, 0.9995, 2), (0.9995, 0.9994, 1)] {
        let points = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (x, y), (0.2, 0.5), (0.5, 0.2)].map(Point::from);
        let mut faces = PolygonList::new();
        [&[0, 1, 2, 3][..], &[4, 5, 6]].iter().for_each(|face| faces.push_face(face));
        let welded = weld(&points, &faces, 0.0007);
        let mut expected = vec![0, 1, 2, 3];
        expected.insert(nearer + 1, 4);
        assert_eq!((welded.faces.cycle(0), welded.inserted), (&expected[..], 1), "({x}, {y})");
    }
}

/// A long row of vertices at equal places: each is compared with those beside it only.
#[test]
fn long_walls_are_welded_as_they_are() {
    let n = 20_000;
    let points: Vec<Point> =
        [0.0, 1.0, 1.0, 2.0].iter().flat_map(|&y| (0..=n).map(move |x| Point::new(f64::from(x), y))).collect();
    let mut faces = PolygonList::new();
    for (row, x) in [0, 2].into_iter().flat_map(|row| (0..n as u32).map(move |x| (row, x))) {
        let [low, high] = [row, row + 1].map(|row| row * (n as u32 + 1) + x);
        faces.push_face(&[low, low + 1, high + 1, high]);
    }
    let welded = weld(&points, &faces, 1e-6);
    assert_eq!((welded.joined, welded.inserted), (n as usize + 1, 0));
    assert!((border_length(&points, &welded.faces) - f64::from(2 * n + 4)).abs() < 1e-6);
}

/// Hills, and the same hills a storey above: each is put together from triangles that were taken apart, and none of one
/// storey is joined with the other, though both have the same plan.
#[test]
fn storeys_of_one_plan_are_put_together_apart() {
    let height = |p: Point| (p.x * 0.7 + p.y * 0.3).sin();
    for seed in 0..30 {
        let mut random = Random::new(seed + 9000);
        let map = Map::random(seed, 3 + seed as usize % 7, 0.7, 0.4);
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|triangle| triangle.to_vec()).collect();
        for (jitter, storey) in [(0.0, 1e-9), (1e-6, 1e-2), (1e-4, 2.0)] {
            let (mut points, mut list, mut of) = (Vec::new(), PolygonList::new(), Vec::new());
            for level in [0, 1] {
                let (plan, one, was) = apart(&map.points, &faces, jitter, &mut random);
                let first = points.len() as u32;
                for (p, &v) in plan.iter().zip(&was) {
                    points.push([p.x, p.y, height(map.points[v as usize]) + f64::from(level) * storey]);
                }
                for face in 0..one.face_count() {
                    list.push_face(&one.cycle(face).iter().map(|v| v + first).collect::<Vec<_>>());
                }
                of.extend(was.iter().map(|v| v + level * map.points.len() as u32));
            }
            let (before, after) = (NavSurface::new(&points, &list, None), weld_in_space(&points, &list, jitter * 3.0));
            let before = before.unwrap_or_else(|error| panic!("seed {seed}: {error}"));
            assert!(faces.len() == 1 || jitter > 1e-5 || !before.near_misses().is_empty(), "seed {seed}");
            let used: BTreeSet<u32> = of.iter().copied().collect();
            assert_eq!(after.joined, of.len() - used.len(), "seed {seed}, {jitter}: each copy but one of each corner");
            assert_eq!((after.inserted, after.collapsed), (0, 0), "seed {seed}");
            let surface = NavSurface::new(&points, &after.faces, None).expect("what was a surface");
            if storey > 0.1 {
                assert_eq!(surface.near_misses(), [], "seed {seed}");
            }
            let whole: Vec<_> = map.points.iter().map(|&p| [p.x, p.y, height(p)]).collect();
            let mut one = PolygonList::new();
            faces.iter().for_each(|face| one.push_face(face));
            let parts = NavSurface::new(&whole, &one, None).expect("the hills").component_count();
            assert_eq!(surface.component_count(), 2 * parts, "seed {seed}");
        }
    }
}
