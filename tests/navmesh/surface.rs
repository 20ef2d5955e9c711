//! Surfaces in space: against the plane where the surface can be laid flat, and elsewhere against every row of triangles
//! that leads to the goal, each searched for its shortest path by samples that get finer and finer.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use dcel_kit::navmesh::{
    Floor, NavMesh, NavSurface, PathAlgorithm, Planner, SurfaceError, SurfacePlanner, SurfacePoint, SurfacePointError,
    SurfaceRoute, SurfaceRouteError,
};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, FaceMap, VertexId};

type Space = [f64; 3];

pub(crate) fn list(faces: &[Vec<u32>]) -> PolygonList {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    list
}

/// The surface of a map whose points are lifted.
pub(crate) fn lifted(map: &Map, lift: impl FnMut(Point) -> Space) -> NavSurface {
    let points: Vec<Space> = map.points.iter().copied().map(lift).collect();
    let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
    NavSurface::new(&points, &list(&faces), None).expect("a surface")
}

pub(crate) fn far(a: Space, b: Space) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// The parts of a route fit together.
pub(crate) fn check(surface: &NavSurface, route: &SurfaceRoute, ends: [&SurfacePoint; 2], context: &str) {
    assert_eq!([route.points[0], *route.points.last().expect("two")], ends.map(|end| end.point), "{context}");
    assert_eq!(route.layers.len() + 1, route.points.len(), "{context}");
    let sum: f64 = route.points.windows(2).map(|pair| far(pair[0], pair[1])).sum();
    assert!(is_close(sum, route.length), "{context}: the points make {sum}, the length is {}", route.length);
    // Every piece lies on one of the triangles of its layer: both ends and the middle do.
    for (pair, &layer) in route.points.windows(2).zip(&route.layers) {
        for share in [0.0, 0.5, 1.0] {
            let p: Space = std::array::from_fn(|i| pair[0][i] + (pair[1][i] - pair[0][i]) * share);
            let near = surface.faces().filter(|&f| surface.layer(f) == Some(layer)).flat_map(|f| surface.triangles(f));
            let off = near.map(|t| off_triangle(p, t)).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-7, "{context}: {p:?} is {off} off layer {layer}");
        }
    }
}

/// How far a point is from a triangle, about.
pub(crate) fn off_triangle(p: Space, [a, b, c]: [Space; 3]) -> f64 {
    let [u, v, w] = [b, c, p].map(|q| -> Space { std::array::from_fn(|i| q[i] - a[i]) });
    let dot = |a: Space, b: Space| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let whole = uu * vv - uv * uv;
    let [s, t] = [(vv * wu - uv * wv) / whole, (uu * wv - uv * wu) / whole];
    let outside = (-s).max(-t).max(s + t - 1.0).max(0.0);
    far(p, std::array::from_fn(|i| a[i] + u[i] * s + v[i] * t)) + outside * (uu + vv).sqrt()
}

