//! Links between places of a surface: teleports, lifts, jumps.

use super::super::links::{Found, LinkError, cheapest_pair, checked_costs, over_links};
use super::super::{PathAlgorithm, Work};
use super::{NavSurface, SurfaceField, SurfacePlanner, SurfacePoint, SurfaceRoute, between};
use crate::ids::FaceMap;

/// A way from one place of a surface to another that is not on it, in this direction only.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceLink {
    /// Where it begins.
    pub from: SurfacePoint,
    /// Where it ends.
    pub to: SurfacePoint,
    /// What it costs to use it, in the unit of lengths; not negative.
    pub cost: f64,
}

/// A path over a surface and over links.
#[derive(Clone, PartialEq, Debug)]
pub struct LinkedSurfaceRoute {
    /// The legs in order.
    pub legs: Vec<SurfaceRoute>,
    /// The links between them, by their indices: one fewer than legs.
    pub links: Vec<usize>,
    /// The lengths of the legs, or what they cost, and the costs of the links.
    pub cost: f64,
    /// The work for all legs that were searched for.
    pub work: Work,
}

impl SurfacePlanner {
    /// A path over a surface and links. Each leg is found by `algorithm`, or for the costs of faces if there are any; which
    /// links are used is decided by what legs and links cost. With [`PathAlgorithm::Exact`] and no costs the answer is the path of
    /// the least cost.
    ///
    /// Cost: as [`Planner::linked_route`](super::super::Planner::linked_route).
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// # Panics
    /// If there are costs and they are shorter than [`face_bound`](NavSurface::face_bound).
    pub fn linked_route(
        &mut self,
        surface: &NavSurface,
        links: &[SurfaceLink],
        algorithm: PathAlgorithm,
        costs: Option<&FaceMap<f64>>,
        [start, goal]: [&SurfacePoint; 2],
    ) -> Result<LinkedSurfaceRoute, LinkError> {
        let prices = checked_costs(links.iter().map(|link| link.cost))?;
        let target = |i: usize| links.get(i).map_or(goal, |link| &link.from);
        let least = costs.map_or(1.0, |costs| surface.faces().map(|f| costs[f].max(0.0)).fold(f64::INFINITY, f64::min));
        let mut work = Work::default();
        let found = over_links(
            &prices,
            Some(()),
            f64::INFINITY,
            |from, to| Some(least * as_crow_flies(surface, node(links, start, from), target(to))?),
            |from, to| {
                let [from, to] = [node(links, start, from), target(to)];
                let route = match costs {
                    Some(costs) => self.weighted_route(surface, algorithm, costs, from, to),
                    None => self.route(surface, algorithm, from, to),
                };
                let route = route.ok()?;
                work += route.work;
                Some((route.cost, route))
            },
        );
        let Found { legs, links, cost, .. } = found.ok_or(LinkError::Unreachable)?;
        Ok(LinkedSurfaceRoute { legs: legs.into_iter().map(|(_, route)| route).collect(), links, cost, work })
    }

    /// The cheapest of the paths over links from one of the starts to one of the goals, as where faces touch in a vertex; of
    /// equals the first. With it the numbers of its start and its goal.
    ///
    /// Cost: that of [`linked_route`](Self::linked_route) for each pair.
    ///
    /// # Errors
    /// [`LinkError::Unreachable`] if there is no path from any of them to any; any other error of one pair.
    ///
    /// # Panics
    /// As [`linked_route`](Self::linked_route).
    pub fn linked_route_among(
        &mut self,
        surface: &NavSurface,
        links: &[SurfaceLink],
        algorithm: PathAlgorithm,
        costs: Option<&FaceMap<f64>>,
        [starts, goals]: [&[SurfacePoint]; 2],
    ) -> Result<(LinkedSurfaceRoute, [usize; 2]), LinkError> {
        let find = |[i, k]: [usize; 2]| self.linked_route(surface, links, algorithm, costs, [&starts[i], &goals[k]]);
        cheapest_pair([starts.len(), goals.len()], find, |path| path.cost)
    }

    /// How far it is from a place to all vertices over the surface and links, as far as that is no more than `limit`.
    ///
    /// Cost: that of a [`distance_field`](Self::distance_field) for the start and for each link that is reached, and
    /// that of the legs between links.
    ///
    /// # Errors
    /// [`LinkError`].
    pub fn linked_distance_field(
        &mut self,
        surface: &NavSurface,
        links: &[SurfaceLink],
        start: &SurfacePoint,
        limit: f64,
    ) -> Result<SurfaceField, LinkError> {
        let prices = checked_costs(links.iter().map(|link| link.cost))?;
        let found = over_links(
            &prices,
            None,
            limit,
            |from, to| as_crow_flies(surface, node(links, start, from), &links[to].from),
            |from, to| {
                let route =
                    self.route(surface, PathAlgorithm::Exact, node(links, start, from), &links[to].from).ok()?;
                Some((route.length, ()))
            },
        );
        let reached = found.map_or_else(Vec::new, |found| found.reached);
        let mut whole: Option<SurfaceField> = None;
        for (i, &before) in reached.iter().enumerate().filter(|(_, before)| before.is_finite()) {
            let field = self.distance_field(surface, node(links, start, i), limit - before);
            match &mut whole {
                Some(whole) => whole.join(&field, before),
                None => whole = Some(field),
            }
        }
        Ok(whole.unwrap_or_else(|| self.distance_field(surface, start, limit)))
    }
}

fn node<'a>(links: &'a [SurfaceLink], start: &'a SurfacePoint, i: usize) -> &'a SurfacePoint {
    if i == 0 { start } else { &links[i - 1].to }
}

/// The distance of two places, as the crow flies; none if the surface does not lead from one to the other.
fn as_crow_flies(surface: &NavSurface, a: &SurfacePoint, b: &SurfacePoint) -> Option<f64> {
    let joined = surface.component(a.face) == surface.component(b.face);
    joined.then(|| between(a.point, b.point))
}
