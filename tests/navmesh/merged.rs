//! Merged faces: convex, made of every face once, and ways over them are the same, told by the faces of the mesh.

use crate::maps::{Map, Random};
use crate::oracle::{Oracle, sides};
use crate::routes::{check, ends, is_close, place};
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};
use dcel_kit::{FaceId, VertexId};
use std::collections::BTreeSet;

fn merged(map: &Map) -> NavMesh {
    let mesh = map.mesh();
    let count = mesh.merge_faces();
    assert_eq!(mesh.merged_faces().len(), count);
    mesh
}

/// Each merged face is convex, and its border is that of the union of its faces; every free face is in one of them.
fn check_faces(map: &Map, mesh: &NavMesh, context: &str) {
    let mut free: BTreeSet<FaceId> = mesh.faces().filter(|&f| mesh.is_walkable(f)).collect();
    for face in mesh.merged_faces() {
        let corners: Vec<u32> = face.corners.iter().map(|v| v.number()).collect();
        let ring = |i: usize| corners[i % corners.len()];
        for i in 0..corners.len() {
            let [a, b, c] = [i, i + 1, i + 2].map(|i| map.points[ring(i) as usize]);
            let straight = || left_to_right(a, b) == left_to_right(b, c);
            let convex = orientation(a, b, c).is_gt() || (orientation(a, b, c).is_eq() && straight());
            assert!(convex, "{context}: {face:?} at v{}", ring(i + 1));
        }
        let mut border: BTreeSet<[u32; 2]> = BTreeSet::new();
        for f in &face.faces {
            assert!(free.remove(f), "{context}: {f} is blocked, or in two merged faces");
            for [a, b] in sides(map.triangles[f.index() - 1]) {
                if !border.remove(&[b, a]) {
                    border.insert([a, b]);
                }
            }
        }
        let found: BTreeSet<[u32; 2]> = (0..corners.len()).map(|i| [ring(i), ring(i + 1)]).collect();
        assert_eq!(found, border, "{context}: the border of {face:?}");
        assert_eq!(found.len(), corners.len(), "{context}: {face:?}");
    }
    assert_eq!(free, BTreeSet::new(), "{context}: faces that were left out");
}

/// The way through the portals of the route, pulled straight, is the route.
fn check_portals(mesh: &NavMesh, planner: &mut Planner, [start, goal]: [Point; 2], context: &str) {
    let Ok(route) = planner.route_between(mesh, PathAlgorithm::Exact, start, goal) else { return };
    let straight = route.funnel_steps(mesh).pop().expect("a last step");
    let way: Vec<Point> = straight.way.iter().chain(&straight.left[1..]).copied().collect();
    let length: f64 = way.windows(2).map(|pair| crate::oracle::distance(pair[0], pair[1])).sum();
    assert!(is_close(length, route.length), "{context}: {} but by its portals {length}", route.length);
    let faces: BTreeSet<FaceId> = route.faces.iter().copied().collect();
    assert_eq!(faces.len(), route.faces.len(), "{context}: a face is entered twice: {:?}", route.faces);
}

#[test]
fn merged_faces_are_convex_and_have_every_face_once() {
    for seed in 0..60 {
        let map = Map::random(seed, 3 + seed as usize % 8, 0.8, [0.0, 0.4, 0.6][seed as usize % 3]);
        let mut mesh = map.mesh();
        let mut random = Random::new(seed + 9000);
        for _ in 0..seed % 4 {
            mesh.block(FaceId::new(random.below(map.triangles.len()) as u32 + 1));
        }
        let bytes = mesh.memory();
        let free = mesh.faces().filter(|&f| mesh.is_walkable(f)).count();
        let count = mesh.merge_faces();
        assert!(count <= free && mesh.memory() > bytes, "made when they are asked for");
        // 36 bytes a side, and 8 for each number of a face.
        let corners: usize = mesh.merged_faces().iter().map(|face| face.corners.len()).sum();
        assert_eq!(mesh.memory(), bytes + 36 * corners + 8 * mesh.face_bound(), "seed {seed}");
        check_faces(&map, &mesh, &format!("seed {seed}"));
        let dead_ends = |f: &FaceId| mesh.is_dead_end(*f);
        for face in mesh.merged_faces() {
            let dead = face.faces.iter().filter(|f| dead_ends(f)).count();
            assert!(dead == 0 || dead == face.faces.len(), "seed {seed}: {face:?} mixes dead ends with others");
        }
    }
}

#[test]
fn ways_over_merged_faces_are_as_short_as_the_visibility_graph_says() {
    let mut planner = Planner::new();
    for seed in 0..60 {
        let jitter = [0.0, 0.6][seed as usize % 2];
        let map = Map::random(seed, 2 + seed as usize % 4, [0.55, 0.75, 0.95][seed as usize / 2 % 3], jitter);
        let (mesh, oracle) = (merged(&map), Oracle::all_free(&map));
        let mut random = Random::new(seed + 3000);
        for pair in ends(&map, &oracle, &mut random, 8).chunks_exact(2) {
            let context = format!("seed {seed}");
            check(&mesh, &mut planner, &oracle, [&pair[0], &pair[1]], &context);
            check_portals(&mesh, &mut planner, [pair[0].point, pair[1].point], &context);
        }
    }
}

