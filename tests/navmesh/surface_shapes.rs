//! What surfaces are made of: polygons that are not convex, and polygons that do not fit, which are named. And how much work
//! a rough one is.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use crate::surface::list;
use dcel_kit::navmesh::{Floor, NavSurface, SurfaceError, SurfacePlanner};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;

type Space = [f64; 3];

/// Twice the area of a polygon in the plan.
fn shoelace(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.x * b.y - a.y * b.x).sum()
}

/// A quadrilateral with a corner that is not convex has one cut inside it only.
#[test]
fn four_corners_are_cut_inside_wherever_one_of_them_is_not_convex() {
    let mut random = Random::new(61);
    let (mut dents, mut convex) = (0, 0);
    for round in 0..600 {
        let mut at = || Point::new(random.unit(), random.unit());
        let [a, b, c] = [at(), at(), at()];
        let [a, b, c] = if orientation(a, b, c).is_gt() { [a, b, c] } else { [a, c, b] };
        // Inside the triangle, or beyond one of its sides.
        let [u, v] = [0.05 + 0.4 * random.unit(), [1.0, -1.0][round % 2] * (0.05 + 0.4 * random.unit())];
        let d = Point::new(a.x + (b.x - a.x) * v + (c.x - a.x) * u, a.y + (b.y - a.y) * v + (c.y - a.y) * u);
        let mut ring = [a, b, c, d];
        ring.rotate_left(round / 2 % 4);
        let turns = (0..4).map(|i| orientation(ring[i], ring[(i + 1) % 4], ring[(i + 2) % 4]));
        let left = turns.filter(|turn| turn.is_gt()).count();
        if left < 3 || shoelace(&ring) < 0.05 {
            continue;
        }
        *if left == 3 { &mut dents } else { &mut convex } += 1;
        let [slope_x, slope_y] = [(); 2].map(|()| 4.0 * random.unit() - 2.0);
        let points = ring.map(|p| [p.x, p.y, slope_x * p.x + slope_y * p.y]);
        let surface = NavSurface::new(&points, &list(&[vec![0, 1, 2, 3]]), None);
        let surface = surface.unwrap_or_else(|error| panic!("round {round}: {error}: {ring:?}"));
        let area = shoelace(&ring) / 2.0 * (1.0 + slope_x * slope_x + slope_y * slope_y).sqrt();
        assert!(is_close(surface.area(), area), "round {round}: {} and not {area}: {ring:?}", surface.area());
        assert_eq!(surface.triangle_count(), 2, "round {round}");
    }
    assert!(dents > 100 && convex > 100, "{dents} with a dent, {convex} without");
}

#[test]
fn what_an_error_names_are_the_polygons_and_the_points_where_it_is() {
    let (mut same, mut three) = (0, 0);
    for seed in 0..40 {
        let mut random = Random::new(seed + 62);
        let map = Map::random(seed + 63, 4, 0.9, 0.4);
        let points: Vec<Space> = map.points.iter().map(|p| [p.x, p.y, random.unit()]).collect();
        let mut faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        // One more triangle on a side that some other ones have, to a point of its own.
        let face = faces[random.below(faces.len())].clone();
        let k = random.below(3);
        let (a, b) = (face[k], face[(k + 1) % 3]);
        let apex = points.len() as u32;
        let [p, q] = [a, b].map(|v| points[v as usize]);
        let above = [p[0] - 0.3 * (q[1] - p[1]), p[1] + 0.3 * (q[0] - p[0]), 2.0];
        faces.push(vec![a, b, apex]);
        let points: Vec<Space> = points.iter().copied().chain([above]).collect();
        let error = NavSurface::new(&points, &list(&faces), None).map(|_| ()).expect_err("two on one side of an edge");
        let mut named = error.vertices();
        named.sort_unstable();
        assert_eq!(named, [a.min(b), a.max(b)], "seed {seed}: {error}");
        // All polygons that it names have both, and the new one is not the only one that has.
        let has_edge = |f: u32| [a, b].iter().all(|v| faces[f as usize].contains(v));
        let told = error.faces();
        assert!(told.len() > 1 && told.iter().all(|&f| has_edge(f)), "seed {seed}: {error}");
        match error {
            SurfaceError::SamePath { .. } => same += 1,
            SurfaceError::ThreeAtEdge { .. } => three += 1,
            other => panic!("seed {seed}: {other}"),
        }
    }
    assert!(same > 5 && three > 5, "{same} of two polygons, {three} of three");
    // A point alone, a polygon alone, and neither.
    let mut points = vec![[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let parts = |points: &[Space], faces: &[Vec<u32>]| {
        let error = NavSurface::new(points, &list(faces), None).map(|_| ()).expect_err("no surface");
        (error.faces(), error.vertices())
    };
    assert_eq!(parts(&points, &[]), (vec![], vec![]));
    assert_eq!(parts(&points, &[vec![0, 1, 2], vec![0, 3, 2]]), (vec![1], vec![]));
    points[3][1] = f64::INFINITY;
    assert_eq!(parts(&points, &[vec![0, 1, 2]]), (vec![], vec![3]));
}

/// On rough ground most windows are outdone by paths round vertices: a field takes work in proportion to the surface, or
/// little more.
#[test]
fn a_field_over_rough_ground_takes_about_as_many_windows_as_there_are_triangles() {
    let work = |size: usize| {
        let map = Map::random(3, size, 1.0, 0.3);
        let mut random = Random::new(8);
        let points: Vec<Space> = map.points.iter().map(|p| [p.x, p.y, 1.5 * random.unit()]).collect();
        let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
        let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
        let start = surface.place([0.7, 0.6], Floor::Any).expect("inside");
        SurfacePlanner::new().distance_field(&surface, &start, f64::INFINITY).work.pops
    };
    let [small, middle, large] = [12, 24, 48].map(work);
    assert!(
        middle < 7 * small && large < 7 * middle,
        "{small}, {middle} and {large} on four times as many triangles each"
    );
}