#[test]
fn what_can_be_laid_flat_has_the_lengths_of_the_plane() {
    let (mut planner, mut plain) = (SurfacePlanner::new(), Planner::new());
    let (mut bent, mut apart) = (0, 0);
    for seed in 0..60 {
        let tilted = seed % 2 == 0;
        let map = Map::random(seed + 500, 7, 0.75, if tilted { 0.5 } else { 0.0 });
        let mesh = map.mesh();
        // Tilted as a whole, or folded up and down along the columns, by slopes of 0.6 and 0.8 over 1.
        let lift = |p: Point| match tilted {
            true => [0.6 * p.x, p.y, 0.8 * p.x],
            false => {
                let fold = |x: f64| if x.rem_euclid(2.0) < 1.0 { x.rem_euclid(2.0) } else { 2.0 - x.rem_euclid(2.0) };
                [0.8 * p.x, p.y, 0.6 * fold(p.x)]
            }
        };
        let surface = lifted(&map, lift);
        assert_eq!(surface.layer_count(), 1);
        let mut random = Random::new(seed);
        for _ in 0..6 {
            let ends: Vec<Point> = (0..2)
                .map(|_| match random.below(3) {
                    0 => map.corners(random.below(map.triangles.len()))[0],
                    _ => map.inside(random.below(map.triangles.len()), &mut random),
                })
                .collect();
            let places: Vec<Vec<SurfacePoint>> = ends
                .iter()
                .map(|&p| {
                    let [x, y, _] = lift(p);
                    surface
                        .places_on([x, y], Floor::Any)
                        .or_else(|_| surface.nearest([x, y], Floor::Any).map(|(place, _)| vec![place]).ok_or("off"))
                })
                .collect::<Result<_, _>>()
                .expect("near the surface");
            let context = format!("seed {seed}, {} to {}", ends[0], ends[1]);
            let expected = plain.route_between(&mesh, PathAlgorithm::Exact, ends[0], ends[1]);
            let found = planner.route_among(&surface, PathAlgorithm::Exact, &places[0], &places[1]);
            let Ok(expected) = expected else {
                assert!(matches!(found, Err(SurfaceRouteError::Unreachable { .. })), "{context}");
                apart += 1;
                continue;
            };
            let (route, [i, k]) = found.expect(&context);
            assert!(
                (route.length - expected.length).abs() <= 1e-9 * (1.0 + expected.length),
                "{context}: {} and not {}",
                route.length,
                expected.length
            );
            let ends = [&places[0][i], &places[1][k]];
            check(&surface, &route, ends, &context);
            bent += usize::from(!route.corners.is_empty());
            for algorithm in PathAlgorithm::ALL {
                let other = planner.route(&surface, algorithm, ends[0], ends[1]).expect(&context);
                assert!(other.length >= route.length * (1.0 - 1e-9), "{context}, {algorithm}: {}", other.length);
                check(&surface, &other, ends, &format!("{context}, {algorithm}"));
            }
        }
    }
    assert!(bent > 50 && apart > 5, "{bent} bent, {apart} apart");
}

/// The shortest path through a row of triangles: they are laid flat side by side, corner by corner from the lengths of
/// their sides, and the path goes straight from end to end of the sides it passes, wherever that stays within the row.
/// Each side runs counter-clockwise round the triangle that is left by it.
fn through(portals: &[[Space; 2]], start: Space, goal: Space) -> f64 {
    type Flat = [f64; 2];
    let minus = |a: Flat, b: Flat| [a[0] - b[0], a[1] - b[1]];
    let cross = |a: Flat, b: Flat| a[0] * b[1] - a[1] * b[0];
    // Beside a side that is laid already: `hand` is 1 on its left, -1 on its right.
    let beside = |[a, b]: [Flat; 2], [p, q]: [Space; 2], r: Space, hand: f64| {
        let (length, to_p, to_q) = (far(p, q), far(p, r), far(q, r));
        let x = (length + (to_p - to_q) * (to_p + to_q) / length) / 2.0;
        let y = hand * ((to_p - x) * (to_p + x)).max(0.0).sqrt();
        let [ex, ey] = minus(b, a).map(|e| e / length);
        [a[0] + ex * x - ey * y, a[1] + ey * x + ex * y]
    };
    let mut flat: Vec<[Flat; 2]> = vec![[[0.0, 0.0], [far(portals[0][0], portals[0][1]), 0.0]]];
    for (i, portal) in portals.iter().enumerate().skip(1) {
        let (before, laid) = (portals[i - 1], flat[i - 1]);
        flat.push(portal.map(|p| match before.iter().position(|q| [p].contains(q)) {
            Some(k) => laid[k],
            None => beside(laid, before, p, -1.0),
        }));
    }
    let last = portals.len() - 1;
    // (place, the side it is on, or one before the first and after the last)
    let mut nodes: Vec<(Flat, isize)> = vec![(beside(flat[0], portals[0], start, 1.0), -1)];
    for (i, ends) in flat.iter().enumerate() {
        nodes.extend(ends.map(|end| (end, i as isize)));
    }
    nodes.push((beside(flat[last], portals[last], goal, -1.0), portals.len() as isize));
    let passes = |p: Flat, q: Flat, [a, b]: [Flat; 2]| {
        let (along, portal, off) = (minus(q, p), minus(b, a), minus(a, p));
        let whole = cross(along, portal);
        let share = -cross(along, off) / whole;
        let here = |end: Flat| [p, q].contains(&end);
        here(a) || here(b) || (-1e-12..=1.0 + 1e-12).contains(&share)
    };
    let mut least = vec![f64::INFINITY; nodes.len()];
    least[0] = 0.0;
    for j in 1..nodes.len() {
        for i in 0..j {
            let ((p, from), (q, to)) = (nodes[i], nodes[j]);
            if from < to && (from + 1..to).all(|k| passes(p, q, flat[k as usize])) {
                let [x, y] = minus(q, p);
                least[j] = least[j].min(least[i] + x.hypot(y));
            }
        }
    }
    least[nodes.len() - 1]
}

