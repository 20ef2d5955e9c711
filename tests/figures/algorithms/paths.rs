//! Films of paths: the funnel, the cones.

use super::assert_every_frame_differs;
use dcel_kit::figure::algorithms;
use dcel_kit::navmesh::{Cone, NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};

/// A comb: a path from one tooth to another bends round each corner between.
fn comb(teeth: usize) -> Subdivision {
    let mut corners: Vec<Point> = vec![Point::new(0.0, -1.0), Point::new(4.0 * teeth as f64 - 2.0, -1.0)];
    for i in (0..teeth).rev() {
        let x = 4.0 * i as f64;
        corners.push(Point::new(x + 2.0, 5.0));
        corners.push(Point::new(x, 5.0));
        if i > 0 {
            corners.push(Point::new(x, 0.0));
            corners.push(Point::new(x - 2.0, 0.0));
        }
    }
    let mut s = Subdivision::polygon(&corners).unwrap();
    s.triangulate(TriangulationMethod::Ears).unwrap();
    s
}

#[test]
fn a_funnel_has_a_frame_for_each_portal_and_cones_come_as_the_search_met_them() {
    for teeth in 2..6 {
        let map = comb(teeth);
        let mesh = NavMesh::new(&map).unwrap();
        let [start, goal] = [Point::new(1.0, 4.0), Point::new(4.0 * teeth as f64 - 3.0, 4.5)];
        let [start, goal] = [start, goal].map(|p| mesh.places(p).unwrap()[0]);
        let mut planner = Planner::face_by_face();
        let route = planner.route(&mesh, PathAlgorithm::Exact, &start, &goal).unwrap();
        // A simple polygon has one corridor: the faces between are those of the only path in the tree of faces.
        let mut from = vec![None; map.face_bound()];
        let mut open = vec![start.face];
        while let Some(f) = open.pop() {
            for g in map.adjacent_faces(f).filter(|&g| g != map.outer_face()) {
                if Some(g) != from[f.index()] {
                    from[g.index()] = Some(f);
                    open.push(g);
                }
            }
        }
        let between = std::iter::successors(Some(goal.face), |&f| from[f.index()].filter(|_| f != start.face));
        let portals = between.take_while(|&f| f != start.face).count();
        let film = algorithms::funnel(&map, &mesh, &route, 1000);
        assert_eq!(film.len(), portals + 1, "{teeth} teeth");
        assert_every_frame_differs(&film);

        let cones: Vec<Cone> = planner.cones(&mesh).collect();
        let film = algorithms::cones(&map, &mesh, &cones, &route, 1000);
        assert_eq!(film.len(), cones.len() + 1);
        assert!(cones.len() >= portals, "each portal of the corridor is seen");
        assert_every_frame_differs(&film);
        // Some of them: the path always ends the film.
        let few = algorithms::cones(&map, &mesh, &cones, &route, 2);
        assert_eq!(few.len(), 3);
        assert_eq!(few.captions().last().unwrap().0, "The shortest path");
    }
}
