//! Routes: the exact one is as short as the visibility graph says, and no algorithm is shorter; all run where they may.

use crate::maps::{Map, Random};
use crate::oracle::{Node, Oracle, distance};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner, QueryPoint, Route, RouteError};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;

pub(crate) fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

/// The place of a node: triangle i is f(i + 1).
pub(crate) fn place(mesh: &NavMesh, node: &Node) -> QueryPoint {
    mesh.place_in(FaceId::new(node.triangles[0] as u32 + 1), node.point).expect("the triangle has the node")
}

/// Ends for queries: points inside triangles and vertices in one of their wedges.
pub(crate) fn ends(map: &Map, oracle: &Oracle, random: &mut Random, count: usize) -> Vec<Node> {
    let vertices = oracle.vertex_nodes();
    let free: Vec<usize> = oracle.free_triangles().collect();
    let end = |i: usize| {
        let t = free[random.below(free.len())];
        if i.is_multiple_of(3) {
            vertices[random.below(vertices.len())].clone()
        } else {
            Oracle::inner_node(map.inside(t, random), t)
        }
    };
    if free.is_empty() { Vec::new() } else { (0..count).map(end).collect() }
}

/// Faces, portals and points of a route fit each other and the mesh.
pub(crate) fn check_shape(mesh: &NavMesh, route: &Route, start: Point, goal: Point, context: &str) {
    assert_eq!(route.faces.len(), route.portals.len() + 1, "{context}");
    assert_eq!(route.portal_ends(mesh).count(), route.portals.len(), "{context}: a portal is no side of its face");
    assert_eq!((route.points[0], route.points[route.points.len() - 1]), (start, goal), "{context}");
    assert_eq!(route.corners.len() + 2, route.points.len(), "{context}");
    for (portal, pair) in route.portal_ends(mesh).zip(route.faces.windows(2)) {
        let side = mesh.sides(pair[0]).find(|side| side.half_edge == portal.half_edge).expect("a side");
        assert!(side.open && side.across == pair[1] && mesh.is_walkable(pair[1]), "{context}: {portal:?}");
    }
    for corner in route.points.windows(3) {
        let [a, b, c] = [corner[0], corner[1], corner[2]];
        let on = orientation(a, b, c).is_eq() && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) > 0.0;
        assert!(!on, "{context}: {b} is no corner of {:?}", route.points);
    }
    let length: f64 = route.points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    assert!(is_close(length, route.length), "{context}: {length} but {}", route.length);
}

/// Checks all algorithms between two nodes.
pub(crate) fn check(mesh: &NavMesh, planner: &mut Planner, oracle: &Oracle, [start, goal]: [&Node; 2], context: &str) {
    let [from, to] = [start, goal].map(|node| place(mesh, node));
    let expected = oracle.shortest(start, goal);
    for algorithm in PathAlgorithm::ALL {
        let context = format!("{context}, {algorithm}: {} -> {}", start.point, goal.point);
        match (planner.route(mesh, algorithm, &from, &to), expected) {
            (Ok(route), Some(expected)) => {
                check_shape(mesh, &route, start.point, goal.point, &context);
                let exact = is_close(route.length, expected);
                let longer = route.length >= expected * (1.0 - 1e-9);
                let good = if algorithm == PathAlgorithm::Exact { exact } else { longer };
                assert!(good, "{context}: {} but the shortest is {expected}: {:?}", route.length, route.points);
            }
            (Err(RouteError::Unreachable { start, goal, .. }), None) => assert_ne!(start, goal, "{context}"),
            (answer, expected) => panic!("{context}: {answer:?} but {expected:?}"),
        }
    }
}

#[test]
fn exact_routes_are_as_short_as_the_visibility_graph_says() {
    let mut planner = Planner::face_by_face();
    for seed in 0..120 {
        let jitter = [0.0, 0.6][seed as usize % 2];
        let map = Map::random(seed, 2 + seed as usize % 4, [0.55, 0.75][seed as usize / 2 % 2], jitter);
        let (mesh, oracle) = (map.mesh(), Oracle::all_free(&map));
        let mut random = Random::new(seed + 3000);
        for pair in ends(&map, &oracle, &mut random, 8).chunks_exact(2) {
            check(&mesh, &mut planner, &oracle, [&pair[0], &pair[1]], &format!("seed {seed}"));
        }
    }
}