/// The shortest path of all, by every row of triangles without a triangle twice.
fn brute(points: &[Space], triangles: &[[u32; 3]], ends: [(usize, Space); 2]) -> Option<f64> {
    let mut search = Brute { points, triangles, ends, row: vec![ends[0].0], portals: Vec::new(), best: None };
    if ends[0].0 == ends[1].0 {
        return Some(far(ends[0].1, ends[1].1));
    }
    search.walk();
    search.best
}

struct Brute<'a> {
    points: &'a [Space],
    triangles: &'a [[u32; 3]],
    ends: [(usize, Space); 2],
    row: Vec<usize>,
    portals: Vec<[Space; 2]>,
    best: Option<f64>,
}

impl Brute<'_> {
    fn walk(&mut self) {
        let here = self.row[self.row.len() - 1];
        if here == self.ends[1].0 {
            let length = through(&self.portals, self.ends[0].1, self.ends[1].1);
            self.best = Some(self.best.map_or(length, |least| least.min(length)));
            return;
        }
        for k in 0..3 {
            let side = [self.triangles[here][k], self.triangles[here][(k + 1) % 3]];
            let has_twin = |t: &[u32; 3]| (0..3).any(|j| [t[(j + 1) % 3], t[j]] == side);
            let beyond = self.triangles.iter().position(has_twin).filter(|t| !self.row.contains(t));
            if let Some(beyond) = beyond {
                self.row.push(beyond);
                self.portals.push(side.map(|v| self.points[v as usize]));
                self.walk();
                self.row.pop();
                self.portals.pop();
            }
        }
    }
}

/// The triangles of a surface, and which of them has a place.
fn triangles_of(surface: &NavSurface) -> (Vec<Space>, Vec<[u32; 3]>) {
    let mut points: Vec<Space> = Vec::new();
    let mut number = |p: Space| {
        points.iter().position(|q| [p].contains(q)).unwrap_or_else(|| {
            points.push(p);
            points.len() - 1
        }) as u32
    };
    let triangles = surface.faces().flat_map(|f| surface.triangles(f)).map(|t| t.map(&mut number)).collect();
    (points, triangles)
}

#[test]
fn the_shortest_path_over_hills_is_that_of_the_best_row_of_all() {
    let mut planner = SurfacePlanner::new();
    let (mut compared, mut bent, mut turned) = (0, 0, 0);
    for seed in 0..40 {
        let mut random = Random::new(seed + 77);
        let map = Map::random(seed + 900, 3, 0.85, 0.5);
        // From gentle to steep.
        let rough = [0.3, 1.0, 3.0][seed as usize % 3];
        let heights: Vec<f64> = map.points.iter().map(|_| rough * random.unit()).collect();
        let points: Vec<Space> = map.points.iter().zip(&heights).map(|(p, &z)| [p.x, p.y, z]).collect();
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
        for _ in 0..3 {
            let triangles = [(); 2].map(|()| random.below(map.triangles.len()));
            let places = triangles.map(|t| {
                let p = map.inside(t, &mut random);
                surface.place([p.x, p.y], Floor::Any).expect("inside")
            });
            let context = format!("seed {seed}, {:?} to {:?}", places[0].point, places[1].point);
            let expected = brute(&points, &map.triangles, [0, 1].map(|i| (triangles[i], places[i].point)));
            let found = planner.route(&surface, PathAlgorithm::Exact, &places[0], &places[1]);
            let Some(expected) = expected else {
                assert!(found.is_err(), "{context}");
                continue;
            };
            let route = found.expect(&context);
            check(&surface, &route, [&places[0], &places[1]], &context);
            let difference = (route.length - expected) / expected;
            assert!(difference.abs() < 1e-9, "{context}: {} and not {expected}", route.length);
            compared += 1;
            bent += usize::from(!route.corners.is_empty());
            // Another way than the shortest one in the plan.
            turned += usize::from(route.faces.len() > 3);
            // The field from the start agrees with paths to vertices, seen from the other end.
            let field = planner.distance_field(&surface, &places[0], f64::INFINITY);
            let v = map.triangles[triangles[1]][0];
            let vertex =
                surface.places_on([points[v as usize][0], points[v as usize][1]], Floor::Any).expect("a vertex");
            let way = planner.route_among(&surface, PathAlgorithm::Exact, &vertex, &[places[0]]).expect(&context).0;
            let told = field.distance(VertexId::new(v)).expect(&context);
            assert!(is_close(told, way.length), "{context}: {told} to v{v}, and {} back", way.length);
        }
    }
    assert!(compared > 90 && bent > 10 && turned > 30, "{compared} compared, {bent} bent, {turned} long");
}

