//! An agent with a radius: no way comes nearer to a border, and none that is there by a hair is missed.

use crate::maps::{Map, Random};
use crate::oracle::{Oracle, triangles_with};
use crate::routes::is_close;
use dcel_kit::FaceId;
use dcel_kit::navmesh::{Inset, InsetError, LiveMesh, NavMesh, PathAlgorithm, Planner, RouteError};
use dcel_kit::plane::{Point, Subdivision};
use std::f64::consts::PI;

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// A map, some of its faces blocked, and a radius; `None` if an agent of it fits nowhere.
fn case(seed: u64) -> (Map, Vec<bool>, f64, Option<Inset>) {
    let mut random = Random::new(seed + 11_000);
    let map =
        Map::random(seed, 3 + seed as usize % 3, [0.75, 1.0][seed as usize / 2 % 2], [0.0, 0.5][seed as usize % 2]);
    let free: Vec<bool> = map.triangles.iter().map(|_| random.unit() < 0.85).collect();
    let mut mesh = map.mesh();
    for t in (0..free.len()).filter(|&t| !free[t]) {
        mesh.block(FaceId::new(t as u32 + 1));
    }
    let radius = 0.05 + 0.4 * random.unit();
    // Few tangents, or so many that corners are nearly round.
    let inset = match mesh.inset_within(radius, tolerance(seed)) {
        Ok(inset) => Some(inset),
        Err(InsetError::NoRoom { .. }) => None,
        Err(error) => panic!("seed {seed}, radius {radius}: {error}"),
    };
    (map, free, radius, inset)
}

/// By which part of the radius the arcs of a case may be too far out.
fn tolerance(seed: u64) -> f64 {
    [Inset::TOLERANCE, 0.005, 0.5][seed as usize % 3]
}

/// A grid of points, and which of them hang together by steps that keep `radius` all the way.
fn samples(map: &Map, oracle: &Oracle, size: f64, radius: f64) -> Vec<(Point, usize)> {
    const STEPS: i32 = 36;
    let step = size / f64::from(STEPS);
    let good =
        |p: Point| triangles_with(map, p).iter().any(|&t| oracle.free[t]) && oracle.clearance(p) >= radius + 0.5 * step;
    let grid: Vec<Option<Point>> = (0..STEPS * STEPS)
        .map(|i| at((f64::from(i % STEPS) + 0.5) * step, (f64::from(i / STEPS) + 0.5) * step))
        .map(|p| good(p).then_some(p))
        .collect();
    let mut part = vec![usize::MAX; grid.len()];
    for i in 0..grid.len() {
        let mut stack = vec![i];
        while let Some(j) = stack.pop() {
            if grid[j].is_none() || part[j] != usize::MAX {
                continue;
            }
            part[j] = i;
            let (x, y, width) = (j as i32 % STEPS, j as i32 / STEPS, STEPS);
            let beside = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
            let inside = beside.into_iter().filter(|&(x, y)| (0..width).contains(&x) && (0..width).contains(&y));
            stack.extend(inside.map(|(x, y)| (y * width + x) as usize));
        }
    }
    grid.into_iter().zip(part).filter_map(|(p, part)| Some((p?, part))).collect()
}

