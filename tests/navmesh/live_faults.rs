//! Walls and obstacles on a hall of 20 by 20 that once went wrong, by name.

use dcel_kit::navmesh::{LiveMesh, PathAlgorithm, Planner};
use dcel_kit::plane::predicates::twice_area;
use dcel_kit::plane::{Point, Subdivision};

type Corners<'a> = &'a [(f64, f64)];

/// A hall with these put in, in this order.
fn hall(given: &[Corners]) -> LiveMesh {
    let corners = [(0., 0.), (20., 0.), (20., 20.), (0., 20.)].map(Point::from);
    let mut live = LiveMesh::new(Subdivision::polygon(&corners).expect("a hall")).expect("convex");
    for corners in given {
        let points: Vec<Point> = corners.iter().map(|&p| p.into()).collect();
        let put = match points[..] {
            [p, q] => live.insert_wall(p, q),
            _ => live.insert_obstacle(&points),
        };
        put.unwrap_or_else(|error| panic!("{corners:?} is refused: {error}"));
    }
    live
}

/// The area of all faces, and of those where one may stand.
fn areas(live: &LiveMesh) -> [f64; 2] {
    let mesh = live.mesh();
    let mut areas = [0.0; 2];
    for f in mesh.faces() {
        let corners: Vec<Point> = mesh.corners(f).map(|v| mesh.point(v)).collect();
        let area: f64 = (2..corners.len()).map(|i| twice_area(corners[0], corners[i - 1], corners[i]) / 2.0).sum();
        areas[0] += area;
        areas[1] += if mesh.is_walkable(f) { area } else { 0.0 };
    }
    areas
}

fn assert_areas(live: &LiveMesh, blocked: f64, context: &str) {
    let [all, free] = areas(live);
    assert!((all - 400.0).abs() < 1e-9, "{context}: the hall has area {all}");
    assert!((400.0 - blocked - free).abs() < 1e-9, "{context}: area {free} is free, {blocked} is covered");
}

/// The number of a cut that has gone is that of a piece of the border by now: a corner on that cut is not on the border.
#[test]
fn walls_that_never_meet_leave_the_floor_whole() {
    let sets: [&[Corners]; 2] = [
        &[&[(0., 1.), (6., 3.)], &[(1., 0.), (2., 1.)]],
        &[&[(14., 6.), (20., 3.)], &[(2., 11.), (16., 15.)], &[(20., 7.), (17., 13.)]],
    ];
    for set in sets {
        assert_areas(&hall(set), 0.0, &format!("{set:?}"));
        let reversed: Vec<Corners> = set.iter().rev().copied().collect();
        assert_areas(&hall(&reversed), 0.0, &format!("{reversed:?}"));
    }
    assert!(hall(sets[0]).mesh().place(Point::new(1.9, 0.1)).is_ok());
    assert!(hall(sets[1]).mesh().place(Point::new(19., 12.)).is_ok());
}

#[test]
fn obstacles_that_touch_and_cross_block_what_is_inside_and_nothing_else() {
    let touching = hall(&[&[(1., 3.), (3., 3.), (1., 4.)], &[(3., 3.), (2., 3.), (2., 2.)]]);
    assert_areas(&touching, 1.5, "a corner on a side");
    let [start, goal] = [(15., 15.), (0.5, 0.2)].map(Point::from);
    let route = Planner::new().route_between(touching.mesh(), PathAlgorithm::Exact, start, goal).expect("free");
    assert!((route.length - 14.5f64.hypot(14.8)).abs() < 1e-9, "{}", route.length);
    assert_eq!(touching.mesh().component_count(), 1);
    let crossing = hall(&[&[(8., 8.), (6., 5.), (9., 7.)], &[(6., 10.), (8., 2.), (7., 7.)]]);
    assert!(crossing.mesh().place(Point::new(15., 15.)).is_ok());
    for reversed in [false, true] {
        let mut set: [Corners; 2] = [&[(2., 2.), (4., 2.), (2., 3.)], &[(4., 3.), (0., 4.), (2., 1.)]];
        if reversed {
            set.reverse();
        }
        let corner = hall(&set);
        assert!((areas(&corner)[0] - 400.0).abs() < 1e-9, "{set:?}");
        assert!(corner.mesh().place(Point::new(0.04, 0.33)).is_ok(), "{set:?}");
    }
}

/// A side that is bent where it is crossed no longer runs through the corner that lay on it.
#[test]
fn a_corner_on_a_side_that_rounding_has_bent_is_not_refused() {
    let mut live = hall(&[&[(5., 1.), (7., 9.), (6., 8.)], &[(4., 0.), (6., 3.), (6., 5.)]]);
    assert!((areas(&live)[0] - 400.0).abs() < 1e-9);
    assert_eq!(live.map().geometry_violations(), []);
    live.obstacles().into_iter().for_each(|id| live.remove(id).expect("in the map"));
    assert_eq!((live.map().vertex_count(), live.map().edge_count(), live.map().face_count()), (4, 4, 2));
    assert_areas(&live, 0.0, "all out again");
    // The end of the last wall is a last place away from where three lines meet.
    hall(&[&[(11., 17.), (0., 16.), (3., 5.)], &[(-2., 9.), (18., 16.)], &[(5., 20.), (8., 12.5)]]);
}

