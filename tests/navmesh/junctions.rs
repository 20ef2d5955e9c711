//! Junctions and reduced corridors: every face that is no dead end is in one of them, and ways over them have the fewest faces.

use crate::corridors::fewest_portals;
use crate::maps::{Map, Random};
use crate::oracle::Oracle;
use crate::routes::{check, check_shape, ends, is_close, place};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::Point;
use std::collections::BTreeSet;

fn linked(map: &Map) -> NavMesh {
    let mesh = map.mesh();
    let count = mesh.link_junctions();
    assert_eq!(mesh.junctions().len(), count);
    mesh
}

/// The neighbours that are no dead ends, one for each portal.
fn ways_on(mesh: &NavMesh, f: FaceId) -> Vec<FaceId> {
    mesh.neighbours(f).filter(|&g| !mesh.is_dead_end(g)).collect()
}

/// Junctions have three exits, faces of reduced corridors two; each is told once, and each way from a junction is one end.
fn check_network(mesh: &NavMesh, context: &str) {
    let mut rest: BTreeSet<FaceId> = mesh.faces().filter(|&f| mesh.is_walkable(f) && !mesh.is_dead_end(f)).collect();
    let mut ways = 0;
    for f in mesh.junctions() {
        assert!(ways_on(mesh, f).len() >= 3, "{context}: {f} is no junction");
        assert!(rest.remove(&f), "{context}: {f} is told twice, or a dead end");
        ways += ways_on(mesh, f).len();
    }
    for reduced_corridor in mesh.reduced_corridors() {
        let faces = &reduced_corridor.faces;
        for &f in faces {
            assert!(rest.remove(&f), "{context}: {f} is told twice, or a dead end");
            let expected = if reduced_corridor.ends.is_none() && faces.len() == 1 { 0 } else { 2 };
            assert_eq!(ways_on(mesh, f).len(), expected, "{context}: {f} in {reduced_corridor:?}");
        }
        let mut row = faces.clone();
        if let Some([before, behind]) = reduced_corridor.ends {
            row.insert(0, before);
            row.push(behind);
            ways -= 2;
        } else if faces.len() > 1 {
            row.push(faces[0]);
        }
        for pair in row.windows(2) {
            assert!(ways_on(mesh, pair[0]).contains(&pair[1]), "{context}: {pair:?} of {reduced_corridor:?}");
        }
    }
    assert_eq!(rest, BTreeSet::new(), "{context}: faces that were left out");
    assert_eq!(ways, 0, "{context}: ways from junctions into no reduced corridor");
}

#[test]
fn every_face_that_is_no_dead_end_is_in_one_reduced_corridor_or_a_junction() {
    let (mut junctions, mut circles, mut empty, mut loops) = (0, 0, 0, 0);
    for seed in 0..80 {
        let map = Map::random(seed, 3 + seed as usize % 12, [0.6, 0.75, 0.9][seed as usize % 3], 0.4);
        let mut mesh = linked(&map);
        check_network(&mesh, &format!("seed {seed}"));
        for reduced_corridor in mesh.reduced_corridors() {
            circles += usize::from(reduced_corridor.ends.is_none() && reduced_corridor.faces.len() > 1);
            empty += usize::from(reduced_corridor.faces.is_empty());
            loops += usize::from(reduced_corridor.ends.is_some_and(|[a, b]| a == b));
        }
        junctions += mesh.junctions().len();
        // And when some faces are blocked.
        let mut random = Random::new(seed);
        for _ in 0..3 {
            mesh.block(FaceId::new(1 + random.below(map.triangles.len()) as u32));
        }
        check_network(&mesh, &format!("seed {seed}, blocked"));
    }
    assert!([junctions, circles, empty, loops].iter().all(|&n| n > 10), "{junctions} {circles} {empty} {loops}");
}

#[test]
fn routes_over_junctions_have_the_fewest_faces() {
    let mut planner = Planner::new();
    for seed in 0..60 {
        let map = Map::random(seed, 3 + seed as usize % 10, [0.65, 0.8, 1.0][seed as usize % 3], 0.4);
        let mesh = linked(&map);
        let oracle = Oracle::all_free(&map);
        let mut random = Random::new(seed + 5000);
        for pair in ends(&map, &oracle, &mut random, 24).chunks_exact(2) {
            let context = format!("seed {seed}: {} -> {}", pair[0].point, pair[1].point);
            let [start, goal] = [&pair[0], &pair[1]].map(|node| place(&mesh, node));
            let found = planner.route(&mesh, PathAlgorithm::Breadth, &start, &goal).ok();
            let found = found.map(|route| {
                let faces: BTreeSet<FaceId> = route.faces.iter().copied().collect();
                assert_eq!(faces.len(), route.faces.len(), "{context}: a face is entered twice: {:?}", route.faces);
                route.portals.len()
            });
            assert_eq!(found, fewest_portals(&mesh, &start, &goal), "{context}");
        }
    }
}

