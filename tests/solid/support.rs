//! Support points by climbing, against whole numbers and against looking at all vertices.

use super::common::{Random, v};
use super::shapes::{L, cut_cube, grid_points, polygons, prism, round_solid, torus};
use dcel_kit::solid::{Convex, Direction, HullFaces, NotConvex, Platonic, Polyhedron};
use dcel_kit::{FaceId, VertexId};

fn direction(d: [f64; 3]) -> Direction {
    Direction::try_from(d).unwrap()
}

/// The vertex that whole numbers say: furthest, then greatest x, y, z.
fn by_whole_numbers(solid: &Polyhedron, d: [i64; 3]) -> VertexId {
    let key = |v: &VertexId| {
        let p = solid.point(*v).map(|x| x as i64);
        (d[0] * p[0] + d[1] * p[1] + d[2] * p[2], p)
    };
    solid.vertices().max_by_key(key).unwrap()
}

fn check_all_hints(convex: &Convex<'_>, d: [f64; 3], expected: VertexId) {
    for hint in convex.solid().vertices() {
        assert_eq!(convex.support_from(direction(d), hint), expected, "{d:?} from {hint}");
    }
    let path = convex.climb(direction(d), VertexId::new(0));
    assert_eq!(path.last(), Some(&expected), "{d:?}");
    let map = convex.support_map();
    assert_eq!(map.support(direction(d)), expected, "{d:?}, prepared");
    for hint in convex.solid().vertices() {
        assert_eq!(map.support_from(direction(d), hint), expected, "{d:?} from {hint}, prepared");
    }
}

#[test]
fn climbing_finds_what_whole_numbers_say_with_any_hint() {
    let mut ties = 0;
    for seed in 0..60 {
        let mut random = Random(seed);
        let points = grid_points(&mut random, 40, 6);
        let faces = if seed % 2 == 0 { HullFaces::Whole } else { HullFaces::Triangles };
        let solid = Polyhedron::convex_hull(&points, faces).unwrap().solid;
        let convex = solid.check_convex().unwrap();
        for _ in 0..40 {
            // Small directions hit sides and edges at right angles: ties.
            let d: [i64; 3] = std::array::from_fn(|_| random.below(5) as i64 - 2);
            let expected = by_whole_numbers(&solid, d);
            let d = d.map(|x| x as f64);
            assert_eq!(convex.support_by_search(direction(d)), expected, "seed {seed} {d:?}");
            check_all_hints(&convex, d, expected);
            let far = |v: VertexId| (0..3).map(|i| d[i] * solid.point(v)[i]).sum::<f64>();
            ties += usize::from(solid.vertices().filter(|&v| far(v) == far(expected)).count() > 1);
        }
    }
    assert!(ties > 200, "{ties}");
}

/// On a plateau of equally far vertices the page's `dot >= best + EPSILON` stops at once, wherever it is.
#[test]
fn no_plateau_stops_the_climb() {
    let solid = cut_cube(6);
    let convex = solid.check_convex().unwrap();
    for d in [[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, -1, 0], [1, 1, 0], [0, 0, 0], [1, 1, 1], [-1, 0, 1]] {
        check_all_hints(&convex, d.map(|x| x as f64), by_whole_numbers(&solid, d));
    }
    // A direction so close to an axis that all products round to the same number.
    check_all_hints(&convex, [1e-30, -1e-30, 1.0], by_whole_numbers(&solid, [1, -1, 1_000_000]));
}

#[test]
fn climbing_and_searching_agree_on_round_solids_and_a_hint_saves_steps() {
    let mut random = Random(3);
    let solid = round_solid(&mut random, 3000);
    let convex = solid.check_convex().unwrap();
    let mut last = VertexId::new(0);
    let (mut cold, mut warm) = (0, 0);
    for i in 0..200 {
        let angle = f64::from(i) * 0.01;
        let d = [angle.cos(), angle.sin(), 0.3];
        let expected = convex.support_by_search(direction(d));
        cold += convex.climb(direction(d), VertexId::new(5)).len();
        warm += convex.climb(direction(d), last).len();
        last = convex.support_from(direction(d), last);
        assert_eq!(last, expected, "{d:?}");
    }
    assert!(warm * 4 < cold, "{warm} {cold}");
    assert_eq!(
        convex.support_from(direction([1.0, 0.0, 0.0]), VertexId::new(1 << 30)),
        convex.support(direction([1.0, 0.0, 0.0]))
    );
    assert!(Direction::try_from([f64::NAN, 0.0, 0.0]).is_err());
}

