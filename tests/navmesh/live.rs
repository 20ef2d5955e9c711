//! Obstacles come and go: what is brought up to date near the cut is what building anew finds.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use dcel_kit::navmesh::{LiveMesh, Location, NavMesh, ObstacleError, ObstacleId, PathAlgorithm, Planner, RouteError};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::topology::{IsomorphismOptions, isomorphic_with, position_key};
use dcel_kit::{EdgeId, FaceId, HalfEdgeId, VertexId};

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// The navmesh of the map of `live`, built anew, with everything closed that is closed there.
fn anew(live: &LiveMesh) -> NavMesh {
    let mut mesh = NavMesh::new(live.map()).expect("the map stays one of convex faces");
    for f in live.map().faces().filter(|&f| live.mesh().has_face(f)) {
        for h in live.map().incident_half_edges(f) {
            if live.mesh().is_wall(h.edge()) {
                mesh.set_wall(f, h.edge(), true);
            }
        }
        if live.mesh().is_blocked(f) {
            mesh.block(f);
        }
    }
    mesh
}

/// Faces, neighbours, components, locations and lengths agree.
fn check(live: &LiveMesh, first: &NavMesh, planner: &mut Planner, random: &mut Random, width: f64, context: &str) {
    let (mesh, fresh) = (live.mesh(), anew(live));
    assert!(mesh.faces().eq(fresh.faces()), "{context}: faces");
    assert_eq!(mesh.component_count(), fresh.component_count(), "{context}: components");
    for f in mesh.faces() {
        assert!(mesh.sides(f).eq(fresh.sides(f)), "{context}: sides of {f}");
        let size = |mesh: &NavMesh| mesh.component(f).map(|c| mesh.component_faces(c).count());
        assert_eq!(size(mesh), size(&fresh), "{context}: component of {f}");
    }
    // Those that are gone have no face round them any more, and edges that are gone are no walls.
    for v in (0..mesh.vertex_bound() as u32).map(VertexId::new) {
        let sorted = |mesh: &NavMesh| {
            let mut wedges = mesh.wedges(v);
            wedges.iter_mut().for_each(|wedge| wedge.sort_unstable());
            wedges.sort_unstable();
            wedges
        };
        assert_eq!(sorted(mesh), sorted(&fresh), "{context}: {v}");
    }
    for e in (0..live.map().edge_bound() as u32).map(EdgeId::new) {
        assert!(live.map().has_edge(e) || !mesh.is_wall(e), "{context}: {e} is gone, and a wall");
    }
    for _ in 0..12 {
        let [a, b] = [(); 2].map(|()| at(random.unit() * width, random.unit() * width));
        // What an obstacle cuts off a hole is that hole still, as it was in the first map.
        let is_hole = |found: Location| matches!(found, Location::Hole(_) | Location::Outer);
        let anew = fresh.locate(a);
        let expected = if is_hole(anew) { first.locate(a) } else { anew };
        assert_eq!(mesh.locate(a), expected, "{context}: {a}");
        assert_eq!(mesh.locate_by_scan(a), expected, "{context}: {a}, by a scan");
        assert_eq!(is_hole(expected), is_hole(anew), "{context}: {a}");
        let length = |mesh: &NavMesh, planner: &mut Planner| {
            planner.route_between(mesh, PathAlgorithm::Exact, a, b).ok().map(|route| route.length)
        };
        match (length(mesh, planner), length(&fresh, planner)) {
            (Some(x), Some(y)) => assert!(is_close(x, y), "{context}: {a} -> {b}: {x} but {y}"),
            (x, y) => assert_eq!(x, y, "{context}: {a} -> {b}"),
        }
    }
}

#[test]
fn walls_and_obstacles_that_come_and_go_leave_what_building_anew_finds() {
    let mut planner = Planner::new();
    for seed in 0..12 {
        let map = Map::random(seed, 4, 0.9, [0.0, 0.4][seed as usize % 2]);
        let (first, mut live) = (map.mesh(), LiveMesh::new(map.subdivision()).expect("triangles"));
        let mut random = Random::new(seed + 6000);
        let mut inside: Vec<ObstacleId> = Vec::new();
        for step in 0..10 {
            let context = format!("seed {seed}, step {step}");
            let [p, q] = [(); 2].map(|()| at(random.unit() * 4.0, random.unit() * 4.0));
            match random.below(5) {
                0 | 1 => inside.push(live.insert_wall(p, q).unwrap_or_else(|error| panic!("{context}: {error}"))),
                2 | 3 => {
                    let size = 0.2 + random.unit();
                    let corners = [p, at(p.x + size, p.y + 0.1), at(p.x + size / 2.0, p.y + size)];
                    inside.push(live.insert_obstacle(&corners).unwrap_or_else(|error| panic!("{context}: {error}")));
                }
                _ if !inside.is_empty() => {
                    let gone = inside.swap_remove(random.below(inside.len()));
                    live.remove(gone).unwrap_or_else(|error| panic!("{context}: {error}"));
                    assert_eq!(live.remove(gone), Err(ObstacleError::NoSuchObstacle { obstacle: gone }));
                }
                _ => {}
            }
            assert_eq!(live.map().geometry_violations(), [], "{context}");
            check(&live, &first, &mut planner, &mut random, 4.0, &context);
        }
        // All taken out: the map is what it was.
        inside.into_iter().for_each(|obstacle| live.remove(obstacle).expect("in the map"));
        check_restored(&live, &map.subdivision(), &format!("seed {seed}"));
    }
}

