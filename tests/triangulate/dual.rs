//! Duals: the invariants by which they are made, and that the dual of the dual is the structure again.

use crate::common::Random;
use crate::judge::{polygon, rings};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::topology::{Dcel, DualError, PolygonList, components, isomorphic, measure, violations};
use dcel_kit::{FaceId, VertexId};

fn check(dcel: &Dcel) {
    let dual = dcel.dual().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(violations(&dual), []);
    let counts = |d: &Dcel| (d.vertex_count(), d.edge_count(), d.face_count());
    let (v, e, f) = counts(dcel);
    assert_eq!(counts(&dual), (f, e, v));
    for h in dcel.half_edges() {
        assert_eq!(dual.origin(h).number(), dcel.face(h).number());
        assert_eq!(dual.destination(h).number(), dcel.face(h.twin()).number());
        assert_eq!(dual.face(h).number(), dcel.destination(h).number());
        assert_eq!(dual.next(h), dcel.prev(h.twin()));
    }
    let again = dual.dual().unwrap();
    assert!(isomorphic(&again, dcel).is_ok());
    for h in dcel.half_edges() {
        assert_eq!((again.origin(h), again.face(h)), (dcel.origin(h.twin()), dcel.face(h.twin())));
        assert_eq!(again.next(h), dcel.next(h.twin()).twin());
    }
    // Four quarter turns are none, and free slots stay free.
    let mut home = again.dual().unwrap().dual().unwrap();
    let mut start = dcel.clone();
    for h in dcel.half_edges() {
        assert_eq!((home.origin(h), home.next(h), home.face(h)), (dcel.origin(h), dcel.next(h), dcel.face(h)));
    }
    let one = start.half_edges().next().unwrap();
    assert_eq!(home.split_edge(one).map(|(v, _)| v), start.split_edge(one).map(|(v, _)| v));
}

#[test]
fn duals_of_polygons_trees_and_plane_graphs() {
    (1..7).for_each(|n| check(&Dcel::polygon(n).unwrap()));
    check(Subdivision::lab_rectangle().topology());
    // Dangling edges become loops; a tree has one face.
    let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (1., 1.), (2., 1.), (6., 6.)].map(Point::from);
    check(
        Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [4, 5], [2, 6]]).unwrap().topology(),
    );
    check(Subdivision::from_graph(&points, &[[0, 1], [0, 4], [4, 5], [2, 1], [3, 0], [2, 6]]).unwrap().topology());
    for seed in 0..200_u64 {
        let mut random = Random(seed);
        let mut s = polygon(&[(0, 0), (90, 0), (90, 90), (0, 90)]);
        for _ in 0..1 + random.below(20) {
            let p = Point::new(1.0 + random.below(88) as f64, 1.0 + random.below(88) as f64);
            let _ = s.insert_vertex(p);
        }
        s.triangulate(TriangulationMethod::Monotone).unwrap();
        for _ in 0..random.below(20) {
            let edges: Vec<_> = s.edges().collect();
            let edge = edges[random.below(edges.len())];
            let mut other = s.clone();
            if other.remove_edge(edge).is_ok() && other.topology().dual().is_ok() {
                s = other;
            }
        }
        check(s.topology());
    }
}

#[test]
fn the_dual_of_the_cube_is_the_octahedron() {
    let mut faces = PolygonList::new();
    for face in [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]] {
        faces.push_face(&face);
    }
    let cube = Dcel::from_polygons(8, &faces).unwrap().dcel;
    check(&cube);
    let dual = cube.dual().unwrap();
    assert_eq!((dual.vertex_count(), dual.edge_count(), dual.face_count()), (6, 12, 8));
    assert!(dual.vertices().all(|v| dual.degree(v) == 4));
    assert!(dual.faces().all(|f| dual.incident_half_edges(f).count() == 3));
    assert_eq!(measure(&dual).components[0].genus(), measure(&cube).components[0].genus());
    assert_eq!(components(&dual).count(), 1);
}

#[test]
fn what_has_no_dual_is_named() {
    let ring = rings(&[&[(0, 0), (9, 0), (9, 9), (0, 9)], &[(3, 3), (6, 3), (6, 6)]]);
    let half_edge = ring.cycles(FaceId::new(1)).nth(1).unwrap();
    let refused = ring.topology().dual().unwrap_err();
    assert!(
        matches!(refused, DualError::SecondCycle { half_edge: h, .. } if ring.cycle(half_edge).any(|g| g == h)
        || ring.cycle(half_edge.twin()).any(|g| g == h)),
        "{refused}"
    );
    let DualError::SecondCycle { face, half_edge } = refused else { panic!() };
    assert_eq!(ring.face(half_edge), face);
    let points = [(0., 0.), (9., 0.), (0., 9.), (1., 1.)].map(Point::from);
    let lonely = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0]]).unwrap();
    assert_eq!(lonely.topology().dual(), Err(DualError::IsolatedVertex { vertex: VertexId::new(3) }));
    assert_eq!(Subdivision::new().topology().dual(), Err(DualError::NoBoundary { face: FaceId::new(0) }));
    assert!(Dcel::new().dual().unwrap().vertices().next().is_none());
}
