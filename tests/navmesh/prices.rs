//! What is told of a way with costs is what it costs: along an edge the cheaper of its two faces, from an end on an edge or
//! a vertex through whichever face there is cheapest.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use crate::surface::list;
use dcel_kit::navmesh::{Floor, NavMesh, NavSurface, PathAlgorithm, Planner, SurfacePlanner};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::{FaceId, FaceMap};

const QUICK: [PathAlgorithm; 4] =
    [PathAlgorithm::Centroid, PathAlgorithm::Midpoint, PathAlgorithm::Closest, PathAlgorithm::Aimed];

/// What the lengths and costs of a way are, in the plane and on the same polygons folded along x = 1.
fn both(
    points: &[[f64; 2]],
    polygons: &[Vec<u32>],
    costs: &[f64],
    ends: [[f64; 2]; 2],
    algorithm: PathAlgorithm,
) -> [[f64; 2]; 2] {
    let costs = FaceMap::from([&[1.0], costs].concat());
    let flat = points.iter().map(|&p| Point::from(p)).collect();
    let mesh = NavMesh::new(&Subdivision::from_polygons(flat, &list(polygons)).expect("a map")).expect("a mesh");
    let places = ends.map(|p| mesh.place(Point::from(p)).expect("on it"));
    let route = Planner::new().weighted_route(&mesh, algorithm, &costs, &places[0], &places[1]).expect("a way");
    let in_plane = [route.length, mesh.cost_along(&route, &costs)];
    // Half as far in the plan, and steep enough to be as far on the surface.
    let fold = |x: f64| (x - 1.0).abs() * 0.75f64.sqrt();
    let lifted: Vec<[f64; 3]> = points.iter().map(|&[x, y]| [1.0 + (x - 1.0) / 2.0, y, fold(x)]).collect();
    let surface = NavSurface::new(&lifted, &list(polygons), None).expect("a surface");
    let places = ends.map(|[x, y]| surface.place([1.0 + (x - 1.0) / 2.0, y], Floor::Any).expect("on the surface"));
    let route = SurfacePlanner::new().weighted_route(&surface, algorithm, &costs, &places[0], &places[1]);
    let route = route.expect("a way");
    [in_plane, [route.length, route.cost]]
}

#[test]
fn between_two_areas_the_cheaper_one_counts() {
    let points = [[0., 0.], [2., 0.], [2., 1.], [0., 1.], [2., 2.], [0., 2.], [1., 0.], [1., 1.], [1., 2.]];
    // Two faces with a corner in the middle of each long side.
    let polygons = [vec![0, 6, 1, 2, 7, 3], vec![3, 7, 2, 4, 8, 5]];
    for algorithm in QUICK {
        for costs in [[5.0, 1.0], [1.0, 5.0]] {
            for ends in [[[0.5, 1.], [1.5, 1.]], [[0., 1.], [2., 1.]], [[0.25, 1.], [0.75, 1.]], [[2., 1.], [1., 1.]]] {
                for [length, cost] in both(&points, &polygons, &costs, ends, algorithm) {
                    assert!(is_close(length, (ends[0][0] - ends[1][0]).abs()), "{algorithm}, {costs:?}, {ends:?}");
                    assert!(is_close(cost, length), "{algorithm}, {costs:?}, {ends:?}: {cost}, {length} long");
                }
            }
        }
    }
}

#[test]
fn beside_two_areas_and_one_with_a_corner_in_its_side_each_part_counts_for_its_own() {
    // One long face below, two short ones above.
    let points = [[0., 0.], [2., 0.], [2., 1.], [1., 1.], [0., 1.], [1., 2.], [0., 2.], [2., 2.]];
    let polygons = [vec![0, 1, 2, 3, 4], vec![4, 3, 5, 6], vec![3, 2, 7, 5]];
    for algorithm in QUICK {
        for (costs, expected) in [([4.0, 1.0, 2.0], 3.0), ([3.0, 5.0, 2.0], 5.0), ([1.0, 5.0, 2.0], 2.0)] {
            for ends in [[[0., 1.], [2., 1.]], [[2., 1.], [0., 1.]]] {
                let [[length, cost], _] = both(&points, &polygons, &costs, ends, algorithm);
                assert!(is_close(length, 2.0) && is_close(cost, expected), "{algorithm}, {costs:?}: {cost}");
            }
        }
    }
}

