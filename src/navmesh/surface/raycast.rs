//! The first border that a line on a surface meets which is straight in the plan.
//!
//! ```text
//!   seen from above      p ──┼────┼──── q         seen from the side            ╱‾‾‾‾ q
//!                                                                    p ───────╱
//! ```
//!
//! From triangle to triangle over the sides they share, so it goes up a ramp and stays on its storey. Which side it
//! leaves a triangle by is decided by exact signs on the plan; points on the way are rounded.

use super::super::raycast::{Line, enter};
use super::layers::plan;
use super::place::Spot;
use super::{NONE, NavSurface, Space, SurfacePoint, between, lerp, next, prev};
use crate::ids::{FaceId, VertexId};
use crate::plane::predicates::{orientation, twice_area};
use crate::plane::{CoordinateError, Point};
use std::cmp::Ordering;

/// What a ray on a surface met.
#[derive(Clone, PartialEq, Debug)]
pub struct SurfaceRaycast {
    /// The faces it ran through, in order.
    pub faces: Vec<FaceId>,
    /// The start, where it passes from triangle to triangle, and its end: the line is straight from point to point.
    pub points: Vec<[f64; 3]>,
    /// The layer of each piece from point to point.
    pub layers: Vec<usize>,
    /// Its length along the surface.
    pub length: f64,
    /// Where it ended; `None` if nothing was in its way.
    pub hit: Option<SurfaceRayHit>,
}

/// Where a ray on a surface ends at a border.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceRayHit {
    /// The face it came from.
    pub face: FaceId,
    /// The ends of the side it ran against, that face on the left.
    pub side: [VertexId; 2],
    /// The vertex, if it ran against one: an end of the side.
    pub vertex: Option<VertexId>,
    /// The point.
    pub point: [f64; 3],
}

/// Where the line goes on.
enum Onwards {
    /// Through this triangle.
    Into(usize),
    /// To the node that this side starts from, along a side of its triangle.
    Corner(usize),
    /// Nowhere: this side is a border, or an upright face stands on it; it is met at this node, or inside.
    Border(usize, Option<u32>),
    /// It ends in this triangle.
    End(usize),
}

impl Line {
    /// Whether the line ends between two points on it, or in the second one.
    fn ends_by(&self, a: Point, b: Point) -> bool {
        self.to == b || self.is_forward(self.to, b) && (a == self.to || self.is_forward(a, self.to))
    }
}

