//! The traps of the trade: each was fallen into by somebody.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use dcel_kit::navmesh::{Location, NavMesh, NavMeshError, PathAlgorithm, Planner, QueryPointError, RouteError};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, VertexId};

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

fn polygons(points: &[(f64, f64)], faces: &[&[u32]]) -> Subdivision {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    Subdivision::from_polygons(points.iter().map(|&p| p.into()).collect(), &list).expect("faces that fit")
}

/// The start lies inside the first portal: left and right of it are opposite, which is no junction.
#[test]
fn the_funnel_starts_inside_the_first_portal() {
    // Squares in a row, and a last one above: the way turns left at v6.
    let s = polygons(
        &[(0., 0.), (2., 0.), (4., 0.), (0., 2.), (2., 2.), (4., 2.), (2., 4.), (4., 4.)],
        &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[4, 5, 7, 6]],
    );
    let mesh = NavMesh::new(&s).expect("squares");
    let mut planner = Planner::new();
    // On the portal between the first two squares, in the first one; and on the line of the second portal, at its end.
    for (start, goal, expected) in [
        (at(2., 1.), at(3., 3.), 5f64.sqrt()),
        (at(2., 0.), at(2., 4.), 4.0),
        (at(2., 2.), at(4., 4.), 8f64.sqrt()),
        (at(0., 2.), at(4., 2.), 4.0),
        (at(0., 2.), at(2., 4.), 4.0),
    ] {
        for algorithm in PathAlgorithm::ALL {
            for face in mesh.faces().filter(|&f| mesh.place_in(f, start).is_ok()) {
                let [from, to] = [mesh.place_in(face, start), mesh.place(goal)].map(|place| place.expect("free"));
                let route = planner.route(&mesh, algorithm, &from, &to).expect("one component");
                assert!(is_close(route.length, expected), "{algorithm} {start} -> {goal} in {face}: {}", route.length);
            }
        }
    }
}

/// A wall that is straight but for the last place of a coordinate turns a way all the same.
#[test]
fn a_corner_of_one_last_place_is_a_turn() {
    let low = 1.0f64.next_down();
    // Below y = 1 everything is blocked; v1 stands out of the line v0 -> v2, or lies below it, by a last place.
    for (top, is_turn) in [(1.0f64, true), (low.next_down(), false)] {
        let s = polygons(&[(0., low), (2., top), (4., low), (4., 3.), (0., 3.)], &[&[0, 1, 3, 4], &[1, 2, 3]]);
        let mesh = NavMesh::new(&s).expect("convex but for v1");
        let mut planner = Planner::new();
        let route =
            planner.route_between(&mesh, PathAlgorithm::Exact, at(0., low), at(4., low)).expect("one component");
        assert_eq!(route.corners.contains(&VertexId::new(1)), is_turn, "{route:?}");
    }
}

/// Two holes touch in a vertex: nobody squeezes through, and who stands there says in which wedge.
#[test]
fn a_double_corner_has_two_wedges() {
    // A ring of faces round two holes that touch in v4.
    let map = [".....", ".#...", "..#..", "....."];
    let s = cells(&map);
    let mesh = NavMesh::new(&s).expect("squares");
    let corner = at(2., -2.);
    let Location::Vertex(v) = mesh.locate(corner) else { panic!("{corner} is no vertex") };
    assert_eq!(mesh.wedges(v).len(), 2);
    let QueryPointError::Ambiguous { faces, .. } = mesh.place(corner).expect_err("two wedges") else {
        panic!("ambiguous")
    };
    assert_eq!(faces.len(), 2);
    let mut planner = Planner::new();
    // Past the corner: (2.5, -1.5) and (1.5, -2.5) see each other but for it.
    let [a, b] = [at(2.5, -1.5), at(1.5, -2.5)];
    let route = planner.route_between(&mesh, PathAlgorithm::Exact, a, b).expect("round one of the holes");
    assert!(route.length > 2.0, "squeezed through: {:?}", route.points);
    assert!(!route.corners.contains(&v), "{:?}", route.points);
    // From the corner itself: in the wedge of each face, and every face of the wedge is a start.
    for (face, near, far) in [(faces[0], a, b), (faces[1], a, b)] {
        let place = mesh.place_in(face, corner).expect("a corner of the face");
        let all = mesh.faces_at(&place);
        assert!(all.contains(&face) && mesh.wedges(v).contains(&all), "{all:?}");
        let [to_a, to_b] = [near, far].map(|p| {
            planner
                .route(&mesh, PathAlgorithm::Exact, &place, &mesh.place(p).expect("free"))
                .expect("one component")
                .length
        });
        let step = 0.5f64.hypot(0.5);
        let short = to_a.min(to_b);
        assert!(is_close(short, step), "{face}: {to_a} and {to_b}");
        assert!(to_a.max(to_b) > 2.0, "{face}: squeezed through, {to_a} and {to_b}");
    }
    // Between points the wedge is that of the shortest path.
    for p in [a, b] {
        let route = planner.route_between(&mesh, PathAlgorithm::Exact, corner, p).expect("from one of the wedges");
        assert!(is_close(route.length, 0.5f64.hypot(0.5)), "{:?}", route.points);
    }
}