/// The map of `live` is the one it had in the beginning, element for element, and so is the mesh.
fn check_restored(live: &LiveMesh, first: &Subdivision, context: &str) {
    assert!(live.obstacles().is_empty(), "{context}");
    let map = live.map();
    let counts = |s: &Subdivision| (s.vertex_count(), s.edge_count(), s.face_count());
    assert_eq!(counts(map), counts(first), "{context}: V, E, F");
    let key = |s: &Subdivision, v: VertexId| {
        let p = s.point(v);
        position_key([p.x, p.y])
    };
    let (now, before) = (|v| key(map, v), |v| key(first, v));
    // Every vertex, half-edge and face is its own partner, every point the same to the last place.
    let options = IsomorphismOptions::new().keys(&now, &before).fixed(&|_| true);
    isomorphic_with(map, first, &options).unwrap_or_else(|difference| panic!("{context}: {difference}"));
    let mesh = NavMesh::new(first).expect("it was one");
    assert_eq!((live.mesh().face_count(), live.mesh().component_count()), (mesh.face_count(), mesh.component_count()));
    let (mut planner, mut random) = (Planner::new(), Random::new(first.edge_count() as u64));
    for _ in 0..12 {
        let [a, b] = [(); 2].map(|()| at(random.unit() * 4.0, random.unit() * 4.0));
        assert_eq!(live.mesh().locate(a), mesh.locate(a), "{context}: {a}");
        let mut length =
            |mesh: &NavMesh| planner.route_between(mesh, PathAlgorithm::Exact, a, b).ok().map(|r| r.length);
        match (length(&mesh), length(live.mesh())) {
            (Some(x), Some(y)) => assert!(is_close(x, y), "{context}: {a} -> {b}: {x} but {y}"),
            (x, y) => assert_eq!(x, y, "{context}: {a} -> {b}"),
        }
    }
}

#[test]
fn the_last_obstacle_takes_the_last_cut_with_it() {
    let mut planner = Planner::new();
    for seed in 0..40 {
        // Merged cells as well as triangles; obstacles reach into holes and out of the map.
        let size = 2 + seed as usize % 3;
        let map = Map::random(seed, size, [0.7, 1.0][seed as usize / 2 % 2], [0.0, 0.5][seed as usize % 2]);
        let (first, mesh) = (map.subdivision(), map.mesh());
        let mut live = LiveMesh::new(first.clone()).expect("triangles");
        let mut random = Random::new(seed + 9000);
        let mut inside: Vec<(ObstacleId, Vec<Point>)> = Vec::new();
        let mut script = format!("seed {seed}");
        for _ in 0..14 {
            let grid = |random: &mut Random| {
                let on_grid = seed % 3 == 0;
                let x = (random.unit() * 1.2 - 0.1) * size as f64;
                if on_grid { (2.0 * x).round() / 2.0 } else { x }
            };
            let [p, q] = [(); 2].map(|()| at(grid(&mut random), grid(&mut random)));
            let corners = match random.below(5) {
                0 | 1 => vec![p, q],
                2 => vec![p, at(p.x + 0.7, p.y + 0.1), at(p.x + 0.3, p.y + 0.9)],
                _ => Vec::new(),
            };
            if corners.is_empty() {
                if !inside.is_empty() {
                    let (gone, _) = inside.remove(random.below(inside.len()));
                    script += &format!("\nremove {gone}");
                    live.remove(gone).unwrap_or_else(|error| panic!("{script}: {error}"));
                }
            } else if let Ok(id) = insert(&mut live, &corners) {
                script += &format!("\n{id}: {corners:?}");
                inside.push((id, corners));
            }
            assert_eq!(live.map().geometry_violations(), [], "{script}");
            check(&live, &mesh, &mut planner, &mut random, size as f64, &script);
            // On a grid walls end on others: there a last place decides whether an agent slips through.
            if seed % 3 != 0 {
                check_anew(&live, &first, &inside, &mut planner, &mut random, &script);
            }
        }
        while !inside.is_empty() {
            let (gone, _) = inside.remove(random.below(inside.len()));
            script += &format!("\nremove {gone}");
            live.remove(gone).expect("in the map");
        }
        check_restored(&live, &first, &script);
    }
}

fn insert(live: &mut LiveMesh, corners: &[Point]) -> Result<ObstacleId, ObstacleError> {
    match corners {
        &[p, q] => live.insert_wall(p, q),
        corners => live.insert_obstacle(corners),
    }
}

/// The lengths are those on the first map with the obstacles that are left put in anew.
fn check_anew(
    live: &LiveMesh,
    first: &Subdivision,
    inside: &[(ObstacleId, Vec<Point>)],
    planner: &mut Planner,
    random: &mut Random,
    context: &str,
) {
    let mut anew = LiveMesh::new(first.clone()).expect("triangles");
    for (_, corners) in inside {
        // Put in in another order, a junction is rounded elsewhere, and may then be refused.
        let Ok(_) = insert(&mut anew, corners) else { return };
    }
    for _ in 0..4 {
        let [a, b] = [(); 2].map(|()| at(random.unit() * 4.0, random.unit() * 4.0));
        let mut length =
            |mesh: &NavMesh| planner.route_between(mesh, PathAlgorithm::Exact, a, b).ok().map(|r| r.length);
        match (length(anew.mesh()), length(live.mesh())) {
            (Some(x), Some(y)) => assert!(is_close(x, y), "{context}: {a} -> {b}: {x} anew, {y} by and by"),
            (x, y) => assert_eq!(x, y, "{context}: {a} -> {b}"),
        }
    }
}

