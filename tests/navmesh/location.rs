//! Points are located exactly; what is near is near.

use crate::maps::{Map, Random};
use crate::oracle::{distance, triangles_with};
use dcel_kit::navmesh::{LiveMesh, Location, NavMesh, PathAlgorithm, Planner, QueryPoint, QueryPointError};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::{FaceId, VertexId};

/// Where the point lies, by all triangles and by the parity of what a ray crosses.
fn check(map: &Map, s: &Subdivision, mesh: &NavMesh, p: Point, context: &str) {
    let found = mesh.locate(p);
    assert_eq!(mesh.locate_by_scan(p), found, "{context}: {p}");
    let triangles = triangles_with(map, p);
    match found {
        Location::Vertex(v) => assert_eq!(s.point(v), p, "{context}: {v}"),
        Location::Edge(h) => {
            let [a, b] = [s.origin(h), s.destination(h)].map(|v| s.point(v));
            assert!(orientation(a, b, p).is_eq() && crate::oracle::between(a, p, b), "{context}: {p} on {h}");
            assert!(mesh.has_face(s.face(h)), "{context}: {h} has a hole on its left");
        }
        Location::Face(f) => assert_eq!(triangles, [f.index() - 1], "{context}: {p}"),
        Location::Hole(_) | Location::Outer => {
            assert!(triangles.is_empty(), "{context}: {p} is in {triangles:?}");
            // Of the holes, the one whose cycles a ray to the right crosses an odd number of times.
            let odd = |f: FaceId| {
                let sides = s.cycles(f).flat_map(|h| s.cycle(h));
                let crossed = sides.filter(|&h| {
                    let [a, b] = [s.origin(h), s.destination(h)].map(|v| s.point(v));
                    (a.y > p.y) != (b.y > p.y) && orientation(a, b, p).is_gt() == (b.y > a.y)
                });
                crossed.count() % 2 == 1
            };
            let expected = s.hole_faces().find(|&f| odd(f)).map_or(Location::Outer, Location::Hole);
            assert_eq!(found, expected, "{context}: {p}");
        }
    }
}