/// A ramp that winds up round a pillar: `turns` full turns of `steps` quadrilaterals each, `rise` a turn.
pub(crate) fn spiral(turns: usize, steps: usize, rise: f64) -> (Vec<Space>, Vec<Vec<u32>>) {
    let mut points = Vec::new();
    for i in 0..=turns * steps {
        let (sin, cos) = (i as f64 / steps as f64 * std::f64::consts::TAU).sin_cos();
        let z = rise * i as f64 / steps as f64;
        points.extend([[cos, sin, z], [3.0 * cos, 3.0 * sin, z]]);
    }
    let faces = (0..(turns * steps) as u32).map(|i| vec![2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2]).collect();
    (points, faces)
}

#[test]
fn a_spiral_ramp_is_split_into_its_turns_and_walked_from_the_bottom_to_the_top() {
    let (points, faces) = spiral(3, 12, 2.5);
    let ramp = NavSurface::new(&points, &list(&faces), None).expect("a surface");
    assert_eq!((ramp.layer_count(), ramp.component_count()), (3, 1));
    let at = [2.0, 0.3];
    let storeys = ramp.places(at);
    assert_eq!(storeys.iter().map(|place| place.layer).collect::<Vec<_>>(), [0, 1, 2]);
    assert!(
        matches!(ramp.place(at, Floor::Any), Err(SurfacePointError::Ambiguous { places, .. }) if places.len() == 3)
    );
    let below = ramp.place(at, Floor::Height(storeys[1].point[2] + 1.0)).expect("the middle one");
    assert_eq!(below, storeys[1]);
    assert_eq!(ramp.place(at, Floor::Layer(2)), Ok(storeys[2]));
    assert!(matches!(ramp.place(at, Floor::Layer(3)), Err(SurfacePointError::NotOnLayer { .. })));
    assert!(matches!(ramp.place(at, Floor::Height(-1.0)), Err(SurfacePointError::NothingBelow { .. })));
    assert!(matches!(ramp.place([9.0, 9.0], Floor::Any), Err(SurfacePointError::Off { .. })));
    let mut planner = SurfacePlanner::new();
    // The strip is the only row of triangles there is.
    let (corners, triangles) = triangles_of(&ramp);
    for (from, to) in [(0, 2), (2, 0), (0, 1), (1, 2)] {
        let [start, goal] = [storeys[from], storeys[to]];
        let route = planner.route(&ramp, PathAlgorithm::Exact, &start, &goal).expect("the ramp");
        check(&ramp, &route, [&start, &goal], &format!("{from} to {to}"));
        let has = |p: Space| {
            let off = |t: &[u32; 3]| off_triangle(p, t.map(|v| corners[v as usize]));
            (0..triangles.len()).min_by(|&a, &b| off(&triangles[a]).total_cmp(&off(&triangles[b]))).expect("triangles")
        };
        let ends = [start, goal].map(|place| (has(place.point), place.point));
        let expected = brute(&corners, &triangles, ends).expect("the strip");
        assert!(is_close(route.length, expected), "{} and not {expected}", route.length);
        let mut layers = route.layers.clone();
        layers.dedup();
        let between: Vec<usize> = if from < to { (from..=to).collect() } else { (to..=from).rev().collect() };
        assert_eq!(layers, between);
        // A turn round the pillar is longer than the pillar is round.
        assert!(route.length > 6.2 * from.abs_diff(to) as f64, "{}", route.length);
    }
}