/// A wall that ends on an edge stands in the way of the straight edge, which was bent elsewhere by rounding: with the
/// wall the bend goes, too.
#[test]
fn an_edge_is_straight_again_when_the_last_thing_in_its_way_goes() {
    let first = Map::random(18, 2, 1.0, 0.0).subdivision();
    let mut live = LiveMesh::new(first.clone()).expect("triangles");
    let put = |corners: &[(f64, f64)], live: &mut LiveMesh| {
        let corners: Vec<Point> = corners.iter().map(|&p| p.into()).collect();
        insert(live, &corners).expect("it fits")
    };
    // Crosses (1, 0) - (2, 1) at (1.6, 0.6), which is no double.
    let junction = put(&[(0., 1.), (2., 0.5)], &mut live);
    let ending = put(&[(1.5, 0.5), (0.5, 1.)], &mut live);
    live.remove(junction).expect("in the map");
    live.remove(ending).expect("in the map");
    check_restored(&live, &first, "the junction wall first");
    let ending = put(&[(1.5, 0.5), (0.5, 1.)], &mut live);
    let junction = put(&[(0., 1.), (2., 0.5)], &mut live);
    live.remove(ending).expect("in the map");
    live.remove(junction).expect("in the map");
    check_restored(&live, &first, "the ending wall first");
}

#[test]
fn an_obstacle_that_comes_and_goes_a_thousand_times_leaves_no_litter() {
    let map = Map::random(11, 6, 0.9, 0.3).subdivision();
    let mut live = LiveMesh::new(map.clone()).expect("triangles");
    let (before, mut random) = (live.mesh().memory(), Random::new(12));
    for round in 0..400 {
        let [x, y] = [(); 2].map(|()| random.unit() * 4.5);
        let corners = [at(x, y), at(x + 1.3, y + 0.1), at(x + 0.4, y + 1.1)];
        let Ok(id) = live.insert_obstacle(&corners) else { continue };
        live.remove(id).unwrap_or_else(|error| panic!("round {round}: {error}"));
        assert!(live.mesh().memory() < 4 * before + 20_000, "round {round}: {} bytes", live.mesh().memory());
    }
    // Ids are used again.
    assert!(live.map().half_edge_bound() < 2 * map.half_edge_bound() + 300, "{}", live.map().half_edge_bound());
    check_restored(&live, &map, "after all rounds");
}

#[test]
fn the_cuts_of_an_obstacle_go_with_it_while_others_stay() {
    let corners = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
    let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
    let wall = live.insert_wall(at(2., 1.), at(2., 3.)).expect("inside the hall");
    let counts = |live: &LiveMesh| (live.map().vertex_count(), live.map().edge_count(), live.map().face_count());
    let with_wall = counts(&live);
    // Beside the wall, and across it at a point that is no double.
    for obstacle in [
        vec![at(5., 1.), at(6., 1.), at(6., 2.), at(5., 2.)],
        vec![at(1.1, 1.7), at(3.3, 2.1), at(3.2, 2.4)],
        vec![at(1.9, 0.2), at(2.3, 3.8)],
    ] {
        let id = insert(&mut live, &obstacle).expect("it fits");
        live.remove(id).expect("in the map");
        let (v, e, f) = counts(&live);
        assert_eq!(v, with_wall.0, "{obstacle:?}: a vertex is left");
        assert!(e <= with_wall.1 && f <= with_wall.2, "{obstacle:?}: {e} edges and {f} faces are left");
        let [p, q] = [at(2., 1.), at(2., 3.)].map(|p| live.mesh().locate(p));
        let (Location::Vertex(p), Location::Vertex(q)) = (p, q) else { panic!("the ends of the wall") };
        assert!(live.map().find_half_edge(p, q).is_some(), "{obstacle:?}: the wall is no longer one edge");
    }
    live.remove(wall).expect("in the map");
    assert_eq!(counts(&live), (4, 4, 2));
}

#[test]
fn walls_that_cross_open_one_by_one() {
    let hall = || {
        let corners = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
        let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
        let high = live.insert_wall(at(4., 0.), at(4., 4.)).expect("from side to side");
        let long = live.insert_wall(at(0., 2.), at(8., 2.)).expect("across it");
        (live, high, long)
    };
    // Which of the four quarters hang together, from the lower left one counter-clockwise.
    let parts = |live: &LiveMesh| {
        let quarters = [at(1., 1.), at(7., 1.), at(7., 3.), at(1., 3.)];
        let parts = quarters.map(|p| live.mesh().component(live.mesh().place(p).expect("free").face));
        [0, 1, 2, 3].map(|i| parts[i] == parts[(i + 1) % 4])
    };
    let (mut live, high, long) = hall();
    assert_eq!((live.mesh().component_count(), parts(&live)), (4, [false; 4]));
    live.remove(high).expect("in the map");
    assert_eq!((live.mesh().component_count(), parts(&live)), (2, [true, false, true, false]), "both parts open");
    live.remove(long).expect("in the map");
    assert_eq!(parts(&live), [true; 4]);
    let (mut live, high, long) = hall();
    live.remove(long).expect("in the map");
    assert_eq!((live.mesh().component_count(), parts(&live)), (2, [false, true, false, true]), "both parts closed");
    live.remove(high).expect("in the map");
    assert_eq!(parts(&live), [true; 4]);
}

#[test]
fn a_covered_face_that_is_split_stays_covered_until_its_obstacle_goes() {
    let hall = || {
        let corners = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
        let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
        let block = live.insert_obstacle(&[at(5., 1.), at(7., 1.), at(7., 3.), at(5., 3.)]).expect("a block");
        let wall = live.insert_wall(at(6.5, 0.5), at(6.5, 3.5)).expect("across the block");
        (live, block, wall)
    };
    let free = |live: &LiveMesh| {
        [(5.5, 1.5), (6.75, 1.5), (6.25, 2.5), (6.75, 2.5)].map(|(x, y)| live.mesh().place(at(x, y)).is_ok())
    };
    let (mut live, block, wall) = hall();
    assert_eq!(free(&live), [false; 4]);
    live.remove(wall).expect("in the map");
    assert_eq!(free(&live), [false; 4], "the block is still there");
    live.remove(block).expect("in the map");
    assert_eq!(free(&live), [true; 4]);
    let (mut live, block, wall) = hall();
    live.remove(block).expect("in the map");
    assert_eq!(free(&live), [true; 4], "only the wall is left");
    let [a, b] = [at(6., 2.), at(7., 2.)];
    let length =
        |live: &LiveMesh| Planner::new().route_between(live.mesh(), PathAlgorithm::Exact, a, b).expect("free").length;
    let around = length(&live);
    assert!(around > 2.9, "through the wall: {around}");
    // Merged faces keep to the wall as well, and are mended when it goes.
    live.merge_faces();
    assert!(is_close(length(&live), around), "{} through merged faces, {around} else", length(&live));
    live.remove(wall).expect("in the map");
    assert!(is_close(length(&live), 1.0));
}

