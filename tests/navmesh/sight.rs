//! Rays against a slow program in whole numbers; random places against the areas they should fill.

use crate::maps::{Map, Random};
use crate::oracle::{Oracle, sides};
use dcel_kit::FaceId;
use dcel_kit::navmesh::{LiveMesh, NavMesh, QueryPoint, RaycastError, Side};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision};
use std::cmp::Ordering;

/// Coordinates are quarters.
type Whole = [i128; 2];

fn whole(p: Point) -> Whole {
    [p.x, p.y].map(|x| (4.0 * x) as i128)
}

fn turn([a, b]: [Whole; 2], c: Whole) -> i128 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// A fraction of the path from p to q; the denominator is positive.
type Part = [i128; 2];

fn order(a: &Part, b: &Part) -> Ordering {
    (a[0] * b[1]).cmp(&(b[0] * a[1]))
}

/// How far the line from p to q leads over free ground: the fraction at which it ends, or `None` if it does not.
fn first_wall(map: &Map, oracle: &Oracle, [p, q]: [Point; 2]) -> Option<f64> {
    let ends = [p, q].map(whole);
    let corners = |t: usize| map.corners(t).map(whole);
    // Where the line meets the line of a side, or a vertex.
    let mut stops: Vec<Part> = vec![[0, 1], [1, 1]];
    for t in 0..map.triangles.len() {
        let [a, b, c] = corners(t);
        for side in [[a, b], [b, c], [c, a]] {
            let [of_p, of_q] = ends.map(|end| turn(side, end));
            let part = if of_p >= of_q { [of_p, of_p - of_q] } else { [-of_p, of_q - of_p] };
            if part[1] != 0 && part[0] >= 0 && part[0] <= part[1] {
                stops.push(part);
            }
        }
        for v in [a, b, c] {
            let along = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
            let [x, y] = [v[0] - ends[0][0], v[1] - ends[0][1]];
            let part = [x * along[0] + y * along[1], along[0] * along[0] + along[1] * along[1]];
            if turn(ends, v) == 0 && part[0] >= 0 && part[0] <= part[1] {
                stops.push(part);
            }
        }
    }
    stops.sort_by(order);
    stops.dedup_by(|a, b| order(a, b).is_eq());
    let at_part = |t: usize, [num, den]: Part| {
        let [a, b, c] = corners(t);
        [[a, b], [b, c], [c, a]].into_iter().all(|side| {
            let [of_p, of_q] = ends.map(|end| turn(side, end));
            den * of_p + num * (of_q - of_p) >= 0
        })
    };
    let mut before: Vec<usize> = Vec::new();
    for (i, pair) in stops.windows(2).enumerate() {
        let ([a, b], [c, d]) = (pair[0], pair[1]);
        let middle = [a * d + c * b, 2 * b * d];
        let here: Vec<usize> = oracle.free_triangles().filter(|&t| at_part(t, middle)).collect();
        let joined = |&s: &usize| {
            here.iter().any(|&t| {
                // Round the vertex at the stop, or across the side.
                let common: Vec<u32> = map.triangles[s].into_iter().filter(|v| map.triangles[t].contains(v)).collect();
                s == t
                    || oracle.neighbours(s).contains(&t)
                    || common.iter().any(|&v| same_wedge(map, oracle, v, s, t) && is_at(map, v, ends, pair[0]))
            })
        };
        if here.is_empty() || (i > 0 && !before.iter().any(joined)) {
            return Some(a as f64 / b as f64);
        }
        before = here;
    }
    None
}

fn is_at(map: &Map, v: u32, [p, q]: [Whole; 2], [num, den]: Part) -> bool {
    let v = whole(map.points[v as usize]);
    (0..2).all(|i| den * v[i] == den * p[i] + num * (q[i] - p[i]))
}

/// Whether one may walk round the vertex from one triangle to the other.
fn same_wedge(map: &Map, oracle: &Oracle, v: u32, from: usize, to: usize) -> bool {
    let mut seen = vec![from];
    let mut i = 0;
    while i < seen.len() {
        for side in sides(map.triangles[seen[i]]).into_iter().filter(|side| side.contains(&v)) {
            seen.extend(oracle.across(seen[i], side).filter(|t| !seen.contains(t)));
        }
        i += 1;
    }
    seen.contains(&to)
}

