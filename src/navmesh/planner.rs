//! The planner: one place for all searches, which keeps its memory from query to query.
//!
//! ```text
//!   start, goal ──> the same component? ──> portal paths of dead ends ──> search ──> faces ──> funnel ──> route
//! ```
//!
//! A query writes a number of its own into whatever record it uses, so that nothing has to be cleared. The mesh makes its
//! merged faces and junctions when the first query needs them.

use super::bidirectional_bfs::{self, BidirectionalBfs};
use super::corridor;
use super::exact::Exact;
use super::marks::NONE;
use super::merged::Merged;
use super::reduced_astar::{self, ReducedAStar};
use super::reduced_bfs::{self, ReducedBfs};
use super::route::shortest_pair;
use super::scratch::Scratch;
use super::{DistanceField, NavMesh, PathAlgorithm, QueryPoint, Route, RouteError, portals};
use crate::ids::{FaceId, FaceMap};
use crate::plane::Point;

/// Finds routes. One planner serves any number of queries, on any mesh, and allocates next to nothing after the first.
///
/// ```
/// use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
/// use dcel_kit::plane::{Point, Subdivision};
/// let at = |x, y| Point::new(x, y);
/// let points = vec![at(0., 0.), at(4., 0.), at(4., 4.), at(3., 1.), at(0., 1.), at(3., 4.)];
/// let mesh = NavMesh::new(&Subdivision::from_triangles(points, &[[0, 1, 3], [0, 3, 4], [1, 2, 3], [2, 5, 3]])?)?;
/// let mut planner = Planner::new();
/// let route = planner.route_between(&mesh, PathAlgorithm::Exact, at(0., 1.), at(3., 4.))?;
/// assert_eq!(route.points, [at(0., 1.), at(3., 1.), at(3., 4.)]);
/// assert_eq!(route.length, 6.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Planner {
    /// Whether merged faces and junctions are left alone.
    plain: bool,
    pub(super) scratch: Scratch,
    /// Breadth first: what was reached.
    bidirectional_bfs: BidirectionalBfs,
    /// The same from junction to junction.
    reduced_bfs: ReducedBfs,
    /// A* from junction to junction.
    reduced_astar: ReducedAStar,
    pub(super) exact: Exact,
}