/// Between points the path may begin and end in any wedge of a double corner: the shortest one counts.
#[test]
fn at_double_corners_the_shortest_of_all_ways_is_found() {
    let mut planner = Planner::new();
    let (mut several, mut differ) = (0, 0);
    for seed in 0..40 {
        let map = Map::random(seed, 4 + seed as usize % 3, 0.75, [0.0, 0.6][seed as usize % 2]);
        let (mesh, oracle) = (map.mesh(), Oracle::all_free(&map));
        let nodes = oracle.vertex_nodes();
        let mut random = Random::new(seed + 3500);
        let at = |p: Point| nodes.iter().filter(|node| node.point == p).cloned().collect::<Vec<Node>>();
        let double: Vec<Point> = nodes.iter().map(|node| node.point).filter(|&p| at(p).len() > 1).collect();
        for &p in &double {
            let q = nodes[random.below(nodes.len())].point;
            for [start, goal] in [[p, q], [q, p]] {
                let (starts, goals) = (at(start), at(goal));
                let pairs = starts.iter().flat_map(|a| goals.iter().map(|b| oracle.shortest(a, b)));
                let lengths: Vec<f64> = pairs.flatten().collect();
                let least = lengths.iter().copied().reduce(f64::min);
                let found = planner.route_between(&mesh, PathAlgorithm::Exact, start, goal);
                let context = format!("seed {seed}: {start} -> {goal}: {found:?}, not {least:?}");
                assert_eq!(found.is_ok(), least.is_some(), "{context}");
                if let (Ok(route), Some(least)) = (&found, least) {
                    assert!(is_close(route.length, least), "{context}");
                    check_shape(&mesh, route, start, goal, &context);
                    several += 1;
                    differ += usize::from(lengths.iter().any(|&length| !is_close(length, least)));
                }
            }
        }
    }
    assert!(several > 100 && differ > 20, "{several} ways, {differ} times it mattered");
}

#[test]
fn lengths_stay_under_rotation_shift_scale_and_reversal() {
    let mut planner = Planner::new();
    let (sin, cos) = 0.3f64.sin_cos();
    for seed in 0..25 {
        let map = Map::random(seed, 8, 0.75, [0.0, 0.6][seed as usize % 2]);
        let turn = |p: Point| Point::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos);
        let shift = |p: Point| Point::new(p.x + 1e5, p.y - 1e5);
        let scale = |p: Point| Point::new(p.x * 1e-3, p.y * 1e-3);
        let moved: [(Map, f64); 4] = [
            (map.moved(turn), 1.0),
            (map.moved(shift), 1.0),
            (map.moved(|p| shift(turn(p))), 1.0),
            (map.moved(|p| scale(turn(p))), 1e-3),
        ];
        let oracle = Oracle::all_free(&map);
        let mut random = Random::new(seed + 4000);
        let (mesh, original) = (map.mesh(), map.clone());
        let moved: Vec<(Map, NavMesh, f64)> = moved.into_iter().map(|(m, unit)| (m.clone(), m.mesh(), unit)).collect();
        // From vertex to vertex, so that the ends move with the map.
        let nodes = oracle.vertex_nodes();
        for _ in 0..12 {
            let [a, b] = [(); 2].map(|()| nodes[random.below(nodes.len())].clone());
            let length = |planner: &mut Planner, mesh: &NavMesh, map: &Map, [from, to]: [&Node; 2]| {
                let place = |node: &Node| {
                    let t = node.triangles[0];
                    let k = original.corners(t).iter().position(|&p| p == node.point).expect("a corner");
                    mesh.place_in(FaceId::new(t as u32 + 1), map.corners(t)[k]).expect("a corner")
                };
                planner.route(mesh, PathAlgorithm::Exact, &place(from), &place(to)).ok().map(|route| route.length)
            };
            let expected = length(&mut planner, &mesh, &map, [&a, &b]);
            let back = length(&mut planner, &mesh, &map, [&b, &a]);
            let same = |x: Option<f64>, y: Option<f64>| match (x, y) {
                (Some(x), Some(y)) => is_close(x, y),
                (x, y) => x == y,
            };
            assert!(same(expected, back), "seed {seed}: {} <-> {}: {expected:?} but back {back:?}", a.point, b.point);
            for (map, mesh, unit) in &moved {
                let found = length(&mut planner, mesh, map, [&a, &b]).map(|length| length / unit);
                assert!(same(expected, found), "seed {seed}: {} -> {}: {expected:?} but {found:?}", a.point, b.point);
            }
        }
    }
}

