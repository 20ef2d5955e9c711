//! How far everything is, and where a wide agent fits.

use crate::maps::{Map, Random};
use crate::oracle::{Node, Oracle};
use crate::routes::{is_close, place};
use dcel_kit::navmesh::{Link, LinkError, NavMesh, PathAlgorithm, Planner, RouteError, Stop};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, FaceMap, VertexId};

/// On lines of which the points lie beside each other by rounding, a part of a side may be in sight that is a single point
/// of doubles.
#[test]
fn the_field_far_from_the_origin_has_the_lengths_of_the_paths() {
    let mut planner = Planner::new();
    let mut reached = 0;
    for seed in 0..120 {
        let mut map = Map::random(seed, 2 + seed as usize % 4, 0.75, 0.0);
        // Tenths, as they are written in decimals, on lines that are neither level nor upright.
        let [dx, dy] = [1.0, 3.0].map(|k| k + (seed % 5) as f64);
        let place = |p: &Point| Point::new((8.0 * p.x - p.y * dx) * 0.1 + 100.0, (8.0 * p.y + p.x * dy) * 0.1 - 36.0);
        map.points = map.points.iter().map(place).collect();
        let mesh = map.mesh();
        let corners: Vec<VertexId> = map.triangles.iter().flatten().map(|&v| VertexId::new(v)).collect();
        let start = corners
            .iter()
            .cycle()
            .skip(seed as usize)
            .take(corners.len())
            .find_map(|&v| mesh.place(mesh.point(v)).ok());
        let Some(start) = start else { continue };
        let field = planner.distance_field(&mesh, &start, f64::INFINITY);
        for v in corners {
            // At a double corner the nearer of its wedges counts.
            let places = mesh.places(mesh.point(v)).expect("a corner");
            let paths = places.iter().filter_map(|goal| planner.route(&mesh, PathAlgorithm::Exact, &start, goal).ok());
            let least = paths.map(|path| path.length).min_by(f64::total_cmp);
            match (field.distance(v), least) {
                (Some(x), Some(y)) => assert!(is_close(x, y), "seed {seed}: {v}: {x} but {y}"),
                (x, y) => assert_eq!(x, y, "seed {seed}: {v}"),
            }
            reached += usize::from(least.is_some());
        }
    }
    assert!(reached > 1000, "{reached}");
}

/// Four quads of which three corners lie on one line but for rounding.
#[test]
fn the_field_goes_round_corners_in_a_row() {
    let points = [
        (100.0, -36.3),
        (100.9, -36.2),
        (100.8, -35.5),
        (100.0, -35.3),
        (100.9, -34.6),
        (100.0, -34.6),
        (101.6, -35.4),
        (101.5, -34.6),
        (102.4, -35.3),
        (102.4, -34.6),
    ]
    .map(Point::from);
    let mut quads = PolygonList::new();
    [[0, 1, 2, 3], [3, 2, 4, 5], [2, 6, 7, 4], [6, 8, 9, 7]].iter().for_each(|quad| quads.push_face(quad));
    let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &quads).unwrap()).unwrap();
    let mut planner = Planner::new();
    let field = planner.distance_field(&mesh, &mesh.place(points[8]).unwrap(), f64::INFINITY);
    for (v, &goal) in points.iter().enumerate() {
        let path = planner.route_between(&mesh, PathAlgorithm::Exact, points[8], goal).expect("one floor");
        let length = field.distance(VertexId::new(v as u32)).expect("in reach");
        assert!(is_close(length, path.length), "v{v}: {length} but {}", path.length);
    }
}

