//! `dcel navmesh path` on a floor whose heights differ.

use super::super::super::answer::fields;
use super::super::super::failure::{Failure, say};
use super::super::super::output::{point as told, table};
use super::super::super::{Answer, Output};
use super::super::drawing::{Canvas, save};
use super::super::path::Args;
use super::super::tell::faces;
use super::{End, Ground, Spot, Wish, points_of};
use dcel_kit::FaceMap;
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::{
    LinkError, PathAlgorithm, SurfaceLink, SurfacePlanner, SurfacePoint, SurfaceRoute, SurfaceRouteError,
};
use serde::Serialize;
use std::io::Write;

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Answered {
    source: String,
    start: Spot,
    goal: Spot,
    /// How far they were moved, in the plan.
    start_moved: Option<f64>,
    goal_moved: Option<f64>,
    found: bool,
    /// If nothing was found: the components of the start and of the goal.
    apart: Option<[u32; 2]>,
    routes: Vec<Row>,
}

/// A path, or a leg of one.
#[derive(Serialize)]
struct Row {
    algorithm: &'static str,
    /// Along the surface.
    length: f64,
    /// With the costs of faces, if there are any.
    cost: Option<f64>,
    ratio: Option<f64>,
    points: Vec<[f64; 3]>,
    /// The layer of each piece between two points.
    layers: Vec<usize>,
    corners: Vec<String>,
    faces: Vec<String>,
    pops: u64,
    pushes: u64,
    expansions: u64,
}

pub(in super::super) fn run(
    ground: &Ground,
    args: &Args,
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let points = points_of(&args.ends, 2, true)?;
    for &algorithm in args.algorithm.algorithms() {
        args.extras.check(algorithm, &args.algorithm.word())?;
    }
    let wishes = [
        Wish { what: "start", numbers: points[0], layer: args.start_layer, face: args.start_face },
        Wish { what: "goal", numbers: points[1], layer: args.goal_layer, face: args.goal_face },
    ];
    let surface = &ground.surface;
    let ends = [ground.end(&wishes[0], &args.snap)?, ground.end(&wishes[1], &args.snap)?];
    let mut planner = SurfacePlanner::new();
    let [start, goal] = choose(ground, &mut planner, &wishes, &ends);
    let moved = ends.map(|end| end.moved);
    let costs = ground.costs(args.extras.areas())?;
    let links = args.extras.links().on(ground, &args.snap)?;
    if !links.is_empty() {
        return linked(ground, &mut planner, (args, target), costs.as_ref(), &links, [start, goal], out);
    }
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
            Err(error) => return Err(Failure::input(format!("{}: {error}", ground.source), "")),
        }
    }
    let paths: Vec<&SurfaceRoute> = routes.last().map(|(_, route)| route).into_iter().collect();
    draw(ground, (args, target), &paths, &[start, goal], out)?;
    let exact = routes.iter().find(|(algorithm, _)| *algorithm == PathAlgorithm::Exact).map(|(_, route)| route.length);
    let rows: Vec<Row> =
        routes.iter().map(|(algorithm, route)| Row::of(ground, *algorithm, route, exact, costs.as_ref())).collect();
    if args.json {
        let [from, to] = [start, goal].map(|place| ground.spot(&place));
        out.json(&Answered {
            source: ground.source.clone(),
            start: from,
            goal: to,
            start_moved: moved[0],
            goal_moved: moved[1],
            found: true,
            apart: None,
            routes: rows,
        })?;
    } else if let [row] = rows.as_slice() {
        row.print(out)?;
    } else {
        compare(&rows, out)?;
    }
    Ok(Answer::Yes)
}

