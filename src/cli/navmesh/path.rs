//! `dcel navmesh path`: a way by one path algorithm, or by all of them.

use super::super::{Answer, Failure, Output, fields, tell};
use super::drawing::{Canvas, Drawing, save};
use super::ends::{End, Lost, Snap, Wish, choose_side};
use super::extras::Extras;
use super::map::Map;
use super::numbers::number;
use super::reading::{Input, MapArgs, Preparation};
use super::routes::{Links, Row, answer, compared, print};
use super::space;
use super::tell::{Spot, faces, point};
use clap::ValueEnum;
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::navmesh::{
    ComponentId, Inset, InsetError, Link, Location, PathAlgorithm, Planner, QueryPoint, QueryPointError, Route,
    RouteError,
};
use dcel_kit::plane::Point;
use dcel_kit::{FaceId, FaceMap};
use serde::Serialize;
use std::io::Write;

/// Find a path between two points
///
/// Without --algorithm the path is the shortest of all. The other algorithms find a corridor of
/// faces by a quicker rule and pull the path straight in it; --algorithm all compares them. If there is no
/// path, the answer is the proof: the two components. Exit code 1 then. A start or goal off the mesh is
/// refused, with the nearest place; --snap moves it there. The figure is drawn all the same.
///
/// On a floor in space whose heights differ (--up) the length is measured along the surface, up and down
/// its slopes, and the exact path is the shortest of all on the surface, not the shortest in the plan. It
/// leads over ramps and stairs from storey to storey. With --radius, --wall or --obstacle the plan decides.
#[derive(clap::Args, Debug)]
#[command(override_usage = "dcel navmesh path [OPTIONS] <MAP> <X> <Y> <X> <Y>")]
#[command(after_help = "\
The exact path along a row of many pillars takes long: twice \
as many up to four times. --algorithm closest is quicker.

Examples:
  dcel navmesh path rooms.map 1 1 22 12
  dcel navmesh path rooms.map 1 1 22 12 \\
    --algorithm all -o ladder.svg
  dcel navmesh path rooms.map 1 1 22 12 \\
    --triangles --algorithm bfs --draw funnel -o funnel.svg
  dcel navmesh path rooms.map 1 1 22 12 \\
    --draw cones -o cones.svg
  dcel navmesh path rooms.map 2.5 2.5 22 12 \\
    --snap 1
  dcel navmesh path rooms.map 1 1 22 12 \\
    --radius 0.4 --algorithm closest -o wide.svg
  dcel navmesh path rooms.map 1 1 22 12 \\
    --link 2,1,22,11,0.5 -o link.svg
  dcel navmesh path rooms.map 1 1 22 12 \\
    --algorithm closest --cost f1=3 --cost 9,0,14,0,14,9=2
  dcel navmesh path house.obj --up z \\
    1 1 0 1 1 3 -o storeys.svg")]
pub(super) struct Args {
    #[command(flatten)]
    pub(super) map: MapArgs,
    /// The start and the goal: x y x y, as the file has them; on a floor in space (--up) x y z x y z, too
    #[arg(value_names = ["X", "Y", "X", "Y"], num_args = 4..=6, required = true, allow_negative_numbers = true, value_parser = number)]
    pub(super) ends: Vec<f64>,
    /// How the path is found
    #[arg(long, value_name = "ALGORITHM", default_value = "exact")]
    pub(super) algorithm: Which,
    #[command(flatten)]
    preparation: Preparation,
    #[command(flatten)]
    pub(super) snap: Snap,
    /// The radius of the agent: its path keeps that far from every border. Faces, portals and corners
    /// are then those of the map without its margin. Where very many corners of walls are nearer to each
    /// other than that, the time grows with the pairs of them
    #[arg(long, value_name = "R", value_parser = number, conflicts_with = "cost")]
    radius: Option<f64>,
    /// How much further off a way round a corner may be kept, as a part of the radius: arcs are
    /// drawn by as few straight pieces as that allows
    #[arg(long, value_name = "PART", value_parser = number, requires = "radius", default_value_t = Inset::TOLERANCE)]
    tolerance: f64,
    #[command(flatten)]
    pub(super) extras: Extras,
    /// The face to start from, where holes touch in the start; without it the shortest path decides
    #[arg(long, value_name = "f3")]
    pub(super) start_face: Option<FaceId>,
    /// The face to end in, where holes touch in the goal; without it the shortest path decides
    #[arg(long, value_name = "f3")]
    pub(super) goal_face: Option<FaceId>,
    /// The layer of the start, where storeys lie over each other; dcel navmesh info tells the layers
    #[arg(long, value_name = "N")]
    pub(super) start_layer: Option<usize>,
    /// The layer of the goal
    #[arg(long, value_name = "N")]
    pub(super) goal_layer: Option<usize>,
    /// Answer in JSON
    #[arg(long)]
    pub(super) json: bool,
    /// What to draw of a path
    #[arg(long, value_name = "WHAT", default_value = "route", requires = "output", help_heading = "Figure")]
    draw: Draw,
    #[command(flatten)]
    drawing: Drawing,
}