impl Planner {
    /// A planner without any memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A planner that goes from face to face of the mesh as it is, over no merged faces and no junctions: to compare the
    /// work, and for figures of a search. The lengths are the same.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// // Eight triangles round a square hole of the domain: four merged faces.
    /// let points = [(0., 0.), (3., 0.), (3., 3.), (0., 3.), (1., 1.), (2., 1.), (2., 2.), (1., 2.)].map(Point::from);
    /// let sides = [0, 1, 2, 3].map(|i| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]);
    /// let triangles = sides.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).concat();
    /// let mesh = NavMesh::new(&Subdivision::from_triangles(points.to_vec(), &triangles)?)?;
    /// let [a, b] = [(1.2, 0.5), (2.5, 1.8)].map(Point::from);
    /// let plain = Planner::face_by_face().route_between(&mesh, PathAlgorithm::Exact, a, b)?;
    /// let route = Planner::new().route_between(&mesh, PathAlgorithm::Exact, a, b)?;
    /// assert_eq!(plain.length, route.length);
    /// assert!(route.work.expansions < plain.work.expansions);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn face_by_face() -> Self {
        Self { plain: true, ..Self::default() }
    }

    /// A route between two points. At a double corner, or on a wall, an end may be on several sides: then the route is
    /// the shortest of those from and to all of them; to choose a side use [`NavMesh::place_in`] and
    /// [`route`](Self::route).
    ///
    /// Cost: that of [`NavMesh::place`] twice and of [`route`](Self::route), for each pair of sides.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// // Two squares that touch in (1, 1): the goal is there, and the path ends in the square that has the start.
    /// let points = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (2., 1.), (2., 2.), (1., 2.)].map(Point::from);
    /// let mut squares = dcel_kit::topology::PolygonList::new();
    /// [[0, 1, 2, 3], [2, 4, 5, 6]].iter().for_each(|square| squares.push_face(square));
    /// let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &squares)?)?;
    /// assert!(mesh.place(points[2]).is_err());
    /// let route = Planner::new().route_between(&mesh, PathAlgorithm::Exact, points[5], points[2])?;
    /// assert_eq!((route.length, route.faces), (2f64.sqrt(), vec![dcel_kit::FaceId::new(2)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RouteError`]: one cannot stand at an end, or there is no path.
    pub fn route_between(
        &mut self,
        mesh: &NavMesh,
        algorithm: PathAlgorithm,
        start: Point,
        goal: Point,
    ) -> Result<Route, RouteError> {
        let starts = mesh.places(start).map_err(RouteError::Start)?;
        let goals = mesh.places(goal).map_err(RouteError::Goal)?;
        self.route_among(mesh, algorithm, &starts, &goals).map(|(route, _)| route)
    }

    /// The shortest of the routes from one of the starts to one of the goals; of equals the first. With it the numbers
    /// of its start and its goal.
    ///
    /// Cost: that of [`route`](Self::route) for each pair.
    ///
    /// # Errors
    /// [`RouteError::Unreachable`], of the first pair, if there is no path from any of them to any.
    ///
    /// # Panics
    /// If there are no starts or no goals.
    pub fn route_among(
        &mut self,
        mesh: &NavMesh,
        algorithm: PathAlgorithm,
        starts: &[QueryPoint],
        goals: &[QueryPoint],
    ) -> Result<(Route, [usize; 2]), RouteError> {
        let find = |[i, k]: [usize; 2]| self.route(mesh, algorithm, &starts[i], &goals[k]);
        shortest_pair([starts.len(), goals.len()], find, |route| route.length)
    }

    /// A route between two places of the mesh.
    ///
    /// [`PathAlgorithm::Exact`] gives the shortest path of all; the others find a corridor of faces by a quicker rule and the
    /// shortest path through that.
    ///
    /// The first query makes what the search runs over, if the mesh does not have it yet: merged faces for
    /// [`PathAlgorithm::Exact`], junctions for the others. It is kept through all changes of the mesh.
    ///
    /// Cost: O(n) breadth first, O(n log n) for A*. n is the number of faces that are no dead ends. Of the first query:
    /// O(n log n) more. The exact one enters few faces where the path is plain; beside a row of n pillars, from one end to the
    /// other, it is four times as long for twice as many pillars, as for a [`distance_field`](Self::distance_field).
    ///
    /// # Errors
    /// [`RouteError::Unreachable`] if there is no path.
    pub fn route(
        &mut self,
        mesh: &NavMesh,
        algorithm: PathAlgorithm,
        start: &QueryPoint,
        goal: &QueryPoint,
    ) -> Result<Route, RouteError> {
        let prepared = !self.plain && is_worth_it(mesh, start, goal);
        let merged = (prepared && algorithm == PathAlgorithm::Exact).then(|| mesh.merged());
        let junctions = (prepared && algorithm != PathAlgorithm::Exact).then(|| mesh.network());
        self.search(mesh, [start, goal], merged, None, |planner| match algorithm {
            PathAlgorithm::Breadth => match junctions {
                Some(junctions) => {
                    reduced_bfs::fewest_faces(mesh, junctions, &mut planner.reduced_bfs, &mut planner.scratch)
                }
                None => bidirectional_bfs::breadth_first(mesh, &mut planner.bidirectional_bfs, &mut planner.scratch),
            },
            PathAlgorithm::Exact => planner.exact.search(mesh, merged, &mut planner.scratch, start, goal.point),
            metric => {
                let (ends, scratch) = ([start.point, goal.point], &mut planner.scratch);
                let memory = (&mut planner.reduced_astar, &mut planner.reduced_bfs);
                junctions
                    .and_then(|junctions| reduced_astar::a_star(mesh, junctions, memory, scratch, metric, ends))
                    .unwrap_or_else(|| corridor::a_star(mesh, scratch, metric, None, |_, _| true, ends))
            }
        })
    }

    /// A route for which a unit of length in a face costs as much as `costs` says, by A* with the metric of `algorithm`.
    /// [`cost_along`](NavMesh::cost_along) says what it costs.
    ///
    /// Not exact: the corridor is a good one for these costs, and within it the way is the shortest, not the
    /// cheapest. From an end on an edge or a vertex it may lead through any of the faces there: the cheapest way of those
    /// that the search finds to them is taken. With costs below 1 the corridor, too, may be far from the best.
    ///
    /// # Errors
    /// [`RouteError::Unreachable`] if there is no path.
    ///
    /// # Panics
    /// If `costs` is shorter than [`face_bound`](NavMesh::face_bound).
    pub fn weighted_route(
        &mut self,
        mesh: &NavMesh,
        algorithm: PathAlgorithm,
        costs: &FaceMap<f64>,
        start: &QueryPoint,
        goal: &QueryPoint,
    ) -> Result<Route, RouteError> {
        assert!(costs.len() >= mesh.face_bound(), "{} costs for {} faces", costs.len(), mesh.face_bound());
        let metric = algorithm.over_costs();
        let ends = [start.point, goal.point];
        let mut best = self.search(mesh, [start, goal], None, Some(costs), |planner| {
            corridor::a_star(mesh, &mut planner.scratch, metric, Some(costs), |_, _| true, ends)
        })?;
        let others = std::mem::take(&mut self.scratch.others);
        let mut least = if others.is_empty() { 0.0 } else { mesh.cost_along(&best, costs) };
        for portals in others {
            let first = portals.last().map_or(start.face, |&(face, _)| FaceId::new(face));
            self.scratch.portals = portals;
            let way = self.scratch.pull(mesh, None, ends);
            let route = self.scratch.finish(mesh, first, way);
            let cost = mesh.cost_along(&route, costs);
            if cost < least {
                (best, least) = (route, cost);
            }
        }
        Ok(Route { work: self.scratch.work, ..best })
    }

    /// How far it is from a place to all vertices that are no further than `limit`, by the shortest paths.
    ///
    /// Cost: as an exact search that visits everything within the limit; O(n) more to begin. Each vertex in sight parts the
    /// view of those behind it, and what is parted stays apart: an open floor of n vertices in a grid takes O(n^1.5) cones,
    /// each of which looks at the corners of its room, so that twice as many vertices take up to four times as long.
    /// Beside a row of n pillars there are O(n) cones, but a hall of one face has O(n) corners that many of them look at:
    /// four times as long for twice as many pillars, in memory that is in proportion. A `limit` bounds both.
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner};
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let corners = [(0., 0.), (4., 0.), (0., 3.)].map(Point::from);
    /// let mesh = NavMesh::new(&Subdivision::polygon(&corners)?)?;
    /// let field = Planner::new().distance_field(&mesh, &mesh.place(corners[1])?, f64::INFINITY);
    /// assert_eq!(field.distance(VertexId::new(2)), Some(5.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn distance_field(&mut self, mesh: &NavMesh, start: &QueryPoint, limit: f64) -> DistanceField {
        let merged = (!self.plain).then(|| mesh.merged());
        self.scratch.begin(mesh, start, start, merged);
        self.scratch.allow_all();
        let mut field = DistanceField::new(mesh, start, limit);
        self.exact.survey(mesh, merged, &mut self.scratch, start, limit, |v, length| field.see(v, length));
        field.work = self.scratch.work;
        field
    }

    /// A route for an agent of a radius, by the portals it fits through.
    ///
    /// What it is: A* with the metric *closest* through portals at least twice the radius wide (once, if one endpoint only
    /// is on a border, and any if none is), pulled straight between endpoints that are moved inwards by the radius. So
    /// the middle of the agent passes every endpoint of a portal at that distance, measured along the portal. What it is not:
    /// beside a portal that runs aslant, and along walls between two portals, the path may be nearer to the border; and a
    /// portal that is narrow although there is room beside it (a mesh with slivers) is not passed. A start or goal
    /// nearer to the border than the radius is accepted.
    ///
    /// # Errors
    /// [`RouteError::Unreachable`], or [`RouteError::TooNarrow`] if no row of such portals leads to the goal.
    pub fn wide_route(
        &mut self,
        mesh: &NavMesh,
        radius: f64,
        start: &QueryPoint,
        goal: &QueryPoint,
    ) -> Result<Route, RouteError> {
        let fits = |face: FaceId, s: usize| portals::fits(mesh, face, s, radius);
        let (from, to) = (start.face, goal.face);
        let route = self.search(mesh, [start, goal], None, None, |planner| {
            let ends = [start.point, goal.point];
            corridor::a_star(mesh, &mut planner.scratch, PathAlgorithm::Closest, None, fits, ends)
        });
        match route {
            Ok(mut route) => {
                portals::keep_off(mesh, radius, &mut route, &mut self.scratch.funnel);
                Ok(route)
            }
            Err(RouteError::Unreachable { start, goal, .. }) if start == goal => {
                Err(RouteError::TooNarrow { from, to, radius })
            }
            Err(other) => Err(other),
        }
    }

    /// Runs a search over the faces, or over the merged ones. Of faces that have both ends the cheapest is taken.
    fn search(
        &mut self,
        mesh: &NavMesh,
        [start, goal]: [&QueryPoint; 2],
        merged: Option<&Merged>,
        costs: Option<&FaceMap<f64>>,
        find: impl FnOnce(&mut Self) -> bool,
    ) -> Result<Route, RouteError> {
        self.scratch.begin(mesh, start, goal, merged);
        let [from, to] = [start.face, goal.face];
        let apart = |start, goal| RouteError::Unreachable { from, to, start, goal };
        if let [Some(a), Some(b)] = [from, to].map(|f| mesh.component(f))
            && a != b
        {
            return Err(apart(a, b));
        }
        let common = self.scratch.starts.iter().copied().filter(|f| self.scratch.goals.contains(f));
        let cost = |&f: &FaceId| costs.map_or(1.0, |costs| costs[f].max(0.0));
        let common = common.min_by(|f, g| cost(f).total_cmp(&cost(g)));
        if common.is_none() && !find(self) {
            let [a, b] = [from, to].map(|f| mesh.component(f).unwrap_or(super::ComponentId(NONE)));
            return Err(apart(a, b));
        }
        let portals = &self.scratch.portals;
        let first = portals.last().map_or(common.unwrap_or(from), |&(face, _)| FaceId::new(face));
        let way = self.scratch.pull(mesh, merged, [start.point, goal.point]);
        let Some(merged) = merged else { return Ok(self.scratch.finish(mesh, first, way)) };
        let portals = &mut self.scratch.portals;
        let last = portals.first().map_or(first, |&(_, side)| merged.beyond(side));
        let ends = [(start, first), (goal, last)].map(|(place, whole)| merged.face_at(mesh, place, whole));
        merged.refine(mesh, ends, portals);
        Ok(self.scratch.finish(mesh, ends[0], way))
    }
}

/// Whether there is anything to search: not within a face, and not from one component to another.
fn is_worth_it(mesh: &NavMesh, start: &QueryPoint, goal: &QueryPoint) -> bool {
    start.face != goal.face && mesh.component(start.face) == mesh.component(goal.face)
}
