//! Paths on surfaces from and to points on edges, on borders and at vertices: as long there as back, as their own points
//! say, and no longer than by way of a vertex beside the goal.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use crate::surface::{check, far, list};
use dcel_kit::VertexId;
use dcel_kit::navmesh::{Floor, NavSurface, PathAlgorithm, SurfacePlanner, SurfacePoint};
use dcel_kit::plane::Point;

type Space = [f64; 3];

/// The exact route between points of the plan, checked.
fn route(surface: &NavSurface, ends: [[f64; 2]; 2], context: &str) -> Option<(f64, Vec<Space>)> {
    let places = ends.map(|at| surface.places_on(at, Floor::Any).expect(context));
    let found = SurfacePlanner::new().route_among(surface, PathAlgorithm::Exact, &places[0], &places[1]);
    let (route, [i, k]) = found.ok()?;
    check(surface, &route, [&places[0][i], &places[1][k]], context);
    Some((route.length, route.points))
}

#[test]
fn a_goal_inside_an_edge_is_not_overshot() {
    let points = [
        [195., -63., 16.],
        [195., -151., 92.],
        [260., -63., 16.],
        [260., -126., 32.],
        [260., -151., 92.],
        [260., -207., 125.],
        [325., -126., 32.],
        [325., -151., 92.],
        [325., -207., 125.],
    ];
    let faces: [[u32; 3]; 7] = [[0, 3, 2], [1, 5, 4], [2, 3, 6], [3, 4, 7], [3, 7, 6], [4, 5, 8], [4, 8, 7]];
    let surface = NavSurface::new(&points, &list(&faces.map(|face| face.to_vec())), None).expect("a surface");
    let [start, goal] = [[230., -63.], [260., -165.]];
    let (length, path) = route(&surface, [start, goal], "there").expect("joined");
    let (back, _) = route(&surface, [goal, start], "back").expect("joined");
    let by_vertex = [points[2], points[3], points[4], [260., -165., 100.25]];
    assert_eq!(path[1..], by_vertex[1..]);
    let expected = far([230., -63., 16.], points[3]) + far(points[3], points[4]) + far(points[4], by_vertex[3]);
    assert!(is_close(length, expected) && is_close(back, expected), "{length}, {back} and not {expected}");
}

#[test]
fn there_and_back_are_equally_long_from_edges_borders_and_vertices() {
    let (mut compared, mut bent, mut by_vertices) = (0, 0, 0);
    for seed in 0..120 {
        let mut random = Random::new(seed + 4400);
        // Corners on a lattice, so that parts of edges by eighths are exactly on them.
        let jitter = if seed % 3 == 0 { 0.0 } else { 0.5 };
        let lattice = |p: Point| Point::new((p.x * 64.0).round() / 64.0, (p.y * 64.0).round() / 64.0);
        let map = Map::random(seed + 7000, 4, 0.75, jitter).moved(lattice);
        // Rough, in few steps, or a roof: many edges are on one line there.
        let lift = |p: Point, random: &mut Random| match seed % 4 {
            0 => (p.x - 2.0).abs(),
            1 => random.below(3) as f64 * 0.5,
            _ => random.unit() * 3.0,
        };
        let points: Vec<Space> = map.points.iter().map(|&p| [p.x, p.y, lift(p, &mut random)]).collect();
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let Ok(surface) = NavSurface::new(&points, &list(&faces), None) else { continue };
        for _ in 0..8 {
            let ends = [(); 2].map(|()| {
                let corners = map.corners(random.below(map.triangles.len()));
                let [a, b] = [corners[0], corners[1 + random.below(2)]];
                let share = random.below(9) as f64 / 8.0;
                [a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share]
            });
            let context = format!("seed {seed}, {:?} to {:?}", ends[0], ends[1]);
            let there = route(&surface, ends, &context);
            let back = route(&surface, [ends[1], ends[0]], &context);
            let (Some((there, path)), Some((back, _))) = (&there, &back) else {
                assert_eq!(there.is_some(), back.is_some(), "{context}");
                continue;
            };
            assert!(is_close(*there, *back), "{context}: {there}, and {back} back");
            let [starts, goals]: [Vec<SurfacePoint>; 2] =
                ends.map(|at| surface.places_on(at, Floor::Any).expect(&context));
            let mut planner = SurfacePlanner::new();
            for algorithm in PathAlgorithm::ALL {
                let other = planner.route_among(&surface, algorithm, &starts, &goals).expect(&context);
                let (other, [i, k]) = other;
                assert!(other.length >= there * (1.0 - 1e-9), "{context}, {algorithm}: {}", other.length);
                check(&surface, &other, [&starts[i], &goals[k]], &format!("{context}, {algorithm}"));
            }
            // By way of a vertex of a face at the goal.
            for (start, goal) in starts.iter().flat_map(|start| goals.iter().map(move |goal| (start, goal))) {
                let field = planner.distance_field(&surface, start, f64::INFINITY);
                // Nobody passes a vertex where faces touch.
                let is_passable = |at: Space| surface.places([at[0], at[1]]).len() == 1;
                for (v, at) in surface.vertices(goal.face).filter(|&(_, at)| is_passable(at)) {
                    let Some(length) = field.distance(v) else { continue };
                    let by_vertex = length + far(at, goal.point);
                    assert!(*there <= by_vertex * (1.0 + 1e-9), "{context}: {there}, and {by_vertex} by {v}");
                }
            }
            compared += 1;
            bent += usize::from(path.len() > 2);
            by_vertices += usize::from(path[1..path.len() - 1].iter().any(|p| points.contains(p)));
        }
    }
    assert!(compared > 400 && bent > 200 && by_vertices > 100, "{compared}, {bent} bent, {by_vertices} by vertices");
}