/// Prepared, a question is a few steps wherever it points; the plain climb is tens of them.
#[test]
fn a_prepared_solid_is_near_every_answer() {
    let mut random = Random(11);
    let solid = round_solid(&mut random, 4000);
    let convex = solid.check_convex().unwrap();
    let map = convex.support_map();
    let (mut plain, mut steps, mut longest) = (0, 0, 0);
    for i in 0..600 {
        let d: [f64; 3] = std::array::from_fn(|_| random.below(2001) as f64 - 1000.0);
        // The directions on the seams of the cells, too.
        let d = if i % 3 == 0 { d.map(|x| if x < 0.0 { -1.0 } else { 1.0 }) } else { d };
        let path = map.climb(direction(d));
        assert_eq!(path.last(), Some(&convex.support(direction(d))), "{d:?}");
        assert_eq!(map.support(direction(d)), convex.support_by_search(direction(d)), "{d:?}");
        plain += convex.climb(direction(d), VertexId::new(0)).len();
        steps += path.len();
        longest = longest.max(path.len());
    }
    assert!(plain > 600 * 15 && steps < 600 * 6 && longest < 20, "{plain} {steps} {longest}");
    let (v, e) = (solid.vertex_count(), solid.edge_count());
    assert!(map.memory() <= 37 * v + 8 * e + 64, "{} bytes for {v} vertices and {e} edges", map.memory());
    assert_eq!(
        map.support_from(direction([0.0, 0.0, 1.0]), VertexId::new(1 << 30)),
        convex.support(direction([0.0, 0.0, 1.0]))
    );
}

/// Pentagons that are flat only up to rounding: the exact maximum may lie across one.
#[test]
fn rounded_faces_hide_no_vertex() {
    let solid = Polyhedron::platonic(Platonic::Dodecahedron);
    assert!(solid.faces().any(|f| !solid.is_flat(f)), "some face is bent by rounding");
    let convex = solid.check_convex().unwrap();
    for f in solid.faces() {
        let d = solid.area_vector(f);
        let expected = convex.support_by_search(direction(d));
        check_all_hints(&convex, d, expected);
    }
}

#[test]
fn what_is_not_convex_is_refused_by_name() {
    let named = |solid: &Polyhedron| solid.check_convex().unwrap_err();
    assert_eq!(named(&Polyhedron::new()), NotConvex::Empty);
    assert!(matches!(named(&torus(5, 4)), NotConvex::Handles { handles: 1 }));
    assert!(
        matches!(named(&prism(&L, 1.0)), NotConvex::ReflexCorner { face, vertex, .. } if face == FaceId::new(0) && vertex == v(3))
    );
    let mut open = Polyhedron::platonic(Platonic::Cube);
    let mut two = open.clone();
    open.remove_face(FaceId::new(0)).unwrap();
    assert!(matches!(named(&open), NotConvex::Open { .. }));
    let lonely = two.add_vertex([9.0; 3]).unwrap();
    assert_eq!(named(&two), NotConvex::Pieces { vertex: v(0), other: lonely });
    // An octahedron with its top pushed below its middle, by as little as can be.
    let faces =
        polygons(&[&[0, 2, 4], &[2, 1, 4], &[1, 3, 4], &[3, 0, 4], &[2, 0, 5], &[1, 2, 5], &[3, 1, 5], &[0, 3, 5]]);
    let pushed = |z: f64| {
        let points =
            vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, z], [0.0, 0.0, -1.0]];
        Polyhedron::from_polygons(points, &faces).unwrap()
    };
    assert!(pushed(1e-40).check_convex().is_ok() && pushed(0.0).check_convex().is_ok());
    let NotConvex::ReflexEdge { edge, from, to, faces } = named(&pushed(-1e-40)) else { panic!("not an edge") };
    let solid = pushed(-1e-40);
    assert!([from, to].contains(&v(4)) && solid.find_half_edge(from, to).unwrap().edge() == edge);
    assert_eq!(edge.half_edges().map(|h| solid.face(h)), faces);
    // A disc with two sides is folded at each edge.
    let disc = Polyhedron::from_polygons(
        vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        &polygons(&[&[0, 1, 2], &[0, 2, 1]]),
    );
    assert!(matches!(named(&disc.unwrap()), NotConvex::ReflexEdge { .. }));
    let flat =
        Polyhedron::from_polygons(vec![[0.0; 3]; 4], &polygons(&[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]]));
    assert!(matches!(named(&flat.unwrap()), NotConvex::NoArea { .. }));
}

/// A roof whose left half is bent: it is convex along the ridge for one corner of that half and not for the other.
#[test]
fn each_corner_of_a_bent_face_has_a_say() {
    let roof = |height: f64| {
        let points = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, -0.125],
            [0.0, 1.0, height],
            [0.0, -1.0, -0.125],
            [1.0, -1.0, -0.125],
            [0.0, 0.0, -1.0],
            [0.0, -1.0, -1.0],
            [1.0, -1.0, -1.0],
            [1.0, 1.0, -1.0],
            [0.0, 1.0, -1.0],
        ];
        let faces = polygons(&[
            &[0, 1, 2, 3],
            &[1, 0, 4, 5],
            &[5, 4, 7, 8],
            &[1, 5, 8, 9, 2],
            &[2, 9, 10, 3],
            &[4, 0, 6],
            &[0, 3, 10, 6],
            &[4, 6, 7],
            &[7, 6, 10, 9, 8],
        ]);
        Polyhedron::from_polygons(points, &faces).unwrap()
    };
    assert!(roof(-0.125).check_convex().is_ok(), "{:?}", roof(-0.125).check_convex());
    assert!(roof(0.0625).check_convex().is_ok(), "{:?}", roof(0.0625).check_convex());
    let solid = roof(0.25);
    let ridge = solid.find_half_edge(v(0), v(1)).unwrap().edge();
    assert!(matches!(solid.check_convex(), Err(NotConvex::ReflexEdge { edge, .. }) if edge == ridge));
}