/// Of a triangle whose corners are on one line but for rounding nothing is inside.
#[test]
fn an_obstacle_without_room_blocks_nothing() {
    assert_areas(&hall(&[&[(7.6, 12.), (8.1, 6.), (7.7, 10.8)]]), 0.0, "no room");
}

/// A wall along a border that rounding has bent: a cut may lie where the border runs straight again, and makes room for it.
#[test]
fn a_border_along_which_a_wall_stood_is_straight_again_when_all_is_out() {
    let points = [
        (0.7973680207474412, 7.57391604386326),
        (4.618713977249865, 8.75599687050862),
        (-0.08919259923657741, 10.439925511240078),
        (3.7321533572658465, 11.622006337885436),
        (6.598162824642664, 12.508566957869455),
    ]
    .map(Point::from);
    let map =
        Subdivision::from_triangles(points.to_vec(), &[[0, 1, 2], [1, 3, 2], [1, 4, 3]]).expect("three triangles");
    let along = [(4.687489846391452, 11.917526544546776), (1.821480379014634, 11.030965924562757)].map(Point::from);
    let across = [(-0.8865606199840186, 2.866009467376818), (6.598162824642664, 12.508566957869455)].map(Point::from);
    for order in [[0, 1], [1, 0]] {
        let mut live = LiveMesh::new(map.clone()).expect("convex");
        let walls = [along, across].map(|[p, q]| live.insert_wall(p, q).expect("a wall"));
        for i in order {
            live.remove(walls[i]).expect("it stands");
        }
        let (now, first) = (live.map(), &map);
        assert!(now.vertices().eq(first.vertices()), "{order:?}: {:?}", now.vertices().collect::<Vec<_>>());
        assert!(now.vertices().all(|v| now.point(v) == first.point(v)), "{order:?}");
        assert!(now.faces().eq(first.faces()), "{order:?}: {:?}", now.faces().collect::<Vec<_>>());
        assert!(now.edges().eq(first.edges()), "{order:?}: {:?}", now.edges().collect::<Vec<_>>());
        for h in first.edges().flat_map(dcel_kit::EdgeId::half_edges) {
            let of = |map: &Subdivision| (map.origin(h), map.next(h), map.face(h));
            assert_eq!(of(now), of(first), "{order:?}: {h}");
        }
    }
}

/// The end of the third wall lies beside a cut that runs along the second one, within the room that rounding leaves: whatever
/// the order, that wall is led through it, and nothing slips between them.
#[test]
fn an_end_is_put_on_a_line_behind_a_cut() {
    let at = |(x, y): (f64, f64)| Point::new(x * 0.1 + 1e6, y * 0.1 + 1e6);
    let points = [(16., 9.), (16., 16.), (9., 18.), (24., 11.), (24., 16.), (0., 19.), (9., 24.), (18., 24.)].map(at);
    let triangles = [[0, 1, 2], [0, 3, 1], [3, 4, 1], [5, 2, 6], [2, 1, 7], [2, 7, 6]];
    let map = Subdivision::from_triangles(points.to_vec(), &triangles).expect("a floor");
    let walls = [[(11., 16.), (14., 8.)], [(8., 22.), (12., 14.)], [(9., 24.), (10., 18.)]];
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let mut live = LiveMesh::new(map.clone()).expect("convex");
        for [p, q] in order.map(|i| walls[i]) {
            live.insert_wall(at(p), at(q)).expect("a wall");
        }
        let [start, goal] = [(22.375, 14.875), (7.3125, 21.8125)].map(at);
        let path = Planner::new().route_between(live.mesh(), PathAlgorithm::Exact, start, goal);
        assert!(path.is_err(), "{order:?}: {:?}", path.map(|path| path.points));
    }
}

/// The number of a vertex that went may be that of one outside of all faces.
#[test]
fn vertices_of_the_map_are_where_the_mesh_says_also_outside_of_its_faces() {
    let mut live = hall(&[]);
    let wall = live.insert_wall(Point::new(12., 4.), Point::new(10., 14.)).expect("a wall");
    live.remove(wall).expect("it stands");
    live.insert_wall(Point::new(16., 8.), Point::new(24., 9.)).expect("a wall");
    let map = live.map();
    assert!(map.vertices().any(|v| map.point(v) == Point::new(24., 9.)));
    for v in map.vertices() {
        assert_eq!(live.mesh().point(v), map.point(v), "{v}");
    }
}

#[test]
fn a_move_that_cannot_be_changes_nothing() {
    let mut live = hall(&[&[(4., 4.), (8., 5.), (6., 9.)], &[(5., 2.), (7., 12.)]]);
    let all = |live: &LiveMesh| {
        let map = live.map();
        let edges: Vec<_> = map.edges().map(|e| (e, e.half_edges().map(|h| map.point(map.origin(h))))).collect();
        (edges, live.obstacles())
    };
    let (before, obstacles) = (all(&live), live.obstacles());
    for vector in [[f64::INFINITY, 0.0], [0.0, f64::NAN], [1e99, 0.0]] {
        for &obstacle in &obstacles {
            assert!(live.move_obstacle(obstacle, vector).is_err(), "{obstacle} by {vector:?}");
            assert_eq!(all(&live), before, "{obstacle} by {vector:?}");
        }
    }
}