#[test]
fn the_field_has_the_length_of_the_shortest_way_to_every_vertex() {
    let mut planner = Planner::new();
    for seed in 0..40 {
        let map = Map::random(seed, 2 + seed as usize % 3, 0.7, [0.0, 0.6][seed as usize % 2]);
        let (mesh, oracle) = (map.mesh(), Oracle::all_free(&map));
        let mut random = Random::new(seed + 8000);
        let t = random.below(map.triangles.len());
        let start = Oracle::inner_node(map.inside(t, &mut random), t);
        let goals: Vec<Node> = oracle.vertex_nodes();
        let lengths = oracle.distances(&start, &goals);
        let limit = 2.0 + random.unit();
        let whole = planner.distance_field(&mesh, &place(&mesh, &start), f64::INFINITY);
        let part = planner.distance_field(&mesh, &place(&mesh, &start), limit);
        for v in 0..map.points.len() as u32 {
            // At a double corner the nearer wedge counts.
            let here = goals.iter().zip(&lengths).filter(|(goal, _)| goal.point == map.points[v as usize]);
            let least = here.filter_map(|(_, length)| *length).min_by(f64::total_cmp);
            let within = least.filter(|&length| length <= limit);
            for (field, expected) in [(&whole, least), (&part, within)] {
                match (field.distance(VertexId::new(v)), expected) {
                    (Some(x), Some(y)) => assert!(is_close(x, y), "seed {seed}: v{v}: {x} but {y}"),
                    (x, y) => assert_eq!(x, y, "seed {seed}: v{v}, limit {limit}"),
                }
            }
        }
        assert!(
            part.faces_within(&mesh).all(|f| mesh.corners(f).all(|v| part.distance(v).is_some_and(|d| d <= limit)))
        );
    }
}

/// Between pillars in rows there are as many equally short ways to a corner as there are orders of the steps to it: they
/// must not all be gone on with.
#[test]
fn equally_short_ways_do_not_multiply() {
    let work = |size: u32| {
        let mesh = cells(size, size, |x, y| x % 2 == 0 || y % 2 == 0);
        let start = mesh.place(Point::new(0.5, 0.25)).expect("on the map");
        let field = Planner::new().distance_field(&mesh, &start, f64::INFINITY);
        // Along the lowest row, straight to its end.
        let end = field.distance(VertexId::new(size)).expect("reached");
        assert!(is_close(end, (f64::from(size) - 0.5).hypot(0.25)), "{end}");
        field.work.expansions
    };
    let [small, large] = [15, 31].map(work);
    assert!(large < 12 * small, "{small} cones in 15 rows, {large} in 31");
}

