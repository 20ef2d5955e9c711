//! Links: teleports, ladders, leaps, stairs to another storey.
//!
//! ```text
//!   storey 1   ┌───────────────────┐      A link leads from one place to another, one way, at a cost; it need not be on
//!              │   ●───────> goal  │      the mesh between them. Storeys over each other are meshes of their own, which
//!              └───↑───────────────┘      only links join.
//!   storey 0   ┌───↑───────────────┐
//!              │   ●<───── start   │      Legs run over a mesh, from the start or the end of a link to the beginning of a
//!              └───────────────────┘      link or to the goal.
//! ```
//!
//! The search is Dijkstra's over the ends of the links. What lies between two of them is first guessed as the crow
//! flies, and found out when that guess comes to the front: so few legs are ever searched for. With
//! [`PathAlgorithm::Exact`] for the legs the whole is the shortest of all.
//!
//! Source: Dellin and Srinivasa, *A unifying formalism for shortest path problems with expensive edge evaluations*, 2016.

use super::nearest::distance;
use super::{DistanceField, NavMesh, PathAlgorithm, Planner, QueryPoint, Route, Work};
use crate::ids::FaceMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A place on one of several meshes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stop {
    /// Which mesh, by its index.
    pub layer: usize,
    /// Where on it.
    pub place: QueryPoint,
}

/// A way from one place to another that is not on the mesh, in this direction only.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Link {
    /// Where it begins.
    pub from: Stop,
    /// Where it ends.
    pub to: Stop,
    /// What it costs to use it, in the unit of lengths; not negative.
    pub cost: f64,
}

/// A piece of a path that lies on one mesh.
#[derive(Clone, PartialEq, Debug)]
pub struct Leg {
    /// Which mesh.
    pub layer: usize,
    /// The piece.
    pub route: Route,
}

/// A path over meshes and links.
#[derive(Clone, PartialEq, Debug)]
pub struct LinkedRoute {
    /// The legs in order. A leg has no length where one link begins at the end of another.
    pub legs: Vec<Leg>,
    /// The links between them, by their indices: one fewer than legs.
    pub links: Vec<usize>,
    /// The lengths of the legs and the costs of the links.
    pub cost: f64,
    /// The work for all legs that were searched for.
    pub work: Work,
}

/// Why there is no path over meshes and links.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LinkError {
    /// A cost below 0 would make round trips worth while; one that is no number cannot be compared.
    #[error("link {link} costs {cost}: give 0 or more")]
    Cost {
        /// The link, from 0.
        link: usize,
        /// Its cost.
        cost: f64,
    },
    /// A place is on a mesh that is not there.
    #[error("there is no layer {layer}: there are {layers}, from 0")]
    NoSuchLayer {
        /// The layer that was named.
        layer: usize,
        /// How many there are.
        layers: usize,
    },
    /// Neither the meshes nor the links lead there.
    #[error("there is no path: neither the mesh nor the links lead from the start to the goal")]
    Unreachable,
}

/// A piece between two stops: from node `from` to target `to`.
struct Piece<R> {
    from: usize,
    to: usize,
    /// The cost up to its beginning.
    before: f64,
    /// Once it was searched for.
    route: Option<R>,
}

/// What a search over links found.
pub(super) struct Found<R> {
    /// The legs to the goal, and the links between them; none without a goal.
    pub(super) legs: Vec<(usize, R)>,
    pub(super) links: Vec<usize>,
    pub(super) cost: f64,
    /// The least cost to the start, and to the end of each link; infinite if they were not reached.
    pub(super) reached: Vec<f64>,
}

