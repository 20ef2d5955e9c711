//! Paths through a navmesh: the funnel portal by portal, the cones of the exact search one by one.

use super::{numbered, shown};
use crate::figure::SketchFilm;
use crate::figure::navmesh::Floor;
use crate::figure::sketch::Backdrop;
use crate::navmesh::{Cone, NavMesh, Route};
use crate::plane::Subdivision;

/// The film of the funnel through the corridor of a route: a frame for each portal and one for the goal, at most `most` of
/// them.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
/// use dcel_kit::plane::{Point, Subdivision};
/// let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from).to_vec();
/// let map = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
/// let mesh = NavMesh::new(&map)?;
/// let [start, goal] = [(1.5, 0.5), (0.5, 1.5)].map(Point::from);
/// let route = Planner::new().route_between(&mesh, PathAlgorithm::Exact, start, goal)?;
/// let film = algorithms::funnel(&map, &mesh, &route, 40);
/// assert_eq!(film.len(), route.portals.len() + 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn funnel(map: &Subdivision, mesh: &NavMesh, route: &Route, most: usize) -> SketchFilm {
    let floor = Floor::new(map, mesh);
    let panels = floor.funnel_panels(route);
    let mut film = SketchFilm::new();
    film.quiet();
    let kept = shown(panels.len(), most);
    for (i, (heading, text, sketch)) in panels.into_iter().enumerate() {
        if kept.binary_search(&i).is_ok() {
            film.over(&heading, &text, map, Backdrop::Dimmed, sketch);
        }
    }
    film
}

/// The film of an exact search: a frame for each cone in the order in which the search met them, at most `most` of them, and
/// the path that was found.
///
/// The cones are those of [`Planner::cones`](crate::navmesh::Planner::cones).
#[must_use]
pub fn cones(map: &Subdivision, mesh: &NavMesh, cones: &[Cone], route: &Route, most: usize) -> SketchFilm {
    let floor = Floor::new(map, mesh);
    let mut film = SketchFilm::new();
    film.quiet();
    for (i, number) in numbered(cones.len(), most) {
        let (heading, text, sketch) = floor.cone_panel(cones, i, route, &number);
        film.over(&heading, &text, map, Backdrop::Dimmed, sketch);
    }
    let (heading, text, sketch) = floor.path_panel(cones.len(), route);
    film.over(&heading, &text, map, Backdrop::Dimmed, sketch);
    film
}
