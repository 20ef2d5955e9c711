//! What every path algorithm gives: a route.
//!
//! ```text
//!   faces      f3    f7    f8    f2          portals[i] leads from faces[i] to faces[i + 1]:
//!   portals         h9    h15   h4             a half-edge whose face is faces[i]
//!   points     s ─────●──────────── t        the start, the corners, the goal
//! ```

use super::{ComponentId, NavMesh, QueryPointError};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;

crate::named! {
    /// The path algorithms: how a route is found.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    #[non_exhaustive]
    pub enum PathAlgorithm {
        /// Breadth first: the fewest faces; it runs from junction to junction, see
        /// [`link_junctions`](NavMesh::link_junctions).
        Breadth = "breadth",
        /// A* from centroid to centroid of the faces.
        Centroid = "centroid",
        /// A* from midpoint to midpoint of the portals.
        Midpoint = "midpoint",
        /// A* from each portal to the closest point on the next.
        Closest = "closest",
        /// A* from each portal to where the straight line to the goal meets the next.
        Aimed = "aimed",
        /// The shortest path of all; it runs over merged faces, see [`merge_faces`](NavMesh::merge_faces).
        Exact = "exact",
    }

    /// One word for it.
    fn name as Display;
    /// All of them, from the lowest to the highest.
    const ALL;
}

impl PathAlgorithm {
    /// What is searched by where faces have costs: neither the fewest faces nor an exact path is known there.
    pub(super) fn over_costs(self) -> Self {
        if matches!(self, Self::Breadth | Self::Exact) { Self::Closest } else { self }
    }
}

/// How much work a search took: to be compared where times cannot be.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Work {
    /// How often something was taken from the queue.
    pub pops: u64,
    /// How often something was put into the queue.
    pub pushes: u64,
    /// How many faces were entered, each as often as it was.
    pub expansions: u64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, more: Self) {
        self.pops += more.pops;
        self.pushes += more.pushes;
        self.expansions += more.expansions;
    }
}

/// A path from one point to another: through which faces, by which portals, along which points.
#[derive(Clone, PartialEq, Debug)]
pub struct Route {
    /// The faces in order. At a point on an edge or vertex the first or last may be any face there.
    pub faces: Vec<FaceId>,
    /// One fewer: `portals[i]` is the half-edge of `faces[i]` by which `faces[i + 1]` is entered.
    pub portals: Vec<HalfEdgeId>,
    /// The start, where the path bends, the goal.
    pub points: Vec<Point>,
    /// The vertices it bends at: those of `points` without the first and the last. Empty for an agent with a
    /// radius, whose way bends beside the vertices.
    pub corners: Vec<VertexId>,
    /// The length of the path, in units of the map.
    pub length: f64,
    /// What it took to find.
    pub work: Work,
}

/// A portal with its two endpoints, seen by who goes through.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Portal {
    /// The half-edge of `from`.
    pub half_edge: HalfEdgeId,
    /// The vertex on the left.
    pub left: VertexId,
    /// The vertex on the right.
    pub right: VertexId,
    /// The face that is left.
    pub from: FaceId,
    /// The face that is entered.
    pub to: FaceId,
}

impl Route {
    /// The portals of the route with their endpoints. O(sides of its faces).
    pub fn portal_ends<'a>(&'a self, mesh: &'a NavMesh) -> impl Iterator<Item = Portal> + Clone + 'a {
        self.portals.iter().zip(self.faces.windows(2)).filter_map(move |(&half_edge, pair)| {
            let side = mesh.sides(pair[0]).find(|side| side.half_edge == half_edge)?;
            Some(Portal { half_edge, left: side.to, right: side.from, from: pair[0], to: pair[1] })
        })
    }
}

/// Why there is no path between two places.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RouteError {
    /// The start is no place to stand.
    #[error("the start: {0}")]
    Start(QueryPointError),
    /// The goal is no place to stand.
    #[error("the goal: {0}")]
    Goal(QueryPointError),
    /// The two places are in different components: that is the proof that there is no path.
    #[error(
        "there is no path: {from} is in {start}, {to} is in {goal}; nearest_reachable gives the nearest place that can be reached"
    )]
    Unreachable {
        /// A face at the start.
        from: FaceId,
        /// A face at the goal.
        to: FaceId,
        /// The component of the start.
        start: ComponentId,
        /// The component of the goal.
        goal: ComponentId,
    },
    /// There is a way, but none is wide enough.
    #[error("no path from {from} to {to} is wide enough for an agent of radius {radius}; try a smaller one")]
    TooNarrow {
        /// A face at the start.
        from: FaceId,
        /// A face at the goal.
        to: FaceId,
        /// The radius of the agent.
        radius: f64,
    },
}

/// Of what is found for each pair of a start and a goal, by their numbers, the shortest; of equals the first. With it its
/// pair. If there is nothing, why it is so for the first pair.
pub(super) fn shortest_pair<R, E>(
    [starts, goals]: [usize; 2],
    mut find: impl FnMut([usize; 2]) -> Result<R, E>,
    length: impl Fn(&R) -> f64,
) -> Result<(R, [usize; 2]), E> {
    assert!(starts > 0 && goals > 0, "a route has two ends");
    let (mut best, mut first_error) = (None, None);
    for pair in (0..starts).flat_map(|i| (0..goals).map(move |k| [i, k])) {
        match find(pair) {
            Ok(route) if best.as_ref().is_none_or(|(least, _)| length(&route) < length(least)) => {
                best = Some((route, pair));
            }
            Ok(_) => {}
            Err(error) => _ = first_error.get_or_insert(error),
        }
    }
    best.ok_or_else(|| first_error.expect("there is a pair"))
}