/// What is put together from whole reduced corridors is what is found face by face, but where guesses are alike.
#[test]
fn a_star_over_junctions_finds_what_it_finds_over_faces() {
    let (mut planner, mut other) = (Planner::face_by_face(), Planner::new());
    for algorithm in [PathAlgorithm::Centroid, PathAlgorithm::Midpoint, PathAlgorithm::Closest, PathAlgorithm::Aimed] {
        let (mut sums, mut work, mut alike, mut count) = ([0.0; 2], [0; 2], 0, 0);
        for seed in 0..24 {
            let jitter = [0.0, 0.4][seed as usize % 2];
            let map = Map::random(seed, 4 + seed as usize % 16, [0.65, 0.8, 0.9][seed as usize % 3], jitter);
            let meshes = [map.mesh(), linked(&map)];
            let oracle = Oracle::all_free(&map);
            let mut random = Random::new(seed + 6000);
            for pair in ends(&map, &oracle, &mut random, 24).chunks_exact(2) {
                let context = format!("{algorithm}, seed {seed}: {} -> {}", pair[0].point, pair[1].point);
                let [mut start, goal] = [&pair[0], &pair[1]].map(|node| place(&meshes[0], node));
                // On a lattice some ways start in the middle of a portal, that is, in two faces.
                if jitter == 0.0 && count % 2 == 0 {
                    let side = meshes[0].sides(start.face).next().expect("a side");
                    let [a, b] = [side.from, side.to].map(|v| map.points[v.index()]);
                    start = meshes[0].place(Point::new((a.x + b.x) / 2.0, (a.y + b.y) / 2.0)).expect("on a side");
                }
                let plain = planner.route(&meshes[0], algorithm, &start, &goal);
                let over = other.route(&meshes[1], algorithm, &start, &goal);
                let (Ok(plain), Ok(over)) = (&plain, &over) else {
                    assert_eq!(plain.is_err(), over.is_err(), "{context}");
                    continue;
                };
                check_shape(&meshes[1], over, start.point, goal.point, &context);
                let faces: BTreeSet<FaceId> = over.faces.iter().copied().collect();
                assert_eq!(faces.len(), over.faces.len(), "{context}: a face is entered twice: {:?}", over.faces);
                sums = [sums[0] + plain.length, sums[1] + over.length];
                work = [work[0] + plain.work.expansions, work[1] + over.work.expansions];
                alike += u32::from(is_close(plain.length, over.length));
                count += 1;
            }
        }
        let context = format!("{algorithm}: {sums:?}, {work:?}, {alike} of {count}");
        assert!(count > 120 && alike * 10 >= count * 9, "{context}");
        assert!((sums[1] / sums[0] - 1.0).abs() < 0.005, "{context}");
    }
}

