//! The exact search: windows in the order of the shortest path that may lead through them.
//!
//! Every length that it knows of a node is that of a path, so whatever is left out because of one is no loss:
//!
//! - a window that a path by an endpoint of its side, or by the third corner of the triangle before it, outdoes everywhere;
//! - one of the two windows behind a triangle if its corner can be reached on a shorter path through the same side;
//! - whatever is longer by its guess than the best path to the goal.
//!
//! A path bends round nodes on a border, and round those with more than a full turn. There it may leave where both sides
//! of it have half a turn or more; a hair less will do, so that what rounding hides behind a corner is still seen.

use super::super::route::shortest_pair;
use super::super::{PathAlgorithm, Work};
use super::corridor::Corridors;
use super::place::SurfacePoint;
use super::unfold::Strip;
use super::window::Window;
use super::{
    NONE, NavSurface, SideRecord, Space, SurfaceField, SurfaceRoute, SurfaceRouteError, between, cross, dot, minus,
    next, norm, prev,
};
use crate::ids::FaceMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// By how much less than half a turn a path may bend: about the root of what rounding changes of a length.
const HAIR: f64 = 1e-8;
/// Lengths whose difference is a smaller part of them count as equal.
const EQUAL: f64 = 1e-14;
/// The same where a window would be lost by it.
const SURE: f64 = 1e-12;
/// In the queue: a node, and no window.
const NODE: u32 = 1 << 31;

/// How a node was reached.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    /// In which query.
    query: u32,
    by: By,
    /// A side that leaves the node in the triangle that it was reached through.
    corner: u32,
    /// The angle from that side to the way back.
    back: f64,
    length: f64,
    /// Whether what lies behind has been looked at with this length.
    done: bool,
}

#[derive(Clone, Copy, Debug)]
enum By {
    Start,
    Window(u32),
    /// Along a side, from the node that this side of the same triangle leaves.
    Node(u32),
}

impl Arrival {
    /// Its query is written when it is kept.
    fn new(by: By, corner: usize, back: f64, length: f64) -> Self {
        Self { query: 0, by, corner: corner as u32, back, length, done: false }
    }
}

const UNKNOWN: Arrival = Arrival { query: 0, by: By::Start, corner: 0, back: 0.0, length: f64::INFINITY, done: false };

/// The best that is known of the corner above a side.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    query: u32,
    length: f64,
    x: f64,
}

/// Finds paths on surfaces, and keeps its memory from query to query.
///
/// ```
/// use dcel_kit::navmesh::{Floor, NavSurface, PathAlgorithm, SurfacePlanner};
/// use dcel_kit::topology::PolygonList;
/// // A ramp that rises by 3 over 4.
/// let points = [[0., 0., 0.], [4., 0., 3.], [4., 2., 3.], [0., 2., 0.]];
/// let mut faces = PolygonList::new();
/// faces.push_face(&[0, 1, 2, 3]);
/// let ramp = NavSurface::new(&points, &faces, None)?;
/// let [start, goal] = [ramp.place([0., 1.], Floor::Any)?, ramp.place([4., 1.], Floor::Any)?];
/// let route = SurfacePlanner::new().route(&ramp, PathAlgorithm::Exact, &start, &goal)?;
/// assert_eq!((route.length, route.points[1]), (5.0, [4.0, 1.0, 3.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct SurfacePlanner {
    query: u32,
    arrivals: Vec<Arrival>,
    seen: Vec<Seen>,
    windows: Vec<Window>,
    /// Keys are the bits of lengths: they are in the order of the lengths.
    queue: BinaryHeap<Reverse<(u64, u32)>>,
    corridors: Corridors,
    work: Work,
}

/// What the search is for: a goal, or everything within a limit.
struct Aim {
    goal: Option<Goal>,
    limit: f64,
}

/// Where the search is to end.
struct Goal {
    at: Space,
    /// The triangles that have it.
    triangles: Vec<usize>,
    best: f64,
    by: Option<Last>,
}

#[derive(Clone, Copy)]
enum Last {
    Window(u32),
    /// The corner that the straight piece to the goal begins at, by a side that leaves it.
    Corner(u32),
}

impl SurfacePlanner {
    /// A planner without any memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A path on the surface. [`PathAlgorithm::Exact`] gives the shortest of all; the others find a row of triangles by a quicker
    /// rule and the shortest path through that.
    ///
    /// Cost: O(n log n) for the quicker ones. The exact search looks at no more than O(n²) windows, and far fewer where
    /// the goal is in sight of few corners.
    ///
    /// # Errors
    /// [`SurfaceRouteError::Unreachable`] if the surface does not lead from one to the other.
    pub fn route(
        &mut self,
        surface: &NavSurface,
        algorithm: PathAlgorithm,
        start: &SurfacePoint,
        goal: &SurfacePoint,
    ) -> Result<SurfaceRoute, SurfaceRouteError> {
        self.find(surface, algorithm, None, start, goal)
    }