impl NavSurface {
    /// The first border on the way from a place to a point of the plan that is straight in the plan. It follows the
    /// surface, up and down ramps, and never leaps to another storey. Running along a border, or past a corner that it
    /// touches, is allowed; upright faces are borders.
    ///
    /// Cost: O(triangles on the way, and round the vertices on it).
    ///
    /// # Errors
    /// [`CoordinateError`] if `to` is out of range.
    ///
    /// ```
    /// use dcel_kit::navmesh::{Floor, NavSurface};
    /// use dcel_kit::topology::PolygonList;
    /// // A floor, and a ramp that rises by 3 over 4.
    /// let points = [[0., 0., 0.], [4., 0., 0.], [8., 0., 3.], [8., 4., 3.], [4., 4., 0.], [0., 4., 0.]];
    /// let mut faces = PolygonList::new();
    /// [[0, 1, 4, 5], [1, 2, 3, 4]].iter().for_each(|face| faces.push_face(face));
    /// let surface = NavSurface::new(&points, &faces, None)?;
    /// let start = surface.place([2.0, 1.0], Floor::Any)?;
    /// let ray = surface.raycast(&start, [8.0, 1.0])?;
    /// assert_eq!((ray.hit, ray.length), (None, 2.0 + 5.0));
    /// let hit = surface.raycast(&start, [12.0, 1.0])?.hit.expect("the upper end of the ramp");
    /// assert_eq!(hit.point, [8.0, 1.0, 3.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn raycast(&self, start: &SurfacePoint, to: [f64; 2]) -> Result<SurfaceRaycast, CoordinateError> {
        let line = Line { from: plan(start.point), to: Point::from(to) };
        line.to.check()?;
        let mut cast =
            SurfaceRaycast { faces: Vec::new(), points: vec![start.point], layers: Vec::new(), length: 0.0, hit: None };
        if line.to == line.from {
            cast.faces.push(start.face);
            return Ok(cast);
        }
        let mut onwards = match self.spot(start) {
            Spot::Inside => Onwards::Into(start.triangle as usize),
            Spot::Side(s) => self.leave_side(&line, s),
            Spot::Corner(s) => self.leave_corner(&line, s),
        };
        loop {
            onwards = match onwards {
                Onwards::Into(t) => {
                    enter(&mut cast.faces, self.face_of(t));
                    self.cross(&line, t, &mut cast)
                }
                Onwards::Corner(s) => {
                    enter(&mut cast.faces, self.face_of(s / 3));
                    cast.go_to(self.ends(s)[0], self.layer_of(s / 3));
                    self.leave_corner(&line, s)
                }
                Onwards::Border(s, node) => {
                    let vertex = |node: u32| VertexId::new(self.vertices[node as usize]);
                    let side = [s, next(s)].map(|s| vertex(self.sides[s].origin));
                    let point = cast.points.last().copied().unwrap_or(start.point);
                    let face = self.face_of(s / 3);
                    enter(&mut cast.faces, face);
                    cast.hit = Some(SurfaceRayHit { face, side, vertex: node.map(vertex), point });
                    return Ok(cast);
                }
                Onwards::End(t) => {
                    enter(&mut cast.faces, self.face_of(t));
                    if let Some(place) = self.place_in(t, line.to) {
                        cast.go_to(place.point, place.layer);
                    }
                    return Ok(cast);
                }
            };
        }
    }

    /// Through a triangle, up to where the line leaves it.
    fn cross(&self, line: &Line, t: usize, cast: &mut SurfaceRaycast) -> Onwards {
        if self.place_in(t, line.to).is_some() {
            return Onwards::End(t);
        }
        let signs = self.corners(t).map(|p| line.side(plan(p)));
        for k in 0..3 {
            let [one, other] = [signs[k], signs[(k + 1) % 3]];
            if one.is_lt() && other.is_gt() {
                let s = 3 * t + k;
                let [a, b] = self.ends(s);
                let [right, left] = [a, b].map(|p| twice_area(line.from, line.to, plan(p)).abs());
                let share = if right + left > 0.0 { right / (right + left) } else { 0.5 };
                cast.go_to(lerp(a, b, share), self.layer_of(t));
                return self.over(s);
            }
            if one.is_lt() && other.is_eq() && signs[(k + 2) % 3].is_gt() {
                return Onwards::Corner(3 * t + (k + 1) % 3);
            }
        }
        // It touches the triangle only: it came in through a corner, and leaves by it.
        let on_line = (0..3).filter(|&k| signs[k].is_eq()).map(|k| 3 * t + k);
        let last = on_line.reduce(|a, b| if line.is_forward(self.flat(a), self.flat(b)) { b } else { a });
        Onwards::Corner(last.unwrap_or(3 * t))
    }

    /// Into the triangle beyond a side.
    fn over(&self, s: usize) -> Onwards {
        match self.sides[s].twin {
            NONE => Onwards::Border(s, None),
            twin if self.is_upright(twin as usize / 3) => Onwards::Border(s, None),
            twin => Onwards::Into(twin as usize / 3),
        }
    }

    /// From a point inside a side.
    fn leave_side(&self, line: &Line, s: usize) -> Onwards {
        let [a, b] = [self.flat(s), self.flat(next(s))];
        match orientation(a, b, line.to) {
            Ordering::Greater => Onwards::Into(s / 3),
            Ordering::Less => self.over(s),
            Ordering::Equal => {
                let end = if line.is_forward(a, b) { next(s) } else { s };
                if line.ends_by(line.from, self.flat(end)) { Onwards::End(s / 3) } else { Onwards::Corner(end) }
            }
        }
    }

    /// From the corner that a side of the triangle starts from through which the line came, into whichever triangle of its fan
    /// the line leads.
    fn leave_corner(&self, line: &Line, s: usize) -> Onwards {
        let at = self.flat(s);
        if line.to == at {
            return Onwards::End(s / 3);
        }
        let first = self.first[self.sides[s].origin as usize] as usize;
        let fan = || std::iter::successors(Some(first), |&s| self.turn_left(s).filter(|&s| s != first));
        for s in fan().filter(|&s| !self.is_upright(s / 3)) {
            let [after, before] = [next(s), prev(s)];
            for end in [after, before] {
                if line.side(self.flat(end)).is_eq() && line.is_forward(at, self.flat(end)) {
                    let ends = line.ends_by(at, self.flat(end));
                    return if ends { Onwards::End(s / 3) } else { Onwards::Corner(end) };
                }
            }
            if line.side(self.flat(after)).is_lt() && line.side(self.flat(before)).is_gt() {
                return Onwards::Into(s / 3);
            }
        }
        // The borders that the line would go on to the right of: one of the triangle that it came through, or the first.
        let at_ends = fan().filter(|&s| !self.is_upright(s / 3)).flat_map(|s| [s, prev(s)]);
        let is_met = |&side: &usize| {
            let is_border = matches!(self.over(side), Onwards::Border(..));
            is_border && orientation(self.flat(side), self.flat(next(side)), line.to).is_lt()
        };
        let met = at_ends.filter(is_met).min_by_key(|side| side / 3 != s / 3);
        Onwards::Border(met.unwrap_or(s), Some(self.sides[s].origin))
    }

    fn layer_of(&self, t: usize) -> usize {
        self.layer(self.face_of(t)).unwrap_or_default()
    }

    fn flat(&self, s: usize) -> Point {
        plan(self.points[self.sides[s].origin as usize])
    }

    fn is_upright(&self, t: usize) -> bool {
        let [a, b, c] = self.corners(t).map(plan);
        orientation(a, b, c).is_le()
    }
}

impl SurfaceRaycast {
    fn go_to(&mut self, p: Space, layer: usize) {
        let last = self.points[self.points.len() - 1];
        let length = between(last, p);
        if length > 0.0 {
            self.length += length;
            self.points.push(p);
            self.layers.push(layer);
        }
    }
}
