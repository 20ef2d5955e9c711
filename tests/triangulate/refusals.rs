//! What cannot be triangulated is refused by name, and nothing is changed.

use crate::judge::{METHODS, polygon};
use dcel_kit::plane::{Point, Subdivision, TriangulateError};
use dcel_kit::topology::{IdError, PolygonList};
use dcel_kit::{Element, FaceId};

#[test]
fn the_outer_face_and_faces_that_do_not_exist() {
    let mut s = polygon(&[(0, 0), (4, 0), (4, 4), (0, 4)]);
    let before = s.clone();
    for method in METHODS {
        assert_eq!(s.triangulate_face(s.outer_face(), method), Err(TriangulateError::OuterFace));
        let element: Element = FaceId::new(2).into();
        let error = s.triangulate_face(FaceId::new(2), method);
        assert_eq!(error, Err(IdError::OutOfRange { element, count: 2, bound: 2 }.into()));
    }
    assert_eq!(s.split_into_monotone(s.outer_face()), Err(TriangulateError::OuterFace));
    assert_eq!(s, before);
    assert_eq!(Subdivision::new().triangulate(METHODS[1]).unwrap().diagonals, []);
}

/// Polygons that overlap without sharing an edge pass the converter, unless the full check is asked for.
#[test]
fn overlaps_are_noticed_or_do_no_harm() {
    let mut refused = 0;
    for seed in 0..400_u64 {
        let mut random = crate::common::Random(seed);
        let mut points = Vec::new();
        let mut list = PolygonList::new();
        for _ in 0..2 + random.below(3) {
            let first = points.len() as u32;
            let at = [random.below(30) as f64, random.below(30) as f64];
            let n = 4 + random.below(3) as u32;
            let r = 5.0 + random.below(10) as f64;
            points.extend((0..n).map(|i| {
                let angle = f64::from(i) * std::f64::consts::TAU / f64::from(n) + 0.1;
                let r = if i % 2 == 0 { r } else { 0.4 * r };
                Point::new(at[0] + r * angle.cos(), at[1] + r * angle.sin())
            }));
            list.push_face(&(first..first + n).collect::<Vec<_>>());
        }
        let Ok(s) = Subdivision::from_polygons(points, &list) else { continue };
        for method in METHODS {
            let mut after = s.clone();
            match after.triangulate(method) {
                Ok(_) => assert_eq!(dcel_kit::topology::violations(&after), [], "seed {seed}"),
                Err(error) => {
                    refused += 1;
                    assert_eq!(after, s, "seed {seed}");
                    assert!(!s.geometry_violations().is_empty(), "seed {seed}: {error}");
                    let TriangulateError::NotPlanar { face, vertex } = error else { panic!("seed {seed}: {error}") };
                    assert!(s.has_face(face) && s.has_vertex(vertex));
                    let text = error.to_string();
                    assert!(text.contains(&face.to_string()) && text.contains("dcel validate"), "{text}");
                }
            }
        }
    }
    assert!(refused > 0);
}
