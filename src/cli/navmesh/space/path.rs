//! `dcel navmesh path` on a floor whose heights differ.

use super::super::super::output::point as told;
use super::super::super::{Answer, Failure, Output, tell};
use super::super::drawing::{Canvas, save};
use super::super::path::Args;
use super::super::routes::{Links, Row, WHERE_FACES_TOUCH, answer, choose, compared, print, tell_linked};
use super::super::tell::faces;
use super::{End, Ground, Wish, points_of};
use dcel_kit::FaceMap;
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::{
    LinkError, PathAlgorithm, SurfaceLink, SurfacePlanner, SurfacePoint, SurfaceRoute, SurfaceRouteError,
};
use std::io::Write;

pub(in super::super) fn run(
    ground: &Ground,
    args: &Args,
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let points = points_of(&args.ends, 2, true)?;
    args.check_costs()?;
    let wishes = [
        Wish { what: "start", numbers: points[0], layer: args.start_layer, face: args.start_face },
        Wish { what: "goal", numbers: points[1], layer: args.goal_layer, face: args.goal_face },
    ];
    let surface = &ground.surface;
    let ends = [ground.end(&wishes[0], &args.snap)?, ground.end(&wishes[1], &args.snap)?];
    let mut planner = SurfacePlanner::new();
    let costs = ground.costs(&args.extras.costs.cost)?;
    let links = args.extras.links.on(ground, &args.snap)?;
    if !links.is_empty() {
        return linked(ground, &mut planner, (args, target), (&links, costs.as_ref()), (&wishes, &ends), out);
    }
    let [starts, goals] = ends.each_ref().map(|end| end.places.as_slice());
    let shortest = || Some(planner.route_among(surface, PathAlgorithm::Exact, starts, goals).ok()?.1);
    let [start, goal] = choose_place(&wishes, &ends, shortest);
    let moved = ends.map(|end| end.moved);
    let mut routes: Vec<(PathAlgorithm, SurfaceRoute)> = Vec::new();
    for &algorithm in args.algorithm.algorithms() {
        let found = match &costs {
            Some(costs) => planner.weighted_route(surface, algorithm, costs, &start, &goal),
            None => planner.route(surface, algorithm, &start, &goal),
        };
        match found {
            Ok(route) => routes.push((algorithm, route)),
            Err(SurfaceRouteError::Unreachable { start: from, goal: to, .. }) => {
                draw(ground, (args, target), &[], &[start, goal], out)?;
                return apart(ground, args, ([start, goal], moved), [from, to], out);
            }
            Err(error) => return Err(Failure::about(&ground.source, error)),
        }
    }
    let paths: Vec<&SurfaceRoute> = routes.last().map(|(_, route)| route).into_iter().collect();
    draw(ground, (args, target), &paths, &[start, goal], out)?;
    let row = |(algorithm, route): &(PathAlgorithm, SurfaceRoute)| row(ground, *algorithm, route, costs.as_ref());
    let rows = compared(routes.iter().map(row).collect());
    let ends = [start, goal].map(|place| ground.spot(&place));
    let answer = answer(&ground.source, None, ends, moved, None::<()>, &rows);
    tell(&answer, args.json, out, |out| print(&rows, out))
}

