//! Corridors: breadth first passes the fewest faces; the aimed line is straight in the open; where a map lies makes no
//! difference.

use crate::maps::{Map, Random};
use crate::oracle::{Oracle, distance};
use crate::routes::{ends, is_close, place};
use crate::surface::{far, list};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{Floor, NavMesh, NavSurface, PathAlgorithm, Planner, QueryPoint, SurfacePlanner};
use dcel_kit::plane::Point;

/// The fewest portals from a face at the start to one at the goal: plainly, and through dead ends, too.
pub(crate) fn fewest_portals(mesh: &NavMesh, start: &QueryPoint, goal: &QueryPoint) -> Option<usize> {
    let goals = mesh.faces_at(goal);
    let mut reached: Vec<(FaceId, usize)> = mesh.faces_at(start).into_iter().map(|f| (f, 0)).collect();
    let mut at = 0;
    while let Some(&(f, portals)) = reached.get(at) {
        if goals.contains(&f) {
            return Some(portals);
        }
        for next in mesh.neighbours(f) {
            if !reached.iter().any(|&(other, _)| other == next) {
                reached.push((next, portals + 1));
            }
        }
        at += 1;
    }
    None
}

#[test]
fn breadth_first_passes_the_fewest_faces() {
    // One planner for all, so that nothing may be left over from the query before.
    let mut planner = Planner::face_by_face();
    for seed in 0..40 {
        let map = Map::random(seed, 4 + seed as usize % 9, [0.65, 0.8, 1.0][seed as usize % 3], 0.4);
        let mut mesh = map.mesh();
        let mut random = Random::new(seed + 3000);
        let mut free = vec![true; map.triangles.len()];
        for _ in 0..seed as usize % 4 {
            let t = random.below(free.len());
            free[t] = false;
            mesh.block(FaceId::new(t as u32 + 1));
        }
        let oracle = Oracle::new(&map, free);
        for pair in ends(&map, &oracle, &mut random, 24).chunks_exact(2) {
            let [start, goal] = [&pair[0], &pair[1]].map(|node| place(&mesh, node));
            let context = format!("seed {seed}: {} -> {}", start.point, goal.point);
            let found = planner.route(&mesh, PathAlgorithm::Breadth, &start, &goal).ok();
            assert_eq!(found.map(|route| route.portals.len()), fewest_portals(&mesh, &start, &goal), "{context}");
        }
    }
}

#[test]
fn an_aimed_line_is_straight_in_the_open() {
    let map = Map::random(5, 24, 1.0, 0.5);
    let mesh = map.mesh();
    let mut planner = Planner::face_by_face();
    let mut random = Random::new(6);
    for _ in 0..50 {
        let mut at = || Point::new(1.0 + 22.0 * random.unit(), 1.0 + 22.0 * random.unit());
        let [start, goal] = [at(), at()];
        let route = planner.route_between(&mesh, PathAlgorithm::Aimed, start, goal).expect("all is free");
        assert!(is_close(route.length, distance(start, goal)), "{start} -> {goal}: {:?}", route.points);
        // Whatever is looked at is on the line, but for the faces round a vertex that it passes closely.
        let faces = route.faces.len() as u64;
        assert!(route.work.expansions <= faces + 2, "{start} -> {goal}: {:?} for {faces} faces", route.work);
        // From each of them two more are reached, at most.
        assert!(route.work.pushes <= 2 * faces + 2, "{start} -> {goal}: {:?}", route.work);
    }
}