#[test]
fn merged_faces_give_the_same_answers_with_less_work() {
    let mut planners = [Planner::face_by_face(), Planner::new()];
    let mut work = [0, 0];
    for seed in 0..12 {
        let map = Map::random(seed, 16, 0.85, [0.0, 0.5][seed as usize % 2]);
        let mesh = map.mesh();
        let mut random = Random::new(seed + 9500);
        for _ in 0..12 {
            let [a, b] = [(); 2].map(|()| map.inside(random.below(map.triangles.len()), &mut random));
            let [one, other] = planners.each_mut().map(|p| p.route_between(&mesh, PathAlgorithm::Exact, a, b));
            let [one, other] = [one, other].map(|answer| answer.map_err(|e| e.to_string()));
            match (one, other) {
                (Ok(one), Ok(other)) => {
                    assert!(is_close(one.length, other.length), "seed {seed}: {a} -> {b}");
                    work[0] += one.work.expansions;
                    work[1] += other.work.expansions;
                    check_portals(&mesh, &mut planners[1], [a, b], &format!("seed {seed}: {a} -> {b}"));
                }
                (one, other) => assert_eq!(one.err(), other.err(), "seed {seed}: {a} -> {b}"),
            }
        }
        let start = mesh.place(map.inside(0, &mut random)).expect("free");
        let [one, other] = planners.each_mut().map(|planner| planner.distance_field(&mesh, &start, 9.0));
        for v in 0..map.points.len() as u32 {
            let [x, y] = [&one, &other].map(|field| field.distance(VertexId::new(v)));
            assert!(x == y || x.zip(y).is_some_and(|(x, y)| is_close(x, y)), "seed {seed}: v{v}: {x:?} but {y:?}");
        }
        assert!(other.work.expansions < one.work.expansions, "seed {seed}: {:?} {:?}", other.work, one.work);
    }
    assert!(work[1] * 10 <= work[0] * 6, "{} faces were entered instead of {}", work[1], work[0]);
}

#[test]
fn merged_faces_are_kept_through_changes() {
    let (mut planner, mut kept) = (Planner::new(), 0);
    let mut counts = [0; 2];
    for seed in 0..16 {
        let map = Map::random(
            seed,
            5 + seed as usize % 6,
            [0.75, 0.9, 1.0][seed as usize % 3],
            [0.0, 0.4][seed as usize % 2],
        );
        let mut mesh = merged(&map);
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
            check_faces(&map, &mesh, &context);
            counts = [counts[0] + mesh.merge_faces(), counts[1] + anew.merge_faces()];
            if step % 4 == 0 {
                let oracle = Oracle::new(&map, free.clone());
                for pair in ends(&map, &oracle, &mut random, 6).chunks_exact(2) {
                    check(&mesh, &mut planner, &oracle, [&pair[0], &pair[1]], &context);
                    check_portals(&mesh, &mut planner, [pair[0].point, pair[1].point], &context);
                }
                let work = [&mesh, &anew].map(|mesh| {
                    let start = mesh.faces().find(|&f| mesh.is_walkable(f)).expect("some are free");
                    let start = mesh.place_in(start, map.corners(start.index() - 1)[0]).expect("its corner");
                    planner.distance_field(mesh, &start, f64::INFINITY).work.expansions
                });
                assert!(work[0] <= 2 * work[1] + 8, "{context}: {work:?}");
            }
        }
    }
    assert!(kept > 16 * 40 * 3 / 4, "kept {kept} times of {}", 16 * 40);
    assert!(counts[0] * 100 <= counts[1] * 103, "{} merged faces where {} would do", counts[0], counts[1]);
}

#[test]
fn cones_over_merged_faces_lie_between_faces_of_the_mesh() {
    let map = Map::random(4, 8, 0.8, 0.5);
    let (mesh, mut planner) = (merged(&map), Planner::new());
    let mut random = Random::new(78);
    let mut count = 0;
    for _ in 0..20 {
        let [a, b] = [(); 2].map(|()| map.inside(random.below(map.triangles.len()), &mut random));
        if planner.route_between(&mesh, PathAlgorithm::Exact, a, b).is_err() {
            continue;
        }
        for cone in planner.cones(&mesh) {
            let side = mesh.sides(cone.from).find(|side| side.across == cone.to).expect("neighbours");
            let [p, q] = [side.from, side.to].map(|v| mesh.point(v));
            // The part that is seen is on the portal, and the root is not behind it.
            for end in [cone.left, cone.right] {
                let off = (q.x - p.x) * (end.y - p.y) - (q.y - p.y) * (end.x - p.x);
                assert!(off.abs() < 1e-12, "{cone:?} is not on {side:?}");
            }
            assert!(orientation(p, q, cone.root).is_ge(), "{cone:?} comes from behind {side:?}");
            count += 1;
        }
        // Another mesh has no cones of this search, be it smaller and merged, too.
        assert_eq!(planner.cones(&map.mesh()).count(), 0);
        assert_eq!(planner.cones(&merged(&Map::random(4, 3, 0.8, 0.5))).count(), 0);
    }
    assert!(count > 100, "{count}");
}