#[test]
fn obstacles_are_as_if_they_had_been_holes_from_the_beginning() {
    let mut planner = Planner::new();
    for seed in 0..10 {
        let mut random = Random::new(seed + 7000);
        let corners = [at(0., 0.), at(9., 0.), at(9., 9.), at(0., 9.)];
        let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a square")).expect("convex");
        let (mut points, mut edges) = (corners.to_vec(), vec![[0, 1], [1, 2], [2, 3], [3, 0]]);
        for i in 0..9 {
            let [x, y] = [i % 3, i / 3].map(|k| 3.0 * f64::from(k) + 1.5);
            let turn = random.unit();
            let obstacle: Vec<Point> = (0..5)
                .map(|k| (turn + std::f64::consts::TAU * f64::from(k) / 5.0).sin_cos())
                .map(|(sin, cos)| at(x + 1.3 * cos, y + 1.3 * sin))
                .collect();
            live.insert_obstacle(&obstacle).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
            let first = points.len() as u32;
            points.extend(&obstacle);
            edges.extend((0..5).map(|k| [first + k, first + (k + 1) % 5]));
        }
        let mut s = Subdivision::from_graph(&points, &edges).expect("disjoint");
        for i in 0..9 {
            let inner = s.face(HalfEdgeId::new(2 * (4 + 5 * i)));
            s.set_hole(inner, true);
        }
        s.triangulate(TriangulationMethod::Ears).expect("a square with holes");
        let mesh = NavMesh::new(&s).expect("triangles");
        for _ in 0..25 {
            let [a, b] = [(); 2].map(|()| at(random.unit() * 9.0, random.unit() * 9.0));
            let mut length =
                |mesh: &NavMesh| planner.route_between(mesh, PathAlgorithm::Exact, a, b).ok().map(|r| r.length);
            match (length(&mesh), length(live.mesh())) {
                (Some(x), Some(y)) => assert!(is_close(x, y), "seed {seed}: {a} -> {b}: {x} but {y}"),
                (x, y) => assert_eq!(x, y, "seed {seed}: {a} -> {b}"),
            }
        }
    }
}

#[test]
fn a_wall_has_two_sides_and_ends_that_are_turned_round() {
    let corners = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
    let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
    let wall = live.insert_wall(at(4., 1.), at(4., 3.)).expect("inside the hall");
    let mut planner = Planner::new();
    let [left, right] = [3.0, 5.0].map(|x| live.mesh().place(at(x, 2.)).expect("free"));
    let route = planner.route(live.mesh(), PathAlgorithm::Exact, &left, &right).expect("round an end");
    assert!(is_close(route.length, 2.0 * 2f64.sqrt()), "{}", route.length);
    // On the wall one stands on one of its sides; from one to the other is a way.
    let on_wall = at(4., 2.);
    assert!(live.mesh().place(on_wall).is_err());
    let sides: Vec<FaceId> = live.mesh().faces().filter(|&f| live.mesh().place_in(f, on_wall).is_ok()).collect();
    assert_eq!(sides.len(), 2);
    let [one, other] = [0, 1].map(|i| live.mesh().place_in(sides[i], on_wall).expect("a side"));
    assert!(is_close(planner.route(live.mesh(), PathAlgorithm::Exact, &one, &other).expect("round").length, 2.0));
    // From wall to wall the hall falls apart, and together again.
    let upper = live.insert_wall(at(4., 3.), at(4., 4.)).expect("to the border");
    let lower = live.insert_wall(at(4., 0.), at(4., 1.)).expect("to the border");
    assert_eq!(live.mesh().component_count(), 2);
    assert!(matches!(
        planner.route(live.mesh(), PathAlgorithm::Exact, &left, &right),
        Err(RouteError::Unreachable { .. })
    ));
    for obstacle in [upper, wall, lower] {
        live.remove(obstacle).expect("in the map");
        assert_eq!(live.mesh().component_count(), 1);
    }
    assert!(is_close(
        planner.route_between(live.mesh(), PathAlgorithm::Exact, at(3., 2.), at(5., 2.)).expect("free").length,
        2.0
    ));
}

#[test]
fn bad_obstacles_change_nothing() {
    let map = Map::random(2, 3, 1.0, 0.3).subdivision();
    let mut live = LiveMesh::new(map.clone()).expect("triangles");
    let [a, b, c] = [at(1., 1.), at(2., 1.), at(1., 2.)];
    assert!(matches!(live.insert_wall(a, a), Err(ObstacleError::Side { side: 0, .. })));
    assert!(matches!(live.insert_wall(a, at(f64::NAN, 0.)), Err(ObstacleError::Side { .. })));
    assert!(matches!(live.insert_obstacle(&[a, c, b]), Err(ObstacleError::Polygon(_))), "clockwise");
    assert!(matches!(live.insert_obstacle(&[a, b]), Err(ObstacleError::Polygon(_))));
    assert!(matches!(live.remove(ObstacleId(0)), Err(ObstacleError::NoSuchObstacle { .. })));
    assert_eq!(live.map(), &map);
}