/// The cheapest path over links that cost `costs`. Node 0 is the start and node i + 1 the end of link i; target i is the
/// beginning of link i, and the target after the last link the goal. `guess` gives at most the cost of the leg from a
/// node to a target, or none if there is none; `search` gives the leg and its cost.
///
/// Without a goal all ends of links within the limit are reached, and what is found has no legs.
pub(super) fn over_links<R>(
    costs: &[f64],
    goal: Option<()>,
    limit: f64,
    guess: impl Fn(usize, usize) -> Option<f64>,
    mut search: impl FnMut(usize, usize) -> Option<(f64, R)>,
) -> Option<Found<R>> {
    let goal_target = costs.len();
    let targets = goal_target + usize::from(goal.is_some());
    let mut pieces: Vec<Piece<R>> = Vec::new();
    let mut queue: BinaryHeap<Reverse<(u64, usize)>> = BinaryHeap::new();
    // By which piece each node was reached first, that is, at the least cost.
    let mut reached: Vec<Option<usize>> = vec![None; costs.len() + 1];
    let mut least = vec![f64::INFINITY; costs.len() + 1];
    let mut settled = Some((0, 0.0));
    loop {
        if let Some((from, before)) = settled.take() {
            least[from] = before;
            for to in 0..targets {
                let is_new = to == goal_target || reached[to + 1].is_none();
                let Some(leg) = guess(from, to).filter(|_| is_new) else { continue };
                let whole = before + leg + costs.get(to).unwrap_or(&0.0);
                if whole <= limit {
                    queue.push(Reverse((whole.to_bits(), pieces.len())));
                    pieces.push(Piece { from, to, before, route: None });
                }
            }
        }
        let Some(Reverse((key, i))) = queue.pop() else {
            let all = Found { legs: Vec::new(), links: Vec::new(), cost: 0.0, reached: least };
            return goal.is_none().then_some(all);
        };
        let Piece { from, to, before, .. } = pieces[i];
        if to != goal_target && reached[to + 1].is_some() {
            continue;
        }
        if pieces[i].route.is_none() {
            let Some((leg, route)) = search(from, to) else { continue };
            // Rounding of the length must not bring it before what came to the front already.
            let known = (before + leg + costs.get(to).unwrap_or(&0.0)).max(f64::from_bits(key));
            if known <= limit {
                pieces[i].route = Some(route);
                queue.push(Reverse((known.to_bits(), i)));
            }
            continue;
        }
        let cost = f64::from_bits(key);
        if to == goal_target {
            return Some(trace(pieces, &reached, i, cost, least));
        }
        reached[to + 1] = Some(i);
        settled = Some((to + 1, cost));
    }
}

/// The legs that led to the last piece.
fn trace<R>(mut pieces: Vec<Piece<R>>, by: &[Option<usize>], last: usize, cost: f64, reached: Vec<f64>) -> Found<R> {
    let mut found = Found { legs: Vec::new(), links: Vec::new(), cost, reached };
    let mut at = Some(last);
    while let Some(i) = at {
        let Piece { from, ref mut route, .. } = pieces[i];
        found.legs.extend(route.take().map(|route| (from, route)));
        found.links.extend(from.checked_sub(1));
        at = by[from];
    }
    found.legs.reverse();
    found.links.reverse();
    found
}

/// Of what is found for each pair of a start and a goal, by their numbers, the cheapest; of equals the first. With it its
/// pair. A pair that nothing joins is passed over.
pub(super) fn cheapest_pair<R>(
    [starts, goals]: [usize; 2],
    mut find: impl FnMut([usize; 2]) -> Result<R, LinkError>,
    cost: impl Fn(&R) -> f64,
) -> Result<(R, [usize; 2]), LinkError> {
    let mut best: Option<(R, [usize; 2])> = None;
    for pair in (0..starts).flat_map(|i| (0..goals).map(move |k| [i, k])) {
        match find(pair) {
            Ok(path) if best.as_ref().is_none_or(|(least, _)| cost(&path) < cost(least)) => best = Some((path, pair)),
            Ok(_) | Err(LinkError::Unreachable) => {}
            Err(error) => return Err(error),
        }
    }
    best.ok_or(LinkError::Unreachable)
}