/// A way may come back to the corner it starts from, in another wedge, and bend there.
///
/// ```text
///    ┌───┬───┐
///    │ g │   │      Walls above and right of the lower left square s, which meet in v: from there the way to g leads
///    ├═══v   │      down to the end of the one wall, round it, up to v again and along the other.
///    │ s ║   │
///    │   u   │
///    └───┴───┘
/// ```
#[test]
fn a_way_bends_at_its_own_start_in_another_wedge() {
    // With u straight below v the path goes back on the line on which it came.
    for x in [1.0, 1.25, 0.75] {
        let corner = |i: u32| (if i == 7 { x } else { f64::from(i % 3) }, -f64::from(i / 3));
        let squares = [0u32, 1, 3, 4, 6, 7].map(|i| [i + 3, i + 4, i + 1, i]);
        let points: Vec<(f64, f64)> = (0..12).map(corner).collect();
        let mut mesh = NavMesh::new(&polygons(&points, &squares.each_ref().map(|square| &square[..]))).expect("convex");
        let [v, u, end] = [at(1., -1.), at(x, -2.), at(0.25, -0.75)];
        let below = mesh.place(at(0.5, -1.5)).expect("free").face;
        let at_v = mesh.sides(below).filter(|side| [side.from, side.to].map(|v| mesh.point(v)).contains(&v));
        for side in at_v.collect::<Vec<_>>() {
            assert_eq!(mesh.set_wall(below, side.half_edge.edge(), true), Some(false));
        }
        for (ready, mut planner) in [(false, Planner::face_by_face()), (true, Planner::new())] {
            let [from, to] = [mesh.place_in(below, v), mesh.place(end)].map(|place| place.expect("free"));
            for algorithm in PathAlgorithm::ALL {
                let context = format!("{algorithm}, u at {x}, prepared: {ready}");
                let way = planner.route(&mesh, algorithm, &from, &to).expect("one component");
                assert_eq!(way.points, [v, u, v, end], "{context}");
                assert_eq!(way.corners.len(), 2, "{context}");
                let back = planner.route(&mesh, algorithm, &to, &from).expect("one component");
                assert_eq!(back.points, [end, v, u, v], "{context}");
            }
        }
    }
}

/// From one side of a wall without area to the other, at the same point, the path goes to its end and back.
#[test]
fn a_way_goes_round_a_wall_without_area_and_back_on_the_same_line() {
    let mut mesh = NavMesh::new(&cells(&["....", "...."])).expect("squares");
    // A wall along the middle line, from the left side to x = 3.
    for x in 0..3 {
        let above = mesh.place(at(f64::from(x) + 0.5, -0.5)).expect("free").face;
        let below = mesh.place(at(f64::from(x) + 0.5, -1.5)).expect("free").face;
        let wall = mesh.sides(above).find(|side| side.across == below).expect("neighbours");
        assert_eq!(mesh.set_wall(above, wall.half_edge.edge(), true), Some(false));
    }
    let face = |p| mesh.place(p).expect("free").face;
    let [above, below] = [face(at(0.5, -0.5)), face(at(0.5, -1.5))];
    for (ready, mut planner) in [(false, Planner::face_by_face()), (true, Planner::new())] {
        for (x, back) in [(0.0, 0.0), (0.25, 0.25), (1.0, 0.5), (0.5, 1.0)] {
            let [from, to] = [(above, x), (below, back)].map(|(f, x)| mesh.place_in(f, at(x, -1.0)).expect("its side"));
            for algorithm in PathAlgorithm::ALL {
                let context = format!("{algorithm}, from {x} to {back}, prepared: {ready}");
                let way = planner.route(&mesh, algorithm, &from, &to).expect("one component");
                assert_eq!(way.points, [at(x, -1.0), at(3.0, -1.0), at(back, -1.0)], "{context}");
                assert!(is_close(way.length, 6.0 - x - back), "{context}: {}", way.length);
            }
        }
    }
}

