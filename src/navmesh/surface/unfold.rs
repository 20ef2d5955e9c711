//! A row of triangles unfolded into the plane, pulled straight, and folded back.
//!
//! ```text
//!     ╱╲╱╲            ┌───────────────┐       Unfolding keeps all lengths within the row, so the shortest path through it
//!    ╱  ╲ ╲    ──>    │╲  ╱╲   ╱╲   ╱ │       is found in the plane, by the funnel; where it passes the sides says where
//!        ╲ ╲          └───────────────┘       it runs in space.
//! ```

use super::super::funnel::{Endpoint, Funnel};
use super::super::steps::{End, Step, steps};
use super::{
    NONE, NavSurface, SideRecord, Space, SurfacePoint, SurfaceRoute, between, cross, dot, lerp, minus, next, norm, prev,
};
use crate::geometry::space::normal;
use crate::ids::{FaceId, FaceMap, VertexId};
use crate::plane::Point;
use crate::plane::predicates::orientation;

/// Triangles from one with the start to one with the goal, by the sides that they are left by.
pub(super) struct Strip<'a> {
    pub(super) surface: &'a NavSurface,
    pub(super) first: usize,
    pub(super) portals: &'a [usize],
}

/// Edges whose faces are inclined by less than this are no creases.
const CREASE: f64 = 1e-9;

impl Strip<'_> {
    /// The shortest path through the row.
    pub(super) fn pull(&self, ends: [&SurfacePoint; 2], costs: Option<&FaceMap<f64>>) -> SurfaceRoute {
        let [start, goal] = ends.map(|place| place.point);
        let (portals, [from, to]) = self.unfold(start, goal);
        let mut funnel = Funnel::default();
        funnel.start(Endpoint::free(from));
        between_ends(&portals, [from, to]).iter().for_each(|&[left, right]| funnel.pass(left, right));
        let path = funnel.finish(Endpoint::free(to)).to_vec();
        self.fold(ends, &path, &steps(&portals, &path), costs)
    }

    /// The sides as portals, left and right endpoint, and the ends, all in one plane.
    fn unfold(&self, start: Space, goal: Space) -> (Vec<[Endpoint; 2]>, [Point; 2]) {
        let surface = self.surface;
        let mut portals = Vec::with_capacity(self.portals.len());
        // A side of the triangle that was entered last, and where its ends are.
        let mut side = 3 * self.first;
        let mut ends = [Point::new(0.0, 0.0), Point::new(surface.sides[side].length, 0.0)];
        let place = |[a, b]: [Point; 2], length: f64, [x, y]: [f64; 2]| {
            let [ex, ey] = [(b.x - a.x) / length, (b.y - a.y) / length];
            Point::new(a.x + ex * x - ey * y, a.y + ey * x + ex * y)
        };
        let within = |side: usize, ends: [Point; 2], p: Space| {
            let SideRecord { length, .. } = surface.sides[side];
            let [a, b] = surface.ends(side);
            let c = surface.points[surface.sides[prev(side)].origin as usize];
            let unit = |v: Space| v.map(|x| x / norm(v));
            let along = unit(minus(b, a));
            let up = unit(cross(cross(along, unit(minus(c, a))), along));
            let off = minus(p, a);
            place(ends, length, [dot(along, off), dot(up, off)])
        };
        let from = within(side, ends, start);
        for &portal in self.portals {
            let SideRecord { length, apex, .. } = surface.sides[side];
            let top = place(ends, length, apex);
            let portal_ends = if portal == side {
                ends
            } else if portal == next(side) {
                [ends[1], top]
            } else {
                [top, ends[0]]
            };
            let endpoint = |s: usize, point: Point| Endpoint { point, vertex: surface.sides[s].origin };
            portals.push([endpoint(next(portal), portal_ends[1]), endpoint(portal, portal_ends[0])]);
            side = surface.sides[portal].twin as usize;
            ends = [portal_ends[1], portal_ends[0]];
        }
        (portals, [from, within(side, ends, goal)])
    }

    /// The path in space.
    fn fold(
        &self,
        places: [&SurfacePoint; 2],
        path: &[Endpoint],
        steps: &[Step],
        costs: Option<&FaceMap<f64>>,
    ) -> SurfaceRoute {
        let surface = self.surface;
        let [start, goal] = places.map(|place| place.point);
        let beyond = |portal: usize| surface.sides[portal].twin as usize / 3;
        let triangles: Vec<usize> =
            std::iter::once(self.first).chain(self.portals.iter().map(|&portal| beyond(portal))).collect();
        let mut faces: Vec<FaceId> = triangles.iter().map(|&t| surface.face_of(t)).collect();
        let mut route = SurfaceRoute { points: vec![start], ..SurfaceRoute::default() };
        let (mut last, mut spot) = (start, Spot::Place(places[0]));
        for step in steps {
            let face = faces[step.face];
            let (at, here, shows) = match step.end {
                End::Portal(d, share) => {
                    let portal = self.portals[d];
                    let [right, left] = surface.ends(portal);
                    (lerp(right, left, share), Spot::on(surface, portal, share), surface.shows(portal))
                }
                End::Endpoint(k) if k + 1 == path.len() => (goal, Spot::Place(places[1]), true),
                End::Endpoint(k) => {
                    let node = path[k].vertex as usize;
                    let at = surface.points[node];
                    if ![start, goal].contains(&at) {
                        route.corners.push(VertexId::new(surface.vertices[node]));
                    }
                    (at, Spot::Node(path[k].vertex), true)
                }
            };
            let length = between(last, at);
            route.length += length;
            route.cost +=
                length * costs.map_or(1.0, |costs| surface.cost_of(triangles[step.face], [&spot, &here], costs));
            (last, spot) = (at, here);
            if shows
                && (route.points.last() != Some(&at)
                    || route.points.len() == 1 && step.end == End::Endpoint(path.len() - 1))
            {
                route.points.push(at);
                route.layers.push(surface.layer(face).unwrap_or(0));
            }
        }
        faces.dedup();
        route.faces = faces;
        route
    }
}

