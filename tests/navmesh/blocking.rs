//! Blocking and walls: what is kept up to date locally is what a look at everything finds.

use crate::maps::{Map, Random};
use crate::oracle::Oracle;
use crate::routes::{check, ends};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{NavMesh, Planner};
use dcel_kit::plane::Point;

/// Components, dead ends and portals of the mesh against plain floods and peeling.
fn check_derived(map: &Map, mesh: &NavMesh, oracle: &Oracle, context: &str) {
    let face = |t: usize| FaceId::new(t as u32 + 1);
    let neighbours: Vec<Vec<usize>> =
        (0..map.triangles.len()).map(|t| if oracle.free[t] { oracle.neighbours(t) } else { Vec::new() }).collect();
    let mut seen = vec![false; map.triangles.len()];
    let mut components = 0;
    for t in 0..map.triangles.len() {
        assert_eq!(mesh.component(face(t)).is_some(), oracle.free[t], "{context}: {}", face(t));
        if seen[t] || !oracle.free[t] {
            continue;
        }
        let mut part = vec![t];
        seen[t] = true;
        let mut i = 0;
        while i < part.len() {
            for &u in &neighbours[part[i]] {
                if !std::mem::replace(&mut seen[u], true) {
                    part.push(u);
                }
            }
            i += 1;
        }
        components += 1;
        let number = mesh.component(face(t)).expect("a free face");
        assert_eq!(mesh.component_faces(number).count(), part.len(), "{context}: {number}");
        assert!(part.iter().all(|&u| mesh.component(face(u)) == Some(number)), "{context}: {number}");
        assert!(mesh.components().any(|entry| entry == (number, part.len())), "{context}: {number}");

        // Peeling: in a component with a round trip the rest is unique, else one face is left.
        let mut left = part.clone();
        while let Some(end) = left.iter().position(|&u| neighbours[u].iter().filter(|w| left.contains(w)).count() <= 1)
            && left.len() > 1
        {
            left.remove(end);
        }
        let rest: Vec<usize> = part.iter().copied().filter(|&u| !mesh.is_dead_end(face(u))).collect();
        if left.len() == 1 {
            assert_eq!(rest.len(), 1, "{context}: {number} is a tree");
        } else {
            let mut sorted = [left, rest];
            sorted.iter_mut().for_each(|list| list.sort_unstable());
            assert_eq!(sorted[0], sorted[1], "{context}: {number}");
        }
        for &u in &part {
            let path: Vec<FaceId> = mesh.portal_path(face(u)).take(map.triangles.len() + 1).collect();
            assert!(path.len() <= part.len(), "{context}: the portals from {} run in a circle", face(u));
            assert!(path.windows(2).all(|pair| mesh.neighbours(pair[0]).any(|f| f == pair[1])), "{context}");
        }
    }
    assert_eq!(mesh.component_count(), components, "{context}");
}

#[test]
fn blocking_and_unblocking_is_as_good_as_building_anew() {
    let mut planner = Planner::new();
    for seed in 0..24 {
        let map = Map::random(seed, 3 + seed as usize % 3, 0.8, [0.0, 0.5][seed as usize % 2]);
        let mut mesh = map.mesh();
        let mut free = vec![true; map.triangles.len()];
        let mut random = Random::new(seed + 5000);
        for step in 0..14 {
            let t = random.below(free.len());
            let f = FaceId::new(t as u32 + 1);
            let before = if free[t] { mesh.block(f) } else { mesh.unblock(f) };
            assert_eq!(before, Some(!free[t]));
            free[t] = !free[t];
            let oracle = Oracle::new(&map, free.clone());
            let context = format!("seed {seed}, step {step}");
            check_derived(&map, &mesh, &oracle, &context);
            for pair in ends(&map, &oracle, &mut random, 2).chunks_exact(2) {
                check(&mesh, &mut planner, &oracle, [&pair[0], &pair[1]], &context);
            }
        }
        for (t, &was_free) in free.iter().enumerate() {
            if !was_free {
                mesh.unblock(FaceId::new(t as u32 + 1));
            }
        }
        check_derived(&map, &mesh, &Oracle::all_free(&map), &format!("seed {seed}, all free again"));
    }
}

#[test]
fn a_wall_is_closed_from_both_sides_and_opens_again() {
    let map = Map::random(7, 3, 1.0, 0.0);
    let mut mesh = map.mesh();
    let f = FaceId::new(1);
    let inner: Vec<_> = mesh.sides(f).filter(|side| side.open).collect();
    for side in &inner {
        assert_eq!(mesh.set_wall(f, side.half_edge.edge(), true), Some(false));
        assert!(!mesh.neighbours(side.across).any(|g| g == f), "{:?} is open from behind", side.half_edge);
    }
    assert_eq!((mesh.component_count(), mesh.neighbours(f).count()), (2, 0));
    for side in &inner {
        assert_eq!(mesh.set_wall(f, side.half_edge.edge(), false), Some(true));
    }
    assert_eq!(mesh.component_count(), 1);
    check_derived(&map, &mesh, &Oracle::all_free(&map), "walls taken away");
}

/// What is cut off gets a new number, be it on whichever side; so the cost is that of the smaller part.
#[test]
fn the_larger_part_keeps_its_number() {
    let points = (0..=40).flat_map(|x| [0.0, 1.0].map(|y| Point::new(f64::from(x), y))).collect();
    let triangles: Vec<[u32; 3]> = (0..40).flat_map(|x| [[0, 2, 3], [0, 3, 1]].map(|t| t.map(|v| v + 2 * x))).collect();
    let mut mesh = Map { points, triangles }.mesh();
    let [left, right] = [1, 80].map(FaceId::new);
    let number = mesh.component(left);
    mesh.block(FaceId::new(10));
    assert_eq!(mesh.component(right), number);
    assert_ne!(mesh.component(left), number);
    mesh.unblock(FaceId::new(10));
    assert_eq!((mesh.component(left), mesh.component(right)), (number, number));
    mesh.block(FaceId::new(70));
    assert_eq!(mesh.component(left), number);
    assert_ne!(mesh.component(right), number);
}

#[test]
fn what_is_no_face_cannot_be_blocked() {
    let mut mesh = Map::random(7, 3, 1.0, 0.0).mesh();
    for f in [0, 1000, u32::MAX] {
        assert_eq!((mesh.block(FaceId::new(f)), mesh.unblock(FaceId::new(f))), (None, None));
    }
}