/// Round the end of a wall and back on the same line, through portals that lie on it: the wall is not walked through.
#[test]
fn a_way_turns_back_on_its_own_line() {
    let mut mesh = NavMesh::new(&cells(&["..", "..", ".."])).expect("squares");
    let [here, there] = [at(0.5, -1.5), at(1.5, -1.5)].map(|p| mesh.place(p).expect("free").face);
    let corner = at(1., -1.);
    let walls = mesh.sides(here).filter(|side| [side.from, side.to].map(|v| mesh.point(v)).contains(&corner));
    for side in walls.collect::<Vec<_>>() {
        assert_eq!(mesh.set_wall(here, side.half_edge.edge(), true), Some(false));
    }
    for (merged, mut planner) in [(false, Planner::face_by_face()), (true, Planner::new())] {
        // On both sides of the wall, and from its upper end on one to behind that end.
        let ends = [(here, at(1., -1.25), there, at(1., -1.5), 1.25), (here, corner, there, corner, 2.0)];
        for (from, start, to, goal, length) in ends {
            let [from, to] =
                [mesh.place_in(from, start), mesh.place_in(to, goal)].map(|place| place.expect("on the wall"));
            for algorithm in PathAlgorithm::ALL {
                for (from, to) in [(&from, &to), (&to, &from)] {
                    let way = planner.route(&mesh, algorithm, from, to).expect("one component");
                    assert_eq!(way.points, [from.point, at(1., -2.), to.point], "{algorithm}, merged: {merged}");
                    assert!(is_close(way.length, length), "{algorithm}: {}", way.length);
                }
            }
        }
    }
}

/// Squares for the dots of a picture, y down in it.
fn cells(rows: &[&str]) -> Subdivision {
    let width = rows[0].len() as u32;
    let points = (0..=rows.len() as u32).flat_map(|y| (0..=width).map(move |x| at(f64::from(x), -f64::from(y))));
    let mut list = PolygonList::new();
    for (y, row) in (0u32..).zip(rows) {
        for (x, cell) in (0u32..).zip(row.chars()) {
            let corner = |dx: u32, dy: u32| (y + dy) * (width + 1) + x + dx;
            if cell == '.' {
                list.push_face(&[corner(0, 1), corner(1, 1), corner(1, 0), corner(0, 0)]);
            }
        }
    }
    Subdivision::from_polygons(points.collect(), &list).expect("cells")
}

/// Faces that were merged have corners in the middle of straight sides: they stay convex, and portals on one line too.
#[test]
fn straight_corners_are_no_concave_ones() {
    let s = polygons(
        &[(0., 0.), (6., 0.), (6., 2.), (4., 2.), (2., 2.), (0., 2.), (2., 4.), (4., 4.), (6., 4.), (0., 4.)],
        &[&[0, 1, 2, 3, 4, 5], &[5, 4, 6, 9], &[3, 2, 8, 7]],
    );
    let mesh = NavMesh::new(&s).expect("convex with straight corners");
    assert_eq!(mesh.locate(at(2., 2.)), Location::Vertex(VertexId::new(4)));
    assert!(matches!(mesh.locate(at(3., 2.)), Location::Edge(_)));
    assert!(matches!(mesh.locate(at(3., 2.5)), Location::Outer));
    let mut planner = Planner::new();
    for (start, goal, expected) in [
        (at(1., 3.), at(5., 3.), 2.0 + 2.0 * 2f64.sqrt()),
        (at(0., 2.), at(6., 2.), 6.0),
        (at(2., 3.), at(4., 3.), 4.0),
        (at(3., 2.), at(1., 4.), 1.0 + 5f64.sqrt()),
    ] {
        let route = planner.route_between(&mesh, PathAlgorithm::Exact, start, goal).expect("one component");
        assert!(is_close(route.length, expected), "{start} -> {goal}: {}", route.length);
        let back = planner.route_between(&mesh, PathAlgorithm::Exact, goal, start).expect("one component");
        assert!(is_close(back.length, expected), "{goal} -> {start}: {}", back.length);
    }
}

