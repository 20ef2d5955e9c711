//! `dcel navmesh path`: a way by one rung of the ladder, or by all of them.

use super::super::failure::Failure;
use super::super::output::table;
use super::super::picture::Target;
use super::super::{Answer, Output};
use super::drawing::{Drawing, save};
use super::map::{Map, MapArgs};
use super::tell::{Spot, faces, point, refusal};
use clap::ValueEnum;
use dcel_kit::FaceId;
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::navmesh::{ComponentId, Place, PlaceError, Planner, Route, RouteError, Rung};
use serde::Serialize;
use std::io::Write;

/// Find a way between two points
///
/// Without --rung the way is the shortest of all. The lower rungs of the ladder find a corridor of
/// faces by a quicker rule and pull the way straight in it; --rung all compares them. If there is no
/// way, the answer is the proof: the two components. Exit code 1 then.
#[derive(clap::Args, Debug)]
#[command(override_usage = "dcel navmesh path [OPTIONS] <MAP> <X> <Y> <X> <Y>")]
#[command(after_help = "\
Examples:
  dcel navmesh path figures/data/rooms.map 1 1 22 12
  dcel navmesh path figures/data/rooms.map 1 1 22 12 \\
    --rung all -o ladder.svg
  dcel navmesh path figures/data/rooms.map 1 1 22 12 \\
    --triangles --rung bfs --draw funnel -o funnel.svg
  dcel navmesh path figures/data/rooms.map 1 1 22 12 \\
    --draw cones -o cones.svg")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// The start and the goal: x y x y, as the file has them
    #[arg(value_names = ["X", "Y", "X", "Y"], num_args = 4, required = true, allow_negative_numbers = true)]
    ends: Vec<f64>,
    /// How the way is found
    #[arg(long, value_name = "RUNG", default_value = "exact")]
    rung: Which,
    /// Look for the exact way over larger faces, merged from those of the map: the same answer with
    /// less work
    #[arg(long)]
    merged: bool,
    /// The radius of the agent: its way leads through doors that are wide enough, and keeps off their
    /// posts; not exact
    #[arg(long, value_name = "R", conflicts_with = "rung")]
    radius: Option<f64>,
    /// The face to start from, where gaps touch in the start
    #[arg(long, value_name = "f3")]
    start_face: Option<FaceId>,
    /// The face to end in, where gaps touch in the goal
    #[arg(long, value_name = "f3")]
    goal_face: Option<FaceId>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    /// What to draw of a way
    #[arg(long, value_name = "WHAT", default_value = "route", requires = "output", help_heading = "Figure")]
    draw: Draw,
    #[command(flatten)]
    drawing: Drawing,
}

/// The rungs of the ladder.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Which {
    /// Breadth first: the fewest faces
    #[value(alias = "breadth")]
    Bfs,
    /// A* from centroid to centroid of the faces
    Centroid,
    /// A* from midpoint to midpoint of the doors
    Midpoint,
    /// A* to the closest point of each door
    Closest,
    /// The shortest way of all
    Exact,
    /// All of them, compared
    All,
}

impl Which {
    pub(super) fn rungs(self) -> &'static [Rung] {
        match self {
            Self::Bfs => &[Rung::Breadth],
            Self::Centroid => &[Rung::Centroid],
            Self::Midpoint => &[Rung::Midpoint],
            Self::Closest => &[Rung::Closest],
            Self::Exact => &[Rung::Exact],
            Self::All => &Rung::ALL,
        }
    }
}

/// What to draw of a way.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum Draw {
    /// The corridor, its portals and the way; the ladder for --rung all
    Route,
    /// How the way is pulled straight, door by door
    Funnel,
    /// What the exact search looked at
    Cones,
}

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Answered {
    source: String,
    start: Spot,
    goal: Spot,
    found: bool,
    /// If nothing was found: the components of the start and of the goal, and the nearest point that can be reached.
    apart: Option<Apart>,
    routes: Vec<Row>,
}

#[derive(Serialize)]
struct Apart {
    start_component: u32,
    start_faces: usize,
    goal_component: u32,
    goal_faces: usize,
    nearest_reachable: Option<[f64; 2]>,
}

