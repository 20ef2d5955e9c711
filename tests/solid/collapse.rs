//! Collapsing edges of surfaces with borders: no hole closes, no two borders touch.

use super::common::{Random, v};
use super::shapes::polygons;
use dcel_kit::solid::{CollapseError, Polyhedron, SurfaceJournal};
use dcel_kit::topology::{CollapseEdgeError, violations};
use dcel_kit::{HalfEdgeId, VertexId};

/// A ring between a triangular hole, v0 v1 v2, and a hexagon, v3 .. v8.
fn annulus() -> Polyhedron {
    let inner = (0..3).map(|i| (f64::from(i) * 2.0 + 0.5, 1.0));
    let outer = (0..6).map(|i| (f64::from(i), 2.0));
    let at = |(turn, r): (f64, f64)| [r * (turn * 1.047).cos(), r * (turn * 1.047).sin(), 0.0];
    let faces = polygons(&[&[0, 3, 4], &[0, 4, 5, 1], &[1, 5, 6], &[1, 6, 7, 2], &[2, 7, 8], &[2, 8, 3, 0]]);
    Polyhedron::from_polygons(inner.chain(outer).map(at).collect(), &faces).unwrap()
}

#[test]
fn a_triangular_hole_is_not_closed_although_the_kernel_would() {
    let ring = annulus();
    assert_eq!((ring.boundary_faces().len(), ring.parts()[0].euler()), (2, 0));
    let h = ring.find_half_edge(v(0), v(1)).unwrap();
    let mut closed = ring.topology().clone();
    closed.collapse_edge(h).unwrap();
    assert_eq!(closed.face_count(), ring.face_count() - 1, "the kernel takes the hole for a triangle");
    for h in [h, h.twin()] {
        let mut after = ring.clone();
        let refused = after.collapse_edge(h).unwrap_err();
        let hole = ring.boundary_faces().find(|&f| ring.incident_half_edges(f).count() == 3).unwrap();
        assert_eq!(refused, CollapseError::ClosesHole { h, boundary_face: hole });
        assert_eq!(after, ring);
    }
    let spoke = ring.find_half_edge(v(0), v(4)).unwrap();
    ring.topology().clone().collapse_edge(spoke).unwrap();
    let mut after = ring.clone();
    let refused = after.collapse_edge(spoke).unwrap_err();
    assert!(matches!(refused, CollapseError::JoinsBorders { h, borders } if h == spoke && borders[0] != borders[1]));
    assert_eq!(after, ring);
    // An edge of the hexagon may go.
    let rim = ring.find_half_edge(v(4), v(3)).unwrap();
    assert_eq!(after.collapse_edge(rim), Ok(v(3)));
    assert_eq!((after.boundary_faces().len(), after.parts()[0].euler(), after.polygon_faces().count()), (2, 0, 5));
    assert_eq!(violations(&after), []);
    assert!(matches!(after.collapse_edge(HalfEdgeId::new(99)), Err(CollapseError::Topology(CollapseEdgeError::Id(_)))));
}

/// A sheet of triangles with holes is coarsened until no edge may go: it keeps its holes, each vertex one gap at
/// most, and each undo gives back what was.
#[test]
fn random_collapses_keep_every_hole_open_and_apart() {
    let side = 7;
    let at = |x: u32, y: u32| y * (side + 1) + x;
    for seed in 0..6 {
        let mut random = Random(seed);
        let mut triangles: Vec<[u32; 3]> = (0..side * side)
            .map(|i| (i % side, i / side))
            .flat_map(|(x, y)| {
                let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        // A hole of one triangle, and one of two.
        triangles.retain(|t| {
            ![[at(2, 2), at(3, 2), at(3, 3)], [at(5, 4), at(6, 4), at(6, 5)], [at(5, 4), at(6, 5), at(5, 5)]]
                .contains(t)
        });
        let faces: Vec<&[u32]> = triangles.iter().map(|t| &t[..]).collect();
        let points = (0..(side + 1) * (side + 1)).map(|i| [f64::from(i % (side + 1)), f64::from(i / (side + 1)), 0.0]);
        let mut sheet = Polyhedron::from_polygons(points.collect(), &polygons(&faces)).unwrap();
        assert_eq!(sheet.boundary_faces().len(), 3);
        let (start, mut journal, mut pages) = (sheet.clone(), SurfaceJournal::new(), Vec::new());
        loop {
            let fit: Vec<HalfEdgeId> = sheet.half_edges().filter(|&h| sheet.can_collapse_edge(h).is_ok()).collect();
            if fit.is_empty() {
                break;
            }
            let h = fit[random.below(fit.len())];
            pages.push((journal.len(), sheet.clone()));
            sheet.collapse_edge_with(h, &mut journal).unwrap();
            assert_eq!((violations(&sheet), sheet.boundary_faces().len()), (vec![], 3), "seed {seed}, {h}");
            assert_eq!((sheet.parts().len(), sheet.parts()[0].euler()), (1, -1), "seed {seed}, {h}");
            let gaps = |v: VertexId| sheet.incident_faces(v).filter(|&f| sheet.is_boundary_face(f)).count();
            assert!(sheet.vertices().all(|v| gaps(v) <= 1), "seed {seed}, {h}");
            assert!(sheet.faces().all(|f| sheet.incident_half_edges(f).count() >= 3), "seed {seed}, {h}");
        }
        assert!(sheet.vertex_count() < 20, "seed {seed}: {}", sheet.vertex_count());
        for (mark, before) in pages.into_iter().rev() {
            sheet.undo(&mut journal, mark);
            assert_eq!(sheet, before, "seed {seed}");
        }
        assert_eq!(sheet, start);
    }
}