#[test]
fn every_point_is_where_a_scan_finds_it() {
    for seed in 0..40 {
        let jitter = [0.0, 0.5][seed as usize % 2];
        let map = Map::random(seed, 3 + seed as usize % 6, 0.6, jitter);
        let (s, mesh) = (map.subdivision(), map.mesh());
        let mut random = Random::new(seed + 1000);
        for _ in 0..60 {
            let p = Point::new(random.unit() * 9.0 - 0.5, random.unit() * 9.0 - 0.5);
            check(&map, &s, &mesh, p, &format!("seed {seed}"));
        }
        for [a, b, c] in (0..map.triangles.len()).map(|t| map.corners(t)) {
            let middle = Point::new((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
            let beside = Point::new(middle.x, middle.y.next_up());
            for p in [a, b, c, middle, beside, Point::new(a.x, a.y.next_down()), Point::new(a.x.next_up(), a.y)] {
                check(&map, &s, &mesh, p, &format!("seed {seed}"));
            }
        }
    }
}

#[test]
fn points_near_sides_and_on_borders_of_cells_are_where_a_scan_finds_them() {
    for seed in 0..24 {
        let jitter = [0.0, 0.5][seed as usize % 2];
        let map = Map::random(seed, 4 + seed as usize % 9, 0.7, jitter);
        let (s, mesh) = (map.subdivision(), map.mesh());
        let mut random = Random::new(seed + 4000);
        // Up to some steps of a lattice of 65,536 beside a side, and a few last places.
        for t in 0..map.triangles.len() {
            let [a, b, _] = map.corners(t);
            let u = random.unit();
            for size in [1e-3, 2e-4, 5e-5, 1e-15] {
                let [dx, dy] = [(); 2].map(|()| (random.unit() - 0.5) * size);
                let p = Point::new(a.x + (b.x - a.x) * u + dx, a.y + (b.y - a.y) * u + dy);
                check(&map, &s, &mesh, p, &format!("seed {seed}, triangle {t}"));
            }
        }
        // Whatever the number of columns and rows: the lines between them, and a last place to both sides.
        let corners = || (0..map.triangles.len()).flat_map(|t| map.corners(t));
        let least = |of: fn(Point) -> f64| corners().map(of).fold(f64::INFINITY, f64::min);
        let [left, right, low, high] = [least(|p| p.x), -least(|p| -p.x), least(|p| p.y), -least(|p| -p.y)];
        for cells in 1..=12 {
            for i in 0..=cells {
                let t = f64::from(i) / f64::from(cells);
                let (x, y) = (left + (right - left) * t, low + (high - low) * random.unit());
                for x in [x.next_down(), x, x.next_up()] {
                    check(&map, &s, &mesh, Point::new(x, y), &format!("seed {seed}"));
                }
                let (x, y) = (left + (right - left) * random.unit(), low + (high - low) * t);
                for y in [y.next_down(), y, y.next_up()] {
                    check(&map, &s, &mesh, Point::new(x, y), &format!("seed {seed}"));
                }
            }
        }
    }
}

#[test]
fn far_away_and_no_number_are_outside() {
    let mesh = Map::random(1, 4, 0.8, 0.3).mesh();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
        for p in [Point::new(bad, 1.0), Point::new(1.0, bad), Point::new(bad, bad)] {
            assert_eq!(mesh.locate(p), Location::Outer, "{p}");
        }
    }
    assert_eq!(mesh.nearest_point(Point::new(f64::NAN, 0.0)), None);
}

#[test]
fn the_nearest_point_is_on_the_mesh_and_none_is_nearer() {
    for seed in 0..30 {
        let map = Map::random(seed, 3 + seed as usize % 5, 0.5, 0.5);
        let mesh = map.mesh();
        let mut random = Random::new(seed + 2000);
        for _ in 0..20 {
            let p = Point::new(random.unit() * 12.0 - 2.0, random.unit() * 12.0 - 2.0);
            let near = mesh.nearest_point(p).expect("some face is free");
            let QueryPoint { point, face, .. } = near.place;
            assert!(mesh.place_in(face, point).is_ok(), "seed {seed}: {p} -> {point} is not in {face}");
            assert!((near.distance - distance(p, point)).abs() <= 1e-12, "seed {seed}: {p}");
            let least = (0..map.triangles.len()).map(|t| distance_to(map.corners(t), p)).fold(f64::INFINITY, f64::min);
            assert!((near.distance - least).abs() <= 1e-12, "seed {seed}: {p}: {} but {least}", near.distance);
        }
    }
}

/// Where a sliver is nearest in which no point near it can be written in doubles, its nearest corner is compared with what
/// else there is.
#[test]
fn the_nearest_point_is_near_beside_a_sliver() {
    let quad = [
        (16.240720315135302, 5.023843513242772),
        (22.928075739014545, 7.092484959872149),
        (20.859434292385167, 13.779840383751392),
        (13.21674237938032, 11.415678730460675),
    ];
    let obstacle = [
        (22.632555532353205, 8.047821448997755),
        (27.409237977981235, 9.525422482304453),
        (26.522677357997217, 12.39143194968127),
        (21.745994912369188, 10.913830916374572),
    ]
    .map(Point::from);
    let mut live = LiveMesh::new(Subdivision::polygon(&quad.map(Point::from)).unwrap()).unwrap();
    live.insert_obstacle(&obstacle).unwrap();
    let near = live.mesh().nearest_point(obstacle[1]).expect("some face is free");
    assert!(near.distance <= distance(obstacle[1], obstacle[0]) + 1e-12, "{near:?}");
    assert!(live.mesh().place_in(near.place.face, near.place.point).is_ok(), "{near:?}");
}

fn distance_to([a, b, c]: [Point; 3], p: Point) -> f64 {
    let inside = [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| orientation(a, b, p).is_ge());
    if inside {
        return 0.0;
    }
    let to_side = |(a, b): (Point, Point)| {
        let d = [b.x - a.x, b.y - a.y];
        let t = ((p.x - a.x) * d[0] + (p.y - a.y) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        let t = t.clamp(0.0, 1.0);
        distance(p, Point::new(a.x + d[0] * t, a.y + d[1] * t))
    };
    [(a, b), (b, c), (c, a)].into_iter().map(to_side).fold(f64::INFINITY, f64::min)
}

/// Walks from face to face, always across a side that has the point on its right, and gives up at a hole.
fn walk(s: &Subdivision, is_hole: impl Fn(FaceId) -> bool, start: FaceId, p: Point) -> Option<FaceId> {
    let mut at = start;
    for _ in 0..1000 {
        let beyond = s.incident_half_edges(at).find(|&h| {
            let [a, b] = [s.origin(h), s.destination(h)].map(|v| s.point(v));
            orientation(a, b, p).is_lt()
        });
        let Some(h) = beyond else { return Some(at) };
        at = s.face(h.twin());
        if is_hole(at) {
            return None;
        }
    }
    None
}

#[test]
fn a_walk_fails_where_holes_are_no_faces_and_not_where_they_are() {
    // A square with a wide hole: from the left to the right a walk runs into it.
    let at = |x, y| Point::new(x, y);
    let corners = [at(0., 0.), at(9., 0.), at(9., 9.), at(0., 9.), at(1., 1.), at(8., 1.), at(8., 8.), at(1., 8.)];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let mut s = Subdivision::from_graph(&corners, &edges).expect("two squares");
    let inner = s.face(dcel_kit::HalfEdgeId::new(8));
    assert_eq!(s.set_hole(inner, true), Some(false));
    s.triangulate(TriangulationMethod::Ears).expect("a ring");
    let mesh = NavMesh::new(&s).expect("triangles");
    let goal = at(8.5, 4.5);
    let starts: Vec<FaceId> = mesh.faces().collect();
    let lost = |s: &Subdivision, hole: &dyn Fn(FaceId) -> bool| {
        starts.iter().filter(|&&f| walk(s, hole, f, goal).is_none()).count()
    };
    let by_holes = lost(&s, &|f| f == s.outer_face() || s.is_hole(f));
    assert!(by_holes > 0, "every walk came through");
    // With the hole cut into faces that are only flagged, every walk arrives.
    let mut whole = s.clone();
    whole.triangulate_all(TriangulationMethod::Ears).expect("a square");
    assert_eq!(lost(&whole, &|f| f == whole.outer_face()), 0);
    // Holes side by side are one hole, named by the first of them.
    let cut = NavMesh::new(&whole).expect("triangles");
    let first = whole.hole_faces().next().expect("the hole");
    assert!(whole.hole_faces().count() > 1);
    for (x, y) in [(2., 4.), (4., 2.), (7., 5.), (5., 7.)] {
        assert_eq!(cut.locate(at(x, y)), Location::Hole(first), "({x}, {y})");
    }
    // The index needs no walk.
    assert!(matches!(mesh.locate(goal), Location::Face(_) | Location::Edge(_)));
    assert!(matches!(mesh.locate(at(4., 5.)), Location::Hole(_)));
}

#[test]
fn places_are_refused_by_name() {
    let map = Map::random(3, 4, 1.0, 0.0);
    let mut mesh = map.mesh();
    assert!(matches!(mesh.place(Point::new(-1., 0.)), Err(QueryPointError::OffMesh { .. })));
    let p = map.inside(0, &mut Random::new(1));
    let place = mesh.place(p).expect("inside the first triangle");
    mesh.block(place.face);
    assert!(matches!(mesh.place(p), Err(QueryPointError::Blocked { .. })));
    assert!(matches!(mesh.place_in(place.face, p), Err(QueryPointError::NotInFace { .. })));
    assert_eq!(mesh.locate(p), Location::Face(place.face), "a blocked face is still a face");
}

/// Of two distances that are the same as doubles the nearer place still wins: by exact fractions, 2^1023 away, too.
#[test]
fn the_nearest_point_to_one_far_away_is_the_right_one() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let mut list = dcel_kit::topology::PolygonList::new();
    // Two rooms of other heights; the right one reaches furthest to the right, the left one furthest up.
    let points = [(0., 0.), (4., 0.), (4., 9.), (0., 9.), (6., 1.), (26., 1.), (26., 7.), (6., 7.)].map(Point::from);
    [[0, 1, 2, 3], [4, 5, 6, 7]].iter().for_each(|face| list.push_face(face));
    let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &list).expect("two rooms")).expect("convex");
    for far in [1e3, 1e9, 1e17, 1e100, 1e155, 1e200, 1e300, f64::MAX] {
        for (p, nearest) in [
            (at(far, 1.5), at(26., 1.5)),
            (at(far, 1.0), at(26., 1.)),
            (at(far, -3.0), at(26., 1.)),
            (at(far, 8.0), at(26., 7.)),
            (at(-far, 8.5), at(0., 8.5)),
            (at(-far, -1.0), at(0., 0.)),
            (at(2.0, far), at(2., 9.)),
            (at(25.0, -far), at(4., 0.)),
            (at(far, far), at(26., 7.)),
            (at(-far, far), at(0., 9.)),
            (at(far, -far), at(26., 1.)),
        ] {
            let near = mesh.nearest_point(p).expect("all is free");
            assert_eq!(near.place.point, nearest, "{p}");
            // Of the exact distance, which has one big part or two.
            let [x, y] = [p.x - nearest.x, p.y - nearest.y].map(|d| d / far);
            let expected = (x * x + y * y).sqrt();
            assert!((near.distance / far / expected - 1.0).abs() < 1e-12 || far >= f64::MAX, "{p}: {}", near.distance);
        }
    }
}