#[test]
fn a_ray_ends_where_a_program_in_whole_numbers_says() {
    let (mut hits, mut clear, mut at_vertices, mut passed) = (0, 0, 0, 0);
    for seed in 0..60 {
        let mut random = Random::new(seed + 14_000);
        let size = 3 + seed as usize % 3;
        let map = Map::random(seed, size, 0.85, 0.0);
        let free: Vec<bool> = map.triangles.iter().map(|_| random.unit() < 0.85).collect();
        let mut mesh = map.mesh();
        for t in (0..free.len()).filter(|&t| !free[t]) {
            mesh.block(FaceId::new(t as u32 + 1));
        }
        let oracle = Oracle::new(&map, free);
        for _ in 0..60 {
            // Whole, half and quarter coordinates, in and out of the map: vertices, edges and lines along them are hit.
            let step = [1.0, 2.0, 4.0][random.below(3)];
            let mut point = || {
                let [x, y] = [(); 2].map(|()| ((random.unit() * (size as f64 + 2.0) - 1.0) * step).round() / step);
                Point::new(x, y)
            };
            let ends = [point(), point()];
            let context = format!("seed {seed}: {} -> {}", ends[0], ends[1]);
            let cast = match mesh.raycast(ends[0], ends[1]) {
                Ok(cast) => cast,
                Err(RaycastError::Start(_)) => {
                    assert!(mesh.place(ends[0]).is_err(), "{context}");
                    continue;
                }
                Err(error) => panic!("{context}: {error}"),
            };
            for pair in cast.faces.windows(2) {
                let around = |f| mesh.corners(f).collect::<Vec<_>>();
                assert!(around(pair[0]).iter().any(|v| around(pair[1]).contains(v)), "{context}: {:?}", cast.faces);
            }
            let expected = if ends[0] == ends[1] { None } else { first_wall(&map, &oracle, ends) };
            let Some(hit) = cast.hit else {
                assert_eq!(expected, None, "{context}: nothing is hit");
                clear += 1;
                continue;
            };
            let part = expected.unwrap_or_else(|| panic!("{context}: {hit:?} is hit, and nothing is there"));
            let [x, y] = [ends[1].x - ends[0].x, ends[1].y - ends[0].y];
            let length = x.hypot(y);
            assert!((hit.distance - part * length).abs() < 1e-12, "{context}: {hit:?}, but {part}");
            assert!((hit.point.x - ends[0].x - part * x).abs() < 1e-12, "{context}: {hit:?}");
            let side = mesh.sides(hit.face).find(|side| side.half_edge == hit.half_edge);
            let side = side.unwrap_or_else(|| panic!("{context}: {hit:?} is no side of its face"));
            assert!(
                !side.open && mesh.is_walkable(hit.face) && cast.faces.last() == Some(&hit.face),
                "{context}: {hit:?}"
            );
            let [a, b] = [side.from, side.to].map(|v| mesh.point(v));
            let is_in_the_way = |side: &Side| {
                let [a, b] = [side.from, side.to].map(|v| mesh.point(v));
                orientation(a, b, ends[1]).is_lt()
            };
            assert!(is_in_the_way(&side), "{context}: {hit:?}");
            match hit.vertex {
                Some(v) => {
                    assert!(hit.point == mesh.point(v) && [side.from, side.to].contains(&v), "{context}: {hit:?}");
                    // It is one of the face that the ray came through, if one of those is in the way there.
                    if let &[.., before, _] = &*cast.faces {
                        let mut sides = mesh.sides(before).filter(|side| [side.from, side.to].contains(&v));
                        let own = sides.find(|side| !side.open && is_in_the_way(side));
                        assert_eq!(own, None, "{context}: {hit:?} after {before}");
                        passed += 1;
                    }
                }
                // It runs against the side from its left.
                None => assert!(orientation(a, b, ends[0]).is_ge(), "{context}: {hit:?}"),
            }
            hits += 1;
            at_vertices += usize::from(hit.vertex.is_some());
        }
    }
    assert!(hits > 500 && clear > 300 && at_vertices > 50, "{hits} hits, {at_vertices} at vertices, {clear} clear");
    assert!(passed > 20, "{passed} hits at vertices of other faces than the ray came through");
}

#[test]
fn from_a_wall_a_ray_goes_to_its_own_side() {
    let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    let mut live = LiveMesh::new(Subdivision::polygon(&hall).expect("a hall")).expect("convex");
    live.insert_wall(Point::new(4.0, 1.0), Point::new(4.0, 3.0)).expect("it fits");
    let (mesh, on_wall) = (live.mesh(), Point::new(4.0, 2.0));
    assert!(matches!(mesh.raycast(on_wall, hall[0]), Err(RaycastError::Start(_))));
    let places: Vec<QueryPoint> = mesh.faces().filter_map(|f| mesh.place_in(f, on_wall).ok()).collect();
    assert_eq!(places.len(), 2);
    for place in places {
        let is_left = mesh.corners(place.face).any(|v| mesh.point(v).x < 4.0);
        let hit = mesh.raycast_from(&place, Point::new(0.0, 2.0)).expect("in range").hit;
        assert_eq!(hit.map(|hit| hit.distance), if is_left { None } else { Some(0.0) });
        // Along the wall and round its end nothing is in the way.
        assert_eq!(mesh.raycast_from(&place, Point::new(4.0, 4.0)).expect("in range").hit, None);
        let stays = mesh.raycast_from(&place, place.point).expect("in range");
        assert_eq!((stays.faces, stays.hit), (vec![place.face], None), "a ray without length");
    }
    assert!(matches!(mesh.raycast(hall[0], Point::new(f64::NAN, 0.0)), Err(RaycastError::End(_))));
    assert!(matches!(mesh.raycast(hall[0], Point::new(1e300, 1.0)), Err(RaycastError::End(_))));
}