    /// A path for which a unit of length in a face costs as much as `costs` says. As on a map it is not exact: the
    /// corridor is a good one for these costs, and within it the path is the shortest, not the cheapest. From an end on an
    /// edge or a vertex it may lead through any of the faces there. Along an edge the cheaper of its two faces counts.
    ///
    /// # Errors
    /// [`SurfaceRouteError::Unreachable`] if the surface does not lead from one to the other.
    ///
    /// # Panics
    /// If `costs` is shorter than [`face_bound`](NavSurface::face_bound).
    pub fn weighted_route(
        &mut self,
        surface: &NavSurface,
        algorithm: PathAlgorithm,
        costs: &FaceMap<f64>,
        start: &SurfacePoint,
        goal: &SurfacePoint,
    ) -> Result<SurfaceRoute, SurfaceRouteError> {
        assert!(costs.len() >= surface.face_bound(), "{} costs for {} faces", costs.len(), surface.face_bound());
        self.find(surface, algorithm.over_costs(), Some(costs), start, goal)
    }

    /// The shortest of the routes between some places, as at a double corner; with the numbers of its ends.
    ///
    /// # Errors
    /// [`SurfaceRouteError::Unreachable`], of the first pair, if there is no path between any two of them.
    ///
    /// # Panics
    /// If there are no starts or no goals.
    pub fn route_among(
        &mut self,
        surface: &NavSurface,
        algorithm: PathAlgorithm,
        starts: &[SurfacePoint],
        goals: &[SurfacePoint],
    ) -> Result<(SurfaceRoute, [usize; 2]), SurfaceRouteError> {
        let find = |[i, k]: [usize; 2]| self.route(surface, algorithm, &starts[i], &goals[k]);
        shortest_pair([starts.len(), goals.len()], find, |route| route.length)
    }

    fn find(
        &mut self,
        surface: &NavSurface,
        algorithm: PathAlgorithm,
        costs: Option<&FaceMap<f64>>,
        start: &SurfacePoint,
        goal: &SurfacePoint,
    ) -> Result<SurfaceRoute, SurfaceRouteError> {
        let [from, to] = [start, goal].map(|place| surface.component(place.face).unwrap_or(NONE));
        let unreachable = SurfaceRouteError::Unreachable { from: start.face, to: goal.face, start: from, goal: to };
        if from != to {
            return Err(unreachable);
        }
        self.begin(surface);
        let [starts, goals] = [start, goal].map(|place| surface.triangles_at(place));
        let cost = |&t: &usize| costs.map_or(1.0, |costs| costs[surface.face_of(t)].max(0.0));
        let common = starts.iter().copied().filter(|t| goals.contains(t)).min_by(|t, u| cost(t).total_cmp(&cost(u)));
        let rows = match common {
            Some(_) => vec![Vec::new()],
            None if algorithm == PathAlgorithm::Exact => {
                self.search(surface, start, &starts, goal.point, goals).into_iter().collect()
            }
            None => {
                let ends = [start.point, goal.point];
                let found = self.corridors.find(surface, algorithm, costs, ends, [&starts, &goals]);
                self.work = self.corridors.work;
                found
            }
        };
        let routes = rows.into_iter().map(|mut portals| {
            keep_between(surface, [start, goal], &mut portals);
            let first = portals.first().map_or(common.unwrap_or(start.triangle as usize), |portal| portal / 3);
            Strip { surface, first, portals: &portals }.pull([start, goal], costs)
        });
        // Within a component there is a path.
        let best = routes.min_by(|one, other| one.cost.total_cmp(&other.cost)).ok_or(unreachable)?;
        Ok(SurfaceRoute { work: self.work, ..best })
    }

    /// How far it is to every vertex that is no further away than `limit`, along the surface.
    ///
    /// Cost: as an exact search that looks at everything within the limit.
    pub fn distance_field(&mut self, surface: &NavSurface, start: &SurfacePoint, limit: f64) -> SurfaceField {
        self.begin(surface);
        let mut aim = Aim { goal: None, limit };
        self.leave(surface, start, &surface.triangles_at(start), &mut aim);
        self.spread(surface, &mut aim);
        SurfaceField::over(surface, self.work, |node| {
            let length = self.length(node as u32);
            if length <= limit { length } else { f64::INFINITY }
        })
    }

