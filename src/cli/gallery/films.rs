//! Films of algorithms, of the shapes that the labs work on where there is one.

use super::Made;
use super::labs::{lab_02, lab_06, lab_11};
use super::lesson;
use dcel_kit::FaceId;
use dcel_kit::figure::{FigureOptions, algorithms};
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::solid::{Direction, Platonic, Polyhedron, Selection};
use dcel_kit::sources;
use dcel_lab::cases::handouts;

/// One split of a face, and what a wrong next makes of it.
pub(super) fn slip(options: &FigureOptions) -> Made<String> {
    Ok(super::film(sources::SPLIT_FACE)?.beside(&["h13.next = h8".parse()?])?.strip(options)?.to_svg())
}

/// A face of the lab's subdivision, half-edge by half-edge.
pub(super) fn face_walk(options: &FigureOptions) -> Made<String> {
    let film = algorithms::face_walk(&lesson::lab_subdivision()?, FaceId::new(1), 40)?;
    Ok(film.strip(options)?.to_svg())
}

/// The polygon of lab 02.
pub(super) fn ears(options: &FigureOptions) -> Made<String> {
    let polygon = Subdivision::polygon(&lab_02::corners())?;
    Ok(algorithms::ear_clipping(&polygon, 10)?.strip(options)?.to_svg())
}

/// A polygon with corners of all kinds.
pub(super) fn monotone(options: &FigureOptions) -> Made<String> {
    let corners =
        [(0., 2.), (4., 0.), (9., 3.), (13., 1.), (11., 5.), (14., 8.), (8., 6.), (5., 9.), (6., 5.), (2., 7.)];
    let polygon = Subdivision::polygon(&corners.map(Point::from))?;
    Ok(algorithms::monotone(&polygon, 40)?.strip(options)?.to_svg())
}

/// The points of lab 03.
pub(super) fn hull(options: &FigureOptions) -> Made<String> {
    let points = handouts::POINTS.map(Point::from);
    Ok(algorithms::convex_hull(&points, 12)?.strip(options)?.to_svg())
}

/// Four segments.
pub(super) fn sweep(options: &FigureOptions) -> Made<String> {
    let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
    let segments =
        [segment(0., 1., 12., 8.), segment(1., 6., 11., 1.), segment(3., 9., 10., 6.), segment(8., 9., 10., 0.)];
    Ok(algorithms::segment_sweep(&segments, 40)?.strip(options)?.to_svg())
}

/// A fan, until it is Delaunay.
pub(super) fn flips(options: &FigureOptions) -> Made<String> {
    let points = [(0., 4.), (3., 0.), (8., -1.), (12., 1.), (13., 5.), (9., 8.), (4., 8.)].map(Point::from).to_vec();
    let triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6]];
    let given = Subdivision::from_triangles(points, &triangles)?;
    Ok(algorithms::lawson_flips(&given, |_| false, 40).strip(options)?.to_svg())
}

/// The sites of lab 08.
pub(super) fn voronoi(options: &FigureOptions) -> Made<String> {
    let delaunay = Subdivision::delaunay(&handouts::SITES.map(Point::from))?.subdivision;
    Ok(algorithms::voronoi(&delaunay, 6)?.strip(options)?.to_svg())
}

/// The map of lab 06, from a corner of it.
pub(super) fn locate(options: &FigureOptions) -> Made<String> {
    let map = lab_06::map()?;
    let start = map.vertices().next().ok_or("the map has vertices")?;
    Ok(algorithms::location_walk(&map, start, Point::from(handouts::GOAL), 40)?.strip(options)?.to_svg())
}

/// The path of lab 06.
pub(super) fn funnel(options: &FigureOptions) -> Made<String> {
    let map = lab_06::map()?;
    let mesh = NavMesh::new(&map)?;
    let ends = [handouts::START, handouts::GOAL].map(Point::from);
    let route = Planner::new().route_between(&mesh, PathAlgorithm::Breadth, ends[0], ends[1])?;
    Ok(algorithms::funnel(&map, &mesh, &route, 12).strip(options)?.to_svg())
}

/// The gem of lab 11.
pub(super) fn climb(options: &FigureOptions) -> Made<String> {
    let points = handouts::GEM.to_vec();
    let gem = Polyhedron::convex_hull(&points, dcel_kit::solid::HullFaces::Triangles)?.solid;
    let convex = gem.check_convex()?;
    let start = gem.vertices().next().ok_or("the gem has vertices")?;
    let film = algorithms::hill_climbing(&gem, &convex, Direction::try_from(lab_11::DIRECTION)?, start, 40);
    Ok(film.strip(options)?.to_svg())
}

/// Eight points.
pub(super) fn solid_hull(options: &FigureOptions) -> Made<String> {
    let points = [
        [0., 0., 0.],
        [6., 0., 1.],
        [1., -6., 0.],
        [1., -1., 5.],
        [2., -2., 2.],
        [5., -5., 4.],
        [7., -4., 0.],
        [3., -2., 7.],
    ];
    Ok(algorithms::convex_hull_in_space(&points, 40)?.strip(options)?.to_svg())
}

/// A cube that becomes rounder.
pub(super) fn catmull_clark(options: &FigureOptions) -> Made<String> {
    let cube = Polyhedron::platonic(Platonic::Cube);
    Ok(algorithms::catmull_clark(&cube, &Selection::new(), 2)?.strip(options)?.to_svg())
}