#[derive(Serialize)]
struct Row {
    rung: &'static str,
    length: f64,
    /// How much longer than the exact way, if that was asked for.
    ratio: Option<f64>,
    points: Vec<[f64; 2]>,
    corners: Vec<String>,
    faces: Vec<String>,
    doors: Vec<String>,
    pops: u64,
    pushes: u64,
    expansions: u64,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if let Some(radius) = args.radius.filter(|radius| !radius.is_finite() || *radius < 0.0) {
        return Err(Failure::input(format!("an agent of radius {radius}"), "give a number such as 0.5"));
    }
    if args.draw == Draw::Cones && (args.rung != Which::Exact || args.radius.is_some()) {
        return Err(Failure::input("only the exact search has cones", "leave --rung out, or draw the route"));
    }
    if args.draw == Draw::Funnel && args.rung == Which::All {
        return Err(Failure::input("a funnel is drawn of one way", "choose one rung, for example --rung bfs"));
    }
    let [x0, y0, x1, y1] = args.ends[..] else {
        return Err(Failure::input("a way has two ends", "give x y of the start and x y of the goal"));
    };
    if let Some(bad) = args.ends.iter().find(|x| !x.is_finite()) {
        return Err(Failure::input(format!("{bad} is no coordinate"), "give finite numbers"));
    }
    let target = args.drawing.target(args.map.file())?;
    let mut map = args.map.open()?;
    if args.merged {
        map.mesh.merge_faces();
    }
    let start = place(&map, "start", [x0, y0], args.start_face)?;
    let goal = place(&map, "goal", [x1, y1], args.goal_face)?;
    let mut planner = Planner::new();
    let mut routes: Vec<(Rung, Route)> = Vec::new();
    let rungs: &[Rung] = if args.radius.is_some() { &[Rung::Closest] } else { args.rung.rungs() };
    for &rung in rungs {
        let route = match args.radius {
            Some(radius) => planner.wide_route(&map.mesh, radius, &start, &goal),
            None => planner.route(&map.mesh, rung, &start, &goal),
        };
        match route {
            Ok(route) => routes.push((rung, route)),
            Err(error @ RouteError::TooNarrow { .. }) => return too_narrow(args, &map, [start, goal], &error, out),
            Err(RouteError::Apart { start: from, goal: to, .. }) => {
                return apart(args, &map, [start, goal], [from, to], target.as_ref(), out);
            }
            Err(error) => return Err(Failure::input(format!("{}: {error}", map.source), "")),
        }
    }
    if let Some(target) = &target {
        draw(args, &map, &planner, &routes, target, out)?;
    }
    let exact = routes.iter().find(|(rung, _)| *rung == Rung::Exact).map(|(_, route)| route.length);
    let rows: Vec<Row> = routes.iter().map(|(rung, route)| Row::of(&map, *rung, route, exact)).collect();
    if args.json {
        let [start, goal] = [start, goal].map(|place| Spot::of(&map, place.point, place.location));
        out.json(&Answered { source: map.source.clone(), start, goal, found: true, apart: None, routes: rows })?;
    } else if let [row] = rows.as_slice() {
        row.print(out)?;
    } else {
        compare(&rows, out)?;
    }
    Ok(Answer::Yes)
}

/// Where a way starts or ends.
fn place(map: &Map, what: &str, coordinates: [f64; 2], face: Option<FaceId>) -> Result<Place, Failure> {
    let p = map.point(coordinates);
    let found = face.map_or_else(|| map.mesh.place(p), |face| map.mesh.place_in(face, p));
    found.map_err(|error| {
        let help = match &error {
            PlaceError::Ambiguous { .. } => format!("choose one of them with --{what}-face"),
            _ => map.mesh.nearest_point(p).map_or_else(String::new, |nearest| {
                format!("the nearest place is {} in {}", point(map, nearest.place.point), nearest.place.face)
            }),
        };
        Failure::input(format!("{}: the {what} {}", map.source, refusal(map, &error)), help)
    })
}

fn draw(
    args: &Args,
    map: &Map,
    planner: &Planner,
    routes: &[(Rung, Route)],
    target: &Target,
    out: &mut Output,
) -> Result<(), Failure> {
    let floor = Floor::new(&map.subdivision, &map.mesh);
    let title = args.map.title();
    let options = |what: &str| args.drawing.options(map, &format!("{what} through {title}"));
    let drawn = match (args.draw, routes) {
        (Draw::Funnel, [(_, route)]) => floor.funnel(route, &options("The funnel")),
        (Draw::Cones, [(_, route)]) => {
            let cones: Vec<_> = planner.cones(&map.mesh).collect();
            floor.cones(&cones, route, &options("What an exact search sees"))
        }
        (_, [(_, route)]) => floor.route(route, &options("A way")),
        _ => floor.ladder(routes, &options("Five ways")),
    };
    save(target, drawn, out)
}