/// Of several places at the ends those of the shortest path. Tells which.
fn choose_place(
    wishes: &[Wish<'_>; 2],
    ends: &[End; 2],
    shortest: impl FnOnce() -> Option<[usize; 2]>,
) -> [SurfacePoint; 2] {
    let ends = [0, 1].map(|i| (wishes[i].what, told(wishes[i].numbers), ends[i].places.as_slice()));
    choose(&ends, WHERE_FACES_TOUCH, |place| place.face, shortest)
}

fn draw(
    ground: &Ground,
    (args, target): (&Args, Option<&Canvas>),
    paths: &[&SurfaceRoute],
    ends: &[SurfacePoint; 2],
    out: &mut Output,
) -> Result<(), Failure> {
    let Some(target) = target else { return Ok(()) };
    let what = if paths.is_empty() { "No path through" } else { "A path through" };
    let options = ground.options(target, &format!("{what} {}", args.map.title()));
    save(target, Storeys::new(&ground.surface).paths(paths, &[], ends, &options), out)
}

/// The answer if there is no path.
fn apart(
    ground: &Ground,
    args: &Args,
    (ends, moved): ([SurfacePoint; 2], [Option<f64>; 2]),
    components: [u32; 2],
    out: &mut Output,
) -> Result<Answer, Failure> {
    if args.json {
        let ends = ends.map(|place| ground.spot(&place));
        out.json(&answer(&ground.source, None, ends, moved, Some(components), &[]))?;
        return Ok(Answer::No);
    }
    let [from, to] = ends.map(|place| ground.told(place.point));
    let [a, b] = components;
    let count = |c: u32| ground.surface.faces().filter(|&f| ground.surface.component(f) == Some(c)).count();
    let [of_a, of_b] = [a, b].map(|c| faces(count(c)));
    writeln!(out, "no path: {from} is in component {a} of {of_a}, {to} is in component {b} of {of_b}")?;
    Ok(Answer::No)
}

fn linked(
    ground: &Ground,
    planner: &mut SurfacePlanner,
    (args, target): (&Args, Option<&Canvas>),
    (links, costs): (&Links<SurfaceLink>, Option<&FaceMap<f64>>),
    (wishes, ends): (&[Wish<'_>; 2], &[End; 2]),
    out: &mut Output,
) -> Result<Answer, Failure> {
    let algorithm = args.over_links()?;
    let sides = ends.each_ref().map(|end| end.places.as_slice());
    let (path, pair) = match planner.linked_route_among(&ground.surface, &links.sides, algorithm, costs, sides) {
        Ok((path, pair)) => (Some(path), Some(pair)),
        Err(LinkError::Unreachable) => (None, None),
        Err(error) => return Err(Failure::about(&ground.source, error)),
    };
    let moved = ends.each_ref().map(|end| end.moved);
    let [start, goal] = choose_place(wishes, ends, || pair);
    if let (Some(target), Some(path)) = (target, &path) {
        let legs: Vec<&SurfaceRoute> = path.legs.iter().collect();
        let used: Vec<SurfaceLink> = path.links.iter().map(|&i| links.sides[i]).collect();
        let options = ground.options(target, &format!("A path over links through {}", args.map.title()));
        save(target, Storeys::new(&ground.surface).paths(&legs, &used, &[start, goal], &options), out)?;
    }
    let leg = |leg: &SurfaceRoute| {
        let points: Vec<String> = leg.points.iter().map(|&p| ground.told(p)).collect();
        let cost = costs.map(|_| format!(", costs {}", leg.cost)).unwrap_or_default();
        (row(ground, algorithm, leg, costs), format!("{}, {} long{cost}", points.join(" "), leg.length))
    };
    let between = |ends: [SurfacePoint; 2]| ends.map(|place| ground.told(place.point));
    let link = |link: &SurfaceLink| (between([link.from, link.to]), link.cost);
    let spots = [start, goal].map(|place| ground.spot(&place));
    let path = path.as_ref().map(|path| (path.cost, path.legs.iter().map(leg).collect(), &path.links[..]));
    let (ends, how) = ((spots, moved), (&*ground.source, args.json));
    tell_linked(how, algorithm, ends, path, (links, link), ("surface", between([start, goal])), out)
}

fn row(ground: &Ground, algorithm: PathAlgorithm, route: &SurfaceRoute, costs: Option<&FaceMap<f64>>) -> Row {
    Row {
        cost: costs.map(|_| route.cost),
        points: route.points.iter().map(|&p| ground.in_file(p).to_vec()).collect(),
        layers: Some(route.layers.clone()),
        ..Row::new(algorithm, route.length, (&route.corners, &route.faces), route.work)
    }
}
