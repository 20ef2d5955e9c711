//! The reference figures of lab 06.

use super::{Made, dots};
use dcel_kit::HalfEdgeId;
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Role, Sketch};
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner, Route};
use dcel_kit::plane::{Point, Subdivision};
use dcel_lab::cases::handouts::{GOAL, MAP, MAP_TRIANGLES, START};

/// The edges inside of it.
const INSIDE: [[u32; 2]; 13] =
    [[0, 2], [2, 9], [2, 8], [2, 7], [3, 7], [4, 7], [4, 12], [4, 11], [5, 11], [6, 11], [6, 10], [7, 10], [7, 12]];

/// The map.
pub(in crate::gallery) fn map() -> Made<Subdivision> {
    let points: Vec<Point> = MAP.iter().map(|&p| p.into()).collect();
    let border = (0..10).map(|v| [v, (v + 1) % 10]);
    let pillar = [[10, 11], [11, 12], [12, 10]];
    let edges: Vec<[u32; 2]> = border.chain(pillar).chain(INSIDE).collect();
    let mut map = Subdivision::from_graph(&points, &edges)?;
    map.mark_holes(&[Point::new(188.0, -2.0)])?;
    Ok(map)
}

/// The map, and the path through as few triangles as possible.
fn path() -> Made<(Subdivision, Route)> {
    let map = map()?;
    let mesh = NavMesh::new(&map)?;
    let route = Planner::new().route_between(&mesh, PathAlgorithm::Breadth, START.into(), GOAL.into())?;
    Ok((map, route))
}

/// Where a half-edge begins.
fn place(map: &Subdivision, h: HalfEdgeId) -> Point {
    map.point(map.origin(h))
}

/// The picture that lab 06 asks for: corridor and path.
pub(in crate::gallery) fn corridor(options: &FigureOptions) -> Made<String> {
    let (map, route) = path()?;
    let mut sketch = Sketch::new();
    for &f in &route.faces {
        sketch.region(Role::Main, [map.incident_vertices(f).map(|v| map.point(v)).collect::<Vec<_>>()]).plain();
    }
    for edge in map.edges() {
        sketch.path(Role::Plain, edge.half_edges().map(|h| place(&map, h)));
    }
    sketch.path(Role::Goal, route.points.iter().copied()).solid();
    dots(&mut sketch, Role::Plain, route.points);
    Ok(sketch.figure(options)?.to_svg())
}

/// The portals of the corridor, with their left and right ends, over the map.
pub(in crate::gallery) fn portals(options: &FigureOptions) -> Made<String> {
    let (map, route) = path()?;
    let mut sketch = Sketch::new();
    for (t, triangle) in MAP_TRIANGLES.iter().enumerate() {
        let corners = triangle.map(|v| MAP[v]);
        let centre = [0, 1].map(|axis| corners.iter().map(|p| p[axis]).sum::<f64>() / 3.0);
        sketch.region(Role::Plain, [corners]).plain();
        sketch.path(Role::Plain, [corners[0], corners[1], corners[2], corners[0]]);
        sketch.text(Role::Dimmed, centre, format!("f{}", t + 1));
    }
    for &h in &route.portals {
        // A face is on the left of its half-edges: who leaves it sees the end on the left.
        let portal = sketch.portal(Role::Secondary, place(&map, h.twin()), place(&map, h));
        portal.key("portals: seen by one who goes through, the left end is a square, the right one a ring");
    }
    sketch.path(Role::Main, route.points.iter().copied()).arrow().key("the shortest path in the corridor");
    sketch.point(Role::Start, START).label("start");
    sketch.point(Role::Goal, GOAL).label("goal");
    Ok(sketch.figure(options)?.to_svg())
}