/// A side seen edge-on: the path runs along a wall, in line with a portal behind it, and bends where the portal begins.
///
/// ```text
///    8 ───── 3 ───────────── 4           The wall ends in v6; the portal v6 - v5 to the lowest face lies on its line.
///    │       │               │
///    0 ───── 2 ═══════ 6 ┄┄┄ 5           Ways from the left, straight or round v2, and from the wall itself.
///    │       ║         │     │
///    9 ───── 1        10 ─── 7
/// ```
#[test]
fn a_side_seen_edge_on_is_passed_at_its_nearer_end() {
    let points: [(f64, f64); 11] = [
        (0., 0.),
        (2., -2.),
        (2., 0.),
        (2., 2.),
        (7., 2.),
        (7., 0.),
        (4., 0.),
        (7., -2.),
        (0., 2.),
        (0., -2.),
        (4., -2.),
    ];
    // Left of the first portal one face, or two: then the first ray runs through the endpoint, not from a corner of its face.
    let left: [&[&[u32]]; 2] = [&[&[9, 1, 2, 3, 8]], &[&[9, 1, 2, 0], &[0, 2, 3, 8]]];
    let right: [&[u32]; 2] = [&[2, 6, 5, 4, 3], &[10, 7, 5, 6]];
    for (left, symmetry) in left.into_iter().flat_map(|left| (0..8).map(move |symmetry| (left, symmetry))) {
        let moved = |(x, y): (f64, f64)| {
            let (x, y) = (if symmetry & 1 == 0 { x } else { -x }, if symmetry & 2 == 0 { y } else { -y });
            if symmetry & 4 == 0 { (x, y) } else { (y, x) }
        };
        let mirrored = (symmetry & 1) + (symmetry >> 1 & 1) + (symmetry >> 2 & 1) == 1 || symmetry == 7;
        let mut faces: Vec<Vec<u32>> = left.iter().chain(&right).map(|face| face.to_vec()).collect();
        if mirrored {
            faces.iter_mut().for_each(|face| face.reverse());
        }
        let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
        let mesh = NavMesh::new(&polygons(&points.map(moved), &faces)).expect("convex with straight corners");
        let mut planner = Planner::new();
        let goal = (4.5, -1.5);
        let last = 0.5f64.hypot(1.5);
        for (start, expected) in [
            ((0., 0.), 4.0 + last),
            ((1., 0.), 3.0 + last),
            ((2., 0.), 2.0 + last),
            ((3., 0.), 1.0 + last),
            ((4., 0.), last),
            ((1., -1.), 2f64.sqrt() + 2.0 + last),
            ((2., -1.), 1.0 + 2.0 + last),
        ] {
            let [from, to] = [start, goal].map(|p| Point::from(moved(p)));
            for [a, b] in [[from, to], [to, from]] {
                let route = planner.route_between(&mesh, PathAlgorithm::Exact, a, b).expect("one component");
                let way = &route.points;
                assert!(is_close(route.length, expected), "{symmetry}: {a} -> {b}: {} by {way:?}", route.length);
            }
        }
    }
}

