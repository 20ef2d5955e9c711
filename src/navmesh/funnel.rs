//! The shortest path through a row of portals: string pulling.
//!
//! ```text
//!              l1     l2            The funnel: from its apex, the way as far as it is certain, two chains lead to
//!               ●─────●             the endpoints of the last portal. A new endpoint takes off the end of its chain what it
//!              ╱       portal         pulls straight; if it comes across the other chain, the path bends round that
//!   s ─── apex ●      |             one's vertices, and the last of them is the new apex.
//!              ╲──●───●
//!                 r1  r2
//! ```
//!
//! Across means strictly across: an endpoint on the line of the other chain changes nothing, be it in front or behind, but
//! for a whole portal on a line with the apex: the path leads by its nearer endpoint, and may go back from there. (The
//! funnel as it is commonly printed fails there when the start lies inside the first portal, left and right of it are
//! opposite, and no area is taken for a crossing.)
//!
//! Each endpoint is put in and taken off once: O(number of portals).
//!
//! Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*, 1984.

use super::marks::NONE;
use super::nearest::distance;
use super::{NavMesh, Route};
use crate::ids::VertexId;
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// A point of a chain: a vertex, or the start or the goal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Endpoint {
    pub(super) point: Point,
    pub(super) vertex: u32,
}

impl Endpoint {
    pub(super) fn free(point: Point) -> Self {
        Self { point, vertex: NONE }
    }

    pub(super) fn at(mesh: &NavMesh, v: VertexId) -> Self {
        Self { point: mesh.point(v), vertex: v.number() }
    }
}

/// The funnel; kept for the next query, so that its memory is.
#[derive(Clone, Debug, Default)]
pub(super) struct Funnel {
    /// The certain part of the path; the last one is the apex.
    way: Vec<Endpoint>,
    /// The left and the right chain, each from the apex on, which is their first point.
    chains: [Chain; 2],
    /// Whether there are endpoints in the way that it may run straight through.
    touched: bool,
}

#[derive(Clone, Debug, Default)]
struct Chain {
    endpoints: Vec<Endpoint>,
    /// Where the apex is; what is before it is spent.
    apex: usize,
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

impl Funnel {
    pub(super) fn start(&mut self, start: Endpoint) {
        self.way.clear();
        self.way.push(start);
        self.touched = false;
        for chain in &mut self.chains {
            chain.endpoints.clear();
            chain.endpoints.push(start);
            chain.apex = 0;
        }
    }

    /// Goes through a portal.
    pub(super) fn pass(&mut self, left: Endpoint, right: Endpoint) {
        self.put_new(&[left, right], |endpoint, last| endpoint != last, |endpoint| *endpoint);
    }

    /// Goes through a portal between two vertices. Mostly one of them is an endpoint of the portal before.
    #[inline]
    pub(super) fn pass_between(&mut self, mesh: &NavMesh, left: VertexId, right: VertexId) {
        self.put_new(&[left, right], |v, last| v.number() != last.vertex, |v| Endpoint::at(mesh, *v));
    }

    /// Puts those endpoints of a portal at the ends of the chains that are not there already.
    #[inline]
    fn put_new<T>(
        &mut self,
        endpoints: &[T; 2],
        is_new: impl Fn(&T, &Endpoint) -> bool,
        make: impl Fn(&T) -> Endpoint,
    ) {
        let mut in_line = false;
        for (side, endpoint) in [LEFT, RIGHT].into_iter().zip(endpoints) {
            if self.chains[side].endpoints.last().is_none_or(|last| is_new(endpoint, last)) {
                in_line |= self.put(side, make(endpoint));
            }
        }
        if in_line {
            self.touch();
        }
    }

    /// Ends at the goal and returns the way there.
    pub(super) fn finish(&mut self, goal: Endpoint) -> &[Endpoint] {
        self.put(LEFT, goal);
        let Self { way, chains, touched } = self;
        way.extend(&chains[LEFT].endpoints[chains[LEFT].apex + 1..]);
        if *touched {
            let mut kept: Vec<Endpoint> = Vec::with_capacity(way.len());
            for (i, &endpoint) in way.iter().enumerate() {
                let straight =
                    |(before, after): (&Endpoint, &Endpoint)| runs_straight(before.point, endpoint.point, after.point);
                if !kept.last().zip(way.get(i + 1)).is_some_and(straight) {
                    kept.push(endpoint);
                }
            }
            *way = kept;
        }
        way
    }