#[test]
fn an_end_on_an_edge_is_come_to_through_the_cheaper_face() {
    let points = [[0., 0.], [1., 0.], [1., 1.], [1., 2.], [0., 2.], [2., 0.], [2., 1.], [2., 2.]];
    let polygons = [vec![0, 1, 2, 3, 4], vec![1, 5, 6, 2], vec![2, 6, 7, 3]];
    for algorithm in QUICK {
        for (costs, y) in [([1.0, 5.0, 1.0], 0.9), ([1.0, 1.0, 5.0], 1.1)] {
            for ends in [[[0.5, y], [1.5, 1.0]], [[1.5, 1.0], [0.5, y]]] {
                // Not straight through the dear face, but by the corner and along the edge.
                let expected = 0.5f64.hypot(0.1) + 0.5;
                for [_, cost] in both(&points, &polygons, &costs, ends, algorithm) {
                    assert!(is_close(cost, expected), "{algorithm}, {costs:?}, {ends:?}: {cost} and not {expected}");
                }
            }
        }
    }
}

#[test]
fn costs_of_ways_from_and_to_edges_and_vertices_are_those_of_many_samples() {
    let mut planner = Planner::new();
    let (mut compared, mut along) = (0, 0);
    for seed in 0..30 {
        let mut random = Random::new(seed + 5100);
        // Corners on a lattice: samples by 64ths are exactly on its edges.
        let map = Map::random(seed + 5300, 4, 0.9, 0.0);
        let mesh = map.mesh();
        let costs: Vec<f64> = (0..mesh.face_bound()).map(|_| [0.0, 1.0, 2.5, 6.0][random.below(4)]).collect();
        let costs = FaceMap::from(costs);
        let corners: Vec<(FaceId, Vec<Point>)> =
            mesh.faces().map(|f| (f, mesh.corners(f).map(|v| mesh.point(v)).collect())).collect();
        let has = |corners: &[Point], p| (0..3).all(|k| orientation(corners[k], corners[(k + 1) % 3], p).is_ge());
        for _ in 0..6 {
            let ends = [(); 2].map(|()| {
                let corners = map.corners(random.below(map.triangles.len()));
                let [a, b] = [corners[0], corners[1 + random.below(2)]];
                let share = random.below(5) as f64 / 4.0;
                Point::new(a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share)
            });
            let places = ends.map(|p| mesh.places(p).expect("on the mesh")[0]);
            for algorithm in QUICK {
                let Ok(route) = planner.weighted_route(&mesh, algorithm, &costs, &places[0], &places[1]) else {
                    continue;
                };
                let context = format!("seed {seed}, {algorithm}, {ends:?}");
                let (mut expected, mut on_edges) = (0.0, 0);
                const SAMPLES: usize = 256;
                for pair in route.points.windows(2) {
                    let [x, y] = [pair[1].x - pair[0].x, pair[1].y - pair[0].y];
                    for i in 0..SAMPLES {
                        let t = (i as f64 + 0.5) / SAMPLES as f64;
                        let p = Point::new(pair[0].x + x * t, pair[0].y + y * t);
                        let faces = corners.iter().filter(|(_, corners)| has(corners, p));
                        let faces: Vec<FaceId> = faces.map(|&(f, _)| f).collect();
                        let least = faces.iter().map(|&f| costs[f]).fold(f64::INFINITY, f64::min);
                        // Rounding may bring a sample off the mesh by a hair.
                        let least = if faces.is_empty() { costs[route.faces[0]] } else { least };
                        expected += least * x.hypot(y) / SAMPLES as f64;
                        on_edges += usize::from(faces.len() > 1);
                    }
                }
                let cost = mesh.cost_along(&route, &costs);
                assert!((cost - expected).abs() < 0.03 * (1.0 + expected), "{context}: {cost} and not {expected}");
                compared += 1;
                along += usize::from(on_edges > SAMPLES / 2);
            }
        }
    }
    assert!(compared > 400 && along > 100, "{compared} compared, {along} of them along edges");
}