    fn begin(&mut self, surface: &NavSurface) {
        self.query = self.query.wrapping_add(1);
        if self.query == 0 {
            self.arrivals.clear();
            self.seen.clear();
            self.query = 1;
        }
        self.arrivals.resize(surface.points.len().max(self.arrivals.len()), UNKNOWN);
        self.seen.resize(surface.sides.len().max(self.seen.len()), Seen::default());
        self.windows.clear();
        self.queue.clear();
        self.work = Work::default();
    }

    /// The least length that is known of a node.
    #[inline]
    fn length(&self, node: u32) -> f64 {
        let arrival = &self.arrivals[node as usize];
        if arrival.query == self.query { arrival.length } else { f64::INFINITY }
    }

    /// The sides by which triangles are left, from the start on.
    fn search(
        &mut self,
        surface: &NavSurface,
        start: &SurfacePoint,
        starts: &[usize],
        goal: Space,
        triangles: Vec<usize>,
    ) -> Option<Vec<usize>> {
        let goal = Goal { at: goal, triangles, best: f64::INFINITY, by: None };
        let mut aim = Aim { goal: Some(goal), limit: f64::INFINITY };
        self.leave(surface, start, starts, &mut aim);
        self.spread(surface, &mut aim);
        Some(self.trace(surface, aim.goal?.by?))
    }

    /// Looks at what the start sees.
    fn leave(&mut self, surface: &NavSurface, start: &SurfacePoint, starts: &[usize], aim: &mut Aim) {
        for &t in starts {
            for s in 3 * t..3 * t + 3 {
                let corner = surface.sides[s].origin;
                let [at, ahead] = surface.ends(s);
                let back = minus(start.point, at);
                let length = norm(back);
                let angle = angle_between(minus(ahead, at), back);
                self.reach(surface, corner, Arrival::new(By::Start, s, angle, length), aim);
                if length == 0.0 {
                    // What lies behind it is what the start sees itself.
                    self.arrivals[corner as usize].done = true;
                }
            }
        }
        for &t in starts {
            for s in (3 * t..3 * t + 3).filter(|&s| !surface.is_on_side(start, s)) {
                let [x, depth] = surface.turned(s, start.point);
                let SideRecord { twin, length, .. } = surface.sides[s];
                if twin != NONE {
                    let window = Window {
                        side: twin,
                        parent: NONE,
                        root: NONE,
                        corner: NONE,
                        ends: [0.0, length],
                        at: [length - x, depth],
                        length: 0.0,
                    };
                    self.keep(surface, window, aim);
                }
            }
        }
    }

    /// Takes windows and nodes from the queue until nothing shorter can come.
    fn spread(&mut self, surface: &NavSurface, aim: &mut Aim) {
        while let Some(Reverse((key, item))) = self.queue.pop() {
            if aim.goal.as_ref().is_some_and(|goal| f64::from_bits(key) >= goal.best) {
                break;
            }
            self.work.pops += 1;
            if item & NODE != 0 {
                let arrival = &mut self.arrivals[(item & !NODE) as usize];
                if !std::mem::replace(&mut arrival.done, true) {
                    self.bend(surface, item & !NODE, aim);
                }
                continue;
            }
            let window = self.windows[item as usize];
            if window.root == NONE || window.length <= self.length(window.root) {
                self.look_behind(surface, window, item, aim);
            }
        }
    }

    /// Looks at what a window shows behind the triangle.
    fn look_behind(&mut self, surface: &NavSurface, window: Window, number: u32, aim: &mut Aim) {
        self.work.expansions += 1;
        let s = window.side as usize;
        let side = surface.sides[s];
        let x = window.pierce(side.apex);
        let slack = SURE * side.length;
        let [mut left, mut right] = window.children(surface, number);
        if window.ends[0] - slack <= x && x <= window.ends[1] + slack {
            let length = window.length + window.to(side.apex);
            let back = [window.at[0] - side.apex[0], -window.at[1] - side.apex[1]];
            let along = [-side.apex[0], -side.apex[1]];
            let angle = (along[0] * back[1] - along[1] * back[0]).atan2(along[0] * back[0] + along[1] * back[1]);
            let corner = prev(s);
            let angle = angle.clamp(0.0, surface.sides[corner].angle);
            let arrival = Arrival::new(By::Window(number), corner, angle, length);
            self.reach(surface, surface.sides[corner].origin, arrival, aim);
            let seen = &mut self.seen[s];
            if seen.query != self.query || length < seen.length {
                *seen = Seen { query: self.query, length, x };
            } else if length > seen.length * (1.0 + SURE) {
                if x < seen.x {
                    right = None;
                } else {
                    left = None;
                }
            }
        }
        // The endpoint that the way in and the way out have in common, and the other one.
        let [a, b] = [s, next(s)].map(|s| surface.sides[s].origin);
        if let Some(child) = left.filter(|child| !self.is_outdone(surface, child, b, 0)) {
            self.keep(surface, child, aim);
        }
        if let Some(child) = right.filter(|child| !self.is_outdone(surface, child, a, 1)) {
            self.keep(surface, child, aim);
        }
    }