#[test]
fn what_a_ray_reaches_is_as_near_as_the_shortest_path() {
    // Far from the origin and small, too: the decisions are those of the same map at home.
    for (offset, scale) in [(0.0, 1.0), (1e7, 1.0), (0.0, 1e-9)] {
        let mut planner = dcel_kit::navmesh::Planner::new();
        let mut random = Random::new(15_000);
        let (mut clear, mut blocked) = (0, 0);
        for seed in 0..12 {
            let home = Map::random(seed, 5, 0.8, 0.5);
            let there = |p: Point| Point::new(p.x * scale + offset, p.y * scale - offset);
            let map = home.moved(there);
            let mesh = map.mesh();
            for _ in 0..60 {
                let [a, b] = [(); 2].map(|()| random.below(map.triangles.len()));
                let [a, b] = [map.inside(a, &mut random), map.inside(b, &mut random)];
                let straight = (b.x - a.x).hypot(b.y - a.y);
                let route = planner.route_between(&mesh, dcel_kit::navmesh::PathAlgorithm::Exact, a, b);
                let cast = mesh.raycast(a, b).expect("inside");
                match (cast.hit, route) {
                    (None, route) => {
                        let length = route.expect("it is in sight").length;
                        assert!((length - straight).abs() <= 1e-9 * straight, "seed {seed}: {a} -> {b}");
                        clear += 1;
                    }
                    (Some(hit), Ok(route)) => {
                        assert!(route.length > straight * (1.0 - 1e-12), "seed {seed}: {a} -> {b}");
                        assert!(!route.corners.is_empty() && hit.distance <= straight, "seed {seed}: {a} -> {b}");
                        blocked += 1;
                    }
                    (Some(_), Err(_)) => blocked += 1,
                }
            }
        }
        assert!(clear > 100 && blocked > 100, "{clear} clear, {blocked} blocked");
    }
}

#[test]
fn random_places_fill_every_face_by_its_area() {
    for seed in 0..6 {
        let map = Map::random(seed, 4, 0.8, 0.6);
        let mut mesh = map.mesh();
        mesh.block(FaceId::new(1));
        let area = |f: FaceId| {
            let [a, b, c] = map.corners(f.index() - 1);
            (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
        };
        let free: Vec<FaceId> = mesh.faces().filter(|&f| mesh.is_walkable(f)).collect();
        let whole: f64 = free.iter().map(|&f| area(f)).sum();
        let count = 40_000;
        let mut found = vec![0; mesh.face_bound()];
        let mut halves = [0, 0];
        for place in mesh.random_places(seed).take(count) {
            assert!(mesh.place(place.point).is_ok(), "seed {seed}: {place:?}");
            assert!(mesh.place_in(place.face, place.point).is_ok(), "seed {seed}: {place:?}");
            found[place.face.index()] += 1;
            // The half at the first corner has a quarter of the area.
            let [a, b, c] = map.corners(place.face.index() - 1);
            let height = |p: Point| (p.x - a.x) * (c.y - b.y) - (p.y - a.y) * (c.x - b.x);
            halves[usize::from(height(place.point).abs() * 2.0 < height(b).abs())] += 1;
        }
        for f in free {
            let expected = count as f64 * area(f) / whole;
            let off = (f64::from(found[f.index()]) - expected).abs();
            assert!(off < 5.0 * expected.sqrt() + 5.0, "seed {seed}, {f}: {} and not {expected}", found[f.index()]);
        }
        let quarter = halves[1] as f64 / count as f64;
        assert!((quarter - 0.25).abs() < 0.012, "seed {seed}: {quarter} at the first corner");
        // The same seed, the same places; another, others.
        assert!(mesh.random_places(seed).take(9).eq(mesh.random_places(seed).take(9)));
        assert!(!mesh.random_places(seed).take(9).eq(mesh.random_places(seed + 1).take(9)));
        let component = mesh.components().map(|(c, _)| c).last().expect("one");
        let mut inside = mesh.random_places_in(mesh.component_faces(component), seed).take(50);
        assert!(inside.all(|place| mesh.component(place.face) == Some(component)), "seed {seed}");
    }
    // Nowhere to stand, nothing to give; in a thin face, on it all the same.
    let corners = [(0., 0.), (1., 0.), (1., 1e-40)].map(Point::from);
    let thin = NavMesh::new(&Subdivision::polygon(&corners).expect("thin")).expect("convex");
    assert!(thin.random_places(1).take(50).all(|place| thin.place(place.point).is_ok()));
    let mut none = thin.clone();
    none.block(FaceId::new(1));
    assert_eq!(none.random_places(1).next(), None);
}