/// Of several places at the ends those of the shortest path.
fn choose(ground: &Ground, planner: &mut SurfacePlanner, wishes: &[Wish<'_>; 2], ends: &[End; 2]) -> [SurfacePoint; 2] {
    let [starts, goals] = ends.each_ref().map(|end| end.places.as_slice());
    if starts.len() == 1 && goals.len() == 1 {
        return [starts[0], goals[0]];
    }
    let found = planner.route_among(&ground.surface, PathAlgorithm::Exact, starts, goals);
    let [i, k] = found.map_or([0, 0], |(_, chosen)| chosen);
    for ((wish, end), chosen) in wishes.iter().zip(ends).zip([i, k]).filter(|((_, end), _)| end.places.len() > 1) {
        let others: Vec<String> = end.places.iter().map(|place| place.face.to_string()).collect();
        let (what, at, face) = (wish.what, told(wish.numbers), end.places[chosen].face);
        let others = others.join(", ");
        say(
            "note",
            format_args!(
                "the {what} {at} is where faces touch in a vertex, in {others}: the shortest path is that of {face}; --{what}-face chooses"
            ),
        );
    }
    [starts[i], goals[k]]
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
        let [start, goal] = ends.map(|place| ground.spot(&place));
        out.json(&Answered {
            source: ground.source.clone(),
            start,
            goal,
            start_moved: moved[0],
            goal_moved: moved[1],
            found: false,
            apart: Some(components),
            routes: Vec::new(),
        })?;
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
    costs: Option<&FaceMap<f64>>,
    links: &[SurfaceLink],
    [start, goal]: [SurfacePoint; 2],
    out: &mut Output,
) -> Result<Answer, Failure> {
    let &[algorithm] = args.algorithm.algorithms() else {
        return Err(Failure::input(
            "--link cannot be used with --algorithm all",
            "choose one algorithm, for example exact",
        ));
    };
    let path = match planner.linked_route(&ground.surface, links, algorithm, costs, [&start, &goal]) {
        Ok(path) => Some(path),
        Err(LinkError::Unreachable) => None,
        Err(error) => return Err(Failure::input(format!("{}: {error}", ground.source), "")),
    };
    if let (Some(target), Some(path)) = (target, &path) {
        let legs: Vec<&SurfaceRoute> = path.legs.iter().collect();
        let used: Vec<SurfaceLink> = path.links.iter().map(|&i| links[i]).collect();
        let options = ground.options(target, &format!("A path over links through {}", args.map.title()));
        save(target, Storeys::new(&ground.surface).paths(&legs, &used, &[start, goal], &options), out)?;
    }
    let answer = if path.is_some() { Answer::Yes } else { Answer::No };
    if args.json {
        let legs = path.iter().flat_map(|path| &path.legs);
        out.json(&fields! {
            source: &ground.source,
            algorithm: algorithm.name(),
            found: path.is_some(),
            // What the legs and the links cost.
            cost: path.as_ref().map(|path| path.cost),
            legs: legs.map(|leg| Row::of(ground, algorithm, leg, None, costs)).collect::<Vec<_>>(),
            // Between the legs, by their order on the command line, from 0.
            links: path.as_ref().map_or(&[][..], |path| &path.links),
        })?;
        return Ok(answer);
    }
    let Some(path) = path else {
        let [from, to] = [start, goal].map(|place| ground.told(place.point));
        writeln!(out, "no path: neither the surface nor the links lead from {from} to {to}")?;
        return Ok(answer);
    };
    let count = path.links.len();
    writeln!(out, "{algorithm}: {}, over {count} {}", path.cost, if count == 1 { "link" } else { "links" })?;
    for (i, leg) in path.legs.iter().enumerate() {
        if let Some(&link) = i.checked_sub(1).and_then(|before| path.links.get(before)) {
            let [from, to] = [links[link].from, links[link].to].map(|place| ground.told(place.point));
            writeln!(out, "  link    {from} -> {to}, costs {}", links[link].cost)?;
        }
        let points: Vec<String> = leg.points.iter().map(|&p| ground.told(p)).collect();
        let cost = costs.map(|_| format!(", costs {}", leg.cost)).unwrap_or_default();
        writeln!(out, "  leg     {}, {} long{cost}", points.join(" "), leg.length)?;
    }
    Ok(answer)
}

impl Row {
    fn of(
        ground: &Ground,
        algorithm: PathAlgorithm,
        route: &SurfaceRoute,
        exact: Option<f64>,
        costs: Option<&FaceMap<f64>>,
    ) -> Self {
        Self {
            algorithm: algorithm.name(),
            length: route.length,
            cost: costs.map(|_| route.cost),
            ratio: exact.filter(|&exact| exact > 0.0).map(|exact| route.length / exact),
            points: route.points.iter().map(|&p| ground.in_file(p)).collect(),
            layers: route.layers.clone(),
            corners: route.corners.iter().map(ToString::to_string).collect(),
            faces: route.faces.iter().map(ToString::to_string).collect(),
            pops: route.work.pops,
            pushes: route.work.pushes,
            expansions: route.work.expansions,
        }
    }

    fn print(&self, out: &mut Output) -> Result<(), Failure> {
        let cost = self.cost.map(|cost| format!(", costs {cost}")).unwrap_or_default();
        writeln!(
            out,
            "{}: {} along the surface{cost}, through {}",
            self.algorithm,
            self.length,
            faces(self.faces.len())
        )?;
        let points: Vec<String> = self.points.iter().map(|p| told(p)).collect();
        let mut layers: Vec<String> = self.layers.iter().map(ToString::to_string).collect();
        layers.dedup();
        for (what, words) in
            [("path", &points), ("layers", &layers), ("corners", &self.corners), ("faces", &self.faces)]
        {
            if !words.is_empty() {
                writeln!(out, "  {what:<8}{}", words.join(" "))?;
            }
        }
        writeln!(out, "  {:<8}{} taken from the queue, {} looked behind", "work", self.pops, self.expansions)?;
        Ok(())
    }
}

/// The ladder as a table.
fn compare(rows: &[Row], out: &mut Output) -> Result<(), Failure> {
    let head = ["algorithm", "length", "of the exact", "faces", "corners", "from queue"].map(str::to_owned);
    let mut lines = vec![head];
    for row in rows {
        lines.push([
            row.algorithm.to_owned(),
            format!("{:.6}", row.length),
            row.ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.6}")),
            row.faces.len().to_string(),
            row.corners.len().to_string(),
            row.pops.to_string(),
        ]);
    }
    table(out, &lines)?;
    Ok(())
}