/// The path algorithms.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Which {
    /// Breadth first: the fewest faces
    #[value(alias = "breadth")]
    Bfs,
    /// A* from centroid to centroid of the faces
    Centroid,
    /// A* from midpoint to midpoint of the portals
    Midpoint,
    /// A* to the closest point of each portal
    Closest,
    /// A* to where the straight line to the goal meets each portal
    Aimed,
    /// The shortest path of all
    Exact,
    /// All of them, compared
    All,
}

impl Which {
    /// The word for it on the command line.
    pub(super) fn word(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    pub(super) fn algorithms(self) -> &'static [PathAlgorithm] {
        match self {
            Self::Bfs => &[PathAlgorithm::Breadth],
            Self::Centroid => &[PathAlgorithm::Centroid],
            Self::Midpoint => &[PathAlgorithm::Midpoint],
            Self::Closest => &[PathAlgorithm::Closest],
            Self::Aimed => &[PathAlgorithm::Aimed],
            Self::Exact => &[PathAlgorithm::Exact],
            Self::All => &PathAlgorithm::ALL,
        }
    }
}

/// What to draw of a path.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum Draw {
    /// The corridor, its portals and the path; the ladder for --algorithm all
    Route,
    /// How the path is pulled straight, portal by portal
    Funnel,
    /// What the exact search looked at
    Cones,
}

impl Args {
    /// The one algorithm of a path over links.
    pub(super) fn over_links(&self) -> Result<PathAlgorithm, Failure> {
        let &[algorithm] = self.algorithm.algorithms() else {
            let what = "--link cannot be used with --algorithm all";
            return Err(Failure::input(what, "choose one algorithm, for example exact"));
        };
        Ok(algorithm)
    }

    /// Refuses costs where an algorithm counts something else.
    pub(super) fn check_costs(&self) -> Result<(), Failure> {
        let mut all = self.algorithm.algorithms().iter();
        all.try_for_each(|&algorithm| self.extras.check(algorithm, &self.algorithm.word()))
    }
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if let Some(radius) = args.radius.filter(|radius| *radius < 0.0) {
        return Err(Failure::input(format!("an agent of radius {radius}"), "give a number such as 0.5"));
    }
    if args.draw == Draw::Cones && args.algorithm != Which::Exact {
        return Err(Failure::input("only the exact search has cones", "leave --algorithm out, or draw the route"));
    }
    if args.draw == Draw::Funnel && args.algorithm == Which::All {
        return Err(Failure::input(
            "a funnel is drawn of one path",
            "choose one algorithm, for example --algorithm bfs",
        ));
    }
    args.snap.check()?;
    let target = args.drawing.target(&args.map.file)?;
    // What the plan alone knows.
    let is_plan = args.radius.is_some() || args.map.obstacles.are_given() || args.draw != Draw::Route;
    let draft = match args.map.read_as(!is_plan)? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => return space::path::run(&ground, args, target.as_ref(), out),
    };
    if args.start_layer.or(args.goal_layer).is_some_and(|layer| layer > 0) {
        return Err(Failure::input(format!("{}: a map of the plane has one layer", args.map.source()), "leave it out"));
    }
    let whole = args.map.open_draft(draft, &args.extras.costs.cost)?;
    let help = "give x y of the start and x y of the goal";
    let [from, to] = whole.points(&args.ends, "a path has two ends", help)?;
    let radius = args.radius.filter(|&radius| radius > 0.0);
    let inset = radius.map(|radius| whole.mesh.inset_within(radius, args.tolerance)).transpose();
    let inset = inset.map_err(|error| no_inset(&whole.source, &error))?;
    let ways = inset.as_ref().map(|inset| whole.inset(inset.clone()));
    let maps = Maps { whole, inset, ways };
    let wishes = [
        Wish { what: "start", coordinates: from, face: args.start_face },
        Wish { what: "goal", coordinates: to, face: args.goal_face },
    ];
    let ends = match wishes.each_ref().map(|wish| args.snap.end(maps.ways(), wish, |error| maps.why(wish, error))) {
        [Ok(start), Ok(goal)] => [start, goal],
        lost => return Err(refuse(args, &maps, lost, target.as_ref(), out)),
    };
    let map = maps.ways();
    let mut planner = args.preparation.planner();
    args.check_costs()?;
    let costs = map.costs(&args.extras.costs.cost)?;
    let links = args.extras.links.links(map)?;
    if !links.is_empty() {
        return linked(args, map, &mut planner, (&links, costs.as_ref()), (&wishes, &ends), target.as_ref(), out);
    }
    let [start, goal] = maps.choose(&mut planner, &wishes, &ends);
    let moved = ends.map(|end| end.moved);
    let mut routes: Vec<(PathAlgorithm, Route)> = Vec::new();
    for &algorithm in args.algorithm.algorithms() {
        let found = match &costs {
            Some(costs) => planner.weighted_route(&map.mesh, algorithm, costs, &start, &goal),
            None => planner.route(&map.mesh, algorithm, &start, &goal),
        };
        match found {
            Ok(route) => routes.push((algorithm, route)),
            Err(RouteError::Unreachable { start: from, goal: to, .. }) => {
                return apart(args, &maps, ([start, goal], moved), [from, to], target.as_ref(), out);
            }
            Err(error) => return Err(Failure::about(&map.source, error)),
        }
    }
    if let Some(target) = &target {
        draw(args, &maps, &planner, &routes, target, out)?;
    }
    let row = |(algorithm, route): &(PathAlgorithm, Route)| row(map, *algorithm, route, costs.as_ref());
    let rows = compared(routes.iter().map(row).collect());
    let answer = maps.answer([start, goal], moved, None::<()>, &rows);
    tell(&answer, args.json, out, |out| print(&rows, out))
}