/// The costs of links, if they can be compared.
pub(super) fn checked_costs(costs: impl Iterator<Item = f64>) -> Result<Vec<f64>, LinkError> {
    let checked = |(link, cost): (usize, f64)| {
        if cost.is_finite() && cost >= 0.0 { Ok(cost) } else { Err(LinkError::Cost { link, cost }) }
    };
    costs.enumerate().map(checked).collect()
}

/// The same, if there are no other layers than so many.
pub(super) fn check(layers: usize, links: &[Link], ends: &[&Stop]) -> Result<Vec<f64>, LinkError> {
    let stops = links.iter().flat_map(|link| [&link.from, &link.to]).chain(ends.iter().copied());
    match stops.into_iter().find(|stop| stop.layer >= layers) {
        Some(stop) => Err(LinkError::NoSuchLayer { layer: stop.layer, layers }),
        None => checked_costs(links.iter().map(|link| link.cost)),
    }
}

impl Planner {
    /// A path between two places over several meshes and the links between and on them. For one mesh, give
    /// `std::slice::from_ref(&mesh)`.
    ///
    /// Each leg is found by `algorithm`; which links are used is decided by the lengths of the legs and the costs of the
    /// links. With [`PathAlgorithm::Exact`] the answer is the path of the least cost.
    ///
    /// Cost: at most (k + 1)² searches for k links, and far fewer where links are far from each other: only legs that
    /// may be part of the best path by the distance as the crow flies are searched for.
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// ```
    /// use dcel_kit::navmesh::{Link, NavMesh, Planner, PathAlgorithm, Stop};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let floors = [NavMesh::new(&Subdivision::polygon(&hall)?)?, NavMesh::new(&Subdivision::polygon(&hall)?)?];
    /// let stop = |layer: usize, x, y| floors[layer].place(Point::new(x, y)).map(|place| Stop { layer, place });
    /// let stairs = Link { from: stop(0, 7.0, 2.0)?, to: stop(1, 5.0, 2.0)?, cost: 3.0 };
    /// let path = Planner::new().linked_route(&floors, &[stairs], PathAlgorithm::Exact, &stop(0, 1.0, 2.0)?, &stop(1, 1.0, 2.0)?)?;
    /// assert_eq!((path.legs.len(), path.links.as_slice(), path.cost), (2, [0].as_slice(), 6.0 + 3.0 + 4.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn linked_route(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        algorithm: PathAlgorithm,
        start: &Stop,
        goal: &Stop,
    ) -> Result<LinkedRoute, LinkError> {
        self.over_links(layers, links, algorithm, None, [start, goal])
    }

    /// The cheapest of the paths over links from one of the starts to one of the goals, as from all sides of a double corner;
    /// of equals the first. With it the numbers of its start and its goal. With `costs` a path is found as by
    /// [`weighted_linked_route`](Self::weighted_linked_route).
    ///
    /// Cost: that of [`linked_route`](Self::linked_route) for each pair.
    ///
    /// # Errors
    /// [`LinkError::Unreachable`] if there is no path from any of them to any; any other error of one pair.
    ///
    /// # Panics
    /// As [`weighted_linked_route`](Self::weighted_linked_route), if there are costs.
    ///
    /// ```
    /// use dcel_kit::navmesh::{Link, NavMesh, PathAlgorithm, Planner, Stop};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// use dcel_kit::topology::PolygonList;
    /// // Two squares that touch in a corner, which nobody passes.
    /// let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (8., 4.), (8., 8.), (4., 8.)].map(Point::from);
    /// let mut faces = PolygonList::new();
    /// faces.push_face(&[0, 1, 2, 3]);
    /// faces.push_face(&[2, 4, 5, 6]);
    /// let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &faces)?)?;
    /// let stops = |x, y| -> Result<Vec<Stop>, Box<dyn std::error::Error>> {
    ///     Ok(mesh.places(Point::new(x, y))?.into_iter().map(|place| Stop { layer: 0, place }).collect())
    /// };
    /// let link = Link { from: stops(1., 2.)?[0], to: stops(7., 4.)?[0], cost: 1.0 };
    /// let (starts, goals) = (stops(1., 1.)?, stops(4., 4.)?);
    /// let layers = std::slice::from_ref(&mesh);
    /// let path = Planner::new().linked_route_among(layers, &[link], PathAlgorithm::Exact, None, [&starts, &goals])?;
    /// assert_eq!((goals.len(), path.0.cost), (2, 18f64.sqrt()), "on foot");
    /// let goals = &goals[1..];
    /// let path = Planner::new().linked_route_among(layers, &[link], PathAlgorithm::Exact, None, [&starts, goals])?;
    /// assert_eq!(path.0.cost, 1.0 + 1.0 + 3.0, "the other side of the corner");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn linked_route_among(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        algorithm: PathAlgorithm,
        costs: Option<&[FaceMap<f64>]>,
        [starts, goals]: [&[Stop]; 2],
    ) -> Result<(LinkedRoute, [usize; 2]), LinkError> {
        let find = |[i, k]: [usize; 2]| self.over_links(layers, links, algorithm, costs, [&starts[i], &goals[k]]);
        cheapest_pair([starts.len(), goals.len()], find, |path| path.cost)
    }

    /// [`linked_route`](Self::linked_route) where a unit of length in a face costs as much as `costs` says, layer by layer.
    /// Legs are found as by [`weighted_route`](Self::weighted_route), so they are good ones and not the cheapest of all;
    /// which links are used is decided by what these legs cost.
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// # Panics
    /// If there are not as many costs as layers, or some are shorter than [`face_bound`](NavMesh::face_bound).
    ///
    /// ```
    /// use dcel_kit::navmesh::{Link, NavMesh, Planner, PathAlgorithm, Stop};
    /// use dcel_kit::{FaceMap, plane::{Point, Subdivision}};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let hall = NavMesh::new(&Subdivision::polygon(&hall)?)?;
    /// let stop = |x, y| hall.place(Point::new(x, y)).map(|place| Stop { layer: 0, place });
    /// let ferry = Link { from: stop(1., 3.)?, to: stop(7., 3.)?, cost: 8.0 };
    /// let mut costs = FaceMap::filled(hall.face_bound(), 1.0);
    /// let mut planner = Planner::new();
    /// let mut path = |costs: &FaceMap<f64>| {
    ///     let (layers, costs) = (std::slice::from_ref(&hall), std::slice::from_ref(costs));
    ///     planner.weighted_linked_route(layers, &[ferry], PathAlgorithm::Closest, costs, &stop(1., 2.)?, &stop(7., 2.)?)
    ///         .map_err(Box::<dyn std::error::Error>::from)
    /// };
    /// assert_eq!(path(&costs)?.links.len(), 0, "6 on foot, 1 + 8 + 1 by the ferry");
    /// costs[dcel_kit::FaceId::new(1)] = 2.0;
    /// assert_eq!(path(&costs)?.cost, 2.0 + 8.0 + 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn weighted_linked_route(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        algorithm: PathAlgorithm,
        costs: &[FaceMap<f64>],
        start: &Stop,
        goal: &Stop,
    ) -> Result<LinkedRoute, LinkError> {
        self.over_links(layers, links, algorithm, Some(costs), [start, goal])
    }

    /// Both kinds of linked routes.
    fn over_links(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        algorithm: PathAlgorithm,
        costs: Option<&[FaceMap<f64>]>,
        [start, goal]: [&Stop; 2],
    ) -> Result<LinkedRoute, LinkError> {
        if let Some(costs) = costs {
            assert_eq!(costs.len(), layers.len(), "costs for every layer");
        }
        let prices = check(layers.len(), links, &[start, goal])?;
        // What a unit as the crow flies costs at least on a layer.
        let cheapest = |(layer, mesh): (usize, &NavMesh)| {
            costs.map_or(1.0, |all| mesh.faces().map(|f| all[layer][f].max(0.0)).fold(f64::INFINITY, f64::min))
        };
        let least: Vec<f64> = layers.iter().enumerate().map(cheapest).collect();
        let mut work = Work::default();
        let node = |i: usize| if i == 0 { start } else { &links[i - 1].to };
        let target = |i: usize| links.get(i).map_or(goal, |link| &link.from);
        let found = over_links(
            &prices,
            Some(()),
            f64::INFINITY,
            |from, to| Some(least[node(from).layer] * as_crow_flies(layers, node(from), target(to))?),
            |from, to| {
                let Stop { layer, place: ref from } = *node(from);
                let (mesh, to) = (&layers[layer], &target(to).place);
                let (cost, route) = match costs.map(|all| &all[layer]) {
                    Some(costs) => {
                        let route = self.weighted_route(mesh, algorithm, costs, from, to).ok()?;
                        (mesh.cost_along(&route, costs), route)
                    }
                    None => {
                        let route = self.route(mesh, algorithm, from, to).ok()?;
                        (route.length, route)
                    }
                };
                work += route.work;
                Some((cost, route))
            },
        );
        let Found { legs, links, cost, .. } = found.ok_or(LinkError::Unreachable)?;
        let legs = legs.into_iter().map(|(from, route)| Leg { layer: node(from).layer, route }).collect();
        Ok(LinkedRoute { legs, links, cost, work })
    }

    /// How far it is from a place to all vertices of all layers, over the meshes and links, as far as that is no more
    /// than `limit`. One field for each layer.
    ///
    /// Cost: that of a [`distance_field`](Self::distance_field) for the start and for each link that is reached, and
    /// that of the legs between links.
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// ```
    /// use dcel_kit::navmesh::{Link, NavMesh, Planner, Stop};
    /// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let hall = NavMesh::new(&Subdivision::polygon(&hall)?)?;
    /// let stop = |x, y| hall.place(Point::new(x, y)).map(|place| Stop { layer: 0, place });
    /// let teleport = Link { from: stop(1., 3.)?, to: stop(8., 1.)?, cost: 0.5 };
    /// let layers = std::slice::from_ref(&hall);
    /// let fields = Planner::new().linked_distance_field(layers, &[teleport], &stop(1., 2.)?, f64::INFINITY)?;
    /// assert_eq!(fields[0].distance(VertexId::new(1)), Some(1.0 + 0.5 + 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn linked_distance_field(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        start: &Stop,
        limit: f64,
    ) -> Result<Vec<DistanceField>, LinkError> {
        let costs = check(layers.len(), links, &[start])?;
        let node = |i: usize| if i == 0 { start } else { &links[i - 1].to };
        let found = over_links(
            &costs,
            None,
            limit,
            |from, to| as_crow_flies(layers, node(from), &links[to].from),
            |from, to| {
                let [from, to] = [node(from), &links[to].from];
                let route = self.route(&layers[from.layer], PathAlgorithm::Exact, &from.place, &to.place).ok()?;
                Some((route.length, ()))
            },
        );
        let mut fields: Vec<DistanceField> =
            layers.iter().map(|mesh| DistanceField::new(mesh, &start.place, limit)).collect();
        let reached = found.map_or_else(Vec::new, |found| found.reached);
        for (i, &before) in reached.iter().enumerate().filter(|(_, before)| before.is_finite()) {
            let Stop { layer, ref place } = *node(i);
            let near = self.distance_field(&layers[layer], place, limit - before);
            fields[layer].join(&near, before);
        }
        Ok(fields)
    }
}

/// The distance of two stops of one layer, as the crow flies; none if nothing joins them.
fn as_crow_flies(layers: &[NavMesh], a: &Stop, b: &Stop) -> Option<f64> {
    let joined = a.layer == b.layer && is_joined(&layers[a.layer], &a.place, &b.place);
    joined.then(|| distance(a.place.point, b.place.point))
}

/// Whether two places are in one component, as far as their faces tell.
fn is_joined(mesh: &NavMesh, a: &QueryPoint, b: &QueryPoint) -> bool {
    let [a, b] = [a, b].map(|place| mesh.component(place.face));
    a.is_some() && a == b
}