#[test]
fn every_rung_keeps_the_radius_and_finds_what_is_wide_enough() {
    let mut planner = Planner::new();
    for seed in 0..40 {
        let (map, free, radius, inset) = case(seed);
        let (oracle, size) = (Oracle::new(&map, free), (3 + seed as usize % 3) as f64);
        let samples = samples(&map, &oracle, size, radius * (1.0 + tolerance(seed)));
        let Some(inset) = inset else {
            assert!(samples.is_empty(), "seed {seed}: radius {radius} fits at {}", samples[0].0);
            continue;
        };
        let mut random = Random::new(seed + 12_000);
        for i in 0..8 {
            // Ends that are known to hang together, and ends anywhere.
            let known = i % 2 == 0 && !samples.is_empty();
            let [a, b] = if known {
                let (a, part) = samples[random.below(samples.len())];
                let same: Vec<Point> = samples.iter().filter(|(_, other)| *other == part).map(|(p, _)| *p).collect();
                [a, same[random.below(same.len())]]
            } else {
                [(); 2].map(|()| at(random.unit() * size, random.unit() * size))
            };
            let [start, goal] = [a, b].map(|p| inset.mesh().place(p));
            assert!(!known || start.is_ok() && goal.is_ok(), "seed {seed}, radius {radius}: {a} or {b} is lost");
            let (Ok(start), Ok(goal)) = (start, goal) else { continue };
            for algorithm in PathAlgorithm::ALL {
                let context = format!("seed {seed}, radius {radius}, {algorithm}: {a} -> {b}");
                let route = planner.route(inset.mesh(), algorithm, &start, &goal);
                let Ok(route) = route else {
                    assert!(!known, "{context}: a way is wide enough, and none is found");
                    continue;
                };
                for pair in route.points.windows(2) {
                    let clearance = oracle.clearance_along([pair[0], pair[1]]);
                    assert!(!oracle.crosses_border([pair[0], pair[1]]), "{context}: through a wall");
                    assert!(clearance >= radius * (1.0 - 1e-9), "{context}: {clearance} at {} {}", pair[0], pair[1]);
                }
            }
        }
    }
}

#[test]
fn a_place_is_free_just_if_the_agent_fits_there() {
    for seed in 0..60 {
        let (map, free, radius, inset) = case(seed);
        let oracle = Oracle::new(&map, free);
        let mut random = Random::new(seed + 13_000);
        for _ in 0..60 {
            let p = at(random.unit() * 5.0, random.unit() * 5.0);
            let inside = triangles_with(&map, p).iter().any(|&t| oracle.free[t]);
            let clearance = if inside { oracle.clearance(p) } else { 0.0 };
            let found = inset.as_ref().is_some_and(|inset| inset.mesh().place(p).is_ok());
            if clearance < radius * (1.0 - 1e-9) {
                assert!(!found, "seed {seed}, radius {radius}: {p} is {clearance} off");
            } else if clearance > radius * (1.0 + tolerance(seed)) * (1.0 + 1e-9) {
                assert!(found, "seed {seed}, radius {radius}: {p} is {clearance} off");
            }
        }
    }
}

/// A hall of 12 x 6 with a pillar of 2 x 2 in its middle, cut into triangles.
fn pillar() -> NavMesh {
    let corners = [at(0., 0.), at(12., 0.), at(12., 6.), at(0., 6.), at(5., 2.), at(7., 2.), at(7., 4.), at(5., 4.)];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let mut s = Subdivision::from_graph(&corners, &edges).expect("two squares");
    let inner = s.face(dcel_kit::HalfEdgeId::new(8));
    s.set_hole(inner, true);
    s.triangulate(dcel_kit::plane::TriangulationMethod::Monotone).expect("a ring");
    NavMesh::new(&s).expect("triangles")
}

#[test]
fn the_exact_way_is_between_those_of_two_discs() {
    let mesh = pillar();
    // From the middle of the left to the middle of the right: a tangent, a quarter circle less its angle, and so on.
    let around = |r: f64| {
        let [x, y] = [4.0f64, 1.0];
        let far = x.hypot(y);
        let tangent = (far * far - r * r).sqrt();
        // How far the tangent rises over the line to the corner, and so where it touches.
        let rise = y.atan2(x) + (r / far).asin();
        2.0 * (tangent + r * rise) + 2.0
    };
    for radius in [0.1, 0.5, 0.9] {
        let inset = mesh.inset(radius).expect("2 wide above and below");
        let route =
            Planner::new().route_between(inset.mesh(), PathAlgorithm::Exact, at(1., 3.), at(11., 3.)).expect("round");
        let [low, high] = [radius, radius * (1.0 + Inset::TOLERANCE)].map(around);
        assert!(route.length >= low * (1.0 - 1e-9) && route.length <= high, "{low} <= {} <= {high}", route.length);
    }
    let inset = mesh.inset(1.001).expect("there is room beside the pillar");
    let error =
        Planner::new().route_between(inset.mesh(), PathAlgorithm::Exact, at(2., 3.), at(10., 3.)).expect_err("2 wide");
    assert!(matches!(error, RouteError::Unreachable { .. }), "{error}");
}

