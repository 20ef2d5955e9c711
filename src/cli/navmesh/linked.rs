//! `dcel navmesh path --link`: a path over the map and over links.

use super::super::output::point as told;
use super::super::{Answer, Failure, Output, fields};
use super::ends::{End, Wish, choose_side};
use super::map::Map;
use super::routes::{Links, tell_linked};
use super::tell::{Spot, point};
use dcel_kit::FaceMap;
use dcel_kit::navmesh::{Link, LinkError, LinkedRoute, PathAlgorithm, Planner, QueryPoint, Stop};

/// Finds the path and tells it. Returns it, for a figure.
pub(super) fn run(
    map: &Map,
    planner: &mut Planner,
    algorithm: PathAlgorithm,
    (links, costs): (&Links<Link>, Option<&FaceMap<f64>>),
    (wishes, ends): (&[Wish<'_>; 2], &[End; 2]),
    json: bool,
    out: &mut Output,
) -> Result<(Answer, Option<LinkedRoute>), Failure> {
    let stops = |end: &End| end.places.iter().map(|&place| Stop { layer: 0, place }).collect::<Vec<_>>();
    let [starts, goals] = ends.each_ref().map(stops);
    let (layers, costs) = (std::slice::from_ref(&map.mesh), costs.map(std::slice::from_ref));
    let (path, pair) = match planner.linked_route_among(layers, &links.sides, algorithm, costs, [&starts, &goals]) {
        Ok((path, pair)) => (Some(path), Some(pair)),
        Err(LinkError::Unreachable) => (None, None),
        Err(error) => return Err(Failure::about(&map.source, error)),
    };
    let moved = ends.each_ref().map(|end| end.moved);
    let places = choose_side(map, wishes, ends, || pair);
    let legs = |path: &LinkedRoute| {
        let leg = |route: &dcel_kit::navmesh::Route| {
            let points: Vec<[f64; 2]> = route.points.iter().map(|&p| map.in_file(p)).collect();
            let words: Vec<String> = points.iter().map(|p| told(p)).collect();
            let (length, faces) = (route.length, route.faces.iter().map(ToString::to_string).collect::<Vec<_>>());
            (fields! { length, points, faces }, format!("{}, {length} long", words.join(" ")))
        };
        path.legs.iter().map(|of| leg(&of.route)).collect()
    };
    let told = |ends: [QueryPoint; 2]| ends.map(|place| point(map, place.point));
    let link = |link: &Link| (told([link.from.place, link.to.place]), link.cost);
    let spots = places.map(|place| Spot::of(map, place.point, place.location));
    let told_path = path.as_ref().map(|path| (path.cost, legs(path), &path.links[..]));
    let (ends, how) = ((spots, moved), (&*map.source, json));
    let answer = tell_linked(how, algorithm, ends, told_path, (links, link), ("map", told(places)), out)?;
    Ok((answer, path))
}
