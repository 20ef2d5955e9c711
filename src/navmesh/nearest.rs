//! The nearest place where one can stand.
//!
//! ```text
//!     p ·                 Cells are searched ring by ring round the point, until the next ring is further away
//!        ╲                than what was found. The answer is a rounded point; it is moved into its face by as
//!   ──────●──────────     little as it takes, so that it lies on the mesh exactly.
//! ```
//!
//! What is compared is not the distance |p - q| itself, of which nothing would be left for a point far away, but by how
//! much its square is more than that of the distance to the point c of the box round all faces that is the closest to p:
//!
//! ```text
//!     |p - q|² - |p - c|² = (c - q) · ((p - q) + (p - c))        no term of this sum is negative
//! ```

use super::location::{Location, QueryPoint};
use super::{ComponentId, NavMesh};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;

/// The nearest place to a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nearest {
    /// The place; if it is at a double corner, its face is on one of the nearest sides.
    pub place: QueryPoint,
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
        let near = self.grid.clamp(p);
        let unit = unit_for(p);
        // See the head of the page, in squares of `unit`.
        let excess = |q: Point| {
            let [x, y] = [[near.x, q.x, p.x], [near.y, q.y, p.y]]
                .map(|[c, q, p]| (c - q) * ((p * unit - q * unit) + (p * unit - c * unit)));
            x + y
        };
        let [column, row] = self.grid.cell(p);
        let [columns, rows] = self.grid.size();
        let mut best: Option<(f64, Nearest)> = None;
        for ring in 0..columns.max(rows) {
            let beyond = (ring as f64 - 1.001) * self.grid.step();
            if ring > 1 && best.is_some_and(|(excess, _)| excess <= beyond * beyond * unit) {
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
                            let at = closest_in_units(self.ends(f, s).map(|v| self.point(v)), p, unit);
                            if best.is_some_and(|(least, _)| excess(at) >= least) {
                                continue;
                            }
                            // In a thin face there may be no point of doubles near it.
                            let found = self.nearest_in(f, at, p);
                            let excess = excess(found.place.point);
                            if best.is_none_or(|(least, _)| excess < least) {
                                best = Some((excess, found));
                            }
                        }
                    }
                }
            }
        }
        best.map(|(_, found)| found)
    }

    /// Two opposite corners of the box round all faces.
    pub(super) fn box_corners(&self) -> [Point; 2] {
        self.grid.corners()
    }

    /// Calls `visit` with every face that the segment may reach into, perhaps more than once, and perhaps some beside it.
    pub(super) fn visit_faces_along(&self, segment: [Point; 2], mut visit: impl FnMut(FaceId)) {
        self.grid.visit_cells(&segment, |cell| {
            self.grid.faces(self.grid.place_of(cell)).for_each(|f| visit(FaceId::new(f)));
        });
    }

    /// The place at `at`, or as close to it in the direction of the middle of `f` as there is a point of `f`.
    pub(super) fn nearest_in(&self, f: FaceId, at: Point, p: Point) -> Nearest {
        let middle = self.centroid(f);
        let steps = (0..=60).rev().map(|i| 2f64.powi(-i));
        let moved = steps.map(|t| Point::new(at.x + (middle.x - at.x) * t, at.y + (middle.y - at.y) * t));
        let found = std::iter::once(at).chain(moved).find_map(|q| Some((q, self.spot_in(f, q)?)));
        let (point, location) = found.unwrap_or_else(|| {
            // A face too thin to have a point inside: the nearest of its corners.
            let far = |v: &VertexId| distance(self.point(*v), at);
            let nearest = self.corners(f).min_by(|a, b| far(a).total_cmp(&far(b)));
            let v = nearest.unwrap_or(VertexId::new(0));
            (self.point(v), Location::Vertex(v))
        });
        let unit = unit_for(p);
        let scaled = |p: Point| Point::new(p.x * unit, p.y * unit);
        let distance = if unit < 1.0 { distance(scaled(p), scaled(point)) / unit } else { distance(p, point) };
        Nearest { place: QueryPoint { point, location, face: f }, distance }
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
    norm([b.x - a.x, b.y - a.y])
}

/// The length of a vector.
#[inline]
pub(super) fn norm([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// What to multiply with so that squares of distances from `p` stay within the range of doubles.
fn unit_for(p: Point) -> f64 {
    // Points of a map are no further away than 2^201.
    if p.x.abs().max(p.y.abs()) > 2f64.powi(400) { 2f64.powi(-560) } else { 1.0 }
}

/// The point of the segment closest to `p`, rounded.
#[inline]
pub(super) fn closest_on(ends: [Point; 2], p: Point) -> Point {
    closest_in_units(ends, p, 1.0)
}

/// The same for points of which only multiples with `unit` can be computed with.
#[inline]
fn closest_in_units([a, b]: [Point; 2], p: Point, unit: f64) -> Point {
    let along = [b.x - a.x, b.y - a.y];
    let off = [p.x * unit - a.x * unit, p.y * unit - a.y * unit];
    let t = (off[0] * along[0] + off[1] * along[1]) / ((along[0] * along[0] + along[1] * along[1]) * unit);
    // Ends at one place make it no number.
    if t >= 1.0 {
        b
    } else if t > 0.0 {
        Point::new(a.x + along[0] * t, a.y + along[1] * t)
    } else {
        a
    }
}
