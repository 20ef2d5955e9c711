//! Paths over links against Dijkstra on all pairs, whose lengths come from the visibility graph.

use crate::maps::{Map, Random};
use crate::oracle::{Node, Oracle};
use crate::routes::is_close;
use dcel_kit::navmesh::{Link, LinkError, NavMesh, PathAlgorithm, Planner, Stop};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceMap, VertexId};

/// The least costs by relaxing every pair until nothing changes.
fn least(count: usize, edges: &[(usize, usize, f64)]) -> Vec<f64> {
    let mut costs = vec![f64::INFINITY; count];
    costs[0] = 0.0;
    for _ in 0..count {
        for &(a, b, cost) in edges {
            costs[b] = costs[b].min(costs[a] + cost);
        }
    }
    costs
}

#[test]
fn the_exact_path_over_links_and_storeys_is_the_cheapest_of_all() {
    let mut planner = Planner::new();
    let (mut linked, mut apart, mut several) = (0, 0, 0);
    for seed in 0..50 {
        let mut random = Random::new(seed + 18_000);
        let maps: Vec<Map> = (0..1 + seed % 2).map(|layer| Map::random(9 * seed + layer, 3, 0.7, 0.4)).collect();
        let meshes: Vec<NavMesh> = maps.iter().map(Map::mesh).collect();
        let oracles: Vec<Oracle> = maps.iter().map(Oracle::all_free).collect();
        // A stop in a triangle, and the same for the oracle.
        let mut stops: Vec<(Stop, Node)> = Vec::new();
        let count = 8 + 2 * random.below(8);
        for _ in 0..count {
            let layer = random.below(maps.len());
            let triangle = random.below(maps[layer].triangles.len());
            let point = maps[layer].inside(triangle, &mut random);
            let place = meshes[layer].place(point).expect("inside");
            stops.push((Stop { layer, place }, Oracle::inner_node(point, triangle)));
        }
        // Stops 0 and 1 are the start and the goal; 2 and 3, 4 and 5, ... are links.
        let links: Vec<Link> = stops[2..]
            .chunks(2)
            .map(|pair| Link { from: pair[0].0, to: pair[1].0, cost: [0.0, 0.3, 2.0][random.below(3)] * random.unit() })
            .collect();
        let mut edges: Vec<(usize, usize, f64)> =
            links.iter().enumerate().map(|(i, link)| (2 * i + 2, 2 * i + 3, link.cost)).collect();
        for (a, (from, node)) in stops.iter().enumerate() {
            for (b, (_, other)) in stops.iter().enumerate().filter(|(_, (to, _))| to.layer == from.layer) {
                edges.extend(oracles[from.layer].shortest(node, other).map(|length| (a, b, length)));
            }
        }
        let expected = least(stops.len(), &edges)[1];
        let found = planner.linked_route(&meshes, &links, PathAlgorithm::Exact, &stops[0].0, &stops[1].0);
        let context = format!("seed {seed}");
        let Ok(path) = found else {
            assert_eq!((found, expected), (Err(LinkError::Unreachable), f64::INFINITY), "{context}");
            apart += 1;
            continue;
        };
        assert!(is_close(path.cost, expected), "{context}: {} and not {expected}", path.cost);
        assert_eq!(path.legs.len(), path.links.len() + 1, "{context}");
        // The legs begin and end where the links do, and their costs are the whole.
        let mut sum: f64 = path.links.iter().map(|&i| links[i].cost).sum();
        for (i, leg) in path.legs.iter().enumerate() {
            let from = i.checked_sub(1).map_or(stops[0].0, |before| links[path.links[before]].to);
            let to = path.links.get(i).map_or(stops[1].0, |&link| links[link].from);
            let ends = [leg.route.points[0], *leg.route.points.last().expect("two")];
            assert_eq!((leg.layer, ends), (from.layer, [from.place.point, to.place.point]), "{context}");
            sum += leg.route.length;
        }
        assert!(is_close(sum, path.cost), "{context}: {sum} and not {}", path.cost);
        linked += usize::from(!path.links.is_empty());
        several += usize::from(path.links.len() > 1);
        // Every other algorithm finds a path, too, and none that is shorter.
        for algorithm in PathAlgorithm::ALL {
            let other = planner.linked_route(&meshes, &links, algorithm, &stops[0].0, &stops[1].0);
            let other = other.unwrap_or_else(|error| panic!("{context}, {algorithm}: {error}"));
            assert!(other.cost >= path.cost * (1.0 - 1e-9), "{context}, {algorithm}: {} < {}", other.cost, path.cost);
        }
    }
    assert!(linked > 15 && several > 5 && apart > 2, "{linked} linked, {several} by several, {apart} apart");
}

