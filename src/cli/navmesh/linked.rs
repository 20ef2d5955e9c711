//! `dcel navmesh path --link`: a path over the map and over links.

use super::super::answer::fields;
use super::super::failure::Failure;
use super::super::output::point as told;
use super::super::{Answer, Output};
use super::map::Map;
use super::routes::{Linked, tell_linked};
use super::tell::{Spot, point};
use dcel_kit::FaceMap;
use dcel_kit::navmesh::{Link, LinkError, LinkedRoute, PathAlgorithm, Planner, QueryPoint, Stop};

/// Finds the path and tells it. Returns it, for a figure.
pub(super) fn run(
    map: &Map,
    planner: &mut Planner,
    algorithm: PathAlgorithm,
    (links, costs): (&[Link], Option<&FaceMap<f64>>),
    (ends, moved): ([QueryPoint; 2], [Option<f64>; 2]),
    json: bool,
    out: &mut Output,
) -> Result<(Answer, Option<LinkedRoute>), Failure> {
    let [start, goal] = ends.map(|place| Stop { layer: 0, place });
    let layers = std::slice::from_ref(&map.mesh);
    let found = match costs {
        Some(costs) => {
            planner.weighted_linked_route(layers, links, algorithm, std::slice::from_ref(costs), &start, &goal)
        }
        None => planner.linked_route(layers, links, algorithm, &start, &goal),
    };
    let path = match found {
        Ok(path) => Some(path),
        Err(LinkError::Unreachable) => None,
        Err(error) => return Err(Failure::about(&map.source, error)),
    };
    let legs = |path: &LinkedRoute| {
        let leg = |route: &dcel_kit::navmesh::Route| {
            let points: Vec<[f64; 2]> = route.points.iter().map(|&p| map.in_file(p)).collect();
            let words: Vec<String> = points.iter().map(|p| told(p)).collect();
            let (length, faces) = (route.length, route.faces.iter().map(ToString::to_string).collect::<Vec<_>>());
            (fields! { length, points, faces }, format!("{}, {length} long", words.join(" ")))
        };
        path.legs.iter().map(|of| leg(&of.route)).collect()
    };
    let linked = path.as_ref().map(|path| Linked { cost: path.cost, legs: legs(path), links: &path.links });
    let between = |ends: [Stop; 2]| ends.map(|stop| point(map, stop.place.point));
    let link = |i: usize| {
        let [from, to] = between([links[i].from, links[i].to]);
        format!("{from} -> {to}, costs {}", links[i].cost)
    };
    let none = || {
        let [from, to] = between([start, goal]);
        format!("the map nor the links lead from {from} to {to}")
    };
    let spots = ends.map(|place| Spot::of(map, place.point, place.location));
    let answer = tell_linked((&map.source, json), algorithm, (spots, moved), linked.as_ref(), (link, none), out)?;
    Ok((answer, path))
}