#[test]
fn a_bridge_is_crossed_above_and_passed_below() {
    // A road from west to east on the ground; a bridge over it from south to north with a ramp at each end. The ground
    // reaches round the ramps, so both belong together.
    let ground = [[-6.0, -1.0], [6.0, -1.0], [6.0, 1.0], [-6.0, 1.0]];
    let mut points: Vec<Space> = ground.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    // The ramps stand on the ground beyond the road, at x from -1 to 1.
    let profile = [(-6.0, 0.0), (-2.0, 3.0), (2.0, 3.0), (6.0, 0.0)];
    for (y, z) in profile {
        points.extend([[-1.0, y, z], [1.0, y, z]]);
    }
    let faces = vec![vec![0, 1, 2, 3], vec![4, 5, 7, 6], vec![6, 7, 9, 8], vec![8, 9, 11, 10]];
    let bridge = NavSurface::new(&points, &list(&faces), None).expect("a surface");
    assert_eq!((bridge.layer_count(), bridge.component_count()), (2, 2));
    assert_eq!(bridge.faces().map(|f| bridge.layer(f)).collect::<Vec<_>>(), [Some(0), Some(1), Some(1), Some(1)]);
    let mut planner = SurfacePlanner::new();
    let place = |x: f64, y: f64, z: f64| bridge.place([x, y], Floor::Height(z)).expect("there");
    let above =
        planner.route(&bridge, PathAlgorithm::Exact, &place(0.0, -6.0, 0.0), &place(0.0, 6.0, 0.0)).expect("over it");
    assert!(is_close(above.length, 14.0), "5 up, 4 across, 5 down: {}", above.length);
    assert_eq!(above.points.len(), 4, "it bends in space where the slopes do: {:?}", above.points);
    assert_eq!(above.layers, [1, 1, 1]);
    let below =
        planner.route(&bridge, PathAlgorithm::Exact, &place(-6.0, 0.0, 1.0), &place(6.0, 0.0, 1.0)).expect("under it");
    assert_eq!((below.length, below.layers), (12.0, vec![0]));
    let error =
        planner.route(&bridge, PathAlgorithm::Exact, &place(0.0, 0.0, 9.0), &place(0.0, 0.0, 1.0)).expect_err("apart");
    assert!(matches!(error, SurfaceRouteError::Unreachable { start: 1, goal: 0, .. }), "{error}");
}

#[test]
fn a_path_over_a_hill_goes_round_it_where_that_is_shorter() {
    // A pyramid on a square: over the top it is long, over its sides shorter, and in the plan it would be straight.
    let points = [[0., 0., 0.], [4., 0., 0.], [4., 4., 0.], [0., 4., 0.], [2., 2., 6.]];
    let faces: Vec<Vec<u32>> = (0..4).map(|i| vec![i, (i + 1) % 4, 4]).collect();
    let hill = NavSurface::new(&points, &list(&faces), None).expect("a surface");
    let [start, goal] = [[0.0, 0.0], [4.0, 4.0]].map(|at| hill.place(at, Floor::Any).expect("a corner"));
    let route = SurfacePlanner::new().route(&hill, PathAlgorithm::Exact, &start, &goal).expect("a path");
    // Along the foot it is 8. Over two sides, unfolded round the top: both corners are as far from it as each other.
    let slant = (4.0f64 + 4.0 + 36.0).sqrt();
    let angle = 2.0 * (2.0 / slant).asin();
    let over = 2.0 * slant * angle.sin();
    assert!(over < 8.0 && is_close(route.length, over), "{} and not {over}", route.length);
    let steepest = hill.steepest().expect("faces").0;
    assert!(is_close(steepest, 3.0f64.atan().to_degrees()), "{steepest}");
}