    /// Whether a path by an endpoint of its side, or by the third corner of the triangle that was left, leads to all of a
    /// window on a shorter path. `near` is the end of the window that is nearer to where the triangle was entered.
    fn is_outdone(&self, surface: &NavSurface, window: &Window, third: u32, near: usize) -> bool {
        let s = window.side as usize;
        let [a, b] = [s, next(s)].map(|s| surface.sides[s].origin);
        let [low, high] = window.ends;
        let by = window.ends.map(|x| (window.length + window.to([x, 0.0])) * (1.0 - SURE));
        if self.length(a) + high < by[1] || self.length(b) + (surface.sides[s].length - low) < by[0] {
            return true;
        }
        let third_length = self.length(third);
        if !third_length.is_finite() {
            return false;
        }
        let [x, y] = surface.sides[surface.sides[s].twin as usize].apex;
        // The frame of the other side of the edge is turned by half a turn.
        let [dx, dy] = [surface.sides[s].length - x - window.ends[near], y];
        third_length + (dx * dx + dy * dy).sqrt() < by[near]
    }

    /// Puts a window into the queue, and sees whether the goal is in sight.
    fn keep(&mut self, surface: &NavSurface, window: Window, aim: &mut Aim) {
        let number = self.windows.len() as u32;
        let key = match &mut aim.goal {
            Some(goal) => {
                let turned = surface.turned(window.side as usize, goal.at);
                if goal.triangles.contains(&(window.side as usize / 3))
                    && let Some(length) = window.length_to(turned)
                    && length < goal.best
                {
                    (goal.best, goal.by) = (length, Some(Last::Window(number)));
                }
                window.guess(turned)
            }
            None => window.nearest(),
        };
        let is_best = matches!(aim.goal, Some(Goal { by: Some(Last::Window(best)), .. }) if best == number);
        if is_best || (key <= aim.limit && aim.goal.as_ref().is_none_or(|goal| key < goal.best)) {
            self.windows.push(window);
            self.work.pushes += 1;
            self.queue.push(Reverse((key.to_bits(), number)));
        }
    }

    /// A node has been reached.
    fn reach(&mut self, surface: &NavSurface, node: u32, arrival: Arrival, aim: &mut Aim) {
        let length = arrival.length;
        if length >= self.length(node) * (1.0 - EQUAL) || length > aim.limit {
            return;
        }
        self.arrivals[node as usize] = Arrival { query: self.query, ..arrival };
        let at = surface.points[node as usize];
        if let Some(goal) = &mut aim.goal {
            for &t in &goal.triangles {
                let here = (3 * t..3 * t + 3).find(|&s| surface.sides[s].origin == node);
                let whole = length + between(at, goal.at);
                if let Some(s) = here.filter(|_| whole < goal.best) {
                    (goal.best, goal.by) = (whole, Some(Last::Corner(s as u32)));
                }
            }
        }
        let turns = if surface.border[node as usize] { PI } else { 2.0 * PI };
        if surface.around[node as usize] >= turns - HAIR {
            let key = length + aim.goal.as_ref().map_or(0.0, |goal| between(at, goal.at));
            if aim.goal.as_ref().is_none_or(|goal| key < goal.best) {
                self.work.pushes += 1;
                self.queue.push(Reverse((key.to_bits(), node | NODE)));
            }
        }
    }