#[test]
fn what_an_obstacle_closes_stays_closed_when_another_cuts_it() {
    let corners = [at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)];
    let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
    live.insert_wall(at(4., 0.), at(4., 4.)).expect("from side to side");
    live.insert_wall(at(2., 2.), at(6., 2.)).expect("across the wall");
    assert_eq!(live.mesh().component_count(), 2, "the wall has a hole where it is crossed");
    live.insert_obstacle(&[at(5., 1.), at(7., 1.), at(7., 3.), at(5., 3.)]).expect("a block");
    live.insert_wall(at(6.5, 0.5), at(6.5, 3.5)).expect("across the block");
    for (x, y) in [(5.5, 1.5), (6.75, 1.5), (6.25, 2.5), (6.75, 2.5)] {
        assert!(live.mesh().place(at(x, y)).is_err(), "({x}, {y}) is free inside the block");
    }
}

/// Issue 15: the third wall crosses the cuts that the first two need.
#[test]
fn legal_walls_are_not_refused_because_of_cuts() {
    let hall = [at(0., 0.), at(20., 0.), at(20., 20.), at(0., 20.)];
    let hall = Subdivision::polygon(&hall).expect("a hall");
    let mut live = LiveMesh::new(hall.clone()).expect("convex");
    let walls = [[at(4., 14.), at(9., 9.)], [at(18., 9.), at(14., 2.)], [at(7., 4.), at(12., 7.)]];
    let ids = walls.map(|[p, q]| live.insert_wall(p, q).unwrap_or_else(|error| panic!("{p} {q}: {error}")));
    // None of them is bent: each is one edge.
    for [p, q] in walls {
        let ends = [p, q].map(|p| live.mesh().locate(p));
        let [Location::Vertex(p), Location::Vertex(q)] = ends else { panic!("the ends of a wall") };
        assert!(live.map().find_half_edge(p, q).is_some_and(|h| live.mesh().is_wall(h.edge())));
    }
    ids.into_iter().for_each(|id| live.remove(id).expect("in the map"));
    check_restored(&live, &hall, "after the three walls");
}

/// Whole coordinates: walls meet in vertices, run along each other, and cross near where others cross.
#[test]
fn no_wall_of_a_crowd_is_refused() {
    let mut junctions = 0;
    for seed in 0..36 {
        let mut random = Random::new(seed + 16_000);
        let (size, scale) = (10.0, [1.0, 0.1, 1e-3][seed as usize % 3]);
        let corner = |x: f64, y: f64| at(x * scale, y * scale);
        // One face, and a hundred cells in two triangles each.
        let hall = match seed / 3 % 2 {
            0 => {
                let corners = [corner(0., 0.), corner(size, 0.), corner(size, size), corner(0., size)];
                Subdivision::polygon(&corners).expect("a hall")
            }
            _ => Map::random(seed, size as usize, 1.0, 0.0).moved(|p| corner(p.x, p.y)).subdivision(),
        };
        let mut live = LiveMesh::new(hall.clone()).expect("convex");
        let mut inside: Vec<ObstacleId> = Vec::new();
        let mut script = format!("seed {seed}");
        for _ in 0..24 {
            if random.below(4) == 0 && !inside.is_empty() {
                let gone = inside.swap_remove(random.below(inside.len()));
                script += &format!("\nremove {gone}");
                live.remove(gone).unwrap_or_else(|error| panic!("{script}: {error}"));
                continue;
            }
            let [p, q] = [(); 2].map(|()| corner(random.below(11) as f64, random.below(11) as f64));
            if p == q {
                continue;
            }
            script += &format!("\n{p} {q}");
            inside.push(live.insert_wall(p, q).unwrap_or_else(|error| panic!("{script}: {error}")));
            assert_eq!(live.map().geometry_violations(), [], "{script}");
        }
        junctions += live.map().vertex_count() - hall.vertex_count();
        inside.into_iter().for_each(|id| live.remove(id).expect("in the map"));
        check_restored(&live, &hall, &script);
    }
    assert!(junctions > 1000, "{junctions} junctions: the walls are not put to the test");
}

#[test]
fn corners_may_lie_on_vertices_and_sides_along_edges() {
    let map = Map::random(3, 6, 1.0, 0.0).subdivision();
    let mut live = LiveMesh::new(map.clone()).expect("triangles");
    // Corners of cells; a side along cells; a corner in the corner of another one; the map's own corner.
    let shapes = [
        vec![at(1., 1.), at(3., 1.), at(3., 3.), at(1., 3.)],
        vec![at(3., 3.), at(5., 3.), at(5., 5.)],
        vec![at(0., 0.), at(1., 0.), at(1., 1.)],
        vec![at(3., 1.), at(5., 1.)],
        vec![at(3., 1.), at(3., 3.)],
        vec![at(2., 2.), at(4., 4.)],
    ];
    let ids: Vec<ObstacleId> = shapes.iter().map(|corners| insert(&mut live, corners).expect("it fits")).collect();
    for (p, free) in [(at(2., 1.5), false), (at(4.5, 3.5), false), (at(0.9, 0.5), false), (at(4., 2.), true)] {
        assert_eq!(live.mesh().place(p).is_ok(), free, "{p}");
    }
    assert_eq!(live.map().geometry_violations(), []);
    for (id, corners) in ids.iter().zip(&shapes) {
        assert_eq!(live.corners(*id), Some(corners.as_slice()));
    }
    ids.into_iter().for_each(|id| live.remove(id).expect("in the map"));
    check_restored(&live, &map, "after all");
}