/// The path over links, told and drawn.
fn linked(
    args: &Args,
    map: &Map,
    planner: &mut Planner,
    (links, costs): (&Links<Link>, Option<&FaceMap<f64>>),
    ends: (&[Wish<'_>; 2], &[End; 2]),
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let algorithm = args.over_links()?;
    let (answer, path) = super::linked::run(map, planner, algorithm, (links, costs), ends, args.json, out)?;
    if let Some((target, path)) = target.zip(path) {
        let options = target.options(map, &format!("A path over links through {}", args.map.title()));
        save(target, Floor::new(&map.subdivision, &map.mesh).linked(0, &path, &links.sides, &options), out)?;
    }
    Ok(answer)
}

/// Why nothing is left of a map for an agent with a radius: what helps stands behind the colon.
fn no_inset(source: &str, error: &InsetError) -> Failure {
    match error {
        InsetError::NoRoom { .. } | InsetError::Radius { .. } | InsetError::Tolerance { .. } => {
            Failure::refused(source, error)
        }
        _ => Failure::about(source, error),
    }
}

/// The map of the file, and what is left of it for an agent with a radius.
struct Maps {
    whole: Map,
    inset: Option<Inset>,
    /// The inset as a map.
    ways: Option<Map>,
}

impl Maps {
    /// The map on which ways are looked for.
    fn ways(&self) -> &Map {
        self.ways.as_ref().unwrap_or(&self.whole)
    }

    /// Whether a point is on the mesh of the file.
    fn is_on_whole(&self, p: Point) -> bool {
        !matches!(self.whole.mesh.locate(p), Location::Hole(_) | Location::Outer)
    }

    /// Why nobody can stand at an end, if the radius is the reason.
    fn why(&self, wish: &Wish<'_>, error: &QueryPointError) -> Option<String> {
        let (map, inset) = (self.ways(), self.inset.as_ref()?);
        let p = map.point(wish.coordinates);
        let by_radius = matches!(error, QueryPointError::OffMesh { .. }) && self.is_on_whole(p);
        by_radius.then(|| format!("{} is nearer to a border than the radius, {}", point(map, p), inset.radius()))
    }

    /// Of several places at the ends those of the shortest path. Tells which.
    fn choose(&self, planner: &mut Planner, wishes: &[Wish<'_>; 2], ends: &[End; 2]) -> [QueryPoint; 2] {
        let map = self.ways();
        let [starts, goals] = ends.each_ref().map(|end| end.places.as_slice());
        let shortest = || Some(planner.route_among(&map.mesh, PathAlgorithm::Exact, starts, goals).ok()?.1);
        choose_side(map, wishes, ends, shortest)
    }

    /// The answer with these routes, or with what lies apart.
    fn answer(
        &self,
        ends: [QueryPoint; 2],
        moved: [Option<f64>; 2],
        apart: Option<impl Serialize>,
        routes: &[Row],
    ) -> impl Serialize {
        let ends = ends.map(|place| Spot::of(self.ways(), place.point, place.location));
        answer(&self.ways().source, Some(self.inset.as_ref().map(Inset::radius)), ends, moved, apart, routes)
    }
}

/// What to say if there is no place for an end. The picture is drawn all the same.
fn refuse(
    args: &Args,
    maps: &Maps,
    ends: [Result<End, Box<Lost>>; 2],
    target: Option<&Canvas>,
    out: &mut Output,
) -> Failure {
    if let Some(target) = target {
        let map = maps.ways();
        let marks = ends.each_ref().map(|end| match end {
            Ok(end) => (end.asked, None),
            Err(lost) => (lost.asked, lost.nearest.map(|near| near.place.point)),
        });
        let options = target.options(map, &format!("No place in {}", args.map.title()));
        let drawn = Floor::new(&map.subdivision, &map.mesh).off_mesh(marks, &options);
        if let Err(error) = save(target, drawn, out) {
            return error;
        }
    }
    let [start, goal] = ends.map(|end| end.err().map(|lost| lost.failure));
    start.or(goal).unwrap_or_else(|| Failure::kit("both ends have a place"))
}

fn draw(
    args: &Args,
    maps: &Maps,
    planner: &Planner,
    routes: &[(PathAlgorithm, Route)],
    target: &Canvas,
    out: &mut Output,
) -> Result<(), Failure> {
    let map = maps.ways();
    let floor = Floor::new(&map.subdivision, &map.mesh);
    let title = args.map.title();
    let options = |what: &str| target.options(map, &format!("{what} through {title}"));
    let drawn = match (args.draw, routes, &maps.inset) {
        (Draw::Funnel, [(_, route)], _) => floor.funnel(route, &options("The funnel")),
        (Draw::Cones, [(_, route)], _) => {
            let cones: Vec<_> = planner.cones(&map.mesh).collect();
            floor.cones(&cones, route, &options("What an exact search sees"))
        }
        (_, [(_, route)], Some(inset)) => {
            let whole = Floor::new(&maps.whole.subdivision, &maps.whole.mesh);
            whole.clearance(inset, route, &options("The way of an agent with a radius"))
        }
        (_, [(_, route)], None) => floor.route(route, &options("A way")),
        _ => floor.ladder(routes, &options("Six ways")),
    };
    save(target, drawn, out)
}

/// The answer if there is no path.
fn apart(
    args: &Args,
    maps: &Maps,
    (ends, moved): ([QueryPoint; 2], [Option<f64>; 2]),
    components: [ComponentId; 2],
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let map = maps.ways();
    if let Some(target) = target {
        let options = target.options(map, &format!("No path through {}", args.map.title()));
        let floor = Floor::new(&map.subdivision, &map.mesh);
        save(target, floor.apart(ends.map(|place| place.point), components, &options), out)?;
    }
    let [start_faces, goal_faces] = components.map(|c| map.mesh.component_faces(c).count());
    let nearest = map.mesh.nearest_reachable(components[0], ends[1].point);
    if args.json {
        // The components of the start and of the goal, and the nearest point that can be reached.
        let apart = fields! {
            start_component: components[0].0,
            start_faces,
            goal_component: components[1].0,
            goal_faces,
            nearest_reachable: nearest.map(|nearest| map.in_file(nearest.place.point)),
        };
        out.json(&maps.answer(ends, moved, Some(apart), &[]))?;
        return Ok(Answer::No);
    }
    let [from, to] = ends.map(|place| point(map, place.point));
    let [a, b] = components;
    let [start_faces, goal_faces] = [start_faces, goal_faces].map(faces);
    let agent = maps.inset.as_ref().map(|inset| format!(" for a radius of {}", inset.radius())).unwrap_or_default();
    writeln!(out, "no path{agent}: {from} is in {a} of {start_faces}, {to} is in {b} of {goal_faces}")?;
    if let Some(nearest) = nearest {
        let (at, face) = (point(map, nearest.place.point), nearest.place.face);
        writeln!(out, "  nearest point that can be reached: {at} in {face}, {} away", nearest.distance)?;
    }
    Ok(Answer::No)
}

fn row(map: &Map, algorithm: PathAlgorithm, route: &Route, costs: Option<&FaceMap<f64>>) -> Row {
    Row {
        cost: costs.map(|costs| map.mesh.cost_along(route, costs)),
        points: route.points.iter().map(|&p| map.in_file(p).to_vec()).collect(),
        portals: Some(route.portals.iter().map(ToString::to_string).collect()),
        ..Row::new(algorithm, route.length, (&route.corners, &route.faces), route.work)
    }
}