    /// Looks at what lies behind a node: where a path may go on from it, bent or straight.
    fn bend(&mut self, surface: &NavSurface, node: u32, aim: &mut Aim) {
        self.work.expansions += 1;
        let Arrival { corner, back, length, .. } = self.arrivals[node as usize];
        let first = corner as usize;
        let is_border = surface.border[node as usize];
        let most = if is_border { f64::INFINITY } else { surface.around[node as usize] - PI + HAIR };
        let least = PI - HAIR;
        // Counter-clockwise from the way back.
        let mut turned = surface.sides[first].angle - back;
        let mut at = surface.turn_left(first);
        while let Some(s) = at.filter(|&s| s != first) {
            let angle = surface.sides[s].angle;
            self.see(surface, node, s, [least - turned, most - turned], length, aim);
            turned += angle;
            if turned > most {
                break;
            }
            at = surface.turn_left(s);
        }
        if !is_border {
            return;
        }
        let mut turned = back;
        let mut at = surface.turn_right(first);
        while let Some(s) = at {
            let angle = surface.sides[s].angle;
            self.see(surface, node, s, [f64::NEG_INFINITY, angle + turned - least], length, aim);
            turned += angle;
            at = surface.turn_right(s);
        }
    }

    /// Looks from a node into one triangle, between two angles from the side that leaves it.
    fn see(&mut self, surface: &NavSurface, node: u32, s: usize, [from, to]: [f64; 2], length: f64, aim: &mut Aim) {
        let angle = surface.sides[s].angle;
        if to < 0.0 || from > angle {
            return;
        }
        let (ahead, behind) = (next(s), prev(s));
        if from <= 0.0 {
            let back = surface.sides[ahead].angle;
            let whole = length + surface.sides[s].length;
            let arrival = Arrival::new(By::Node(s as u32), ahead, back, whole);
            self.reach(surface, surface.sides[ahead].origin, arrival, aim);
        }
        if to >= angle {
            let whole = length + surface.sides[behind].length;
            let arrival = Arrival::new(By::Node(s as u32), behind, 0.0, whole);
            self.reach(surface, surface.sides[behind].origin, arrival, aim);
        }
        let SideRecord { twin, length: width, apex: [x, depth], .. } = surface.sides[ahead];
        if twin == NONE {
            return;
        }
        // As the triangle beyond sees it: the side runs from its left end, the far end of `behind`.
        let root = [width - x, depth];
        let right = depth.atan2(width - root[0]);
        let meet = |turn: f64| {
            let (sin, cos) = (right + turn).sin_cos();
            (root[0] + depth * cos / sin).clamp(0.0, width)
        };
        let ends = [if to >= angle { 0.0 } else { meet(to) }, if from <= 0.0 { width } else { meet(from) }];
        if ends[0] < ends[1] {
            let window = Window { side: twin, parent: NONE, root: node, corner: s as u32, ends, at: root, length };
            self.keep(surface, window, aim);
        }
    }

    /// The sides by which triangles are left on the way to the goal, from the start on.
    fn trace(&self, surface: &NavSurface, last: Last) -> Vec<usize> {
        // From the goal backwards; a side and its twin one after the other lead nowhere.
        let mut portals: Vec<usize> = Vec::new();
        let mut push = |portal: usize| {
            if portals.last().is_some_and(|&last| surface.sides[last].twin as usize == portal) {
                portals.pop();
            } else {
                portals.push(portal);
            }
        };
        // What was walked last: through a window, or from a corner of a triangle.
        let mut at = last;
        'back: loop {
            let corner = match at {
                Last::Window(mut i) => loop {
                    let Window { side, parent, root, corner, .. } = self.windows[i as usize];
                    push(surface.sides[side as usize].twin as usize);
                    if parent != NONE {
                        i = parent;
                    } else if root == NONE {
                        break 'back;
                    } else {
                        break corner as usize;
                    }
                },
                Last::Corner(corner) => corner as usize,
            };
            let arrival = &self.arrivals[surface.sides[corner].origin as usize];
            surface.round(arrival.corner as usize, corner).into_iter().rev().for_each(&mut push);
            at = match arrival.by {
                By::Window(i) => Last::Window(i),
                By::Node(side) => Last::Corner(side),
                By::Start => break,
            };
        }
        portals.reverse();
        portals
    }
}

/// Of a row of triangles, by the sides that they are left by, the part from the last one that has the start to the first one
/// that has the goal: a path leads through no side that one of its ends lies on. O(length of the row).
fn keep_between(surface: &NavSurface, [start, goal]: [&SurfacePoint; 2], portals: &mut Vec<usize>) {
    let behind = portals.iter().rev().take_while(|&&portal| surface.is_on_side(goal, portal)).count();
    portals.truncate(portals.len() - behind);
    let before = portals.iter().take_while(|&&portal| surface.is_on_side(start, portal)).count();
    portals.drain(..before);
}

/// The angle between two directions.
fn angle_between(a: Space, b: Space) -> f64 {
    norm(cross(a, b)).atan2(dot(a, b))
}