/// Maps whose files list what is blocked, too: more holes than faces, side by side.
#[test]
fn maps_with_many_holes_are_what_they_are_with_a_record_for_each_number() {
    let mut holes = std::collections::BTreeSet::new();
    for seed in 0..40 {
        let jitter = [0.0, 0.4][seed as usize % 2];
        let (size, share) = (3 + seed as usize % 14, [0.2, 0.55, 0.8][seed as usize % 3]);
        let mut map = Map::random(seed, size, [1.0, 0.8][seed as usize / 2 % 2], jitter).subdivision();
        let mut random = Random::new(seed + 5000);
        let inner: Vec<FaceId> = map.faces().filter(|&f| f != map.outer_face()).collect();
        for &f in inner[1..].iter().filter(|_| random.unit() < share) {
            map.set_hole(f, true);
        }
        // The hole that each hole face belongs to, by numbers that go down until nothing changes.
        let mut first_of: Vec<u32> = (0..map.face_bound() as u32).collect();
        loop {
            let before = first_of.clone();
            for h in map.half_edges() {
                let [f, g] = [map.face(h), map.face(h.twin())];
                if map.is_hole(f) && map.is_hole(g) {
                    first_of[f.index()] = first_of[f.index()].min(first_of[g.index()]);
                }
            }
            if before == first_of {
                break;
            }
        }
        let mesh = NavMesh::new(&map).expect("triangles");
        // Before the first obstacle there is a record for each number.
        let live = LiveMesh::new(map.clone()).expect("triangles");
        let dense = live.mesh();
        assert!(mesh.faces().eq(dense.faces()) && mesh.components().eq(dense.components()), "seed {seed}");
        for f in (0..map.face_bound() as u32 + 2).map(FaceId::new) {
            assert!(mesh.sides(f).eq(dense.sides(f)) && mesh.corners(f).eq(dense.corners(f)), "seed {seed}: {f}");
            let facts =
                |mesh: &NavMesh| (mesh.has_face(f), mesh.is_walkable(f), mesh.component(f), mesh.is_dead_end(f));
            assert_eq!(facts(&mesh), facts(dense), "seed {seed}: {f}");
        }
        let at_random = (0..150).map(|_| {
            let [x, y] = [(); 2].map(|()| random.unit() * (size as f64 + 1.0) - 0.5);
            Point::new(x, y)
        });
        let asked: Vec<Point> = at_random.chain(map.vertices().map(|v| map.point(v))).collect();
        for p in asked {
            let found = mesh.locate(p);
            assert_eq!((mesh.locate_by_scan(p), dense.locate(p)), (found, found), "seed {seed}: {p}");
            if let dcel_kit::plane::Location::Face(f) = map.locate_by_scan(p) {
                let expected = match f {
                    f if f == map.outer_face() => Location::Outer,
                    f if map.is_hole(f) => Location::Hole(FaceId::new(first_of[f.index()])),
                    f => Location::Face(f),
                };
                assert_eq!(found, expected, "seed {seed}: {p}");
                holes.extend(map.is_hole(f).then_some((seed, first_of[f.index()])));
            }
        }
        let mut planner = Planner::new();
        for _ in 0..20 {
            let mut point = || Point::new(random.unit() * size as f64, random.unit() * size as f64);
            let ends = (point(), point());
            for algorithm in PathAlgorithm::ALL {
                let mut route = |mesh: &NavMesh| planner.route_between(mesh, algorithm, ends.0, ends.1);
                assert_eq!(route(&mesh), route(dense), "seed {seed}: {ends:?}");
            }
        }
    }
    assert!(holes.len() > 200, "only {} holes were asked for", holes.len());
}