/// Across a few faces of an octagon: straight, and the portals between are told.
#[test]
fn within_merged_faces_the_way_is_straight_and_its_portals_are_told() {
    let points: Vec<Point> = (0..8)
        .map(|i| (std::f64::consts::TAU * f64::from(i) / 8.0).sin_cos())
        .map(|(sin, cos)| Point::new(cos, sin))
        .collect();
    let map = Map { points, triangles: (1..7).map(|i| [0, i, i + 1]).collect() };
    let (mesh, mut planner, oracle) = (merged(&map), Planner::new(), Oracle::all_free(&map));
    // Without a round trip all are dead ends but one face, which stays apart.
    assert_eq!(mesh.merged_faces().len(), 2);
    let mut random = Random::new(79);
    for [t, u] in [[0, 5], [5, 0], [2, 3], [1, 1], [4, 1]] {
        let nodes = [t, u].map(|t| Oracle::inner_node(map.inside(t, &mut random), t));
        let route = planner
            .route(&mesh, PathAlgorithm::Exact, &place(&mesh, &nodes[0]), &place(&mesh, &nodes[1]))
            .expect("one face");
        assert_eq!(route.portals.len(), t.abs_diff(u), "{route:?}");
        check(&mesh, &mut planner, &oracle, [&nodes[0], &nodes[1]], "octagon");
    }
}

/// The same by a plain program: of the portals, the longest first, each that leaves a convex face is taken away.
#[test]
fn the_longest_portals_go_first() {
    let (mut opened, mut kept) = (0, 0);
    for seed in 0..40 {
        // No two portals are equally long.
        let map = Map::random(seed + 600, 3 + seed as usize % 8, [0.8, 1.0][seed as usize % 2], 0.5);
        let mesh = merged(&map);
        let mut rings: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let mut ring_of: Vec<usize> = (0..rings.len()).collect();
        let mut portals: Vec<(f64, [usize; 2], [u32; 2])> = Vec::new();
        for (t, u) in (0..rings.len()).flat_map(|t| (0..t).map(move |u| (t, u))) {
            let common = sides(map.triangles[t]).into_iter().find(|&[a, b]| sides(map.triangles[u]).contains(&[b, a]));
            let is_dead_end = |t: usize| mesh.is_dead_end(FaceId::new(t as u32 + 1));
            if let Some([a, b]) = common.filter(|_| is_dead_end(t) == is_dead_end(u)) {
                let [p, q] = [a, b].map(|v| map.points[v as usize]);
                portals.push((crate::oracle::distance(p, q), [t, u], [a, b]));
            }
        }
        portals.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (_, pair, [a, b]) in portals {
            let [one, other] = pair.map(|t| ring_of[t]);
            // From b round to a, and from a round to b.
            let from = |ring: &[u32], v: u32| {
                let mut ring = ring.to_vec();
                let first = ring.iter().position(|&w| w == v).expect("a corner");
                ring.rotate_left(first);
                ring
            };
            let [left, right] = [from(&rings[one], b), from(&rings[other], a)];
            let convex = |corners: [u32; 3]| {
                let [p, q, r] = corners.map(|v| map.points[v as usize]);
                let turn = orientation(p, q, r);
                turn.is_gt() || (turn.is_eq() && left_to_right(p, q) == left_to_right(q, r))
            };
            let at_a = [left[left.len() - 2], a, right[1]];
            let at_b = [right[right.len() - 2], b, left[1]];
            if one == other || !convex(at_a) || !convex(at_b) {
                kept += 1;
                continue;
            }
            rings[one] = left[..left.len() - 1].iter().chain(&right[..right.len() - 1]).copied().collect();
            ring_of.iter_mut().filter(|ring| **ring == other).for_each(|ring| *ring = one);
            opened += 1;
        }
        let members = |ring: usize| -> BTreeSet<FaceId> {
            let of_ring = ring_of.iter().enumerate().filter(|&(_, &other)| other == ring);
            of_ring.map(|(t, _)| FaceId::new(t as u32 + 1)).collect()
        };
        let expected: BTreeSet<BTreeSet<FaceId>> = ring_of.iter().map(|&ring| members(ring)).collect();
        let found: BTreeSet<BTreeSet<FaceId>> =
            mesh.merged_faces().into_iter().map(|face| face.faces.into_iter().collect()).collect();
        assert_eq!(found, expected, "seed {seed}");
    }
    assert!(opened > 500 && kept > 500, "{opened} taken away, {kept} kept");
}
