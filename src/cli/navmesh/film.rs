//! Films of paths, for `dcel film`.

use super::super::failure::Failure;
use super::super::film::Refused;
use super::ends::{Snap, Wish};
use super::reading::MapArgs;
use dcel_kit::figure::{SketchFilm, algorithms};
use dcel_kit::navmesh::{Cone, PathAlgorithm, Planner};
use std::path::Path;

/// What is filmed of a path.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum PathFilm {
    /// The funnel, portal by portal.
    Funnel,
    /// The cones of the exact search.
    Cones,
}

/// The film of the exact path on the map of a file. The ends are given as the file has its points.
pub(crate) fn path_film(file: &Path, ends: [[f64; 2]; 2], what: PathFilm, most: usize) -> Result<SketchFilm, Refused> {
    let map = MapArgs::of(file).open()?;
    let snap = Snap::none();
    let place = |what, coordinates| {
        let wish = Wish { what, coordinates, face: None };
        match snap.end(&map, &wish, |_| None) {
            // At a double corner or a wall the first of the places will do.
            Ok(end) => Ok(end.places[0]),
            Err(lost) => {
                let near = lost.nearest.map(|near| (near.place.point, "nearest place"));
                let places: Vec<_> = std::iter::once((lost.asked, what)).chain(near).collect();
                let film = algorithms::refusal(&map.subdivision, lost.failure.what(), &[], &places);
                Err(Refused { failure: Box::new(lost.failure), film: Some(film) })
            }
        }
    };
    let [start, goal] = [place("start", ends[0])?, place("goal", ends[1])?];
    let mut planner = Planner::face_by_face();
    let route = planner.route(&map.mesh, PathAlgorithm::Exact, &start, &goal).map_err(|error| {
        let places = [(start.point, "start"), (goal.point, "goal")];
        let film = algorithms::refusal(&map.subdivision, &error.to_string(), &[], &places);
        let failure = Failure::input(format!("{}: {error}", map.source), "choose two points of one component");
        Refused { failure: Box::new(failure), film: Some(film) }
    })?;
    Ok(match what {
        PathFilm::Funnel => algorithms::funnel(&map.subdivision, &map.mesh, &route, most),
        PathFilm::Cones => {
            let cones: Vec<Cone> = planner.cones(&map.mesh).collect();
            algorithms::cones(&map.subdivision, &map.mesh, &cones, &route, most)
        }
    })
}
