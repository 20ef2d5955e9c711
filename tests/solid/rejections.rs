//! Polygons that make no surface, and what is said about them.

use super::common::Random;
use super::shapes::{grid_points, polygons};
use dcel_kit::VertexId;
use dcel_kit::solid::{HullFaces, Polyhedron, SolidError};
use dcel_kit::topology::{BuildError, OneSided, PolygonList, faces_to_turn, violations};

fn build(vertices: usize, faces: &PolygonList) -> Result<Polyhedron, SolidError> {
    Polyhedron::from_polygons(vec![[0.0; 3]; vertices], faces)
}

/// Each face of the band shares an edge with the next, the last with the first, and the turns do not cancel.
fn is_moebius(faces: &PolygonList, band: &[u32]) -> bool {
    let sides = |face: u32| {
        let corners = faces.cycle(face as usize).to_vec();
        (0..corners.len()).map(|i| (corners[i], corners[(i + 1) % corners.len()])).collect::<Vec<_>>()
    };
    let mut turned = false;
    for (i, &face) in band.iter().enumerate() {
        let next = sides(band[(i + 1) % band.len()]);
        let Some(&(u, v)) = sides(face).iter().find(|&&(u, v)| next.contains(&(u, v)) || next.contains(&(v, u))) else {
            return false;
        };
        turned ^= next.contains(&(u, v));
    }
    turned
}

#[test]
fn a_moebius_strip_is_named_however_its_faces_are_wound() {
    for (n, seed) in (3..30).zip(0..) {
        // A strip of n quads, closed with a twist, and a cap of triangles so that there is more than the strip.
        let mut random = Random(seed);
        let mut faces = PolygonList::new();
        for i in 0..n {
            let (a, b) = (2 * i, 2 * i + 1);
            let (c, d) = if i + 1 < n { (2 * i + 3, 2 * i + 2) } else { (0, 1) };
            let mut quad = [a, b, c, d];
            if random.below(2) == 0 {
                quad.reverse();
            }
            faces.push_face(&quad);
        }
        faces.push_face(&[0, 2 * n, 2]);
        let error = faces_to_turn(&faces).unwrap_err();
        assert!(is_moebius(&faces, &error.band), "n = {n}: {error}");
        let mut sorted = error.band.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..n).collect::<Vec<_>>(), "each face of the strip once");
        let points = vec![[0.0; 3]; 2 * n as usize + 1];
        assert_eq!(
            Polyhedron::from_polygons_oriented(points, faces.clone()).unwrap_err(),
            SolidError::OneSided(error.clone())
        );
        match build(2 * n as usize + 1, &faces) {
            Err(SolidError::OneSided(named)) => assert_eq!(named, error),
            other => panic!("n = {n}: {other:?}"),
        }
    }
    let klein = polygons(&[
        &[0, 1, 4, 3],
        &[1, 2, 5, 4],
        &[2, 0, 3, 5],
        &[3, 4, 7, 6],
        &[4, 5, 8, 7],
        &[5, 3, 6, 8],
        &[6, 7, 2, 0],
        &[7, 8, 1, 2],
        &[8, 6, 0, 1],
    ]);
    let Err(OneSided { band }) = faces_to_turn(&klein) else { panic!("the bottle of Klein has one side") };
    assert!(is_moebius(&klein, &band), "{band:?}");
}

#[test]
fn faces_wound_against_the_rest_are_found_and_turned() {
    for seed in 0..80 {
        let mut random = Random(seed);
        let points = grid_points(&mut random, 30, 9);
        let solid = Polyhedron::convex_hull(&points, HullFaces::Whole).unwrap().solid;
        let mut faces = PolygonList::new();
        let mut wrong: Vec<u32> = Vec::new();
        let all = solid.face_count();
        let share = 1 + random.below(all / 2 - 1);
        let chosen = random.shuffled(all);
        for (f, i) in solid.faces().zip(0..) {
            let mut corners: Vec<u32> = solid.incident_vertices(f).map(VertexId::number).collect();
            if chosen[i as usize] < share && 2 * share < all {
                corners.reverse();
                wrong.push(i);
            }
            faces.push_face(&corners);
        }
        assert_eq!(faces_to_turn(&faces).unwrap(), wrong, "seed {seed}");
        let points: Vec<_> = solid.vertices().map(|v| solid.point(v)).collect();
        if !wrong.is_empty() {
            let error = Polyhedron::from_polygons(points.clone(), &faces).unwrap_err();
            let SolidError::Winding { first, second, turn, turns, .. } = error else { panic!("seed {seed}: {error}") };
            assert!(wrong.contains(&turn) && [first, second].contains(&turn) && turns == wrong.len(), "seed {seed}");
            assert!(error.to_string().contains(&format!("reverse face {turn}")), "{error}");
        }
        let (repaired, turned) = Polyhedron::from_polygons_oriented(points, faces).unwrap();
        assert_eq!(turned, wrong);
        assert_eq!(violations(&repaired), []);
        assert!(repaired.check_convex().is_ok(), "seed {seed}");
    }
}

#[test]
fn what_turning_does_not_help_keeps_its_own_name() {
    let three = polygons(&[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[2, 3, 4], &[4, 1, 0]]);
    let error = BuildError::ThreeFaces { u: 0, v: 1, faces: vec![0, 1, 2, 4] };
    let told = "the edge between vertices 0 and 1 has 4 faces (0, 1, 2, 4): an edge has two sides";
    assert!(error.to_string().starts_with(told), "{error}");
    assert_eq!(error.faces(), [0, 1, 2, 4]);
    assert_eq!(build(5, &three), Err(SolidError::Build(error.clone())));
    let points = vec![[0.0; 3]; 5];
    assert_eq!(Polyhedron::from_polygons_oriented(points, three).unwrap_err(), SolidError::Build(error));
    // Two tetrahedra and a triangle that touch in vertex 0: three fans.
    let mut faces: Vec<Vec<u32>> = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|t| t.to_vec()).to_vec();
    faces.extend([[0, 5, 4], [0, 4, 6], [4, 5, 6], [5, 0, 6], [0, 7, 8]].map(|t| t.to_vec()));
    let list = polygons(&faces.iter().map(|face| &face[..]).collect::<Vec<_>>());
    let error = BuildError::NonManifoldVertex { vertex: 0, fans: vec![0, 4, 8] };
    assert_eq!(build(9, &list), Err(SolidError::Build(error)));
    let twice = polygons(&[&[0, 1, 2], &[1, 2, 0]]);
    assert_eq!(build(3, &twice), Err(SolidError::Build(BuildError::SameFaceTwice { first: 0, second: 1 })));
}