#[test]
fn links_lead_one_way_and_few_legs_are_searched_for() {
    let mesh = Map::random(1, 8, 1.0, 0.0).mesh();
    let layers = std::slice::from_ref(&mesh);
    let stop = |x: f64, y: f64| Stop { layer: 0, place: mesh.place(Point::new(x, y)).expect("inside") };
    let [a, b] = [stop(0.3, 0.4), stop(7.6, 7.7)];
    let teleport = Link { from: a, to: b, cost: 1.0 };
    let mut planner = Planner::new();
    let mut cost = |links: &[Link], from: &Stop, to: &Stop| {
        planner.linked_route(layers, links, PathAlgorithm::Exact, from, to).map(|path| path.cost)
    };
    let straight = cost(&[], &a, &b).expect("no wall");
    assert_eq!(cost(&[teleport], &a, &b), Ok(1.0));
    assert_eq!(cost(&[teleport], &b, &a), Ok(straight), "it leads one way");
    assert_eq!(cost(&[Link { cost: 99.0, ..teleport }], &a, &b), Ok(straight), "it is too dear");
    let bad = Link { cost: -1.0, ..teleport };
    assert_eq!(cost(&[teleport, bad], &a, &b), Err(LinkError::Cost { link: 1, cost: -1.0 }));
    let above = Stop { layer: 3, ..a };
    assert_eq!(cost(&[teleport], &a, &above), Err(LinkError::NoSuchLayer { layer: 3, layers: 1 }));
    // A hundred links that lead nowhere near: the work is that of the path itself.
    let far: Vec<Link> = (0..100).map(|i| Link { from: b, to: stop(7.0, f64::from(i) * 0.07), cost: 5.0 }).collect();
    let near = stop(0.9, 0.2);
    let work = |links: &[Link]| {
        Planner::new().linked_route(layers, links, PathAlgorithm::Closest, &a, &near).expect("near").work
    };
    assert_eq!(work(&far), work(&[]));
}

#[test]
fn a_field_over_links_has_the_lengths_of_the_paths_over_them() {
    let mut planner = Planner::new();
    let (mut compared, mut linked, mut beyond) = (0, 0, 0);
    for seed in 0..20 {
        let mut random = Random::new(seed + 400);
        let maps: Vec<Map> = (0..1 + seed % 2).map(|layer| Map::random(7 * seed + layer, 3, 0.7, 0.4)).collect();
        let meshes: Vec<NavMesh> = maps.iter().map(Map::mesh).collect();
        let mut stop = || {
            let layer = random.below(maps.len());
            let triangle = random.below(maps[layer].triangles.len());
            let point = maps[layer].inside(triangle, &mut random);
            Stop { layer, place: meshes[layer].place(point).expect("inside") }
        };
        let start = stop();
        let links: Vec<Link> = (0..5).map(|i| Link { from: stop(), to: stop(), cost: 0.2 * f64::from(i) }).collect();
        let limit = if seed % 3 == 0 { 2.0 } else { f64::INFINITY };
        let fields = planner.linked_distance_field(&meshes, &links, &start, limit).expect("costs");
        assert_eq!(fields.len(), meshes.len());
        for (layer, (mesh, map)) in meshes.iter().zip(&maps).enumerate() {
            for (v, &point) in (0..).map(VertexId::new).zip(&map.points) {
                let Ok(places) = mesh.places(point) else { continue };
                let paths = places.into_iter().map(|place| {
                    planner.linked_route(&meshes, &links, PathAlgorithm::Exact, &start, &Stop { layer, place })
                });
                let paths: Vec<_> = paths.filter_map(Result::ok).collect();
                let least = paths.iter().map(|path| path.cost).fold(f64::INFINITY, f64::min);
                match fields[layer].distance(v) {
                    Some(found) => assert!(is_close(found, least), "seed {seed}, {v}: {found} and not {least}"),
                    None => assert!(least > limit || least.is_infinite(), "seed {seed}, {v}: {least}"),
                }
                compared += 1;
                linked += usize::from(paths.iter().any(|path| path.cost <= least && !path.links.is_empty()));
                beyond += usize::from(least.is_finite() && least > limit);
            }
        }
    }
    assert!(compared > 200 && linked > 50 && beyond > 20, "{compared} vertices, {linked} by links, {beyond} beyond");
}