/// Lines through midpoints are as long where the map lies elsewhere, or is turned by a right angle: so the rows of faces
/// are the same. Round a vertex of four triangles the centroids are a parallelogram, and two lines through them are equally
/// long: so there the lengths are the same.
#[test]
fn corridors_do_not_depend_on_where_the_map_lies_nor_how_it_is_turned() {
    let (mut plain, mut prepared, mut on_surfaces) = (Planner::face_by_face(), Planner::new(), SurfacePlanner::new());
    let moves: [fn(Point) -> Point; 4] = [
        |p| Point::new(p.x + 1024.0, p.y),
        |p| Point::new(p.x - 96.0, p.y + 512.0),
        |p| Point::new(0.0 - p.y, p.x),
        |p| Point::new(32.0 - p.x, 0.0 - p.y),
    ];
    let mut compared = 0;
    for seed in 0..30 {
        let mut random = Random::new(seed + 3300);
        // Corners on a lattice, so that nothing is rounded when they are moved.
        let lattice = |x: f64| (x * 64.0).round() / 64.0;
        let map = Map::random(seed + 3400, 8, 0.8, 0.6).moved(|p| Point::new(lattice(p.x), lattice(p.y)));
        let heights: Vec<f64> = map.points.iter().map(|_| lattice(random.unit())).collect();
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let lifted = |map: &Map| {
            let points: Vec<[f64; 3]> = map.points.iter().zip(&heights).map(|(p, &z)| [p.x, p.y, z]).collect();
            NavSurface::new(&points, &list(&faces), None).expect("a surface")
        };
        let maps: Vec<Map> = std::iter::once(map.clone()).chain(moves.map(|to| map.moved(to))).collect();
        let spaces: Vec<(NavMesh, NavSurface)> = maps.iter().map(|map| (map.mesh(), lifted(map))).collect();
        // Through the centroids of some faces, at their heights times `steep`.
        let line = |steep: f64, ends: [[f64; 3]; 2], faces: &[FaceId]| -> f64 {
            let centroid = |f: &FaceId| {
                let corners = map.triangles[f.index() - 1].map(|v| v as usize);
                let sum = corners
                    .iter()
                    .fold([0.0; 3], |[x, y, z], &v| [x + map.points[v].x, y + map.points[v].y, z + steep * heights[v]]);
                sum.map(|x| x / 3.0)
            };
            let inner = faces[1..].iter().map(centroid);
            let points: Vec<[f64; 3]> = std::iter::once(ends[0]).chain(inner).chain([ends[1]]).collect();
            points.windows(2).map(|pair| far(pair[0], pair[1])).sum()
        };
        for _ in 0..8 {
            let triangles = [(); 2].map(|()| random.below(map.triangles.len()));
            let ends_on = |map: &Map| {
                triangles.map(|t| {
                    let [a, b, c] = map.corners(t);
                    let part = |a: f64, b: f64, c: f64| a + (b - a) / 4.0 + (c - a) / 4.0;
                    Point::new(part(a.x, b.x, c.x), part(a.y, b.y, c.y))
                })
            };
            for metric in [PathAlgorithm::Centroid, PathAlgorithm::Midpoint] {
                let mut rows = maps.iter().zip(&spaces).map(|(map, (mesh, surface))| {
                    let ends = ends_on(map);
                    let [a, b] = [&mut plain, &mut prepared]
                        .map(|planner| planner.route_between(mesh, metric, ends[0], ends[1]).ok().map(|way| way.faces));
                    let places = ends.map(|p| surface.place([p.x, p.y], Floor::Any).expect("inside"));
                    let in_space = on_surfaces.route(surface, metric, &places[0], &places[1]).ok().map(|way| way.faces);
                    [a, b, in_space]
                });
                let first = rows.next().expect("as it is");
                for (i, other) in rows.enumerate() {
                    let context = format!("seed {seed}, {metric}, {triangles:?}, move {i}");
                    if metric == PathAlgorithm::Midpoint {
                        assert_eq!(other, first, "{context}");
                        continue;
                    }
                    for (k, (one, other)) in first.iter().zip(&other).enumerate() {
                        let [Some(one), Some(other)] = [one, other] else {
                            assert_eq!(one, other, "{context}");
                            continue;
                        };
                        let places = ends_on(&map).map(|p| spaces[0].1.place([p.x, p.y], Floor::Any).expect("inside"));
                        let steep = if k == 2 { 1.0 } else { 0.0 };
                        let ends = places.map(|place| [place.point[0], place.point[1], steep * place.point[2]]);
                        let [one, other] = [one, other].map(|faces| line(steep, ends, faces));
                        assert!(is_close(one, other), "{context}: {one} and {other}");
                    }
                }
                compared += usize::from(first.iter().flatten().any(|faces| faces.len() > 4));
            }
        }
    }
    assert!(compared > 150, "{compared} rows");
}