#[test]
fn distances_from_a_start_very_near_a_vertex_are_right_to_the_last_digits() {
    let points = [
        [1., 0., 5.],
        [3., 1., 6.],
        [-1., 5., 4.],
        [3., 5., 6.],
        [0., 9., 5.],
        [3., 8., 3.],
        [1., 12., 0.],
        [5., 13., 2.],
    ];
    let faces: [[u32; 3]; 6] = [[0, 1, 3], [0, 3, 2], [2, 3, 4], [3, 5, 4], [4, 5, 7], [4, 7, 6]];
    // To v2, computed with 40 digits.
    for (count, start, expected) in [
        (2, [1.000_000_029_802_322_4, 4.470_348_358_154_297e-8], 5.477_225_547_845_988),
        (6, [1.000_000_003_725_290_3, 5.587_935_447_692_871e-9], 5.477_225_571_650_952),
    ] {
        let faces: Vec<Vec<u32>> = faces[..count].iter().map(|face| face.to_vec()).collect();
        let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
        let place = surface.place(start, Floor::Any).expect("on it");
        let field = SurfacePlanner::new().distance_field(&surface, &place, f64::INFINITY);
        let told = field.distance(VertexId::new(2)).expect("joined");
        assert!((told - expected).abs() < 1e-10, "{start:?}: {told} and not {expected}");
    }
}

/// From starts ever nearer to a vertex: a field says what paths say that are pulled straight, and no more and no less
/// than from the vertex itself but for the way to it.
#[test]
fn fields_and_paths_from_ever_nearer_to_a_vertex_are_equally_long() {
    let mut compared = 0;
    for seed in 0..60 {
        let mut random = Random::new(seed + 9100);
        // Far from the origin points have fewer digits beside a vertex.
        let shift = [0.0, 700.0][seed as usize % 2];
        let map = Map::random(seed + 9300, 3, 0.9, 0.5).moved(|p| Point::new(p.x + shift, p.y - shift));
        let points: Vec<Space> = map.points.iter().map(|p| [p.x, p.y, 2.0 * random.unit()]).collect();
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let Ok(surface) = NavSurface::new(&points, &list(&faces), None) else { continue };
        let mut planner = SurfacePlanner::new();
        for exponent in 3..13 {
            let t = random.below(map.triangles.len());
            let [a, b, c] = map.corners(t);
            let share = 10f64.powi(-exponent) * (0.5 + random.unit());
            let part = random.unit();
            let step = |a: f64, b: f64, c: f64| a + share * (part * (b - a) + (1.0 - part) * (c - a));
            let Ok(start) = surface.place([step(a.x, b.x, c.x), step(a.y, b.y, c.y)], Floor::Any) else { continue };
            let corner = map.triangles[t][0] as usize;
            let near = far(start.point, points[corner]);
            let field = planner.distance_field(&surface, &start, f64::INFINITY);
            let context = format!("seed {seed}, {near:e} from v{corner}, {:?}", start.point);
            // From the vertex, if nobody has to say from which side of it.
            let from_corner = match surface.places([a.x, a.y]).as_slice() {
                [corner] => Some(planner.distance_field(&surface, corner, f64::INFINITY)),
                _ => None,
            };
            for (v, p) in (0..).map(VertexId::new).zip(&points) {
                let Some(told) = field.distance(v) else { continue };
                let goals = surface.places([p[0], p[1]]);
                let path = planner.route_among(&surface, PathAlgorithm::Exact, &[start], &goals);
                let path = path.expect(&context).0.length;
                assert!((told - path).abs() <= 1e-10 * told, "{context}: {told} to {v}, and {path} by a path");
                let back = planner.route_among(&surface, PathAlgorithm::Exact, &goals, &[start]);
                let back = back.expect(&context).0.length;
                assert!((told - back).abs() <= 1e-10 * told, "{context}: {told} to {v}, and {back} back");
                if let Some(from_corner) = from_corner.as_ref().and_then(|field| field.distance(v)) {
                    let off = (told - from_corner).abs();
                    assert!(
                        off <= near + 1e-12 * (told + shift),
                        "{context}: {told} to {v}, and {from_corner} from the vertex"
                    );
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 3000, "{compared} compared");
}
