//! Schlegel diagrams, and winged-edge tables.

use super::common::Random;
use super::shapes::{prism, round_solid};
use dcel_kit::FaceId;
use dcel_kit::figure::{self, Camera, FigureOptions, HiddenLines};
use dcel_kit::solid::{Archimedean, NotConvex, Platonic, Polyhedron, SchlegelError};
use dcel_kit::topology::{PolygonList, isomorphic, violations};

#[test]
fn seen_through_any_face_a_solid_is_the_same_structure() {
    let mut random = Random(5);
    let mut solids: Vec<Polyhedron> = Platonic::ALL.map(Polyhedron::platonic).to_vec();
    solids.extend(Archimedean::ALL.map(Polyhedron::archimedean));
    solids.push(prism(&[[0.0, 0.0], [9.0, 1.0], [3.0, 2.0]], 0.01));
    solids.push(round_solid(&mut random, 60));
    for solid in &solids {
        for face in solid.faces() {
            let seen = solid.schlegel(face).unwrap();
            assert_eq!(violations(&seen.diagram), []);
            assert_eq!(seen.diagram.geometry_violations(), [], "{face}");
            assert!(isomorphic(solid.topology(), seen.diagram.topology()).is_ok(), "{face}");
            for f in seen.diagram.faces() {
                let mut there: Vec<_> = seen.diagram.incident_vertices(f).map(|v| seen.vertices[v]).collect();
                let mut here: Vec<_> = solid.incident_vertices(seen.faces[f]).collect();
                there.sort_unstable();
                here.sort_unstable();
                assert_eq!(there, here, "{f}");
            }
            assert_eq!(seen.faces[FaceId::new(0)], face);
        }
    }
}

#[test]
fn only_faces_of_convex_solids_are_looked_through() {
    let cube = Polyhedron::platonic(Platonic::Cube);
    assert!(matches!(cube.schlegel(FaceId::new(6)), Err(SchlegelError::Id(_))));
    let l = prism(&super::shapes::L, 1.0);
    assert!(matches!(l.schlegel(FaceId::new(2)), Err(SchlegelError::NotConvex(NotConvex::ReflexCorner { .. }))));
}

/// A box in front hides the left half of one behind it, seen from -y.
#[test]
fn an_edge_that_passes_behind_a_box_is_hidden_up_to_its_outline() {
    let place = |x: [f64; 2], y: [f64; 2], z: [f64; 2]| {
        (0..8).map(move |i: usize| [x[i & 1], y[i >> 1 & 1], z[i >> 2]]).collect::<Vec<_>>()
    };
    let sides: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut faces = PolygonList::new();
    sides.iter().for_each(|side| faces.push_face(side));
    sides.iter().for_each(|side| faces.push_face(&side.map(|corner| corner + 8)));
    let mut points = place([0.0, 1.0], [0.0, 1.0], [0.0, 1.0]);
    points.extend(place([0.5, 1.5], [2.0, 3.0], [0.25, 0.75]));
    let both = Polyhedron::from_polygons(points, &faces).unwrap();
    let options = FigureOptions::new("Two boxes");
    let camera = Camera { towards: [0.0, -1.0, 0.0], distance: None };
    let svg = figure::solid(&both, &camera, HiddenLines::LeftOut, &options).unwrap().to_svg();
    assert_eq!(svg.matches("data-origin").count(), 4, "only the front of the first box is seen whole");
    assert_eq!(svg.matches("<title>edge</title>").count(), 3, "two halves and the right side of the second: {svg}");
    // From the other side the second box is in front.
    let behind = Camera { towards: [0.0, 1.0, 0.0], distance: Some(20.0) };
    let svg = figure::solid(&both, &behind, HiddenLines::Dashed, &options).unwrap().to_svg();
    assert_eq!(svg.matches("data-origin").count(), 4);
    assert!(svg.contains("<title>hidden edge</title>"));
}