#[test]
fn an_obstacle_that_moves_is_as_if_it_had_been_put_there() {
    let mut planner = Planner::new();
    for seed in 0..16 {
        let map = Map::random(seed, 4, 0.9, [0.0, 0.4][seed as usize % 2]).subdivision();
        let (first, mut live) =
            (NavMesh::new(&map).expect("triangles"), LiveMesh::new(map.clone()).expect("triangles"));
        let mut random = Random::new(seed + 17_000);
        let mut inside: Vec<(ObstacleId, Vec<Point>)> = Vec::new();
        for i in 0..4 {
            let [x, y] = [(); 2].map(|()| random.unit() * 3.0);
            let corners = match i % 2 {
                0 => vec![at(x, y), at(x + 0.8, y + 0.1), at(x + 0.3, y + 0.9)],
                _ => vec![at(x, y), at(x + 1.0, y + 0.7)],
            };
            let id = insert(&mut live, &corners).expect("it fits");
            inside.push((id, corners));
        }
        for step in 0..8 {
            let context = format!("seed {seed}, step {step}");
            let i = random.below(inside.len());
            let by = [(); 2].map(|()| random.unit() - 0.5);
            let (id, corners) = &mut inside[i];
            live.move_obstacle(*id, by).unwrap_or_else(|error| panic!("{context}: {error}"));
            *corners = corners.iter().map(|p| at(p.x + by[0], p.y + by[1])).collect();
            assert_eq!(live.corners(*id), Some(corners.as_slice()), "{context}");
            assert_eq!(live.map().geometry_violations(), [], "{context}");
            check(&live, &first, &mut planner, &mut random, 4.0, &context);
            check_anew(&live, &map, &inside, &mut planner, &mut random, &context);
        }
        // What is refused leaves it where it stands.
        let (id, corners) = &inside[0];
        let clockwise: Vec<Point> = corners.iter().rev().copied().collect();
        assert!(matches!(live.reshape_obstacle(*id, &clockwise), Err(ObstacleError::Polygon(_))), "seed {seed}");
        assert!(live.move_obstacle(*id, [f64::INFINITY, 0.0]).is_err(), "seed {seed}");
        assert_eq!(live.corners(*id), Some(corners.as_slice()), "seed {seed}");
        check_anew(&live, &map, &inside, &mut planner, &mut random, &format!("seed {seed}, refused"));
        let none = ObstacleId(99);
        assert_eq!(live.move_obstacle(none, [1.0, 0.0]), Err(ObstacleError::NoSuchObstacle { obstacle: none }));
        inside.into_iter().for_each(|(id, _)| live.remove(id).expect("in the map"));
        check_restored(&live, &map, &format!("seed {seed}"));
    }
}

/// A floor of cells with a pillar in every third of every third row, each cell in two triangles: near (0, 0) the same for
/// every size.
fn pillars(size: usize) -> Subdivision {
    let corner = |x: usize, y: usize| (y * (size + 1) + x) as u32;
    let points = (0..=size).flat_map(|y| (0..=size).map(move |x| at(x as f64, y as f64))).collect();
    let cells = (0..size).flat_map(|y| (0..size).map(move |x| (x, y)));
    let triangles: Vec<[u32; 3]> = cells
        .filter(|(x, y)| x % 3 != 1 || y % 3 != 1)
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            if (x + y) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        })
        .collect();
    Subdivision::from_triangles(points, &triangles).expect("cells")
}

/// The work of an edit is that near the obstacle, in a map of any size: with merged faces and junctions, too.
#[test]
fn the_work_of_an_edit_does_not_grow_with_the_map() {
    let work = |size: usize| {
        let map = pillars(size);
        let mut live = LiveMesh::new(map.clone()).expect("triangles");
        live.merge_faces();
        live.link_junctions();
        let (mut random, mut inside) = (Random::new(31), Vec::new());
        // Put in, moved, taken out: the sum of links, faces, cells, faces visited.
        let mut sums = [[0usize; 4]; 3];
        let mut count = |what: usize, live: &LiveMesh| {
            let work = live.last_edit();
            let counts = [work.links, work.faces, work.cells, work.visited];
            sums[what].iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        };
        for i in 0..60 {
            let [x, y] = [(); 2].map(|()| 2.0 + 16.0 * random.unit());
            let corners = [at(x, y), at(x + 0.9, y + 0.2), at(x + 0.3, y + 0.8)];
            inside.push(insert(&mut live, &corners[..2 + i % 2]).expect("it fits"));
            count(0, &live);
            if i % 3 == 0 {
                live.move_obstacle(inside[i], [0.3, -0.2]).expect("it fits there, too");
                count(1, &live);
            }
        }
        for id in inside {
            live.remove(id).expect("in the map");
            count(2, &live);
        }
        check_restored(&live, &map, &format!("{size} x {size} cells"));
        sums
    };
    let [small, large] = [24, 72].map(work);
    for (what, (small, large)) in ["in", "moved", "out"].into_iter().zip(small.into_iter().zip(large)) {
        assert_eq!((small[0], small[1]), (large[0], large[1]), "{what}: links and faces");
        // Cells have not quite the same size in both, and dead ends at the far border are near in the small one.
        for k in [2, 3] {
            assert!(large[k] > 0 && 10 * large[k] < 13 * small[k] + 100, "{what}: {small:?} and {large:?}");
        }
    }
}

/// A strip of unit squares, or of triangles that are as high as `height`.
fn strip(count: u32, height: f64, is_cut: bool) -> Subdivision {
    let points = (0..=count).flat_map(|i| [at(f64::from(i), 0.0), at(f64::from(i), height)]).collect::<Vec<_>>();
    let mut edges: Vec<[u32; 2]> = (0..=count).map(|i| [2 * i, 2 * i + 1]).collect();
    edges.extend((0..2 * count).map(|i| [i, i + 2]));
    edges.extend((0..count).filter(|_| is_cut).map(|i| [2 * i, 2 * i + 3]));
    Subdivision::from_graph(&points, &edges).expect("a strip")
}