/// Of the wedges at a vertex one at most is more than half a turn: at a double corner ways bend in that one only, and
/// one length a vertex is enough to know the shortest path there.
#[test]
fn a_way_bends_in_one_wedge_of_a_double_corner() {
    let mut bends = 0;
    for seed in 0..60 {
        let map = Map::random(seed, 6, 0.9, [0.0, 0.6][seed as usize % 2]);
        let (mut mesh, mut random) = (map.mesh(), Random::new(seed));
        for t in 0..map.triangles.len() {
            if random.unit() < 0.3 {
                mesh.block(FaceId::new(t as u32 + 1));
            }
        }
        let turns = |v: VertexId, wedge: &[FaceId]| -> f64 {
            let here = mesh.point(v);
            let direction = |w: VertexId| (mesh.point(w).y - here.y).atan2(mesh.point(w).x - here.x);
            let angle = |&f: &FaceId| {
                let from = mesh.sides(f).find(|side| side.from == v).expect("a corner").to;
                let to = mesh.sides(f).find(|side| side.to == v).expect("a corner").from;
                (direction(to) - direction(from)).rem_euclid(std::f64::consts::TAU)
            };
            wedge.iter().map(angle).sum()
        };
        let mut planner = Planner::new();
        for v in (0..map.points.len() as u32).map(VertexId::new) {
            let wedges = mesh.wedges(v);
            if wedges.len() < 2 {
                continue;
            }
            let wide: Vec<&Vec<FaceId>> =
                wedges.iter().filter(|wedge| turns(v, wedge) > std::f64::consts::PI + 1e-9).collect();
            assert!(wide.len() <= 1, "seed {seed}: {v}");
            // From the first face of the wide wedge to its last: straight to the vertex, and on.
            let Some([first, .., last]) = wide.first().map(|wedge| wedge.as_slice()) else { continue };
            let [a, b] = [first, last].map(|f| map.inside(f.index() - 1, &mut random));
            let [from, to] = [(first, a), (last, b)].map(|(&f, p)| mesh.place_in(f, p).expect("inside"));
            let route = planner.route(&mesh, PathAlgorithm::Exact, &from, &to).expect("one wedge");
            bends += usize::from(route.corners == [v]);
        }
    }
    assert!(bends > 10, "only {bends} ways bend at a double corner");
}

/// What is no navmesh is refused by name.
#[test]
fn concave_faces_rings_and_empty_maps_are_refused() {
    let concave = polygons(&[(0., 0.), (4., 0.), (1., 1.), (0., 4.)], &[&[0, 1, 2, 3]]);
    let expected = NavMeshError::Concave { face: FaceId::new(1), corner: VertexId::new(2) };
    assert_eq!(NavMesh::new(&concave).expect_err("concave"), expected);
    let mut ring = Subdivision::lab_rectangle();
    assert!(NavMesh::new(&ring).is_ok());
    ring.insert_vertex(at(10., 20.)).expect("inside");
    assert_eq!(NavMesh::new(&ring).expect_err("a ring"), NavMeshError::Rings { face: FaceId::new(1), rings: 1 });
    let mut spur = Subdivision::lab_rectangle();
    spur.insert_dangling_edge(VertexId::new(0), at(0., 0.)).expect("inside");
    assert!(matches!(NavMesh::new(&spur), Err(NavMeshError::Concave { .. })));
    let mut hole = Subdivision::lab_rectangle();
    hole.set_hole(FaceId::new(1), true);
    assert_eq!(NavMesh::new(&hole).expect_err("only a hole"), NavMeshError::NoFaces);
}

/// "No way" names the two components.
#[test]
fn apart_is_proved_by_two_components() {
    let mesh = NavMesh::new(&cells(&["..#..", "..#.."])).expect("squares");
    let error =
        Planner::new().route_between(&mesh, PathAlgorithm::Exact, at(0.5, -0.5), at(4.5, -0.5)).expect_err("apart");
    let RouteError::Unreachable { from, to, start, goal } = error else { panic!("{error}") };
    assert_ne!(start, goal);
    assert_eq!((mesh.component(from), mesh.component(to)), (Some(start), Some(goal)));
    let near = mesh.nearest_reachable(start, at(4.5, -0.5)).expect("some face");
    assert_eq!((near.place.point, near.distance), (at(2., -0.5), 2.5));
}

/// Start and goal at the same place, at corners, on the border.
#[test]
fn ends_on_vertices_and_edges_are_ends_like_others() {
    let map = Map::random(5, 4, 1.0, 0.0);
    let mesh = map.mesh();
    let mut planner = Planner::new();
    for (a, b) in
        [((0., 0.), (4., 4.)), ((0., 0.), (0., 0.)), ((1., 1.), (3., 1.)), ((0.5, 0.), (4., 3.5)), ((2., 2.), (2., 4.))]
    {
        let (a, b) = (Point::from(a), Point::from(b));
        for algorithm in PathAlgorithm::ALL {
            let route = planner.route_between(&mesh, algorithm, a, b).expect("one component");
            let straight = (b.x - a.x).hypot(b.y - a.y);
            let good = if algorithm == PathAlgorithm::Exact {
                is_close(route.length, straight)
            } else {
                route.length >= straight * (1. - 1e-9)
            };
            assert!(good, "{algorithm}: {a} -> {b}: {}", route.length);
        }
    }
}