#[test]
fn the_end_of_a_wall_is_passed_in_a_half_circle() {
    let hall = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
    let mut live = LiveMesh::new(Subdivision::polygon(&hall).expect("a hall")).expect("convex");
    live.insert_wall(at(4., 0.), at(4., 2.)).expect("inside the hall");
    let radius = 0.5;
    let inset = live.mesh().inset(radius).expect("room");
    let [a, b] = [at(3.5, 0.5), at(4.5, 0.5)];
    for algorithm in PathAlgorithm::ALL {
        let route = Planner::new().route_between(inset.mesh(), algorithm, a, b).expect("round the end");
        let [low, high] = [radius, radius * (1.0 + Inset::TOLERANCE)].map(|r| 3.0 + PI * r);
        assert!(route.length >= low * (1.0 - 1e-9) && route.length <= high, "{algorithm}: {}", route.length);
    }
}

#[test]
fn a_straight_border_in_pieces_leaves_no_cracks() {
    // Two pieces of one line; with some lengths their strips leave a crack of one last place at (0, 0).
    for i in [3.0, 5.0, 7.0, 9.0] {
        let mut points = vec![at(-3., -1.), at(0., 0.), at(3. * i, i)];
        let border = points.clone();
        let end = border[border.len() - 1].x;
        points.extend([at(end, 2.0 * end), at(-3., 2.0 * end)]);
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let mut list = dcel_kit::topology::PolygonList::new();
        list.push_face(&corners);
        let mut s = Subdivision::from_polygons(points, &list).expect("a room");
        s.triangulate(dcel_kit::plane::TriangulationMethod::Ears).expect("a room");
        let radius = 0.23;
        let inset = NavMesh::new(&s).expect("triangles").inset(radius).expect("room");
        for p in border {
            let near = inset.mesh().nearest_point(p).expect("somewhere");
            assert!(near.distance >= radius * (1.0 - 1e-9), "{p}: {} off", near.distance);
        }
    }
}

#[test]
fn no_radius_and_no_room_are_refused_by_name() {
    let mesh = pillar();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(mesh.inset(bad), Err(InsetError::Radius { .. })), "{bad}");
    }
    for large in [3.0, 100.0] {
        assert_eq!(mesh.inset(large).expect_err("6 wide"), InsetError::NoRoom { radius: large });
    }
    let inset = mesh.inset(0.25).expect("room");
    assert!(is_close(inset.radius(), 0.25));
    let (map, own) = inset.into_parts();
    assert_eq!(own.face_count() + map.hole_faces().count() + 1, map.face_count());
}

/// A crowd of corners: what is left has not many more faces than the map.
#[test]
fn an_inset_has_not_many_more_faces_than_its_map() {
    for (seed, jitter) in [(1, 0.0), (2, 0.0), (3, 0.5), (4, 0.5)] {
        let mesh = Map::random(seed, 24, 0.75, jitter).mesh();
        let faces = |tolerance: f64| mesh.inset_within(0.2, tolerance).expect("room").mesh().face_count();
        let [coarse, fine, finest] = [Inset::TOLERANCE, 0.01, 0.001].map(faces);
        assert!(coarse < 3 * mesh.face_count(), "seed {seed}: {coarse} of {}", mesh.face_count());
        assert!(coarse < fine && fine < finest, "seed {seed}: {coarse} {fine} {finest}");
    }
    let mesh = pillar();
    for tolerance in [0.0, -0.1, 1.5, f64::NAN, 1e-300, 1e-9] {
        let error = mesh.inset_within(0.5, tolerance).expect_err("no part of the radius");
        assert!(matches!(error, InsetError::Tolerance { .. }), "{tolerance}: {error}");
    }
}
