//! Corridors: breadth first passes the fewest faces; the aimed line is straight in the open.

use crate::maps::{Map, Random};
use crate::oracle::{Oracle, distance};
use crate::routes::{ends, is_close, place};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner, QueryPoint};
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