#[test]
fn the_work_is_bounded_and_dead_ends_are_left_out() {
    // A comb: a corridor with many teeth that lead nowhere.
    let mut triangles = Vec::new();
    let mut points = Vec::new();
    let teeth = 200u32;
    for i in 0..=2 * teeth {
        points.extend([0., 1., 9.].map(|y| Point::new(f64::from(i), y)));
    }
    for i in 0..2 * teeth {
        let [a, b] = [3 * i, 3 * i + 3];
        triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        if i % 2 == 0 {
            triangles.extend([[a + 1, b + 1, b + 2], [a + 1, b + 2, a + 2]]);
        }
    }
    let map = Map { points, triangles };
    let mesh = map.mesh();
    let mut planner = Planner::new();
    let [start, goal] = [Point::new(0.25, 0.5), Point::new(f64::from(2 * teeth) - 0.25, 0.5)];
    // A field goes into all dead ends; no query after it may.
    planner.distance_field(&mesh, &mesh.place(start).expect("a triangle"), f64::INFINITY);
    for algorithm in PathAlgorithm::ALL {
        let route = planner.route_between(&mesh, algorithm, start, goal).expect("a corridor");
        assert!(is_close(route.length, distance(start, goal)), "{algorithm}");
        // The corridor has 4 triangles for each tooth; else only the tooth that the portals lead to may be entered.
        assert!(route.work.expansions <= 4 * u64::from(teeth) + 2, "{algorithm}: {:?}", route.work);
    }
    // A cone with one successor does not go through the queue.
    let route = planner.route_between(&mesh, PathAlgorithm::Exact, start, goal).expect("a corridor");
    assert!(route.work.pops <= 2, "{:?}", route.work);
    // Into a tooth and out of one the portal paths are open.
    let [start, goal] = [Point::new(0.5, 8.0), Point::new(f64::from(2 * teeth) - 1.5, 8.0)];
    let route = planner.route_between(&mesh, PathAlgorithm::Exact, start, goal).expect("a corridor");
    assert_eq!(route.corners.len(), 2);
}

#[test]
fn costs_lead_round_what_is_dear() {
    let map = Map::random(1, 7, 1.0, 0.0);
    let mesh = map.mesh();
    let mut planner = Planner::new();
    let [start, goal] = [Point::new(0.5, 3.4), Point::new(6.5, 3.4)].map(|p| mesh.place(p).expect("free"));
    let mut costs = dcel_kit::FaceMap::filled(mesh.face_bound(), 1.0);
    let in_the_way = |f: FaceId| {
        let [a, b, c] = map.corners(f.index() - 1);
        let middle = Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
        (middle.x - 3.5).abs() < 0.5 && middle.y < 6.0
    };
    mesh.faces().filter(|&f| in_the_way(f)).for_each(|f| costs[f] = 100.0);
    for algorithm in [PathAlgorithm::Centroid, PathAlgorithm::Midpoint, PathAlgorithm::Closest] {
        let cheap = planner.weighted_route(&mesh, algorithm, &costs, &start, &goal).expect("a way");
        assert!(!cheap.faces.iter().any(|&f| in_the_way(f)), "{algorithm} goes through {:?}", cheap.faces);
        let plain = planner.route(&mesh, algorithm, &start, &goal).expect("a way");
        assert!(plain.faces.iter().any(|&f| in_the_way(f)), "{algorithm}");
    }
}