/// Blocked faces cost some bits, and not the records of a face.
#[test]
fn a_map_with_more_holes_than_faces_is_not_much_larger_than_one_without() {
    let mut map = Map::random(5, 60, 1.0, 0.3).subdivision();
    // Blocks of blocked triangles; none at the border, so that both maps have the same vertices there.
    let blocked: Vec<FaceId> = map
        .faces()
        .filter(|&f| f != map.outer_face())
        .filter(|&f| {
            let h = map.incident_half_edges(f).next().expect("a triangle");
            let p = map.point(map.origin(h));
            (p.x as usize / 2 + p.y as usize / 2) % 2 == 1 || p.x as usize % 7 == 3
        })
        .collect();
    blocked.iter().for_each(|&f| assert_eq!(map.set_hole(f, true), Some(false)));
    let mesh = NavMesh::new(&map).expect("triangles");
    assert!(blocked.len() > mesh.face_count(), "{} holes, {} faces", blocked.len(), mesh.face_count());
    let points: Vec<Point> = (0..map.vertex_bound() as u32).map(|v| map.point(VertexId::new(v))).collect();
    let triangles: Vec<[u32; 3]> = mesh
        .faces()
        .map(|f| mesh.corners(f).map(VertexId::number).collect::<Vec<_>>().try_into().expect("3"))
        .collect();
    let without = NavMesh::new(&Subdivision::from_triangles(points, &triangles).expect("the same")).expect("triangles");
    assert_eq!(mesh.face_count(), without.face_count());
    let each = |bytes: usize| bytes as f64 / mesh.face_count() as f64;
    let (with, without) = (each(mesh.memory()), each(without.memory()));
    assert!(with < without + 8.0, "{with:.1} bytes a face, {without:.1} without holes");
}

