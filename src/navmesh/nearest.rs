//! The nearest place where one can stand.
//!
//! ```text
//!     p ·                 Cells are searched ring by ring round the point, until the next ring is further away
//!        ╲                than what was found. The answer is a rounded point; it is moved into its face by as
//!   ──────●──────────     little as it takes, so that it lies on the mesh exactly.
//! ```

use super::location::{Location, Place};
use super::{ComponentId, NavMesh};
use crate::ids::FaceId;
use crate::plane::Point;

/// The nearest place to a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nearest {
    /// The place; if it is at a double corner, its face is on one of the nearest sides.
    pub place: Place,
    /// How far away it is, in units of the map.
    pub distance: f64,
}

impl NavMesh {
    /// The nearest place to `p` where one can stand; `p` itself if that is one. `None` if every face is blocked, or
    /// a coordinate is not finite.
    ///
    /// Cost: O(faces within that distance), about.
    #[must_use]
    pub fn nearest_point(&self, p: Point) -> Option<Nearest> {
        self.nearest_of(p, |f| self.is_walkable(f))
    }

    /// The nearest place to `p` in the given component: where to go instead, if `p` cannot be reached.
    ///
    /// Cost: O(faces within that distance), about.
    #[must_use]
    pub fn nearest_reachable(&self, component: ComponentId, p: Point) -> Option<Nearest> {
        self.nearest_of(p, |f| self.component(f) == Some(component))
    }

    fn nearest_of(&self, p: Point, suits: impl Fn(FaceId) -> bool) -> Option<Nearest> {
        if !p.x.is_finite() || !p.y.is_finite() {
            return None;
        }
        let [column, row] = self.grid.cell(p);
        let [columns, rows] = self.grid.size();
        let mut best: Option<(f64, FaceId, Point)> = None;
        for ring in 0..columns.max(rows) {
            if best.is_some_and(|(distance, ..)| distance <= (ring as f64 - 1.001) * self.grid.step()) {
                break;
            }
            let [low, high] = [column.saturating_sub(ring), (column + ring).min(columns - 1)];
            for y in row.saturating_sub(ring)..=(row + ring).min(rows - 1) {
                let whole = y.abs_diff(row) == ring;
                for x in (low..=high).filter(|x| whole || x.abs_diff(column) == ring) {
                    for f in self.grid.faces([x, y]).map(FaceId::new).filter(|&f| suits(f)) {
                        if self.spot_in(f, p).is_some() {
                            return Some(self.nearest_in(f, p, p));
                        }
                        for s in self.range(f) {
                            let at = closest_on(self.ends(f, s).map(|v| self.point(v)), p);
                            let distance = distance(p, at);
                            if best.is_none_or(|(least, ..)| distance < least) {
                                best = Some((distance, f, at));
                            }
                        }
                    }
                }
            }
        }
        best.map(|(_, f, at)| self.nearest_in(f, at, p))
    }

    /// The place at `at`, or as close to it in the direction of the middle of `f` as there is a point of `f`.
    fn nearest_in(&self, f: FaceId, at: Point, p: Point) -> Nearest {
        let middle = self.centroid(f);
        let steps = (0..=60).rev().map(|i| 2f64.powi(-i));
        let moved = steps.map(|t| Point::new(at.x + (middle.x - at.x) * t, at.y + (middle.y - at.y) * t));
        let found = std::iter::once(at).chain(moved).find_map(|q| Some((q, self.spot_in(f, q)?)));
        let (point, location) = found.unwrap_or_else(|| {
            // A face too thin to have a point inside: one of its corners.
            let v = self.corners(f).next().unwrap_or(crate::VertexId::new(0));
            (self.point(v), Location::Vertex(v))
        });
        Nearest { place: Place { point, location, face: f }, distance: distance(p, point) }
    }

    /// The mean of the corners of `f`, rounded.
    pub(super) fn centroid(&self, f: FaceId) -> Point {
        let count = self.corners(f).len() as f64;
        let sum = self.corners(f).map(|v| self.point(v)).fold([0.0, 0.0], |sum, p| [sum[0] + p.x, sum[1] + p.y]);
        Point::new(sum[0] / count, sum[1] / count)
    }
}

/// The distance of two points.
#[inline]
pub(super) fn distance(a: Point, b: Point) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    (x * x + y * y).sqrt()
}

/// The point of the segment closest to `p`, rounded.
#[inline]
pub(super) fn closest_on([a, b]: [Point; 2], p: Point) -> Point {
    let along = [b.x - a.x, b.y - a.y];
    let t = ((p.x - a.x) * along[0] + (p.y - a.y) * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        Point::new(a.x + along[0] * t, a.y + along[1] * t)
    }
}