#[test]
fn lengths_do_not_depend_on_where_and_how_large_the_surface_is() {
    let mut planner = SurfacePlanner::new();
    for seed in 0..12 {
        let map = Map::random(seed + 40, 6, 0.8, 0.5);
        let mut random = Random::new(seed + 5);
        let heights: Vec<f64> = map.points.iter().map(|_| random.unit()).collect();
        let at = |v: usize| [map.points[v].x, map.points[v].y, heights[v]];
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let ends = [(); 2].map(|()| map.inside(random.below(map.triangles.len()), &mut random));
        let mut lengths = Vec::new();
        // As it is, far away, small, large, and turned by a right angle.
        for (scale, shift, turned) in
            [(1.0, 0.0, false), (1.0, 65536.0, false), (2f64.powi(-20), 0.0, false), (2f64.powi(30), 0.0, true)]
        {
            let place = |[x, y, z]: Space| {
                let [x, y] = if turned { [0.0 - y, x] } else { [x, y] };
                [scale * x + shift, scale * y - shift, scale * z + shift]
            };
            let points: Vec<Space> = (0..map.points.len()).map(|v| place(at(v))).collect();
            let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
            let places = ends.map(|p| {
                let [x, y, _] = place([p.x, p.y, 0.0]);
                surface.place([x, y], Floor::Any).expect("inside")
            });
            let found = planner.route(&surface, PathAlgorithm::Exact, &places[0], &places[1]);
            lengths.push(found.map_or(f64::INFINITY, |route| route.length / scale));
        }
        for length in &lengths[1..] {
            let fine = length.is_infinite() == lengths[0].is_infinite();
            assert!(fine && (length.is_infinite() || (length - lengths[0]).abs() < 1e-8), "seed {seed}: {lengths:?}");
        }
    }
}

#[test]
fn a_large_flat_floor_costs_about_its_size_and_a_large_hill_not_its_square() {
    let mut planner = SurfacePlanner::new();
    let mut work = |size: usize, rough: f64| {
        let map = Map::random(3, size, 1.0, 0.3);
        let mut random = Random::new(8);
        let surface = lifted(&map, |p| [p.x, p.y, 0.0]);
        let surface =
            if rough > 0.0 { lifted(&map, |p| [p.x, p.y, rough * random_height(&mut random)]) } else { surface };
        let ends = [[0.7, 0.6], [size as f64 - 0.7, size as f64 - 0.9]];
        let places = ends.map(|at| surface.place(at, Floor::Any).expect("inside"));
        planner.route(&surface, PathAlgorithm::Exact, &places[0], &places[1]).expect("a path").work.pops
    };
    for rough in [0.0, 0.3] {
        let [small, large] = [16, 32].map(|size| work(size, rough));
        assert!(
            large < 10 * small + 1000,
            "{small} windows on n triangles, {large} on four times as many, rough {rough}"
        );
    }
}

fn random_height(random: &mut Random) -> f64 {
    random.unit()
}

#[test]
fn what_is_no_surface_is_refused_by_name() {
    let square: [Space; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let refuse = |points: &[Space], faces: &[Vec<u32>]| NavSurface::new(points, &list(faces), None).map(|_| ());
    assert_eq!(refuse(&square, &[]), Err(SurfaceError::NoFaces));
    assert_eq!(refuse(&square, &[vec![0, 1, 9]]), Err(SurfaceError::NoSuchVertex { face: 0, vertex: 9, count: 4 }));
    assert_eq!(refuse(&square, &[vec![0, 1, 2], vec![0, 3, 2]]), Err(SurfaceError::FacesDown { face: 1 }));
    assert!(matches!(refuse(&square, &[vec![0, 1, 1]]), Err(SurfaceError::Shape { face: 0, .. })));
    assert!(matches!(refuse(&square, &[vec![0, 1]]), Err(SurfaceError::Shape { face: 0, .. })));
    let bad = [[0., 0., 0.], [1., f64::NAN, 0.], [1., 1., 0.]];
    assert!(matches!(refuse(&bad, &[vec![0, 1, 2]]), Err(SurfaceError::Coordinate { vertex: 1, .. })));
    // Three walls at one edge; two faces on the same side of one.
    let tops: [Space; 5] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 1., 2.], [0., 1., 4.]];
    let fans = [vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4]];
    assert_eq!(refuse(&tops, &fans), Err(SurfaceError::ThreeAtEdge { faces: [0, 1, 2], edge: [0, 1] }));
    assert_eq!(refuse(&tops, &fans[..2]), Err(SurfaceError::SamePath { faces: [0, 1], edge: [0, 1] }));
}