/// Where a step begins or ends, as far as sides know it.
enum Spot<'a> {
    Place(&'a SurfacePoint),
    Node(u32),
    /// Between the ends of a side.
    Side(usize),
}

/// A path that passes a side at this share of its length from an end runs through the end, as far as rounding knows.
const AT_END: f64 = 1e-12;

impl Spot<'_> {
    fn on(surface: &NavSurface, side: usize, share: f64) -> Self {
        if share <= AT_END {
            Self::Node(surface.sides[side].origin)
        } else if share >= 1.0 - AT_END {
            Self::Node(surface.sides[next(side)].origin)
        } else {
            Self::Side(side)
        }
    }

    /// Whether it is on a side, its ends included.
    fn is_on(&self, surface: &NavSurface, s: usize) -> bool {
        match *self {
            Self::Place(place) => surface.is_on_side(place, s),
            Self::Node(node) => [s, next(s)].iter().any(|&s| surface.sides[s].origin == node),
            Self::Side(on) => on == s || surface.sides[on].twin as usize == s,
        }
    }
}

/// The portals without those at the beginning that the start is not in front of, and those at the end that the goal is not
/// behind: each end lies in the triangle beside such a portal, so it is rounding that brings it onto the portal or across.
fn between_ends(portals: &[[Endpoint; 2]], [from, to]: [Point; 2]) -> &[[Endpoint; 2]] {
    let side = |&[left, right]: &[Endpoint; 2], p: Point| orientation(right.point, left.point, p);
    let first = portals.iter().take_while(|portal| side(portal, from).is_le()).count();
    let rest = &portals[first..];
    let last = rest.iter().rev().take_while(|portal| side(portal, to).is_ge()).count();
    &rest[..rest.len() - last]
}

impl NavSurface {
    /// What a unit of length of a step through a triangle costs: along a side as much as in the cheaper of its two faces.
    fn cost_of(&self, t: usize, ends: [&Spot<'_>; 2], costs: &FaceMap<f64>) -> f64 {
        let cost = |t: usize| costs[self.face_of(t)].max(0.0);
        let along = (3 * t..3 * t + 3).filter(|&s| ends.iter().all(|end| end.is_on(self, s)));
        let beyond = along.map(|s| self.sides[s].twin).filter(|&twin| twin != NONE);
        beyond.map(|twin| cost(twin as usize / 3)).fold(cost(t), f64::min)
    }

    /// Whether a path that passes a side bends there in space, or comes to another layer.
    fn shows(&self, side: usize) -> bool {
        let [one, other] = [side, self.sides[side].twin as usize].map(|s| s / 3);
        if self.layer(self.face_of(one)) != self.layer(self.face_of(other)) {
            return true;
        }
        let [m, n] = [one, other].map(|t| normal(self.corners(t)));
        norm(cross(m, n)) > CREASE * norm(m) * norm(n)
    }
}