/// A mesh of the cells of unit squares that are open, two triangles each.
fn cells(width: u32, height: u32, is_open: impl Fn(u32, u32) -> bool) -> NavMesh {
    let corner = |x: u32, y: u32| y * (width + 1) + x;
    let points = (0..=height).flat_map(|y| (0..=width).map(move |x| Point::new(x.into(), y.into()))).collect();
    let triangles: Vec<[u32; 3]> = (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .filter(|&(x, y)| is_open(x, y))
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    NavMesh::new(&Subdivision::from_triangles(points, &triangles).expect("cells")).expect("triangles")
}

/// Along a row of pillars each of their corners is reached a little better from the pillar before: what is seen of the
/// others by then must not all be written down.
#[test]
fn a_row_of_pillars_takes_memory_in_proportion() {
    let work = |pillars: u32| {
        let mesh = cells(2 * pillars + 1, 3, |x, y| y != 1 || x % 2 == 0);
        let start = mesh.place(Point::new(0.5, 2.5)).expect("on the map");
        Planner::new().distance_field(&mesh, &start, f64::INFINITY).work.pushes
    };
    let [small, large] = [100, 200].map(work);
    assert!(large < 3 * small, "{small} cones by 100 pillars, {large} by 200");
}

/// Sides in one line, seen edge-on, and paths as long as others: where everything is searched, less is looked at than for
/// one goal, and the lengths are the same.
#[test]
fn the_field_on_cells_has_the_lengths_of_paths() {
    let mut planner = Planner::new();
    let mut compared = 0;
    for seed in 0..60 {
        let mut random = Random::new(seed + 4100);
        let (width, height) = (8 + random.below(12) as u32, 3 + random.below(9) as u32);
        let open: Vec<bool> = (0..width * height).map(|i| i == 0 || random.unit() > 0.3).collect();
        let is_open = |x: u32, y: u32| match seed % 3 {
            0 => x.is_multiple_of(2) || y.is_multiple_of(2),
            1 => open[(y * width + x) as usize],
            _ => open[((y / 2) * width + x) as usize] || x == 0,
        };
        let mesh = cells(width, height, is_open);
        // A corner, the middle of a side, and places inside.
        for at in [[0.0, 0.0], [0.5, 0.0], [0.25, 0.5], [0.7, 0.3]] {
            let start = mesh.place(at.into()).expect("the first cell");
            for mut planner in [Planner::face_by_face(), std::mem::take(&mut planner)] {
                let field = planner.distance_field(&mesh, &start, f64::INFINITY);
                for v in (0..mesh.vertex_bound() as u32).map(VertexId::new) {
                    let wedges = mesh.wedges(v);
                    // Of the wedges of a double corner the nearer one counts.
                    let lengths = wedges.iter().filter_map(|wedge| {
                        let goal = mesh.place_in(wedge[0], mesh.point(v)).expect("its corner");
                        Some(planner.route(&mesh, PathAlgorithm::Exact, &start, &goal).ok()?.length)
                    });
                    let least = lengths.min_by(f64::total_cmp);
                    match (field.distance(v), least) {
                        (Some(x), Some(y)) => assert!(is_close(x, y), "seed {seed}, from {at:?}: {v}: {x} but {y}"),
                        (x, y) => assert_eq!(x, y, "seed {seed}, from {at:?}: {v}"),
                    }
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 50_000, "{compared}");
}

/// Two rooms joined by a narrow hole below and a wide one above.
fn two_holes() -> NavMesh {
    let at = |x: f64, y: f64| Point::new(x, y);
    let walls = [[at(5., 0.), at(6., 0.), at(6., 1.), at(5., 1.)], [at(5., 2.), at(6., 2.), at(6., 7.), at(5., 7.)]];
    let mut points = vec![at(0., 0.), at(5., 0.), at(6., 0.), at(11., 0.), at(11., 10.), at(0., 10.)];
    let mut edges = vec![[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]];
    let first = points.len() as u32;
    points.extend([walls[0][2], walls[0][3]]);
    edges.extend([[2, first], [first, first + 1], [first + 1, 1]]);
    let second = points.len() as u32;
    points.extend(walls[1]);
    edges.extend((0..4).map(|k| [second + k, second + (k + 1) % 4]));
    let mut s = Subdivision::from_graph(&points, &edges).expect("two blocks");
    for (x, y) in [(5.5, 0.5), (5.5, 4.5)] {
        let inside = s.faces().skip(1).find(|&f| {
            let corners: Vec<Point> = s.incident_vertices(f).map(|v| s.point(v)).collect();
            corners.len() == 4 && corners.iter().all(|p| (p.x - x).abs() <= 0.5 && (p.y - y).abs() <= 2.5)
        });
        s.set_hole(inside.expect("a block"), true);
    }
    s.triangulate(dcel_kit::plane::TriangulationMethod::Monotone).expect("rooms");
    NavMesh::new(&s).expect("triangles")
}

#[test]
fn a_wide_agent_takes_the_wide_hole_and_a_very_wide_one_none() {
    let mesh = two_holes();
    let mut planner = Planner::new();
    let [start, goal] = [(2.0, 1.5), (9.0, 1.5)].map(|p| mesh.place(p.into()).expect("free"));
    let thin = planner.route(&mesh, PathAlgorithm::Exact, &start, &goal).expect("straight");
    assert!(is_close(thin.length, 7.0));
    let point = planner.wide_route(&mesh, 0.0, &start, &goal).expect("as a point");
    assert!(point.length >= thin.length - 1e-9);
    // 0.6 does not fit through the hole of 1.
    let wide = planner.wide_route(&mesh, 0.6, &start, &goal).expect("through the upper hole");
    assert!(wide.points.iter().any(|p| p.y >= 7.0), "{:?}", wide.points);
    assert!(wide.length > 12.0 && wide.corners.is_empty());
    // Off every endpoint of every portal.
    for portal in wide.portal_ends(&mesh) {
        for v in [portal.left, portal.right] {
            let p = mesh.point(v);
            assert!(wide.points[1..wide.points.len() - 1].iter().all(|q| (q.x - p.x).hypot(q.y - p.y) >= 0.6 - 1e-9));
        }
    }
    let error = planner.wide_route(&mesh, 4.0, &start, &goal).expect_err("no hole is 8 wide");
    assert!(matches!(error, RouteError::TooNarrow { .. }), "{error}");
}

/// Where costs differ by next to nothing the lengths are next to those of the exact field; never less, and little more.
#[test]
fn costs_of_paths_are_no_less_than_the_least_and_little_more() {
    let mut planner = Planner::new();
    let mut worst = 1.0f64;
    for seed in 0..24 {
        let map = Map::random(seed + 40, 8, 0.8, [0.0, 0.5][seed as usize % 2]);
        let mesh = map.mesh();
        let mut random = Random::new(seed);
        let start = map.inside(random.below(map.triangles.len()), &mut random);
        let Ok(place) = mesh.place(start) else { continue };
        let exact = planner.distance_field(&mesh, &place, f64::INFINITY);
        let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
        let field = planner.weighted_distance_field(&mesh, &costs, &[], &place, f64::INFINITY).expect("no links");
        let vertices = || (0..mesh.vertex_bound() as u32).map(VertexId::new);
        assert!(vertices().all(|v| field.distance(v) == exact.distance(v)), "seed {seed}: one cost");
        costs[mesh.faces().next().expect("a face")] = 1.0 + 1e-12;
        let field = planner.weighted_distance_field(&mesh, &costs, &[], &place, f64::INFINITY).expect("no links");
        for v in vertices() {
            match (field.distance(v), exact.distance(v)) {
                (Some(cost), Some(length)) => {
                    assert!(cost >= length * (1.0 - 1e-12), "seed {seed}: {v}: {cost}, and {length} is the least");
                    worst = worst.max(cost / length);
                }
                (one, other) => assert_eq!(one, other, "seed {seed}: {v}"),
            }
        }
        // Dear and cheap faces: between the least and the greatest cost of a unit, and more where more is dear.
        let mut dear = costs.clone();
        for f in mesh.faces() {
            costs[f] = 1.0 + 3.0 * random.unit();
            dear[f] = costs[f] * (1.0 + random.unit());
        }
        let [field, dear] = [&costs, &dear]
            .map(|costs| planner.weighted_distance_field(&mesh, costs, &[], &place, f64::INFINITY).expect("no links"));
        let near = planner.weighted_distance_field(&mesh, &costs, &[], &place, 6.0).expect("no links");
        for v in vertices() {
            let (Some(cost), Some(length)) = (field.distance(v), exact.distance(v)) else { continue };
            assert!(cost >= length * (1.0 - 1e-12) && cost <= 4.0 * 1.05 * length, "seed {seed}: {v}");
            assert!(dear.distance(v).is_some_and(|dear| dear >= cost), "seed {seed}: {v}");
            assert_eq!(near.distance(v), Some(cost).filter(|&cost| cost <= 6.0), "seed {seed}: {v}");
        }
    }
    assert!(worst > 1.0 && worst < 1.05, "{worst}");
}

/// Over the border of two fields a path is bent as light is: the least by a look at every place where it may cross.
#[test]
fn a_dear_field_is_left_by_the_shortest_line_and_links_lead_past_it() {
    // Grass below the line y = 1, mud of three times the cost above it.
    let points = [(0., 0.), (6., 0.), (6., 1.), (0., 1.), (6., 4.), (0., 4.)].map(Point::from);
    let mut fields = PolygonList::new();
    [[0, 1, 2, 3], [3, 2, 4, 5]].iter().for_each(|field| fields.push_face(field));
    let mesh =
        NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &fields).expect("two fields")).expect("convex");
    let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
    costs[FaceId::new(2)] = 3.0;
    let start = mesh.place(Point::new(0.5, 0.25)).expect("on the grass");
    let least = |goal: Point| {
        let cost = |x: f64| (x - 0.5f64).hypot(0.75) + 3.0 * (goal.x - x).hypot(goal.y - 1.0);
        (0..=60_000).map(|i| cost(f64::from(i) * 1e-4)).fold(f64::INFINITY, f64::min)
    };
    let mut planner = Planner::new();
    let field = planner.weighted_distance_field(&mesh, &costs, &[], &start, f64::INFINITY).expect("no links");
    for v in [4, 5] {
        let (found, least) = (field.distance(VertexId::new(v)).expect("near"), least(points[v as usize]));
        assert!(found >= least - 1e-9 && found < 1.01 * least, "v{v}: {found}, and {least} is the least");
    }
    let stop = |x, y| Stop { layer: 0, place: mesh.place(Point::new(x, y)).expect("on a field") };
    let lift = Link { from: stop(0.5, 0.75), to: stop(5.5, 4.0), cost: 1.0 };
    let linked = planner.weighted_distance_field(&mesh, &costs, &[lift], &start, f64::INFINITY).expect("a lift");
    assert_eq!(linked.distance(VertexId::new(4)), Some(0.5 + 1.0 + 3.0 * 0.5));
    let wrong = Link { cost: -1.0, ..lift };
    let refused = planner.weighted_distance_field(&mesh, &costs, &[wrong], &start, f64::INFINITY);
    assert!(matches!(refused, Err(LinkError::Cost { link: 0, .. })), "{refused:?}");
}

/// A start in dear mud, close to the grass: the path out of the mud is short, wherever along the side the start is.
/// The exact cost is the least over the places where the side may be crossed.
#[test]
fn a_dear_field_is_left_straight_from_a_start_close_to_its_side() {
    let points = [(0., 0.), (14., 0.), (14., 14.), (0., 14.)].map(Point::from);
    let square = Subdivision::from_triangles(points.to_vec(), &[[0, 1, 2], [0, 2, 3]]).expect("two triangles");
    let mesh = NavMesh::new(&square).expect("convex");
    let mut planner = Planner::new();
    for (start, cost) in [1.0, 0.1, 0.01, 1e-4, 1e-8].into_iter().flat_map(|off| {
        [3.1, 6.9, 11.3].into_iter().flat_map(move |at| [2.0, 10.0, 100.0].map(|cost| (Point::new(at + off, at), cost)))
    }) {
        let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
        costs[FaceId::new(1)] = cost;
        let place = mesh.place(start).expect("in the mud");
        let field = planner.weighted_distance_field(&mesh, &costs, &[], &place, f64::INFINITY).expect("no links");
        let found = field.distance(VertexId::new(3)).expect("near");
        let over = |x: f64| cost * (start.x - x).hypot(start.y - x) + x.hypot(x - 14.0);
        // Convex in x: thirds are cut off.
        let [mut low, mut high] = [0.0, 14.0];
        for _ in 0..200 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if over(a) < over(b) { high = b } else { low = a }
        }
        let least = over(low);
        assert!(
            found >= least * (1.0 - 1e-9) && found < least * 1.02,
            "{start:?}, {cost}: {found}, and {least} is the least"
        );
    }
}

/// Dear strips, thin, one behind the other on grass, with sides of different lengths: they are crossed almost straight.
#[test]
fn thin_dear_faces_are_crossed_straight() {
    const THICK: f64 = 0.0002;
    const COST: f64 = 5000.0;
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..5 {
        let (x, y) = (f64::from(i), 4.0 * f64::from(i));
        points.extend([Point::new(-3.0 * x, y), Point::new(50.0 + 5.0 * x, y)]);
        points.extend([Point::new(-2.0 - 3.0 * x, y + THICK), Point::new(59.0 + 5.0 * x, y + THICK)]);
    }
    for row in 0..9_u32 {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * row + k);
        triangles.extend([[a, b, d], [a, d, c]]);
    }
    // A wide field below: the start is so far away that no points are placed for it.
    points.extend([Point::new(0.0, -70.0), Point::new(50.0, -70.0)]);
    triangles.extend([[20, 21, 1], [20, 1, 0]]);
    let map = Subdivision::from_triangles(points.clone(), &triangles).expect("rows");
    let mesh = NavMesh::new(&map).expect("convex");
    let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
    for f in (0..18).filter(|i| i % 4 < 2) {
        costs[FaceId::new(f + 1)] = COST;
    }
    let start = Point::new(21.0, -69.0);
    let place = mesh.place(start).expect("on the field");
    let field = Planner::new().weighted_distance_field(&mesh, &costs, &[], &place, f64::INFINITY).expect("no links");
    for v in [16, 17] {
        let goal = points[v as usize];
        let found = field.distance(VertexId::new(v)).expect("near");
        // Over the grass on one slope, and at right angles over the four strips.
        let good = (goal.x - start.x).hypot(goal.y - start.y - 4.0 * THICK) + 4.0 * COST * THICK;
        assert!(found > 0.9 * good && found < 1.1 * good, "v{v}: {found}, and {good} is one way");
    }
}
