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

/// Powers of two change no digit: whatever the unit, the same is joined.
#[test]
fn what_is_welded_does_not_depend_on_the_unit() {
    for seed in 0..12 {
        let mut random = Random::new(seed + 8200);
        let map = Map::random(seed, 4, 0.8, 0.4);
        let triangles: Vec<Vec<u32>> = map.triangles.iter().map(|triangle| triangle.to_vec()).collect();
        let (corners, faces) = if seed % 2 == 0 { (map.points, triangles) } else { bricks(4, 6.0, &mut random) };
        let (points, list, _) = apart(&corners, &faces, 1e-4, &mut random);
        let welded = weld(&points, &list, 3e-4);
        assert!(welded.joined > 0 && welded.farthest > 0.0, "seed {seed}");
        for unit in [2f64.powi(40), 2f64.powi(-40)] {
            let points: Vec<Point> = points.iter().map(|p| Point::new(p.x * unit, p.y * unit)).collect();
            let other = weld(&points, &list, 3e-4 * unit);
            let expected = dcel_kit::navmesh::Welded { farthest: welded.farthest * unit, ..welded.clone() };
            assert_eq!(other, expected, "seed {seed}, unit {unit}");
        }
    }
}

/// Platforms beside a flight of stairs: their corners lie on its sides, which are as steep as they like.
#[test]
fn t_junctions_on_steep_sides_are_split_in_order() {
    let mut random = Random::new(8300);
    let mut compared = 0;
    for round in 0..300 {
        let steep = [0.1, 1.0, 10.0, 100.0][round % 4];
        let mut at = || [random.unit(), random.unit(), steep * random.unit()];
        let [a, b, c] = [at(), at(), at()];
        let count = 1 + round % 5;
        let shares: Vec<f64> = (0..count).map(|_| 0.02 + 0.96 * random.unit()).collect();
        let off = [0.0, 1e-6][round % 2];
        let mut points = vec![a, b, c];
        let mut faces = PolygonList::new();
        faces.push_face(&[0, 1, 2]);
        for (i, share) in shares.iter().enumerate() {
            // Each is a corner of a face of its own, which lies elsewhere.
            let on: [f64; 3] = std::array::from_fn(|k| a[k] + (b[k] - a[k]) * share);
            let far = 10.0 * (i + 1) as f64;
            points.extend([[on[0] + off, on[1], on[2]], [on[0], far, 0.0], [on[0] + 1.0, far, 0.0]]);
            let first = 3 + 3 * i as u32;
            faces.push_face(&[first, first + 1, first + 2]);
        }
        let gaps = (0..count).flat_map(|i| (0..i).map(move |k| (i, k)));
        if gaps.map(|(i, k)| (shares[i] - shares[k]).abs()).any(|gap| gap < 1e-3) {
            continue;
        }
        let welded = weld_in_space(&points, &faces, 1e-5);
        let context = format!("round {round}: {a:?} to {b:?}, {shares:?}");
        let mut order: Vec<u32> = (0..count as u32).collect();
        order.sort_by(|&i, &k| shares[i as usize].total_cmp(&shares[k as usize]));
        let expected: Vec<u32> = std::iter::once(0).chain(order.iter().map(|i| 3 + 3 * i)).chain([1, 2]).collect();
        assert_eq!((welded.faces.cycle(0), welded.inserted, welded.joined), (&expected[..], count, 0), "{context}");
        // As far as a vertex was moved, or less, but for rounding.
        assert!(welded.farthest <= off + 1e-12 * steep, "{context}: {}", welded.farthest);
        compared += 1;
    }
    assert!(compared > 250, "{compared} flights");
}

/// Sides that two faces have are left alone, however thin one of the two is.
#[test]
fn what_is_joined_already_stays_as_it_is() {
    for seed in 0..40 {
        let mut random = Random::new(seed + 8400);
        let map = Map::random(seed, 3 + seed as usize % 4, 0.7, 0.4);
        let (mut points, mut faces) = (map.points.clone(), map.triangles.clone());
        let has = |[a, b]: [u32; 2]| map.triangles.iter().any(|t| crate::oracle::sides(*t).contains(&[a, b]));
        for [a, b] in map.triangles.iter().flat_map(|&t| crate::oracle::sides(t)).filter(|&[a, b]| !has([b, a])) {
            if random.unit() < 0.5 {
                continue;
            }
            // A thin triangle on the outside of this side.
            let [p, q] = [a, b].map(|v| map.points[v as usize]);
            let (share, height) = (0.3 + 0.4 * random.unit(), 1e-4);
            let [x, y] = [q.x - p.x, q.y - p.y];
            faces.push([b, a, points.len() as u32]);
            points.push(Point::new(p.x + share * x + height * y, p.y + share * y - height * x));
        }
        assert!(faces.len() > map.triangles.len(), "seed {seed}");
        let mut list = PolygonList::new();
        faces.iter().for_each(|face| list.push_face(face));
        let welded = weld(&points, &list, 1e-3);
        let context = format!("seed {seed}");
        assert_eq!((welded.joined, welded.inserted, welded.collapsed, &welded.faces), (0, 0, 0, &list), "{context}");
        let faults = mesh_faults(&points, &list, &[]);
        assert!(faults.iter().all(|fault| fault.kind() != "nearly-welded"), "{context}: {faults:?}");
    }
}

#[test]
fn what_no_face_may_be_stays_for_the_validator_to_name() {
    let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.)].map(Point::from);
    for wrong in [&[0, 1, 1, 2, 3][..], &[0, 1, 2, 2], &[0, 1], &[2]] {
        let mut faces = PolygonList::new();
        faces.push_face(wrong);
        let welded = weld(&points, &faces, 0.5);
        assert_eq!((&welded.faces, welded.collapsed), (&faces, 0), "{wrong:?}");
        assert_ne!(mesh_faults(&points, &welded.faces, &[]), [], "{wrong:?}");
    }
}