/// A reduced corridor that begins and ends at the same junction, with start and goal in it: a line to the junction and back may
/// be as long as the straight one, but nobody goes back.
#[test]
fn nobody_goes_back_through_the_reduced_corridor_in_which_he_started() {
    let points: Vec<Point> = (0..12).map(|i| Point::new(f64::from(i % 4), f64::from(i / 4))).collect();
    let squares = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [4, 5, 9, 8], [5, 6, 10, 9], [6, 7, 11, 10]];
    let cut = |[a, b, c, d]: [u32; 4], slash: bool| {
        if slash { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
    };
    let mut planner = Planner::new();
    let mut looked_at = 0;
    for cuts in 0..64 {
        let triangles = (0..6).flat_map(|i| cut(squares[i], cuts >> i & 1 == 1)).collect();
        let map = Map { points: points.clone(), triangles };
        let mesh = linked(&map);
        let middle = |t: usize| map.corners(t).iter().fold([0.0; 2], |[x, y], p| [x + p.x / 3.0, y + p.y / 3.0]);
        // All points in the middle of the sides, so that some starts are in two faces.
        for [a, b] in map.triangles.iter().flat_map(|&triangle| crate::oracle::sides(triangle)) {
            let [a, b] = [a, b].map(|v| points[v as usize]);
            let start = Point::new((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
            for goal in (0..map.triangles.len()).map(|t| Point::from(middle(t))) {
                for algorithm in
                    [PathAlgorithm::Breadth, PathAlgorithm::Midpoint, PathAlgorithm::Closest, PathAlgorithm::Aimed]
                {
                    let route = planner.route_between(&mesh, algorithm, start, goal).expect("one component");
                    let faces: BTreeSet<FaceId> = route.faces.iter().copied().collect();
                    assert_eq!(
                        faces.len(),
                        route.faces.len(),
                        "{cuts}, {algorithm}: {start} -> {goal}: {:?}",
                        route.faces
                    );
                    looked_at += 1;
                }
            }
        }
    }
    assert_eq!(looked_at, 64 * 36 * 12 * 4);
}

/// Two rings joined by a bridge: in each ring a reduced corridor leads from a junction to the same junction, and the shorter path
/// from the one part of it to the other may lead through that.
#[test]
fn a_way_may_leave_its_reduced_corridor_and_come_back_by_the_other_end() {
    let is_free = |x: usize, y: usize| if x == 3 { y == 1 } else { (x % 4, y) != (1, 1) };
    let points = (0..4).flat_map(|y| (0..8).map(move |x| Point::new(f64::from(x), f64::from(y)))).collect();
    let corner = |x: usize, y: usize| (8 * y + x) as u32;
    let cells = (0..3).flat_map(|y| (0..7).map(move |x| (x, y))).filter(|&(x, y)| is_free(x, y));
    let halves = |(x, y)| {
        let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    let map = Map { points, triangles: cells.flat_map(halves).collect() };
    let mesh = linked(&map);
    assert_eq!(mesh.junctions().len(), 2);
    assert!(mesh.reduced_corridors().iter().any(|reduced_corridor| reduced_corridor.ends.is_some_and(|[a, b]| a == b)));
    let mut planner = Planner::new();
    // Below and above the junction of each ring; the other way round is three times as long.
    for x in [2.5, 4.5] {
        for (from, to) in [(0.5, 2.5), (2.5, 0.5)] {
            for algorithm in PathAlgorithm::ALL {
                let [start, goal] = [from, to].map(|y| Point::new(x + 0.01, y));
                let route = planner.route_between(&mesh, algorithm, start, goal).expect("one component");
                assert!(route.length < 2.1, "{algorithm}: {start} -> {goal}: {:?}", route.points);
            }
        }
    }
}

/// A ring of `n` trapezoids round a hole, each cut in two, with a dead end of `depth` triangles beside the first.
fn ring(n: u32, depth: u32) -> Map {
    let at = |i: u32, radius: f64| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(n)).sin_cos();
        Point::new(radius * cos, radius * sin)
    };
    let mut points: Vec<Point> = (0..n).flat_map(|i| [at(i, 1.0), at(i, 2.0)]).collect();
    let quad = |i: u32| [2 * i, 2 * i + 1, 2 * ((i + 1) % n) + 1, 2 * ((i + 1) % n)];
    let mut triangles: Vec<[u32; 3]> = (0..n).map(quad).flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    // A strip outwards from the outer side of the first trapezoid.
    let [mut a, mut b] = [1, 3];
    for i in 0..depth {
        let c = points.len() as u32;
        let radius = 3.0 + f64::from(i);
        points.push(at(i % 2, radius));
        triangles.push([b, a, c]);
        if i % 2 == 0 { a = c } else { b = c }
    }
    Map { points, triangles }
}

#[test]
fn without_a_junction_the_way_goes_round_the_shorter_side_or_up_and_down_a_dead_end() {
    let mut planner = Planner::new();
    for (n, depth) in [(3, 0), (5, 4), (8, 7)] {
        let map = ring(n, depth);
        let mesh = linked(&map);
        assert_eq!(mesh.junctions().len(), 0);
        check_network(&mesh, &format!("ring of {n}"));
        let oracle = Oracle::all_free(&map);
        let mut random = Random::new(3);
        let count = map.triangles.len();
        for (t, u) in (0..count).flat_map(|t| (0..count).map(move |u| (t, u))) {
            let nodes = [t, u].map(|t| Oracle::inner_node(map.inside(t, &mut random), t));
            let context = format!("ring of {n}: triangles {t} -> {u}");
            let [start, goal] = [&nodes[0], &nodes[1]].map(|node| place(&mesh, node));
            let route = planner.route(&mesh, PathAlgorithm::Breadth, &start, &goal).expect(&context);
            assert_eq!(Some(route.portals.len()), fewest_portals(&mesh, &start, &goal), "{context}");
            assert_eq!(route.work.pops, 0, "{context}");
            check(&mesh, &mut planner, &oracle, [&nodes[0], &nodes[1]], &context);
        }
    }
}

#[test]
fn junctions_are_kept_through_changes() {
    let (mut planner, mut kept) = (Planner::new(), 0);
    for seed in 0..16 {
        let map = Map::random(seed, 5 + seed as usize % 6, [0.75, 0.9, 1.0][seed as usize % 3], 0.4);
        let mut mesh = linked(&map);
        let mut free = vec![true; map.triangles.len()];
        let mut random = Random::new(seed + 77);
        for step in 0..40 {
            let t = random.below(free.len());
            free[t] = !free[t];
            let f = FaceId::new(t as u32 + 1);
            if free[t] {
                mesh.unblock(f)
            } else {
                mesh.block(f)
            };
            let context = format!("seed {seed}, step {step}");
            // They are there before anybody asks, unless it was time to begin anew.
            let mut anew = map.mesh();
            free.iter().zip(1..).filter(|&(free, _)| !free).for_each(|(_, f)| {
                anew.block(FaceId::new(f));
            });
            kept += usize::from(mesh.memory() > anew.memory());
            check_network(&mesh, &context);
            let sorted = |mesh: &NavMesh| mesh.junctions().collect::<BTreeSet<FaceId>>();
            assert_eq!(sorted(&mesh), sorted(&anew), "{context}");
            assert_eq!(mesh.reduced_corridors().len(), anew.reduced_corridors().len(), "{context}");
            if step % 5 == 0 {
                let oracle = Oracle::new(&map, free.clone());
                for pair in ends(&map, &oracle, &mut random, 4).chunks_exact(2) {
                    check(&mesh, &mut planner, &oracle, [&pair[0], &pair[1]], &context);
                    let [start, goal] = [&pair[0], &pair[1]].map(|node| place(&mesh, node));
                    let found = planner.route(&mesh, PathAlgorithm::Breadth, &start, &goal).ok();
                    assert_eq!(found.map(|way| way.portals.len()), fewest_portals(&mesh, &start, &goal), "{context}");
                }
            }
        }
    }
    assert!(kept > 16 * 40 * 3 / 4, "kept {kept} times of {}", 16 * 40);
}

/// However many triangles there are, the work is that of the junctions.
#[test]
fn the_work_grows_with_the_holes_and_not_with_the_triangles() {
    let mut planner = Planner::new();
    for n in [9_usize, 99, 999] {
        // Two long corridors, joined at both ends and in the middle: two holes.
        let is_free = |x: usize, y: usize| y != 1 || [0, n / 2, n - 1].contains(&x);
        let points = (0..=3).flat_map(|y| (0..=n).map(move |x| Point::new(x as f64, f64::from(y)))).collect();
        let corner = |x: usize, y: usize| (y * (n + 1) + x) as u32;
        let cells = (0..3).flat_map(|y| (0..n).map(move |x| (x, y))).filter(|&(x, y)| is_free(x, y));
        let halves = |(x, y)| {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            [[a, b, c], [a, c, d]]
        };
        let mesh = Map { points, triangles: cells.flat_map(halves).collect() }.mesh();
        let ends = [Point::new(1.3, 0.4), Point::new(n as f64 - 1.3, 2.6)];
        let plain =
            Planner::face_by_face().route_between(&mesh, PathAlgorithm::Breadth, ends[0], ends[1]).expect("a way");
        assert_eq!(mesh.link_junctions(), 2);
        let route = planner.route_between(&mesh, PathAlgorithm::Breadth, ends[0], ends[1]).expect("a way");
        assert_eq!(route.faces.len(), plain.faces.len());
        assert!(plain.work.pops > n as u64 && route.work.pops <= 4, "{n}: {:?}, {:?}", plain.work, route.work);
        check_network(&mesh, &format!("{n}"));
    }
}
