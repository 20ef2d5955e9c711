//! Flips in the plane, and Delaunay by flips.

use crate::common::{Random, f, v};
use crate::families::{FAMILIES, check, edges, is_general, points};
use dcel_kit::HalfEdgeId;
use dcel_kit::plane::{FlipEdgeError, Point, Subdivision};
use dcel_kit::topology::{self, InnerComponent, Journal, PolygonList};

/// Flips whatever can be flipped, at random.
fn mix(s: &mut Subdivision, random: &mut Random) -> usize {
    let count = 20 * s.edge_count();
    (0..count).filter(|_| s.flip_edge(HalfEdgeId::new(random.below(s.half_edge_bound()) as u32)).is_ok()).count()
}

#[test]
fn flips_lead_from_any_triangulation_to_a_delaunay_one() {
    for family in FAMILIES {
        let mut mixed = 0;
        for seed in 0..12 {
            let mut random = Random(seed);
            let built = Subdivision::delaunay(&points(family, 30, &mut random)).unwrap().subdivision;
            if built.edge_count() == 0 {
                continue;
            }
            let context = format!("{family}, seed {seed}");
            let mut s = built.clone();
            mixed += mix(&mut s, &mut random);
            assert_eq!(s.geometry_violations(), [], "{context}");
            let bad = s.non_delaunay_edges(|_| false).count();
            let mut watched = s.clone();
            let flips = s.make_delaunay(|_| false);
            assert_eq!(flips == 0, bad == 0, "{context}");
            check(&s, &context);
            if is_general(&built) {
                assert_eq!(edges(&s), edges(&built), "{context}: there is only one");
            }
            assert_eq!(s.make_delaunay(|_| false), 0, "{context}: nothing is left to flip");
            let mut journal = Journal::new();
            assert_eq!(watched.make_delaunay_with(|_| false, &mut journal), flips, "{context}");
            assert_eq!((&watched, journal.steps().len()), (&s, 4 * flips), "{context}");
        }
        assert!(mixed > 0 || family.contains("line"), "{family}: no triangulation was changed");
    }
}

#[test]
fn fixed_edges_and_borders_are_never_flipped() {
    let points = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec();
    let kite = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let long = kite.find_half_edge(v(0), v(2)).unwrap();
    assert!(!kite.is_locally_delaunay(long));
    let mut fixed = kite.clone();
    assert_eq!(fixed.make_delaunay(|e| e == long.edge()), 0);
    assert_eq!(fixed, kite);
    // With a hole on one side the edge is a border of the domain; with one on both it is not.
    let mut holed = kite.clone();
    holed.set_hole(f(1), true);
    assert_eq!(holed.make_delaunay(|_| false), 0);
    holed.set_hole(f(2), true);
    assert_eq!(holed.make_delaunay(|_| false), 1);
}

/// A flip that is refused changes nothing and says why.
#[test]
fn every_refusal_of_a_flip_has_its_name() {
    let refused = |s: &Subdivision, h: HalfEdgeId| {
        let mut after = s.clone();
        let error = after.flip_edge(h).unwrap_err();
        assert_eq!(&after, s, "{error}");
        error
    };
    let square = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (1., 3.5)].map(Point::from).to_vec();
    let halves = Subdivision::from_triangles(square.clone(), &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let diagonal = halves.find_half_edge(v(0), v(2)).unwrap();
    let side = halves.find_half_edge(v(0), v(1)).unwrap();
    assert_eq!(refused(&halves, side), FlipEdgeError::NotTriangle { h: side, face: f(0) });
    assert!(matches!(refused(&halves, HalfEdgeId::new(77)), FlipEdgeError::Topology(topology::FlipEdgeError::Id(_))));
    let mut holed = halves.clone();
    holed.set_hole(f(2), true);
    assert_eq!(refused(&holed, diagonal), FlipEdgeError::HoleAndDomain { hole: f(2), face: f(1) });
    assert_eq!(refused(&holed, diagonal.twin()), FlipEdgeError::HoleAndDomain { hole: f(2), face: f(1) });

    // A vertex alone in one of the triangles.
    let mut ringed = halves.clone();
    let added = ringed.insert_vertex(square[4]).unwrap();
    assert!(ringed.inner_components(f(2)).iter().any(|ring| matches!(ring, InnerComponent::Isolated(_))), "{added:?}");
    assert_eq!(refused(&ringed, diagonal), FlipEdgeError::NotTriangle { h: diagonal, face: f(2) });
    // Flips leave such triangles alone, even if the edge is not Delaunay without what lies in them.
    let kite = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec();
    let mut ringed = Subdivision::from_triangles(kite, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    ringed.insert_vertex(Point::new(3.0, 0.5)).unwrap();
    assert_eq!(ringed.make_delaunay(|_| false), 0);

    // A quadrilateral beside a triangle.
    let mut faces = PolygonList::new();
    faces.push_face(&[0, 1, 2, 3]);
    faces.push_face(&[0, 3, 4]);
    let house = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (-3., 2.)].map(Point::from).to_vec();
    let house = Subdivision::from_polygons(house, &faces).unwrap();
    let wall = house.find_half_edge(v(0), v(3)).unwrap();
    assert_eq!(refused(&house, wall), FlipEdgeError::NotTriangle { h: wall, face: f(1) });

    // Straight at one end of the diagonal, and turning right there.
    for corner in [(2., 2.), (1., 1.)] {
        let points = [(0., 0.), (4., 0.), corner, (0., 4.)].map(Point::from).to_vec();
        let arrow = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        let h = arrow.find_half_edge(v(0), v(2)).unwrap();
        assert_eq!(refused(&arrow, h), FlipEdgeError::NotConvex { h, vertex: v(2) });
        assert_eq!(refused(&arrow, h.twin()), FlipEdgeError::NotConvex { h: h.twin(), vertex: v(2) });
    }
    // A dangling edge in the outer face has the same face on both sides.
    let lone = Subdivision::from_segments(&[[Point::new(0., 0.), Point::new(1., 0.)]]).unwrap();
    let h = HalfEdgeId::new(0);
    assert_eq!(refused(&lone, h), topology::FlipEdgeError::SameFace { h, face: f(0) }.into());
}
