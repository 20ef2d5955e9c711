//! Where a solid is looked at from, and how it falls on the paper.
//!
//! ```text
//!          up ^   ● eye             right = up x towards      z points up on the paper, unless the eye is above
//!             │  ╱ towards          up    = towards x right   or below: then y does
//!             │ ╱
//!             ●────> right
//! ```

use crate::ids::VertexMap;
use crate::plane::Point;
use crate::solid::Polyhedron;
use crate::solid::vector::{Vector, cross, dot, minus};

/// Where the eye is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    /// From the solid towards the eye, of any length. All zeros or not finite: the usual direction.
    pub towards: [f64; 3],
    /// How far away the eye is, in sizes of the solid; at least 1.1. None: infinitely far, so that parallel lines
    /// stay parallel.
    pub distance: Option<f64>,
}

/// The direction that points up on the paper, as far as it is seen.
pub(in crate::figure) const UP: Vector = [0.0, 0.0, 1.0];

impl Default for Camera {
    /// From the front, somewhat from the right and from above, infinitely far.
    fn default() -> Self {
        Self { towards: [1.3, -2.4, 1.1], distance: None }
    }
}

/// A solid on the paper.
pub(super) struct Picture {
    pub(super) points: VertexMap<Point>,
    pub(super) size: f64,
    towards: Vector,
    /// For an eye at some distance, where it is.
    eye: Option<Vector>,
    middle: Vector,
    right: Vector,
    up: Vector,
}

/// Where a solid is, and how large.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Whole {
    middle: Vector,
    size: f64,
}

impl Whole {
    pub(super) fn of(solid: &Polyhedron) -> Self {
        let middle = solid.mean_point();
        let size = solid.vertices().map(|v| minus(solid.point(v), middle)).map(|p| dot(p, p)).fold(0.0, f64::max);
        Self { middle, size: size.sqrt() }
    }
}

impl Camera {
    pub(super) fn view(&self, solid: &Polyhedron) -> Picture {
        self.view_of(solid, Whole::of(solid), UP)
    }

    /// The solid as the camera sees it that looks at `whole` and holds its head in the direction `up`.
    pub(super) fn view_of(&self, solid: &Polyhedron, Whole { middle, size }: Whole, up: Vector) -> Picture {
        let good = |v: &Vector| v.iter().all(|x| x.is_finite() && x.abs() < 1e100) && dot(*v, *v) > 0.0;
        let towards = unit(if good(&self.towards) { self.towards } else { Self::default().towards });
        let up = if good(&up) { unit(up) } else { UP };
        // Who looks along the head's direction takes the next axis for it.
        let side = [up, [up[1], up[2], up[0]], [0.0, 1.0, 0.0]].map(|up| cross(up, towards));
        let side = side.into_iter().find(|side| dot(*side, *side) > 1e-12).unwrap_or([1.0, 0.0, 0.0]);
        let right = unit(side);
        let up = cross(towards, right);
        let eye = self.distance.filter(|d| d.is_finite()).map(|distance| {
            let far = distance.max(1.1) * size;
            [0, 1, 2].map(|i| middle[i] + towards[i] * far)
        });
        let mut picture = Picture { points: VertexMap::default(), size, towards, eye, middle, right, up };
        let mut points = VertexMap::filled(solid.vertex_bound(), Point::default());
        solid.vertices().for_each(|v| points[v] = picture.place(solid.point(v)));
        picture.points = points;
        picture
    }
}

impl Picture {
    /// Where a point falls on the paper.
    pub(super) fn place(&self, p: Vector) -> Point {
        let q = minus(p, self.middle);
        let scale = self.eye.map_or(1.0, |eye| {
            let far = dot(minus(eye, self.middle), self.towards);
            far / (far - dot(q, self.towards))
        });
        Point::new(dot(q, self.right) * scale, dot(q, self.up) * scale)
    }

    /// A point in space that falls on a place of the paper.
    pub(super) fn lifted(&self, at: Point) -> Vector {
        [0, 1, 2].map(|i| self.middle[i] + at.x * self.right[i] + at.y * self.up[i])
    }

    /// How far away a point is, along the direction of sight; the same for all if the eye is infinitely far.
    pub(super) fn depth(&self, p: Vector) -> f64 {
        self.eye.map_or(1.0, |eye| dot(minus(eye, p), self.towards))
    }

    /// How near to the eye a point is: of two points on one line of sight the nearer one has the greater value. For a
    /// plane it changes evenly across the paper.
    pub(super) fn nearness(&self, p: Vector) -> f64 {
        self.eye.map_or_else(|| dot(minus(p, self.middle), self.towards), |eye| 1.0 / dot(minus(eye, p), self.towards))
    }

    /// No less than how near a plane is, where a point lies on the paper: infinite if the plane is seen almost along
    /// itself. The plane has an area vector and a point on it.
    pub(super) fn nearness_on(&self, p: Vector, [normal, on]: [Vector; 2]) -> f64 {
        let ray = self.ray(p);
        let slope = dot(normal, ray);
        let steps = dot(normal, minus(on, p)) / slope;
        let near = self.nearness([0, 1, 2].map(|i| p[i] + steps * ray[i]));
        let is_steep = slope.abs() < 1e-6 * (dot(normal, normal) * dot(ray, ray)).sqrt();
        // Behind the eye nearness is negative: a plane that passes it is as near as can be.
        if is_steep || !near.is_finite() || (self.eye.is_some() && near <= 0.0) {
            return f64::INFINITY;
        }
        near + 1e-9 * (near.abs() + if self.eye.is_some() { 0.0 } else { self.size })
    }

    /// From a point towards the eye.
    pub(super) fn ray(&self, p: Vector) -> Vector {
        self.eye.map_or(self.towards, |eye| minus(eye, p))
    }
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}