/// A regular polygon, cut into triangles from its middle.
fn fan(count: u32) -> Subdivision {
    let corner = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(count);
    let mut points: Vec<Point> = (0..count).map(|i| at(100.0 * corner(i).cos(), 100.0 * corner(i).sin())).collect();
    points.push(at(0.0, 0.0));
    let edges: Vec<[u32; 2]> = (0..count).flat_map(|i| [[i, (i + 1) % count], [i, count]]).collect();
    Subdivision::from_graph(&points, &edges).expect("a fan")
}

/// A wall costs what it crosses, not the square of it: however many cuts go, and come again, for each a few links are
/// written, a few faces are read, and a few cells of the index.
#[test]
fn the_work_of_a_wall_grows_with_the_cuts_it_crosses() {
    type Case = (&'static str, fn(u32) -> Subdivision, fn(f64) -> Vec<Point>);
    let cases: [Case; 5] = [
        ("squares", |n| strip(n, 1.0, false), |n| vec![at(0.5, 0.4), at(n - 2.5, 0.6)]),
        ("tall triangles", |n| strip(n, 1e4, true), |n| vec![at(1.0, 5000.3), at(n - 3.0, 5001.0)]),
        ("a bar", |n| strip(n, 1.0, false), |n| vec![at(0.5, 0.3), at(n - 2.5, 0.4), at(n - 2.5, 0.7), at(0.5, 0.6)]),
        ("a fan", fan, |_| vec![at(-10.0, -10.0), at(10.0, 12.0)]),
        ("round a fan", fan, |_| vec![at(-10.0, -10.0), at(10.0, -10.0), at(0.0, 12.0)]),
    ];
    for (what, map, corners) in cases {
        for count in [250, 2000] {
            let map = map(count);
            let mut live = LiveMesh::new(map.clone()).expect("convex faces");
            let id = insert(&mut live, &corners(f64::from(count))).expect("it fits");
            let work = live.last_edit();
            for (most, done) in [(100, work.links), (8, work.faces), (100, work.cells), (50, work.visited)] {
                assert!(done < most * count as usize, "{what}, {count} times: {work:?}");
            }
            check_restored_after(&mut live, id, &map, what);
        }
    }
}

fn check_restored_after(live: &mut LiveMesh, id: ObstacleId, map: &Subdivision, context: &str) {
    live.remove(id).expect("in the map");
    check_restored(live, map, context);
}

/// Blocked triangles that fill the rest of the map, as in files that list them: obstacles reach into them, too.
#[test]
fn obstacles_come_and_go_where_holes_are_cut_into_many_faces() {
    let mut planner = Planner::new();
    for seed in 0..8 {
        let mut random = Random::new(seed + 18_000);
        let mut map = Map::random(seed, 9, 1.0, 0.3).subdivision();
        let blocked: Vec<FaceId> = map.faces().filter(|&f| f != map.outer_face() && random.unit() < 0.55).collect();
        blocked.into_iter().for_each(|f| assert_eq!(map.set_hole(f, true), Some(false)));
        let first = NavMesh::new(&map).expect("triangles");
        let mut live = LiveMesh::new(map.clone()).expect("triangles");
        let mut inside = Vec::new();
        for step in 0..14 {
            let context = format!("seed {seed}, step {step}");
            let [x, y] = [(); 2].map(|()| random.unit() * 10.0 - 0.5);
            if random.below(3) == 0 && !inside.is_empty() {
                let gone: ObstacleId = inside.swap_remove(random.below(inside.len()));
                live.remove(gone).unwrap_or_else(|error| panic!("{context}: {error}"));
            } else {
                let corners = [at(x, y), at(x + 1.4, y + 0.3), at(x + 0.5, y + 1.2)];
                let put = insert(&mut live, &corners[..2 + step % 2]);
                inside.push(put.unwrap_or_else(|error| panic!("{context}: {error}")));
            }
            assert_eq!(live.map().geometry_violations(), [], "{context}");
            check(&live, &first, &mut planner, &mut random, 9.0, &context);
        }
        inside.into_iter().for_each(|id| live.remove(id).expect("in the map"));
        check_restored(&live, &map, &format!("seed {seed}"));
    }
}

/// The edges of a map between two walkable faces.
fn inner_edges(map: &Subdivision) -> Vec<EdgeId> {
    let is_free = |f: FaceId| f != map.outer_face() && !map.is_hole(f);
    map.edges().filter(|e| e.half_edges().iter().all(|&h| is_free(map.face(h)))).collect()
}

/// Each inner edge of the first map is there as it was, with its id, or it is not there at all: and then something stands
/// in its way. Each vertex is one of the first map, the corner of an obstacle, or where two lines cross that close
/// something.
fn check_unbent(live: &LiveMesh, first: &Subdivision, inner: &[EdgeId], context: &str) -> usize {
    let map = live.map();
    let ends = |s: &Subdivision, e: EdgeId| e.half_edges().map(|h| s.point(s.origin(h)));
    let lines = || {
        let sides = |corners: &[Point]| match corners {
            &[p, q] => vec![[p, q]],
            corners => {
                corners.iter().copied().zip(corners.iter().copied().cycle().skip(1)).map(|(p, q)| [p, q]).collect()
            }
        };
        live.obstacles().into_iter().flat_map(move |id| sides(live.corners(id).expect("in the map")))
    };
    let borders = first.edges().filter(|e| inner.binary_search(e).is_err()).map(|e| ends(first, e));
    let closed: Vec<[Point; 2]> = borders.chain(lines()).collect();
    // Rounding may lead a wall past the end of an edge: some last places are left to it.
    let near = |p: Point, [a, b]: [Point; 2]| {
        let [x, y] = [b.x - a.x, b.y - a.y];
        let along = (((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y)).clamp(0.0, 1.0);
        (p.x - a.x - along * x).hypot(p.y - a.y - along * y) < 1e-12
    };
    for v in map.vertices() {
        let p = map.point(v);
        let is_first = v.index() < first.vertex_bound() && first.point(v) == p;
        let is_corner = || lines().any(|line| line.contains(&p));
        let is_junction = || closed.iter().filter(|&&line| near(p, line)).count() > 1;
        assert!(is_first || is_corner() || is_junction(), "{context}: {v} at {p} is where nothing crosses");
    }
    let mut out = 0;
    for &e in inner {
        let [a, b] = ends(first, e);
        if map.has_edge(e) {
            assert_eq!(ends(map, e), [a, b], "{context}: {e} is bent, or another edge");
            continue;
        }
        out += 1;
        let crosses = |[p, q]: [Point; 2]| {
            let side = |a: Point, b: Point, c: Point| (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            side(a, b, p) * side(a, b, q) <= 0.0 && side(p, q, a) * side(p, q, b) <= 0.0
        };
        let touches = |line: [Point; 2]| {
            crosses(line) || line.iter().any(|&p| near(p, [a, b])) || [a, b].iter().any(|&p| near(p, line))
        };
        assert!(lines().any(touches), "{context}: {e} is out, and nothing is in its way");
    }
    out
}

/// Inner edges of the given map are never bent, and nothing else keeps a rounded corner: they are out while something is
/// in their way, and come back with their ids and those of the faces beside them.
#[test]
fn edges_of_the_given_map_are_never_bent() {
    let (mut out, mut back) = (0, 0);
    for seed in 0..24 {
        let size = 4 + seed as usize % 3;
        let map = Map::random(seed, size, [1.0, 0.85][seed as usize % 2], [0.0, 0.4][seed as usize / 2 % 2]);
        let first = map.subdivision();
        let inner = inner_edges(&first);
        let mut live = LiveMesh::new(first.clone()).expect("triangles");
        let mut random = Random::new(seed + 19_000);
        let mut inside: Vec<(ObstacleId, Vec<Point>)> = Vec::new();
        let mut script = format!("seed {seed}");
        let mut planner = Planner::new();
        for _ in 0..16 {
            let on_grid = seed % 4 == 3;
            let mut place = || {
                let [x, y] = [(); 2].map(|()| random.unit() * size as f64);
                if on_grid { at((4.0 * x).round() / 4.0, (4.0 * y).round() / 4.0) } else { at(x, y) }
            };
            let [p, q] = [place(), place()];
            match random.below(6) {
                0 | 1 if p != q => {
                    script += &format!("\n{p} {q}");
                    let id = live.insert_wall(p, q).unwrap_or_else(|error| panic!("{script}: {error}"));
                    inside.push((id, vec![p, q]));
                }
                2 | 3 => {
                    let corners = vec![p, at(p.x + 0.75, p.y + 0.25), at(p.x + 0.25, p.y + 1.0)];
                    script += &format!("\n{corners:?}");
                    let id = live.insert_obstacle(&corners).unwrap_or_else(|error| panic!("{script}: {error}"));
                    inside.push((id, corners));
                }
                _ if !inside.is_empty() => {
                    let (gone, _) = inside.swap_remove(random.below(inside.len()));
                    script += &format!("\nremove {gone}");
                    let before = inner.iter().filter(|&&e| live.map().has_edge(e)).count();
                    live.remove(gone).unwrap_or_else(|error| panic!("{script}: {error}"));
                    back += inner.iter().filter(|&&e| live.map().has_edge(e)).count() - before;
                }
                _ => {}
            }
            assert_eq!(live.map().geometry_violations(), [], "{script}");
            out += check_unbent(&live, &first, &inner, &script);
            if !on_grid {
                check_anew(&live, &first, &inside, &mut planner, &mut random, &script);
            }
        }
        inside.into_iter().for_each(|(id, _)| live.remove(id).expect("in the map"));
        check_restored(&live, &first, &script);
    }
    assert!(out > 1000 && back > 300, "{out} out, {back} back: nothing is put to the test");
}

/// Borders of areas stay where they are, and each face knows its area whatever it is cut into.
#[test]
fn areas_keep_their_borders_while_obstacles_come_and_go() {
    for seed in 0..8 {
        let first = Map::random(seed, 5, 1.0, 0.0).subdivision();
        let index = dcel_kit::plane::PointIndex::new(first.clone());
        let area = |f: FaceId| f.number() / 7 % 3;
        let mut live = LiveMesh::with_areas(first.clone(), area).expect("triangles");
        let mut random = Random::new(seed + 20_000);
        let mut inside: Vec<ObstacleId> = Vec::new();
        for step in 0..12 {
            let [x, y] = [(); 2].map(|()| 4.0 * random.unit());
            if random.below(3) == 0 && !inside.is_empty() {
                live.remove(inside.swap_remove(random.below(inside.len()))).expect("in the map");
            } else {
                let corners = [at(x, y), at(x + 1.3, y + 0.3), at(x + 0.4, y + 1.2)];
                inside.push(insert(&mut live, &corners[..2 + step % 2]).expect("it fits"));
            }
            for f in live.mesh().faces() {
                let corners: Vec<Point> = live.mesh().corners(f).map(|v| live.mesh().point(v)).collect();
                let n = corners.len() as f64;
                let [x, y] = corners.iter().fold([0.0; 2], |[x, y], p| [x + p.x / n, y + p.y / n]);
                let dcel_kit::plane::Location::Face(was) = index.locate(at(x, y)) else { continue };
                if was != first.outer_face() {
                    assert_eq!(live.area(f), Some(area(was)), "seed {seed}, step {step}: {f} in {was}");
                }
            }
        }
        inside.into_iter().for_each(|id| live.remove(id).expect("in the map"));
        check_restored(&live, &first, &format!("seed {seed}"));
    }
}