    /// If the last portal is on one line with the apex, on one side of it: makes its nearer endpoint the apex. The way leads
    /// there in any case, be it straight through or back on the same line, as round the end of a wall.
    fn touch(&mut self) {
        let Self { way, chains, touched } = self;
        let [&[apex, left], &[_, right]] = chains.each_ref().map(|chain| &chain.endpoints[chain.apex..]) else {
            return;
        };
        let near = if runs_straight(apex.point, left.point, right.point) {
            LEFT
        } else if runs_straight(apex.point, right.point, left.point) {
            RIGHT
        } else {
            return;
        };
        let (endpoint, other) = ([left, right][near], &mut chains[1 - near]);
        other.endpoints.insert(other.apex + 1, endpoint);
        chains.iter_mut().for_each(|chain| chain.apex += 1);
        way.push(endpoint);
        *touched = true;
    }

    /// Puts an endpoint at the end of a chain. Returns whether it is on one line with the apex and the other chain.
    fn put(&mut self, side: usize, endpoint: Endpoint) -> bool {
        let inwards = if side == LEFT { Ordering::Less } else { Ordering::Greater };
        let Self { way, chains, .. } = self;
        let [left, right] = chains;
        let (own, other) = if side == LEFT { (left, right) } else { (right, left) };
        while own.endpoints.len() > own.apex + 1 {
            let [a, b] = [own.endpoints.len() - 2, own.endpoints.len() - 1].map(|i| own.endpoints[i].point);
            if orientation(a, b, endpoint.point) == inwards.reverse() {
                break;
            }
            own.endpoints.pop();
        }
        let mut in_line = false;
        if own.endpoints.len() == own.apex + 1 {
            while let Some(&next) = other.endpoints.get(other.apex + 1) {
                let turn = orientation(other.endpoints[other.apex].point, next.point, endpoint.point);
                if turn != inwards {
                    in_line = turn.is_eq();
                    break;
                }
                other.apex += 1;
                way.push(next);
                own.endpoints.push(next);
                own.apex = own.endpoints.len() - 1;
            }
        }
        own.endpoints.push(endpoint);
        in_line
    }

    fn step(&self) -> FunnelStep {
        let [left, right] =
            self.chains.each_ref().map(|chain| chain.endpoints[chain.apex..].iter().map(|p| p.point).collect());
        FunnelStep { way: self.way.iter().map(|endpoint| endpoint.point).collect(), left, right }
    }
}

/// The funnel after a portal, for figures.
#[derive(Clone, PartialEq, Debug)]
pub struct FunnelStep {
    /// The way that is certain, from the start to the apex.
    pub way: Vec<Point>,
    /// The left chain from the apex to the left endpoint.
    pub left: Vec<Point>,
    /// The right chain from the apex to the right endpoint.
    pub right: Vec<Point>,
}

impl Route {
    /// The funnel after each portal of the route, and at last at the goal: one more step than portals. O(k^2) for k
    /// portals, as every step is copied.
    #[must_use]
    pub fn funnel_steps(&self, mesh: &NavMesh) -> Vec<FunnelStep> {
        let (Some(&start), Some(&goal)) = (self.points.first(), self.points.last()) else { return Vec::new() };
        let mut funnel = Funnel::default();
        funnel.start(Endpoint::free(start));
        let mut steps = Vec::new();
        for portal in self.portal_ends(mesh) {
            funnel.pass_between(mesh, portal.left, portal.right);
            steps.push(funnel.step());
        }
        funnel.pass(Endpoint::free(goal), Endpoint::free(goal));
        steps.push(funnel.step());
        steps
    }
}

/// Whether the way over three different points is straight.
fn runs_straight(a: Point, b: Point, c: Point) -> bool {
    a != b && b != c && orientation(a, b, c).is_eq() && left_to_right(a, b) == left_to_right(b, c)
}

/// The length of a path.
pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}
