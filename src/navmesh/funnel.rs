//! The shortest way through a row of doors: string pulling.
//!
//! ```text
//!              l1     l2            The funnel: from its apex, the way as far as it is certain, two chains lead to
//!               ●─────●             the posts of the last door. A new post takes off the end of its chain what it
//!              ╱       door         pulls straight; if it comes across the other chain, the way bends round that
//!   s ─── apex ●      |             one's vertices, and the last of them is the new apex.
//!              ╲──●───●
//!                 r1  r2
//! ```
//!
//! A post on the line of its own chain, but back towards the apex, lies behind a door that is seen edge-on, and beside
//! a wall without area: the way turns round at the nearer end of the door.
//! Across means strictly across: a post on the line of the other chain changes nothing, be it in front or behind. (The
//! funnel as it is commonly printed fails there when the start lies inside the first door, left and right of it are
//! opposite, and no area is taken for a crossing.)
//!
//! Each post is put in and taken off once: O(number of doors).
//!
//! Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*, 1984.

use super::mesh::NONE;
use super::nearest::distance;
use super::{NavMesh, Route};
use crate::ids::VertexId;
use crate::plane::Point;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// A point of a chain: a vertex, or the start or the goal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Post {
    pub(super) point: Point,
    pub(super) vertex: u32,
}

impl Post {
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
    /// The certain part of the way; the last one is the apex.
    way: Vec<Post>,
    /// The left and the right chain, each from the apex on, which is their first point.
    chains: [Chain; 2],
}

#[derive(Clone, Debug, Default)]
struct Chain {
    posts: Vec<Post>,
    /// Where the apex is; what is before it is spent.
    apex: usize,
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

impl Funnel {
    pub(super) fn start(&mut self, start: Post) {
        self.way.clear();
        self.way.push(start);
        for chain in &mut self.chains {
            chain.posts.clear();
            chain.posts.push(start);
            chain.apex = 0;
        }
    }

    /// Goes through a door.
    pub(super) fn pass(&mut self, left: Post, right: Post) {
        for (side, post) in [(LEFT, left), (RIGHT, right)] {
            if self.chains[side].posts.last() != Some(&post) {
                self.put(side, post);
            }
        }
    }

    /// Goes through a door between two vertices. Mostly one of them is a post of the door before.
    #[inline]
    pub(super) fn pass_between(&mut self, mesh: &NavMesh, left: VertexId, right: VertexId) {
        for (side, v) in [(LEFT, left), (RIGHT, right)] {
            if self.chains[side].posts.last().is_none_or(|post| post.vertex != v.number()) {
                self.put(side, Post::at(mesh, v));
            }
        }
    }

    /// Ends at the goal and returns the way there.
    pub(super) fn finish(&mut self, goal: Post) -> &[Post] {
        self.put(LEFT, goal);
        let Self { way, chains } = self;
        way.extend(&chains[LEFT].posts[chains[LEFT].apex + 1..]);
        way
    }

    fn put(&mut self, side: usize, post: Post) {
        let inwards = if side == LEFT { Ordering::Less } else { Ordering::Greater };
        let Self { way, chains } = self;
        let [left, right] = chains;
        let (own, other) = if side == LEFT { (left, right) } else { (right, left) };
        // Whether the way turns back at the other end of a door that is seen edge-on.
        let mut turns_at_other = false;
        while own.posts.len() > own.apex + 1 {
            let [a, b] = [own.posts.len() - 2, own.posts.len() - 1].map(|i| own.posts[i].point);
            let turn = orientation(a, b, post.point);
            if turn == inwards.reverse() {
                break;
            }
            if turn.is_eq() && turns_back(a, b, post.point) {
                let is_nearer = |end: &Post| orientation(a, b, end.point).is_eq() && is_between(a, end.point, b);
                turns_at_other =
                    own.posts.len() == own.apex + 2 && other.posts.get(other.apex + 1).is_some_and(is_nearer);
                if !turns_at_other {
                    break;
                }
            }
            own.posts.pop();
        }
        if own.posts.len() == own.apex + 1 {
            while let Some(&next) = other.posts.get(other.apex + 1) {
                let crosses = orientation(other.posts[other.apex].point, next.point, post.point) == inwards;
                if !crosses && !std::mem::take(&mut turns_at_other) {
                    break;
                }
                other.apex += 1;
                way.push(next);
                own.posts.push(next);
                own.apex = own.posts.len() - 1;
            }
        }
        own.posts.push(post);
    }

    fn step(&self) -> FunnelStep {
        let [left, right] =
            self.chains.each_ref().map(|chain| chain.posts[chain.apex..].iter().map(|p| p.point).collect());
        FunnelStep { way: self.way.iter().map(|post| post.point).collect(), left, right }
    }
}

/// The funnel after a door, for figures.
#[derive(Clone, PartialEq, Debug)]
pub struct FunnelStep {
    /// The way that is certain, from the start to the apex.
    pub way: Vec<Point>,
    /// The left chain from the apex to the left post.
    pub left: Vec<Point>,
    /// The right chain from the apex to the right post.
    pub right: Vec<Point>,
}

impl Route {
    /// The funnel after each door of the route, and at last at the goal: one more step than doors. O(k^2) for k
    /// doors, as every step is copied.
    #[must_use]
    pub fn funnel_steps(&self, mesh: &NavMesh) -> Vec<FunnelStep> {
        let (Some(&start), Some(&goal)) = (self.points.first(), self.points.last()) else { return Vec::new() };
        let mut funnel = Funnel::default();
        funnel.start(Post::free(start));
        let mut steps = Vec::new();
        for portal in self.portals(mesh) {
            funnel.pass_between(mesh, portal.left, portal.right);
            steps.push(funnel.step());
        }
        funnel.pass(Post::free(goal), Post::free(goal));
        steps.push(funnel.step());
        steps
    }
}

/// Whether of three points on a line the third is on the same side of the second as the first: so a way turns round the
/// end of a wall without area.
fn turns_back(a: Point, b: Point, c: Point) -> bool {
    let there = left_to_right(a, b);
    there.is_ne() && left_to_right(b, c) == there.reverse()
}

/// Whether of three points on a line the second lies strictly between the others.
fn is_between(a: Point, b: Point, c: Point) -> bool {
    let there = left_to_right(a, b);
    there.is_ne() && left_to_right(b, c) == there
}

/// The length of a way.
pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}