/// One long face beside a straight line and short ones on its other side: of each part of the line the cheaper one counts,
/// whichever way the line runs.
#[test]
fn along_a_line_in_any_direction_each_part_counts_for_the_cheaper_side() {
    let mut planner = Planner::new();
    let mut several = 0;
    for seed in 0..200 {
        let mut random = Random::new(seed + 5500);
        let mut whole = |least: i32, most: i32| least + random.below((most - least + 1) as usize) as i32;
        let (along, origin) = ([whole(-9, 9), whole(-9, 9)], [whole(-50, 50), whole(-50, 50)]);
        if along == [0, 0] {
            continue;
        }
        let stops: Vec<i32> =
            (0..1 + whole(1, 6)).scan(0, |t, _| Some(std::mem::replace(t, *t + whole(2, 5)))).collect();
        let (count, last) = (stops.len(), stops[stops.len() - 1]);
        let ends = [whole(0, last), whole(0, last)];
        // On the line, and beside it on the left.
        let at = |t: i32, off: i32| {
            let [x, y] = [origin[0] + t * along[0] - off * along[1], origin[1] + t * along[1] + off * along[0]];
            Point::new(f64::from(x), f64::from(y))
        };
        let mut points: Vec<Point> = stops.iter().map(|&t| at(t, 0)).chain(stops.iter().map(|&t| at(t, 1))).collect();
        points.extend([at(0, -1), at(last, -1)]);
        let n = count as u32;
        let mut polygons: Vec<Vec<u32>> = vec![[2 * n, 2 * n + 1].into_iter().chain((0..n).rev()).collect()];
        polygons.extend((1..n).map(|i| vec![i - 1, i, n + i, n + i - 1]));
        let mesh = NavMesh::new(&Subdivision::from_polygons(points, &list(&polygons)).expect("a map")).expect("a mesh");
        let costs: Vec<f64> = (0..=polygons.len()).map(|_| f64::from(1 + random.below(6) as u32)).collect();
        let unit = f64::from(along[0]).hypot(f64::from(along[1]));
        let parts = stops.windows(2).zip(&costs[2..]).map(|(pair, &cost)| {
            let [low, high] = [pair[0].max(ends[0].min(ends[1])), pair[1].min(ends[0].max(ends[1]))];
            f64::from((high - low).max(0)) * unit * cost.min(costs[1])
        });
        let expected: f64 = parts.sum();
        let places = ends.map(|t| mesh.places(at(t, 0)).expect("on the line")[0]);
        let costs = FaceMap::from(costs.clone());
        for algorithm in QUICK {
            let route = planner.weighted_route(&mesh, algorithm, &costs, &places[0], &places[1]).expect("a way");
            let cost = mesh.cost_along(&route, &costs);
            let context = format!("seed {seed}, {algorithm}, {along:?} at {origin:?}, {stops:?}, {ends:?}");
            assert!((cost - expected).abs() <= 1e-9 * expected, "{context}: {cost} and not {expected}");
        }
        several +=
            usize::from(stops.iter().filter(|&&t| t > ends[0].min(ends[1]) && t < ends[0].max(ends[1])).count() > 1);
    }
    assert!(several > 40, "{several} along several faces");
}

/// Where all faces cost 1, a way costs its length: also where it runs along rows of edges that rounding has brought off
/// their common line, so that it passes them at any point of theirs.
#[test]
fn for_one_price_a_way_along_a_row_of_edges_costs_its_length() {
    let mut planner = Planner::new();
    let mut compared = 0;
    for seed in 0..120 {
        let mut random = Random::new(seed + 5600);
        let (sin, cos) = (0.1 + 6.0 * random.unit()).sin_cos();
        let scale = [0.01, 1.0, 100.0][seed as usize % 3];
        let turn = |p: Point| Point::new(scale * (p.x * cos - p.y * sin), scale * (p.x * sin + p.y * cos));
        let map = Map::random(seed + 5700, 6, 0.95, 0.0);
        let mesh = map.moved(turn).mesh();
        let costs = FaceMap::filled(mesh.face_bound(), 1.0);
        for _ in 0..20 {
            // Along a column, a row or a diagonal.
            let corner = map.points[random.below(map.points.len())];
            let [dx, dy] = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]][random.below(4)];
            let ends = [(); 2].map(|()| {
                let t = 12.0 * random.unit() - 6.0;
                turn(Point::new(corner.x + t * dx, corner.y + t * dy))
            });
            let [Ok(starts), Ok(goals)] = ends.map(|p| mesh.places(p)) else { continue };
            for algorithm in QUICK {
                let Ok(route) = planner.weighted_route(&mesh, algorithm, &costs, &starts[0], &goals[0]) else {
                    continue;
                };
                let cost = mesh.cost_along(&route, &costs);
                assert!(
                    is_close(cost, route.length),
                    "seed {seed}, {algorithm}, {ends:?}: {cost}, {} long",
                    route.length
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 1000, "{compared} ways");
}
