//! `dcel navmesh path --link`: a path over the map and over links.

use super::super::answer::fields;
use super::super::failure::Failure;
use super::super::output::point as told;
use super::super::{Answer, Output};
use super::map::Map;
use super::tell::point;
use dcel_kit::FaceMap;
use dcel_kit::navmesh::{Link, LinkError, LinkedRoute, PathAlgorithm, Planner, QueryPoint, Stop};
use std::io::Write;

/// Finds the path and tells it. Returns it, for a figure.
pub(super) fn run(
    map: &Map,
    planner: &mut Planner,
    algorithm: PathAlgorithm,
    (links, costs): (&[Link], Option<&FaceMap<f64>>),
    ends: [QueryPoint; 2],
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
        Err(error) => return Err(Failure::input(format!("{}: {error}", map.source), "")),
    };
    if json {
        let legs = path.iter().flat_map(|path| &path.legs).map(|leg| {
            fields! {
                length: leg.route.length,
                points: leg.route.points.iter().map(|&p| map.in_file(p)).collect::<Vec<_>>(),
                faces: leg.route.faces.iter().map(ToString::to_string).collect::<Vec<_>>(),
            }
        });
        out.json(&fields! {
            source: &map.source,
            algorithm: algorithm.name(),
            found: path.is_some(),
            // The lengths of the legs and the costs of the links.
            cost: path.as_ref().map(|path| path.cost),
            legs: legs.collect::<Vec<_>>(),
            // Between the legs, by their order on the command line, from 0.
            links: path.as_ref().map_or(&[][..], |path| &path.links),
        })?;
    } else {
        tell(map, algorithm, links, [start, goal], path.as_ref(), out)?;
    }
    Ok((if path.is_some() { Answer::Yes } else { Answer::No }, path))
}

fn tell(
    map: &Map,
    algorithm: PathAlgorithm,
    links: &[Link],
    ends: [Stop; 2],
    path: Option<&LinkedRoute>,
    out: &mut Output,
) -> Result<(), Failure> {
    let Some(path) = path else {
        let [from, to] = ends.map(|stop| point(map, stop.place.point));
        writeln!(out, "no path: neither the map nor the links lead from {from} to {to}")?;
        return Ok(());
    };
    let count = path.links.len();
    writeln!(out, "{algorithm}: {}, over {count} {}", path.cost, if count == 1 { "link" } else { "links" })?;
    for (i, leg) in path.legs.iter().enumerate() {
        if let Some(&link) = i.checked_sub(1).and_then(|before| path.links.get(before)) {
            let [from, to] = [links[link].from, links[link].to].map(|stop| point(map, stop.place.point));
            writeln!(out, "  link    {from} -> {to}, costs {}", links[link].cost)?;
        }
        let points: Vec<String> = leg.route.points.iter().map(|&p| told(&map.in_file(p))).collect();
        writeln!(out, "  leg     {}, {} long", points.join(" "), leg.route.length)?;
    }
    Ok(())
}