#[test]
fn costs_along_a_route_are_what_many_samples_say_and_decide_about_links() {
    let mut planner = Planner::new();
    let (mut sampled, mut decided) = (0, 0);
    for seed in 0..30 {
        let mut random = Random::new(seed + 900);
        let map = Map::random(seed + 60, 5, 0.85, 0.4);
        let mesh = map.mesh();
        let costs: Vec<f64> = (0..mesh.face_bound()).map(|_| [0.0, 1.0, 2.5][random.below(3)]).collect();
        let costs = FaceMap::from(costs);
        let mut stop = || {
            let point = map.inside(random.below(map.triangles.len()), &mut random);
            Stop { layer: 0, place: mesh.place(point).expect("inside") }
        };
        let (start, goal) = (stop(), stop());
        let Ok(route) = planner.weighted_route(&mesh, PathAlgorithm::Closest, &costs, &start.place, &goal.place) else {
            continue;
        };
        const SAMPLES: usize = 4000;
        let mut expected = 0.0;
        for pair in route.points.windows(2) {
            let [x, y] = [pair[1].x - pair[0].x, pair[1].y - pair[0].y];
            for i in 0..SAMPLES {
                let t = (i as f64 + 0.5) / SAMPLES as f64;
                let p = Point::new(pair[0].x + x * t, pair[0].y + y * t);
                // Along an edge the cost of either side would do.
                let face = mesh.place(p).map_or(route.faces[0], |place| place.face);
                expected += costs[face] * x.hypot(y) / SAMPLES as f64;
            }
        }
        let cost = mesh.cost_along(&route, &costs);
        // A piece from corner to corner of one face runs along an edge, and samples fall on either side of it.
        let along_edges = route.points.windows(2).any(|pair| {
            let has = |f, p| mesh.corners(f).any(|v| mesh.point(v) == p);
            mesh.faces().any(|f| has(f, pair[0]) && has(f, pair[1]))
        });
        if !along_edges {
            assert!((cost - expected).abs() < 0.01 * (1.0 + expected), "seed {seed}: {cost} and not {expected}");
            sampled += 1;
        }
        // A link that costs a little less than the way on foot is taken, one that costs a little more is not.
        let (layers, costs) = (std::slice::from_ref(&mesh), std::slice::from_ref(&costs));
        for (factor, links) in [(0.9, 1), (1.1, 0)] {
            let link = Link { from: start, to: goal, cost: factor * cost };
            let path = planner.weighted_linked_route(layers, &[link], PathAlgorithm::Closest, costs, &start, &goal);
            let path = path.expect("a path");
            if cost > 0.0 {
                assert_eq!(path.links.len(), links, "seed {seed}: {cost}");
                assert!(is_close(path.cost, cost.min(link.cost)), "seed {seed}");
                decided += 1;
            }
        }
    }
    assert!(sampled > 15 && decided > 40, "{sampled} sampled, {decided} decided");
}

#[test]
fn a_path_over_links_begins_and_ends_on_the_sides_that_are_best_with_the_links() {
    // Two squares that touch in a corner, which nobody passes.
    let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (8., 4.), (8., 8.), (4., 8.)].map(Point::from);
    let mut faces = PolygonList::new();
    faces.push_face(&[0, 1, 2, 3]);
    faces.push_face(&[2, 4, 5, 6]);
    let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &faces).expect("a plane")).expect("a mesh");
    let stops = |x: f64, y: f64| -> Vec<Stop> {
        mesh.places(Point::new(x, y)).expect("inside").into_iter().map(|place| Stop { layer: 0, place }).collect()
    };
    let (corner, near, far) = (stops(4., 4.), stops(0.5, 0.5), stops(7., 7.));
    let link = |from: &[Stop], to: &[Stop]| Link { from: from[0], to: to[0], cost: 0.25 };
    let mut planner = Planner::new();
    let mut cost = |links: &[Link], starts: &[Stop], goals: &[Stop]| {
        let layers = std::slice::from_ref(&mesh);
        planner
            .linked_route_among(layers, links, PathAlgorithm::Exact, None, [starts, goals])
            .map(|(path, pair)| (path.cost, pair))
    };
    // To the corner by a link that leads beside its other side; and the same back.
    let beside = stops(5., 4.5);
    let there = link(&near, &beside);
    let expected = 0.25 + 1.25f64.sqrt();
    assert_eq!(cost(&[there], &near, &corner), Ok((expected, [0, 1])));
    assert_eq!(cost(&[link(&beside, &near)], &corner, &near), Ok((expected, [1, 0])));
    // No link, and one that leads nowhere near.
    assert_eq!(cost(&[], &near, &corner), Ok((24.5f64.sqrt(), [0, 0])));
    assert_eq!(cost(&[], &near, &far), Err(LinkError::Unreachable));
    assert_eq!(cost(&[], &[], &far), Err(LinkError::Unreachable));
    assert_eq!(cost(&[Link { cost: -1.0, ..there }], &near, &corner), Err(LinkError::Cost { link: 0, cost: -1.0 }));
}