/// The answer if there is a way, but not for so wide an agent.
fn too_narrow(
    args: &Args,
    map: &Map,
    ends: [Place; 2],
    error: &RouteError,
    out: &mut Output,
) -> Result<Answer, Failure> {
    if args.json {
        let [start, goal] = ends.map(|place| Spot::of(map, place.point, place.location));
        let source = map.source.clone();
        out.json(&Answered { source, start, goal, found: false, apart: None, routes: Vec::new() })?;
    } else {
        writeln!(out, "{error}")?;
    }
    Ok(Answer::No)
}

/// The answer if there is no way.
fn apart(
    args: &Args,
    map: &Map,
    ends: [Place; 2],
    components: [ComponentId; 2],
    target: Option<&Target>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    if let Some(target) = target {
        let options = args.drawing.options(map, &format!("No way through {}", args.map.title()));
        let floor = Floor::new(&map.subdivision, &map.mesh);
        save(target, floor.apart(ends.map(|place| place.point), components, &options), out)?;
    }
    let [start_faces, goal_faces] = components.map(|c| map.mesh.component_faces(c).count());
    let nearest = map.mesh.nearest_reachable(components[0], ends[1].point);
    if args.json {
        let [start, goal] = ends.map(|place| Spot::of(map, place.point, place.location));
        let apart = Apart {
            start_component: components[0].0,
            start_faces,
            goal_component: components[1].0,
            goal_faces,
            nearest_reachable: nearest.map(|nearest| map.in_file(nearest.place.point)),
        };
        let source = map.source.clone();
        out.json(&Answered { source, start, goal, found: false, apart: Some(apart), routes: Vec::new() })?;
        return Ok(Answer::No);
    }
    let [from, to] = ends.map(|place| point(map, place.point));
    let [a, b] = components;
    let [start_faces, goal_faces] = [start_faces, goal_faces].map(faces);
    writeln!(out, "no way: {from} is in {a} of {start_faces}, {to} is in {b} of {goal_faces}")?;
    if let Some(nearest) = nearest {
        let (at, face) = (point(map, nearest.place.point), nearest.place.face);
        writeln!(out, "  nearest point that can be reached: {at} in {face}, {} away", nearest.distance)?;
    }
    Ok(Answer::No)
}

impl Row {
    fn of(map: &Map, rung: Rung, route: &Route, exact: Option<f64>) -> Self {
        Self {
            rung: rung.name(),
            length: route.length,
            ratio: exact.filter(|&exact| exact > 0.0).map(|exact| route.length / exact),
            points: route.points.iter().map(|&p| map.in_file(p)).collect(),
            corners: route.corners.iter().map(ToString::to_string).collect(),
            faces: route.faces.iter().map(ToString::to_string).collect(),
            doors: route.doors.iter().map(ToString::to_string).collect(),
            pops: route.work.pops,
            pushes: route.work.pushes,
            expansions: route.work.expansions,
        }
    }

    fn print(&self, out: &mut Output) -> Result<(), Failure> {
        writeln!(out, "{}: {}, through {}", self.rung, self.length, faces(self.faces.len()))?;
        let points: Vec<String> = self.points.iter().map(|p| super::super::output::point(p)).collect();
        for (what, words) in
            [("way", &points), ("corners", &self.corners), ("faces", &self.faces), ("doors", &self.doors)]
        {
            if !words.is_empty() {
                writeln!(out, "  {what:<8}{}", words.join(" "))?;
            }
        }
        writeln!(out, "  {:<8}{} taken from the queue, {} faces entered", "work", self.pops, self.expansions)?;
        Ok(())
    }
}

/// The ladder as a table.
fn compare(rows: &[Row], out: &mut Output) -> Result<(), Failure> {
    let head = ["rung", "length", "of the exact", "faces", "corners", "from queue", "entered"].map(str::to_owned);
    let mut lines = vec![head];
    for row in rows {
        lines.push([
            row.rung.to_owned(),
            format!("{:.6}", row.length),
            row.ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.6}")),
            row.faces.len().to_string(),
            row.corners.len().to_string(),
            row.pops.to_string(),
            row.expansions.to_string(),
        ]);
    }
    table(out, &lines)?;
    Ok(())
}