/// An edge between a hole and what is outside is kept, and so are the cells that it runs through.
#[test]
fn holes_beside_the_outside_take_memory() {
    for size in [4u32, 12, 40] {
        let number = |x: u32, y: u32| y * (size + 1) + x;
        let points: Vec<Point> =
            (0..=size).flat_map(|y| (0..=size).map(move |x| Point::new(f64::from(x), f64::from(y)))).collect();
        // Two arms of cells; between them a hole with one long side to the outside.
        let cells = (0..size).flat_map(|y| (0..size).map(move |x| (x, y))).filter(|&(x, y)| x < 2 || y < 2);
        let mut faces = dcel_kit::topology::PolygonList::new();
        for (x, y) in cells {
            faces.push_face(&[number(x, y), number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)]);
        }
        let arms = faces.clone();
        let bottom = (2..=size).map(|x| number(x, 2));
        let between: Vec<u32> = bottom.chain((3..=size).rev().map(|y| number(2, y))).collect();
        faces.push_face(&between);
        let hole = FaceId::new(faces.face_count() as u32);
        let mut map = Subdivision::from_polygons(points.clone(), &faces).expect("cells, and what is between");
        assert_eq!(map.set_hole(hole, true), Some(false));
        let with = NavMesh::new(&map).expect("squares");
        let without = NavMesh::new(&Subdivision::from_polygons(points, &arms).expect("cells")).expect("squares");
        assert_eq!(with.face_count(), without.face_count());
        let middle = Point::new(2.25, 2.25);
        assert_eq!((with.locate(middle), without.locate(middle)), (Location::Hole(hole), Location::Outer));
        // The ends and the holes on both sides of the edge are four words; each cell that it runs through takes two.
        let more = with.memory() as isize - without.memory() as isize;
        assert!(more >= 16 + 8, "{size}: {more} bytes more");
    }
}
