//! Links: teleports, ladders, jumps, stairs to another storey.
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
//! [`Rung::Exact`] for the legs the whole is the shortest of all.
//!
//! Source: Dellin and Srinivasa, *A unifying formalism for shortest path problems with expensive edge evaluations*, 2016.

use super::nearest::distance;
use super::{NavMesh, Place, Planner, Route, Rung, Work};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A place on one of several meshes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stop {
    /// Which mesh, by its index.
    pub layer: usize,
    /// Where on it.
    pub place: Place,
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
struct Piece {
    from: usize,
    to: usize,
    /// The cost up to its beginning.
    before: f64,
    /// Once it was searched for.
    route: Option<Route>,
}

impl Planner {
    /// A path between two places over several meshes and the links between and on them. For one mesh, give
    /// `std::slice::from_ref(&mesh)`.
    ///
    /// Each leg is found by `rung`; which links are used is decided by the lengths of the legs and the costs of the
    /// links. With [`Rung::Exact`] the answer is the path of the least cost.
    ///
    /// Cost: at most (k + 1)² searches for k links, and far fewer where links are far from each other: only legs that
    /// may be part of the best path by the distance as the crow flies are searched for.
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// ```
    /// use dcel_kit::navmesh::{Link, NavMesh, Planner, Rung, Stop};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let floors = [NavMesh::new(&Subdivision::polygon(&hall)?)?, NavMesh::new(&Subdivision::polygon(&hall)?)?];
    /// let stop = |layer: usize, x, y| floors[layer].place(Point::new(x, y)).map(|place| Stop { layer, place });
    /// let stairs = Link { from: stop(0, 7.0, 2.0)?, to: stop(1, 5.0, 2.0)?, cost: 3.0 };
    /// let path = Planner::new().linked_route(&floors, &[stairs], Rung::Exact, &stop(0, 1.0, 2.0)?, &stop(1, 1.0, 2.0)?)?;
    /// assert_eq!((path.legs.len(), path.links.as_slice(), path.cost), (2, [0].as_slice(), 6.0 + 3.0 + 4.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn linked_route(
        &mut self,
        layers: &[NavMesh],
        links: &[Link],
        rung: Rung,
        start: &Stop,
        goal: &Stop,
    ) -> Result<LinkedRoute, LinkError> {
        let stops = links.iter().flat_map(|link| [&link.from, &link.to]).chain([start, goal]);
        if let Some(stop) = stops.into_iter().find(|stop| stop.layer >= layers.len()) {
            return Err(LinkError::NoSuchLayer { layer: stop.layer, layers: layers.len() });
        }
        let is_bad = |link: &Link| !link.cost.is_finite() || link.cost < 0.0;
        if let Some(link) = links.iter().position(is_bad) {
            return Err(LinkError::Cost { link, cost: links[link].cost });
        }
        // Node 0 is the start, node i + 1 the end of link i; target i is the beginning of link i, the last is the goal.
        let goal_target = links.len();
        let node = |i: usize| if i == 0 { start } else { &links[i - 1].to };
        let target = |i: usize| links.get(i).map_or((goal, 0.0), |link| (&link.from, link.cost));
        let mut work = Work::default();
        let mut pieces: Vec<Piece> = Vec::new();
        let mut queue: BinaryHeap<Reverse<(u64, usize)>> = BinaryHeap::new();
        // By which piece each node was reached first, that is, at the least cost.
        let mut reached: Vec<Option<usize>> = vec![None; links.len() + 1];
        let mut settled = Some((0, 0.0));
        loop {
            if let Some((from, before)) = settled.take() {
                let here = node(from);
                for to in 0..=goal_target {
                    let (there, cost) = target(to);
                    let is_new = to == goal_target || reached[to + 1].is_none();
                    if is_new && here.layer == there.layer && is_joined(&layers[here.layer], &here.place, &there.place)
                    {
                        let guess = before + distance(here.place.point, there.place.point) + cost;
                        queue.push(Reverse((guess.to_bits(), pieces.len())));
                        pieces.push(Piece { from, to, before, route: None });
                    }
                }
            }
            let Some(Reverse((key, i))) = queue.pop() else { return Err(LinkError::Unreachable) };
            let Piece { from, to, before, .. } = pieces[i];
            if to != goal_target && reached[to + 1].is_some() {
                continue;
            }
            if pieces[i].route.is_none() {
                let (here, (there, cost)) = (node(from), target(to));
                let Ok(route) = self.route(&layers[here.layer], rung, &here.place, &there.place) else { continue };
                work.pops += route.work.pops;
                work.pushes += route.work.pushes;
                work.expansions += route.work.expansions;
                // Rounding of the length must not bring it before what came to the front already.
                let known = (before + route.length + cost).to_bits().max(key);
                pieces[i].route = Some(route);
                queue.push(Reverse((known, i)));
                continue;
            }
            if to == goal_target {
                return Ok(trace(pieces, &reached, i, node, f64::from_bits(key), work));
            }
            reached[to + 1] = Some(i);
            settled = Some((to + 1, f64::from_bits(key)));
        }
    }
}

/// The legs that led to the last piece.
fn trace<'a>(
    mut pieces: Vec<Piece>,
    reached: &[Option<usize>],
    last: usize,
    node: impl Fn(usize) -> &'a Stop,
    cost: f64,
    work: Work,
) -> LinkedRoute {
    let mut found = LinkedRoute { legs: Vec::new(), links: Vec::new(), cost, work };
    let mut at = Some(last);
    while let Some(i) = at {
        let Piece { from, ref mut route, .. } = pieces[i];
        found.legs.extend(route.take().map(|route| Leg { layer: node(from).layer, route }));
        found.links.extend(from.checked_sub(1));
        at = reached[from];
    }
    found.legs.reverse();
    found.links.reverse();
    found
}

/// Whether two places are in one component, as far as their faces tell.
fn is_joined(mesh: &NavMesh, a: &Place, b: &Place) -> bool {
    let [a, b] = [a, b].map(|place| mesh.component(place.face));
    a.is_some() && a == b
}