#[test]
fn of_a_whole_house_the_floors_are_left_and_stairs_are_climbed_over_their_risers() {
    // A closed box, as a drawing program saves it: only its top faces up gently.
    let corner = |i: usize| [(i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64];
    let points: Vec<Space> = (0..8).map(corner).collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces: Vec<Vec<u32>> = faces.iter().map(|face| face.to_vec()).collect();
    let top = NavSurface::new(&points, &list(&faces), Some(45.0)).expect("the top");
    assert_eq!(top.faces().collect::<Vec<_>>(), [FaceId::new(2)]);
    assert_eq!(top.place([0.5, 0.5], Floor::Any).expect("on it").point.to_vec(), [0.5, 0.5, 1.0]);
    // Three steps, 1 deep and 0.5 high, with upright risers; nobody stands on a riser, so the goal is below the last one.
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for i in 0..7 {
        let (x, z) = (f64::from((i + 1) / 2), 0.5 * f64::from(i / 2));
        points.extend([[x, 0.0, z], [x, 2.0, z]]);
    }
    for i in 0..6u32 {
        faces.push(vec![2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
    }
    let stairs = NavSurface::new(&points, &list(&faces), None).expect("a stair");
    assert_eq!((stairs.layer_count(), stairs.component_count()), (1, 1));
    let [start, goal] = [[0.0, 1.0], [3.0, 1.0]].map(|at| *stairs.places(at).last().expect("there"));
    let route = SurfacePlanner::new().route(&stairs, PathAlgorithm::Exact, &start, &goal).expect("up the stair");
    assert!(is_close(route.length, 3.0 + 1.0), "{}", route.length);
    assert_eq!(stairs.steepest().map(|(slope, _)| slope), Some(90.0));
    // Without the risers there is no stair.
    let treads = NavSurface::new(&points, &list(&faces), Some(60.0)).expect("treads");
    assert_eq!(treads.component_count(), 3);
}

#[test]
fn costs_lead_a_path_round_what_is_dear() {
    // Two ways round a square hole; the upper one is a little longer, the lower one is mud.
    let points: Vec<Space> = [(0., 0.), (6., 0.), (6., 6.), (0., 6.), (2., 1.9), (4., 1.9), (4., 4.), (2., 4.)]
        .map(|(x, y)| [x, y, 0.1 * x])
        .to_vec();
    let faces: Vec<Vec<u32>> = (0..4u32).map(|i| vec![i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]).collect();
    let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
    let [start, goal] = [[1.0, 2.9], [5.0, 2.9]].map(|at| surface.place(at, Floor::Any).expect("there"));
    let mut planner = SurfacePlanner::new();
    let plain = planner.route(&surface, PathAlgorithm::Exact, &start, &goal).expect("a path");
    assert!(plain.faces.contains(&FaceId::new(1)) && plain.cost.to_bits() == plain.length.to_bits());
    let mut costs = FaceMap::filled(surface.face_bound(), 1.0);
    costs[FaceId::new(1)] = 4.0;
    let round = planner.weighted_route(&surface, PathAlgorithm::Closest, &costs, &start, &goal).expect("a path");
    assert!(round.faces.contains(&FaceId::new(3)) && !round.faces.contains(&FaceId::new(1)), "{:?}", round.faces);
    assert!(is_close(round.cost, round.length));
    costs = FaceMap::filled(surface.face_bound(), 2.5);
    let all = planner.weighted_route(&surface, PathAlgorithm::Closest, &costs, &start, &goal).expect("a path");
    assert!(is_close(all.cost, 2.5 * all.length));
}

#[test]
fn polygons_of_many_corners_are_one_face_and_have_the_lengths_of_the_plane() {
    // An L with a corner that is not convex, tilted: five corners in one face.
    let flat = [(0., 0.), (4., 0.), (4., 1.), (1., 1.), (1., 4.), (0., 4.)].map(Point::from);
    let points: Vec<Space> = flat.iter().map(|p| [p.x, 0.6 * p.y, 0.8 * p.y]).collect();
    let surface = NavSurface::new(&points, &list(&[vec![0, 1, 2, 3, 4, 5]]), None).expect("a surface");
    assert_eq!((surface.faces().count(), surface.triangle_count()), (1, 4));
    assert!(is_close(surface.area(), 7.0));
    let outline: Vec<_> = surface.outline(FaceId::new(1)).collect();
    assert!(outline.len() == 6 && outline.iter().all(|(_, beyond)| beyond.is_none()));
    let [start, goal] = [[4.0, 0.3], [0.5, 2.4]].map(|at| surface.place(at, Floor::Any).expect("there"));
    let route = SurfacePlanner::new().route(&surface, PathAlgorithm::Exact, &start, &goal).expect("a path");
    assert_eq!((route.faces.len(), route.corners.as_slice()), (1, [VertexId::new(3)].as_slice()));
    let mut map = Subdivision::polygon(&flat).expect("an L");
    map.triangulate(dcel_kit::plane::TriangulationMethod::default()).expect("triangles");
    let mesh = NavMesh::new(&map).expect("a mesh");
    let plain = Planner::new().route_between(&mesh, PathAlgorithm::Exact, Point::new(4.0, 0.5), Point::new(0.5, 4.0));
    assert!(is_close(route.length, plain.expect("a way").length));
}

#[test]
fn the_nearest_place_is_that_of_a_look_at_every_triangle() {
    for seed in 0..20 {
        let map = Map::random(seed + 300, 6, 0.6, 0.5);
        let mut heights = Random::new(seed);
        let surface = lifted(&map, |p| [p.x, p.y, 2.0 * heights.unit()]);
        let mut random = Random::new(seed + 1);
        for round in 0..60 {
            let size = [6.0, 30.0, 1e6][round % 3];
            let at = [(); 2].map(|()| (random.unit() - 0.3) * size);
            let closest = |[a, b]: [Space; 2]| {
                let [x, y] = [b[0] - a[0], b[1] - a[1]];
                let share = (((at[0] - a[0]) * x + (at[1] - a[1]) * y) / (x * x + y * y)).clamp(0.0, 1.0);
                (a[0] + share * x - at[0]).hypot(a[1] + share * y - at[1])
            };
            let is_inside = surface.place(at, Floor::Any).is_ok();
            let sides =
                surface.faces().flat_map(|f| surface.triangles(f)).flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
            let least = if is_inside { 0.0 } else { sides.map(closest).fold(f64::INFINITY, f64::min) };
            let (place, distance) = surface.nearest(at, Floor::Any).expect("finite");
            assert!((distance - least).abs() <= 1e-9 * (1.0 + least), "seed {seed}: {at:?}: {distance}, and {least}");
            assert!(((place.point[0] - at[0]).hypot(place.point[1] - at[1]) - distance).abs() <= 1e-9 * (1.0 + least));
        }
    }
}

/// Laid flat, a surface has the costs of the plane; by one cost for all it is exact.
#[test]
fn costs_on_a_surface_that_can_be_laid_flat_are_those_of_the_plane() {
    let (mut planner, mut plain) = (SurfacePlanner::new(), Planner::new());
    for seed in 0..10 {
        let map = Map::random(seed + 700, 6, 0.85, 0.5);
        let (mesh, surface) = (map.mesh(), lifted(&map, |p| [0.6 * p.x, p.y, 0.8 * p.x]));
        let mut random = Random::new(seed);
        let from = map.inside(random.below(map.triangles.len()), &mut random);
        let (Ok(place), Ok(start)) = (mesh.place(from), surface.place([0.6 * from.x, from.y], Floor::Any)) else {
            continue;
        };
        let mut costs = FaceMap::filled(mesh.face_bound(), 2.0);
        for round in 0..2 {
            let flat = plain.weighted_distance_field(&mesh, &costs, &[], &place, f64::INFINITY).expect("no links");
            let field =
                planner.weighted_distance_field(&surface, &costs, &[], &start, f64::INFINITY).expect("no links");
            for v in (0..map.points.len() as u32).map(VertexId::new) {
                match (flat.distance(v), field.distance(v)) {
                    (Some(one), Some(other)) => {
                        assert!((one - other).abs() < 1e-9 * (1.0 + one), "seed {seed}, {round}: {v}");
                    }
                    (one, other) => assert_eq!(one, other, "seed {seed}, {round}: {v}"),
                }
            }
            mesh.faces().for_each(|f| costs[f] = 1.0 + 3.0 * random.unit());
        }
    }
}
